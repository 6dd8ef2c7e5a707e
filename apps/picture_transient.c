#include "picture_transient.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw.h"
#include "sample.h"

/* Points of a curve: more than there are px along its axis. */
enum { POINTS = 2000 };

/* Shown of a log axis at most: the fastest changes of a start may be over in
 * 1e-46 units of time. */
#define DECADES 1e-12

/* One of the two figures. */
struct view {
    const char *x, *y; /* labels */
    bool is_log;       /* both axes */
    void (*sample)(const struct study *, const struct transient *, size_t,
                   struct trajectory_row[]);
    double (*x_of)(const struct trajectory_row *);
    double (*y_of)(const struct trajectory_row *);
};

static double slip_of(const struct trajectory_row *r)
{
    return r->slip;
}

static double mu_of(const struct trajectory_row *r)
{
    return r->mu;
}

static double time_of(const struct trajectory_row *r)
{
    return r->time;
}

static double v_of(const struct trajectory_row *r)
{
    return r->v;
}

static const struct view friction_view = { "slip x/L", "friction coefficient μ",
                                           false,      sample_linear_slip,
                                           slip_of,    mu_of };
static const struct view speed_view = { "time t V*/L", "slip rate v = V/V*",
                                        true,          sample_log_time,
                                        time_of,       v_of };

/* The points of all runs, one run after another; owned. */
struct points {
    double *x, *y;
    size_t runs;
};

static enum status fill(const struct simulation *s, const struct view *view,
                        struct points *p)
{
    struct trajectory_row *row = calloc(POINTS, sizeof *row);

    p->x = calloc(s->runs * POINTS, sizeof *p->x);
    p->y = calloc(s->runs * POINTS, sizeof *p->y);
    if (row == NULL || p->x == NULL || p->y == NULL) {
        free(row);
        return STATUS_NO_MEMORY;
    }
    for (size_t k = 0; k < s->runs; k++) {
        if (s->run[k].curve.count == 0)
            continue;
        view->sample(&s->study, &s->run[k], POINTS, row);
        for (size_t i = 0; i < POINTS; i++) {
            p->x[p->runs * POINTS + i] = view->x_of(&row[i]);
            p->y[p->runs * POINTS + i] = view->y_of(&row[i]);
        }
        p->runs++;
    }
    free(row);
    return STATUS_OK;
}

static struct figure_axis axis_of(const char *label, const double *value,
                                  size_t count, bool is_log)
{
    double lo = HUGE_VAL, hi = -HUGE_VAL;

    for (size_t i = 0; i < count; i++) {
        lo = fmin(lo, value[i]);
        hi = fmax(hi, value[i]);
    }
    if (is_log)
        lo = fmax(lo, DECADES * hi);
    const double rim = is_log ? 0.03 * log(hi / lo) : 0.03 * (hi - lo);
    if (is_log)
        return (struct figure_axis){ label, lo * exp(-rim), hi * exp(rim),
                                     true };
    return (struct figure_axis){ label, lo - rim, hi + rim, false };
}

static enum status add_runs(struct figure *f, const struct simulation *s,
                            const struct points *p)
{
    enum status status = STATUS_OK;
    size_t shown = 0;

    for (size_t k = 0; k < s->runs && status == STATUS_OK; k++) {
        const struct transient_summary *sum = &s->run[k].sum;
        char entry[96];
        if (s->run[k].curve.count == 0)
            continue;
        snprintf(entry, sizeof entry, "from v = %.4g, ψ = %.4g", sum->v,
                 sum->psi);
        const struct figure_curve c = {
            .style = { .role = (enum figure_role)(FIGURE_SERIES_1 +
                                                  (int) (shown % 6)) },
            .entry = entry,
            .x = p->x + shown * POINTS,
            .y = p->y + shown * POINTS,
            .count = POINTS,
        };
        status = figure_add_curve(f, &c);
        shown++;
    }
    return status;
}

static enum status draw(const struct simulation *s, const struct view *view,
                        const char *path, bool keep_script, struct fault *why)
{
    struct figure f = FIGURE_EMPTY;
    struct points p = { .x = NULL };
    char title[512];

    snprintf(title, sizeof title, "%s%s%s, α = %.6g rad", s->scene.title,
             s->scene.title[0] ? " — " : "", s->study.block.law.preset,
             s->scene.alpha);
    enum status status = fill(s, view, &p);
    if (status == STATUS_OK && p.runs == 0) {
        snprintf(why->text, sizeof why->text, "%.300s: no run has a length",
                 path);
        status = STATUS_BAD_ARGUMENT;
    } else if (status == STATUS_OK) {
        const struct figure_axis x =
            axis_of(view->x, p.x, p.runs * POINTS, view->is_log);
        const struct figure_axis y =
            axis_of(view->y, p.y, p.runs * POINTS, view->is_log);
        status = figure_init(&f, title, &x, &y);
        if (status == STATUS_OK)
            status = add_runs(&f, s, &p);
        if (status == STATUS_OK)
            status = figure_write(&f, path, keep_script, why);
    }
    free(p.x);
    free(p.y);
    figure_free(&f);
    return status;
}

bool picture_time_path(const char *path, char out[PICTURE_PATH])
{
    const char *dot = strrchr(path, '.');
    const int stem = dot ? (int) (dot - path) : (int) strlen(path);

    return snprintf(out, PICTURE_PATH, "%.*s_time%s", stem, path,
                    dot ? dot : "") < PICTURE_PATH;
}

enum status picture_simulation(const struct simulation *s, const char *path,
                               bool keep_script, struct fault *why)
{
    char timed[PICTURE_PATH];

    if (!picture_time_path(path, timed))
        return STATUS_BAD_ARGUMENT;
    const enum status status = draw(s, &friction_view, path, keep_script, why);
    return status ? status : draw(s, &speed_view, timed, keep_script, why);
}
