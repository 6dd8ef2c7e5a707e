/* Numbers that stand alone come from the study's own tables (result.h); lists
 * are told here, with what they are along. */
#include "sweep_product.h"

#include <stdio.h>
#include <string.h>

#include "scene_slope.h"
#include "scene_sweep.h"
#include "study_results.h"

_Static_assert(sizeof(size_t) == sizeof(int64_t),
               "numbers of cells are counts of record.h");

/* ---- lists of the study -------------------------------------------------- */

#define AT(member) offsetof(struct sweep_point, member)
#define HERE(name, member)                                                     \
    ((struct column_part){ .prefix = name, .base = AT(member) })

static enum status add_xi(const struct column_adder *a, size_t i)
{
    struct sweep_columns *c = a->to;
    const size_t first = c->count;
    char prefix[48];
    const struct column_part part = {
        .prefix = prefix,
        .base = AT(study.estimates.xi) + i * sizeof(struct xi_number),
    };

    snprintf(prefix, sizeof prefix, "estimates_xi_%zu_", i);
    const enum status status = column_add_record(a, &part, &record_xi);
    for (size_t k = first; k < c->count; k++) {
        char *text = c->at[k].text;
        const size_t end = strlen(text);
        snprintf(text + end, sizeof c->at[k].text - end, " at xi = %.15g",
                 a->scene->xi[i]);
    }
    return status;
}

/* The estimates of each xi. */
static enum status add_estimates(const struct column_adder *a)
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < a->scene->xi_count && status == STATUS_OK; i++)
        status = add_xi(a, i);
    return status;
}

static enum status add_taylor(const struct column_adder *a)
{
    const struct column_part terms = { .prefix = "taylor_series_",
                                       .base = AT(study.taylor.term),
                                       .stride = sizeof(struct taylor_term),
                                       .dim = { DIM_TERM },
                                       .dims = 1 };

    return column_add_record(a, &terms, &record_taylor_term);
}

static enum status add_chi(const struct column_adder *a)
{
    const struct column_part part = { .prefix = "chi_",
                                      .source = SOURCE_CHI,
                                      .dim = { DIM_CHI_ALPHA },
                                      .dims = 1 };

    return column_add_record(a, &part, &record_chi_slope);
}

/* ---- steady states ------------------------------------------------------- */

/* What saddle_ and the law's own psi do not say already. */
static bool says_more(enum steady_kind kind, const struct record_field *f,
                      bool psi_log)
{
    const bool is_log = strncmp(f->name, "ln_", 3) == 0;

    if (strcmp(f->name, "ln_psi") == 0 && psi_log)
        return false;
    return is_log || kind != STEADY_SADDLE;
}

static enum status add_kinds(const struct column_adder *a)
{
    static const char *const prefix[STEADY_KINDS] = { "creep_", "saddle_",
                                                      "sliding_" };
    const bool psi_log = law_psi_is_log(&a->scene->law);
    enum status status = STATUS_OK;

    for (int k = 0; k < STEADY_KINDS; k++)
        for (size_t i = 0; i < record_steady_kind.count && status == STATUS_OK;
             i++) {
            const struct column_part part = {
                .prefix = prefix[k],
                .base = AT(kind) + (size_t) k * sizeof(struct kind_numbers)
            };
            if (says_more((enum steady_kind) k, &record_steady_kind.fields[i],
                          psi_log))
                status = column_add(a, &part, &record_steady_kind.fields[i]);
        }
    return status;
}

/* ---- basins -------------------------------------------------------------- */

static enum status add_share(const struct column_adder *a, size_t base,
                             const char *measure, const char *text)
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < FATES && status == STATUS_OK; i++) {
        char name[48];
        const struct record_field f = {
            .name = name,
            .unit = "1",
            .text = text,
            .offset = base + i * sizeof(struct basin_fraction),
            .kind = RECORD_QUANTITY,
        };
        snprintf(name, sizeof name, "basin_fraction_%s_%s", measure,
                 fate_names[i]);
        status = column_add(a, &(struct column_part){ .prefix = "" }, &f);
    }
    return status;
}

static enum status add_audit(const struct column_adder *a)
{
    static const struct record_field audit[] = {
        { .name = "cells",
          .unit = "1",
          .text = "cells whose orbit was followed",
          .offset = AT(study.basins.audit.cells),
          .kind = RECORD_COUNT },
        { .name = "disagreements",
          .unit = "1",
          .text = "those whose orbit has another fate than the map says",
          .offset = AT(study.basins.audit.disagreements),
          .kind = RECORD_COUNT },
    };
    const struct column_part part = { .prefix = "basin_audit_" };

    if (a->scene->audit == 0 || a->scene->exact)
        return STATUS_OK;
    const enum status status = column_add(a, &part, &audit[0]);
    return status ? status : column_add(a, &part, &audit[1]);
}

static enum status add_basins(const struct column_adder *a)
{
    const size_t base = AT(study.basins.fraction);
    enum status status =
        add_share(a, base + offsetof(struct basin_fraction, log), "log",
                  "share of the window in ln v and ln psi (psi where it is a "
                  "logarithm)");

    if (status == STATUS_OK)
        status = add_share(a, base + offsetof(struct basin_fraction, linear),
                           "linear", "share of the window in v and psi");
    return status ? status : add_audit(a);
}

/* ---- runs ---------------------------------------------------------------- */

/* Time, slip, v, psi, mu of an event; along levels if `stride`. */
static enum status add_event(const struct column_adder *a, const char *what,
                             size_t base, size_t stride)
{
    enum status status = STATUS_OK;
    char prefix[64];
    const struct column_part part = { .prefix = prefix,
                                      .source = SOURCE_START,
                                      .base = base,
                                      .stride = stride,
                                      .dim = { DIM_START, DIM_LEVEL },
                                      .dims = stride ? 2 : 1 };

    snprintf(prefix, sizeof prefix, "trajectory_%s_", what);
    for (size_t i = 0; i < record_transient_event.count && !status; i++)
        if (record_transient_event.fields[i].kind == RECORD_QUANTITY)
            status = column_add(a, &part, &record_transient_event.fields[i]);
    return status;
}

static enum status add_events(const struct column_adder *a)
{
    const size_t size = sizeof(struct transient_event);
    enum status status = STATUS_OK;

    for (size_t i = 0; i < MOMENTS && status == STATUS_OK; i++)
        if (i != MOMENT_V && i != MOMENT_PSI && i != MOMENT_MU_NEARS &&
            i != MOMENT_MU_LEAVES)
            status =
                add_event(a, moment_names[i],
                          offsetof(struct start_numbers, first) + i * size, 0);
    if (status == STATUS_OK)
        status = add_event(a, "mu_nears", offsetof(struct start_numbers, nears),
                           size);
    return status ? status
                  : add_event(a, "mu_leaves",
                              offsetof(struct start_numbers, leaves), size);
}

static enum status add_runs(const struct column_adder *a)
{
    static const struct record_field defect = {
        .name = "energy_defect",
        .unit = "1",
        .text = "relative defect of the balance of energy (27)",
        .offset = offsetof(struct transient_summary, energy_defect),
        .kind = RECORD_REAL,
    };
    const struct column_part whole = { .prefix = "trajectory_",
                                       .source = SOURCE_START,
                                       .base =
                                           offsetof(struct start_numbers, sum),
                                       .dim = { DIM_START },
                                       .dims = 1 };
    const struct column_part phases = { .prefix = "trajectory_phase_",
                                        .source = SOURCE_START,
                                        .base = offsetof(struct start_numbers,
                                                         phase),
                                        .stride = sizeof(struct phase),
                                        .dim = { DIM_START, DIM_PHASE },
                                        .dims = 2 };
    enum status status = column_add_record(a, &whole, &record_transient);

    if (status == STATUS_OK)
        status = column_add(a, &whole, &defect);
    if (status == STATUS_OK)
        status = column_add_record(a, &phases, &record_phase);
    return status ? status : add_events(a);
}

/* ---- which --------------------------------------------------------------- */

static enum status add_release(const struct column_adder *a)
{
    return scene_sweep_releases(a->scene)
               ? column_add_record(a, &HERE("rabinowicz_", release),
                                   &record_release)
               : STATUS_OK;
}

/* Every number that the study's tables describe, one by one: those of columns,
 * or the others. */
static enum status add_numbers(const struct column_adder *a,
                               const struct result_numbers *n, bool columns)
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < n->count && status == STATUS_OK; i++)
        if ((n->at[i].of->shape == RESULT_COLUMNS) == columns)
            status = column_add_number(a, &n->at[i]);
    return status;
}

/* By the stage that computes it. */
static const struct {
    enum stage stage;
    enum status (*add)(const struct column_adder *a);
} table[] = {
    { STAGE_ESTIMATES, add_estimates },
    { STAGE_TAYLOR, add_taylor },
    { STAGE_CHI, add_chi },
    { STAGE_BASINS, add_basins },
    { STAGE_TRAJECTORIES, add_runs },
};

static enum status add_lists(const struct column_adder *a)
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        if (plan_has(a->stages, table[i].stage) && status == STATUS_OK)
            status = table[i].add(a);
    if (status == STATUS_OK)
        status = add_release(a);
    return status || !scene_has_slope(a->scene) ||
                   !(a->scene->products & 1u << PRODUCT_EQUILIBRIA)
               ? status
               : add_kinds(a);
}

/* Rows of columns are the last ones, so that those which no point has can be
 * left off. */
enum status sweep_product_add(const struct column_adder *a)
{
    const uint64_t steady = scene_has_slope(a->scene) ? ASKED_BY(STEADY) : 0;
    struct result_numbers n;

    enum status status = study_numbers(
        &n, a->stages | steady | (uint64_t) a->scene->products << STAGES);
    if (status == STATUS_OK)
        status = add_numbers(a, &n, false);
    if (status == STATUS_OK)
        status = add_lists(a);
    if (status == STATUS_OK)
        status = add_numbers(a, &n, true);
    result_numbers_free(&n);
    return status;
}
