/* slipway ensemble: the numbers of many materials, and the fates of pushes. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ensemble.h"
#include "figure.h"
#include "line.h"
#include "output.h"
#include "report_ensemble.h"
#include "result_file.h"
#include "shared.h"
#include "sheet.h"

/* ---- picture ------------------------------------------------------------- */

static bool has_numbers(const struct scene *s)
{
    return s->ensemble.number == NULL || s->ensemble.numbers > 0;
}

enum { PANELS = 4 };

/* The panels of its figure (panel_path), NULL-ended: the distribution of v_plus
 * (or of the first number) with its quantiles, "_arrest" with pushes, "_matrix"
 * with parameters.  Without numbers the first is that of arrest. */
static void name_panels(const struct scene *s, const char *panel[PANELS])
{
    size_t n = 0;

    panel[n++] = "";
    if (s->ensemble.pushes > 0 && has_numbers(s) && s->system == NULL)
        panel[n++] = "_arrest";
    if (has_numbers(s) || s->system == NULL)
        panel[n++] = "_matrix";
    panel[n] = NULL;
}

/* ---- a distribution ------------------------------------------------------ */

enum { BARS = 60 };

/* The share of the draws in each bar, per bar. */
static enum status count_bars(const struct ensemble *e, size_t k,
                              const double range[2], double bar[BARS],
                              struct fault *why)
{
    double *value = malloc(SPOOL_DRAWS * sizeof *value);
    int8_t *code = malloc(SPOOL_DRAWS);
    enum status status = value && code ? STATUS_OK : STATUS_NO_MEMORY;

    memset(bar, 0, BARS * sizeof *bar);
    for (size_t b = 0; b < spool_blocks(&e->spool) && status == STATUS_OK;
         b++) {
        status = spool_read(&e->spool, b, SPOOL_VALUE, k, value, why);
        if (status == STATUS_OK)
            status = spool_read(&e->spool, b, SPOOL_CODE, k, code, why);
        for (size_t i = 0; i < spool_count(&e->spool, b) && !status; i++) {
            const double t = (value[i] - range[0]) / (range[1] - range[0]);
            if (code[i] == REASON_PRESENT && t >= 0.0 && t < 1.0)
                bar[(size_t) (t * BARS)] += 1.0 / (double) e->draws.count;
        }
    }
    free(value);
    free(code);
    return status;
}

static void add_bars(struct figure *f, const double range[2],
                     const double bar[BARS])
{
    const double wide = (range[1] - range[0]) / BARS;

    for (int i = 0; i < BARS; i++) {
        const double from = range[0] + i * wide;
        if (bar[i] > 0.0)
            figure_add_block(f, (double[]){ from, from + wide },
                             (double[]){ 0.0, bar[i] }, FIGURE_SHADE_1,
                             "draws");
    }
}

/* Dashed, the median solid. */
static void add_quantiles(struct figure *f, const struct ensemble_number *n,
                          double top)
{
    for (int q = 0; q < ENSEMBLE_QUANTILES; q++) {
        static const enum figure_dash dash[] = { FIGURE_DOTTED, FIGURE_DASHED,
                                                 FIGURE_SOLID, FIGURE_DASHED,
                                                 FIGURE_DOTTED };
        static const char *const entry[] = { "quantiles 0.025, 0.975",
                                             "0.16, 0.84", "median",
                                             "0.16, 0.84",
                                             "quantiles 0.025, 0.975" };
        const double x = n->quantile[q];
        if (isfinite(x))
            sheet_segment(
                f, (struct figure_style){ FIGURE_SERIES_1, dash[q], 0 },
                entry[q], (struct vec2){ x, 0.0 }, (struct vec2){ x, top });
    }
}

/* Of v_plus, or the first number. */
static size_t shown_number(const struct ensemble *e)
{
    for (size_t k = 0; k < e->batch.numbers; k++)
        if (strcmp(e->number[k].name, "v_plus") == 0)
            return k;
    return 0;
}

static enum status distribution(const struct ensemble *e, struct figure *f,
                                struct fault *why)
{
    const size_t k = shown_number(e);
    const struct ensemble_number *n = &e->number[k];
    const double lo = n->quantile[0], hi = n->quantile[ENSEMBLE_QUANTILES - 1];
    const double rim = hi > lo ? 0.6 * (hi - lo) : 0.5 * fabs(lo) + 0.5;
    const double range[2] = { isfinite(lo) ? lo - rim : 0.0,
                              isfinite(hi) ? hi + rim : 1.0 };
    const struct unit_system none = { .si = false };
    const struct sheet_label label = sheet_label(&none, n->name, n->unit);
    double bar[BARS], top = 0.0;
    const enum status status = count_bars(e, k, range, bar, why);

    for (int i = 0; i < BARS && status == STATUS_OK; i++)
        top = fmax(top, bar[i]);
    top = top > 0.0 ? 1.05 * top : 1.0;
    const struct figure_axis x = { label.text, range[0], range[1], false };
    const struct figure_axis y = { "share of the draws", 0.0, top, false };
    figure_init(f, sheet_title(e->scene, false).text, &x, &y);
    if (status == STATUS_OK)
        add_bars(f, range, bar);
    add_quantiles(f, n, top);
    return status;
}

/* ---- arrest -------------------------------------------------------------- */

/* Pushes of one kind, in the order of their slip rates. */
static size_t order(const struct ensemble *e, bool from_creep, size_t at[])
{
    size_t n = 0;

    for (size_t k = 0; k < e->batch.pushes; k++) {
        if (e->push[k].at.from_creep != from_creep)
            continue;
        size_t i = n++;
        for (; i > 0 && e->push[at[i - 1]].at.v > e->push[k].at.v; i--)
            at[i] = at[i - 1];
        at[i] = k;
    }
    return n;
}

static void add_arrest(const struct ensemble *e, struct figure *f, bool creep)
{
    const struct figure_style style = { .role = creep ? FIGURE_SERIES_2
                                                      : FIGURE_SERIES_1 };
    const char *entry = creep ? "kick from creep" : "push";
    double x[SCENE_PUSHES], y[SCENE_PUSHES];
    size_t at[SCENE_PUSHES];
    const size_t n = order(e, creep, at);

    for (size_t i = 0; i < n; i++) {
        const struct estimate *p = &e->push[at[i]].arrest;
        x[i] = e->push[at[i]].at.v;
        y[i] = p->value;
        if (isfinite(p->error))
            sheet_segment(f, style, entry,
                          (struct vec2){ x[i], fmax(y[i] - p->error, 0.0) },
                          (struct vec2){ x[i], fmin(y[i] + p->error, 1.0) });
    }
    struct figure_layer layer = { .style = style,
                                  .entry = entry,
                                  .x = x,
                                  .y = y,
                                  .count = n,
                                  .mark = FIGURE_DISC,
                                  .size = 7 };
    if (n > 1)
        figure_add(f, &layer);
    layer.kind = FIGURE_POINTS;
    if (n > 0)
        figure_add(f, &layer);
}

static void arrest(const struct ensemble *e, struct figure *f)
{
    double lo = HUGE_VAL, hi = -HUGE_VAL;

    for (size_t k = 0; k < e->batch.pushes; k++) {
        lo = fmin(lo, e->push[k].at.v);
        hi = fmax(hi, e->push[k].at.v);
    }
    const bool is_log = lo > 0.0;
    const double rim = is_log ? 1.2 : 0.1 * (hi - lo) + 1.0;
    const struct figure_axis x = { e->push[0].at.is_si
                                       ? "slip rate v or kick (m/s)"
                                       : "slip rate v or kick (V_*)",
                                   is_log ? lo / rim : lo - rim,
                                   is_log ? hi * rim : hi + rim, is_log };
    const struct figure_axis y = { "probability of arrest", 0.0, 1.0, false };

    figure_init(f, sheet_title(e->scene, false).text, &x, &y);
    add_arrest(e, f, false);
    add_arrest(e, f, true);
}

/* ---- the matrix ---------------------------------------------------------- */

enum { DOTS = 400 };

/* Where some draws lie in a parameter, as a part of their range. */
static enum status read_dots(const struct ensemble *e, size_t k, double at[],
                             size_t count, struct fault *why)
{
    double *value = malloc(SPOOL_DRAWS * sizeof *value);
    double lo = HUGE_VAL, hi = -HUGE_VAL;
    enum status status = value ? STATUS_OK : STATUS_NO_MEMORY;

    for (size_t i = 0, was = SIZE_MAX; i < count && status == STATUS_OK; i++) {
        const size_t draw = i * e->draws.count / count;
        const size_t block = draw / SPOOL_DRAWS;
        if (block != was)
            status = spool_read(&e->spool, block, SPOOL_KEY, k, value, why);
        was = block;
        at[i] = value[draw % SPOOL_DRAWS];
        lo = fmin(lo, at[i]);
        hi = fmax(hi, at[i]);
    }
    for (size_t i = 0; i < count; i++)
        at[i] = hi > lo ? (at[i] - lo) / (hi - lo) : 0.5;
    free(value);
    return status;
}

/* Columns and rows are the parameters, cell by cell. */
static void add_cells(const struct ensemble *e, struct figure *f,
                      const double *dot, size_t count)
{
    const size_t n = e->draws.keys;
    double x[DOTS], y[DOTS];

    for (size_t j = 0; j < n; j++)
        for (size_t i = 0; i < n; i++) {
            for (size_t d = 0; d < count; d++) {
                x[d] = (double) i + 0.05 + 0.9 * dot[i * DOTS + d];
                y[d] = (double) j + 0.05 + 0.9 * dot[j * DOTS + d];
            }
            if (i != j)
                figure_add(f, &(struct figure_layer){
                                  .kind = FIGURE_POINTS,
                                  .style = { .role = FIGURE_SERIES_1 },
                                  .x = x,
                                  .y = y,
                                  .count = count,
                                  .size = 2 });
        }
    for (size_t i = 1; i < n; i++) {
        const struct figure_style rule = { .role = FIGURE_FIELD };
        const double at = (double) i, end = (double) n;
        sheet_segment(f, rule, NULL, (struct vec2){ at, 0.0 },
                      (struct vec2){ at, end });
        sheet_segment(f, rule, NULL, (struct vec2){ 0.0, at },
                      (struct vec2){ end, at });
    }
}

static enum status matrix(const struct ensemble *e, struct figure *f,
                          struct fault *why)
{
    const size_t n = e->draws.keys;
    const size_t count = e->draws.count < DOTS ? e->draws.count : DOTS;
    double *dot = calloc(n * DOTS, sizeof *dot);
    char label[512] = "";
    enum status status = dot ? STATUS_OK : STATUS_NO_MEMORY;

    for (size_t k = 0; k < n; k++) {
        snprintf(label + strlen(label), sizeof label - strlen(label), "%s%s",
                 k ? " | " : "", strrchr(e->draws.key[k], '.') + 1);
        if (status == STATUS_OK)
            status = read_dots(e, k, dot + k * DOTS, count, why);
    }
    const struct figure_axis axis = { label, 0.0, (double) n, false };
    figure_init(f, sheet_title(e->scene, false).text, &axis, &axis);
    if (status == STATUS_OK)
        add_cells(e, f, dot, count);
    free(dot);
    return status;
}

/* Begins those panels.  STATUS_IO, STATUS_NO_MEMORY. */
static enum status draw_work(const void *work, struct panels *p,
                             struct fault *why)
{
    const struct ensemble *e = work;
    const char *panel[PANELS];
    enum status status = STATUS_OK;

    name_panels(e->scene, panel);
    for (size_t i = 0; panel[i] && status == STATUS_OK; i++) {
        struct figure *f = panels_add(p, panel[i]);
        const bool pushes = i == 0 && !has_numbers(e->scene);
        if (strcmp(panel[i], "_matrix") == 0 || (pushes && e->scene->system))
            status = matrix(e, f, why);
        else if (strcmp(panel[i], "_arrest") == 0 || pushes)
            arrest(e, f);
        else
            status = distribution(e, f, why);
    }
    return status;
}

static enum status read_scene(const struct options *o, struct scene *scene,
                              struct fault *why)
{
    const enum status s = command_read(o, NULL, 0, scene, why);

    if (s != STATUS_OK || (ensemble_is_asked(scene) && !scene->proved))
        return s;
    const bool proved = scene->proved;
    scene_free(scene);
    snprintf(
        why->text, sizeof why->text, "%s",
        proved
            ? "ensemble: accuracy.proved: draws are not proved, "
              "expected knees, study or basin"
            : "ensemble: the scene has none, expected 'ensemble: {parameters: "
              "{material.a: {normal: [m, s]}}, draws: N}'");
    return STATUS_BAD_SCENE;
}

static enum status run_work(void *work, const struct scene *scene,
                            const struct sweep_options *how,
                            const struct monitor *monitor, struct fault *why)
{
    return ensemble_run(work, scene, how, monitor, why);
}

static void free_work(void *work)
{
    ensemble_free(work);
}

static enum status write_work(const void *work, const char *path,
                              struct fault *why)
{
    static const struct result *const none[] = { NULL };
    const struct ensemble *e = work;

    return result_file_write(
        "ensemble", &(struct results){ .table = none }, e->scene, e,
        e->scene->system ? "system" : e->scene->law.preset, path, NULL, why);
}

static enum exit_code print_work(const void *work, const struct options *o)
{
    if (o->json && !json_print(report_ensemble_json(work)))
        return command_unwritten();
    if (!o->json && !o->quiet)
        report_ensemble_print(stdout, work);
    return EXIT_DONE;
}

static enum exit_code run(const struct options *o, const struct scene *scene)
{
    const char *panel[PANELS];
    struct ensemble e = ENSEMBLE_EMPTY;
    const struct shared_work work = { "ensemble", "draws",        panel,
                                      &e,         run_work,       free_work,
                                      write_work, draw_work,      print_work,
                                      NULL,       &e.draws.count, &e.missing,
                                      &e.taken,   &e.replaced };

    name_panels(scene, panel);
    return shared_command(&work, o, scene);
}

enum exit_code command_ensemble(const struct options *o)
{
    return command_with_scene(o, read_scene, run);
}
