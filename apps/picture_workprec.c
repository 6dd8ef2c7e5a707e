#include "picture_workprec.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "draw.h"
#include "workprec_tolerance.h"

enum { POINTS = 32 };

/* Runs of one method that have an answer. */
struct trace {
    double seconds[POINTS], error[POINTS];
    size_t count;
};

/* Ours are thick, red and black; GSL's solid, SUNDIALS' dotted, the same colour
 * for the same kind of method. */
struct look {
    const char *method;
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
    { "slipway", OURS(FIGURE_HIGHLIGHT, FIGURE_SOLID), FIGURE_DISC },
    { "slow_curve", OURS(FIGURE_HIGHLIGHT, FIGURE_DASHED), FIGURE_SQUARE },
    { "eigen", OURS(FIGURE_EQUILIBRIUM, FIGURE_SOLID), FIGURE_DISC },
    { "radau", OURS(FIGURE_EQUILIBRIUM, FIGURE_SOLID), FIGURE_SQUARE },
    { "explicit8", OURS(FIGURE_EQUILIBRIUM, FIGURE_DASHED), FIGURE_CIRCLE },
    { "gsl_rk8pd", THEIRS(1, FIGURE_SOLID), FIGURE_PLUS },
    { "gsl_rkf45", THEIRS(2, FIGURE_SOLID), FIGURE_PLUS },
    { "gsl_msbdf", THEIRS(3, FIGURE_SOLID), FIGURE_PLUS },
    { "gsl_bsimp", THEIRS(4, FIGURE_SOLID), FIGURE_PLUS },
    { "gsl_rk4imp", THEIRS(5, FIGURE_SOLID), FIGURE_PLUS },
    { "cvode_adams", THEIRS(1, FIGURE_DOTTED), FIGURE_CROSS },
    { "cvode_bdf", THEIRS(3, FIGURE_DOTTED), FIGURE_CROSS },
    { "arkode_erk8", THEIRS(2, FIGURE_DOTTED), FIGURE_CROSS },
};
enum { LOOKS = sizeof looks / sizeof *looks, OURS_COUNT = 5 };

bool picture_workprec_path(const char *path, enum workprec_quantity q,
                           char out[PICTURE_WORKPREC_PATH])
{
    const char *dot = strrchr(path, '.');
    const int stem = dot ? (int) (dot - path) : (int) strlen(path);

    return snprintf(out, PICTURE_WORKPREC_PATH, "%.*s_%s%s", stem, path,
                    workprec_quantity_names[q],
                    dot ? dot : "") < PICTURE_WORKPREC_PATH;
}

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

struct range {
    double lo, hi;
};

static void span(struct range *r, const double value[], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        r->lo = fmin(r->lo, value[i]);
        r->hi = fmax(r->hi, value[i]);
    }
}

/* A log axis with a rim around the values. */
static struct figure_axis axis_of(const char *label, struct range r)
{
    return (struct figure_axis){ label, r.lo / 1.5, r.hi * 1.5, true };
}

static enum status add(struct figure *f, const struct look *look,
                       const char *entry, const struct trace *t)
{
    const struct figure_curve line = { .style = look->style,
                                       .entry = entry,
                                       .x = t->seconds,
                                       .y = t->error,
                                       .count = t->count };
    const struct figure_points marks = { .style = look->style,
                                         .x = t->seconds,
                                         .y = t->error,
                                         .count = t->count,
                                         .mark = look->mark,
                                         .size = 7.0 };
    const enum status s = figure_add_curve(f, &line);

    return s ? s : figure_add_points(f, &marks);
}

/* Ours come first in the legend, and once more on top of the others. */
static enum status fill(struct figure *f, const struct trace trace[LOOKS])
{
    enum status s = STATUS_OK;

    for (int i = 0; i < LOOKS && s == STATUS_OK; i++)
        if (trace[i].count > 0)
            s = add(f, &looks[i], looks[i].method, &trace[i]);
    for (int i = OURS_COUNT; i-- > 0 && s == STATUS_OK;)
        if (trace[i].count > 0)
            s = add(f, &looks[i], NULL, &trace[i]);
    return s;
}

static enum status draw(const struct workprec *w, enum workprec_quantity q,
                        const char *path, bool keep_script, struct fault *why)
{
    struct range x = { HUGE_VAL, 0.0 }, y = x;
    struct trace trace[LOOKS];
    struct figure f;
    char title[256];

    for (int i = 0; i < LOOKS; i++) {
        trace[i] = trace_of(w, q, looks[i].method);
        span(&x, trace[i].seconds, trace[i].count);
        span(&y, trace[i].error, trace[i].count);
    }
    const struct figure_axis time = axis_of("run time (µs)", x);
    const struct figure_axis error = axis_of("true error", y);
    snprintf(title, sizeof title, "%s, α = %.6g: %s", w->scene.law.preset,
             w->scene.alpha, workprec_quantity_texts[q]);
    enum status s = figure_init(&f, title, &time, &error);
    if (s == STATUS_OK)
        s = fill(&f, trace);
    if (s == STATUS_OK)
        s = figure_write(&f, path, keep_script, why);
    figure_free(&f);
    return s;
}

enum status picture_workprec(const struct workprec *w, const char *path,
                             bool keep_script, struct fault *why)
{
    char panel[PICTURE_WORKPREC_PATH];
    enum status s = STATUS_OK;

    for (int i = 0; i < WORKPREC_QUANTITIES && s == STATUS_OK; i++) {
        const enum workprec_quantity q = (enum workprec_quantity) i;
        if (w->course.reason[q])
            continue;
        s = picture_workprec_path(path, q, panel)
                ? draw(w, q, panel, keep_script, why)
                : STATUS_BAD_ARGUMENT;
    }
    return s;
}
