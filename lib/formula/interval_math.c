#include "interval_math.h"

#include <float.h>

#include "interval_point.h"

/* Sizes beside which what underflows as a double is nothing, to one over it. */
#define INTERVAL_NEAR 0x1p-900L

/* ---- sums of products ---------------------------------------------------- */

static struct interval term_by_term(size_t n, int rise,
                                    const struct interval u[],
                                    const struct interval *w, long double over)
{
    struct interval sum = { 0, 0 };

    for (size_t i = 0; i < n; i++) {
        const struct interval by =
            interval_point(1 + (long double) (i * (size_t) rise));
        if (!interval_is_zero(u[i]) && !interval_is_zero(*(w - i)))
            sum = interval_add(
                sum, interval_times(interval_times(u[i], *(w - i)), by));
    }
    return interval_is_zero(sum) ? sum
                                 : interval_divide(sum, interval_point(over));
}

/* Sizes being above 2^-900, high + low is m but where the half is 2^170 times
 * what it is beside. */
void interval_row_take(struct interval_row *r, size_t k)
{
    const struct interval u = r->c[k];
    const long double m = u.lo + u.hi, w = u.hi - u.lo;
    const long double size = fabsl(m) + w;

    r->high[k] = (double) m;
    r->low[k] = (double) (m - r->high[k]);
    r->half[k] = 0;
    if (interval_is_zero(u))
        return;
    r->half[k] = (double) w * (1 + 2 * DBL_EPSILON);
    if (!(size > INTERVAL_NEAR && size < 1 / INTERVAL_NEAR))
        r->high[k] = NAN;
}

struct interval_row interval_row_of(const struct interval c[], size_t n)
{
    struct interval_row r;

    r.c = c;
    for (size_t k = 0; k <= n; k++)
        interval_row_take(&r, k);
    return r;
}

/* With 2 m and 2 l of two rows and 2 r, 2 s their halves, a product is within
 * |m| s + r (|l| + s) of m l.  Of n terms of at most |m l| and their sum each
 * rounding adds 2^-64 of the terms' sizes so far (Higham, Accuracy and
 * Stability (2002), ch. 3): n + 7 at most, with the quotient's and the middles'
 * own, where twice n + 12 are counted.  Halves, which are not negative, and the
 * sizes |m|, |l| are summed in doubles with n + 8 roundings by 2^-53, for which
 * n + 12 of 2^-51 are added; what underflows is nothing beside 2^-900. */
struct interval interval_sum(size_t n, int rise, const struct interval_row *u,
                             size_t first, const struct interval_row *w,
                             size_t top, long double over)
{
    const double units = (double) (n + 12) * (double) LDBL_EPSILON;
    const double grown = 1 + (double) (n + 12) * 2 * DBL_EPSILON;
    long double all = 0;
    double beside = 0, by = 1;

    for (size_t i = 0; i < n; i++, by += rise) {
        const size_t j = first + i, k = top - i;
        const double m = fabs(u->high[j]), l = fabs(w->high[k]);
        const double r = u->half[j], s = w->half[k];
        all += ((long double) u->high[j] + u->low[j]) * by *
               ((long double) w->high[k] + w->low[k]);
        beside += by * (m * (s + l * units) + r * (l + s));
    }
    const long double room = (long double) beside * grown;
    if (!(room > INTERVAL_NEAR && room < HUGE_VAL))
        return term_by_term(n, rise, u->c + first, w->c + top, over);
    return (struct interval){ (all - room) / (4 * over),
                              (all + room) / (4 * over) };
}

/* sum_{j=1}^{k} j u_j d_{k-j} over k */
struct interval interval_chain(const struct interval_row *u,
                               const struct interval_row *d, size_t k)
{
    return interval_sum(k, 1, u, 1, d, k - 1, (long double) k);
}

void interval_exponential(size_t n, const struct interval u[],
                          struct interval e0, struct interval out[])
{
    const struct interval_row by = interval_row_of(u, n);
    struct interval_row made = { .c = out };

    out[0] = e0;
    for (size_t k = 1; k <= n; k++) {
        interval_row_take(&made, k - 1);
        out[k] = interval_chain(&by, &made, k);
    }
}

void interval_product(size_t n, const struct interval u[],
                      const struct interval w[], struct interval out[])
{
    const struct interval_row U = interval_row_of(u, n);
    const struct interval_row W = interval_row_of(w, n);

    out[0] = interval_times(u[0], w[0]);
    for (size_t k = 1; k <= n; k++)
        out[k] = interval_sum(k + 1, 0, &U, 0, &W, k, 1);
}

/* ---- functions that rise ------------------------------------------------- */

static struct interval rising(struct interval (*at)(long double),
                              struct interval u)
{
    const struct interval lo = at(u.lo);

    return (struct interval){ lo.lo, u.lo < u.hi ? at(u.hi).hi : lo.hi };
}

static struct interval all(void)
{
    return (struct interval){ -HUGE_VAL, HUGE_VAL };
}

struct interval interval_exp(struct interval u)
{
    return rising(interval_exp_at, u);
}

struct interval interval_expm1(struct interval u)
{
    return rising(interval_expm1_at, u);
}

struct interval interval_ln(struct interval u)
{
    return u.lo >= 0 && u.hi > 0 ? rising(interval_ln_at, u) : all();
}

struct interval interval_ln1p(struct interval u)
{
    return u.lo >= -1 && u.hi > -1 ? rising(interval_ln1p_at, u) : all();
}

/* The processor's is correctly rounded (IEEE 754). */
struct interval interval_sqrt(struct interval u)
{
    if (!(u.lo >= 0))
        return all();
    return (struct interval){ fmaxl(0, nextafterl(sqrtl(u.lo), -HUGE_VALL)),
                              nextafterl(sqrtl(u.hi), HUGE_VALL) };
}

static struct interval plus(struct interval u, long double x)
{
    return interval_add(u, interval_point(x));
}

static struct interval twice(struct interval u, long double factor)
{
    return interval_times(u, interval_point(factor));
}

/* (e + e/(1 + e))/2, e = e^|x| - 1 */
static struct interval sinh_at(long double x)
{
    const struct interval e = interval_expm1_at(fabsl(x));
    const struct interval s =
        twice(interval_add(e, interval_divide(e, plus(e, 1))), 0.5L);

    return x < 0 ? interval_minus(s) : s;
}

/* ln(1 + z + z^2/(1 + sqrt(1 + z^2))), z = |x| */
static struct interval asinh_at(long double x)
{
    const struct interval z = interval_point(fabsl(x));
    const struct interval square = interval_times(z, z);
    const struct interval under = plus(interval_sqrt(plus(square, 1)), 1);
    const struct interval s =
        interval_ln1p(interval_add(z, interval_divide(square, under)));

    return x < 0 ? interval_minus(s) : s;
}

static struct interval power_at(long double x, long n)
{
    if (n == 0)
        return interval_point(1);
    const struct interval half = power_at(x, n / 2);
    const struct interval square = interval_times(half, half);

    return n % 2 ? interval_times(square, interval_point(x)) : square;
}

/* Rises with |u|, or with u where n is odd. */
struct interval interval_power(struct interval u, long n)
{
    if (n % 2 == 0)
        u = (struct interval){ interval_least(u), interval_most(u) };
    return (struct interval){ power_at(u.lo, n).lo, power_at(u.hi, n).hi };
}

struct interval interval_sinh(struct interval u)
{
    return rising(sinh_at, u);
}

struct interval interval_asinh(struct interval u)
{
    return rising(asinh_at, u);
}

/* ---- made of them -------------------------------------------------------- */

/* w + ln(1 + (sqrt(1 + 4 e^(-2 w)) - 1)/2), where e^w would be too large */
static struct interval asinh_exp_large(struct interval w)
{
    const struct interval q = twice(interval_exp(twice(w, -2)), 4);
    const struct interval root = interval_sqrt(plus(q, 1));

    return interval_add(w, interval_ln1p(twice(plus(root, -1), 0.5)));
}

/* Rises: an end each. */
struct interval interval_asinh_exp(struct interval u)
{
    struct interval end[2];

    for (int i = 0; i < 2; i++) {
        const struct interval w = interval_point(i == 0 ? u.lo : u.hi);
        end[i] = w.lo > 1 ? asinh_exp_large(w)
                          : interval_asinh(twice(interval_exp(w), 0.5));
    }
    return (struct interval){ end[0].lo, end[1].hi };
}

/* Neither k nor q is much larger than 1. */
static struct interval mixed_at(struct interval k, struct interval q,
                                long double at)
{
    const struct interval u = interval_point(at);

    if (at > 1)
        return interval_add(
            u, interval_ln(interval_add(
                   k, interval_times(q, interval_exp(twice(u, -1))))));
    const struct interval change = interval_times(k, interval_expm1(u));
    return change.lo > -0.5 ? interval_ln1p(change)
                            : interval_ln(interval_add(
                                  q, interval_times(k, interval_exp(u))));
}

struct interval interval_mixed(struct interval k, struct interval q,
                               struct interval u)
{
    return (struct interval){ mixed_at(k, q, u.lo).lo,
                              mixed_at(k, q, u.hi).hi };
}

/* k/(k + q e^-u) or k e^u/(k e^u + q): rises */
static struct interval mixed_slope_at(struct interval k, struct interval q,
                                      long double at)
{
    const struct interval e = interval_exp(interval_point(-fabsl(at)));
    const struct interval ke = at < 0 ? interval_times(k, e) : k;
    const struct interval qe = at < 0 ? q : interval_times(q, e);

    return interval_divide(ke, interval_add(ke, qe));
}

struct interval interval_mixed_slope(struct interval k, struct interval q,
                                     struct interval u)
{
    if (q.lo >= 0 && q.hi <= 0)
        return interval_point(1);
    if (k.lo >= 0 && k.hi <= 0)
        return interval_point(0);
    return interval_both((struct interval){ mixed_slope_at(k, q, u.lo).lo,
                                            mixed_slope_at(k, q, u.hi).hi },
                         (struct interval){ 0, 1 });
}

/* With q0 = 4 e^(-2 k), q = q0 e^(-2 u) and s = sqrt(1 + q):
 * u + ln(1 + q0 (e^(-2 u) - 1)/((s + s0)(1 + s0))) */
static struct interval friction_far(struct interval k, struct interval u)
{
    const struct interval q0 = twice(interval_exp(twice(k, -2)), 4);
    const struct interval q =
        twice(interval_exp(twice(interval_add(k, u), -2)), 4);
    const struct interval s0 = interval_sqrt(plus(q0, 1));
    const struct interval s = interval_sqrt(plus(q, 1));
    const struct interval under =
        interval_times(interval_add(s, s0), plus(s0, 1));
    const struct interval over =
        interval_times(q0, interval_expm1(twice(u, -2)));

    return interval_add(u, interval_ln1p(interval_divide(over, under)));
}

/* asinh of t0 (e^(2 u) - 1)/(e^u sqrt(1 + t0^2) + sqrt(1 + t^2)), t = e^w/2 */
static struct interval friction_near(struct interval k, struct interval u)
{
    const struct interval t0 = twice(interval_exp(k), 0.5);
    const struct interval e = interval_exp(u), t = interval_times(t0, e);
    const struct interval root0 =
        interval_sqrt(plus(interval_times(t0, t0), 1));
    const struct interval root = interval_sqrt(plus(interval_times(t, t), 1));
    const struct interval under = interval_add(interval_times(e, root0), root);
    const struct interval over =
        interval_times(t0, interval_expm1(twice(u, 2)));

    return interval_asinh(interval_divide(over, under));
}

static struct interval friction_at(struct interval k, long double at)
{
    const struct interval u = interval_point(at);
    const struct interval w = interval_add(k, u);

    if (k.lo > 0.7 && w.lo > 0.7)
        return friction_far(k, u);
    if (fabsl(at) < 1 && k.hi < 300)
        return friction_near(k, u);
    return interval_less(interval_asinh_exp(w), interval_asinh_exp(k));
}

struct interval interval_friction(struct interval k, struct interval u)
{
    return (struct interval){ friction_at(k, u.lo).lo,
                              friction_at(k, u.hi).hi };
}
