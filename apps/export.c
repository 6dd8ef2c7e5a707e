#include "export.h"

#include <gsl/gsl_version.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "export_basin.h"
#include "export_diagram.h"
#include "library.h"
#include "remark.h"
#include "result_file.h"
#include "rows.h"
#include "scene_slope.h"
#include "store.h"
#include "store_records.h"

/* One group of rows with `axis`; frees the rows. */
static enum status put_rows(struct store *out, const char *group,
                            struct rows *rows, const char *axis,
                            enum status sampled)
{
    const struct record_array a = rows_array(rows);
    const enum status s = sampled == STATUS_OK
                              ? store_put_records(out, group, &a, axis)
                              : sampled;

    rows_free(rows);
    return s;
}

static enum status put_manifolds(const struct study *s, struct store *out)
{
    static const char *const group[][SIDES] = {
        { "/manifold/stable_upper", "/manifold/stable_lower" },
        { "/manifold/unstable_upper", "/manifold/unstable_lower" },
    };
    enum status status = STATUS_OK;

    for (int i = 0; i < SIDES && status == STATUS_OK; i++) {
        struct rows r = rows_of(&record_branch);
        status = put_rows(out, group[0][i], &r, "arc",
                          rows_branch(s, &s->stable[i], &r));
        if (status != STATUS_OK || !plan_has(s->stages, STAGE_UNSTABLE))
            continue;
        struct rows u = rows_of(&record_branch);
        status = put_rows(out, group[1][i], &u, "arc",
                          rows_unstable(s, &s->unstable[i], &u));
    }
    return status;
}

static enum status put_nullclines(const struct study *s, struct store *out)
{
    static const char *const name[NULLCLINES] = { "v", "psi" };
    enum status status = STATUS_OK;

    for (int i = 0; i < NULLCLINES; i++)
        for (size_t k = 0; k < s->portrait.nullcline[i].count; k++) {
            char group[64];
            struct rows r = rows_of(&record_nullcline);
            if (status != STATUS_OK)
                return status;
            snprintf(group, sizeof group, "/nullcline/%s_%zu", name[i], k);
            status = put_rows(
                out, group, &r, "arc",
                rows_nullcline(s, &s->portrait.nullcline[i].piece[k], &r));
        }
    return status;
}

/* A trajectory on its way into the file. */
struct track {
    const struct trajectory *at;
    struct rows rows; /* owned */
    enum status sampled;
};

/* Frees the rows. */
static enum status put_track(const struct study *s, struct track *t,
                             size_t number, struct store *out)
{
    char group[64];

    snprintf(group, sizeof group, "/trajectory_%zu", number);
    enum status status = put_rows(out, group, &t->rows, "time", t->sampled);
    if (status == STATUS_OK)
        status = store_put_text(out, group, "end", study_end_name(t->at));
    if (status == STATUS_OK)
        status = store_put_real(out, group, "energy_defect",
                                study_energy_defect(s, &t->at->curve));
    return status;
}

/* Those with points; returns how many. */
static size_t collect_tracks(const struct study *s, struct track *track)
{
    const struct trajectories *set[] = { &s->chosen,
                                         &s->portrait.trajectories };
    size_t n = 0;

    for (int i = 0; i < 2; i++)
        for (size_t k = 0; k < set[i]->count; k++)
            if (set[i]->at[k].curve.count > 0)
                track[n++] =
                    (struct track){ .at = &set[i]->at[k],
                                    .rows = rows_of(&record_trajectory) };
    return n;
}

/* Sampled on all threads first: that takes a third of the time of writing. */
static enum status put_trajectories(const struct study *s, struct store *out)
{
    const size_t most = s->chosen.count + s->portrait.trajectories.count;
    struct track *track = calloc(most + 1, sizeof *track);
    enum status status = track ? STATUS_OK : STATUS_NO_MEMORY;
    const size_t n = track ? collect_tracks(s, track) : 0;

#pragma omp parallel for schedule(dynamic, 1)
    for (size_t k = 0; k < n; k++)
        track[k].sampled =
            rows_trajectory(s, &track[k].at->curve, &track[k].rows);
    for (size_t k = 0; k < n; k++)
        if (status == STATUS_OK)
            status = put_track(s, &track[k], k, out);
        else
            rows_free(&track[k].rows);
    free(track);
    return status;
}

static enum status put_arrows(const struct study *s, struct store *out)
{
    struct rows r = rows_of(&record_arrow);
    return put_rows(out, "/field_arrows", &r, NULL, rows_arrows(s, &r));
}

static enum status put_critical(const struct study *s, struct store *out)
{
    const struct critical_numbers *c = &s->critical;
    const struct record_array up = { &record_knee, c->knees_upper,
                                     c->knees_upper_count };
    const struct record_array low = { &record_knee, c->knees_lower,
                                      c->knees_lower_count };
    enum status status =
        store_put_scalars(out, "/critical", &record_critical, c);

    if (status == STATUS_OK && plan_has(s->stages, STAGE_KNEES))
        status = store_put_records(out, "/critical/knees_upper", &up, NULL);
    if (status == STATUS_OK && plan_has(s->stages, STAGE_KNEES))
        status = store_put_records(out, "/critical/knees_lower", &low, NULL);
    return status;
}

static enum status put_taylor(const struct study *s, struct store *out)
{
    static const char group[] = "/taylor_series";
    const struct record_array terms = { &record_taylor_term, s->taylor.term,
                                        s->taylor.terms };
    const enum status status = store_put_records(out, group, &terms, "order");

    return status ? status
                  : store_put_scalars(out, group, &record_taylor, &s->taylor);
}

static enum status put_sensitivities(const struct study *s, struct store *out)
{
    const struct sensitivities *d = &s->sensitivities;
    const enum status status = store_put_scalars(
        out, "/critical/sensitivities/v_plus", &record_sensitivity, &d->v_plus);

    return status ? status
                  : store_put_scalars(out, "/critical/sensitivities/v_minus",
                                      &record_sensitivity, &d->v_minus);
}

static enum status put_estimates(const struct study *s, struct store *out)
{
    const struct estimate_numbers *e = &s->estimates;
    const struct record_array xi = { &record_xi, e->xi, e->xi_count };
    const enum status status =
        store_put_scalars(out, "/estimates", &record_estimates, e);

    return status ? status : store_put_records(out, "/estimates/xi", &xi, "xi");
}

/* The overrides but those of the output: where a file lies is not part of what
 * it holds.  Owned by the caller. */
static char *lasting_overrides(const char *overrides)
{
    char *kept = calloc(strlen(overrides) + 1, 1), *end = kept;

    for (const char *line = overrides; kept && *line;) {
        const size_t size = strcspn(line, "\n") + 1;
        if (strncmp(line, "output.", 7) != 0 &&
            strncmp(line, "output=", 7) != 0)
            end = (char *) memcpy(end, line, size) + size;
        line += size;
    }
    return kept;
}

static enum status put_scene(const struct scene *scene, struct store *out)
{
    char *overrides = lasting_overrides(scene->overrides);
    enum status status = overrides ? STATUS_OK : STATUS_NO_MEMORY;

    if (!status)
        status = store_put_text(out, "/provenance", "scene", scene->text);
    if (!status)
        status = store_put_text(out, "/provenance", "overrides", overrides);
    free(overrides);
    return status;
}

/* What made the file: no clock, path, host or thread count. */
enum status export_provenance(const struct scene *scene, struct store *out)
{
    struct material m = scene->material;
    char formula[256], libraries[128];
    const char *const text[][2] = {
        { "version", SLIPWAY_VERSION },
        { "compiler", __VERSION__ },
        { "libraries", libraries },
        { "law", scene->law.preset },
        { "friction", friction_form_names[scene->law.form] },
        { "formula", formula },
    };
    enum status status = put_scene(scene, out);

    law_formula(&scene->law, formula, sizeof formula);
    snprintf(libraries, sizeof libraries, "GSL %s, HDF5 %s", GSL_VERSION,
             store_library_version());
    for (size_t i = 0; i < sizeof text / sizeof *text && !status; i++)
        status = store_put_text(out, "/provenance", text[i][0], text[i][1]);
    for (int key = 0; key < MATERIAL_KEYS && !status; key++)
        status = store_put_real(out, "/provenance",
                                material_key_name((enum material_key) key),
                                *material_member(&m, (enum material_key) key));
    if (!status && scene_has_slope(scene))
        status = store_put_real(out, "/provenance", "alpha", scene->alpha);
    if (!status)
        status = store_put_real(out, "/provenance", "eps2", material_eps2(&m));
    return status;
}

static enum status put_all(const struct study *s, struct store *out,
                           const struct monitor *monitor)
{
    const struct record_array steady = { &record_steady, s->steady,
                                         s->equilibria };
    const unsigned stages = s->stages;
    enum status status = export_provenance(s->scene, out);

    if (!status && plan_has(stages, STAGE_STEADY))
        status = store_put_records(out, "/equilibria", &steady, NULL);
    if (!status && plan_has(stages, STAGE_STEADY))
        status = store_put_scalars(out, "/saddle", &record_saddle,
                                   &s->saddle_numbers);
    if (!status && plan_has(stages, STAGE_FOLDS))
        status = store_put_scalars(out, "/folds", &record_folds, &s->folds);
    if (!status && plan_has(stages, STAGE_STABLE) && study_has_manifolds(s))
        status = put_manifolds(s, out);
    if (!status && plan_has(stages, STAGE_CRITICAL))
        status = put_critical(s, out);
    if (!status && plan_has(stages, STAGE_TAYLOR))
        status = put_taylor(s, out);
    if (!status && plan_has(stages, STAGE_ESTIMATES))
        status = put_estimates(s, out);
    if (!status && plan_has(stages, STAGE_SENSITIVITIES))
        status = put_sensitivities(s, out);
    if (!status && plan_has(stages, STAGE_NULLCLINES))
        status = put_nullclines(s, out);
    if (!status && plan_has(stages, STAGE_ARROWS))
        status = put_arrows(s, out);
    if (!status && plan_has(stages, STAGE_TRAJECTORIES))
        status = put_trajectories(s, out);
    if (!status && plan_has(stages, STAGE_BASINS))
        status = export_basin(s, out, monitor);
    if (!status)
        status = export_diagrams(s, out);
    return status;
}

enum status export_study(const struct study *s, const char *path,
                         const struct monitor *monitor, struct fault *why)
{
    struct store *out;
    enum status status =
        result_file_begin(&out, path, s->scene, s->block.law.preset, why);

    if (status == STATUS_OK)
        status = result_file_end(&out, path, put_all(s, out, monitor), why);
    return status;
}
