/* slipway sweep: what a scene's products give over one key of it, or two; and
 * merge. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "csv_results.h"
#include "ensemble.h"
#include "output.h"
#include "picture_sweep.h"
#include "product_setting.h"
#include "report_sweep.h"
#include "report_sweep_json.h"
#include "scene_sweep.h"
#include "shared.h"
#include "sweep.h"
#include "sweep_file.h"
#include "sweep_told.h"
#include "tolerance.h"

/* ---- csv ----------------------------------------------------------------- */

/* A number or word of every point. */
struct part {
    int column;
    size_t entry;
    const char *suffix; /* "", "_error", "_reason" */
};

/* Of every entry whether a point lacks it; owned by the caller, NULL without
 * memory. */
static bool *find_gaps(const struct sweep *s)
{
    bool *gaps = calloc(s->columns.entries + 1, sizeof *gaps), *to = gaps;

    for (size_t k = 0; k < s->columns.count && gaps; k++)
        for (size_t e = 0; e < s->columns.at[k].entries; e++, to++)
            for (size_t i = 0; i < s->points && !s->columns.at[k].codes; i++)
                *to |= sweep_entry_code(s, (int) k, i, e) != REASON_PRESENT;
    return gaps;
}

static void put_head(FILE *out, const struct sweep *s,
                     const struct unit_system *u, struct part p)
{
    const struct sweep_column *c = &s->columns.at[p.column];
    const bool number = !c->codes && strcmp(p.suffix, "_reason") != 0;
    char count[48] = "";

    if (c->entries > 1)
        snprintf(count, sizeof count, "_%zu", p.entry);
    fprintf(out, ",%s%s%s", sweep_told_name(s, u, p.column).text, count,
            p.suffix);
    csv_unit(out, number ? sweep_column_unit(s, u, p.column) : "1");
}

static void put_cell(FILE *out, const struct sweep *s,
                     const struct unit_system *u, struct part p, size_t i)
{
    const struct sweep_column *c = &s->columns.at[p.column];
    const int code = sweep_entry_code(s, p.column, i, p.entry);
    const struct quantity q =
        c->codes ? quantity_none("") : sweep_told(s, u, p.column, i, p.entry);

    fputc(',', out);
    if (c->codes)
        csv_text(out, code < 0 ? "" : c->codes[code]);
    else if (strcmp(p.suffix, "_reason") == 0)
        csv_text(out, quantity_exists(&q) ? "" : q.reason);
    else
        csv_real(out, *p.suffix ? q.error : q.value);
}

/* The head, or of point i what stands under it. */
static void put(FILE *out, const struct sweep *s, const struct unit_system *u,
                struct part p, bool head, size_t i)
{
    if (head)
        put_head(out, s, u, p);
    else
        put_cell(out, s, u, p, i);
}

static void put_line(FILE *out, const struct sweep *s, const bool gaps[],
                     bool head, size_t i)
{
    const struct unit_system u = sweep_answer_units(s, i);

    for (size_t k = 0; k < s->columns.count; k++) {
        const struct sweep_column *c = &s->columns.at[k];
        for (size_t e = 0; e < c->entries; e++) {
            struct part p = { (int) k, e, "" };
            put(out, s, &u, p, head, i);
            p.suffix = "_error";
            if (c->kind == RECORD_QUANTITY)
                put(out, s, &u, p, head, i);
            p.suffix = "_reason";
            if (*gaps++)
                put(out, s, &u, p, head, i);
        }
    }
    fputc('\n', out);
}

/* STATUS_NO_MEMORY: nothing is written. */
static enum status sweep_csv(FILE *out, const struct sweep *s)
{
    bool *gaps = find_gaps(s);

    if (gaps == NULL)
        return STATUS_NO_MEMORY;
    for (size_t k = 0; k < s->axes; k++) {
        fprintf(out, "%s%s", k ? "," : "", s->axis[k].name);
        csv_unit(out, sweep_told_unit(s, s->axis[k].key.unit));
    }
    put_line(out, s, gaps, true, 0);
    for (size_t i = 0; i < s->points; i++) {
        for (size_t k = 0; k < s->axes; k++) {
            fputs(k ? "," : "", out);
            csv_real(out, sweep_rows_x(&s->rows, i)[k]);
        }
        put_line(out, s, gaps, false, i);
    }
    free(gaps);
    return STATUS_OK;
}

#define BIT(p) (1u << PRODUCT_##p)

static enum status complain(struct fault *why, const char *text)
{
    return fault_set(why, STATUS_BAD_SCENE, "sweep: %s", text);
}

/* ---- the scene ----------------------------------------------------------- */

/* What `knees` computes, where the scene names nothing. */
static unsigned products_of(const struct options *o, const struct scene *s)
{
    const unsigned of_system = BIT(EQUILIBRIA) | BIT(MANIFOLDS);
    const unsigned asked = s->products ? s->products
                           : s->system ? of_system
                                       : BIT(EQUILIBRIA) | BIT(FOLDS) |
                                             BIT(KNEES) | BIT(ESTIMATES);

    return asked | (o->sensitivities ? BIT(SENSITIVITIES) : 0);
}

static enum status read_settings(const struct options *o, char *const more[],
                                 size_t count, struct scene *scene,
                                 struct fault *why)
{
    enum status s = output_standard_check(o, why);

    if (s == STATUS_OK)
        s = command_read(o, more, count, scene, why);
    if (s == STATUS_OK && output_is_standard(o)) {
        free(scene->hdf5); /* CSV, and no file */
        scene->hdf5 = NULL;
    }
    return s;
}

static enum status read_scene(const struct options *o, struct scene *scene,
                              struct fault *why)
{
    char line[PRODUCT_SETTING], *more[] = { line };

    enum status s = read_settings(o, NULL, 0, scene, why);
    if (s != STATUS_OK)
        return s;
    if (scene->sweep.axes == 0) {
        scene_free(scene);
        return complain(why, "the scene has none, expected 'sweep: {key: "
                             "slope.alpha, from: A, to: B, points: N}'");
    }
    const unsigned products = products_of(o, scene);
    if (products == scene->products)
        return STATUS_OK;
    scene_free(scene);
    product_setting(products, line);
    return read_settings(o, more, 1, scene, why);
}

/* ---- results ------------------------------------------------------------- */

/* How many points have an entry of that column beyond so many times rtol. */
static size_t points_beyond(const struct sweep *s, const char *name,
                            double times)
{
    const int k = sweep_find(s, name);
    size_t count = 0;

    for (size_t i = 0; k >= 0 && i < s->points; i++) {
        struct scene point;
        scene_at(s->scene, sweep_rows_x(&s->rows, i), &point);
        const double bound = times * point.rtol;
        bool beyond = false;
        for (size_t e = 0; e < s->columns.at[k].entries; e++)
            beyond |= fabs(sweep_entry(s, k, i, e).value) > bound;
        count += beyond;
    }
    return count;
}

/* Files are written and numbers printed: the user may see for himself. */
static enum exit_code judge(const struct sweep *s)
{
    const struct {
        size_t points;
        const char *what;
    } wrong[] = {
        { s->failed, "the computation failed" },
        { points_beyond(s, "basin_audit_disagreements", 0.0),
          "audit: orbits of cells have another fate than the map says" },
        { points_beyond(s, "trajectory_energy_defect", TOL_TRANSIENT_ENERGY),
          "the balance of energy (27) of a run is off" },
    };
    char text[160];

    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        if (wrong[i].points > 0) {
            snprintf(text, sizeof text, "sweep: %s at %zu of %zu points",
                     wrong[i].what, wrong[i].points, s->points);
            return command_fail(STATUS_NO_CONVERGENCE, text);
        }
    return EXIT_DONE;
}

/* A point's bar and its proof cannot both be right. */
static enum exit_code judge_proofs(const struct sweep_reasons *r)
{
    for (size_t i = REASON_FIRST; i < r->count; i++)
        if (strstr(r->text[i], PROVED_LIE)) {
            fprintf(stderr, "slipway: %s\n", r->text[i]);
            return EXIT_CHECK;
        }
    return EXIT_DONE;
}

static enum exit_code print_work(const void *work, const struct options *o)
{
    const struct sweep *s = work;
    const bool csv = output_is_standard(o);

    if (csv && sweep_csv(stdout, s) != STATUS_OK)
        return command_fail(STATUS_NO_MEMORY, status_text(STATUS_NO_MEMORY));
    if ((o->json && !json_print(report_sweep_json(s))) ||
        (csv && fflush(stdout)))
        return command_unwritten();
    if (!o->json && !o->quiet && !csv)
        report_sweep_print(stdout, s);
    const enum exit_code code = judge(s);
    return code == EXIT_DONE ? judge_proofs(&s->reasons) : code;
}

static void note_work(const void *work)
{
    const struct sweep *s = work;

    if (s->unrefined)
        printf("note: refinement stopped before its tolerance: too many "
               "points, or as near to a fold as the key's digits allow\n");
}

/* ---- the whole ----------------------------------------------------------- */

static enum status run_work(void *work, const struct scene *scene,
                            const struct sweep_options *how,
                            const struct monitor *monitor, struct fault *why)
{
    return sweep_run(work, scene, how, monitor, why);
}

static void free_work(void *work)
{
    sweep_free(work);
}

static enum status write_work(const void *work, const char *path,
                              struct fault *why)
{
    return sweep_file_write(work, path, why);
}

static enum status draw_work(const void *work, struct panels *p,
                             struct fault *why)
{
    (void) why;
    picture_sweep(work, panels_add(p, ""));
    return STATUS_OK;
}

static enum exit_code run(const struct options *o, const struct scene *scene)
{
    static const char *const panel[] = { "", NULL };
    struct sweep s = { .scene = NULL };
    const struct shared_work work = { "sweep",    "points",      panel,
                                      &s,         run_work,      free_work,
                                      write_work, draw_work,     print_work,
                                      note_work,  &s.rows.count, &s.missing,
                                      &s.taken,   &s.replaced };

    return shared_command(&work, o, scene);
}

enum exit_code command_sweep(const struct options *o)
{
    return command_with_scene(o, read_scene, run);
}

/* The shares of a sweep or an ensemble. */
enum exit_code command_merge(const struct options *o)
{
    struct scene scene;
    struct fault why;
    bool draws = false;

    if (command_read(o, NULL, 0, &scene, &why) == STATUS_OK) {
        draws = ensemble_is_asked(&scene);
        scene_free(&scene);
    }
    return draws ? command_ensemble(o) : command_sweep(o);
}
