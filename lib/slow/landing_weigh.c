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
 * way, or vanish. */
#include "landing_weigh.h"

#include <float.h>
#include <math.h>

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

/* What a step misses of one thing and of what t makes of another, by the terms
 * of both. */
static inline double missed_of(const double of[], const double across[],
                               const struct weight *t)
{
    const double apart =
        fabs(of[0] - of[1]) + fabs(t->value * (across[0] - across[1]));
    double size[LANDING_TERMS], most = 0.0;

    for (int n = 0; n < LANDING_TERMS; n++)
        size[n] = fabs(of[n]) + fabs(t->value * across[n]);
    for (int n = 0; n < EXPLICIT8_TERMS; n++)
        most = larger(most, fabs(of[n] + t->value * across[n]) +
                                t->blur * fabs(across[n]));
    return landing_missed(size, apart) * most;
}

struct landing_bar landing_weigh(const struct landing *l,
                                 const struct landing_slope *across, double v)
{
    struct weight t = { across->time, 0.0 }, x = { across->slip, 0.0 };
    struct landing_bar bar = { l->time_error, l->slip_error,
                               l->slip_error + v * l->time_error };

    for (size_t k = l->out->steps; k-- > 0;) {
        const struct landing_step *m = &l->step[k];
        const struct weight more = { x.value - v * t.value,
                                     x.blur + v * t.blur };
        double late[LANDING_TERMS];
        for (int j = 0; j < LANDING_TERMS; j++)
            late[j] = m->slip[j] - v * m->time[j];
        bar.time +=
            missed_of(m->time, m->across, &t) + fabs(t.value) * m->digits;
        bar.slip +=
            missed_of(m->slip, m->across, &x) + fabs(x.value) * m->digits;
        bar.more +=
            missed_of(late, m->across, &more) + fabs(more.value) * m->digits;
        weight_before(&t, m->left, m->time_gain);
        weight_before(&x, m->left, m->slip_gain);
    }
    bar.time += fabs(t.value) * l->start + l->start_time;
    bar.slip += fabs(x.value) * l->start + l->start_slip;
    bar.more += fabs(x.value - v * t.value) * l->start +
                fabs(l->start_slip - v * l->start_time);
    return bar;
}
