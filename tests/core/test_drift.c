/* What an orbit carries of its errors is what they are: on linear systems,
 * stiff ones too, and on an oscillator, whose orbits are known. */
#include "drift.h"

#include <math.h>

#include "check.h"
#include "fields_of.h"
#include "orbit.h"
#include "tolerance.h"

static void run(struct orbit *o, struct drift *d, const struct planar *sys,
                struct vec2 z, double rtol, double time)
{
    struct orbit_options p = orbit_defaults(sys, 1.0);

    drift_start(d, 0.0, 0.0);
    p.rtol = rtol;
    p.reach[0] = time;
    p.drift = d;
    assert_int_equal(orbit_init(o, sys, z, &p), STATUS_OK);
    assert_int_equal(orbit_run(o, NULL), STATUS_OK);
    assert_int_equal(o->end, ORBIT_REACHED);
}

/* How far component i is off when the orbit's clock reads the time it took. */
static double off_then(const struct drift *d, size_t i)
{
    return d->e[i] - d->du[i] / d->du[2] * d->e[2];
}

/* Where those of steps cancel, what is left of them is known as well as they
 * are: to a thousandth of its bar. */
static void errors_of_linear_orbits_are_known_with_their_signs(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 200; i++) {
        const double stiff = pow(10.0, check_uniform(&rng, 0, 5));
        const struct fixture x = { linear,
                                   { check_uniform(&rng, -1, 1), -stiff } };
        const struct planar sys = planar_of(&x, 1e3);
        const struct vec2 z = { check_uniform(&rng, 0.5, 2), 1.0 };
        const double rtol = pow(10.0, check_uniform(&rng, -7, -4));
        struct orbit o;
        struct drift d;
        run(&o, &d, &sys, z, rtol, 3.0);
        const double t = o.u[2], a = x.p[0];
        const double off[] = { o.u[0] - z.x * exp(a * t), 0.0, 0.0,
                               o.u[3] - z.x * expm1(a * t) / a };
        for (size_t k = 0; k < 4; k += 3) {
            const double seen = off_then(&d, k), bar = drift_bar_at(&d, 2, k);
            CHECK(fabs(seen - off[k]) <=
                      fmax(0.1 * fabs(off[k]), 1e-3 * bar) + 2e-14,
                  "%zu, %g: %g is seen as %g", k, stiff, off[k], seen);
            CHECK(bar + 1e-15 >= fabs(off[k]), "%zu, %g", k, stiff);
        }
        orbit_free(&o);
    }
}

/* x'' = x - x^3 conserves y^2/2 - x^2/2 + x^4/4: its gradient is across. */
static void errors_across_an_orbit_are_what_its_energy_says(void **state)
{
    static const struct fixture x = { duffing, { 0 } };
    const struct planar sys = planar_of(&x, 1e3);
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 100; i++) {
        const struct vec2 z = { check_uniform(&rng, 1.5, 3.0), 0.0 };
        const double rtol = pow(10.0, check_uniform(&rng, -7, -4));
        struct orbit o;
        struct drift d;
        run(&o, &d, &sys, z, rtol, 10.0);
        const double X = o.u[0], Y = o.u[1], X2 = X * X, z2 = z.x * z.x;
        const double energy = 0.5 * (Y * Y - X2) + 0.25 * X2 * X2;
        const double off = energy - (0.25 * z2 * z2 - 0.5 * z2);
        const double seen = (X2 * X - X) * d.e[0] + Y * d.e[1];
        CHECK(fabs(seen - off) <= 0.1 * fabs(off) + 1e-13, "%g is seen as %g",
              off, seen);
        orbit_free(&o);
    }
}

/* x loses less than half of its last digit on a step, and so nothing. */
static void steps_short_of_a_last_digit_are_seen_to_be_lost(void **state)
{
    static const struct fixture fall = { linear, { -2e-16, -1.0 } };
    const struct planar sys = planar_of(&fall, 1e3);
    struct orbit o;
    struct drift d;

    (void) state;
    run(&o, &d, &sys, (struct vec2){ 10.0, 10.0 }, TOL_FINEST, 30.0);
    const double off = o.u[0] - 10.0 + 6e-14;
    CHECK(off > 3e-14 && fabs(d.lost[0] - off) <= 0x1p-49, "%g is seen as %g",
          off, d.lost[0]);
    orbit_free(&o);
}

/* A start that is only known to `off` is told as well as it grows. */
static void what_is_not_known_of_the_start_grows_with_the_orbit(void **state)
{
    static const struct fixture x = { linear, { 2.0, -3.0 } };
    const struct planar sys = planar_of(&x, 1e6);
    struct orbit_options p = orbit_defaults(&sys, 1.0);
    const double off = 1e-6;
    struct drift d;
    struct orbit o;

    (void) state;
    drift_start(&d, off, 0.0);
    p.reach[0] = 1.0;
    p.drift = &d;
    assert_int_equal(orbit_init(&o, &sys, (struct vec2){ 1.0, 1.0 }, &p), 0);
    assert_int_equal(orbit_run(&o, NULL), 0);
    /* at a time: e^2 and e^-3 of it */
    const double bar[] = { drift_bar_at(&d, 2, 0), drift_bar_at(&d, 2, 1) };
    CHECK(bar[0] > off * exp(2.0) && bar[0] < 5.0 * off * exp(2.0), "%g",
          bar[0]);
    CHECK(bar[1] > off * exp(-3.0) && bar[1] < 5.0 * off * exp(-3.0), "%g",
          bar[1]);
    orbit_free(&o);
}

/* x loses less than half of its last digit on a step: all leave it where it
 * is, which no step's own estimate tells. */
static void what_is_beside_an_orbit_counts_rounding_to_one_side(void **state)
{
    const struct fixture fall = { linear, { -2e-16, -1.0 } };
    const struct planar sys = planar_of(&fall, 1e6);
    struct orbit_options p = orbit_defaults(&sys, 1.0);
    struct drift d;
    struct orbit o;

    (void) state;
    drift_start(&d, 0.0, 0.0);
    p.drift = &d;
    p.reach[0] = 10.0;
    p.rtol = TOL_FINEST;
    assert_int_equal(orbit_init(&o, &sys, (struct vec2){ 1e5, 10.0 }, &p), 0);
    assert_int_equal(orbit_run(&o, NULL), 0);
    const double off = fabs(o.u[0] - 1e5 + 2e-10);
    const double across = o.curve.piece[o.curve.count - 1].across;
    CHECK(off > 2e-11 && across >= off, "%g over %g", off, across);
    orbit_free(&o);
}

/* Loose steps onto a slow curve are off by less where they end than where they
 * begin: x = e^-t, y = e^(-stiff t), whose orbit is y = x^stiff. */
static void no_point_of_a_piece_is_further_aside_than_it_says(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 200; i++) {
        const double stiff = pow(10.0, check_uniform(&rng, 1, 4));
        const struct fixture x = { linear, { -1.0, -stiff } };
        const struct planar sys = planar_of(&x, 1e3);
        struct orbit o;
        struct drift d;
        run(&o, &d, &sys, (struct vec2){ 1.0, 1.0 },
            pow(10.0, check_uniform(&rng, -8, -4)), 3.0);
        for (size_t k = 0; k < 8 * o.curve.count; k++) {
            const struct vec2 z =
                curve_point(&o.curve, k / 8, (double) (k % 8) / 8.0);
            const double y = pow(z.x, stiff), slope = stiff * y / z.x;
            const double off = fabs(z.y - y) / hypot(1.0, slope);
            const double bar = o.curve.piece[k / 8].across;
            CHECK(off <= bar + 1e-14, "%g, piece %zu of %zu: %g, not %g", stiff,
                  k / 8, o.curve.count, off, bar);
        }
        orbit_free(&o);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_of_linear_orbits_are_known_with_their_signs),
        cmocka_unit_test(errors_across_an_orbit_are_what_its_energy_says),
        cmocka_unit_test(what_is_beside_an_orbit_counts_rounding_to_one_side),
        cmocka_unit_test(no_point_of_a_piece_is_further_aside_than_it_says),
        cmocka_unit_test(steps_short_of_a_last_digit_are_seen_to_be_lost),
        cmocka_unit_test(what_is_not_known_of_the_start_grows_with_the_orbit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
