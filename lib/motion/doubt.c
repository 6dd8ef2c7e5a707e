/* What the state's error does to the function is looked up in the corners of
 * its box, which takes rounding with it.  The ends of the stretch are found by
 * doubling: each is at most twice as far as it is. */
#include "doubt.h"

#include <float.h>
#include <math.h>

#include "moment.h"
#include "motion_tolerance.h"
#include "slider.h"

/* A curve, by piece + theta, and what is watched along it. */
struct watched {
    const struct slider *slider;
    const struct event *event;
    const struct curve *curve;
    double s;
};

static double value_at(const struct watched *w, const double u[])
{
    return w->event->value(w->event->ctx, w->s, u) - w->event->level;
}

static void state_at(const struct watched *w, double at, double u[])
{
    const double last = (double) w->curve->count - 1.0;
    const double piece = fmin(floor(at), last);

    curve_at(w->curve, (size_t) piece, at - piece, u);
}

/* The largest change of the function in the box of half width `off`. */
static double change_within(const struct watched *w,
                            const struct event_hit *hit, double off)
{
    const double here = value_at(w, hit->u);
    double u[CURVE_DIM_MAX], most = 0.0;

    for (size_t i = 0; i < w->curve->dim; i++)
        u[i] = hit->u[i];
    for (int corner = 0; corner < 4; corner++) {
        u[0] = hit->u[0] + (corner & 1 ? off : -off);
        u[1] = hit->u[1] + (corner & 2 ? off : -off);
        most = fmax(most, fabs(value_at(w, u) - here));
    }
    return most;
}

/* The nearest state to one side, at distances that double, where the function
 * is larger than `allowed`; the end of the curve where it is not. */
static void leave(const struct watched *w, double at, int side, double allowed,
                  double u[])
{
    const double end = side > 0 ? (double) w->curve->count : 0.0;
    double far = TOL_ROUNDINGS_FEW * DBL_EPSILON;

    do {
        const double next = at + side * far;
        const bool ended = side > 0 ? next >= end : next <= end;
        state_at(w, ended ? end : next, u);
        if (ended)
            return;
        far *= 2.0;
    } while (!(fabs(value_at(w, u)) > allowed));
}

static void widen(struct doubt *d, const struct slider *s, const double here[],
                  const double there[])
{
    const struct vec2 z = { here[0], here[1] }, to = { there[0], there[1] };

    d->x = fmax(d->x, fabs(there[0] - here[0]));
    d->y = fmax(d->y, fabs(there[1] - here[1]));
    d->time = fmax(d->time, fabs(there[2] - here[2]));
    d->slip = fmax(d->slip, fabs(there[3] - here[3]));
    d->mu = fmax(d->mu, fabs(moment_excess_friction(s, to) -
                             moment_excess_friction(s, z)));
}

struct doubt doubt_find(const struct slider *s, const struct event *e,
                        const struct event_hit *hit, const struct curve *c,
                        double off, double level)
{
    const struct watched w = { s, e, c, hit->s };
    const double at = (double) hit->piece + hit->theta;
    const double allowed = change_within(&w, hit, off) + level;
    struct doubt d = { 0.0, 0.0, 0.0, 0.0, 0.0 };
    double u[CURVE_DIM_MAX];

    for (int side = -1; side <= 1; side += 2) {
        leave(&w, at, side, allowed, u);
        widen(&d, s, hit->u, u);
    }
    return d;
}
