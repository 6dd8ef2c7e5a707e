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
    curve_at(&o->curve, o->curve.count - 1, 0.0, o->u);
    event_drop(&o->log, &o->curve);
}
