/* Work needs no integral: by (27) it is tan(alpha) slip + eps^2 (v0^2 -
 * v1^2)/(2 cos(alpha)), exactly, and the mean friction that over the slip. */
#include "fast_cells.h"

#include <math.h>

#include "layer_lanes.h"
#include "study.h"
#include "study_tolerance.h"

static const unsigned peaks = 1u << CELL_V_PEAK | 1u << CELL_MU_PEAK;
static const unsigned integrals =
    1u << CELL_SLIP | 1u << CELL_TIME | 1u << CELL_MU_MEAN;

enum status fast_cells_init(struct fast_cells *f, const struct study *s,
                            const struct monitor *monitor)
{
    *f = (struct fast_cells){ .study = s, .lanes = layer_lanes_width(8) };
    return slow_curve_init(&f->curve, s, monitor);
}

void fast_cells_free(struct fast_cells *f)
{
    slow_curve_free(&f->curve);
}

/* ---- one state ----------------------------------------------------------- */

static void fill_integrals(const struct study *s, double x,
                           const struct layer *l, struct cell *c)
{
    const double t = (double) s->block.tan_alpha;
    const double least = TOL_FAST_LEAST;
    const double v0 = exp(x), v1 = exp(s->block.at.x0 + l->x_end);
    const double eps2 = material_eps2(&s->block.material);
    const double lost =
        0.5 * eps2 * (v0 - v1) * (v0 + v1) * hypot(1.0, t) / l->slip;

    c->slip = l->slip;
    c->slip_error = l->slip_error + least * l->slip;
    c->time = l->time;
    c->time_error = l->time_error + least * l->time;
    c->mu_mean = t + lost;
    c->mu_mean_error =
        fabs(lost) * c->slip_error / l->slip + least * (t + fabs(lost));
}

static void fill_peaks(const struct study *s, const struct layer *l,
                       struct cell *c)
{
    const struct material *m = &s->block.material;
    const double x = s->block.at.x0 + l->x_peak;
    const double rounding = TOL_FAST_LEAST * (1.0 + fabs(x));
    const double place = TOL_LAYER_TRANSPORT * l->place_error;

    c->v_peak = exp(x);
    c->v_peak_error = c->v_peak * (place + rounding);
    if (l->fate == FATE_REST_FINITE)
        return;
    c->mu_peak = l->mu_peak;
    c->mu_peak_error = (m->a + m->b) * place + l->mu_error + rounding;
}

/* The largest error of those asked for, relative. */
static double worst_of(const struct cell *c, unsigned which)
{
    const double of[CELL_FIELDS] = {
        [CELL_SLIP] = c->slip_error / c->slip,
        [CELL_TIME] = c->time_error / c->time,
        [CELL_MU_MEAN] = c->mu_mean_error / c->mu_mean,
        [CELL_V_PEAK] = c->v_peak_error / c->v_peak,
        [CELL_MU_PEAK] = c->mu_peak_error / c->mu_peak,
    };
    double worst = 0.0;

    for (unsigned k = 0; k < CELL_FIELDS; k++)
        if (which & 1u << k)
            worst = fmax(worst, fabs(of[k]));
    return worst;
}

static void keep_asked(unsigned which, struct cell *c)
{
    double *const of[CELL_FIELDS][2] = {
        [CELL_SLIP] = { &c->slip, &c->slip_error },
        [CELL_TIME] = { &c->time, &c->time_error },
        [CELL_MU_MEAN] = { &c->mu_mean, &c->mu_mean_error },
        [CELL_V_PEAK] = { &c->v_peak, &c->v_peak_error },
        [CELL_MU_PEAK] = { &c->mu_peak, &c->mu_peak_error },
    };

    for (unsigned k = 0; k < CELL_FIELDS; k++)
        if (!(which & 1u << k) || !isfinite(*of[k][0]))
            *of[k][0] = *of[k][1] = (double) NAN;
}

static struct cell cell_of(const struct study *s, double x, unsigned which,
                           const struct layer *l)
{
    struct cell c = { .exit_reason = l->fate };
    const double none = (double) NAN;

    c.slip = c.time = c.mu_mean = c.v_peak = c.mu_peak = none;
    if (l->end != LAYER_RAN) {
        if (which & integrals)
            fill_integrals(s, x, l, &c);
        if (which & peaks)
            fill_peaks(s, l, &c);
    }
    keep_asked(which, &c);
    return c;
}

/* Whether the table knows its largest friction as well as is asked: it may lie
 * beside the slow curve, between where the state lands and the next knot. */
static bool knows_friction(const struct cell *c, double rtol)
{
    return !(c->mu_peak_error > rtol * c->mu_peak);
}

/* ---- many ---------------------------------------------------------------- */

/* States followed together, and those of them that are not done. */
enum { TOGETHER = 128 };
struct batch {
    const struct fast_cells *fast;
    double rtol;
    unsigned which;
    const struct vec2 *z; /* of the batch */
    struct cell *out;
    bool found[TOGETHER];
    size_t of[TOGETHER], open; /* job i is of state of[i] */
    struct layer_job job[TOGETHER];
    struct layer layer[TOGETHER];
};

static void follow(struct batch *b)
{
    const struct slow_curve *c = &b->fast->curve;

    if (b->fast->lanes > 1 && !(b->which & peaks)) {
        layer_lanes_follow(c, b->fast->lanes, b->job, b->open, b->layer);
        return;
    }
    for (size_t i = 0; i < b->open; i++)
        layer_follow(c, b->job[i].z, &b->job[i].options, &b->layer[i]);
}

/* How much finer to follow what job i left to wish for; 0: not again. */
static double finer(struct batch *b, size_t i)
{
    const struct layer *l = &b->layer[i];
    const size_t k = b->of[i];

    if (l->end == LAYER_LOST)
        return 0.0;
    if (l->end == LAYER_UNSURE)
        return TOL_FAST_FINER;
    b->found[k] = true;
    b->out[k] = cell_of(b->fast->study, b->z[k].x, b->which, l);
    const double excess = worst_of(&b->out[k], b->which) / b->rtol;
    if (l->end == LAYER_RAN || excess <= 1.0)
        return 0.0;
    return fmax(TOL_FAST_FINER, TOL_FAST_AIM / excess);
}

static void set_job(struct batch *b, size_t i, size_t k, double tol)
{
    const struct vec2 origin = b->fast->study->system.origin;

    b->of[i] = k;
    b->job[i].z = vec2_sub(b->z[k], origin);
    b->job[i].options = layer_defaults(tol);
    b->job[i].options.peaks = (b->which & peaks) != 0;
}

/* n states, n <= TOGETHER. */
static void find_by_curve(struct batch *b, size_t n)
{
    b->open = n;
    for (size_t k = 0; k < n; k++) {
        set_job(b, k, k, b->rtol);
        b->found[k] = false;
    }
    while (b->open > 0) {
        size_t open = 0;
        follow(b);
        for (size_t i = 0; i < b->open; i++) {
            const double tol = b->job[i].options.promise * finer(b, i);
            if (tol >= TOL_FAST_FINEST)
                set_job(b, open++, b->of[i], tol);
        }
        b->open = open;
    }
}

/* Those whose orbits are needed whole are left to cells_find. */
static enum status find(const struct fast_cells *f, const struct vec2 z[],
                        size_t n, double rtol, unsigned which,
                        struct cell out[], size_t *whole)
{
    struct batch b = { f, rtol, which, .z = z, .out = out };
    enum status status = STATUS_OK;

    find_by_curve(&b, n);
    for (size_t k = 0; k < n && status == STATUS_OK; k++) {
        if (b.found[k] && knows_friction(&out[k], rtol))
            continue;
        ++*whole;
        status = cells_find(f->study, &z[k], 1, rtol, which, NULL, &out[k]);
    }
    return status;
}

enum status fast_cells_find(const struct fast_cells *f, const struct vec2 z[],
                            size_t n, double rtol, unsigned which,
                            const struct monitor *m, struct cell out[],
                            size_t *whole)
{
    enum { BLOCK = 32 * TOGETHER };
    enum status failed = STATUS_OK;
    size_t left = 0;

    if (!(rtol > 0.0 && rtol < 1.0))
        return STATUS_BAD_ARGUMENT;
    for (size_t i = 0; i < n; i++)
        if (!box_holds(f->study->system.domain, z[i]))
            return STATUS_BAD_ARGUMENT;
    for (size_t first = 0; first < n && failed == STATUS_OK; first += BLOCK) {
        const size_t end = n - first < BLOCK ? n : first + BLOCK;
#pragma omp parallel for schedule(dynamic) reduction(+ : left)
        for (size_t i = first; i < end; i += TOGETHER) {
            const size_t some = end - i < TOGETHER ? end - i : TOGETHER;
            const enum status status =
                find(f, &z[i], some, rtol, which, &out[i], &left);
            if (status != STATUS_OK) {
#pragma omp atomic write
                failed = status;
            }
        }
        if (failed == STATUS_OK && monitor_tell(m, "cells", end, n))
            failed = STATUS_STOPPED;
    }
    if (whole)
        *whole = left;
    return failed;
}
