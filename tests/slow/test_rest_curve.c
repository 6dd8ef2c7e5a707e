/* The curve along which a block comes to rest, and states that fall onto it. */
#include "rest_curve.h"

#include "fast_layer.h"
#include "fault_alloc.h"
#include "found.h"
#include "rest_left.h"
#include "slope.h"
#include "stops.h"
#include "tolerance.h"

static const char *const steady_only[] = { "products=[equilibria]", NULL };

static void make(struct slow_curve *c, struct slope *s, const char *law,
                 const char *alpha)
{
    slope_make(s, law, NULL, alpha, steady_only);
    const enum status status = slow_curve_init(c, &s->study.slider, NULL);
    CHECK(status == STATUS_OK, "%s", status_text(status));
}

static void drop(struct slow_curve *c, struct slope *s)
{
    slow_curve_free(c);
    slope_free(s);
}

static void orbits_on_it_take_the_tabulated_time_and_slip(void **state)
{
    struct rest_point p;
    struct fate_result r;
    struct slow_curve c;
    struct slope s;

    (void) state;
    make(&c, &s, "dieterich_gen", "0.34");
    for (double x = -5.2; x > -14.0; x -= 0.83) {
        const struct vec2 o = s.study.slider.plane.system.origin;
        assert_true(rest_curve_at(&c.rest, x, &p));
        const struct vec2 z = { o.x + x, o.y + p.y };
        assert_int_equal(fate_find(&s.study.slider, z, 1e-10, true, NULL, &r),
                         STATUS_OK);
        assert_int_equal(r.fate, FATE_REST_FINITE);
        CHECK(fabs(r.time.value - p.time) <= 1e-8 * p.time + r.time.error,
              "x %g: %.12g, not %.12g +- %g", x, p.time, r.time.value,
              r.time.error);
        CHECK(p.time_error <= 1e-10 * p.time && p.slip_error <= 1e-10 * p.slip,
              "x %g: %g, %g", x, p.time_error / p.time, p.slip_error / p.slip);
        CHECK(fabs(r.slip.value - p.slip) <= 1e-8 * p.slip + r.slip.error,
              "x %g: %.12g, not %.12g +- %g", x, p.slip, r.slip.value,
              r.slip.error);
    }
    drop(&c, &s);
}

/* Across the floor of the orbit and the bottom of the table. */
static void time_and_slip_change_as_their_slopes_say(void **state)
{
    struct rest_point p, q;
    struct slow_curve c;
    struct slope s;
    const double h = 1e-5;
    double y, y_slope;

    (void) state;
    make(&c, &s, "dieterich_gen", "0.30");
    for (double x = c.rest.knot[0].at.x - 0.1; x > -45.0; x -= 0.37) {
        assert_true(rest_curve_at(&c.rest, x, &p));
        assert_true(rest_curve_at(&c.rest, x + h, &q));
        CHECK(fabs((q.time - p.time) / h / p.time_slope - 1.0) < 1e-4,
              "x %g: %g, not %g", x, (q.time - p.time) / h, p.time_slope);
        CHECK(fabs((q.slip - p.slip) / h / p.slip_slope - 1.0) < 1e-4,
              "x %g: %g, not %g", x, (q.slip - p.slip) / h, p.slip_slope);
        CHECK(fabs((q.y - p.y) / h - p.y_slope) < 1e-3, "x %g: %g, not %g", x,
              (q.y - p.y) / h, p.y_slope);
        assert_true(rest_curve_beside(&c.rest, x, &y, &y_slope));
        assert_true(y == p.y);
    }
    assert_false(rest_curve_at(&c.rest, 0.0, &p));
    assert_false(rest_curve_beside(&c.rest, 0.0, &y, &y_slope));
    drop(&c, &s);
}

/* However little v is left, time goes by eps^2 v and slip by its square. */
static void the_table_has_no_end(void **state)
{
    struct rest_point p, q;
    struct slow_curve c;
    struct slope s;

    (void) state;
    make(&c, &s, "dieterich_gen", "0.34");
    assert_true(rest_curve_at(&c.rest, -60.0, &p));
    assert_true(rest_curve_at(&c.rest, -60.0 - log(2.0), &q));
    CHECK(fabs(p.time / q.time - 2.0) < 0.05, "%g", p.time / q.time);
    CHECK(fabs(p.slip / q.slip - 4.0) < 0.1, "%g", p.slip / q.slip);
    drop(&c, &s);
}

/* Midway between knots second derivatives, which are those of three knots,
 * count most; what is left is one quadrature, too. */
static void between_knots_it_is_within_its_bars(void **state)
{
    static const struct found slope = {
        FRICTION_ASINH,         THETA_LN_PSI,
        PSI_SS_INVERSE,         TIMESCALE_SLIP,
        KINETICS_SINH,          0.369,
        0.026270601147123342,   0.0489,
        0.00087607094724221853, 133.99995049455831,
        1.1131264969023437e-08, 1e-6,
        0.55096367103137478,    1e-6
    };
    struct slow_curve c;
    struct slider s;
    struct scene scene;
    size_t known = 0;

    (void) state;
    found_scene(&slope, steady_only, &scene);
    slider_init(&s, &scene.law, &scene.material, 0.614431910600887344837L);
    assert_int_equal(slow_curve_init(&c, &s, NULL), STATUS_OK);
    for (size_t i = 0; i + 1 < c.rest.count; i++) {
        const struct rest_knot *k = &c.rest.knot[i];
        const double x = 0.5 * (k[0].at.x + k[1].at.x);
        struct rest_point p;
        struct rest_left left;
        assert_true(rest_curve_at(&c.rest, x, &p));
        if (!rest_left_find(&s, (struct vec2){ x, p.y }, 0.0, &left))
            continue;
        CHECK(fabs(p.time - left.time) <= p.time_error + left.time_error,
              "x %g: time %.17g +- %g, not %.17g +- %g", x, p.time,
              p.time_error, left.time, left.time_error);
        CHECK(fabs(p.slip - left.slip) <= p.slip_error + left.slip_error,
              "x %g: slip %.17g +- %g, not %.17g +- %g", x, p.slip,
              p.slip_error, left.slip, left.slip_error);
        known += left.time_error < 0.1 * p.time_error;
    }
    CHECK(known > 30, "%zu of %zu", known, c.rest.count);
    slow_curve_free(&c);
    scene_free(&scene);
}

static void states_fall_onto_it(void **state)
{
    struct layer_job job = { .options = layer_defaults(1e-6) };
    struct slow_curve c;
    struct fate_result r;
    struct layer l;
    struct slope s;

    (void) state;
    make(&c, &s, "dieterich_gen", "0.34");
    const struct vec2 z = { -6.0, -6.0 },
                      o = s.study.slider.plane.system.origin;
    job.z = vec2_sub(z, o);
    job.options.peaks = false;
    layer_follow(&c, layer_width(8), &job, 1, &l);
    assert_int_equal(l.end, LAYER_LANDED);
    assert_int_equal(l.fate, FATE_REST_FINITE);
    assert_int_equal(fate_find(&s.study.slider, z, 1e-10, true, NULL, &r),
                     STATUS_OK);
    CHECK(fabs(l.time - r.time.value) <= l.time_error + 1e-8 * l.time,
          "%.12g, not %.12g", l.time, r.time.value);
    CHECK(l.time_error < 1e-5 * l.time, "%g of %g", l.time_error, l.time);
    drop(&c, &s);
}

static void blocks_that_never_rest_have_none(void **state)
{
    struct slow_curve c;
    struct slope s;

    (void) state;
    make(&c, &s, "spinodal_gen", "0.34");
    assert_int_equal(c.rest.count, 0);
    drop(&c, &s);
    make(&c, &s, "ruina", "0.34");
    assert_int_equal(c.rest.count, 0);
    drop(&c, &s);
}

static void every_allocation_may_fail_and_monitors_stop_it(void **state)
{
    const struct monitor monitor = { stop_at_once, NULL };
    enum status status = STATUS_NO_MEMORY;
    struct rest_curve r;
    struct slow_curve c;
    struct slope s;

    (void) state;
    make(&c, &s, "dieterich_gen", "0.34");
    const struct slow_branch *b = &c.branch[0];
    const struct slow_knot *k = &b->knot[b->count - 1];
    const struct vec2 z = { k->x, k->y };
    for (long n = 0; status != STATUS_OK; n++) {
        fault_alloc_at(n);
        status = rest_curve_run(&s.study.slider, z, NULL, &r);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        assert_true(status == STATUS_OK || status == STATUS_NO_MEMORY);
        rest_curve_free(&r);
        rest_curve_free(&r);
    }
    assert_int_equal(rest_curve_run(&s.study.slider, z, &monitor, &r),
                     STATUS_STOPPED);
    rest_curve_free(&r);
    drop(&c, &s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(orbits_on_it_take_the_tabulated_time_and_slip),
        cmocka_unit_test(time_and_slip_change_as_their_slopes_say),
        cmocka_unit_test(the_table_has_no_end),
        cmocka_unit_test(between_knots_it_is_within_its_bars),
        cmocka_unit_test(states_fall_onto_it),
        cmocka_unit_test(blocks_that_never_rest_have_none),
        cmocka_unit_test(every_allocation_may_fail_and_monitors_stop_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
