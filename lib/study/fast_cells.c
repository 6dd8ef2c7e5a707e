/* Work needs no integral: by (27) it is tan(alpha) slip + eps^2 (v0^2 -
 * v1^2)/(2 cos(alpha)), exactly, and the mean friction that over the slip. */
#include "fast_cells.h"

#include <math.h>

#include "fast_layer.h"
#include "study.h"
#include "study_tolerance.h"

static const unsigned peaks = 1u << CELL_V_PEAK | 1u << CELL_MU_PEAK;
static const unsigned integrals =
    1u << CELL_SLIP | 1u << CELL_TIME | 1u << CELL_MU_MEAN;

enum status fast_cells_init(struct fast_cells *f, const struct study *s,
                            const struct monitor *monitor)
{
    *f = (struct fast_cells){ .study = s };
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

/* False: this one needs its whole orbit. */
static bool find(const struct fast_cells *f, struct vec2 z, double rtol,
                 unsigned which, struct cell *out)
{
    const struct vec2 offset = vec2_sub(z, f->study->system.origin);
    bool found = false;

    for (double tol = rtol; tol >= TOL_FAST_FINEST; tol *= TOL_FAST_FINER) {
        struct layer_options options = layer_defaults(tol);
        struct layer l;
        options.peaks = (which & peaks) != 0;
        layer_follow(&f->curve, offset, &options, &l);
        if (l.end == LAYER_LOST)
            break;
        if (l.end == LAYER_UNSURE)
            continue;
        found = true;
        *out = cell_of(f->study, z.x, which, &l);
        if (l.end == LAYER_RAN || worst_of(out, which) <= rtol)
            break;
    }
    return found && knows_friction(out, rtol);
}

/* ---- many ---------------------------------------------------------------- */

/* One state, its orbit whole where need be. */
static enum status find_any(const struct fast_cells *f, struct vec2 z,
                            double rtol, unsigned which, struct cell *out,
                            size_t *whole)
{
    if (find(f, z, rtol, which, out))
        return STATUS_OK;
    ++*whole;
    return cells_find(f->study, &z, 1, rtol, which, NULL, out);
}

enum status fast_cells_find(const struct fast_cells *f, const struct vec2 z[],
                            size_t n, double rtol, unsigned which,
                            const struct monitor *m, struct cell out[],
                            size_t *whole)
{
    enum { BLOCK = 4096 };
    enum status failed = STATUS_OK;
    size_t left = 0;

    if (!(rtol > 0.0 && rtol < 1.0))
        return STATUS_BAD_ARGUMENT;
    for (size_t i = 0; i < n; i++)
        if (!box_holds(f->study->system.domain, z[i]))
            return STATUS_BAD_ARGUMENT;
    for (size_t first = 0; first < n && failed == STATUS_OK; first += BLOCK) {
        const size_t end = n - first < BLOCK ? n : first + BLOCK;
#pragma omp parallel for schedule(dynamic, 16) reduction(+ : left)
        for (size_t i = first; i < end; i++) {
            const enum status status =
                find_any(f, z[i], rtol, which, &out[i], &left);
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
