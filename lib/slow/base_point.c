/* With T(y) and X(y) the table's time and slip, T' < 0 say, a state that lands
 * at y1 after a time t and a slip x has T(y) = t + T(y1), and beyond X(y) the
 * slip x + X(y1) - X(y): what is wrong with y1 cancels in it, for X' = v T'. */
#include "base_point.h"

#include <math.h>

#include "slider.h"
#include "slow_tolerance.h"

static const struct base_point none = { (double) NAN, (double) NAN,
                                        (double) NAN, (double) NAN, 1.0 };

/* Of a state that comes to rest without landing on it: the same by its time
 * alone. */
static struct base_point of_rest(const struct slow_curve *c,
                                 const struct layer *l)
{
    struct slow_point p;

    for (size_t i = 0; i < c->branches; i++) {
        const struct slow_branch *b = &c->branch[i];
        const double y = b->fate == FATE_REST_FINITE
                             ? slow_point_when(b, l->time)
                             : (double) NAN;
        if (isnan(y) || !slow_curve_anywhere(c, y, &p))
            continue;
        const double v = p.slip_slope / p.time_slope;
        return (struct base_point){ y, l->time_error / fabs(p.time_slope),
                                    l->slip - p.slip,
                                    l->slip_error + v * l->time_error, 1.0 };
    }
    return none;
}

/* Orbits that meet a node's box have their base points this near it then. */
static double reach_of(const struct slow_branch *inside)
{
    const struct slow_knot *k = &inside->knot[inside->count - 1];
    const struct vec2 e = k->fibre;
    const double det = fabs(e.x - e.y * k->x_slope);

    return TOL_AS_BEFORE * TOL_ARREST * (fabs(e.x) + fabs(e.y)) / det;
}

/* A state that falls from y to y1 may meet a box that y is not near. */
static double late_of(const struct slow_curve *c, double y, double y1)
{
    double late = 1.0;

    for (size_t i = 0; i < c->branches; i++) {
        const struct slow_branch *in = &c->inside[i];
        if (in->count < 3)
            continue;
        const double reach = reach_of(in), far = fabs(y - in->centre);
        if (far > reach)
            late = fmax(late, far / fmax(fabs(y1 - in->centre), reach));
    }
    return late;
}

struct base_point base_point_of(const struct slow_curve *c,
                                const struct layer *l)
{
    struct slow_point landed, p;

    if (l->is_near)
        return (struct base_point){ l->y, l->y_error, l->more,
                                    l->way_slip_error, 1.0 };
    if (l->end == LAYER_RESTED || (l->end == LAYER_LANDED && isnan(l->y)))
        return l->fate == FATE_REST_FINITE ? of_rest(c, l) : none;
    if (l->end == LAYER_RAN || l->end == LAYER_LOST || isnan(l->y) ||
        !slow_curve_anywhere(c, l->y, &landed))
        return none;
    const double y = slow_curve_when(c, l->y, l->time);
    if (isnan(y) || !slow_curve_anywhere(c, y, &p))
        return none;
    const double v1 = landed.slip_slope / landed.time_slope;
    const double v = p.slip_slope / p.time_slope;
    return (struct base_point){
        .y = y,
        .y_error = l->way_time_error / fabs(p.time_slope),
        .more = l->slip - p.slip,
        .more_error = l->way_slip_error + fabs(v1 - v) * l->way_time_error,
        .late = late_of(c, y, l->y),
    };
}

/* ---- boxes --------------------------------------------------------------- */

static bool passes(const struct slow_curve *c, double one, double other,
                   double late)
{
    const double lo = fmin(one, other), hi = fmax(one, other);

    for (size_t i = 0; i < c->branches; i++) {
        const struct slow_branch *in = &c->inside[i];
        if (in->count < 3)
            continue;
        const double reach = fmax(late, 1.0) * reach_of(in);
        if (hi > in->centre - reach && lo < in->centre + reach)
            return true;
    }
    return false;
}

bool base_point_passes(const struct slow_curve *c, double one, double other)
{
    return passes(c, one, other, 1.0);
}

/* ---- telling ------------------------------------------------------------- */

bool base_point_tell(const struct slow_curve *c, const struct base_point *b,
                     struct layer *out)
{
    const double room = TOL_LAYER_CORNER * b->y_error;
    struct slow_point p;

    *out = (struct layer){ .end = LAYER_LOST, .fate = FATE_UNDECIDED };
    if (!slow_curve_anywhere(c, b->y, &p))
        return false;
    out->end = p.fate == FATE_RUNAWAY ? LAYER_RAN : LAYER_LANDED;
    out->fate = p.fate;
    out->x_end = p.x_end;
    out->x_end_error = p.x_end_error;
    out->time = p.time;
    out->slip = p.slip + b->more;
    out->time_error =
        TOL_AS_BEFORE * fabs(p.time_slope) * b->y_error + p.time_error;
    out->slip_error = TOL_AS_BEFORE * fabs(p.slip_slope) * b->y_error +
                      b->more_error + p.slip_error;
    return (slider_saddle(c->slider) < 0 || room < fabs(b->y)) &&
           !passes(c, b->y - room, b->y + room, TOL_AS_BEFORE * b->late);
}
