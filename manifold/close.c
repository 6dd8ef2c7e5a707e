/*
 * Gauss-Laguerre quadrature of the slope from z to infinity, scaled by the
 * slope's own rate of decay kappa: with u = kappa |ind - ind_z| the integrand
 * is e^-u times something smooth.  dep moves by the first-order approach
 * g0/kappa (1 - e^-u) meanwhile (one Picard iterate).  Error: the four-point
 * rule's difference, and what the slope makes of an approach that is off by as
 * much as the quadrature is from g0/kappa.  Nodes and weights: Abramowitz &
 * Stegun 25.4.45, here to 17 digits, weights times e^node.
 */
#include "close.h"

#include <math.h>

enum { FINE = 8, COARSE = 4 };

static const double fine_node[FINE] = {
    0.170279632305101,  0.90370177679937991, 2.2510866298661307,
    4.2667001702876588, 7.0459054023934657,  10.758516010180995,
    15.740678641278005, 22.863131736889264
};
static const double fine_weight[FINE] = {
    0.43772341049291137, 1.0338693476655976, 1.6697097656587757,
    2.3769247017585995,  3.2085409133479263, 4.2685755108251322,
    5.8180833686719219,  8.9062262152922114
};
static const double coarse_node[COARSE] = { 0.32254768961939231,
                                            1.7457611011583466,
                                            4.536620296921128,
                                            9.3950709123011331 };
static const double coarse_weight[COARSE] = { 0.83273912383788925,
                                              2.0481024384542968,
                                              3.6311463058215179,
                                              6.4871450844076623 };

struct tail_point {
    double unknown;                   /* d dep/du0, u0 = |ind - ind_z| */
    double integral[LOCAL_CARRY_MAX]; /* d integral/du0 */
};

static void rates_at(const struct planar *sys, int ind, int toward,
                     struct vec2 z, const struct carry *carry,
                     struct tail_point *p)
{
    struct planar_field f;
    double rate = 1.0;

    sys->field(sys->ctx, z, &f);
    const double along = ind == 0 ? f.direction.x : f.direction.y;
    const double across = ind == 0 ? f.direction.y : f.direction.x;
    p->unknown = toward * across / along;
    for (size_t i = 0; i < carry->count; i++) {
        if (carry->which[i] != CARRY_TIME)
            sys->rate_gradient(sys->ctx, (size_t) carry->which[i], z, &rate,
                               NULL);
        else
            rate = 1.0;
        p->integral[i] = toward * rate * exp(-f.log_scale) / along;
    }
}

struct approach {
    const struct planar *sys;
    const struct carry *carry;
    int ind, toward;
    struct vec2 z;
    double first; /* slope at z, per u0 */
    double kappa;
};

static void point_at(const struct approach *a, double u, struct tail_point *p)
{
    const double moved = -a->first / a->kappa * expm1(-u);
    const double ind =
        (a->ind == 0 ? a->z.x : a->z.y) + a->toward * u / a->kappa;
    const double dep = (a->ind == 0 ? a->z.y : a->z.x) + moved;

    rates_at(a->sys, a->ind, a->toward, local_point(a->ind, ind, dep), a->carry,
             p);
}

static void quadrature(const struct approach *a, size_t n, const double node[],
                       const double weight[], struct tail_point *sum)
{
    *sum = (struct tail_point){ 0 };
    for (size_t k = 0; k < n; k++) {
        struct tail_point p;
        point_at(a, node[k], &p);
        sum->unknown += weight[k] * p.unknown / a->kappa;
        for (size_t i = 0; i < a->carry->count; i++)
            sum->integral[i] += weight[k] * p.integral[i] / a->kappa;
    }
}

/* The relative rate of decay of the slope at z; not positive: no decay. */
static double decay_rate(const struct planar *sys, int ind, int toward,
                         struct vec2 z)
{
    const double du = 1e-3;
    const struct vec2 next = ind == 0 ? (struct vec2){ z.x + toward * du, z.y }
                                      : (struct vec2){ z.x, z.y + toward * du };
    const double here = local_slope(sys, ind, z);
    const double there = local_slope(sys, ind, next);

    if (here == 0.0) /* decayed below the smallest double */
        return HUGE_VAL;
    return -log(there / here) / du;
}

/* |d slope/d dep| at z */
static double stiffness(const struct planar *sys, int ind, struct vec2 z)
{
    struct planar_jacobian J;

    sys->jacobian(sys->ctx, z, &J);
    const struct vec2 f = J.field.direction;
    return ind == 0 ? fabs((J.matrix.yy - f.y / f.x * J.matrix.xy) / f.x)
                    : fabs((J.matrix.xx - f.x / f.y * J.matrix.yx) / f.y);
}

bool close_tail(const struct planar *sys, int ind, int toward, struct vec2 z,
                const struct carry *carry, struct tail *t)
{
    struct approach a = {
        .sys = sys, .carry = carry, .ind = ind, .toward = toward, .z = z
    };
    struct tail_point fine, coarse;

    *t = (struct tail){ 0 };
    a.kappa = decay_rate(sys, ind, toward, z);
    a.first = toward * local_slope(sys, ind, z);
    if (a.kappa == HUGE_VAL)
        return true;
    if (!(a.kappa > 0.2))
        return false;
    quadrature(&a, FINE, fine_node, fine_weight, &fine);
    quadrature(&a, COARSE, coarse_node, coarse_weight, &coarse);
    t->unknown = fine.unknown;
    const double off = fabs(fine.unknown - a.first / a.kappa);
    const double part = off * stiffness(sys, ind, z) / a.kappa;
    t->unknown_error = fabs(fine.unknown - coarse.unknown) + part;
    for (size_t i = 0; i < carry->count; i++) {
        t->integral[i] = fine.integral[i];
        t->integral_error[i] = fabs(fine.integral[i] - coarse.integral[i]);
    }
    return isfinite(t->unknown);
}
