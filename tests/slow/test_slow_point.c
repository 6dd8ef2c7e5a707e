/* Points of the slow curve's branches, by place and by time. */
#include "slow_point.h"

#include "fate.h"
#include "found.h"
#include "slow_curve.h"

static const char *const steady_only[] = { "products=[equilibria]", NULL };

static void make(struct slow_curve *c, struct slope *s, const char *law,
                 const char *alpha)
{
    slope_make(s, law, NULL, alpha, steady_only);
    assert_int_equal(slow_curve_init(c, &s->study.slider, NULL), STATUS_OK);
}

static void drop(struct slow_curve *c, struct slope *s)
{
    slow_curve_free(c);
    slope_free(s);
}

/* As well as time tells y. */
static int check_found_again(const struct slow_branch *b, double y)
{
    struct slow_point p;

    if (!slow_point_at(b, y, &p))
        return 0;
    const double again = slow_point_when(b, p.time);
    const double told = 1e-14 * fabs(p.time / p.time_slope) + 1e-14;
    CHECK(fabs(again - y) <= told, "y = %.17g: %.17g, time %g", y, again,
          p.time);
    return 1;
}

static void a_point_is_found_again_by_its_time(void **state)
{
    static const char *const law[] = { "spinodal_gen", "dieterich_gen",
                                       "spinodal" };

    (void) state;
    for (int i = 0; i < 3; i++) {
        struct slow_curve c;
        struct slope s;
        int points = 0;
        make(&c, &s, law[i], "0.34");
        for (size_t k = 0; k < c.branches; k++)
            for (double y = -9.0; y < 6.0; y += 0.0137) {
                points += check_found_again(&c.branch[k], y);
                if (c.inside[k].count > 2)
                    points += check_found_again(&c.inside[k], y);
            }
        for (double y = 1e-9; y < 0.1; y *= 7.0)
            points += check_found_again(&c.branch[0], y);
        CHECK(points > 200, "%s: %d points", law[i], points);
        drop(&c, &s);
    }
}

/* Half way between knots, against an orbit from there. */
static void check_between(const struct slow_curve *c, size_t branch, size_t i)
{
    const struct slow_branch *b = &c->branch[branch];
    const double y = 0.5 * (b->knot[i].y + b->knot[i + 1].y);
    struct slow_point p;
    struct fate_result r;

    assert_true(slow_point_at(b, y, &p));
    const struct vec2 z = { p.x, y }, o = c->slider->plane.system.origin;
    assert_int_equal(
        fate_find(c->slider, vec2_add(z, o), 1e-12, true, NULL, &r), 0);
    const double time = fabs(p.time - r.time.value);
    const double slip = fabs(p.slip - r.slip.value);
    CHECK(time <= p.time_error + r.time.error, "y = %.17g: time %g over %g", y,
          time, p.time_error);
    CHECK(slip <= p.slip_error + r.slip.error, "y = %.17g: slip %g over %g", y,
          slip, p.slip_error);
}

/* Where psi settles first, and by 1e-4 of that the curve is followed, slopes of
 * knots are rounding, which no shorter step mends. */
static void rounding_of_slopes_is_in_the_bars(void **state)
{
    static const struct found f = {
        FRICTION_ASINH,         THETA_PSI,
        PSI_SS_SPINODAL,        TIMESCALE_SPINODAL,
        KINETICS_LINEAR,        0.35838222826273081,
        0.048745225148090814,   0.010271319279817217,
        0.013406343101165142,   2452.9873780463604,
        3.0262838996485415e-07, 0.00023098601944379621,
        0.35698359402709817,    1e-8
    };
    struct slow_curve c;
    struct slope s;
    struct fault why;
    int points = 0;

    (void) state;
    found_scene(&f, steady_only, &s.scene);
    assert_int_equal(study_run(&s.study, &s.scene, NULL, &why), STATUS_OK);
    assert_int_equal(slow_curve_init(&c, &s.study.slider, NULL), STATUS_OK);
    for (size_t k = 0; k < c.branches; k++)
        for (size_t i = 0; i + 1 < c.branch[k].count; i += 10)
            if (isfinite(c.branch[k].knot[i].gap) &&
                isfinite(c.branch[k].knot[i + 1].gap)) {
                check_between(&c, k, i);
                points++;
            }
    CHECK(points > 30, "%d points", points);
    drop(&c, &s);
}

/* T = T0 + ln(way)/|lambda| next to a node, the table's last knot or not. */
static void inside_a_box_time_goes_on_below_zero(void **state)
{
    struct slow_curve c;
    struct slope s;
    int boxes = 0;

    (void) state;
    make(&c, &s, "spinodal_gen", "0.34");
    for (size_t k = 0; k < c.branches; k++) {
        const struct slow_branch *in = &c.inside[k];
        const double end = c.branch[k].knot[c.branch[k].count - 1].y;
        struct slow_point face, p, q;
        if (in->count < 3)
            continue;
        boxes++;
        assert_true(slow_point_at(in, end, &face));
        CHECK(fabs(face.time) < 1e-12, "%g", face.time);
        for (double way = 0.3; way > 1e-7; way *= 0.1) {
            const double y = in->centre + way * (end - in->centre);
            const double near = in->centre + 0.1 * way * (end - in->centre);
            assert_true(slow_point_at(in, y, &p));
            assert_true(slow_point_at(in, near, &q));
            CHECK(p.time < 0.0 && p.slip < 0.0, "%g", p.time);
            CHECK(fabs((p.time - q.time) * -in->grows / log(10.0) - 1.0) <
                      0.02 * way + 1e-6,
                  "%g of the way: %g", way, p.time - q.time);
        }
    }
    assert_int_equal(boxes, 4);
    drop(&c, &s);
}

static void elsewhere_there_is_nothing(void **state)
{
    struct slow_curve c;
    struct slow_point p;
    struct slope s;
    double x, slope;

    (void) state;
    make(&c, &s, "spinodal_gen", "0.34");
    const struct slow_branch *b = &c.branch[0];
    assert_false(slow_point_at(b, -b->knot[0].y, &p));
    assert_false(slow_point_at(b, 7.0, &p));
    assert_false(slow_point_beside(b, 7.0, &x, &slope));
    assert_true(isnan(slow_point_when(b, -1.0)));
    assert_true(isnan(slow_point_when(&c.branch[2], 1e6)));
    assert_true(slow_point_when(b, 300.0) > 0.0); /* ever nearer the saddle */
    drop(&c, &s);
}

/* y^6 on [1, 3] by a quintic with other slopes and curvatures at its ends. */
static double sixth_off_by(double slope, double bend, double theta)
{
    const double f[3] = { 1.0, 6.0 + slope, 30.0 + bend };
    const double g[3] = { 729.0, 1458.0 - slope, 2430.0 + bend };
    const double y = 1.0 + 2.0 * theta;
    double ignored;

    return fabs(slow_quintic(f, g, 2.0, theta, &ignored) - pow(y, 6.0));
}

static void a_polynomial_between_knots_misses_less_beside_them(void **state)
{
    const double missed = sixth_off_by(0.0, 0.0, 0.5);
    const double rounded = sixth_off_by(1e3, 0.0, 0.5) - missed;
    const double bent = missed + sixth_off_by(0.0, 1e3, 0.5);

    (void) state;
    assert_true(missed > 0.0 && rounded > 0.0);
    for (double theta = 0.01; theta < 1.0; theta += 0.01) {
        const struct slow_miss power = { missed, 0.0 };
        const struct slow_miss slopes = { missed, rounded };
        const struct slow_miss bends = { missed, bent };
        const double told = slow_knot_missed(&power, theta);
        CHECK(fabs(sixth_off_by(0.0, 0.0, theta) - told) < 1e-11, "%g", theta);
        CHECK(sixth_off_by(1e3, 0.0, theta) <=
                  slow_knot_missed(&slopes, theta) + 1e-9,
              "%g", theta);
        CHECK(sixth_off_by(0.0, 1e3, theta) <=
                  slow_knot_missed(&bends, theta) + 1e-9,
              "%g", theta);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_point_is_found_again_by_its_time),
        cmocka_unit_test(inside_a_box_time_goes_on_below_zero),
        cmocka_unit_test(elsewhere_there_is_nothing),
        cmocka_unit_test(rounding_of_slopes_is_in_the_bars),
        cmocka_unit_test(a_polynomial_between_knots_misses_less_beside_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
