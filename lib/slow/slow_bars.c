/* What is off along the orbit only comes earlier or later. */
#include "slow_bars.h"

#include <math.h>

#include "tolerance.h"

/* Along y, where a function with that gradient has its value; rates are the
 * knot's, for the field's own may be all rounding. */
static double late_at(const struct orbit *o, const struct slow_knot *k,
                      struct vec2 gradient)
{
    const double *e = o->options.drift->e;

    return (gradient.x * e[0] + gradient.y * e[1]) /
           (gradient.x * k->x_slope + gradient.y);
}

double slow_bars_beside(const struct orbit *o, const struct slow_knot *k,
                        struct vec2 gradient)
{
    return o->options.drift->e[0] - k->x_slope * late_at(o, k, gradient);
}

/* What it makes of time and slip. */
static struct slow_off off_at(const struct orbit *o, const struct slow_knot *k,
                              struct vec2 gradient)
{
    const double late = late_at(o, k, gradient);

    return (struct slow_off){ k->time[1] * late, k->slip[1] * late };
}

/* y, of which all is told. */
static const struct vec2 along = { 0.0, 1.0 };

void slow_bars_note(const struct orbit *o, struct slow_knot *k,
                    struct slow_off *was)
{
    const struct slow_off gained =
        slow_off_gained(o->options.drift, off_at(o, k, along), was);

    k->time_bar = gained.time;
    k->slip_bar = gained.slip;
    k->beside = slow_bars_beside(o, k, along);
}

/* Of the end at the face of a box of arrest, beside that at its y. */
static struct slow_off at_end(const struct orbit *o,
                              const struct slow_branch *b)
{
    const struct slow_knot *k = &b->knot[b->count - 1];

    if (o->end != ORBIT_ARRIVED)
        return (struct slow_off){ 0.0, 0.0 };
    const struct vec2 face = fate_face((struct vec2){ o->u[0], o->u[1] },
                                       o->options.target[o->end_index]);
    const struct slow_off there = off_at(o, k, face),
                          here = off_at(o, k, along);
    return (struct slow_off){ there.time - here.time, there.slip - here.slip };
}

void slow_bars_add(const struct orbit *o, struct slow_branch *b)
{
    const bool from_first = b->start == SLOW_FACE;
    struct slow_sum sum = { .off = { 0.0, 0.0 } };

    if (!from_first)
        sum.off = at_end(o, b);
    for (size_t i = 0; i < b->count; i++) {
        struct slow_knot *const k = &b->knot[from_first ? i : b->count - 1 - i];
        const struct slow_off gain = { k->time_bar, k->slip_bar };
        const double beside = slow_knot_shift(k, k->beside);
        if (from_first)
            slow_sum_add(&sum, gain);
        const struct slow_off bar = slow_sum_bar(&sum);
        k->time_bar =
            bar.time + TOL_BAR_FIRST_ORDER * fabs(k->time[1]) * beside;
        k->slip_bar =
            bar.slip + TOL_BAR_FIRST_ORDER * fabs(k->slip[1]) * beside;
        if (!from_first)
            slow_sum_add(&sum, gain);
    }
}
