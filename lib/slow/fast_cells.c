/* Work needs no integral: by (27) it is tan(alpha) slip + eps^2 (v0^2 -
 * v1^2)/(2 cos(alpha)), exactly, and the mean friction that over the slip. */
#include "fast_cells.h"

#include <float.h>
#include <math.h>

#include "layer_peaks.h"
#include "rest_form.h"
#include "slider.h"
#include "slow_tolerance.h"

static const unsigned peaks = 1u << CELL_V_PEAK | 1u << CELL_MU_PEAK;
static const unsigned integrals =
    1u << CELL_SLIP | 1u << CELL_TIME | 1u << CELL_MU_MEAN;

enum status fast_cells_init(struct fast_cells *f, const struct slider *s,
                            const struct monitor *monitor)
{
    *f = (struct fast_cells){ .slider = s, .lanes = layer_width(8) };
    return slow_curve_init(&f->curve, s, monitor);
}

void fast_cells_free(struct fast_cells *f)
{
    slow_curve_free(&f->curve);
}

/* ---- one state ----------------------------------------------------------- */

/* Work over slip, per unit of v0^2 - v1^2. */
static double work_of(const struct slider *s, double slip)
{
    const double t = (double) s->block.tan_alpha;

    return 0.5 * material_eps2(&s->block.material) * hypot(1.0, t) / slip;
}

/* Friction from c's slip, `left` being v1^2.  tan(alpha) and the sum round by
 * half a digit each, what is lost by five at most. */
static void fill_friction(const struct slider *s, double x, double left,
                          double left_error, struct cell *c)
{
    const double t = (double) s->block.tan_alpha;
    const double v0 = exp(x), per = work_of(s, c->slip);
    const double lost = per * (v0 * v0 - left);
    const double start = 2.0 * TOL_ROUNDING * (1.0 + fabs(x)) * v0 * v0;

    c->mu_mean = t + lost;
    c->mu_mean_error = fabs(lost) * c->slip_error / c->slip +
                       per * (start + left_error) +
                       DBL_EPSILON * (t + TOL_ROUNDINGS_FEW * fabs(lost));
}

/* v^2 where it arrests, and its error. */
static double square_at_end(const struct slider *s, const struct layer *l,
                            double *error)
{
    const double v = exp(s->block.at.x0 + l->x_end);

    *error = v * v * (2.0 * l->x_end_error + TOL_ROUNDINGS_FEW * DBL_EPSILON);
    return v * v;
}

static void fill_integrals(const struct slider *s, double x,
                           const struct layer *l, struct cell *c)
{
    double left_error;
    const double left = square_at_end(s, l, &left_error);

    c->slip = l->slip;
    c->slip_error = l->slip_error + TOL_ROUNDING * l->slip + TOL_VANISHING;
    c->time = l->time;
    c->time_error = l->time_error + TOL_ROUNDING * l->time + TOL_VANISHING;
    fill_friction(s, x, left, left_error, c);
}

unsigned fast_cells_fields(const struct slider *s, enum fate fate)
{
    switch (fate) {
        case FATE_RUNAWAY:
        case FATE_UNDECIDED:
            return 0;
        case FATE_REST_FINITE:
            return integrals | 1u << CELL_V_PEAK;
        case FATE_REST_ASYMPTOTIC:
            return rest_form_at(&s->block).has_slip
                       ? peaks | 1u << CELL_SLIP | 1u << CELL_MU_MEAN
                       : peaks;
        default:
            return integrals | peaks;
    }
}

/* A peak at the start is the start's, to rounding; of others that is in their
 * errors. */
static void fill_peaks(const struct slider *s, struct vec2 z,
                       const struct layer *l, struct cell *c)
{
    const struct vec2 m = s->block.steep;
    const struct vec2 o = s->plane.system.origin, from = vec2_sub(z, o);
    const double x = s->block.at.x0 + l->x.value;
    const double rounding =
        TOL_ROUNDING * (1.0 + fabs(z.x) + fabs(z.y) + fabs(o.x) + fabs(o.y));
    const bool fastest = l->falls[0] && l->x.value == from.x;
    const bool hardest = l->falls[1] &&
                         l->mu.value == block_mu(&s->block, from) &&
                         l->mu_next < l->mu.value - TOL_ASIDE * (m.x + m.y);

    c->v_peak = exp(fastest ? z.x : x);
    c->v_peak_error =
        c->v_peak * (expm1(layer_peak_error(&l->x)) +
                     TOL_ROUNDING * (fastest ? 1.0 : 1.0 + fabs(x)));
    c->mu_peak = l->mu.value;
    c->mu_peak_error = (m.x + m.y) * rounding +
                       (hardest ? 0.0 : layer_peak_error(&l->mu)) +
                       TOL_ROUNDINGS_FEW * DBL_EPSILON * fabs(l->mu.value);
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

static struct cell cell_of(const struct slider *s, struct vec2 z,
                           unsigned which, const struct layer *l)
{
    struct cell c = { .exit_reason = l->fate };
    const double none = (double) NAN;

    c.slip = c.time = c.mu_mean = c.v_peak = c.mu_peak = none;
    if (l->end != LAYER_RAN) {
        if (which & integrals)
            fill_integrals(s, z.x, l, &c);
        if (which & peaks)
            fill_peaks(s, z, l, &c);
    }
    keep_asked(which & fast_cells_fields(s, (enum fate) l->fate), &c);
    return c;
}

/* Whether the table knows its peaks as well as is asked: the largest friction
 * may lie beside the slow curve, between where the state lands and the next
 * knot. */
static bool knows_peaks(const struct cell *c, double rtol)
{
    return !(c->mu_peak_error > rtol * c->mu_peak) &&
           !(c->v_peak_error > rtol * c->v_peak);
}

/* ---- many ---------------------------------------------------------------- */

/* States followed together, and those of them that are not done: the fewer
 * these, the more lanes are idle at the end. */
enum { TOGETHER = 512, FEWEST = 128, PARTS = 8 };
struct batch {
    const struct fast_cells *fast;
    double rtol;
    unsigned which;
    const struct vec2 *z; /* of the batch */
    struct cell *out;
    bool found[TOGETHER];
    double excess[TOGETHER];   /* of bars over the promise; 0: not known */
    bool vain[TOGETHER];       /* another try hardly made it smaller */
    size_t of[TOGETHER], open; /* job i is of state of[i] */
    struct layer_job job[TOGETHER];
    struct layer layer[TOGETHER];
};

/* How much finer to follow what job i left to wish for; 0: not again. */
static double finer(struct batch *b, size_t i)
{
    const struct layer *l = &b->layer[i];
    const size_t k = b->of[i];

    if (l->end == LAYER_LOST)
        return 0.0;
    if (l->end == LAYER_UNSURE)
        return 1.0 / TOL_RETRY;
    b->found[k] = true;
    b->out[k] = cell_of(b->fast->slider, b->z[k], b->which, l);
    const double before = b->excess[k];
    const double excess = worst_of(&b->out[k], b->which) / b->rtol;
    const bool vain = before > 0.0 && !(excess < TOL_CELLS_GAIN * before);
    if (l->end == LAYER_RAN || excess <= 1.0 || (vain && b->vain[k]))
        return 0.0;
    b->excess[k] = excess;
    b->vain[k] = vain;
    return vain ? 1.0 / TOL_RETRY : fmax(1.0 / TOL_RETRY, TOL_SHARE / excess);
}

static struct layer_job job_of(const struct fast_cells *f, struct vec2 z,
                               struct layer_options options)
{
    return (struct layer_job){ vec2_sub(z, f->slider->plane.system.origin),
                               options };
}

static void set_job(struct batch *b, size_t i, size_t k, double tol)
{
    b->of[i] = k;
    b->job[i] = job_of(b->fast, b->z[k], layer_defaults(tol));
    b->job[i].options.peaks = (b->which & peaks) != 0;
}

/* Job number `to` is job i once more, of which something is known by now. */
static void set_again(struct batch *b, size_t to, size_t i, double tol)
{
    const struct layer seen = b->layer[i];

    set_job(b, to, b->of[i], tol);
    if (seen.end == LAYER_LANDED) {
        b->job[to].options.time = seen.time;
        b->job[to].options.slip = seen.slip;
    }
}

/* n states, n <= TOGETHER. */
static void find_by_curve(struct batch *b, size_t n)
{
    b->open = n;
    for (size_t k = 0; k < n; k++) {
        set_job(b, k, k, b->rtol);
        b->found[k] = false;
        b->excess[k] = 0.0;
        b->vain[k] = false;
    }
    while (b->open > 0) {
        size_t open = 0;
        layer_follow(&b->fast->curve, b->fast->lanes, b->job, b->open,
                     b->layer);
        for (size_t i = 0; i < b->open; i++) {
            const double tol = b->job[i].options.promise * finer(b, i);
            if (tol >= TOL_RTOL_DEFAULT)
                set_again(b, open++, i, tol);
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
        if (b.found[k] && knows_peaks(&out[k], rtol))
            continue;
        ++*whole;
        status = cells_find(f->slider, &z[k], 1, rtol, which, NULL, &out[k]);
    }
    return status;
}

static bool are_states(const struct fast_cells *f, const struct vec2 z[],
                       size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!box_holds(f->slider->plane.system.domain, z[i]))
            return false;
    return true;
}

/* How many of n states: threads are to have some each. */
static size_t together_of(size_t n)
{
    const size_t part = n / PARTS;

    return part < FEWEST ? FEWEST : part < TOGETHER ? part : TOGETHER;
}

enum status fast_cells_find(const struct fast_cells *f, const struct vec2 z[],
                            size_t n, double rtol, unsigned which,
                            const struct monitor *m, struct cell out[],
                            size_t *whole)
{
    enum { BLOCK = 16 * TOGETHER };
    const size_t part = together_of(n);
    enum status failed = STATUS_OK;
    size_t left = 0;

    if (!(rtol > 0.0 && rtol < 1.0) || !are_states(f, z, n))
        return STATUS_BAD_ARGUMENT;
    for (size_t first = 0; first < n && failed == STATUS_OK; first += BLOCK) {
        const size_t end = n - first < BLOCK ? n : first + BLOCK;
#pragma omp parallel for schedule(dynamic) reduction(+ : left)
        for (size_t i = first; i < end; i += part) {
            const size_t some = end - i < part ? end - i : part;
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

/* ---- patches ------------------------------------------------------------- */

/* Those that are not followed any further: as fast_cells_find, without base;
 * by (27) their friction tells how fast they arrest. */
static enum status sample_whole(const struct fast_cells *f,
                                struct patch_sample *s, double rtol,
                                unsigned which)
{
    const double v = exp(s->z.x);
    const double t = (double) f->slider->block.tan_alpha;
    const enum status status =
        fast_cells_find(f, &s->z, 1, rtol, which, NULL, &s->cell, NULL);
    const double per = work_of(f->slider, s->cell.slip);

    s->base = base_point_of(&f->curve, &(struct layer){ .end = LAYER_LOST });
    s->left = v * v - (s->cell.mu_mean - t) / per;
    s->left_error =
        s->cell.mu_mean_error / per + TOL_ROUNDINGS_FEW * DBL_EPSILON * v * v;
    return status;
}

static void take_sample(const struct fast_cells *f, const struct layer *l,
                        unsigned which, struct patch_sample *s)
{
    struct layer seen = *l;

    s->base = base_point_of(&f->curve, l);
    if (base_point_passes(&f->curve, s->base.y, s->base.y) ||
        l->fate == FATE_RUNAWAY)
        seen.end = LAYER_RAN;
    s->cell = cell_of(f->slider, s->z, which & integrals, &seen);
    s->left = square_at_end(f->slider, l, &s->left_error);
}

/* Those whose bars are far too wide are followed once more. */
static enum status take_peaks(const struct fast_cells *f, const struct layer *l,
                              double tol, unsigned which,
                              struct patch_sample *s)
{
    struct cell c = cell_of(f->slider, s->z, which & peaks, l);
    enum status status = STATUS_OK;

    if (l->end == LAYER_LOST || l->end == LAYER_UNSURE ||
        worst_of(&c, which & peaks) > TOL_FAST_LOOSE * tol)
        status =
            fast_cells_find(f, &s->z, 1, tol, which & peaks, NULL, &c, NULL);
    s->cell.v_peak = c.v_peak;
    s->cell.v_peak_error = c.v_peak_error;
    s->cell.mu_peak = c.mu_peak;
    s->cell.mu_peak_error = c.mu_peak_error;
    return status;
}

/* Peaks have no base points, and one orbit more, but for those that were found
 * whole. */
static enum status add_peaks(const struct fast_cells *f,
                             struct patch_sample s[], const bool whole[],
                             size_t n, double rtol, unsigned which)
{
    const double tol = fmax(rtol, TOL_ROOT);
    enum status status = STATUS_OK;
    struct layer_job job[FEWEST];
    struct layer layer[FEWEST];
    size_t open = 0;

    for (size_t i = 0; i < n; i++)
        if (!whole[i])
            job[open++] = job_of(f, s[i].z, layer_defaults(tol));
    layer_follow(&f->curve, f->lanes, job, open, layer);
    open = 0;
    for (size_t i = 0; i < n && status == STATUS_OK; i++)
        if (!whole[i])
            status = take_peaks(f, &layer[open++], tol, which, &s[i]);
    return status;
}

/* n states, n <= FEWEST: none is followed twice, nor finer than the curve is:
 * an orbit that asks too much is lost. */
static enum status sample_some(const struct fast_cells *f,
                               struct patch_sample s[], size_t n, double rtol,
                               unsigned which)
{
    struct layer_options options = layer_defaults(fmax(rtol, TOL_REST_WRONG));
    struct layer_job job[FEWEST];
    struct layer layer[FEWEST];
    bool whole[FEWEST];
    enum status status = STATUS_OK;

    options.peaks = false;
    options.through = true;
    for (size_t i = 0; i < n; i++)
        job[i] = job_of(f, s[i].z, options);
    layer_follow(&f->curve, f->lanes, job, n, layer);
    for (size_t i = 0; i < n && status == STATUS_OK; i++) {
        whole[i] = layer[i].end == LAYER_LOST;
        if (whole[i])
            status = sample_whole(f, &s[i], rtol, which);
        else
            take_sample(f, &layer[i], which, &s[i]);
    }
    if (status == STATUS_OK && which & peaks)
        status = add_peaks(f, s, whole, n, rtol, which);
    return status;
}

enum status fast_cells_sample(const struct fast_cells *f,
                              struct patch_sample sample[], size_t n,
                              double rtol, unsigned which)
{
    enum status failed = STATUS_OK;

    if (which & 1u << CELL_MU_MEAN) /* by slip */
        which |= 1u << CELL_SLIP;
#pragma omp parallel for schedule(dynamic)
    for (size_t i = 0; i < n; i += FEWEST) {
        const size_t some = n - i < FEWEST ? n - i : FEWEST;
        const enum status status =
            sample_some(f, &sample[i], some, rtol, which);
        if (status != STATUS_OK) {
#pragma omp atomic write
            failed = status;
        }
    }
    return failed;
}

void fast_cells_friction(const struct fast_cells *f, struct vec2 z, double left,
                         double left_error, struct cell *c)
{
    fill_friction(f->slider, z.x, left, left_error, c);
}

bool fast_cells_tell(const struct fast_cells *f, struct vec2 z,
                     const struct base_point *base, unsigned which,
                     struct cell *out)
{
    struct layer l;
    const bool is_told = base_point_tell(&f->curve, base, &l);

    *out = cell_of(f->slider, z, l.end == LAYER_LANDED ? which & integrals : 0,
                   &l);
    return is_told;
}
