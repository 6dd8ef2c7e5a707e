/* Slopes and rates in closed form against differences in 113 bits. */
#include "response.h"

#include <float.h>

#include "check.h"
#include "laws.h"
#include "plain.h"
#include "steady.h"

/* dpsi/dt as it is printed, near steady state. */
static quad evolution(const struct law *law, const struct material *m, quad x,
                      quad psi)
{
    const quad v = expq(x);

    if (law->kinetics == KINETICS_COMPOSITE)
        return expq(-v / (quad) m->V_c) - v * psi * logq(v * psi);
    const quad d = psi - plain_psi_ss(law, m, x);
    return -(law->kinetics == KINETICS_SINH ? sinhq(d) : d) *
           expq(-plain_log_T(law, m, x));
}

/* Differences over h leave h^2 of the value or so. */
static const quad h = (quad) 1e-10;

struct exact {
    quad slope, direct, rate;
};

static struct exact exact_at(const struct law *law, const struct material *m,
                             quad x)
{
    const quad psi = plain_psi_ss(law, m, x);
    const quad step = h * (fabsq(psi) < 1 ? fabsq(psi) : 1);
    const quad near = h * (fabsq(x) < 1 ? fabsq(x) : 1); /* -ln v may be psi */

    return (struct exact){
        .slope =
            (plain_mu_ss(law, m, x + near) - plain_mu_ss(law, m, x - near)) /
            (2 * near),
        .direct =
            (plain_mu(law, m, x + h, psi) - plain_mu(law, m, x - h, psi)) /
            (2 * h),
        .rate = -(evolution(law, m, x, psi + step) -
                  evolution(law, m, x, psi - step)) /
                (2 * step),
    };
}

static void check_one(size_t i, const struct law *law, const struct material *m,
                      double x)
{
    const struct response r = response_at(law, m, (long double) x);
    const struct exact e = exact_at(law, m, (quad) x);
    const double off = (double) fabsq(r.slope - e.slope);
    const double eps = 8 * (double) LDBL_EPSILON * (10 + fabs(x) / m->a);

    CHECK(off <= (double) r.slope_error * (1 + fabs(x) / m->a) +
                     (double) fabsq(e.direct) * 1e-17,
          "law %zu x = %g: slope %Lg is off by %g, bound %Lg", i, x, r.slope,
          off, r.slope_error);
    CHECK(fabsq(r.direct / e.direct - 1) <= eps + 1e-17,
          "law %zu x = %g: direct effect %Lg, not %Lg", i, x, r.direct,
          (long double) e.direct);
    CHECK(r.rate == 0 ||
              fabsq(r.rate / e.rate - 1) <= (quad) r.rate_error + 1e-17,
          "law %zu x = %g: rate %Lg, not %Lg", i, x, r.rate,
          (long double) e.rate);
}

static void slopes_and_rates_are_those_of_the_printed_law(void **state)
{
    uint64_t seed = check_seed();
    struct law law;
    struct material m;

    (void) state;
    if (laws_emulated())
        return;
    for (size_t i = 0; i < LAWS * 20; i++) {
        if (!laws_draw(i % LAWS, &seed, &law, &m))
            continue;
        const double x = check_uniform(&seed, -12, 12);
        if ((long double) x >= steady_x_max(&law) || fabs(x) < 1e-3)
            continue;
        check_one(i % LAWS, &law, &m, x);
    }
}

/* By hand: slope a - b, direct effect a, rate v. */
static void dieterich_falls_by_b_minus_a(void **state)
{
    struct law law = *law_preset_find("dieterich");
    const struct material m = material_bristol_board();

    (void) state;
    law.form = FRICTION_LOG;
    for (int x = -20; x <= 20; x += 5) {
        const struct response r = response_at(&law, &m, x);
        CHECK(fabsl(r.slope - ((long double) m.a - m.b)) <=
                  m.a * 1e2L * laws_long_epsilon(),
              "x = %d: slope %Lg", x, r.slope);
        CHECK(r.direct == m.a && fabsl(r.rate / expl(x) - 1) < 1e-14L,
              "x = %d: %Lg, %Lg", x, r.direct, r.rate);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slopes_and_rates_are_those_of_the_printed_law),
        cmocka_unit_test(dieterich_falls_by_b_minus_a),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
