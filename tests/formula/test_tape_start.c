/* Formulas from their anchor: every function keeps its digits near, at and far
 * from it; what vanishes at an equilibrium vanishes, and what has no value is
 * refused. */
#include "made_plane.h"

#define ULP 0x1p-53

struct function_case {
    const char *text, *slope;
    double lo, hi; /* of its argument */
};

/* The slopes in other words than the program's. */
static const struct function_case functions_of_x[] = {
    { "exp(x)", "exp(x)", -30, 30 },
    { "sinh(x)", "cosh(x)", -30, 30 },
    { "cosh(x)", "sinh(x)", -30, 30 },
    { "tanh(x)", "1/cosh(x)^2", -30, 30 },
    { "asinh(x)", "1/sqrt(1 + x*x)", -1e3, 1e3 },
    { "sin(x)", "cos(x)", -30, 30 },
    { "cos(x)", "-sin(x)", -30, 30 },
    { "tan(x)", "1/cos(x)^2", -1.5, 1.5 },
    { "atan(x)", "1/(1 + x^2)", -1e3, 1e3 },
    { "asin(x)", "1/sqrt(1 - x^2)", -0.999, 0.999 },
    { "acos(x)", "-1/sqrt(1 - x^2)", -0.999, 0.999 },
    { "sqrt(40 + x)", "1/(2*sqrt(40 + x))", -30, 30 },
    { "ln(40 + x)", "1/(40 + x)", -30, 30 },
    { "log10(40 + x)", "1/(ln(10)*(40 + x))", -30, 30 },
    { "(40 + x)^p", "p*(40 + x)^(p - 1)", -30, 30 },
    { "1/(40 + x)", "-1/(40 + x)^2", -30, 30 },
    { "abs2(x)", "2*x", -30, 30 },
    { "x^3", "3*x^2", -30, 30 },
    { "x^-2", "-2/x^3", 0.01, 30 },
    { "x^7", "7*x^6", -30, 30 },
};

/* A difference of sizes from 1e-12 to the whole range, in doubles. */
static double offset(uint64_t *seed, double lo, double hi, double at)
{
    for (;;) {
        const double size = exp(check_uniform(seed, log(1e-12), log(hi - lo)));
        const double u = check_uniform(seed, 0, 1) < 0.5 ? size : -size;
        if (at + u > lo && at + u < hi)
            return u;
    }
}

/* |f(k + u) - f(k)| is known as well as k, u and f(k + u) are: to so many units
 * of roundoff of what those three do to it. */
static void a_function_from_its_anchor_loses_no_digits(void **state)
{
    const bool real[2] = { false, false };
    uint64_t seed = check_seed();
    const double limit = 10;

    (void) state;
    for (size_t i = 0; i < sizeof functions_of_x / sizeof *functions_of_x;
         i++) {
        const struct function_case *c = &functions_of_x[i];
        double worst = 0;
        char rate[80];
        for (int n = 0; n < 400; n++) {
            const double k = check_uniform(&seed, c->lo, c->hi),
                         u = offset(&seed, c->lo, c->hi, k);
            const quad at[2] = { k, 0 };
            snprintf(rate, sizeof rate, "%s - 3", c->text); /* f(k) is 3 */
            make((const char *const[]){ rate, "-y" }, real, NULL, true, at);
            const struct planar s = tape_planar(&plane);
            struct planar_field f;
            s.field(s.ctx, (struct vec2){ u, 0.0 }, &f);
            const double found = f.direction.x * exp(f.log_scale);
            const quad w = (quad) k + u, d0 = plain(c->slope, k, 0),
                       d = plain(c->slope, w, 0);
            const quad f0 = plain(c->text, k, 0),
                       exact = plain(c->text, w, 0) - f0;
            /* and the plain difference to its own roundoff */
            const double size =
                (double) (fabsq(exact) + fabsq(u * d) + fabsq(k * (d - d0)) +
                          fabsq(f0) * (quad) 0x1p-57);
            const double error = (double) fabsq(found - exact) / (ULP * size);
            worst = error > worst ? error : worst;
            CHECK(error <= limit, "%s: %.3g units, k = %.17g, u = %.17g",
                  c->text, error, k, u);
        }
        print_message("%s: %.2g units of roundoff\n", c->text, worst);
    }
}

static void rates_vanish_at_an_equilibrium_that_is_no_double(void **state)
{
    const bool positive[2] = { true, true };
    const quad x = sqrtq(2), at[2] = { logq(x), logq(x) / 2 };
    struct planar_field f;

    (void) state;
    make((const char *const[]){ "x^2 - 2", "x - y^2" }, positive, NULL, true,
         at);
    const struct planar s = tape_planar(&plane);
    s.field(s.ctx, (struct vec2){ 0, 0 }, &f);
    assert_true(f.direction.x == 0.0 && f.direction.y == 0.0);
    s.field(s.ctx, (struct vec2){ 1e-200, 0 }, &f);
    const double found = f.direction.x * exp(f.log_scale);
    CHECK(fabs(found / (2 * 1.4142135623730951e-200) - 1) < 1e-14, "%g", found);
}

/* Differences of two products, alone and under a sinh, too. */
static void differences_vanish_at_an_equilibrium_in_113_bits(void **state)
{
    static const char *const rate[] = { "y - 1/x", "-sinh(y - 1/x)/x",
                                        "(x - 2*y)*exp(y)", "ln(x*y)*x" };
    const bool positive[2] = { true, true };
    const quad x = sqrtq(2), at[2] = { logq(x), -logq(x) };

    (void) state;
    for (size_t i = 0; i < sizeof rate / sizeof *rate; i++) {
        struct planar_field f;
        make((const char *const[]){ "x^2 - 2", rate[i] }, positive, NULL, true,
             at);
        tape_field(&plane, (struct vec2){ 0, 0 }, &f);
        CHECK(f.direction.x == 0.0 && f.direction.y == 0.0, "%s: %g %g",
              rate[i], f.direction.x, f.direction.y);
        tape_field(&plane, (struct vec2){ 0, 1e-200 }, &f);
        CHECK(f.direction.y != 0.0, "%s", rate[i]);
    }
}

static void what_has_no_value_at_the_anchor_is_refused(void **state)
{
    const bool real[2] = { false, false };
    const quad at[2] = { -1, 0 };
    struct fault why = { "" };

    (void) state;
    assert_int_equal(
        lower((const char *const[]){ "ln(x)", "-y" }, real, NULL, false, &why),
        STATUS_OK);
    assert_int_equal(tape_plane_at(&lowered, parameters, at, &plane, &why),
                     STATUS_BAD_ARGUMENT);
    assert_non_null(strstr(why.text, "no finite value"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_function_from_its_anchor_loses_no_digits),
        cmocka_unit_test(rates_vanish_at_an_equilibrium_that_is_no_double),
        cmocka_unit_test(differences_vanish_at_an_equilibrium_in_113_bits),
        cmocka_unit_test(what_has_no_value_at_the_anchor_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
