#include "orbit.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "fields_of.h"
#include "tolerance.h"

static int fail_at = -1;

void *__real_realloc(void *p, size_t n);
void *__wrap_realloc(void *p, size_t n);

void *__wrap_realloc(void *p, size_t n)
{
    if (fail_at-- == 0)
        return NULL;
    return __real_realloc(p, n);
}

static void run(struct orbit *o, const struct planar *sys, struct vec2 z,
                const struct orbit_options *options, enum orbit_end end)
{
    enum status s = orbit_init(o, sys, z, options);

    CHECK(s == STATUS_OK, "init: %s", status_text(s));
    s = orbit_run(o, NULL);
    CHECK(s == STATUS_OK, "run: %s after %zu + %zu steps at (%g, %g)",
          status_text(s), o->steps, o->rejected, o->u[0], o->u[1]);
    CHECK(o->end == end, "end %d, expected %d, at (%g, %g), t = %g",
          (int) o->end, (int) end, o->u[0], o->u[1], o->u[2]);
    CHECK(o->curve.count == o->steps, "%zu pieces, %zu steps", o->curve.count,
          o->steps);
}

static void linear_systems_are_followed_in_both_directions(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 200; i++) {
        const struct fixture x = {
            linear, { check_uniform(&rng, -2, 2), check_uniform(&rng, -2, 2) }
        };
        const struct planar sys = planar_of(&x, 1e3);
        const struct vec2 z = { 1.0, -0.5 };
        const double sign = i % 2 ? 1.0 : -1.0, a = x.p[0], b = x.p[1];
        struct orbit_options p = orbit_defaults(&sys, 1.0);
        struct orbit o;
        p.backward = sign < 0.0;
        p.reach[0] = 3.0 * sign;
        run(&o, &sys, z, &p, ORBIT_REACHED);
        for (size_t k = 0; k < o.curve.count; k++) {
            double u[4];
            curve_at(&o.curve, k, check_uniform(&rng, 0, 1), u);
            const double ex = z.x * exp(a * u[2]), ey = z.y * exp(b * u[2]);
            const double tol = 3e-7 * (1.0 + fabs(ex) + fabs(ey));
            CHECK(fabs(u[0] - ex) < tol && fabs(u[1] - ey) < tol,
                  "(%.12g, %.12g), true (%.12g, %.12g)", u[0], u[1], ex, ey);
            CHECK(fabs(u[3] - z.x * expm1(a * u[2]) / a) < tol,
                  "integral %.12g, true %.12g", u[3],
                  z.x * expm1(a * u[2]) / a);
        }
        CHECK(fabs(o.u[2] - 3.0 * sign) < 1e-14, "t = %.17g", o.u[2]);
        orbit_free(&o);
    }
}

static void energy_is_kept_on_closed_orbits(void **state)
{
    const struct fixture x = { duffing, { 0 } };
    const struct planar sys = planar_of(&x, 10.0);
    struct orbit_options p = orbit_defaults(&sys, 1.0);
    struct orbit o;

    (void) state;
    for (double rtol = 1e-6; rtol > 1e-12; rtol *= 0.1) {
        p.rtol = rtol;
        p.reach[0] = 20.0;
        run(&o, &sys, (struct vec2){ 1.0, 0.5 }, &p, ORBIT_REACHED);
        const double x2 = o.u[0] * o.u[0];
        const double E = 0.5 * (o.u[1] * o.u[1] - x2) + 0.25 * x2 * x2;
        CHECK(fabs(E - (0.125 - 0.25)) < 200.0 * rtol, "rtol %g: off by %g",
              rtol, E + 0.125);
        orbit_free(&o);
    }
}

static void stiff_solutions_keep_the_tolerance(void **state)
{
    (void) state;
    for (double stiff = 1e2; stiff < 2e8; stiff *= 100.0) {
        const struct fixture x = { prothero, { stiff } };
        const struct planar sys = planar_of(&x, 100.0);
        struct orbit_options p = orbit_defaults(&sys, stiff);
        struct orbit o;
        p.reach[0] = 10.0;
        for (int off = 0; off < 2; off++) { /* on and off the slow curve */
            run(&o, &sys, (struct vec2){ 0.0, off ? 2.0 : 0.0 }, &p,
                ORBIT_REACHED);
            CHECK(fabs(o.u[1] - sin(10.0)) < 2e-7, "rate %g: y off by %g",
                  stiff, o.u[1] - sin(10.0));
            CHECK(fabs(o.u[0] - 10.0) < 1e-7, "rate %g: x = %.12g", stiff,
                  o.u[0]);
            CHECK(fabs(o.u[3] - 50.0) < 1e-6, "rate %g: integral %.12g", stiff,
                  o.u[3]);
            CHECK(o.steps < 200, "rate %g: %zu steps", stiff, o.steps);
            orbit_free(&o);
        }
    }
}

/* eps = 1e-6 from x = 2, x' = 0; the values at t = 1 and 2 are those of Hairer
 * & Wanner, Solving ODEs II, sec. IV.10, VDPOL. */
static void relaxation_oscillations_are_followed(void **state)
{
    const double eps = 1e-6, ref[2] = { -1.863646254808130, 1.706167732170483 };
    const struct fixture x = { pol, { eps } };
    const struct planar sys = planar_of(&x, 10.0);
    struct orbit_options p = orbit_defaults(&sys, 1.0 / eps);

    (void) state;
    for (int k = 0; k < 2; k++) {
        struct orbit o;
        p.reach[0] = k + 1.0;
        run(&o, &sys, (struct vec2){ 2.0, 2.0 / 3.0 }, &p, ORBIT_REACHED);
        CHECK(fabs(o.u[0] - ref[k]) < 2e-9, "t = %d: off by %g", k + 1,
              o.u[0] - ref[k]);
        CHECK(o.steps < 600, "%zu steps", o.steps);
        orbit_free(&o);
    }
}

static void slip_rides_along_over_a_stiff_layer(void **state)
{
    const struct fixture x = { relax, { 1e6 } };
    const struct planar sys = planar_of(&x, 100.0);
    struct orbit_options p = orbit_defaults(&sys, 1e6);
    const struct vec2 node = { 0.0, 1.0 };
    struct orbit o;

    (void) state;
    p.target = &node;
    p.targets = 1;
    p.arrival = 1e-3;
    run(&o, &sys, (struct vec2){ 5.0, -7.0 }, &p, ORBIT_ARRIVED);
    CHECK(fabs(o.u[0] - 1e-3) < 1e-14, "x = %.17g", o.u[0]);
    CHECK(fabs(o.u[2] - log(5e3)) < 1e-7, "t off by %g", o.u[2] - log(5e3));
    CHECK(fabs(o.u[3] - 4.999) < 1e-7, "integral off by %g", o.u[3] - 4.999);
    CHECK(o.error[3] > 0.0 && o.error[3] < 1e-6, "error sum %g", o.error[3]);
    CHECK(o.field_calls < 15 * o.steps &&
              o.jacobian_calls == o.steps + o.rejected + 1,
          "%zu, %zu calls in %zu + %zu steps", o.field_calls, o.jacobian_calls,
          o.steps, o.rejected);
    orbit_free(&o);
}

static double level(const void *ctx, double s, const double u[])
{
    (void) s;
    return u[0] - *(const double *) ctx;
}

static void every_stop_fires_where_it_should(void **state)
{
    /* On a straight line at speed 5 the place of every stop is known. */
    const struct fixture x = { stream, { 3.0, 4.0, 0.0, 0.0 } };
    struct planar sys = planar_of(&x, 60.0);
    const struct orbit_options base = orbit_defaults(&sys, 1.0);
    const double ten = 10.0;
    const struct event e = { .value = level, .ctx = &ten, .stop = true };
    const struct box window = { { -5.0, -5.0 }, { 100.0, 21.0 } };
    const struct vec2 target[] = { { 30.0, 40.0 }, { 12.0, 16.0 + 3e-3 } };
    struct orbit_options p[6] = { base, base, base, base, base, base };
    const enum orbit_end end[6] = { ORBIT_LEFT_DOMAIN, ORBIT_LEFT_WINDOW,
                                    ORBIT_ARRIVED,     ORBIT_REACHED,
                                    ORBIT_REACHED,     ORBIT_EVENT };
    const size_t index[6] = { 0, 0, 0, 0, 1, 0 };
    /* Origin (1, 2): the window's edge is at offset 19, the domain's at 58.
     * The corner of target 1's box is passed, target 0 entered from below. */
    const double y[6] = { 58.0, 19.0, 39.999, 8.0, 16.0, 40.0 / 3 };

    (void) state;
    sys.origin = (struct vec2){ 1.0, 2.0 };
    p[1].window = &window;
    p[2].target = target;
    p[2].targets = 2;
    p[2].arrival = 1e-3;
    p[3].reach[0] = 2.0;
    p[4].reach[1] = 24.0; /* 3 t^2/2 at t = 4 */
    p[5].event = &e;
    p[5].events = 1;
    for (size_t i = 0; i < 6; i++) {
        struct orbit o;
        double at[4];
        run(&o, &sys, (struct vec2){ 0.0, 0.0 }, &p[i], end[i]);
        CHECK(fabs(o.u[1] - y[i]) < (i == 4 ? 1e-7 : 1e-12),
              "stop %zu at y = %.15g", i, o.u[1]);
        CHECK(fabs(o.u[2] - o.u[1] / 4.0) < 1e-12, "stop %zu: t = %g", i,
              o.u[2]);
        CHECK(o.end_index == index[i], "index %zu", o.end_index);
        curve_at(&o.curve, o.curve.count - 1, 1.0, at);
        assert_memory_equal(at, o.u, sizeof at);
        const size_t steps = o.steps;
        assert_int_equal(orbit_step(&o), STATUS_OK);
        assert_int_equal(o.steps, steps);
        orbit_free(&o);
    }
}

static void fast_passages_are_not_jumped_over(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 500; i++) {
        const double slope = check_uniform(&rng, -0.5, 0.5);
        const struct fixture x = { stream, { 1.0, slope, 30.0, 0.0 } };
        const struct planar sys = planar_of(&x, 500.0);
        struct orbit_options p = orbit_defaults(&sys, 1.0);
        const double x0 = check_uniform(&rng, 100.0, 400.0);
        const struct vec2 target = { x0, slope * x0 };
        const struct vec2 beside = { x0, slope * x0 + 0.03 };
        struct orbit o;
        p.target = &target;
        p.targets = 1;
        run(&o, &sys, (struct vec2){ 0.0, 0.0 }, &p, ORBIT_ARRIVED);
        CHECK(fabs(o.u[0] - (x0 - TOL_ARREST)) < 1e-11, "x = %.15g", o.u[0]);
        orbit_free(&o);
        p.target = &beside;
        run(&o, &sys, (struct vec2){ 0.0, 0.0 }, &p, ORBIT_LEFT_DOMAIN);
        CHECK(o.steps < 60, "%zu steps", o.steps);
        orbit_free(&o);
    }
}

static void recorded_events_do_not_stop(void **state)
{
    const struct fixture x = { duffing, { 0 } };
    const struct planar sys = planar_of(&x, 10.0);
    const double one = 1.0;
    const struct event e = { .value = level, .ctx = &one };
    struct orbit_options p = orbit_defaults(&sys, 1.0);
    struct orbit o;

    (void) state;
    p.rtol = 1e-12;
    p.reach[0] = 30.0;
    p.event = &e;
    p.events = 1;
    run(&o, &sys, (struct vec2){ 1.0, 0.5 }, &p, ORBIT_REACHED);
    CHECK(o.log.count >= 9, "%zu hits", o.log.count);
    for (size_t i = 0; i < o.log.count; i++) {
        const struct event_hit *hit = &o.log.hit[i];
        CHECK(fabs(hit->u[0] - 1.0) < 1e-12, "x = %.17g", hit->u[0]);
        CHECK(fabs(fabs(hit->u[1]) - 0.5) < 1e-9, "y = %.15g", hit->u[1]);
        CHECK((hit->u[1] < 0.0) == (i % 2 == 0), "way %zu", i);
    }
    orbit_free(&o);
}

/* x' = -e^-x: e^x = 1 - t, at rest after t = 1; ln v falls out of the box. */
static void rest_in_finite_time_leaves_the_domain(void **state)
{
    const struct fixture x = { stream, { -1.0, 0.0, 0.0, -1.0 } };
    const struct planar sys = planar_of(&x, LN_RANGE);
    const struct orbit_options p = orbit_defaults(&sys, 1.0);
    struct orbit o;

    (void) state;
    run(&o, &sys, (struct vec2){ 0.0, 0.0 }, &p, ORBIT_LEFT_DOMAIN);
    CHECK(o.u[0] == -LN_RANGE || fabs(o.u[0] + LN_RANGE) < 1e-12, "x = %.17g",
          o.u[0]);
    CHECK(fabs(o.u[2] - 1.0) < 1e-7, "t off by %g", o.u[2] - 1.0);
    /* The integral of ln(1 - t). */
    CHECK(fabs(o.u[3] + 1.0) < 1e-7, "integral off by %g", o.u[3] + 1.0);
    orbit_free(&o);
}

static void log_scales_of_any_size_do_not_overflow(void **state)
{
    const double scale[] = { -1e300, -1e5, -800.0, 800.0, 1e5, 1e300 };

    (void) state;
    for (size_t i = 0; i < 6; i++) {
        const struct fixture x = { stream, { 1.0, 0.5, scale[i], 0.0 } };
        const struct planar sys = planar_of(&x, 20.0);
        struct orbit_options p = orbit_defaults(&sys, 0.25);
        struct orbit o;
        const bool slow = scale[i] < 0.0;
        p.reach[0] = 8.0;
        run(&o, &sys, (struct vec2){ 0.0, 0.0 }, &p,
            slow ? ORBIT_REACHED : ORBIT_LEFT_DOMAIN);
        CHECK(fabs(o.u[0] - (slow ? 0.0 : 20.0)) < 1e-12, "x = %g", o.u[0]);
        CHECK(fabs(o.u[2] - (slow ? 8.0 : 0.0)) < 1e-12, "t = %g", o.u[2]);
        CHECK(fabs(o.tau - (slow ? 2.0 : 20.0 * hypot(1.0, 0.5))) < 1e-9,
              "tau = %g", o.tau);
        orbit_free(&o);
    }
    /* From e^-10000 to e^10000 on one orbit: t = (e^-p3 x0 - ...)/p3. */
    const struct fixture x = { stream, { 1.0, 0.0, 0.0, 1e3 } };
    const struct planar sys = planar_of(&x, 10.0);
    const struct orbit_options p = orbit_defaults(&sys, 1.0);
    struct orbit o;
    run(&o, &sys, (struct vec2){ -0.1, 0.0 }, &p, ORBIT_LEFT_DOMAIN);
    CHECK(fabs(o.u[2] / (exp(100.0) / 1e3) - 1.0) < 1e-6, "t = %g", o.u[2]);
    orbit_free(&o);
}

static void orbit_at_rest_ends(void **state)
{
    const struct fixture x = { linear, { 1.0, -1.0 } };
    const struct planar sys = planar_of(&x, 10.0);
    struct orbit_options p = orbit_defaults(&sys, 1.0);
    struct orbit o;

    (void) state;
    for (int way = 0; way < 2; way++) {
        p.backward = way;
        run(&o, &sys, (struct vec2){ 0.0, 0.0 }, &p, ORBIT_REACHED);
        CHECK(fabs(o.u[2]) == TOL_RANGE || o.end_index == 0, "t = %g", o.u[2]);
        CHECK(o.u[0] == 0.0 && o.u[1] == 0.0, "moved");
        orbit_free(&o);
    }
}

static void nan_in_the_field_is_an_error_and_never_hangs(void **state)
{
    const struct fixture x = { hole, { 1.0, 0.2 } };
    const struct planar sys = planar_of(&x, 10.0);
    const struct orbit_options p = orbit_defaults(&sys, 1.0);
    struct orbit o;

    (void) state;
    for (int start = 0; start < 2; start++) {
        const struct vec2 z = { start ? 2.0 : 0.0, 0.0 };
        assert_int_equal(orbit_init(&o, &sys, z, &p), STATUS_OK);
        assert_int_equal(orbit_run(&o, NULL), STATUS_NO_CONVERGENCE);
        CHECK(o.steps + o.rejected < 3000, "%zu steps", o.steps + o.rejected);
        CHECK(start || (o.u[0] <= 1.0 + 1e-12 && o.u[0] > 0.99), "x = %.17g",
              o.u[0]);
        orbit_free(&o);
    }
}

static void starts_that_end_at_once_and_starts_refused(void **state)
{
    const struct fixture x = { linear, { 1.0, -1.0 } };
    const struct planar sys = planar_of(&x, 10.0);
    const struct orbit_options good = orbit_defaults(&sys, 1.0);
    const struct box window = { { 1.0, 1.0 }, { 2.0, 2.0 } };
    const struct vec2 z = { 0.5, 0.5 };
    struct orbit_options p = good, bad[5] = { good, good, good, good, good };
    struct orbit o;

    (void) state;
    p.window = &window;
    run(&o, &sys, z, &p, ORBIT_LEFT_WINDOW);
    orbit_free(&o);
    p.target = &z;
    p.targets = 1;
    run(&o, &sys, z, &p, ORBIT_ARRIVED);
    assert_int_equal(o.curve.count, 0);
    orbit_free(&o);

    bad[0].kappa = 0.0;
    bad[1].rtol = NAN;
    bad[2].reach[1] = 0.0;
    bad[3].observables = 2;
    bad[4].events = EVENT_COUNT_MAX + 1;
    for (size_t i = 0; i < 5; i++)
        assert_int_equal(orbit_init(&o, &sys, z, &bad[i]), STATUS_BAD_ARGUMENT);
    assert_int_equal(orbit_init(&o, &sys, (struct vec2){ 0, 10.1 }, &good),
                     STATUS_BAD_ARGUMENT);
    assert_int_equal(orbit_init(&o, &sys, (struct vec2){ NAN, 0 }, &good),
                     STATUS_BAD_ARGUMENT);
    orbit_free(&o);
}

static int refuse(void *ctx, const char *stage, uint64_t done, uint64_t total)
{
    (void) ctx;
    (void) stage;
    (void) total;
    return done >= 64;
}

static void bounds_monitor_and_memory_end_the_run(void **state)
{
    const struct fixture x = { duffing, { 0 } };
    const struct planar sys = planar_of(&x, 10.0);
    const struct monitor m = { refuse, NULL };
    struct orbit_options p = orbit_defaults(&sys, 1.0);
    enum status s = STATUS_NO_MEMORY;
    struct orbit o;
    int k = 0;

    (void) state;
    p.max_steps = 300;
    assert_int_equal(orbit_init(&o, &sys, (struct vec2){ 1, 0.5 }, &p),
                     STATUS_OK);
    assert_int_equal(orbit_run(&o, &m), STATUS_STOPPED);
    assert_int_equal(o.steps, 64);
    assert_int_equal(orbit_run(&o, NULL), STATUS_TOO_MANY_STEPS);
    assert_int_equal(o.steps + o.rejected, 300);
    orbit_free(&o);
    orbit_free(&o);
    p.max_steps = 10000;
    p.reach[0] = 60.0;
    for (; s != STATUS_OK; k++) {
        assert_int_equal(orbit_init(&o, &sys, (struct vec2){ 1, 0.5 }, &p),
                         STATUS_OK);
        fail_at = k;
        s = orbit_run(&o, NULL);
        fail_at = -1;
        CHECK(s == STATUS_OK || s == STATUS_NO_MEMORY, "%s", status_text(s));
        CHECK(o.curve.count == o.steps, "%zu pieces", o.curve.count);
        orbit_free(&o);
    }
    CHECK(k > 5, "only %d allocations failed", k - 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(linear_systems_are_followed_in_both_directions),
        cmocka_unit_test(energy_is_kept_on_closed_orbits),
        cmocka_unit_test(stiff_solutions_keep_the_tolerance),
        cmocka_unit_test(relaxation_oscillations_are_followed),
        cmocka_unit_test(slip_rides_along_over_a_stiff_layer),
        cmocka_unit_test(every_stop_fires_where_it_should),
        cmocka_unit_test(fast_passages_are_not_jumped_over),
        cmocka_unit_test(recorded_events_do_not_stop),
        cmocka_unit_test(rest_in_finite_time_leaves_the_domain),
        cmocka_unit_test(log_scales_of_any_size_do_not_overflow),
        cmocka_unit_test(orbit_at_rest_ends),
        cmocka_unit_test(nan_in_the_field_is_an_error_and_never_hangs),
        cmocka_unit_test(starts_that_end_at_once_and_starts_refused),
        cmocka_unit_test(bounds_monitor_and_memory_end_the_run),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
