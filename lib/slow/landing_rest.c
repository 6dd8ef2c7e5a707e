/* As onto the slow curve, x and y in each other's place.  psi settles by a sinh
 * of psi_ss - psi: linear rates hold for changes of psi up to one, which are
 * changes of ln psi up to v, about what the curve moves while psi settles. */
#include "landing_rest.h"

#include <math.h>

#include "landing_weigh.h"
#include "slider.h"
#include "slow_tolerance.h"

/* The point of the curve on the fibre through the end of the walk; *off: how
 * far along it, signed. */
static bool project(const struct landing *l, struct rest_point *p, double *off)
{
    const struct rest_curve *c = &l->curve->rest;
    double x = l->u[LAYER_X];

    for (int i = 0; i < 3; i++) {
        if (!rest_curve_at(c, x, p))
            return false;
        const double dx = l->u[LAYER_X] - x, dy = l->u[LAYER_Y] - p->y;
        const struct vec2 e = p->fibre;
        const double det = e.y - e.x * p->y_slope;
        *off = (dy - dx * p->y_slope) / det;
        x = l->u[LAYER_X] - *off * e.x;
    }
    return true;
}

/* What part of the way off the curve may be bent.  Behind it a sinh is faster
 * than its tangent all the way; ahead of it psi may wait, its own rate of next
 * to nothing, until the curve comes: `off` over the curve's speed. */
static double bent_part(const struct landing *l, const struct rest_point *p,
                        double off)
{
    const double moves = fabs(p->y_slope / (p->time_slope * p->fast));
    const double part = fabs(off) / moves + p->gap;
    const bool may_wait =
        l->curve->slider->block.waits && off * p->fibre.y * p->y_slope < 0.0;

    return may_wait ? part : fmin(part, 1.0);
}

/* What the table says of p, `off` away along its fibre, added to what was
 * before.  False: nearer to the curve it would be good enough. */
static bool land(struct landing *l, const struct rest_point *p, double off,
                 double *excess)
{
    const struct vec2 e = p->fibre;
    const double det = fabs(e.y - e.x * p->y_slope);
    const double bend =
        TOL_LAYER_BEND * fabs(off * e.x) * bent_part(l, p, off) / det;
    const double time = l->u[LAYER_TIME] + p->time;
    const double slip = l->u[LAYER_SLIP] + p->slip;
    const double late = 2.0 * fabs(p->time_slope), far = 2.0 * p->slip_slope;
    const double on = -(e.x * l->du[LAYER_X] + e.y * l->du[LAYER_Y]) /
                      (e.y - e.x * p->y_slope);
    const struct landing_slope across = { p->time_slope * on,
                                          p->slip_slope * on };
    const struct landing_bar bar = landing_weigh(l, &across, 0.0);
    struct layer *const out = l->out;

    *excess =
        bend * fmax(late / time, far / slip) / (TOL_SHARE * l->options.promise);
    if (*excess > 1.0 && fabs(off) > TOL_ROOT)
        return false;
    out->end = LAYER_LANDED;
    out->fate = FATE_REST_FINITE;
    out->x_end = -HUGE_VAL;
    out->time = time;
    out->slip = slip;
    out->time_error = bar.time + p->time_error + late * bend;
    out->slip_error = bar.slip + p->slip_error + far * bend;
    return true;
}

bool landing_rests(struct landing *l, double *most)
{
    double y, y_slope, off, excess = 1.0, aim = l->options.landing;
    struct rest_point p;

    if (!rest_curve_beside(&l->curve->rest, l->u[LAYER_X], &y, &y_slope))
        return false;
    const double d = l->u[LAYER_Y] - y;
    if (fabs(d) < aim && !(l->du[LAYER_X] > 0.0)) {
        if (project(l, &p, &off) && land(l, &p, off, &excess))
            return true;
        aim = fabs(d) *
              fmin(TOL_SHARE, fmax(1.0 / TOL_RETRY, TOL_SHARE / excess));
    }
    const double closing = l->du[LAYER_Y] - y_slope * l->du[LAYER_X];
    if (d * closing < 0.0)
        *most = fmin(*most, (fabs(d) - TOL_AIM * aim) / fabs(closing));
    return false;
}
