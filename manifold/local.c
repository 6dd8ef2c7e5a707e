/*
 * The graph of an invariant manifold over one coordinate, by the recursion of
 * its invariance equation  S(s) f_ind(s) = f_dep(s),  S = d dep/d ind, order
 * by order: at a saddle both sides vanish and order k gives
 *     c[k] (k lambda - mu) = known,   lambda this, mu the other eigenvalue,
 * which is never singular (Poincare; Cabre, Fontich & de la Llave 2005).
 * What is ours: the field comes as jets, so no formula is differentiated by
 * hand, and the radius is checked against the field itself.
 */
#include "local.h"

#include <float.h>
#include <math.h>

#include "tolerance.h"

/* Working series: the field along the graph, the same in both lanes. */
struct graph {
    const struct planar *sys;
    struct jet_work work;
    jet_pair at[2][JET_SIZE]; /* ind = s, dep = u->c */
    jet_pair f[2][JET_SIZE];
    jet_pair rate[LOCAL_CARRY_MAX][JET_SIZE];
};

static void graph_jet(struct graph *g, const struct local_series *u, size_t k)
{
    g->at[1 - u->ind][k] = JET_PAIR(u->c[k]);
    g->at[u->ind][k] = JET_PAIR(k == 1 ? u->unit : 0.0);
    g->sys->jet(g->sys->ctx, &g->work, k, g->at[0], g->at[1], g->f[0], g->f[1]);
}

/* What order k leaves on the right when c[k] is still zero. */
static double defect_of_order(const struct graph *g,
                              const struct local_series *u, size_t k)
{
    const jet_pair *ind = g->f[u->ind];
    double sum = u->c[1] * ind[k][0];

    for (size_t j = 1; j + 1 < k; j++)
        sum += (double) (j + 1) * u->c[j + 1] * ind[k - j][0];
    return g->f[1 - u->ind][k][0] - sum / u->unit;
}

static void carry_order(struct graph *g, const struct carry *carry, size_t k)
{
    for (size_t i = 0; i < carry->count; i++) {
        if (carry->which[i] == CARRY_TIME)
            g->rate[i][k] = JET_PAIR(k == 0 ? 1.0 : 0.0);
        else
            g->sys->rate_jet(g->sys->ctx, (size_t) carry->which[i], &g->work, k,
                             g->at[0], g->at[1], g->rate[i]);
    }
}

static void build(struct graph *g, const struct carry *carry,
                  const struct equilibrium *e, enum manifold_kind kind,
                  struct local_series *u)
{
    double lambda = 0.0, other = 0.0;

    for (size_t k = 0; k <= u->order; k++) {
        if (k >= 2) {
            u->c[k] = 0.0;
            graph_jet(g, u, k);
            u->c[k] = defect_of_order(g, u, k) / ((double) k * lambda - other);
        } else if (k == 1) {
            const double unit = exp(e->log_scale - g->work.log_scale[0]);
            lambda = unit * e->scaled[kind == MANIFOLD_STABLE ? 0 : 1];
            other = unit * e->scaled[kind == MANIFOLD_STABLE ? 1 : 0];
        }
        graph_jet(g, u, k);
        carry_order(g, carry, k);
    }
}

void local_integral_floor(size_t order, double along, double u[])
{
    const double lost = TOL_ROUNDINGS * DBL_TRUE_MIN / fabs(along);
    const bool nil = fmax(fabs(u[1]), lost) <= INTEGRAL_NIL;

    for (size_t k = order - 1; k <= order && !nil; k++)
        if (fabs(u[k]) < lost)
            u[k] = lost;
}

/* q' = rate/f_ind with both zero at the saddle: divide the shifted series. */
static void build_integrals(const struct graph *g, const struct carry *carry,
                            struct local_series *u)
{
    const jet_pair *den = g->f[u->ind] + 1;
    jet_pair quotient[JET_SIZE];

    for (size_t i = 0; i < carry->count; i++) {
        const jet_pair *rate = g->rate[i];
        u->converges[i] = rate[0][0] == 0.0;
        for (size_t k = 0; k <= u->order; k++)
            u->integral[i][k] = 0.0;
        for (size_t k = 0; u->converges[i] && k < u->order; k++) {
            quotient[k] = jet_quotient(k, rate + 1, den, quotient);
            u->integral[i][k + 1] = u->unit * quotient[k][0] / (double) (k + 1);
        }
        if (u->converges[i])
            local_integral_floor(u->order, den[0][0] / u->unit, u->integral[i]);
    }
}

double local_slope(const struct planar *sys, int ind, struct vec2 z)
{
    struct planar_field f;

    sys->field(sys->ctx, z, &f);
    return local_quotient(ind, f.direction);
}

struct vec2 local_series_at(const struct local_series *u, double s)
{
    return local_point(u->ind, s * u->unit, jet_at(u->order, u->c, s));
}

/* Radius at which the last two terms of u fall to tol times its first - or,
 * where that is zero by symmetry, its largest - coefficient. */
static double radius_of(const double u[], size_t order, double tol)
{
    double radius = HUGE_VAL, size = fabs(u[1]);

    for (size_t k = 2; u[1] == 0.0 && k <= order; k++)
        size = fmax(size, fabs(u[k]));
    for (size_t k = order - 1; k <= order; k++)
        if (u[k] != 0.0)
            radius = fmin(radius,
                          pow(tol * size / fabs(u[k]), 1.0 / (double) (k - 1)));
    return radius;
}

/* The series' slope against the field's at +-s, relative; terms below the least
 * double are lost. */
static double slope_defect(const struct planar *sys,
                           const struct local_series *u, double s)
{
    double worst = 0.0;

    for (int side = -1; side <= 1; side += 2) {
        const double t = side * s;
        const double slope = jet_slope_at(u->order, u->c, t) / u->unit;
        const double field = local_slope(sys, u->ind, local_series_at(u, t));
        const double lost = TOL_ROUNDINGS * DBL_TRUE_MIN / u->unit;
        const double off = fdim(fabs(slope - field), lost);
        const double size = fabs(slope) + fabs(u->c[1] / u->unit);
        const double defect = off == 0.0 ? 0.0 : off / size;
        if (!(defect <= worst))
            worst = defect;
    }
    return worst;
}

/* Relative rounding of the field's slope near the saddle along the manifold:
 * on a slow manifold each component is a small difference of large terms. */
static double slope_rounding(const struct equilibrium *e, double lambda,
                             const struct local_series *u)
{
    const struct mat2 m = e->matrix;
    const double c = u->c[1] / u->unit, size = fabs(lambda);
    const double ind =
        u->ind == 0 ? fabs(m.xx) + fabs(m.xy * c) : fabs(m.yy) + fabs(m.yx * c);
    const double dep =
        u->ind == 0 ? fabs(m.yx) + fabs(m.yy * c) : fabs(m.xy) + fabs(m.xx * c);
    const double lost = ind / size + (c == 0.0 ? 0.0 : dep / fabs(size * c));
    return 8.0 * DBL_EPSILON * (lost + 32.0);
}

static enum status find_radius(const struct planar *sys,
                               const struct carry *carry, double tol,
                               double rounding, struct local_series *u)
{
    double radius = radius_of(u->c, u->order, tol);

    for (size_t i = 0; i < carry->count; i++)
        if (u->converges[i] && fabs(u->integral[i][1]) > INTEGRAL_NIL)
            radius = fmin(radius, radius_of(u->integral[i], u->order, tol));
    radius = fmin(0.9 * radius, TOL_SERIES_RADIUS_MAX);
    for (int i = 0; i < 60; i++, radius *= 0.5) {
        u->radius = radius;
        if (slope_defect(sys, u, radius) <= TOL_SLOPE_CHECK * tol + rounding)
            return STATUS_OK;
    }
    return STATUS_NO_CONVERGENCE;
}

/* The length over which the field changes, in units: from the larger of the
 * last two coefficients, for one may vanish by symmetry; 0 where they have
 * overflowed, infinite where both vanish. */
static double length_of(const struct local_series *u)
{
    const double first = u->c[1] == 0.0 ? u->unit : u->c[1];
    double length = HUGE_VAL;

    for (size_t k = u->order - 1; k <= u->order; k++) {
        const double ratio = fabs(u->c[k] / first);
        if (!isfinite(ratio))
            return 0.0;
        if (ratio > 0.0)
            length = fmin(length, pow(ratio, -1.0 / (double) (k - 1)));
    }
    return length;
}

/* The series of the given slope, in a smaller unit - found by bisection of its
 * exponent - where powers of the length over which the field changes would
 * overflow. */
static void expand(const struct planar *sys, const struct carry *carry,
                   const struct equilibrium *e, enum manifold_kind kind,
                   double slope, struct local_series *u)
{
    const double near = TOL_SAME;
    struct graph g;
    int least = DBL_MIN_EXP, most = 0, exponent = 0;

    g.sys = sys;
    g.work.linear = g.at[u->ind];
    u->c[0] = 0.0;
    for (;;) {
        u->unit = ldexp(1.0, exponent);
        u->c[1] = slope * u->unit;
        build(&g, carry, e, kind, u);
        const double length = length_of(u);
        if (length > near && (length < 1.0 / near || exponent == 0))
            break;
        const bool ends = most - least < 2;
        if (ends && (length > near || exponent == least))
            break;
        *(length > near ? &least : &most) = exponent;
        exponent = ends ? least : least + (most - least) / 2;
    }
    build_integrals(&g, carry, u);
}

enum status local_over(const struct planar *sys, const struct equilibrium *e,
                       enum manifold_kind kind, int ind,
                       const struct carry *carry, size_t order, double tol,
                       struct local_series *out)
{
    const double lambda = e->scaled[kind == MANIFOLD_STABLE ? 0 : 1];
    const double other = e->scaled[kind == MANIFOLD_STABLE ? 1 : 0];

    if (sys->jet == NULL || order < 4 || order >= JET_SIZE)
        return STATUS_BAD_ARGUMENT;
    if (kind == MANIFOLD_STABLE ? !(lambda < 0.0 && other >= 0.0)
                                : !(lambda > 0.0 && other <= 0.0))
        return STATUS_NOT_HYPERBOLIC;
    if (equilibrium_is_beyond(e))
        return STATUS_NOT_HYPERBOLIC;
    const struct vec2 v = mat2_eigenvector(e->matrix, lambda);
    const double slope = local_quotient(ind, v);
    if (!isfinite(slope))
        return STATUS_NO_CONVERGENCE;
    out->ind = ind;
    out->order = order;
    expand(sys, carry, e, kind, slope, out);
    return find_radius(sys, carry, tol, slope_rounding(e, lambda, out), out);
}

enum status local_at(const struct planar *sys, const struct equilibrium *e,
                     enum manifold_kind kind, const struct carry *carry,
                     size_t order, double tol, struct local_series *out)
{
    const double lambda = e->scaled[kind == MANIFOLD_STABLE ? 0 : 1];
    const struct vec2 v = mat2_eigenvector(e->matrix, lambda);

    return local_over(sys, e, kind, fabs(v.y) <= fabs(v.x) ? 0 : 1, carry,
                      order, tol, out);
}
