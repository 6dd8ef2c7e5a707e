/*
 * interval_formula.h -- interval.h's formulas for one kind of number, whose
 * arithmetic is interval_sums.h.
 *
 * Functions: Moore, Kearfott & Cloud, Introduction to Interval Analysis (2009),
 * ch. 5; derivatives go with the values as in automatic differentiation.
 */

#include "interval_sums.h"

static bool OWN(holds)(OWN(range) u, REAL x)
{
    return u.lo <= x && x <= u.hi;
}

static OWN(range) OWN(square)(OWN(range) u)
{
    const REAL a = FN(fabs)(u.lo), b = FN(fabs)(u.hi);
    const REAL least = OWN(holds)(u, 0) ? 0 : OWN(smaller)(a, b);
    const REAL most = OWN(larger)(a, b);

    return (OWN(range)){ OWN(larger)(OWN(below)(least * least), 0),
                         most > 0 ? OWN(above)(most * most) : 0 };
}

static OWN(range) OWN(hull)(OWN(range) u, OWN(range) w)
{
    return (OWN(range)){ OWN(smaller)(u.lo, w.lo), OWN(larger)(u.hi, w.hi) };
}

/* Function values, from the lower and the upper end. */
static OWN(range) OWN(wide)(REAL lo, REAL hi)
{
    const REAL a = FN(fabs)(lo) * (8 * UNIT) + LEAST;
    const REAL b = FN(fabs)(hi) * (8 * UNIT) + LEAST;

    return (OWN(range)){ lo > MOST ? MOST * (1 - 8 * UNIT) : lo - a,
                         hi < -MOST ? -MOST * (1 - 8 * UNIT) : hi + b };
}

static OWN(range) OWN(clip)(OWN(range) u, REAL lo, REAL hi)
{
    return (OWN(range)){ OWN(larger)(u.lo, lo), OWN(smaller)(u.hi, hi) };
}

/* ---- functions: value and slope of u ------------------------------------- */

struct OWN(rule) {
    OWN(range) u;
    OWN(range) value, slope;
    enum interval_domain domain;
};

/* Cuts u to where the function is defined, lo <= u <= hi. */
static void OWN(defined)(struct OWN(rule) * r, REAL lo, REAL hi)
{
    if (r->u.hi < lo || r->u.lo > hi) {
        r->domain = INTERVAL_NOWHERE;
        r->u = OWN(point)(lo < -MOST ? hi : lo);
    } else if (r->u.lo < lo || r->u.hi > hi) {
        r->domain = INTERVAL_PARTLY;
        r->u = OWN(clip)(r->u, lo, hi);
    }
}

static OWN(range) OWN(root)(OWN(range) u)
{
    const REAL lo = OWN(larger)(u.lo, 0), hi = OWN(larger)(u.hi, 0);

    return OWN(clip)(OWN(wide)(FN(sqrt)(lo), FN(sqrt)(hi)), 0, ENDLESS);
}

static OWN(range) OWN(exp)(OWN(range) u)
{
    return OWN(clip)(OWN(wide)(FN(exp)(u.lo), FN(exp)(u.hi)), 0, ENDLESS);
}

static OWN(range) OWN(one_plus_square)(OWN(range) u)
{
    return NAME(interval_add)(OWN(point)(1), OWN(square)(u));
}

static OWN(range) OWN(cosh)(OWN(range) u)
{
    const REAL a = FN(fabs)(u.lo), b = FN(fabs)(u.hi);
    const REAL near = OWN(holds)(u, 0) ? 0 : OWN(smaller)(a, b);

    return OWN(clip)(OWN(wide)(FN(cosh)(near), FN(cosh)(OWN(larger)(a, b))), 1,
                     ENDLESS);
}

static OWN(range) OWN(sech_square)(OWN(range) u)
{
    return OWN(clip)(OWN(inverse)(OWN(square)(OWN(cosh)(u))), 0, 1);
}

/* sin has its extrema at pi/2 + n pi: those that may be in u count, n even 1,
 * n odd -1; n is counted with room for its rounding. */
static OWN(range) OWN(sin)(OWN(range) u)
{
    const REAL pi = (REAL) formula_pi(), room = 64 * UNIT;

    if (!(u.hi - u.lo < 2 * pi) || !(FN(fabs)(u.lo) + FN(fabs)(u.hi) < 1e6))
        return (OWN(range)){ -1, 1 };
    const REAL from = u.lo / pi - (REAL) 0.5, to = u.hi / pi - (REAL) 0.5;
    const long first = (long) FN(ceil)(from - room * (1 + FN(fabs)(from)));
    const long last = (long) FN(floor)(to + room * (1 + FN(fabs)(to)));
    const REAL a = FN(sin)(u.lo), b = FN(sin)(u.hi);
    OWN(range) value = OWN(wide)(OWN(smaller)(a, b), OWN(larger)(a, b));

    for (long n = first; n <= last; n++)
        value = OWN(hull)(value, OWN(point)(n % 2 == 0 ? 1 : -1));
    return OWN(clip)(value, -1, 1);
}

/* sin(u + pi/2): u is shifted outward. */
static OWN(range) OWN(cos)(OWN(range) u)
{
    const REAL half = (REAL) (formula_pi() / 2);
    const OWN(range) shift = { OWN(below)(half), OWN(above)(half) };

    return OWN(sin)(NAME(interval_add)(u, shift));
}

/* Rises between poles, at which cos is 0. */
static void OWN(tan)(struct OWN(rule) * r)
{
    const OWN(range) c = OWN(cos)(r->u);

    r->value = r->slope = OWN(all)();
    if (OWN(holds)(c, 0) || !(r->u.hi - r->u.lo < 3)) {
        r->domain = INTERVAL_PARTLY;
        return;
    }
    r->value = OWN(wide)(FN(tan)(r->u.lo), FN(tan)(r->u.hi));
    r->slope = OWN(inverse)(OWN(square)(c));
}

static OWN(range) OWN(monotone)(OWN(range) u, REAL (*f)(REAL))
{
    return OWN(wide)(f(u.lo), f(u.hi));
}

static void OWN(asin)(struct OWN(rule) * r)
{
    OWN(defined)(r, -1, 1);
    r->value = OWN(monotone)(r->u, FN(asin));
    r->slope = OWN(inverse)(
        OWN(root)(NAME(interval_less)(OWN(point)(1), OWN(square)(r->u))));
}

static void OWN(ln)(struct OWN(rule) * r)
{
    OWN(defined)(r, 0, ENDLESS);
    r->value = OWN(monotone)(r->u, FN(log));
    r->slope = OWN(inverse)(r->u);
}

/* False: there is no rule. */
static bool OWN(apply)(enum formula_function f, struct OWN(rule) * r)
{
    switch (f) {
        case FUNCTION_EXP:
            r->value = r->slope = OWN(exp)(r->u);
            return true;
        case FUNCTION_LN:
            OWN(ln)(r);
            return true;
        case FUNCTION_SQRT:
            OWN(defined)(r, 0, ENDLESS);
            r->value = OWN(root)(r->u);
            r->slope =
                OWN(inverse)(NAME(interval_times)(OWN(point)(2), r->value));
            return true;
        case FUNCTION_SINH:
            r->value = OWN(monotone)(r->u, FN(sinh));
            r->slope = OWN(cosh)(r->u);
            return true;
        case FUNCTION_COSH:
            r->value = OWN(cosh)(r->u);
            r->slope = OWN(monotone)(r->u, FN(sinh));
            return true;
        case FUNCTION_TANH:
            r->value = OWN(clip)(OWN(monotone)(r->u, FN(tanh)), -1, 1);
            r->slope = OWN(sech_square)(r->u);
            return true;
        case FUNCTION_ASINH:
            r->value = OWN(monotone)(r->u, FN(asinh));
            r->slope = OWN(inverse)(OWN(root)(OWN(one_plus_square)(r->u)));
            return true;
        case FUNCTION_SIN:
            r->value = OWN(sin)(r->u);
            r->slope = OWN(cos)(r->u);
            return true;
        case FUNCTION_COS:
            r->value = OWN(cos)(r->u);
            r->slope = OWN(minus)(OWN(sin)(r->u));
            return true;
        case FUNCTION_TAN:
            OWN(tan)(r);
            return true;
        case FUNCTION_ASIN:
            OWN(asin)(r);
            return true;
        case FUNCTION_ATAN:
            r->value = OWN(monotone)(r->u, FN(atan));
            r->slope = OWN(inverse)(OWN(one_plus_square)(r->u));
            return true;
        default:
            return false;
    }
}

/* ---- powers -------------------------------------------------------------- */

/* x^n of n > 0: seven products are right to four units. */
static REAL OWN(natural_power)(REAL x, int n)
{
    REAL power = x;

    if (n > 8)
        return FN(pow)(x, n);
    for (int i = 1; i < n; i++)
        power *= x;
    return power;
}

/* u^n of a whole n. */
static OWN(range) OWN(whole_power)(OWN(range) u, int n)
{
    if (n < 0)
        return OWN(inverse)(OWN(whole_power)(u, -n));
    if (n == 0)
        return OWN(point)(1);
    const REAL a = OWN(natural_power)(u.lo, n), b = OWN(natural_power)(u.hi, n);
    if (n % 2 || u.lo >= 0)
        return OWN(wide)(a, b);
    if (u.hi <= 0)
        return OWN(wide)(b, a);
    return OWN(clip)(OWN(wide)(0, OWN(larger)(a, b)), 0, ENDLESS);
}

/* u^p of u >= 0: monotone in both. */
static OWN(range) OWN(real_power)(OWN(range) u, OWN(range) p)
{
    const REAL a = FN(pow)(u.lo, p.lo), b = FN(pow)(u.lo, p.hi);
    const REAL c = FN(pow)(u.hi, p.lo), d = FN(pow)(u.hi, p.hi);

    return OWN(clip)(OWN(hull)(OWN(hull)(OWN(wide)(a, a), OWN(wide)(b, b)),
                               OWN(hull)(OWN(wide)(c, c), OWN(wide)(d, d))),
                     0, ENDLESS);
}

static void OWN(power)(struct OWN(rule) * r, OWN(range) p)
{
    const bool whole =
        p.lo >= p.hi && FN(fabs)(p.lo) < 10000 && FN(floor)(p.lo) >= p.lo;

    if (whole) {
        const int n = (int) p.lo;
        if (n < 0 && OWN(holds)(r->u, 0))
            r->domain = INTERVAL_PARTLY;
        r->value = OWN(whole_power)(r->u, n);
        r->slope =
            NAME(interval_times)(OWN(point)(n), OWN(whole_power)(r->u, n - 1));
        return;
    }
    OWN(defined)(r, 0, ENDLESS);
    r->value = OWN(real_power)(r->u, p);
    r->slope = NAME(interval_times)(
        p, OWN(real_power)(r->u, NAME(interval_less)(p, OWN(point)(1))));
}

/* ---- nodes --------------------------------------------------------------- */

/* out = value, with slopes a du + b dw; either may be NULL. */
static void OWN(chain)(struct NAME(interval_slope) * out, OWN(range) value,
                       OWN(range) a, const struct NAME(interval_slope) * u,
                       OWN(range) b, const struct NAME(interval_slope) * w)
{
    struct NAME(interval_slope) sum = { .value = value };

    for (int k = 0; k < 2; k++) {
        if (u)
            sum.by[k] = NAME(interval_times)(a, u->by[k]);
        if (w)
            sum.by[k] = NAME(interval_add)(sum.by[k],
                                           NAME(interval_times)(b, w->by[k]));
    }
    *out = sum;
}

static enum interval_domain OWN(product)(const struct formula_node *n,
                                         struct NAME(interval_slope) * of,
                                         struct NAME(interval_slope) * out)
{
    const struct NAME(interval_slope) *u = &of[n->of[0]], *w = &of[n->of[1]];

    if (n->of[0] == n->of[1])
        OWN(chain)
    (out, OWN(square)(u->value), NAME(interval_times)(OWN(point)(2), u->value),
     u, OWN(point)(0), NULL);
    else OWN(chain)(out, NAME(interval_times)(u->value, w->value), w->value, u,
                    u->value, w);
    return INTERVAL_WHOLE;
}

/* u/w: slopes 1/w and -(u/w)/w; where w may be 0 they may be all. */
static enum interval_domain OWN(quotient)(const struct formula_node *n,
                                          struct NAME(interval_slope) * of,
                                          struct NAME(interval_slope) * out)
{
    const struct NAME(interval_slope) *u = &of[n->of[0]], *w = &of[n->of[1]];
    const OWN(range) over = OWN(inverse)(w->value);
    const OWN(range) value = NAME(interval_times)(u->value, over);

    OWN(chain)
    (out, value, over, u, OWN(minus)(NAME(interval_times)(value, over)), w);
    if (OWN(is_point)(w->value, 0))
        return INTERVAL_NOWHERE;
    return OWN(holds)(w->value, 0) ? INTERVAL_PARTLY : INTERVAL_WHOLE;
}

/* -1: there is no rule. */
static int OWN(call)(const struct formula_node *n,
                     struct NAME(interval_slope) * of,
                     struct NAME(interval_slope) * out)
{
    const struct NAME(interval_slope) *u = &of[n->of[0]];
    struct OWN(rule) r = { .u = u->value, .domain = INTERVAL_WHOLE };

    if (n->function == FUNCTION_POWER)
        OWN(power)(&r, of[n->of[1]].value);
    else if (!OWN(apply)(n->function, &r))
        return -1;
    OWN(chain)(out, r.value, r.slope, u, OWN(point)(0), NULL);
    return (int) r.domain;
}

/* Sets of[i] from those before it; -1: there is no rule. */
static int OWN(node)(const struct formula *f, int i,
                     struct NAME(interval_slope) * of)
{
    const struct formula_node *n = &f->node[i];

    switch (n->kind) {
        case FORMULA_NUMBER:
        case FORMULA_LEAF:
            return INTERVAL_WHOLE; /* set before */
        case FORMULA_SUM:
            OWN(chain)
            (&of[i], NAME(interval_add)(of[n->of[0]].value, of[n->of[1]].value),
             OWN(point)(1), &of[n->of[0]], OWN(point)(1), &of[n->of[1]]);
            return INTERVAL_WHOLE;
        case FORMULA_TIMES:
            return (int) OWN(product)(n, of, &of[i]);
        case FORMULA_OVER:
            return (int) OWN(quotient)(n, of, &of[i]);
        case FORMULA_CALL:
            return OWN(call)(n, of, &of[i]);
    }
    return -1;
}

enum interval_domain NAME(interval_over)(struct interval_plan *p,
                                         const OWN(range) box[2],
                                         struct NAME(interval_slope) out[])
{
    struct NAME(interval_slope) *of = p->NAME(of);
    int domain = INTERVAL_WHOLE;

    for (int k = 0; k < 2; k++) {
        of[p->variable[k]] = (struct NAME(interval_slope)){ .value = box[k] };
        of[p->variable[k]].by[k] = OWN(point)(1);
    }
    for (int i = 0; i < p->nodes; i++) {
        const int found = OWN(node)(p->f, p->node[i], of);
        domain = found > domain ? found : domain;
    }
    for (int i = 0; i < p->results; i++)
        out[i] = of[p->result[i]];
    return (enum interval_domain) domain;
}
