/* Turning points of random polynomials with known ones. */
#include "turning.h"

#include <math.h>

#include "check.h"

enum { DEGREE = 18 };

/* p with p' = scale (theta - root[0]) (theta - root[1]) ... */
static void polynomial_of(size_t roots, const double root[], double scale,
                          double c[])
{
    double slope[JET_SIZE] = { scale };

    for (size_t i = 0; i < roots; i++)
        for (size_t k = i + 2; k-- > 0;)
            slope[k] = (k > 0 ? slope[k - 1] : 0.0) - root[i] * slope[k];
    c[0] = 0.7;
    for (size_t k = 0; k <= roots; k++)
        c[k + 1] = slope[k] / (double) (k + 1);
}

/* From one point to the next p goes one way, but for rounding. */
static void check_monotone(size_t degree, const double c[], double lo,
                           double hi)
{
    const double from = jet_at(degree, c, lo), to = jet_at(degree, c, hi);
    double size = 0.0, last = from;

    for (size_t k = 0; k <= degree; k++)
        size += fabs(c[k]);
    for (int i = 1; i <= 40; i++) {
        const double at = jet_at(degree, c, lo + (hi - lo) * i / 40.0);
        const double back = from < to ? last - at : at - last;
        CHECK(back <= 1e-12 * size, "back by %.2g of %.2g in [%.17g, %.17g]",
              back, size, lo, hi);
        last = at;
    }
}

static void between_its_points_a_polynomial_goes_one_way(void **state)
{
    uint64_t seed = check_seed();

    (void) state;
    for (int i = 0; i < 3000; i++) {
        const size_t roots = 1 + check_bits(&seed) % 8;
        double root[JET_SIZE], c[JET_SIZE], at[TURNING_MAX];
        for (size_t k = 0; k < roots; k++)
            root[k] = check_uniform(&seed, -0.5, 1.5);
        if (roots > 1 && i % 3 == 0) /* beside each other */
            root[1] = root[0] + pow(10.0, check_uniform(&seed, -6, -1));
        polynomial_of(roots, root, check_uniform(&seed, -5, 5), c);
        const size_t n = turning_find(roots + 1, c, at);
        double last = 0.0;
        for (size_t k = 0; k <= n; k++) {
            const double next = k < n ? at[k] : 1.0;
            CHECK(next > last, "point %zu is %.17g", k, next);
            check_monotone(roots + 1, c, last, next);
            last = next;
        }
    }
}

/* One that is alone is found to its last digits. */
static void a_turn_by_itself_is_exact(void **state)
{
    uint64_t seed = check_seed();

    (void) state;
    for (int i = 0; i < 1000; i++) {
        double root[3] = { check_uniform(&seed, 0.01, 0.99),
                           check_uniform(&seed, -3, -1),
                           check_uniform(&seed, 2, 4) };
        double c[JET_SIZE], at[TURNING_MAX];
        polynomial_of(3, root, 1.0, c);
        assert_int_equal(turning_find(4, c, at), 1);
        CHECK(fabs(at[0] - root[0]) < 1e-13, "%.17g, not %.17g", at[0],
              root[0]);
    }
}

static void a_straight_line_never_turns(void **state)
{
    const double line[JET_SIZE] = { 1.0, 3.0 }, level[JET_SIZE] = { 2.0 };
    double at[TURNING_MAX];

    (void) state;
    assert_int_equal(turning_find(DEGREE, line, at), 0);
    assert_int_equal(turning_find(DEGREE, level, at), 0);
    assert_int_equal(turning_find(0, level, at), 0);
}

static void bounds_hold_every_value(void **state)
{
    uint64_t seed = check_seed();

    (void) state;
    for (int i = 0; i < 1000; i++) {
        double c[JET_SIZE], lo = HUGE_VAL, hi = -HUGE_VAL;
        for (size_t k = 0; k <= DEGREE; k++)
            c[k] = check_uniform(&seed, -1, 1) * pow(0.5, (double) k);
        for (int k = 0; k <= 50; k++) {
            const double value = jet_at(DEGREE, c, 0.02 * k);
            lo = fmin(lo, value);
            hi = fmax(hi, value);
        }
        const struct turning_range r = turning_bound(DEGREE, c);
        CHECK(r.lo <= lo + 1e-13 && r.hi >= hi - 1e-13,
              "[%.17g, %.17g] does not hold [%.17g, %.17g]", r.lo, r.hi, lo,
              hi);
        CHECK(r.hi - r.lo < 5.0 * (hi - lo), "%g wide instead of %g",
              r.hi - r.lo, hi - lo);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(between_its_points_a_polynomial_goes_one_way),
        cmocka_unit_test(a_turn_by_itself_is_exact),
        cmocka_unit_test(a_straight_line_never_turns),
        cmocka_unit_test(bounds_hold_every_value),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
