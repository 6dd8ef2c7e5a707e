/* slipway workprec: error against run time, our methods and others', on one
 * slope. */
#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <string.h>

#include "output.h"
#include "progress.h"
#include "sheet.h"
#include "workprec.h"
#include "workprec_tolerance.h"

/* ---- picture ------------------------------------------------------------- */

enum { POINTS = 32 };

/* Runs of one method that have an answer. */
struct trace {
    double seconds[POINTS], error[POINTS];
    size_t count;
};

/* Ours are thick, red and black; GSL's solid, SUNDIALS' dotted, the same colour
 * for the same kind of method, and a mark for each. */
struct look {
    const char *method, *entry; /* its word and its line in the legend */
    struct figure_style style;
    enum figure_mark mark;
};

#define OURS(role_, dash_)                                                     \
    {                                                                          \
        .role = role_, .dash = dash_, .width = 3.0                             \
    }
#define THEIRS(number, dash_)                                                  \
    {                                                                          \
        .role = FIGURE_SERIES_##number, .dash = dash_, .width = 1.5            \
    }

static const struct look looks[] = {
    { "slipway", "Slipway", OURS(FIGURE_HIGHLIGHT, FIGURE_SOLID), FIGURE_DISC },
    { "slow_curve", "slow curve", OURS(FIGURE_HIGHLIGHT, FIGURE_DASHED),
      FIGURE_SQUARE },
    { "radau", "Radau", OURS(FIGURE_EQUILIBRIUM, FIGURE_SOLID), FIGURE_SQUARE },
    { "explicit8", "Dormand–Prince 8", OURS(FIGURE_EQUILIBRIUM, FIGURE_DASHED),
      FIGURE_CIRCLE },
    { "gsl_rk8pd", "GSL, Prince–Dormand 8", THEIRS(1, FIGURE_SOLID),
      FIGURE_PLUS },
    { "gsl_rkf45", "GSL, Fehlberg 4(5)", THEIRS(2, FIGURE_SOLID),
      FIGURE_CROSS },
    { "gsl_msbdf", "GSL, BDF", THEIRS(3, FIGURE_SOLID), FIGURE_BOX },
    { "gsl_bsimp", "GSL, Bader–Deuflhard", THEIRS(4, FIGURE_SOLID),
      FIGURE_DELTA },
    { "gsl_rk4imp", "GSL, Gauss 4", THEIRS(5, FIGURE_SOLID), FIGURE_LOZENGE },
    { "cvode_adams", "CVODE, Adams", THEIRS(1, FIGURE_DOTTED), FIGURE_STAR },
    { "cvode_bdf", "CVODE, BDF", THEIRS(3, FIGURE_DOTTED), FIGURE_TRIANGLE },
    { "arkode_erk8", "ARKODE, Fehlberg 8", THEIRS(2, FIGURE_DOTTED),
      FIGURE_DIAMOND },
};
enum { LOOKS = sizeof looks / sizeof *looks, OURS_COUNT = 4 };

/* "_v_plus", ...: what each file is named after; ended by NULL. */
static const char *const picture_workprec_panel[] = {
    "_v_plus",    "_v_minus",    "_x_excess", "_curve",
    "_transient", "_basin_rows", "_slip",     NULL
};
_Static_assert(sizeof picture_workprec_panel / sizeof(char *) ==
                   WORKPREC_QUANTITIES + 1,
               "one of each quantity");

static struct trace trace_of(const struct workprec *w, enum workprec_quantity q,
                             const char *method)
{
    struct trace t = { .count = 0 };

    for (size_t i = 0; i < w->runs && t.count < POINTS; i++) {
        const struct workprec_run *r = &w->run[i];
        if (r->quantity != (int8_t) q || strcmp(r->method, method) != 0 ||
            r->status == WORKPREC_FAILED || !isfinite(r->true_error))
            continue;
        t.seconds[t.count] = 1e6 * r->seconds;
        t.error[t.count++] = fmax(r->true_error, WORKPREC_LEAST);
    }
    return t;
}

/* A log axis with a rim around the values. */
static struct figure_axis axis_of(const char *label, const double range[2])
{
    return (struct figure_axis){ label, range[0] / 1.5, range[1] * 1.5, true };
}

static void add(struct figure *f, const struct look *look, const char *entry,
                const struct trace *t)
{
    struct figure_layer l = { .style = look->style,
                              .entry = entry,
                              .x = t->seconds,
                              .y = t->error,
                              .count = t->count,
                              .mark = look->mark,
                              .size = 7.0 };

    if (t->count == 0)
        return;
    figure_add(f, &l);
    l.kind = FIGURE_POINTS;
    figure_add(f, &l);
}

static void draw(const struct workprec *w, enum workprec_quantity q,
                 struct figure *f)
{
    double x[2] = RANGE_EMPTY, y[2] = RANGE_EMPTY;
    struct trace trace[LOOKS];
    char title[256];

    for (int i = 0; i < LOOKS; i++) {
        trace[i] = trace_of(w, q, looks[i].method);
        range_grow(x, trace[i].seconds, trace[i].count);
        range_grow(y, trace[i].error, trace[i].count);
    }
    const struct figure_axis time = axis_of("run time (µs)", x);
    const struct figure_axis error = axis_of("true error", y);
    snprintf(title, sizeof title, "%s, α = %.6g: %s", w->scene.law.words,
             w->scene.alpha, workprec_quantity_texts[q]);
    figure_init(f, title, &time, &error);
    /* ours come first in the legend, and once more on top of the others */
    for (int i = 0; i < LOOKS; i++)
        add(f, &looks[i], looks[i].entry, &trace[i]);
    for (int i = OURS_COUNT; i-- > 0;)
        add(f, &looks[i], NULL, &trace[i]);
}

/* Adds one of each quantity that has runs. */
static void picture_workprec(const struct workprec *w, struct panels *out)
{
    for (int q = 0; q < WORKPREC_QUANTITIES; q++)
        if (w->task.reason[q] == NULL)
            draw(w, (enum workprec_quantity) q,
                 panels_add(out, picture_workprec_panel[q]));
}

/* Whether a setting names a key of that section. */
static bool has_section(const struct options *o, const char *section)
{
    for (size_t i = 0; i < o->sets; i++)
        if (strncmp(o->set[i], section, strlen(section)) == 0)
            return true;
    return false;
}

/* The scene; what nobody says of the slope is that of the paper's Fig 7b. */
static enum status read_scene(const struct options *o, struct scene *scene,
                              struct fault *why)
{
    static char law[] = "law.preset=spinodal_gen", slope[] = "slope.alpha=0.34";
    char *more[COMMAND_MORE];
    size_t count = 0;

    if (has_section(o, "system"))
        return command_read(o, NULL, 0, scene, why);
    if (o->files == 0 && !has_section(o, "law"))
        more[count++] = law;
    if (o->files == 0 && !has_section(o, "slope"))
        more[count++] = slope;
    return command_read(o, more, count, scene, why);
}

/* How many of the runs of a method on a quantity, from number i on, went like
 * that; *next: the first of another. */
static size_t count_status(const struct workprec *w, size_t i,
                           enum workprec_status status, size_t *next)
{
    const struct workprec_run *first = &w->run[i];
    size_t n = 0;

    for (; i < w->runs && w->run[i].method == first->method &&
           w->run[i].quantity == first->quantity;
         i++)
        n += w->run[i].status == (int8_t) status;
    *next = i;
    return n;
}

/* One line for each status but the good one: quantity, then methods. */
static void print_failures(FILE *out, const struct workprec *w,
                           enum workprec_status status, const char *title)
{
    int quantity = -1;
    size_t next;

    fprintf(out, "%s", title);
    for (size_t i = 0; i < w->runs; i = next) {
        const size_t n = count_status(w, i, status, &next);
        if (n == 0)
            continue;
        if (w->run[i].quantity != quantity) {
            quantity = w->run[i].quantity;
            fprintf(out, "\n  %-11s", workprec_quantity_names[quantity]);
        }
        fprintf(out, " %s %zu/%zu", w->run[i].method, n, next - i);
    }
    fprintf(out, quantity < 0 ? " none\n" : "\n");
}

/* What stands above the results: whose race it is, and how many runs failed. */
static void print_head(FILE *out, const void *run)
{
    const struct workprec *w = run;

    if (w->scene.system)
        fprintf(out, "stable manifold of a saddle\n");
    else
        fprintf(out, "%s at alpha = %.10g\n", w->scene.law.preset,
                w->scene.alpha);
    print_failures(out, w, WORKPREC_FAILED, "runs that failed:");
    print_failures(out, w, WORKPREC_SILENT_FAILURE,
                   "runs that failed silently:");
}

/* On one thread: times must not compete. */
static enum exit_code run(const struct options *o, const struct scene *scene)
{
    static struct workprec w;
    struct panels p = PANELS_EMPTY;
    struct fault why = { "" };
    const struct results all = { .table = workprec_tables, .run = &w };
    enum status s =
        output_check(o, scene, scene->figure, picture_workprec_panel, &why);

    omp_set_num_threads(1);
    if (s == STATUS_OK)
        s = workprec_run(&w, scene, o->quick, progress_monitor(o), &why);
    progress_end();
    if (s != STATUS_OK)
        return command_fail(s, why.text);
    s = output_write(o, "workprec", &all, scene, NULL, "error against run time",
                     &why);
    if (s == STATUS_OK && scene->figure)
        picture_workprec(&w, &p);
    if (s == STATUS_OK)
        s = output_draw(o, &scene->paper, &p, scene->figure, &why);
    const enum exit_code code = s == STATUS_OK
                                    ? output_print(o, &all, print_head)
                                    : command_fail(s, why.text);
    workprec_free(&w);
    return code;
}

enum exit_code command_workprec(const struct options *o)
{
    return command_with_scene(o, read_scene, run);
}
