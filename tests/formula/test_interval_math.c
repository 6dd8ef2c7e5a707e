/* Functions of intervals against 113 bits, at random points of random boxes. */
#include "interval_math.h"

#include <float.h>
#include <mpfr.h>

#include "check.h"
#include "quad.h"

#define SCALAR formula_real
#define FN(f)  f##q
#include "scalar.h"
#undef SCALAR
#undef FN

enum { POINTS = 20000 };

struct sample {
    struct interval u, k;
    formula_real x;
    uint64_t *rng;
};

/* A box of any width around a point of any size, and a point in it. */
static struct sample draw(uint64_t *rng, double most)
{
    struct sample s = { .rng = rng };
    const double size = most * pow(10, check_uniform(rng, -12, 0));
    const double at = size * check_uniform(rng, -1, 1);
    const double width =
        check_bits(rng) % 3 ? size * pow(10, check_uniform(rng, -16, 0)) : 0;

    s.u = (struct interval){ at, at + width };
    s.x = s.u.lo + ((formula_real) s.u.hi - s.u.lo) *
                       (formula_real) check_uniform(rng, 0, 1);
    return s;
}

static void inside(const char *name, const struct sample *s,
                   struct interval found, formula_real truth)
{
    /* 113 bits are right to 100 or so */
    const formula_real room = fabsq(truth) * 0x1p-95L;

    CHECK(found.lo <= truth + room && truth - room <= found.hi,
          "%s over [%.20Lg, %.20Lg]: [%.20Lg, %.20Lg] has no %.17g", name,
          s->u.lo, s->u.hi, found.lo, found.hi, (double) truth);
}

static void a_function_over_a_box_holds_its_value_at_every_point(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < POINTS; i++) {
        struct sample s = draw(&rng, 600);
        inside("exp", &s, interval_exp(s.u), expq(s.x));
        inside("expm1", &s, interval_expm1(s.u), expm1q(s.x));
        inside("sinh", &s, interval_sinh(s.u), sinhq(s.x));
        inside("asinh", &s, interval_asinh(s.u), asinhq(s.x));
        inside("asinh_exp", &s, interval_asinh_exp(s.u), scalar_asinh_exp(s.x));
        s.u.lo = fabsl(s.u.lo);
        s.u.hi = fmaxl(fabsl(s.u.hi), s.u.lo);
        s.x = s.u.lo + (s.u.hi - (formula_real) s.u.lo) / 3;
        inside("ln", &s, interval_ln(s.u), logq(s.x));
        inside("ln1p", &s, interval_ln1p(s.u), log1pq(s.x));
        inside("sqrt", &s, interval_sqrt(s.u), sqrtq(s.x));
    }
}

static void a_difference_over_a_box_holds_its_value_at_every_point(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < POINTS; i++) {
        const struct sample s = draw(&rng, 300);
        const double k = pow(10, check_uniform(&rng, -18, 0));
        const formula_real q = 1 - (formula_real) k;
        const struct interval K = interval_point(k);
        const struct interval Q = interval_less(interval_point(1), K);
        const double w = check_uniform(&rng, -30, 30);
        inside("mixed", &s, interval_mixed(K, Q, s.u),
               scalar_log1p_expm1(k, q, s.x));
        inside("mixed slope", &s, interval_mixed_slope(K, Q, s.u),
               scalar_logistic(k, q, s.x));
        inside("friction", &s, interval_friction(interval_point(w), s.u),
               scalar_friction(w, 4 * expq(-2 * (formula_real) w), s.x));
    }
}

/* Any mantissa; sizes from 2^-low to 2^high. */
static long double any(uint64_t *rng, int low, int high)
{
    const long double part = (long double) (check_bits(rng) | 1ull << 63);
    const int size = (int) check_uniform(rng, -low, high) - 63;

    return ldexpl(check_bits(rng) % 2 ? part : -part, size);
}

/* Beside halves of ln 2, where e^x is reduced by another multiple, beside what
 * is rare, or any. */
static long double argument(uint64_t *rng)
{
    static const long double ends[] = { 0.35L, 0.5L, 1, 2, 11000, 0x1p15800L };
    const long double sign = check_bits(rng) % 2 ? 1 : -1;

    switch (check_bits(rng) % 4) {
        case 0:
            return sign * ((double) (check_bits(rng) % 31744) * 0.5L *
                               0xb.17217f7d1cf79acp-4L +
                           any(rng, 70, 0));
        case 1:
            return sign * ends[check_bits(rng) % 6] * (1 + any(rng, 70, 1));
        case 2:
            return sign * expm1l(any(rng, 70, 8));
        default:
            return any(rng, 16440, 16383);
    }
}

static bool is_usual(long double x)
{
    return fabsl(x) < 0x1p15799L && fabsl(x) > 0x1p-15799L;
}

/* The ends are not beyond MPFR's, which are correctly rounded, but for a few
 * units; an infinite one says nothing. */
static void beside(const char *name, long double x, struct interval found,
                   int (*f)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t))
{
    static const mpfr_rnd_t to[] = { MPFR_RNDD, MPFR_RNDU };
    long double of[2];

    for (int i = 0; i < 2; i++) {
        MPFR_DECL_INIT(t, 64);
        mpfr_set_ld(t, x, MPFR_RNDN);
        f(t, t, to[i]);
        of[i] = mpfr_get_ld(t, to[i]);
    }
    const long double room = 16 * LDBL_EPSILON * fabsl(of[0]) + 0x1p-16400L;
    CHECK(found.lo <= of[0] && of[1] <= found.hi,
          "%s(%La): [%La, %La] has not all of [%La, %La]", name, x, found.lo,
          found.hi, of[0], of[1]);
    CHECK(!(is_usual(x) && is_usual(of[0])) ||
              (of[0] - found.lo <= room && found.hi - of[1] <= room),
          "%s(%La): [%La, %La], and not [%La, %La]", name, x, found.lo,
          found.hi, of[0], of[1]);
}

static void ends_are_beside_what_is_correctly_rounded(void **state)
{
    const char *asked = getenv("ARGUMENTS"); /* a million takes a minute */
    const long count = asked ? atol(asked) : 4 * POINTS;
    uint64_t rng = check_seed();

    (void) state;
    for (long i = 0; i < count; i++) {
        const long double x = argument(&rng), size = fabsl(x);
        const struct interval u = interval_point(x);
        beside("exp", x, interval_exp(u), mpfr_exp);
        beside("expm1", x, interval_expm1(u), mpfr_expm1);
        beside("ln", size, interval_ln(interval_point(size)), mpfr_log);
        if (x > -1)
            beside("ln1p", x, interval_ln1p(u), mpfr_log1p);
    }
}

static void what_is_0_or_1_is_exact(void **state)
{
    const struct interval zero = interval_point(0), one = interval_point(1);
    const struct interval of[] = {
        interval_expm1(zero), interval_ln1p(zero),
        interval_ln(one),     interval_sinh(zero),
        interval_asinh(zero), interval_less(interval_exp(zero), one)
    };

    (void) state;
    for (size_t i = 0; i < sizeof of / sizeof *of; i++)
        CHECK(of[i].lo >= 0 && of[i].hi <= 0, "%zu: [%La, %La]", i, of[i].lo,
              of[i].hi);
}

/* Sums and products of doubles are exact in 113 bits, and so is what a quotient
 * gives times the divisor. */
static void arithmetic_holds_what_is_exact_and_hardly_more(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < POINTS; i++) {
        const double a = check_uniform(&rng, -1, 1);
        const double b = check_uniform(&rng, 0, 1) *
                         pow(2, (double) (check_bits(&rng) % 50) - 25);
        const struct interval u = interval_point(a), w = interval_point(b);
        const formula_real x = a, y = b;
        const struct interval of[] = { interval_add(u, w), interval_times(u, w),
                                       interval_divide(u, w) };
        const formula_real exact[] = { x + y, x * y, x }, by[] = { 1, 1, y };
        static const double units[] = { 1, 2, 8 }; /* 1/w is rounded, too */
        for (int k = 0; k < 3; k++) {
            CHECK(of[k].lo * by[k] <= exact[k] && exact[k] <= of[k].hi * by[k],
                  "%d of %.17g and %.17g", k, a, b);
            CHECK(of[k].hi - of[k].lo <=
                      units[k] * LDBL_EPSILON * interval_most(of[k]),
                  "%d of %.17g and %.17g: %Lg wide", k, a, b,
                  of[k].hi - of[k].lo);
        }
    }
}

/* ---- sums of products ---------------------------------------------------- */

/* Of any size, and the corner of a box or a point in it: 1, one end; -1, the
 * other one. */
static formula_real draw_factor(uint64_t *rng, double size, int corner,
                                struct interval *u)
{
    const long double at =
        check_uniform(rng, -1, 1) * powl(10, size + check_uniform(rng, -3, 3));
    const long double width =
        check_bits(rng) % 3 ? fabsl(at) * powl(10, check_uniform(rng, -20, 0.5))
                            : 0;

    *u = (struct interval){ at, at + width };
    if (check_bits(rng) % 16 == 0)
        *u = interval_point(0);
    if (corner)
        return corner > 0 ? u->hi : u->lo;
    return u->lo + ((formula_real) u->hi - u->lo) *
                       (formula_real) check_uniform(rng, 0, 1);
}

static void a_sum_of_products_holds_it_and_is_hardly_wider(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < POINTS; i++) {
        const size_t n = 1 + check_bits(&rng) % (JET_SIZE - 1);
        const int rise = (int) (check_bits(&rng) % 2);
        const int corner = (int) (check_bits(&rng) % 3) - 1;
        const double far = check_bits(&rng) % 4 ? 3 : 500;
        const double a = check_uniform(&rng, -far, far),
                     b = check_uniform(&rng, -far, far);
        struct interval u[JET_SIZE], w[JET_SIZE];
        formula_real x[JET_SIZE], sum = 0, sizes = 0, halves = 0;
        for (size_t k = 0; k < n; k++)
            x[k] = draw_factor(&rng, a, corner, &u[k]);
        for (size_t k = n; k-- > 0;) {
            const formula_real y = draw_factor(&rng, b, corner, &w[k]);
            const formula_real by = 1 + rise * (formula_real) (n - 1 - k);
            const struct interval v = u[n - 1 - k];
            const long double m = interval_most(v);
            const long double l = interval_most(w[k]);
            sum += by * x[n - 1 - k] * y;
            sizes += by * (formula_real) m * l;
            halves += by * (m * ((formula_real) w[k].hi - w[k].lo) +
                            l * ((formula_real) v.hi - v.lo));
        }
        const struct interval_row of_u = interval_row_of(u, n - 1);
        const struct interval_row of_w = interval_row_of(w, n - 1);
        const struct interval found =
            interval_sum(n, rise, &of_u, 0, &of_w, n - 1, 3);
        const formula_real room = sizes * 0x1p-104L;
        CHECK(found.lo * 3 <= sum + room && sum - room <= found.hi * 3,
              "%zu, %d of 1e%g, 1e%g: [%.20Lg, %.20Lg] has no %.20Lg", n, rise,
              a, b, found.lo, found.hi, (long double) (sum / 3));
        CHECK(3 * (found.hi - found.lo) <= 3 * halves + sizes * 0x1p-57L,
              "%zu, %d of 1e%g, 1e%g: [%.20Lg, %.20Lg] of %.3Lg", n, rise, a, b,
              found.lo, found.hi, (long double) halves);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_function_over_a_box_holds_its_value_at_every_point),
        cmocka_unit_test(
            a_difference_over_a_box_holds_its_value_at_every_point),
        cmocka_unit_test(ends_are_beside_what_is_correctly_rounded),
        cmocka_unit_test(what_is_0_or_1_is_exact),
        cmocka_unit_test(a_sum_of_products_holds_it_and_is_hardly_wider),
        cmocka_unit_test(arithmetic_holds_what_is_exact_and_hardly_more),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
