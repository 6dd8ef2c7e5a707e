/* From the end of the walk back.  A unit across its orbit, to the left, makes
 * t of the rest of time; before a step it makes t_gain + left t of it.  With e
 * what the step misses,
 *
 *     |error of time| <= sum max (|e_time + t e_across| + blur |e_across|)
 *                             + |t| digits,
 *
 * where both may cancel: an orbit that is late where it lands, having come
 * further along the curve, is not late.  blur is what is not known of t; the
 * largest is that of several estimates of e, for each of them may point another
 * way, or vanish.  Both of order 6 may be small by chance, or because terms do
 * not fall: of a step that makes more of a sum than all others together, as at
 * a corner, two halves tell as well. */
#include "landing_weigh.h"

#include <float.h>
#include <math.h>

#include "landing_halves.h"
#include "slow_tolerance.h"

/* What a unit across makes of all to come, and how well that is known. */
struct weight {
    double value, blur;
};

/* From the end of a step to its start: the means over it of what both ends say
 * are known to a part of what they change. */
static void weight_before(struct weight *w, double left, double gain)
{
    const double change = fabs(gain) + fabs((1.0 - left) * w->value);

    w->value = gain + left * w->value;
    w->blur = left * w->blur + TOL_LAYER_BLUR * change;
}

/* fmax and fmin of numbers alone, without a call. */
static inline double larger(double a, double b)
{
    return a > b ? a : b;
}

static inline double smaller(double a, double b)
{
    return a < b ? a : b;
}

/* The cube of the ratio in which terms fall, by one of order 7: one of order 6
 * that vanishes says nothing where those from order 4 on are large. */
static inline double cube_of(double seventh, double sixth, double fourth)
{
    const double r = seventh / sixth;

    return smaller(r * r * r, seventh / fourth);
}

double landing_missed(const double size[LANDING_TERMS], double apart)
{
    const double sixth = larger(larger(size[0], size[1]), DBL_MIN);
    const double fourth = larger(size[LANDING_FOURTH], DBL_MIN);
    const double square = TOL_LAYER_FOURTH * sixth / fourth;
    const double next =
        larger(cube_of(size[2], sixth, fourth), cube_of(apart, sixth, fourth));

    return TOL_LAYER_MISSED *
           smaller(larger(square * sqrt(square), next), TOL_LAYER_FALL);
}

/* Of one number: what a unit across makes of all of it to come, what steps and
 * rounding have made of it so far, and the largest of what one step missed. */
struct sum {
    struct weight w;
    double bar, most;
    const struct landing_step *step;
    struct weight at_step;
};

/* What step m misses of one thing and of what the sum's weight makes of
 * another, by the terms of both. */
static inline void add_step(struct sum *s, const struct landing_step *m,
                            const double of[])
{
    const double t = s->w.value, *across = m->across;
    const double apart =
        fabs(of[0] - of[1]) + fabs(t * (across[0] - across[1]));
    double size[LANDING_TERMS], most = 0.0;

    for (int n = 0; n < LANDING_TERMS; n++)
        size[n] = fabs(of[n]) + fabs(t * across[n]);
    for (int n = 0; n < EXPLICIT8_TERMS; n++)
        most = larger(most, fabs(of[n] + t * across[n]) +
                                s->w.blur * fabs(across[n]));
    const double missed = landing_missed(size, apart) * most;
    if (missed > s->most) {
        s->most = missed;
        s->step = m;
        s->at_step = s->w;
    }
    s->bar += missed + fabs(t) * m->digits;
}

/* Of a number: so much of time and of slip. */
struct parts {
    double time, slip;
};

/* By halves of that step; *halved: the step of *e, mostly the same one. */
static void weigh_halves(struct sum *s, const struct landing *l, struct parts p,
                         const struct landing_step **halved,
                         struct landing_halves *e)
{
    if (!(2.0 * s->most > s->bar))
        return;
    if (*halved != s->step)
        *e = landing_halve(l->curve->slider, s->step->from, s->step->h);
    *halved = s->step;
    const double off = p.time * e->time + p.slip * e->slip;
    const double missed =
        TOL_BAR_FIRST_ORDER * (fabs(off + s->at_step.value * e->across) +
                               s->at_step.blur * fabs(e->across));

    s->bar += larger(missed - s->most, 0.0);
}

struct landing_bar landing_weigh(const struct landing *l,
                                 const struct landing_slope *across, double v)
{
    struct sum time = { .w = { across->time, 0.0 }, .bar = l->time_error };
    struct sum slip = { .w = { across->slip, 0.0 }, .bar = l->slip_error };
    struct sum more = { .bar = l->slip_error + v * l->time_error };
    const struct landing_step *halved = NULL;
    struct landing_halves e = { 0 };

    for (size_t k = l->out->steps; k-- > 0;) {
        const struct landing_step *m = &l->step[k];
        double late[LANDING_TERMS];
        for (int j = 0; j < LANDING_TERMS; j++)
            late[j] = m->slip[j] - v * m->time[j];
        more.w.value = slip.w.value - v * time.w.value;
        more.w.blur = slip.w.blur + v * time.w.blur;
        add_step(&time, m, m->time);
        add_step(&slip, m, m->slip);
        add_step(&more, m, late);
        weight_before(&time.w, m->left, m->time_gain);
        weight_before(&slip.w, m->left, m->slip_gain);
    }
    weigh_halves(&time, l, (struct parts){ 1.0, 0.0 }, &halved, &e);
    weigh_halves(&slip, l, (struct parts){ 0.0, 1.0 }, &halved, &e);
    weigh_halves(&more, l, (struct parts){ -v, 1.0 }, &halved, &e);
    const double t = time.w.value, x = slip.w.value;
    return (struct landing_bar){
        time.bar + fabs(t) * l->start + l->start_time,
        slip.bar + fabs(x) * l->start + l->start_slip,
        more.bar + fabs(x - v * t) * l->start +
            fabs(l->start_slip - v * l->start_time),
    };
}
