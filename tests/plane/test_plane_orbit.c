/* Orbits of systems whose first integrals, limits and ways out are known. */
#include "plane_cycle.h"
#include "plane_orbit.h"

#include <math.h>

#include "escape.h"
#include "formulas.h"
#include "plane_basin.h"
#include "taylor_orbit.h"

#define WINDOW "window={x: [-1, 1], y: [-1, 1]}\nproducts=[equilibria]\n"

static struct vec2 point(const struct curve *c, size_t piece, double theta)
{
    double at[CURVE_DIM_MAX];

    curve_at(c, piece, theta, at);
    return (struct vec2){ at[0], at[1] };
}

/* On x' = a x - y, y' = x + a y ln r - a phi stays; the anchor is the origin.
 */
static void series_stay_on_a_logarithmic_spiral(void **state)
{
    static const double rtol[] = { 1e-6, 1e-9, 1e-12 };
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = 0.1*x - y; y' = x + 0.1*y", WINDOW);
    for (int i = 0; i < 3; i++) {
        struct taylor_orbit o = taylor_orbit_at(
            &s.system[0], (struct vec2){ 0.5, 0.0 }, s.scale.side, rtol[i]);
        double turned = 0.0;
        while (turned < 12.0 * M_PI) {
            assert_int_equal(taylor_orbit_step(&o), STATUS_OK);
            for (int k = 0; k < 16; k++) {
                const struct vec2 p = point(&o.curve, o.curve.count - 1,
                                            k / 16.0),
                                  q = point(&o.curve, o.curve.count - 1,
                                            (k + 1) / 16.0);
                turned += atan2(p.x * q.y - p.y * q.x, p.x * q.x + p.y * q.y);
                const double off = log(2.0 * vec2_length(q)) - 0.1 * turned;
                CHECK(fabs(off) <= 2.0 * rtol[i] * (double) o.curve.count,
                      "rtol %g, after %g: off by %g", rtol[i], turned, off);
            }
        }
        CHECK(o.curve.count < 30 * 6, "%zu steps", o.curve.count);
        taylor_orbit_free(&o);
    }
    plane_end(&s, &c);
}

/* The number of pieces from (0.5, 0) until it has left for good; 0: not in so
 * many turns about the window. */
static size_t pieces_until_left(const char *ode, double turns)
{
    struct plane_study s;
    struct scene c;
    struct escape e = { .outside = false };
    size_t n = 0;

    plane_run(&s, &c, ode, WINDOW);
    struct taylor_orbit o = taylor_orbit_at(
        &s.system[0], (struct vec2){ 0.5, 0.0 }, s.scale.side, 1e-9);
    for (size_t i = 0; i < 20.0 * turns && !e.left; i++) {
        assert_int_equal(taylor_orbit_step(&o), STATUS_OK);
        (void) escape_add(&e, &s.system[0], s.window.box, &o.curve, i);
        n = i + 1;
    }
    /* a round from where r > sqrt 2 at the latest, by when r may be e^0.63
     * times that: it has left the window, and never comes again */
    if (e.left)
        CHECK(hypot(o.z.x, o.z.y) > M_SQRT2, "at %g, %g", o.z.x, o.z.y);
    taylor_orbit_free(&o);
    plane_end(&s, &c);
    return e.left ? n : 0;
}

static void who_has_gone_round_the_window_never_returns(void **state)
{
    (void) state;
    assert_in_range(pieces_until_left("x' = 0.1*x - y; y' = x + 0.1*y", 10.0),
                    1, 200);
    assert_in_range(pieces_until_left("x' = 0.1*x + y; y' = 0.1*y - x", 10.0),
                    1, 200);
    /* closed, inward, within the window, and a flower that comes back in */
    assert_int_equal(pieces_until_left("x' = -y; y' = x", 20.0), 0);
    assert_int_equal(pieces_until_left("x' = -0.1*x - y; y' = x - 0.1*y", 20.0),
                     0);
    assert_int_equal(pieces_until_left("g = 0.4 - x^2 - y^2; x' = x*g - y; "
                                       "y' = y*g + x",
                                       20.0),
                     0);
    assert_int_equal(pieces_until_left("x' = -3*y; y' = x/3", 20.0), 0);
}

/* The cycle of van der Pol is outside of a small window. */
static void what_is_beyond_is_followed_where_it_is_asked_for(void **state)
{
    struct plane_study s;
    struct scene c;
    struct plane_goal goal;

    (void) state;
    plane_run(&s, &c, "x' = y; y' = (1 - x^2)*y - x", WINDOW);
    const struct plane_guide guide = { .rounds = &s.rounds };
    const struct vec2 z = { 0.3, 0.2 };
    assert_int_equal(plane_orbit(&s, z, false, NULL, &goal), STATUS_OK);
    assert_int_equal(goal.kind, PLANE_GOAL_LEFT);
    assert_int_equal(plane_orbit(&s, z, false, &guide, &goal), STATUS_OK);
    assert_int_equal(goal.kind, PLANE_GOAL_CYCLE);
    assert_int_equal(plane_orbit(&s, z, true, NULL, &goal), STATUS_OK);
    assert_int_equal(goal.kind, PLANE_GOAL_REST);
    plane_end(&s, &c);
}

/* From anywhere, as far as the window is small beside that. */
static void who_starts_far_away_arrives_too(void **state)
{
    static const double x[] = { 140.0, 210.0, -1e6, 1e12 };
    struct plane_study s;
    struct scene c;
    struct plane_goal goal;

    (void) state;
    plane_run(&s, &c, "x' = -x; y' = -y", WINDOW);
    for (int i = 0; i < 4; i++) {
        const struct vec2 z = { x[i], 1.0 };
        assert_int_equal(plane_orbit(&s, z, false, NULL, &goal), STATUS_OK);
        CHECK(goal.kind == PLANE_GOAL_REST && goal.index == 0, "from %g: %d",
              x[i], (int) goal.kind);
        assert_int_equal(plane_orbit(&s, z, true, NULL, &goal), STATUS_OK);
        CHECK(goal.kind == PLANE_GOAL_BEYOND && !goal.beyond.rests,
              "back from %g: %d", x[i], (int) goal.kind);
    }
    plane_end(&s, &c);
}

static void stiff_orbits_arrive_too(void **state)
{
    struct plane_study s;
    struct scene c;
    struct plane_goal goal;

    (void) state;
    plane_run(&s, &c, "x' = y; y' = 1000*(1 - x^2)*y - x",
              "window={x: [-3, 3], y: [-2000, 2000]}\nproducts=[equilibria]\n");
    assert_int_equal(
        plane_orbit(&s, (struct vec2){ 0.1, -1500.0 }, false, NULL, &goal),
        STATUS_OK);
    assert_int_equal(goal.kind, PLANE_GOAL_CYCLE);
    plane_end(&s, &c);
}

/* Its implicit steps are off by what the series of others are not. */
static void stiff_orbits_close_on_their_cycle(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = 30*(x - x^3/3 - y); y' = x + 0.5 - 0.3*y",
              "window={x: [-3, 3], y: [-2, 2]}\nproducts=[basins]\n"
              "basins.audit=10\n");
    assert_int_equal(s.cycles, 1);
    CHECK(s.basin.elsewhere.undecided.value == 0.0, "%g",
          s.basin.elsewhere.undecided.value);
    plane_end(&s, &c);
}

/* Nearly along a straight line, in steps longer than a hundredth of the window:
 * that the velocity hardly changes in them is no sign of a stiff field. */
static void straight_ways_cost_little(void **state)
{
    struct plane_study s;
    struct scene c;
    struct plane_goal goal;

    (void) state;
    plane_run(&s, &c, "x' = 1; y' = 0.002*cos(k*x); k = 20", WINDOW);
    assert_int_equal(
        plane_orbit(&s, (struct vec2){ 0.0, 0.0 }, false, NULL, &goal),
        STATUS_OK);
    assert_int_equal(goal.kind, PLANE_GOAL_BEYOND);
    CHECK(goal.steps < 2000, "%zu steps", goal.steps);
    plane_end(&s, &c);
}

/* A hundred rounds to where it is infinite, thousands of regions about the two
 * foci: the steps of all orbits are counted. */
static void spirals_on_a_wide_window_cost_little(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = y; y' = x*(1 - x)*(x - 0.3) + 0.2*y",
              "window={x: [-10, 10], y: [-10, 10]}\nproducts=[basins]\n"
              "basins.audit=100\n");
    const struct quantity *q = &s.basin.elsewhere.infinity;
    CHECK(fabs(q->value - 1.0) <= q->error && q->error < 1e-4, "%.17g +- %g",
          q->value, q->error);
    assert_int_equal(s.basin.disagreements, 0);
    assert_int_equal(s.basin.cells, 100);
    CHECK(s.basin.steps < 200000, "%lld steps", (long long) s.basin.steps);
    plane_end(&s, &c);
}

/* The pendulum without damping: between the separatrices, half of the strip
 * that they enclose, all orbits close, and none is an attractor. */
static void rounding_makes_no_closed_orbits(void **state)
{
    static const char *const ode[] = { "x' = y; y' = -sin(x)",
                                       "x' = y; y' = x - x^2" };
    struct plane_study s;
    struct scene c;

    (void) state;
    for (int i = 0; i < 2; i++) {
        plane_run(&s, &c, ode[i],
                  i == 0 ? "window={x: [-4, 4], y: [-3, 3]}\n"
                           "products=[basins]\nbasins.audit=10\n"
                         : "window={x: [-1, 2], y: [-1, 1]}\n"
                           "products=[basins]\nbasins.audit=10\n");
        assert_int_equal(s.cycles, 0);
        assert_int_equal(s.basin.disagreements, 0);
        const struct quantity *q = &s.basin.elsewhere.undecided;
        if (i == 1) /* 6/5 of 6 */
            CHECK(fabs(q->value - 0.2) <= q->error && q->error < 1e-6,
                  "%.17g +- %g", q->value, q->error);
        plane_end(&s, &c);
    }
}

/* Into the well at 8 pi, in rounds that are a hundredth smaller each, down to
 * where steps are off by as much: that is no closed orbit. */
static void slow_spirals_are_no_cycles(void **state)
{
    struct plane_study s;
    struct scene c;
    struct plane_goal goal;
    size_t index;

    (void) state;
    plane_run(&s, &c, "x' = y; y' = -sin(x) - 0.003*y",
              "window={x: [-6, 6], y: [-3, 3]}\nproducts=[equilibria]\n");
    const struct plane_guide guide = { .rounds = &s.rounds };
    for (int i = 0; i < 4; i++) {
        const struct vec2 z = { -0.1548, 2.04813 + 0.1 * i };
        assert_int_equal(plane_orbit(&s, z, false, &guide, &goal), STATUS_OK);
        if (goal.kind == PLANE_GOAL_CYCLE)
            assert_int_equal(plane_cycle_add(&s, &goal.round, true, &index),
                             STATUS_OK);
        CHECK(s.cycles == 0, "from y = %g", z.y);
    }
    plane_end(&s, &c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(series_stay_on_a_logarithmic_spiral),
        cmocka_unit_test(who_has_gone_round_the_window_never_returns),
        cmocka_unit_test(what_is_beyond_is_followed_where_it_is_asked_for),
        cmocka_unit_test(who_starts_far_away_arrives_too),
        cmocka_unit_test(stiff_orbits_arrive_too),
        cmocka_unit_test(stiff_orbits_close_on_their_cycle),
        cmocka_unit_test(straight_ways_cost_little),
        cmocka_unit_test(spirals_on_a_wide_window_cost_little),
        cmocka_unit_test(rounding_makes_no_closed_orbits),
        cmocka_unit_test(slow_spirals_are_no_cycles),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
