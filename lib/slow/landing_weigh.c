/* From the end of the walk back.  A unit across its orbit, to the left, makes
 * t of the rest of time; before a step it makes t_gain + left t of it.  With e
 * what the step misses, its bound in explicit8's estimates,
 *
 *     |error of time| <= sum f (|e_time + t e_across| + blur |e_across|
 *                             + turn |t| |e|) + |t| digits,
 *
 * where both may cancel: an orbit that is late where it lands, having come
 * further along the curve, is not late.  blur is what is not known of t, turn
 * |e| of e_across: what a step misses does not point where its estimates do,
 * and these may lie along the orbit.  They may vanish as well; f >= 1 lets a
 * step miss no less of them than its neighbours do, each for its length. */
#include "landing_weigh.h"

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

/* f. */
static double outdone(const struct landing *l, size_t k)
{
    const struct landing_step *const m = &l->step[k];
    double most = m->part;

    for (size_t i = k > 0 ? k - 1 : 0; i <= k + 1 && i < l->out->steps; i++) {
        const struct landing_step *const n = &l->step[i];
        const double ratio = m->length / n->length;
        const double part = n->part * ratio * ratio * ratio;
        if (n->size > n->part * n->digits) /* more than rounding */
            most = fmax(most, fmin(part, TOL_LAYER_MISSED_MOST));
    }
    return m->part > 0.0 ? most / m->part : 1.0;
}

/* From the end back: what each step missed shifts the end by what it is itself
 * and by how far it lies across then, times what that makes of all to come.
 * Both may cancel, but for what is not known of the latter. */
struct landing_bar landing_weigh(const struct landing *l,
                                 const struct landing_slope *across, double v)
{
    struct weight t = { across->time, 0.0 }, x = { across->slip, 0.0 };
    struct landing_bar bar = { l->time_error, l->slip_error,
                               l->slip_error + v * l->time_error };

    for (size_t k = l->out->steps; k-- > 0;) {
        const struct landing_step *m = &l->step[k];
        const double a = fabs(m->across), more = x.blur + v * t.blur;
        const double turn = TOL_LAYER_TURN * m->size, f = outdone(l, k);
        const double time = m->time + t.value * m->across;
        const double slip = m->slip + x.value * m->across;
        bar.time += f * (fabs(time) + t.blur * a + turn * fabs(t.value)) +
                    fabs(t.value) * m->digits;
        bar.slip += f * (fabs(slip) + x.blur * a + turn * fabs(x.value)) +
                    fabs(x.value) * m->digits;
        bar.more += f * (fabs(slip - v * time) + more * a +
                         turn * fabs(x.value - v * t.value)) +
                    fabs(x.value - v * t.value) * m->digits;
        weight_before(&t, m->left, m->time_gain);
        weight_before(&x, m->left, m->slip_gain);
    }
    bar.time += fabs(t.value) * l->start + l->start_time;
    bar.slip += fabs(x.value) * l->start + l->start_slip;
    bar.more += fabs(x.value - v * t.value) * l->start +
                fabs(l->start_slip - v * l->start_time);
    return bar;
}
