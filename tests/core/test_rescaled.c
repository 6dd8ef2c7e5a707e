#include "rescaled.h"

#include <math.h>

#include "check.h"
#include "fields_of.h"

static void right_hand_side(const struct rescaled *r, struct vec2 z,
                            double du[])
{
    const struct cascade c = rescaled_cascade(r);

    assert_int_equal(c.dim, 3 + r->observables);
    c.plane(c.ctx, z, du);
    c.integrals(c.ctx, z, du);
}

/* Against central differences, from fields far below kappa to far above. */
static void gradients_are_those_of_the_right_hand_side(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 2000; i++) {
        const struct fixture x = { i % 2 ? stream : pol,
                                   { i % 2 ? check_uniform(&rng, -1, 1) : 0.3,
                                     check_uniform(&rng, -1, 1),
                                     check_uniform(&rng, -20, 20), 0.7 } };
        const struct planar sys = planar_of(&x, 10.0);
        const struct rescaled r = { &sys, exp(check_uniform(&rng, -5, 5)), 1 };
        const struct vec2 z = { check_uniform(&rng, -2, 2),
                                check_uniform(&rng, -2, 2) };
        const double h = 1e-5;
        struct cascade_linear l;
        double plus[4], minus[4], at[4];
        rescaled_linear(&r, z, &l);
        right_hand_side(&r, z, at);
        for (int way = 0; way < 2; way++) {
            const struct vec2 d = { way ? 0.0 : h, way ? h : 0.0 };
            right_hand_side(&r, vec2_add(z, d), plus);
            right_hand_side(&r, vec2_sub(z, d), minus);
            for (size_t k = 0; k < 4; k++) {
                const double ref = (plus[k] - minus[k]) / (2.0 * h);
                const double slope = way ? l.slope[k].y : l.slope[k].x;
                const double scale = k < 2 ? 1.0 : fabs(l.du[2]) + fabs(at[k]);
                CHECK(at[k] == l.du[k] || fabs(at[k] - l.du[k]) < 1e-15 * scale,
                      "component %zu: %g, %g", k, at[k], l.du[k]);
                CHECK(fabs(slope - ref) <= 3e-5 * scale,
                      "component %zu, way %d: %g, differences %g, scale %g", k,
                      way, slope, ref, scale);
            }
        }
    }
}

/* dz/dt = f, whatever the clock; |dz/dtau| <= 1. */
static void ratios_are_those_of_the_field(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 2000; i++) {
        const struct fixture x = { stream,
                                   { check_uniform(&rng, -1, 1),
                                     check_uniform(&rng, -1, 1),
                                     check_uniform(&rng, -300, 300), 1.0 } };
        const struct planar sys = planar_of(&x, 10.0);
        const double kappa = exp(check_uniform(&rng, -50, 50));
        const struct rescaled r = { &sys, kappa, 1 };
        const struct vec2 z = { check_uniform(&rng, -2, 2), 0.0 };
        const double scale = exp(x.p[2] + z.x);
        double du[4];
        right_hand_side(&r, z, du);
        CHECK(hypot(du[0], du[1]) <= 1.0 + 1e-15, "speed");
        CHECK(fabs(du[0] - x.p[0] * scale * du[2]) <= 1e-12 * fabs(du[0]) &&
                  fabs(du[1] - x.p[1] * scale * du[2]) <= 1e-12 * fabs(du[1]),
              "f = %g (%g, %g), got (%g, %g) in %g", scale, x.p[0], x.p[1],
              du[0], du[1], du[2]);
        CHECK(fabs(du[3] - z.x * du[2]) <= 1e-15 * fabs(du[3]), "rate");
        const double n = hypot(kappa, hypot(du[0], du[1]) / du[2]);
        CHECK(fabs(du[2] * n - 1.0) < 1e-12, "clock off by %g",
              du[2] * n - 1.0);
    }
}

static void scales_beyond_every_double_give_finite_rates(void **state)
{
    const double scale[] = { -1e300, -1e5, 1e5, 1e300 };

    (void) state;
    for (size_t i = 0; i < 8; i++) {
        const bool at_rest = i >= 4; /* and no direction either */
        const double d = at_rest ? 0.0 : 1.0;
        const struct fixture x = { stream, { d, d, scale[i % 4], 0.1 } };
        const struct planar sys = planar_of(&x, 10.0);
        const struct rescaled r = { &sys, 0.5, 1 };
        struct cascade_linear l;
        const bool fast = scale[i % 4] > 0.0 && !at_rest;
        rescaled_linear(&r, (struct vec2){ 0.0, 0.0 }, &l);
        CHECK(fabs(l.du[0] - (fast ? sqrt(0.5) : 0.0)) < 1e-15, "dx %g",
              l.du[0]);
        CHECK(l.du[2] == (fast ? 0.0 : 2.0), "dt %g", l.du[2]);
        for (size_t k = 0; k < 4; k++)
            CHECK(isfinite(l.slope[k].x) && isfinite(l.slope[k].y),
                  "gradient %zu", k);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gradients_are_those_of_the_right_hand_side),
        cmocka_unit_test(ratios_are_those_of_the_field),
        cmocka_unit_test(scales_beyond_every_double_give_finite_rates),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
