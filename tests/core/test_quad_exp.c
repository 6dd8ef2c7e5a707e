/* test_quad_exp.c -- e^x in 113 bits against MPFR's in 256, and where it is
 * glibc's. */
#include <math.h>
#include <mpfr.h>

#include "check.h"
#include "quad.h"

enum { BITS = 256, DIGITS = 113 };

/* Of three doubles, which hold all digits. */
static void set_quad(mpfr_t out, quad x)
{
    mpfr_set_zero(out, 1);
    for (int i = 0; i < 3; i++) {
        mpfr_add_d(out, out, (double) x, MPFR_RNDN);
        x -= (double) x;
    }
}

/* |e^x - truth| in ulps of a quad as large: of |x| < 700, which doubles hold.
 */
static double ulps(quad x)
{
    mpfr_t truth, got;

    mpfr_inits2(BITS, truth, got, (mpfr_ptr) 0);
    set_quad(truth, x);
    mpfr_exp(truth, truth, MPFR_RNDN);
    set_quad(got, expq(x));
    mpfr_sub(got, got, truth, MPFR_RNDN);
    mpfr_mul_2si(got, got, DIGITS - mpfr_get_exp(truth), MPFR_RNDN);
    const double off = fabs(mpfr_get_d(got, MPFR_RNDN));
    mpfr_clears(truth, got, (mpfr_ptr) 0);
    return off;
}

/* All of its 113 digits random. */
static quad any_number(uint64_t *rng, double size)
{
    return ((quad) check_uniform(rng, -1, 1) +
            (quad) check_uniform(rng, -1, 1) * (quad) 0x1p-52 +
            (quad) check_uniform(rng, -1, 1) * (quad) 0x1p-104) *
           (quad) size;
}

static void numbers_are_off_by_half_an_ulp(void **state)
{
    const quad ln2 = logq(2);
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 20000; i++) {
        const double near = pow(10.0, -check_uniform(&rng, 0, 40));
        const quad turns = (quad) (i % 400 - 200) * ln2;
        const quad x[] = { any_number(&rng, 500), any_number(&rng, 2),
                           any_number(&rng, near),
                           turns + any_number(&rng, near) };
        for (int k = 0; k < 4; k++)
            CHECK(ulps(x[k]) <= 0.51, "x = %.17g: %.3f ulps", (double) x[k],
                  ulps(x[k]));
    }
}

/* Beyond what doubles hold, by two steps; as far as 2^13 it is its own. */
static void large_ones_are_glibcs_to_an_ulp(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 20000; i++) {
        const quad x = any_number(&rng, 11300), truth = quad_libm_exp(x);
        CHECK(fabsq(expq(x) - truth) <= truth * (quad) 0x1p-112, "x = %.17g",
              (double) x);
    }
    CHECK(fabsq(logq(expq(-11380)) + 11380) < 1e-12 && expq(0) == 1 &&
              expq(-(quad) 0) == 1 && expq((quad) 1e-4000L) == 1,
          "next to the least, and next to 1");
    CHECK(isinf((double) expq((quad) INFINITY)) && expq(20000) > expq(11000) &&
              expq(-(quad) INFINITY) == 0 && isnan((double) expq((quad) NAN)),
          "special cases");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_are_off_by_half_an_ulp),
        cmocka_unit_test(large_ones_are_glibcs_to_an_ulp),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
