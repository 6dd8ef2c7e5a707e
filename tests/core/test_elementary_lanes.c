/* Lanes of elementary functions have the bits of the plain ones. */
#define JET_LANES 8
#pragma GCC diagnostic ignored "-Wpsabi" /* nobody passes a pair around */
#include "elementary_lanes.h"

#include <string.h>

#include "check.h"

static uint64_t seed;

/* A number of either sign up to `most`, the powers of ten evenly; 0, -0. */
static double any_number(double most)
{
    const double size = exp(check_uniform(&seed, log(1e-320), log(most)));
    const double kind = check_uniform(&seed, -1.0, 1.0);

    return fabs(kind) < 0.01 ? copysign(0.0, kind) : copysign(size, kind);
}

static jet_pair any_pair(double most, double above)
{
    jet_pair x;

    for (int l = 0; l < JET_LANES; l++)
        do
            x[l] = any_number(most);
        while (!(x[l] > above));
    return x;
}

static void check_lane(const char *name, double x, double got, double plain)
{
    CHECK(memcmp(&got, &plain, sizeof got) == 0, "%s of %a: %a, not %a", name,
          x, got, plain);
}

static void exponentials_are_the_plain_ones(void **state)
{
    (void) state;
    for (int i = 0; i < 20000; i++) {
        const jet_pair x = any_pair(i % 2 ? 3.0 : 699.0, -HUGE_VAL);
        jet_pair power;
        const jet_pair e = each_exp(x), less = each_less_one(x, &power);
        for (int l = 0; l < JET_LANES; l++) {
            const bool far = fabs(x[l]) > 1.0;
            const double more = expm1(x[l]);
            check_lane("exp", x[l], e[l], exp(x[l]));
            check_lane("less one", x[l], less[l], far ? exp(x[l]) - 1 : more);
            check_lane("power", x[l], power[l], far ? exp(x[l]) : 1 + more);
        }
    }
}

static void logarithms_are_the_plain_ones(void **state)
{
    (void) state;
    for (int i = 0; i < 20000; i++) {
        const jet_pair x = any_pair(i % 2 ? 2.0 : 1e300, -1.0);
        const jet_pair u = any_pair(i % 2 ? 2.0 : 1e300, 1e-300);
        const jet_pair one = each_log1p(x), near = each_ln(each_all(), x),
                       far = each_ln(~each_all(), u);
        for (int l = 0; l < JET_LANES; l++) {
            check_lane("log1p", x[l], one[l], log1p(x[l]));
            check_lane("ln1p", x[l], near[l],
                       x[l] > 1 ? log(1 + x[l]) : log1p(x[l]));
            check_lane("log", u[l], far[l], log(u[l]));
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exponentials_are_the_plain_ones),
        cmocka_unit_test(logarithms_are_the_plain_ones),
    };

    seed = check_seed();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
