/* The steps of fast_layer.c for LANES states at a time; compiled once for each
 * width, with LAYER_LANES its name.  Components, stages and errors are vectors
 * over the states; whether one is over is asked one by one (landing.h). */
#include "layer_lanes.h"

#include <string.h>

#include "explicit8_table.h"
#include "field_lanes.h"
#include "landing.h"
#include "slider.h"
#include "slow_tolerance.h"

enum { STEPS = EXPLICIT8_STAGES, PAIR = 2, WEIGHED = 5 };

struct bundle {
    const struct slow_curve *curve;
    lanes u[LAYER_DIM], k[STEPS][LAYER_DIM];
    lanes u1[LAYER_DIM], error[LAYER_DIM];
    lanes h, most, tol, least[2];
    lanes previous, last; /* error and size of the last accepted step */
    lanes fresh;          /* 1: no step was refused */
    lanes part, fair; /* of the estimates of order 5 that it misses; least */
    lanes across, wrong[2], place;
    lanes spread; /* rate at which orbits part where it is */
    struct landing at[LANES];
    bool busy[LANES], asks[LANES]; /* asks: whether it is over */
};

/* ---- the field ----------------------------------------------------------- */

/* d(x, y, t, slip)/ds, s the arc length. */
static void along(const struct bundle *b, const lanes *x, const lanes *y,
                  bool weighed, lanes du[])
{
    const struct block *block = &b->curve->slider->block;
    struct many_ctx c;
    lanes fx, fy;

    many_field(&block->law, &block->at, &c, x, y, &fx, &fy);
    const lanes part = 1.0 / lanes_root(fx * fx + fy * fy);
    du[LAYER_X] = fx * part;
    du[LAYER_Y] = fy * part;
    if (!weighed)
        return;
    du[LAYER_TIME] = lanes_exp(-c.scale) * part;
    du[LAYER_SLIP] = block->at.v0 * lanes_exp(*x) * du[LAYER_TIME];
}

/* ---- a step -------------------------------------------------------------- */

/* sum_j weight[j] k[j], j < count, of the first components. */
static inline void combine(const struct bundle *b, int components, int count,
                           const double weight[], lanes sum[])
{
    for (int i = 0; i < components; i++)
        sum[i] = LANES_OF(0.0);
    for (int j = 0; j < count; j++) {
        if (weight[j] == 0.0)
            continue;
        const lanes w = LANES_OF(weight[j]);
        for (int i = 0; i < components; i++)
            sum[i] = w * b->k[j][i] + sum[i];
    }
}

static lanes on_tolerance(const struct bundle *b, int i)
{
    const lanes larger =
        lanes_larger(lanes_size(b->u[i]), lanes_size(b->u1[i]));
    const lanes least =
        i < LAYER_TIME ? LANES_OF(1.0) : b->least[i - LAYER_TIME];

    return b->tol * (least + larger);
}

/* Stage j of a step; time and slip matter from stage WEIGHED on. */
static void stage(struct bundle *b, int j)
{
    lanes at[2];

    combine(b, 2, j, explicit8_a[j], at);
    at[0] = b->h * at[0] + b->u[LAYER_X];
    at[1] = b->h * at[1] + b->u[LAYER_Y];
    along(b, &at[0], &at[1], j >= WEIGHED, b->k[j]);
}

/* After the stages, as explicit8_try: the error over the tolerance. */
static lanes finish(struct bundle *b)
{
    lanes gain[LAYER_DIM], third[LAYER_DIM], e5[LAYER_DIM];
    lanes sum5 = LANES_OF(0.0), sum3 = LANES_OF(0.0);

    combine(b, LAYER_DIM, STEPS, explicit8_a[STEPS], gain);
    combine(b, LAYER_DIM, STEPS, explicit8_weight3, third);
    combine(b, LAYER_DIM, STEPS, explicit8_error5, e5);
    for (int i = 0; i < LAYER_DIM; i++) {
        b->u1[i] = b->h * gain[i] + b->u[i];
        const lanes unit = 1.0 / on_tolerance(b, i);
        const lanes r3 = (gain[i] - third[i]) * unit, r5 = e5[i] * unit;
        sum3 = r3 * r3 + sum3;
        sum5 = r5 * r5 + sum5;
        b->error[i] = lanes_size(b->h * e5[i]);
    }
    const lanes all = sum5 + 0.01 * sum3, none = LANES_OF(0.0);
    const lanes off = lanes_size(b->h) * sum5 / lanes_root(LAYER_DIM * all);
    b->part = lanes_less(none, sum5, lanes_root(sum5 / all), none + 1.0);
    return lanes_less(none, sum5, off, sum5);
}

/* As judge of fast_layer.c.  Returns 1 where the step is accepted, else 0;
 * *factor: what to multiply it by. */
static lanes judge(struct bundle *b, lanes off, lanes *factor)
{
    const lanes one = LANES_OF(1.0), none = LANES_OF(0.0);
    const lanes least = LANES_OF(TOL_STEP_SHRINK), size = lanes_size(b->h);
    const lanes good = lanes_less(off, one, one, none);
    const lanes now = lanes_larger(off, LANES_OF(TOL_LAYER_FLOOR));
    const lanes wish =
        lanes_less(off, LANES_OF(HUGE_VAL),
                   TOL_LAYER_SAFETY * lanes_exp(-0.125 * lanes_ln(now)), none);
    const lanes trend =
        size / b->last * lanes_exp(0.125 * lanes_ln(b->previous / now));
    const lanes next =
        lanes_less(none, good, lanes_smaller(wish, wish * trend), wish);
    const lanes most =
        lanes_less(none, good * b->fresh, LANES_OF(TOL_LAYER_GROWTH), one);

    *factor = lanes_larger(lanes_smaller(next, most), least);
    b->previous = lanes_less(none, good, now, b->previous);
    b->last = lanes_less(none, good, size, b->last);
    b->fresh = good;
    return good;
}

/* The rate at which orbits beside u part, per arc. */
static lanes spread_at(const struct bundle *b, const lanes u[])
{
    const lanes *du = b->k[0];
    lanes beside[2];

    const lanes x = u[0] - TOL_LAYER_ASIDE * du[LAYER_Y];
    const lanes y = u[1] + TOL_LAYER_ASIDE * du[LAYER_X];
    along(b, &x, &y, false, beside);
    return (du[LAYER_X] * beside[1] - du[LAYER_Y] * beside[0]) /
           TOL_LAYER_ASIDE;
}

/* As account of fast_layer.c, where the step to u is accepted. */
static void account(struct bundle *b, lanes good, const lanes u[])
{
    const lanes *du = b->k[0], *e = b->error, none = LANES_OF(0.0);
    const lanes dx = lanes_size(du[LAYER_X]), dy = lanes_size(du[LAYER_Y]);
    const lanes fair = lanes_larger(b->part, b->fair);
    const lanes spread = spread_at(b, u);
    const lanes most_h = b->h * lanes_larger(spread, b->spread);
    const lanes mean = 0.5 * b->h * (spread + b->spread);
    const lanes parting = lanes_larger(lanes_smaller(most_h, none), mean);
    const lanes left =
        lanes_exp(lanes_smaller(parting, LANES_OF(TOL_LAYER_PARTING))) *
        b->across;
    const lanes transport = TOL_LAYER_TRANSPORT * fair;
    const lanes digit_x = TOL_LAYER_ROUNDING * lanes_size(u[LAYER_X]);
    const lanes digit_y = TOL_LAYER_ROUNDING * lanes_size(u[LAYER_Y]);
    const lanes digits = digit_x + digit_y;
    const lanes missed = TOL_LAYER_MISSED * fair;
    const lanes x = missed * e[LAYER_X] + digit_x;
    const lanes y = missed * e[LAYER_Y] + digit_y;
    const lanes turned = TOL_LAYER_TERMS * digits * lanes_size(b->h) * dx * dy;
    const lanes across = x * dy + y * dx + turned + left;
    const lanes on =
        x * dx + y * dy + TOL_LAYER_TURNED * lanes_size(b->across - left);
    const lanes place = fair * (e[LAYER_X] + e[LAYER_Y]) + digits;
    const lanes most =
        TOL_LAYER_TRANSPORT * lanes_larger(across, b->across) + digits;

    for (int i = 0; i < 2; i++) {
        const int k = LAYER_TIME + i;
        const lanes gain = lanes_size(b->u1[k] - b->u[k]);
        const lanes wrong = transport * e[k] + du[k] * on + most * gain;
        b->wrong[i] += lanes_less(none, good, wrong, none);
    }
    b->across = lanes_less(none, good, across, b->across);
    b->spread = lanes_less(none, good, spread, b->spread);
    b->place += lanes_less(none, good, place, none);
}

/* Goes where the steps that are good end. */
static void move(struct bundle *b)
{
    const lanes none = LANES_OF(0.0);
    lanes factor, u[LAYER_DIM];
    const lanes good = judge(b, finish(b), &factor);

    for (int i = 0; i < LAYER_DIM; i++)
        u[i] = lanes_less(none, good, b->u1[i], b->u[i]);
    along(b, &u[LAYER_X], &u[LAYER_Y], true, b->k[0]);
    account(b, good, u);
    memcpy(b->u, u, sizeof u);
    b->h = factor * lanes_less(none, good, lanes_size(b->h), b->h);
    for (int l = 0; l < LANES; l++) {
        struct layer *const out = b->at[l].out;
        b->asks[l] = good[l] > 0.0;
        if (b->busy[l]) {
            out->calls += STEPS;
            out->steps += b->asks[l];
        }
    }
}

/* One attempt in every lane; its step is no longer than `most`. */
static void step(struct bundle b[])
{
    for (int p = 0; p < PAIR; p++)
        b[p].h = lanes_smaller(b[p].h, b[p].most);
    for (int j = 1; j < STEPS; j++)
        for (int p = 0; p < PAIR; p++)
            stage(&b[p], j);
    for (int p = 0; p < PAIR; p++)
        move(&b[p]);
}

/* ---- lanes --------------------------------------------------------------- */

static void take(struct bundle *b, int l, const struct layer_job *job,
                 struct layer *out)
{
    struct layer_options options = job->options;
    double least[2];

    options.peaks = false;
    landing_start(&b->at[l], b->curve, job->z, &options, out, least);
    for (int i = 0; i < LAYER_DIM; i++)
        b->u[i][l] = b->at[l].u[i];
    b->h[l] = TOL_LAYER_FIRST;
    b->tol[l] = options.rtol;
    b->fair[l] = options.fair;
    b->least[0][l] = least[0];
    b->least[1][l] = least[1];
    b->previous[l] = b->fresh[l] = 1.0;
    b->last[l] = 0.0;
    b->across[l] = b->at[l].across;
    b->spread[l] = b->wrong[0][l] = b->wrong[1][l] = b->place[l] = 0.0;
    b->busy[l] = b->asks[l] = true;
}

/* Whether lane l is done with its state. */
static bool is_over(struct bundle *b, int l)
{
    struct landing *const at = &b->at[l];
    double most;

    if (!b->asks[l])
        return !(fabs(b->h[l]) > TOL_LAYER_SHORTEST);
    for (int i = 0; i < LAYER_DIM; i++) {
        at->u[i] = b->u[i][l];
        at->du[i] = b->k[0][i][l];
    }
    at->across = b->across[l];
    at->time_error = b->wrong[0][l];
    at->slip_error = b->wrong[1][l];
    at->out->place_error = b->place[l];
    if (landing_is_over(at, &most) || at->out->steps >= TOL_LAYER_STEPS)
        return true;
    b->most[l] = most;
    return false;
}

/* Asks every lane that moved; done ones take the next of the jobs.  Returns how
 * many are busy. */
static int refill(struct bundle *b, const struct layer_job job[], size_t n,
                  size_t *next, struct layer out[])
{
    int busy = 0;

    for (bool again = true; again;) {
        busy = 0;
        again = false;
        for (int l = 0; l < LANES; l++) {
            if (b->busy[l] && is_over(b, l)) {
                b->busy[l] = *next < n;
                if (*next < n) {
                    take(b, l, &job[*next], &out[*next]);
                    ++*next;
                    again = true;
                }
            } else {
                b->asks[l] = false;
            }
            busy += b->busy[l];
        }
        if (again)
            along(b, &b->u[LAYER_X], &b->u[LAYER_Y], true, b->k[0]);
    }
    return busy;
}

void LAYER_LANES(const struct slow_curve *c, const struct layer_job job[],
                 size_t n, struct layer out[])
{
    struct bundle b[PAIR];
    size_t next = 0;
    int busy = n > 0;

    memset(b, 0, sizeof b);
    for (int l = 0; l < PAIR * LANES && n > 0; l++) { /* idle: as the last */
        const bool is_busy = next < n;
        const size_t i = is_busy ? next++ : n - 1;
        struct bundle *p = &b[l / LANES];
        p->curve = c;
        take(p, l % LANES, &job[i], &out[i]);
        p->busy[l % LANES] = is_busy;
    }
    for (int p = 0; p < PAIR && n > 0; p++)
        along(&b[p], &b[p].u[LAYER_X], &b[p].u[LAYER_Y], true, b[p].k[0]);
    while (busy > 0) {
        busy = 0;
        for (int p = 0; p < PAIR; p++)
            busy += refill(&b[p], job, n, &next, out);
        if (busy > 0)
            step(b);
    }
}
