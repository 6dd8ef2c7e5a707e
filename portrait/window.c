/* exp(c) is written relative to exp(hi), so that it does not overflow. */
#include "window.h"

#include <math.h>

enum status window_check(const struct window *w, const struct planar *system)
{
    const struct box b = w->box;
    const bool good = b.lo.x < b.hi.x && b.lo.y < b.hi.y &&
                      box_holds(system->domain, b.lo) &&
                      box_holds(system->domain, b.hi);

    return good ? STATUS_OK : STATUS_BAD_ARGUMENT;
}

/* (e^c - e^lo)/(e^hi - e^lo) */
static double unit_of(bool exponential, double lo, double hi, double c)
{
    if (!exponential)
        return (c - lo) / (hi - lo);
    return exp(c - hi) * expm1(lo - c) / expm1(lo - hi);
}

static double coordinate_at(bool exponential, double lo, double hi, double u)
{
    if (!exponential || u == 0.0 || u == 1.0)
        return (1.0 - u) * lo + u * hi;
    return hi + log(exp(lo - hi) - u * expm1(lo - hi));
}

/* du/dc */
static double stretch(bool exponential, double lo, double hi, double c)
{
    return exponential ? -exp(c - hi) / expm1(lo - hi) : 1.0 / (hi - lo);
}

struct vec2 window_unit(const struct window *w, struct vec2 z)
{
    const struct box b = w->box;

    return (struct vec2){ unit_of(w->exponential[0], b.lo.x, b.hi.x, z.x),
                          unit_of(w->exponential[1], b.lo.y, b.hi.y, z.y) };
}

struct vec2 window_at(const struct window *w, struct vec2 unit)
{
    const struct box b = w->box;

    return (struct vec2){
        coordinate_at(w->exponential[0], b.lo.x, b.hi.x, unit.x),
        coordinate_at(w->exponential[1], b.lo.y, b.hi.y, unit.y)
    };
}

struct vec2 window_push(const struct window *w, struct vec2 z,
                        struct vec2 direction)
{
    const struct box b = w->box;

    return (struct vec2){
        direction.x * stretch(w->exponential[0], b.lo.x, b.hi.x, z.x),
        direction.y * stretch(w->exponential[1], b.lo.y, b.hi.y, z.y)
    };
}

struct box window_enlarged(const struct window *w, const struct planar *system,
                           double fraction)
{
    const struct box b = w->box, d = system->domain;
    const struct vec2 more = vec2_scale(fraction, vec2_sub(b.hi, b.lo));
    const struct vec2 lo = vec2_sub(b.lo, more), hi = vec2_add(b.hi, more);

    return (struct box){ { fmax(lo.x, d.lo.x), fmax(lo.y, d.lo.y) },
                         { fmin(hi.x, d.hi.x), fmin(hi.y, d.hi.y) } };
}
