/*
 * test_elementary.c -- e^x, ln x and their kin against 113 bits, in units in
 * the last place, over all that doubles hold; their special cases.
 */
#include <math.h>

#include "check.h"
#include "quad.h"

static uint64_t seed;

/* |got - true| in ulps of a double as large as the true one. */
static double ulps(double got, quad truth)
{
    const double near = (double) fabsq(truth);

    if (isinf(near) || isinf(got))
        return got == (double) truth ? 0.0 : HUGE_VAL;
    const double ulp = nextafter(near, HUGE_VAL) - near;
    return (double) fabsq((quad) got - truth) / ulp;
}

/* A number of either sign, the powers of ten evenly: some near 1, some far. */
static double any_number(double least, double most)
{
    const double size = exp(check_uniform(&seed, log(least), log(most)));

    return check_uniform(&seed, -1.0, 1.0) < 0.0 ? -size : size;
}

static void each_function_holds_its_claim(void **state)
{
    static const struct {
        const char *name;
        double (*ours)(double);
        quad (*truth)(quad);
        double least, most, claim;
    } function[] = {
        { "exp", exp, expq, 1e-20, 708.0, 0.56 },
        { "exp", exp, expq, 708.0, 746.0, 1.01 },
        { "exp", exp, expq, 0.01, 3.0, 0.56 },
        { "expm1", expm1, expm1q, 1e-300, 720.0, 1.2 },
        { "expm1", expm1, expm1q, 0.001, 3.0, 1.2 },
        { "sinh", sinh, sinhq, 1e-300, 711.0, 3.0 },
        { "sinh", sinh, sinhq, 0.01, 3.0, 3.0 },
        { "cosh", cosh, coshq, 1e-20, 711.0, 3.0 },
        { "tanh", tanh, tanhq, 1e-300, 50.0, 3.0 },
        { "asinh", asinh, asinhq, 1e-300, 1e300, 3.0 },
        { "asinh", asinh, asinhq, 0.01, 3.0, 3.0 },
        { "atanh", atanh, atanhq, 1e-300, 0.9999, 3.0 },
        { "log1p", log1p, log1pq, 1e-300, 0.9999, 1.2 },
        { "sin", sin, sinq, 1e-20, 1e3, 0.501 },
        { "cos", cos, cosq, 1e-20, 1e3, 0.501 },
        { "tan", tan, tanq, 1e-20, 1e3, 0.501 },
        { "atan", atan, atanq, 1e-20, 1e20, 0.501 },
    };
    (void) state;

    for (size_t k = 0; k < sizeof function / sizeof *function; k++) {
        double worst = 0.0;

        for (int i = 0; i < 4000; i++) {
            const double x = any_number(function[k].least, function[k].most);
            worst =
                fmax(worst, ulps(function[k].ours(x), function[k].truth(x)));
        }
        print_message("# %-5s worst %.3f ulps\n", function[k].name, worst);
        CHECK(worst <= function[k].claim, "%s: %.3f ulps, claimed %.3f",
              function[k].name, worst, function[k].claim);
    }
}

/* As far as a double is decided by fewer bits, which is then the same; also at
 * those next to multiples of pi/2, by continued fractions. */
static void sines_are_those_rounded_from_113_bits(void **state)
{
    static const double next[] = { 0x1.b951f1572eba5p+23, 0x1.b951f1572eba5p+29,
                                   0x1.55202aefde314p+29,
                                   0x1.e1dcc9111b506p+27 };
    (void) state;

    for (int i = 0; i < 4; i++)
        CHECK(sin(next[i]) == (double) sinq(next[i]) &&
                  cos(next[i]) == (double) cosq(next[i]),
              "x = %a", next[i]);
    for (int i = 0; i < 200000; i++) {
        const double quarter = floor(check_uniform(&seed, -1e3, 1e3)) * M_PI_2,
                     off = any_number(1e-18, 1.0);
        const double x = i % 2 ? quarter + off : any_number(1e-310, 1e12);
        CHECK(sin(x) == (double) sinq(x) && cos(x) == (double) cosq(x),
              "x = %a: sin %a, cos %a", x, sin(x), cos(x));
    }
    CHECK(signbit(sin(-0.0)) && sin(-0.0) == 0.0 && cos(0.0) == 1.0 &&
              isnan(sin(HUGE_VAL)) && isnan(cos(NAN)),
          "special cases");
}

static void logarithms_hold_their_claim(void **state)
{
    double worst = 0.0, ten = 0.0, near = 0.0, plus = 0.0;
    (void) state;

    for (int i = 0; i < 20000; i++) {
        const double x = fabs(any_number(1e-320, 1e308));
        const double one = 1.0 + any_number(1e-16, 0.4);

        worst = fmax(worst, ulps(log(x), logq(x)));
        near = fmax(near, ulps(log(one), logq(one)));
        plus = fmax(plus, ulps(log1p(x), log1pq(x)));
        ten = fmax(ten, ulps(log10(x), log10q(x)));
        ten = fmax(ten, ulps(log10(one), log10q(one)));
    }
    print_message("# log %.3f, near 1 %.3f, log1p %.3f, log10 %.3f ulps\n",
                  worst, near, plus, ten);
    CHECK(worst <= 0.53 && near <= 0.53 && plus <= 1.2 && ten <= 0.53,
          "%.3f %.3f %.3f %.3f", worst, near, plus, ten);
}

static void powers_hold_their_claim(void **state)
{
    double worst = 0.0;
    (void) state;

    for (int i = 0; i < 20000; i++) {
        const double x = fabs(any_number(1e-300, 1e300));
        const double y = any_number(1e-5, 30.0);
        const quad truth = powq(x, y);

        if (truth > (quad) 1e-307 && truth < (quad) 1e308)
            worst = fmax(worst, ulps(pow(x, y), truth));
    }
    print_message("# pow   worst %.3f ulps\n", worst);
    CHECK(worst <= 0.6, "%.3f ulps", worst);
    for (int n = -300; n <= 300; n++) {
        char text[16];

        snprintf(text, sizeof text, "1e%d", n);
        CHECK(ulps(pow(10.0, n), strtod(text, NULL)) <= 1.0, "10^%d", n);
        CHECK(log10(strtod(text, NULL)) == n, "log10 of 10^%d", n);
    }
}

static void special_cases_are_the_c_librarys(void **state)
{
    volatile double none = 0.0;
    const double inf = HUGE_VAL, nan_ = none / none;
    (void) state;

    CHECK(exp(inf) == inf && exp(-inf) == 0.0 && exp(710.0) == inf &&
              exp(-746.0) == 0.0 && isnan(exp(nan_)) && exp(none) == 1.0,
          "exp");
    CHECK(expm1(inf) == inf && expm1(-inf) == -1.0 && isnan(expm1(nan_)) &&
              signbit(expm1(-none)),
          "expm1");
    CHECK(log(none) == -inf && isnan(log(none - 1.0)) && log(inf) == inf &&
              isnan(log(nan_)) && log(none + 1.0) == 0.0,
          "log");
    CHECK(log1p(none - 1.0) == -inf && isnan(log1p(none - 2.0)) &&
              log1p(inf) == inf && isnan(log1p(nan_)),
          "log1p");
    CHECK(pow(none, 2.0) == 0.0 && pow(none - 2.0, 3.0) == -8.0 &&
              isnan(pow(none - 2.0, 0.5)) && pow(nan_, 0.0) == 1.0 &&
              pow(2.0, inf) == inf && pow(2.0, 2000.0) == inf &&
              pow(2.0, -2000.0) == 0.0 && pow(none + 1.0, inf) == 1.0,
          "pow");
    CHECK(sinh(inf) == inf && sinh(-inf) == -inf && isnan(sinh(nan_)) &&
              sinh(710.4) < inf && sinh(711.0) == inf,
          "sinh");
    CHECK(cosh(-inf) == inf && isnan(cosh(nan_)) && tanh(inf) == 1.0 &&
              tanh(-inf) == -1.0 && isnan(tanh(nan_)),
          "cosh, tanh");
    CHECK(asinh(inf) == inf && asinh(-inf) == -inf && isnan(asinh(nan_)) &&
              atanh(none + 1.0) == inf && isnan(atanh(none + 2.0)),
          "asinh, atanh");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_function_holds_its_claim),
        cmocka_unit_test(sines_are_those_rounded_from_113_bits),
        cmocka_unit_test(logarithms_hold_their_claim),
        cmocka_unit_test(powers_hold_their_claim),
        cmocka_unit_test(special_cases_are_the_c_librarys),
    };

    seed = check_seed();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
