#include "near_cut.h"

#include <math.h>

#include "tolerance.h"

bool near_cut_is_due(const struct orbit *o)
{
    const struct curve *c = &o->curve;
    double from[CURVE_DIM_MAX];

    if (c->count == 0)
        return false;
    curve_at(c, c->count - 1, 0.0, from);
    const double before = hypot(from[0], from[1]);
    const double now = hypot(o->u[0], o->u[1]);
    return (before < TOL_DRIFT_NEAR && now > before) ||
           !(c->piece[c->count - 1].across < TOL_ARREST * now);
}

void near_cut_back(struct orbit *o)
{
    struct curve *c = &o->curve;
    struct event_log *log = &o->log;

    curve_at(c, c->count - 1, 0.0, o->u);
    c->count--;
    while (log->count > 0 && log->hit[log->count - 1].piece == c->count)
        log->count--;
}
