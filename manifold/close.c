/*
 * Gauss-Laguerre quadrature of a rate from z to infinity, scaled by its own
 * rate of decay kappa at z: with u = kappa |ind - ind_z| the integrand is e^-u
 * times something smooth.  dep moves by the first-order approach
 * g0/kappa (1 - e^-u) meanwhile (one Picard iterate).  Error: the differences
 * of the rules of six and of four points, for one may be small by chance; up to
 * the first node, what the rate at z is off from what
 * the nodes make of it, for a kink may hide from them there; and what the slope
 * makes of an approach that is off by as much as the quadrature is from
 * g0/kappa.  How a tail goes with dep is the difference of the coarse rule and
 * that beside it.  Nodes and weights: Abramowitz & Stegun 25.4.45, here to 17
 * digits, weights times e^node.  Integrals may decay much more slowly than the
 * slope, which may be 0 in a double.
 */
#include "close.h"

#include <float.h>
#include <math.h>

#include "many.h"
#include "tolerance.h"

enum { FINE = 8, MIDDLE = 6, COARSE = 4, FIRST = 4 };

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
/* What the function p + q u + r u^2 + s e^-u through the first nodes is at 0:
 * these times its values there, times e^node. */
static const double at_0_weight[FIRST] = { 1.7451222082418316,
                                           -1.602562468991497,
                                           1.9806018321721914,
                                           -2.2289649865523482 };
static const double middle_node[MIDDLE] = {
    0.22284660417926069, 1.188932101672623,  2.9927363260593141,
    5.7751435691045105,  9.8374674183825899, 15.982873980601702
};
static const double middle_weight[MIDDLE] = {
    0.57353550742273809, 1.3692525907123045, 2.2606845933826723,
    3.3505245823554567,  4.886826800210825,  7.8490159455958214
};
static const double coarse_node[COARSE] = { 0.32254768961939231,
                                            1.7457611011583466,
                                            4.536620296921128,
                                            9.3950709123011331 };
static const double coarse_weight[COARSE] = { 0.83273912383788925,
                                              2.0481024384542968,
                                              3.6311463058215179,
                                              6.4871450844076623 };

/* Rates at a point, per unit of |ind - ind_z|. */
struct tail_point {
    double unknown;
    double integral[LOCAL_CARRY_MAX];
};

struct approach {
    const struct planar *sys;
    const struct carry *carry;
    int ind, toward;
    struct vec2 z;
    const struct tail_most *most;
    struct tail_point first, kappa; /* rates at z, and how fast they decay */
    double by_dep;                  /* d slope/d dep at z */
    double aside;                   /* of dep, where it is looked at, too */
};

/* Infinite where the rate is below the smallest double. */
static double decay_rate(double rate, double growth)
{
    return rate == 0.0 ? HUGE_VAL : -growth;
}

/* By what is seen at z with the rate of `rated`. */
static void look(struct approach *a, int rated, const struct planar_look *at)
{
    const struct planar *sys = a->sys;
    const struct mat2 m = at->J.matrix;
    const bool over_x = a->ind == 0;
    const struct vec2 f = at->J.field.direction;
    const double along = over_x ? f.x : f.y, across = over_x ? f.y : f.x;
    const double along_i = over_x ? m.xx : m.yy;
    const double along_d = over_x ? m.xy : m.yx;
    const double across_i = over_x ? m.yx : m.xy;
    const double across_d = over_x ? m.yy : m.xx;
    const double slower = along_i / along, unit = at->unit;

    a->first.unknown = a->toward * across / along;
    a->kappa.unknown =
        decay_rate(across, a->toward * (across_i / across - slower));
    a->by_dep = (across_d - across / along * along_d) / along;
    a->aside = TOL_ASIDE * fmax(1.0, fabs(over_x ? a->z.y : a->z.x));
    for (size_t i = 0; i < a->carry->count; i++) {
        const bool seen = rated >= 0;
        double rate = seen ? at->rate : 1.0;
        struct vec2 gradient = seen ? at->gradient : (struct vec2){ 0.0, 0.0 };
        if (!seen && a->carry->which[i] != CARRY_TIME)
            sys->rate_gradient(sys->ctx, (size_t) a->carry->which[i], a->z,
                               &rate, &gradient);
        const double rate_i = over_x ? gradient.x : gradient.y;
        a->first.integral[i] = a->toward * rate * unit / along;
        a->kappa.integral[i] = decay_rate(a->first.integral[i],
                                          a->toward * (rate_i / rate - slower));
    }
}

/* Where the rates at a distance beyond z are taken, or beyond what is so far
 * beside it. */
static struct vec2 place_beyond(const struct approach *a, double distance,
                                double aside)
{
    const double kappa = a->kappa.unknown;
    const double first = a->first.unknown + a->toward * a->by_dep * aside;
    const double moved = aside - first / kappa * expm1(-kappa * distance);
    const double ind = (a->ind == 0 ? a->z.x : a->z.y) + a->toward * distance;
    const double dep = (a->ind == 0 ? a->z.y : a->z.x) + moved;

    return local_point(a->ind, ind, dep);
}

/* An observable's rate at z, which was seen with that of `rated`. */
static double rate_at(const struct approach *a, size_t i, struct vec2 z,
                      int rated, const struct planar_look *seen)
{
    const struct planar *sys = a->sys;
    double rate = rated >= 0 ? seen->rate : 1.0;

    if (rated < 0 && a->carry->which[i] != CARRY_TIME)
        sys->rate_gradient(sys->ctx, (size_t) a->carry->which[i], z, &rate,
                           NULL);
    return rate;
}

/* The rates at n <= FINE points. */
static void rates_at(const struct approach *a, size_t n, const struct vec2 z[],
                     struct tail_point p[])
{
    const int rated = many_carried(a->carry);
    struct planar_look seen[FINE];

    many_along(a->sys, n, z, rated, false, seen);
    for (size_t k = 0; k < n; k++) {
        const struct planar_field *f = &seen[k].J.field;
        const double x = f->direction.x, y = f->direction.y;
        const double along = a->ind == 0 ? x : y, across = a->ind == 0 ? y : x;
        p[k].unknown = a->toward * across / along;
        for (size_t i = 0; i < a->carry->count; i++)
            p[k].integral[i] = a->toward *
                               rate_at(a, i, z[k], rated, &seen[k]) *
                               seen[k].unit / along;
    }
}

/* Weights times the first n of p, over `unit`. */
static void sum_up(const struct approach *a, size_t n, const double weight[],
                   const struct tail_point p[], double unit,
                   struct tail_point *sum)
{
    *sum = (struct tail_point){ 0 };
    for (size_t k = 0; k < n; k++) {
        sum->unknown += weight[k] * p[k].unknown / unit;
        for (size_t i = 0; i < a->carry->count; i++)
            sum->integral[i] += weight[k] * p[k].integral[i] / unit;
    }
}

/* The same tail by three rules, that beside it by the coarse one, and the rates
 * at z as the fine one's nodes have it. */
struct rules {
    struct tail_point fine, middle, coarse, beside, at_0;
    double kept; /* of the slope that dep's error makes, at the last node */
};

/* *sum, and the rates at the nodes. */
static void rule(const struct approach *a, size_t n, const double node[],
                 const double weight[], double kappa, struct tail_point p[],
                 struct tail_point *sum)
{
    struct vec2 z[FINE];

    for (size_t k = 0; k < n; k++)
        z[k] = place_beyond(a, node[k] / kappa, 0.0);
    rates_at(a, n, z, p);
    sum_up(a, n, weight, p, kappa, sum);
}

static void fine_rule(const struct approach *a, double kappa, struct rules *r)
{
    struct tail_point p[FINE];

    rule(a, FINE, fine_node, fine_weight, kappa, p, &r->fine);
    sum_up(a, FIRST, at_0_weight, p, 1.0, &r->at_0);
}

static void coarse_rule(const struct approach *a, double kappa, struct rules *r)
{
    struct tail_point p[2 * COARSE];
    struct vec2 z[2 * COARSE];

    for (size_t k = 0; k < 2 * COARSE; k++)
        z[k] = place_beyond(a, coarse_node[k % COARSE] / kappa,
                            k < COARSE ? 0.0 : a->aside);
    rates_at(a, 2 * COARSE, z, p);
    sum_up(a, COARSE, coarse_weight, p, kappa, &r->coarse);
    sum_up(a, COARSE, coarse_weight, p + COARSE, kappa, &r->beside);
    r->kept = fabs(p[2 * COARSE - 1].unknown - p[COARSE - 1].unknown);
}

static void middle_rule(const struct approach *a, double kappa, struct rules *r)
{
    struct tail_point p[MIDDLE];

    rule(a, MIDDLE, middle_node, middle_weight, kappa, p, &r->middle);
}

static double miss(double fine, double middle, double coarse, double at_0,
                   double first, double kappa)
{
    return fabs(fine - middle) + fabs(fine - coarse) +
           fabs(at_0 - first) * fine_node[0] / kappa;
}

/* Whether `miss` is more than most, whatever the fine rule says: it is not less
 * than |middle - coarse|, but for three roundings. */
static bool misses(double middle, double coarse, double most)
{
    return fabs(middle - coarse) * (1.0 - 4.0 * DBL_EPSILON) > most;
}

/* Integral i and its error by the rules. */
static void take_integral(const struct approach *a, double kappa,
                          const struct rules *r, size_t i, struct tail *t)
{
    t->integral[i] = r->fine.integral[i];
    t->integral_error[i] =
        miss(r->fine.integral[i], r->middle.integral[i], r->coarse.integral[i],
             r->at_0.integral[i], a->first.integral[i], kappa);
    t->integral_by_dep[i] =
        (r->beside.integral[i] - r->coarse.integral[i]) / a->aside;
}

/* Integral i by itself. */
static bool close_integral(const struct approach *a, size_t i, struct tail *t)
{
    const double kappa = a->kappa.integral[i];
    struct rules r;

    t->integral[i] = t->integral_error[i] = t->integral_by_dep[i] = 0.0;
    if (kappa == HUGE_VAL)
        return true;
    if (!(kappa > TOL_LIMIT_DECAY)) {
        t->integral_error[i] = HUGE_VAL;
        return true;
    }
    coarse_rule(a, kappa, &r);
    middle_rule(a, kappa, &r);
    if (misses(r.middle.integral[i], r.coarse.integral[i],
               a->most->integral[i]))
        return false;
    fine_rule(a, kappa, &r);
    take_integral(a, kappa, &r, i, t);
    return true;
}

/* Whether the dependent coordinate's error is more than is allowed, whatever
 * the other rules say: with S the stiffness over kappa and g = first/kappa,
 *     |fine - coarse| + S |fine - g| >= min(1, S) |coarse - g|
 * but for some roundings. */
static bool strays(const struct approach *a, double kappa, double coarse)
{
    const double part = fmin(fabs(a->by_dep) / kappa, 1.0);
    const double off = fabs(coarse - a->first.unknown / kappa);

    return part * off * (1.0 - 8.0 * DBL_EPSILON) > a->most->unknown;
}

/* Whether dep's error makes a slope that fades as the slope does, by e^-9 to
 * the last node, and is not that of a line from which others part. */
static bool fades(const struct approach *a, const struct rules *r)
{
    return r->kept <= TOL_FAR_BELOW * fabs(a->by_dep) * a->aside +
                          DBL_EPSILON * fabs(a->first.unknown);
}

/* Whether rules of a few points tell that. */
static bool misses_unknown(const struct approach *a, double kappa,
                           struct rules *r)
{
    coarse_rule(a, kappa, r);
    if (strays(a, kappa, r->coarse.unknown) || !fades(a, r))
        return true;
    middle_rule(a, kappa, r);
    return misses(r->middle.unknown, r->coarse.unknown, a->most->unknown);
}

/* The dependent coordinate, and the integrals that decay as it does. */
static bool close_unknown(const struct approach *a, struct tail *t)
{
    const double kappa = a->kappa.unknown;
    struct rules r;

    if (misses_unknown(a, kappa, &r))
        return false;
    fine_rule(a, kappa, &r);
    t->unknown = r.fine.unknown;
    const double off = fabs(r.fine.unknown - a->first.unknown / kappa);
    t->unknown_error = miss(r.fine.unknown, r.middle.unknown, r.coarse.unknown,
                            r.at_0.unknown, a->first.unknown, kappa) +
                       off * fabs(a->by_dep) / kappa;
    t->unknown_by_dep = (r.beside.unknown - r.coarse.unknown) / a->aside;
    for (size_t i = 0; i < a->carry->count; i++)
        take_integral(a, kappa, &r, i, t);
    return true;
}

static bool is_alike(double kappa, double other)
{
    return kappa < 1.5 * other && other < 1.5 * kappa;
}

static bool is_within(double error, double most)
{
    return error <= most || most == HUGE_VAL;
}

static bool holds(const struct approach *a, const struct tail *t)
{
    bool holds =
        isfinite(t->unknown) && is_within(t->unknown_error, a->most->unknown);

    for (size_t i = 0; i < a->carry->count; i++)
        holds &= is_within(t->integral_error[i], a->most->integral[i]);
    return holds;
}

bool close_tail(const struct planar *sys, int ind, int toward, struct vec2 z,
                const struct planar_look *at, const struct carry *carry,
                const struct tail_most *most, struct tail *t)
{
    const int rated = many_carried(carry);
    struct approach a = { .sys = sys,
                          .carry = carry,
                          .ind = ind,
                          .toward = toward,
                          .z = z,
                          .most = most };

    *t = (struct tail){ 0 };
    look(&a, rated, at);
    const double kappa = a.kappa.unknown;
    if (!(kappa > TOL_LIMIT_DECAY) || (kappa == HUGE_VAL && a.by_dep != 0.0) ||
        (kappa < HUGE_VAL && !close_unknown(&a, t)))
        return false;
    for (size_t i = 0; i < carry->count; i++)
        if ((kappa == HUGE_VAL || !is_alike(kappa, a.kappa.integral[i])) &&
            !close_integral(&a, i, t))
            return false;
    return holds(&a, t);
}
