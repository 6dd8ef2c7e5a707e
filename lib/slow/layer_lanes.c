/* In arc length of the chart an orbit off the slow curve is not stiff.  Its
 * steps are by the method of order 8 with time and slip as components.  What a
 * step may have missed is kept, with its sign, and weighed by what it makes of
 * all to come once that is known (landing_weigh).
 *
 * Step sizes follow the trend of the last two (Gustafsson, ACM TOMS 20, 1994,
 * 496-517): a fifth fewer are refused than without.
 *
 * LANES states go at a time; compiled once for each width, with LAYER_LANES its
 * name.  Components, stages and errors are vectors over the states; whether one
 * is over, and what its peaks are, is asked one by one (landing.h,
 * layer_peaks.h). */
#include "layer_lanes.h"

#include <string.h>

#include "explicit8_table.h"
#include "landing.h"
#include "landing_weigh.h"
#include "layer_peaks.h"
#include "slider.h"
#include "slow_tolerance.h"
#include "tape_lanes.h"

enum { STEPS = EXPLICIT8_STAGES, PAIR = TAPE_SETS, WEIGHED = 5 };

struct bundle {
    const struct slow_curve *curve;
    lanes u[LAYER_DIM], k[STEPS][LAYER_DIM];
    lanes u1[LAYER_DIM];
    lanes term[LANDING_TERMS][LAYER_DIM]; /* as of landing.h */
    lanes h, most, tol, least[2];
    lanes previous, last;   /* error and size of the last accepted step */
    lanes fresh;            /* 1: no step was refused */
    lanes spread, aside[2]; /* per unit to the left of where it is */
    struct landing at[LANES];
    bool busy[LANES], asks[LANES]; /* asks: whether it is over */
};

/* ---- the field ----------------------------------------------------------- */

/* d(x, y, t, slip)/ds of both bundles, s the arc length. */
static void along(const struct bundle b[], const lanes x[], const lanes y[],
                  bool weighed, lanes *const du[])
{
    const struct block *block = &b->curve->slider->block;
    lanes fx[PAIR], fy[PAIR], scale[PAIR];

    tape_lanes_field(&block->plane.t, x, y, fx, fy, scale);
    for (int p = 0; p < PAIR; p++) {
        const lanes part = 1.0 / lanes_root(fx[p] * fx[p] + fy[p] * fy[p]);
        du[p][LAYER_X] = fx[p] * part;
        du[p][LAYER_Y] = fy[p] * part;
        if (!weighed)
            continue;
        du[p][LAYER_TIME] = lanes_exp(-scale[p]) * part;
        du[p][LAYER_SLIP] = block->at.v0 * lanes_exp(x[p]) * du[p][LAYER_TIME];
    }
}

/* Where they are, into k[0]. */
static void start(struct bundle b[])
{
    lanes x[PAIR], y[PAIR], *du[PAIR];

    for (int p = 0; p < PAIR; p++) {
        x[p] = b[p].u[LAYER_X];
        y[p] = b[p].u[LAYER_Y];
        du[p] = b[p].k[0];
    }
    along(b, x, y, true, du);
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

/* Stage j of both steps; time and slip matter from stage WEIGHED on. */
static void stage(struct bundle b[], int j)
{
    lanes at[2], x[PAIR], y[PAIR], *du[PAIR];

    for (int p = 0; p < PAIR; p++) {
        combine(&b[p], 2, j, explicit8_a[j], at);
        x[p] = b[p].h * at[0] + b[p].u[LAYER_X];
        y[p] = b[p].h * at[1] + b[p].u[LAYER_Y];
        du[p] = b[p].k[j];
    }
    along(b, x, y, j >= WEIGHED, du);
}

/* After the stages, as explicit8_try: the error over the tolerance. */
static lanes finish(struct bundle *b)
{
    lanes gain[LAYER_DIM], third[LAYER_DIM], e5[LAYER_DIM];
    const lanes none = LANES_OF(0.0);
    lanes sum5 = none, sum3 = none;

    combine(b, LAYER_DIM, STEPS, explicit8_a[STEPS], gain);
    combine(b, LAYER_DIM, STEPS, explicit8_weight3, third);
    combine(b, LAYER_DIM, STEPS, explicit8_error5, e5);
    for (int n = 0; n < EXPLICIT8_TERMS; n++)
        combine(b, LAYER_DIM, STEPS, explicit8_term[n], b->term[n]);
    for (int i = 0; i < LAYER_DIM; i++) {
        b->u1[i] = b->h * gain[i] + b->u[i];
        const lanes unit = 1.0 / on_tolerance(b, i);
        const lanes r5 = e5[i] * unit, r3 = (gain[i] - third[i]) * unit;
        sum3 += r3 * r3;
        sum5 += r5 * r5;
        b->term[LANDING_FOURTH][i] = gain[i] - third[i];
        for (int n = 0; n < LANDING_TERMS; n++)
            b->term[n][i] *= b->h;
    }
    const lanes all = sum5 + 0.01 * sum3;
    const lanes off = lanes_size(b->h) * sum5 / lanes_root(LAYER_DIM * all);
    return lanes_less(none, sum5, off, sum5);
}

/* Returns 1 where a step with this error, relative to what is allowed, is
 * accepted, else 0; *factor: what to multiply it by.  Onto the curve, and away
 * from corners, steps change like their distance: the next one by as much as
 * the last one did, if that is less than its error allows. */
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

/* struct landing_step of every lane, and what else is known of the step;
 * b->k[0] was du0. */
struct steps {
    lanes across[LANDING_TERMS], gain[2][LANDING_TERMS];
    lanes digits, rounded, left, carried[2]; /* rounded: its end */
    lanes gained[2], rounds[2];              /* of time and slip */
    lanes good, factor, du0[LAYER_DIM];
    lanes spread, aside[2];
};

/* What changes per unit to the left of u: beside it by less than the way to the
 * saddle, or the field there is that of other orbits. */
static void look_aside(const struct bundle b[], struct steps m[])
{
    lanes x[PAIR], y[PAIR], far[PAIR], at[PAIR][LAYER_DIM], *to[PAIR];

    for (int p = 0; p < PAIR; p++) {
        const lanes size = lanes_larger(lanes_size(b[p].u[LAYER_X]),
                                        lanes_size(b[p].u[LAYER_Y]));
        far[p] = TOL_ASIDE * lanes_smaller(size, LANES_OF(1.0));
        x[p] = b[p].u[LAYER_X] - far[p] * b[p].k[0][LAYER_Y];
        y[p] = b[p].u[LAYER_Y] + far[p] * b[p].k[0][LAYER_X];
        to[p] = at[p];
    }
    along(b, x, y, true, to);
    for (int p = 0; p < PAIR; p++) {
        const lanes *du = b[p].k[0];
        for (int i = 0; i < 2; i++)
            m[p].aside[i] =
                (at[p][LAYER_TIME + i] - du[LAYER_TIME + i]) / far[p];
        m[p].spread =
            (du[LAYER_X] * at[p][LAYER_Y] - du[LAYER_Y] * at[p][LAYER_X]) /
            far[p];
    }
}

/* What a step makes of what was across at its start, where the direction was
 * du0.  Distances across the orbit shrink as those of orbits that close in on
 * each other at both ends, and grow as they part in the mean of both.  Off its
 * orbit a state is also as far along as the orbit turns. */
static void carry(struct bundle *b, struct steps *m)
{
    const lanes *du0 = m->du0, *du1 = b->k[0];
    const lanes none = LANES_OF(0.0), one = LANES_OF(1.0);
    const lanes most = b->h * lanes_larger(m->spread, b->spread);
    const lanes half = 0.5 * b->h * (m->spread + b->spread);
    const lanes grows = lanes_smaller(
        lanes_larger(lanes_smaller(most, none), half), LANES_OF(TOL_STEP_MOST));
    const lanes turn =
        du0[LAYER_X] * du1[LAYER_Y] - du0[LAYER_Y] * du1[LAYER_X];

    m->left = lanes_exp(grows);
    const lanes even =
        lanes_less(none, lanes_size(grows), lanes_em1(grows) / grows, one);
    for (int i = 0; i < 2; i++) {
        const int k = LAYER_TIME + i;
        m->carried[i] =
            0.5 * even *
            (b->h * (b->aside[i] + m->aside[i]) - turn * (du0[k] + du1[k]));
        b->aside[i] = lanes_less(none, m->good, m->aside[i], b->aside[i]);
    }
    b->spread = lanes_less(none, m->good, m->spread, b->spread);
}

/* The terms across its end, and of time and slip where it is as far along. */
static void turn_terms(const struct bundle *b, struct steps *m)
{
    const lanes *du = b->k[0];

    for (int n = 0; n < LANDING_TERMS; n++) {
        const lanes *t = b->term[n];
        const lanes on = t[LAYER_X] * du[LAYER_X] + t[LAYER_Y] * du[LAYER_Y];
        m->across[n] = t[LAYER_Y] * du[LAYER_X] - t[LAYER_X] * du[LAYER_Y];
        for (int i = 0; i < 2; i++)
            m->gain[i][n] = t[LAYER_TIME + i] - du[LAYER_TIME + i] * on;
    }
}

/* What a step errs by.  Rounding moves its end, and turns the field by as much,
 * relative, as its exponents are wrong. */
static void account(struct bundle *b, struct steps *m)
{
    const lanes *u = b->u, *du = b->k[0];
    const lanes dx = lanes_size(du[LAYER_X]), dy = lanes_size(du[LAYER_Y]);
    const lanes digit_x = TOL_ROUNDING * lanes_size(u[LAYER_X]);
    const lanes digit_y = TOL_ROUNDING * lanes_size(u[LAYER_Y]);
    const lanes digits = digit_x + digit_y;
    const lanes moved = digit_x * dx + digit_y * dy;

    carry(b, m);
    turn_terms(b, m);
    m->digits = digit_x * dy + digit_y * dx +
                TOL_SLOW_TERMS * digits * lanes_size(b->h) * dx * dy;
    m->rounded = digits;
    for (int i = 0; i < 2; i++)
        m->rounds[i] = digits * m->gained[i] + du[LAYER_TIME + i] * moved;
}

static void of_lane(const lanes from[], int l, double to[])
{
    for (int i = 0; i < LAYER_DIM; i++)
        to[i] = from[i][l];
}

/* The peaks on lane l's step, which is good. */
static void find_peaks(struct bundle *b, int l, const struct steps *m,
                       double across)
{
    struct explicit8 stages;
    double u1[LAYER_DIM], du1[LAYER_DIM];

    of_lane(m->du0, l, stages.k[0]);
    for (int j = 1; j < STEPS; j++)
        of_lane(b->k[j], l, stages.k[j]);
    of_lane(b->u, l, u1);
    of_lane(b->k[0], l, du1);
    layer_peaks_step(&b->at[l], b->h[l], across, &stages, u1, du1);
}

/* What lane l's step misses across its end, and of its place. */
static double missed(struct bundle *b, int l, const struct steps *m,
                     double *place)
{
    double size[LANDING_TERMS], across = 0.0;
    const lanes *const first = b->term[0], *const second = b->term[1];
    const double apart = fabs(first[LAYER_X][l] - second[LAYER_X][l]) +
                         fabs(first[LAYER_Y][l] - second[LAYER_Y][l]);

    for (int n = 0; n < LANDING_TERMS; n++)
        size[n] = fabs(b->term[n][LAYER_X][l]) + fabs(b->term[n][LAYER_Y][l]);
    const double part = landing_missed(size, apart);
    for (int n = 0; n < EXPLICIT8_TERMS; n++) {
        across = fmax(across, fabs(m->across[n][l]));
        *place = fmax(*place, part * size[n]);
    }
    return part * across;
}

/* Keeps what lane l's step was. */
static void keep(struct bundle *b, int l, const struct steps *m)
{
    struct landing *at = &b->at[l];
    struct landing_step *to = &at->step[at->out->steps++];
    double place = 0.0;
    const double before = at->across;
    const double across = missed(b, l, m, &place) + m->digits[l];

    at->across = m->left[l] * before + across;
    at->time_error += m->rounds[0][l];
    at->slip_error += m->rounds[1][l];
    at->out->place_error += place + m->rounded[l];
    if (at->options.peaks)
        find_peaks(b, l, m, fmax(m->left[l], 1.0) * before + across);
    *to = (struct landing_step){
        .from = landing_place(at),
        .h = b->h[l],
        .digits = m->digits[l],
        .left = m->left[l],
        .time_gain = m->carried[0][l],
        .slip_gain = m->carried[1][l],
    };
    for (int n = 0; n < LANDING_TERMS; n++) {
        to->across[n] = m->across[n][l];
        to->time[n] = m->gain[0][n][l];
        to->slip[n] = m->gain[1][n][l];
    }
}

/* To where the steps that are good end; one into a box of arrest is taken
 * again. */
static void go_on(struct bundle *b, struct steps *m)
{
    double u1[LAYER_DIM];

    m->good = judge(b, finish(b), &m->factor);
    for (int l = 0; l < LANES; l++) {
        of_lane(b->u1, l, u1);
        if (b->busy[l] && b->at[l].options.peaks && m->good[l] > 0.0 &&
            landing_is_past(&b->at[l], u1)) { /* it would see peaks beyond */
            m->good[l] = b->fresh[l] = 0.0;
            m->factor[l] = TOL_ORBIT_RETREAT;
        }
    }
    for (int i = 0; i < 2; i++)
        m->gained[i] = lanes_size(b->u1[LAYER_TIME + i] - b->u[LAYER_TIME + i]);
    for (int i = 0; i < LAYER_DIM; i++)
        b->u[i] = lanes_less(LANES_OF(0.0), m->good, b->u1[i], b->u[i]);
    memcpy(m->du0, b->k[0], sizeof m->du0);
}

/* What the steps were, and how long the next ones are. */
static void take_note(struct bundle *b, struct steps *m)
{
    account(b, m);
    for (int l = 0; l < LANES; l++) {
        if (b->busy[l])
            b->at[l].out->calls += STEPS;
        if (b->busy[l] && m->good[l] > 0.0)
            keep(b, l, m);
    }
    b->h =
        m->factor * lanes_less(LANES_OF(0.0), m->good, lanes_size(b->h), b->h);
    for (int l = 0; l < LANES; l++)
        b->asks[l] = m->good[l] > 0.0 || !(fabs(b->h[l]) > TOL_TOUCH);
}

/* One attempt in every lane; its step is no longer than `most`. */
static void step(struct bundle b[])
{
    struct steps m[PAIR];

    for (int p = 0; p < PAIR; p++)
        b[p].h = lanes_smaller(b[p].h, b[p].most);
    for (int j = 1; j < STEPS; j++)
        stage(b, j);
    for (int p = 0; p < PAIR; p++)
        go_on(&b[p], &m[p]);
    start(b);
    look_aside(b, m);
    for (int p = 0; p < PAIR; p++)
        take_note(&b[p], &m[p]);
}

/* ---- lanes --------------------------------------------------------------- */

static void take(struct bundle *b, int l, const struct layer_job *job,
                 struct layer *out)
{
    double least[2];

    landing_start(&b->at[l], b->curve, job->z, &job->options, out, least);
    for (int i = 0; i < LAYER_DIM; i++)
        b->u[i][l] = b->at[l].u[i];
    b->h[l] = TOL_NEARBY;
    b->tol[l] = job->options.rtol;
    b->least[0][l] = least[0];
    b->least[1][l] = least[1];
    b->previous[l] = b->fresh[l] = 1.0;
    b->last[l] = 0.0;
    b->spread[l] = b->aside[0][l] = b->aside[1][l] = 0.0;
    b->busy[l] = b->asks[l] = true;
}

/* Whether lane l is done with its state. */
static bool is_over(struct bundle *b, int l)
{
    struct landing *const at = &b->at[l];
    double most;

    if (!(b->fresh[l] > 0.0)) /* refused, and it can be no shorter */
        return true;
    of_lane(b->u, l, at->u);
    of_lane(b->k[0], l, at->du);
    if (at->options.peaks && at->out->steps == 0)
        layer_peaks_start(at);
    if (landing_is_over(at, &most) || at->out->steps >= TOL_LAYER_STEPS)
        return true;
    b->most[l] = most;
    return false;
}

/* Asks every lane of a bundle that moved; done ones, and idle ones, whose
 * numbers mean nothing, take the next of the jobs and *again is true.  Returns
 * how many are busy. */
static int refill(struct bundle *b, const struct layer_job job[], size_t n,
                  size_t *next, struct layer out[], bool *again)
{
    int busy = 0;

    for (int l = 0; l < LANES; l++) {
        if (!b->busy[l] || (b->asks[l] && is_over(b, l))) {
            b->busy[l] = *next < n;
            if (*next < n) {
                take(b, l, &job[*next], &out[*next]);
                ++*next;
                *again = true;
            }
        } else {
            b->asks[l] = false;
        }
        busy += b->busy[l];
    }
    return busy;
}

/* And those again, until none is done. */
static int refill_all(struct bundle b[], const struct layer_job job[], size_t n,
                      size_t *next, struct layer out[])
{
    int busy = 0;

    for (bool again = true; again;) {
        busy = 0;
        again = false;
        for (int p = 0; p < PAIR; p++)
            busy += refill(&b[p], job, n, next, out, &again);
        if (again)
            start(b);
    }
    return busy;
}

void LAYER_LANES(const struct slow_curve *c, const struct layer_job job[],
                 size_t n, struct layer out[])
{
    struct bundle b[PAIR];
    struct landing_step taken[PAIR * LANES][TOL_LAYER_STEPS];
    size_t next = 0;

    memset(b, 0, sizeof b);
    for (int l = 0; l < PAIR * LANES; l++) {
        b[l / LANES].curve = c;
        b[l / LANES].at[l % LANES].step = taken[l];
    }
    while (refill_all(b, job, n, &next, out) > 0)
        step(b);
}
