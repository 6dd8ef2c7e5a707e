/* From the end of the walk back.  A unit across its orbit, to the left, makes
 * t of the rest of time; before a step it makes t_gain + left t of it.  With e
 * what the step misses, its bound in explicit8's estimates,
 *
 *     |error of time| <= sum |e_time + t e_across| + blur |e_across|
 *                        + |t| digits,
 *
 * where both may cancel: an orbit that is late where it lands, having come
 * further along the curve, is not late.  blur is what is not known of t. */
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
        const double time = m->time + t.value * m->across;
        const double slip = m->slip + x.value * m->across;
        bar.time += fabs(time) + t.blur * a + fabs(t.value) * m->digits;
        bar.slip += fabs(slip) + x.blur * a + fabs(x.value) * m->digits;
        bar.more += fabs(slip - v * time) + more * a +
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
