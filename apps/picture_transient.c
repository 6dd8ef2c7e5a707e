#include "picture_transient.h"
#include "panel.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw.h"
#include "sample.h"

/* Points of a curve: more than there are px along its axis. */
enum { POINTS = 2000 };

/* Those that are the end of a run, and how far they may stretch a log axis. */
enum { ENDING = POINTS / 50, BEYOND = 30 };

/* Shown of a log axis at most: the fastest changes of a start may be over in
 * 1e-46 units of time. */
#define DECADES 1e-12

/* One figure; a second curve is drawn dashed. */
struct view {
    const char *panel, *x, *y; /* name; labels */
    bool x_log, y_log;
    void (*sample)(const struct slider *, const struct transient *, size_t,
                   struct trajectory_row[]);
    double (*x_of)(const struct study *, const struct trajectory_row *);
    struct {
        const char *name;
        double (*of)(const struct study *, const struct trajectory_row *);
    } y_of[2];
};

static double slip_of(const struct study *s, const struct trajectory_row *r)
{
    (void) s;
    return r->slip;
}

static double mu_of(const struct study *s, const struct trajectory_row *r)
{
    (void) s;
    return r->mu;
}

static double time_of(const struct study *s, const struct trajectory_row *r)
{
    (void) s;
    return r->time;
}

static double v_of(const struct study *s, const struct trajectory_row *r)
{
    (void) s;
    return r->v;
}

/* e^psi where psi is a logarithm, for a log axis. */
static double psi_of(const struct study *s, const struct trajectory_row *r)
{
    return law_psi_is_log(&s->slider.block.law) ? exp(r->psi) : r->psi;
}

#define SLIP "slip x/L"
#define TIME "time t V*/L"
static const struct view views[PICTURE_PANELS] = {
    { "",
      SLIP,
      "friction coefficient μ",
      false,
      false,
      sample_linear_slip,
      slip_of,
      { { "μ", mu_of } } },
    { "_slip",
      SLIP,
      "slip rate v = V/V*, interfacial state ψ",
      false,
      true,
      sample_linear_slip,
      slip_of,
      { { "v", v_of }, { "ψ", psi_of } } },
    { "_time",
      TIME,
      "slip rate v = V/V*, interfacial state ψ",
      true,
      true,
      sample_log_time,
      time_of,
      { { "v", v_of }, { "ψ", psi_of } } },
    { "_friction",
      TIME,
      "friction coefficient μ",
      true,
      false,
      sample_log_time,
      time_of,
      { { "μ", mu_of } } },
    { "_position",
      TIME,
      SLIP,
      true,
      false,
      sample_log_time,
      time_of,
      { { "x", slip_of } } },
};
const char *const picture_transient_panel[PICTURE_PANELS] = {
    "", "_slip", "_time", "_friction", "_position"
};

/* The points of all runs, one run after another; owned. */
struct points {
    double *x, *y[2]; /* y[1]: NULL where there is one curve only */
    size_t runs;
};

static enum status room_for(const struct simulation *s, const struct view *view,
                            struct points *p)
{
    const size_t count = s->runs * POINTS;

    p->x = calloc(count, sizeof *p->x);
    p->y[0] = calloc(count, sizeof *p->y[0]);
    if (view->y_of[1].of)
        p->y[1] = calloc(count, sizeof *p->y[1]);
    return p->x && p->y[0] && (p->y[1] || !view->y_of[1].of) ? STATUS_OK
                                                             : STATUS_NO_MEMORY;
}

static enum status fill(const struct simulation *s, const struct view *view,
                        struct points *p)
{
    struct trajectory_row *row = calloc(POINTS, sizeof *row);

    if (row == NULL || room_for(s, view, p) != STATUS_OK) {
        free(row);
        return STATUS_NO_MEMORY;
    }
    for (size_t k = 0; k < s->runs; k++) {
        if (s->run[k].curve.count == 0)
            continue;
        view->sample(&s->study.slider, &s->run[k], POINTS, row);
        for (size_t i = 0; i < POINTS; i++) {
            const size_t at = p->runs * POINTS + i;
            p->x[at] = view->x_of(&s->study, &row[i]);
            for (int c = 0; c < 2 && p->y[c]; c++)
                p->y[c][at] = view->y_of[c].of(&s->study, &row[i]);
        }
        p->runs++;
    }
    free(row);
    return STATUS_OK;
}

static void free_points(struct points *p)
{
    free(p->x);
    free(p->y[0]);
    free(p->y[1]);
}

/* A range of values. */
struct span {
    double lo, hi;
};

/* What is not finite, as e^psi where psi is a logarithm may be, is a gap. */
static struct span span_add(struct span r, double value)
{
    return isfinite(value)
               ? (struct span){ fmin(r.lo, value), fmax(r.hi, value) }
               : r;
}

/* Around one array of values, or two; of a log axis the ends of runs, where v
 * may fall to zero and psi grow without bound, add a decade or two at most. */
static struct figure_axis axis_of(const char *label, double *const value[2],
                                  size_t count, bool is_log)
{
    struct span all = { HUGE_VAL, -HUGE_VAL }, most = all;

    for (int c = 0; c < 2 && value[c]; c++)
        for (size_t i = 0; i < count; i++) {
            all = span_add(all, value[c][i]);
            if (i % POINTS < POINTS - ENDING)
                most = span_add(most, value[c][i]);
        }
    if (!is_log) {
        const double rim = 0.03 * (all.hi - all.lo);
        return (struct figure_axis){ label, all.lo - rim, all.hi + rim, false };
    }
    const double hi = fmin(all.hi, most.hi * BEYOND);
    const double lo = fmax(fmax(all.lo, most.lo / BEYOND), DECADES * hi);
    const double rim = pow(hi / lo, 0.03);
    return (struct figure_axis){ label, lo / rim, hi * rim, true };
}

/* One run in a colour of its own; alone, each curve in one of its own. */
static enum status add_run(struct figure *f, const struct view *view,
                           const struct transient_summary *sum,
                           const struct points *p, size_t at)
{
    enum status status = STATUS_OK;

    for (int c = 0; c < 2 && view->y_of[c].of && !status; c++) {
        char entry[96];
        const int colour = (p->runs == 1 ? c : (int) (at % 6));
        if (p->runs == 1)
            snprintf(entry, sizeof entry, "%s", view->y_of[c].name);
        else
            snprintf(entry, sizeof entry, "%s from v = %.4g, ψ = %.4g",
                     view->y_of[c].name, sum->v, sum->psi);
        status = figure_add_curve(
            f, &(struct figure_curve){
                   .style = { (enum figure_role)(FIGURE_SERIES_1 + colour),
                              c ? FIGURE_DASHED : FIGURE_SOLID, 0 },
                   .entry = entry,
                   .x = p->x + at * POINTS,
                   .y = p->y[c] + at * POINTS,
                   .count = POINTS });
    }
    return status;
}

static enum status add_runs(struct figure *f, const struct simulation *s,
                            const struct view *view, const struct points *p)
{
    enum status status = STATUS_OK;
    size_t shown = 0;

    for (size_t k = 0; k < s->runs && status == STATUS_OK; k++)
        if (s->run[k].curve.count > 0)
            status = add_run(f, view, &s->run[k].sum, p, shown++);
    return status;
}

static enum status add_line(struct figure *f, const char *entry,
                            enum figure_dash dash, struct vec2 a, struct vec2 b)
{
    return figure_add_curve(
        f, &(struct figure_curve){ .style = { FIGURE_TRAJECTORY, dash, 0 },
                                   .entry = entry,
                                   .x = (double[]){ a.x, b.x },
                                   .y = (double[]){ a.y, b.y },
                                   .count = 2 });
}

/* tan(alpha) across, and where the phases of a single run end. */
static enum status add_guides(struct figure *f, const struct simulation *s,
                              const struct view *view)
{
    const double drive = (double) s->study.slider.block.tan_alpha;
    enum status status = STATUS_OK;

    if (view->y_of[0].of == mu_of)
        status =
            add_line(f, "tan α", FIGURE_DASHED, (struct vec2){ f->x.lo, drive },
                     (struct vec2){ f->x.hi, drive });
    for (int i = 0; s->runs == 1 && i < PHASES - 1 && !status; i++) {
        const struct phase *q = &s->run[0].phase[i];
        const struct quantity *end =
            view->x_of == slip_of ? &q->end_slip : &q->end_time;
        if (quantity_exists(end))
            status = add_line(f, "ends of phases 1 and 2", FIGURE_DOTTED,
                              (struct vec2){ end->value, f->y.lo },
                              (struct vec2){ end->value, f->y.hi });
    }
    return status;
}

static enum status build(struct figure *f, const struct simulation *s,
                         const struct view *view, const struct points *p)
{
    const size_t count = p->runs * POINTS;
    const struct figure_axis x =
        axis_of(view->x, (double *[]){ p->x, NULL }, count, view->x_log);
    const struct figure_axis y = axis_of(view->y, p->y, count, view->y_log);
    char title[512];

    snprintf(title, sizeof title, "%s%s%s, α = %.6g rad", s->scene.title,
             s->scene.title[0] ? " — " : "", s->study.slider.block.law.preset,
             s->scene.alpha);
    enum status status = figure_init(f, title, &x, &y);
    if (status == STATUS_OK)
        status = add_guides(f, s, view);
    return status ? status : add_runs(f, s, view, p);
}

/* One figure, which is empty where it could not be made. */
static enum status make(const struct simulation *s, const struct view *view,
                        const char *path, struct figure *f, struct fault *why)
{
    struct points p = { .x = NULL };

    enum status status = fill(s, view, &p);
    if (status == STATUS_OK && p.runs == 0) {
        snprintf(why->text, sizeof why->text, "%.300s: no run has a length",
                 path);
        status = STATUS_BAD_ARGUMENT;
    }
    if (status == STATUS_OK)
        status = build(f, s, view, &p);
    free_points(&p);
    return status;
}

enum status picture_simulation(const struct simulation *s, const char *path,
                               bool keep_script, struct fault *why)
{
    char name[PICTURE_PANELS][PANEL_PATH];
    const char *to[PICTURE_PANELS];
    struct figure f[PICTURE_PANELS];
    enum status status = STATUS_OK;

    for (int i = 0; i < PICTURE_PANELS; i++) {
        f[i] = FIGURE_EMPTY;
        to[i] = name[i];
    }
    for (int i = 0; i < PICTURE_PANELS && status == STATUS_OK; i++)
        status = panel_path(path, views[i].panel, name[i])
                     ? make(s, &views[i], name[i], &f[i], why)
                     : STATUS_BAD_ARGUMENT;
    if (status == STATUS_OK)
        status = figures_write(f, to, PICTURE_PANELS, keep_script, why);
    for (int i = 0; i < PICTURE_PANELS; i++)
        figure_free(&f[i]);
    return status;
}
