/* Gauss-Legendre panels of two orders. */
#include <float.h>
#include <math.h>

#include "strand.h"
#include "tolerance.h"

/* Gauss-Legendre nodes and weights on [-1, 1], Abramowitz & Stegun 25.4.30,
 * positive half; ten nodes say what sixteen are worth. */
static const double fine[8][2] = {
    { 0.0950125098376374402, 0.1894506104550684963 },
    { 0.2816035507792589132, 0.1826034150449235888 },
    { 0.4580167776572273863, 0.1691565193950025382 },
    { 0.6178762444026437484, 0.1495959888165767321 },
    { 0.7554044083550030339, 0.1246289712555338720 },
    { 0.8656312023878317439, 0.0951585116824927848 },
    { 0.9445750230732325761, 0.0622535239386478929 },
    { 0.9894009349916499326, 0.0271524594117540949 },
};
static const double coarse[5][2] = {
    { 0.1488743389816312109, 0.2955242247147528702 },
    { 0.4333953941292471908, 0.2692667193099963550 },
    { 0.6794095682990244062, 0.2190863625159820440 },
    { 0.8650633666889845107, 0.1494513491505805931 },
    { 0.9739065285171717200, 0.0666713443086881376 },
};

struct patch {
    const struct separatrix *s;
    const struct strand_piece *p;
    double lo, hi;
    struct measure m;
    double allowed; /* error of one panel */
    int *left;      /* panels that may still be halved */
};

/* What an error of the curve does to the area beside it per unit of its length,
 * where it may be between lo and hi. */
static double cost_of(const struct patch *q, double at, double bar)
{
    const bool inside = at > q->lo - bar && at < q->hi + bar;
    const double z = fmin(fmax(at, q->lo), q->hi);

    return inside ? bar * measure_weight(&q->m, 1 - q->s->along, z) : 0.0;
}

/* The integrand by theta; *slack: what the curve's own error does to it. */
static double patch_at(const struct patch *q, double theta, double *slack)
{
    const struct separatrix *s = q->s;
    const struct curve *c = q->p->curve;
    const int along = s->along;
    double rise, run;
    const double w =
        series_at(strand_series(c, q->p->piece, along), theta, &rise);
    const double out =
        series_at(strand_series(c, q->p->piece, 1 - along), theta, &run);
    const double at = strand_across(s, s->origin) + out;
    const double bar = strand_bar(q->p, theta) + strand_rounding(s, w, out);
    const double weight =
        measure_weight(&q->m, along, strand_along(s, s->origin) + w);
    const double z = fmin(fmax(at, q->lo), q->hi);

    *slack = weight * cost_of(q, at, bar) * (fabs(rise) + fabs(run));
    return weight * measure_between(&q->m, 1 - along, q->lo, z) * rise;
}

static double rule(const struct patch *q, double a, double b,
                   const double node[][2], size_t n, double *slack)
{
    const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
    double sum = 0.0, one;

    *slack = 0.0;
    for (size_t k = 0; k < n; k++)
        for (int side = -1; side <= 1; side += 2) {
            sum += node[k][1] *
                   patch_at(q, middle + side * half * node[k][0], &one);
            *slack += node[k][1] * fabs(half) * one;
        }
    return sum * half;
}

/* Where between a and b the strand crosses lo or hi, and the integrand has a
 * kink: on different sides the rules may agree and both be wrong.  b: nowhere.
 */
static double kink_of(const struct patch *q, double a, double b, double edge)
{
    const struct series out =
        strand_series(q->p->curve, q->p->piece, 1 - q->s->along);
    const double origin = strand_across(q->s, q->s->origin) - edge;
    double slope;
    const bool below = origin + series_at(out, a, &slope) < 0.0;

    if (below == (origin + series_at(out, b, &slope) < 0.0))
        return b;
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (a + b);
        *((origin + series_at(out, middle, &slope) < 0.0) == below ? &a : &b) =
            middle;
    }
    return b;
}

/* From a to b, halved until both rules agree, or as well as the curve is known.
 */
static double integrate(const struct patch *q, double a, double b, int depth,
                        double *error)
{
    double slack, other;
    const double best = rule(q, a, b, fine, 8, &slack);
    const double check = rule(q, a, b, coarse, 5, &other);
    const double off = fabs(best - check), middle = 0.5 * (a + b);

    if (off <= fmax(q->allowed, slack) || depth == 0 || --*q->left < 0) {
        *error += off + slack;
        return best;
    }
    return integrate(q, a, middle, depth - 1, error) +
           integrate(q, middle, b, depth - 1, error);
}

/* The same between kinks. */
static double integrate_all(const struct patch *q, double a, double b,
                            double *error)
{
    const double x = kink_of(q, a, b, q->lo), y = kink_of(q, a, b, q->hi);
    const bool turned = (x < y) != (a < b);
    const double at[] = { a, turned ? y : x, turned ? x : y, b };
    double sum = 0.0;

    for (int i = 0; i < 3; i++)
        if (at[i] != at[i + 1])
            sum += integrate(q, at[i], at[i + 1], TOL_ITERATIONS, error);
    return sum;
}

static double ray_area(const struct patch *q, double from, double to,
                       double *error)
{
    const double at = strand_across(q->s, q->s->origin) + q->p->at;
    const double z = fmin(fmax(at, q->lo), q->hi);
    const int along = q->s->along;
    const double span = measure_between(&q->m, along, from, to);
    const double bar = q->p->error + strand_rounding(q->s, 0.0, q->p->at);

    *error += cost_of(q, at, bar) * span;
    return measure_between(&q->m, 1 - along, q->lo, z) * span;
}

double separatrix_area(const struct separatrix *s, size_t i, double from,
                       double to, double lo, double hi, struct measure m,
                       double *error)
{
    const double base = strand_along(s, s->origin);
    const double height = measure_between(&m, 1 - s->along, lo, hi);
    const double whole = measure_between(&m, s->along, from, to) * height;
    int left = TOL_BRANCH_STEPS;
    double sum = 0.0;

    *error = 0.0;
    for (size_t k = 0; k < s->strand[i].count; k++) {
        const struct strand_piece *p = &s->strand[i].piece[k];
        const struct patch q = { s, p, lo, hi, m, TOL_ROUNDED * whole, &left };
        const double a = fmax(p->lo, from - base), b = fmin(p->hi, to - base);
        if (!(a < b))
            continue;
        if (p->curve == NULL) {
            sum += ray_area(&q, base + a, base + b, error);
            continue;
        }
        const struct series up = strand_series(p->curve, p->piece, s->along);
        sum += integrate_all(&q, a > p->lo ? strand_theta(up, a, p) : p->from,
                             b < p->hi ? strand_theta(up, b, p) : p->to, error);
        *error += height * measure_weight(&m, s->along, base + b) *
                  TOL_ROUNDINGS_FEW * DBL_EPSILON * (fabs(a) + fabs(b));
    }
    *error = fmin(*error, whole);
    return sum;
}

/* ---- a measure of the plane ---------------------------------------------- */

/* c itself, or e^c in units. */
static double measure_at(const struct measure *m, int axis, double c)
{
    return m->exponential[axis] ? exp(c - m->log_unit[axis]) : c;
}

double measure_between(const struct measure *m, int axis, double lo, double hi)
{
    return m->exponential[axis] ? -measure_at(m, axis, hi) * expm1(lo - hi)
                                : hi - lo;
}

double measure_weight(const struct measure *m, int axis, double c)
{
    return m->exponential[axis] ? measure_at(m, axis, c) : 1.0;
}
