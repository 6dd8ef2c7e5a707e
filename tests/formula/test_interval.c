/* Formulas over boxes: whatever they are inside, it is enclosed, and not by
 * much more. */
#include "interval.h"

#include <math.h>
#include <string.h>

#include "quad.h"
#include "typed.h"

static struct interval_plan plan;
static formula_real value[FORMULA_NODES];
static int variable[2];

static int open_graph(void **state)
{
    (void) state;
    formula_init(&f);
    variable[0] = formula_leaf(&f, "x", FORMULA_STATE);
    variable[1] = formula_leaf(&f, "y", FORMULA_STATE);
    value[formula_leaf(&f, "a", FORMULA_PARAMETER)] = (formula_real) 3 / 10;
    return 0;
}

static void make_plan(const char *text)
{
    const int result[] = { parsed(text) };
    struct fault why;

    CHECK(interval_plan(&plan, &f, variable, result, 1, value, &why) ==
              STATUS_OK,
          "%s: %s", text, why.text);
}

static const char *const formulas[] = { "x + y",
                                        "x - a*y",
                                        "x*y",
                                        "x*x",
                                        "x/y",
                                        "1/(x*y)",
                                        "exp(x)",
                                        "ln(x)",
                                        "sqrt(x + y)",
                                        "sinh(x*y)",
                                        "cosh(x - y)",
                                        "tanh(3*x)",
                                        "asinh(10*x)",
                                        "sin(5*x + y)",
                                        "cos(x*y)",
                                        "tan(x/2)",
                                        "asin(x/9)",
                                        "acos(y/9)",
                                        "atan(x - y)",
                                        "x^3",
                                        "y^-2",
                                        "x^a",
                                        "(x + y)^7",
                                        "y^12",
                                        "2^x",
                                        "x^y",
                                        "log10(x)",
                                        "abs2(x - y)",
                                        "x*exp(-y)/(a + exp(-y))",
                                        "cosh(3 - x)^a",
                                        "sin(x)^2 + cos(x)^2",
                                        "(x + 1/3)*(x - 1/3) - x*x",
                                        NULL };

static formula_real between(uint64_t *seed, struct interval_double u)
{
    const double t = check_uniform(seed, 0, 1);

    return t < 0.1 ? u.lo : t > 0.9 ? u.hi : u.lo + t * (u.hi - u.lo);
}

static bool is_in(formula_real x, struct interval_double u)
{
    return u.lo <= x && x <= u.hi;
}

/* What 113 bits find at points of a box is in what doubles say of the box, and
 * so are differences over what moved, between two of them. */
static void whatever_is_in_a_box_is_enclosed(void **state)
{
    uint64_t seed = check_seed();

    (void) state;
    for (int i = 0; formulas[i]; i++) {
        open_graph(NULL);
        make_plan(formulas[i]);
        for (int run = 0; run < 400; run++) {
            struct interval_double box[2];
            struct interval_slope_double over;
            for (int k = 0; k < 2; k++) {
                const double size = exp(check_uniform(&seed, -35, 0.5));
                box[k].lo = check_uniform(&seed, 0.1, 4);
                box[k].hi = box[k].lo + size;
            }
            if (interval_over_double(&plan, box, &over) != INTERVAL_WHOLE)
                continue;
            struct interval_quad at[2];
            struct interval_slope_quad here;
            for (int k = 0; k < 2; k++)
                at[k].lo = at[k].hi = between(&seed, box[k]);
            assert_int_equal(interval_over_quad(&plan, at, &here),
                             INTERVAL_WHOLE);
            CHECK(is_in(here.value.lo, over.value) &&
                      is_in(here.value.hi, over.value),
                  "%s: %.20g is not in %.20g ... %.20g", formulas[i],
                  (double) here.value.lo, over.value.lo, over.value.hi);
            for (int k = 0; k < 2; k++)
                CHECK(is_in(here.by[k].lo, over.by[k]) &&
                          is_in(here.by[k].hi, over.by[k]),
                      "%s by %d: %.20g is not in %.20g ... %.20g", formulas[i],
                      k, (double) here.by[k].lo, over.by[k].lo, over.by[k].hi);
        }
    }
}

/* Slopes are those of differences, 113 bits against h = 2^-35. */
static void slopes_are_those_of_differences(void **state)
{
    uint64_t seed = check_seed();

    (void) state;
    for (int i = 0; formulas[i]; i++) {
        open_graph(NULL);
        make_plan(formulas[i]);
        for (int run = 0; run < 20; run++) {
            struct interval_quad at[2];
            struct interval_slope_quad here, side[2];
            for (int k = 0; k < 2; k++)
                at[k].lo = at[k].hi = check_uniform(&seed, 0.2, 2.5);
            assert_int_equal(interval_over_quad(&plan, at, &here),
                             INTERVAL_WHOLE);
            for (int k = 0; k < 2; k++) {
                for (int j = 0; j < 2; j++) {
                    struct interval_quad off[2] = { at[0], at[1] };
                    off[k].lo = off[k].hi += j ? 0x1p-35 : -0x1p-35;
                    interval_over_quad(&plan, off, &side[j]);
                }
                const formula_real slope =
                    (side[1].value.lo - side[0].value.lo) * 0x1p34;
                const double error = (double) (slope - here.by[k].lo);
                const double size =
                    1 + fabs((double) here.value.lo) + fabs((double) slope);
                CHECK(fabs(error) < 1e-12 * pow(size, 4), "%s by %d: %g of %g",
                      formulas[i], k, error, (double) slope);
                CHECK(here.by[k].hi - here.by[k].lo < 1e-28 * pow(size, 4),
                      "%s by %d", formulas[i], k);
            }
        }
    }
}

/* 113 bits, told from the compiler's own arithmetic. */
static void a_point_is_enclosed_to_all_digits(void **state)
{
    const formula_real x = (formula_real) 7 / 11, y = (formula_real) 5 / 13;
    const struct interval_quad at[2] = { { x, x }, { y, y } };
    struct interval_slope_quad here;

    (void) state;
    open_graph(NULL);
    make_plan("x*exp(-y)/(a + ln(1 + x)) + sin(x*y)^2");
    interval_over_quad(&plan, at, &here);
    const formula_real s = sinq(x * y);
    const formula_real truth =
        x * expq(-y) / ((formula_real) 3 / 10 + log1pq(x)) + s * s;
    assert_true(fabsq(here.value.lo - truth) < 1e-32);
    assert_true(fabsq(here.value.hi - truth) < 1e-32);
    assert_true(here.value.hi - here.value.lo < 1e-32);
}

static enum interval_domain domain_of(const char *text, double x0, double x1)
{
    const struct interval_double box[2] = { { x0, x1 }, { 1, 2 } };
    struct interval_slope_double over;

    open_graph(NULL);
    make_plan(text);
    return interval_over_double(&plan, box, &over);
}

static void where_it_is_not_defined_is_told(void **state)
{
    (void) state;
    assert_int_equal(domain_of("ln(x)", -1, 1), INTERVAL_PARTLY);
    assert_int_equal(domain_of("ln(x)", -2, -1), INTERVAL_NOWHERE);
    assert_int_equal(domain_of("ln(x)", 1, 2), INTERVAL_WHOLE);
    assert_int_equal(domain_of("1/x", -1, 1), INTERVAL_PARTLY);
    assert_int_equal(domain_of("x^-2", -1, 1), INTERVAL_PARTLY);
    assert_int_equal(domain_of("x^-2", 1, 2), INTERVAL_WHOLE);
    assert_int_equal(domain_of("x^a", -1, 1), INTERVAL_PARTLY);
    assert_int_equal(domain_of("tan(x)", 1, 2), INTERVAL_PARTLY);
    assert_int_equal(domain_of("tan(x)", 2, 4), INTERVAL_WHOLE);
    assert_int_equal(domain_of("asin(x)", 0.5, 2), INTERVAL_PARTLY);
    assert_int_equal(domain_of("acos(x)", 2, 3), INTERVAL_NOWHERE);
    assert_int_equal(domain_of("sqrt(x - y)", 0, 1.5), INTERVAL_PARTLY);
}

/* Ends that overflow are infinite upward and finite inward. */
static void nothing_is_lost_where_numbers_overflow(void **state)
{
    const struct interval_double box[2] = { { 0, 1000 }, { -1000, 1000 } };
    struct interval_slope_double over;

    (void) state;
    open_graph(NULL);
    make_plan("exp(x)*exp(y)");
    assert_int_equal(interval_over_double(&plan, box, &over), INTERVAL_WHOLE);
    assert_true(over.value.lo <= 1e-300 && isinf(over.value.hi));
    make_plan("exp(x + 800)");
    assert_int_equal(interval_over_double(&plan, box, &over), INTERVAL_WHOLE);
    assert_true(isfinite(over.value.lo) && isinf(over.value.hi));
    make_plan("exp(x) - exp(x)*a");
    assert_int_equal(interval_over_double(&plan, box, &over), INTERVAL_WHOLE);
    assert_true(isinf(over.value.lo) && isinf(over.value.hi));
    make_plan("1/exp(x)");
    assert_int_equal(interval_over_double(&plan, box, &over), INTERVAL_WHOLE);
    assert_true(over.value.lo == 0 && over.value.hi < 1.001);
}

static void constants_that_are_none_are_refused(void **state)
{
    static const char *const text[][2] = {
        { "x + ln(a - 1)", "ln of a constant is not defined" },
        { "x + 1/(a - 3/10)", "a quotient of a constant is not defined" },
    };
    struct fault why;

    (void) state;
    for (int i = 0; i < 2; i++) {
        open_graph(NULL);
        const int result[] = { parsed(text[i][0]) };
        assert_int_equal(
            interval_plan(&plan, &f, variable, result, 1, value, &why),
            STATUS_BAD_ARGUMENT);
        assert_string_equal(why.text, text[i][1]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(whatever_is_in_a_box_is_enclosed),
        cmocka_unit_test(slopes_are_those_of_differences),
        cmocka_unit_test(a_point_is_enclosed_to_all_digits),
        cmocka_unit_test(where_it_is_not_defined_is_told),
        cmocka_unit_test(nothing_is_lost_where_numbers_overflow),
        cmocka_unit_test(constants_that_are_none_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
