/* Shares that curves and ends outside the window decide: by symmetry, as areas,
 * and as the same states have it in a larger window. */
#include "plane_answer.h"
#include "plane_map.h"
#include "plane_orbit.h"
#include "plane_shares.h"

#define WINDOW(x, y)                                                           \
    "window={x: " x ", y: " y "}\nproducts=[basins]\nbasins.audit=100\n"

/* Each with what goes to one end of two. */
static void a_saddle_outside_the_window_divides_it(void **state)
{
    static const struct {
        const char *ode, *window, *end[2];
        double share;
    } at[] = {
        { "x' = x; y' = -y",
          WINDOW("[-1, 1]", "[1, 2]"),
          { "x_to_infinity", "x_to_-infinity" },
          0.5 },
        { "x' = x - x^3; y' = -y",
          WINDOW("[-0.4, 0.8]", "[1, 2]"),
          { "x_to_1_y_to_0", "x_to_-1_y_to_0" },
          2.0 / 3.0 },
        { "x' = 10/(1 + y^2) - x; y' = 10/(1 + x^2) - y",
          WINDOW("[0, 1]", "[0, 1]"),
          { "x_to_9.899_y_to_0.10102", "x_to_0.10102_y_to_9.899" },
          0.5 },
    };
    struct plane_study s;
    struct scene c;

    (void) state;
    for (size_t i = 0; i < 3; i++) {
        plane_run(&s, &c, at[i].ode, at[i].window);
        has_share(&s, at[i].end[0], at[i].share, 1e-12);
        has_share(&s, at[i].end[1], 1.0 - at[i].share, 1e-12);
        plane_end(&s, &c);
    }
}

/* r' = r (r^2 - 1): the disc's part in the window. */
static void a_cycle_that_leaves_the_window_divides_it(void **state)
{
    const double disc = M_PI / 3.0 - sqrt(3.0) / 4.0;
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "g = x^2 + y^2 - 1; x' = x*g - y; y' = y*g + x",
              WINDOW("[0.5, 2]", "[-1, 1]"));
    has_share(&s, "x_to_0_y_to_0", disc / 3.0, 1e-11);
    plane_end(&s, &c);
}

/* The place of the equilibrium that attracts with a label. */
static struct vec2 rest_of(const struct plane_study *s, int8_t label)
{
    for (size_t i = 0; i < s->rests; i++)
        if (strcmp(s->rest[i].name, s->basin.name[label]) == 0)
            return s->rest[i].z;
    CHECK(false, "%s is no equilibrium", s->basin.name[label]);
    return (struct vec2){ 0 };
}

/* The saddle is outside, its manifold winds through the window fourteen times;
 * and four saddles of a pendulum. */
static void narrow_windows_know_what_wide_ones_do(void **state)
{
    static const struct {
        const char *ode, *narrow, *wide;
    } at[] = {
        { "x' = y; y' = x - x^3 - 0.1*y", WINDOW("[0.5, 4]", "[-3, 3]"),
          WINDOW("[-4, 4]", "[-4, 4]") },
        { "x' = y; y' = -sin(x) - 0.2*y", WINDOW("[2, 7]", "[-2, 2]"),
          WINDOW("[-8, 20]", "[-3, 3]") },
    };
    struct plane_study s, w;
    struct scene c, d;

    (void) state;
    for (size_t i = 0; i < 2; i++) {
        plane_run(&s, &c, at[i].ode, at[i].narrow);
        plane_run(&w, &d, at[i].ode, at[i].wide);
        has_share(&s, "undecided", 0.0, 1e-11);
        for (int k = 0; k < 400; k++) {
            const struct vec2 z = window_at(&s.window, vec2_spread(0.7, k));
            int8_t a, b;
            assert_int_equal(plane_map_at(&s, z, true, &a), STATUS_OK);
            assert_int_equal(plane_map_at(&w, z, true, &b), STATUS_OK);
            if (a < 0 || b < 0)
                continue;
            const struct vec2 off = vec2_sub(rest_of(&s, a), rest_of(&w, b));
            CHECK(vec2_length(off) < 1e-9, "%g, %g: %s, but %s", z.x, z.y,
                  s.basin.name[a], w.basin.name[b]);
        }
        plane_end(&s, &c);
        plane_end(&w, &d);
    }
}

/* The poles are on the window's edge: unstable manifolds may be borders, too,
 * and cross the stable ones at the saddle. */
static void curves_that_cross_at_a_saddle_share_out_the_window(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = 4/(1 + y^3) - x; y' = 4/(1 + x^3) - y",
              WINDOW("[-1, 5]", "[-1, 5]"));
    has_share(&s, "stable_node_0", 0.5, 1e-11);
    has_share(&s, "stable_node_1", 0.5, 1e-11);
    plane_end(&s, &c);
}

/* Tyson's Oregonator: the saddle is the window's corner, its manifolds leave
 * there. */
static void a_saddle_in_the_corner_has_manifolds(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c,
              "x' = (x*(1 - x) - 1.4*y*(x - 0.002)/(x + 0.002))/0.04; "
              "y' = x - y",
              WINDOW("[0, 1]", "[0, 1]"));
    has_share(&s, "cycle_0", 1.0, 1e-12);
    plane_end(&s, &c);
}

/* Where y > 0 each orbit comes back, from -x beyond e^(1/y): none is said to
 * go to infinity, and none where y < 0 to (0, 2). */
static void what_comes_back_from_afar_is_not_told_infinity(void **state)
{
    static const char ode[] = "x' = x*(3 - x - 2*y); y' = y*(2 - x - y)";
    struct plane_study s;
    struct scene c;
    struct plane_answer answer;
    int8_t label;

    (void) state;
    plane_run(&s, &c, ode, WINDOW("[-2, -1]", "[-1, 0.5]"));
    assert_int_equal(
        plane_answer_at(&s, (const double[]){ -1.2, 0.1 }, &answer), STATUS_OK);
    assert_string_equal(answer.attractor, "x_to_0_y_to_2");
    assert_int_equal(
        plane_answer_at(&s, (const double[]){ -1.2, -0.1 }, &answer),
        STATUS_OK);
    assert_string_equal(answer.attractor, "x_to_-infinity");
    for (int k = 0; k < 400; k++) {
        const struct vec2 z = window_at(&s.window, vec2_spread(0.7, k));
        assert_int_equal(plane_map_at(&s, z, true, &label), STATUS_OK);
        if (label >= 0)
            CHECK(strcmp(s.basin.name[label],
                         z.y > 0.0 ? "x_to_0_y_to_2" : "x_to_-infinity") == 0,
                  "%g, %g: %s", z.x, z.y, s.basin.name[label]);
    }
    CHECK(share_of(&s, "undecided")->fraction.value < 0.1, "much is undecided");
    plane_end(&s, &c);
}

/* Two genes that switch each other off, at 2.8e-24 and 2.7e-15 of one: the
 * field's direction is as small there. */
static void what_is_all_but_switched_off_comes_to_rest(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "u' = 2/(1 + v^50) - u; v' = 3/(1 + u^50) - v",
              "system.state={u: positive, v: positive}\n"
              "window={u: [0.01, 5], v: [0.01, 5]}\nproducts=[basins]\n"
              "basins.audit=50\n");
    has_share(&s, "u_to_2.7859e-24_v_to_3", 0.7121866531008, 1e-9);
    has_share(&s, "u_to_2_v_to_2.6645e-15", 1.0 - 0.7121866531008, 1e-9);
    plane_end(&s, &c);
}

/* Beside a rate of 1e10, nothing else seemed to move. */
static void what_is_slow_outside_does_not_rest_there(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = -1e10*(x - y); y' = 0.01*y*(y - 1)",
              "window={x: [-1, 1.5], y: [-1, 1.5]}\nproducts=[basins]\n"
              "basins.audit=50\n");
    has_share(&s, "stable_node_0", 0.8, 1e-9);
    has_share(&s, "x_to_infinity_y_to_infinity", 0.2, 1e-9);
    plane_end(&s, &c);
}

/* x = 0 rests, all along: an orbit that comes there tells of no equilibrium
 * that stands alone.  From x > 0, y > 0 all go to infinity. */
static void a_line_that_rests_goes_on_beyond_the_window(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = x*y; y' = x*(1 - y)", WINDOW("[-1, 1]", "[-1, 2]"));
    assert_int_equal(s.rests, 0);
    CHECK(!s.complete, "all equilibria are known");
    CHECK(share_of(&s, "x_to_infinity")->fraction.value <= 0.5 &&
              s.basin.disagreements == 0,
          "too much goes to infinity");
    plane_end(&s, &c);
}

/* x falls by e^-700 and more while y is above 1, and comes back; what falls
 * for good is told so. */
static void a_positive_state_comes_back_from_below_the_doubles(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    for (int i = 0; i < 2; i++) {
        plane_run(&s, &c,
                  i ? "x' = 1000*x*(1 - x - y); y' = 2 - y"
                    : "x' = 1000*x*(1 - x - y); y' = -y",
                  "system.state={x: positive, y: real}\n" WINDOW(
                      "[0.1, 2]", "[-1, 4]") "basins.audit=20\n");
        has_share(&s, i ? "x_to_0" : "stable_node_0", 1.0, 1e-12);
        plane_end(&s, &c);
    }
}

/* v' = 0.1 - u, u' = -u: v has its least value, v_0 - u_0 + 0.1 + 0.1 ln(10
 * u_0), where u is 0.1; it is 0 before, or grows without end. */
static void a_positive_state_that_is_0_in_time_is_told_so(void **state)
{
    static const struct vec2 at[] = { { 1.0, 0.66 }, { 1.0, 0.68 } };
    struct plane_study s;
    struct scene c;
    struct plane_goal goal;

    (void) state;
    plane_run(&s, &c, "u' = -u; v' = 0.1 - u",
              "system.state={u: positive, v: positive}\n"
              "window={u: [0.2, 3], v: [0.1, 3]}\nproducts=[equilibria]\n");
    for (int i = 0; i < 2; i++) {
        const struct vec2 z = { log(at[i].x), log(at[i].y) };
        assert_int_equal(plane_orbit(&s, z, false, NULL, &goal), STATUS_OK);
        CHECK(goal.kind == PLANE_GOAL_BEYOND &&
                  (goal.beyond.way[1] == PLANE_WAY_DOWN) == (i == 0),
              "v = %g: goal %d, way %d", at[i].y, (int) goal.kind,
              (int) goal.beyond.way[1]);
    }
    plane_end(&s, &c);
}

/* An epidemic that ends, and the weaker of two who destroy each other: to a
 * line of equilibria on an axis, along which all orbits go elsewhere. */
static void what_dies_out_beside_a_line_that_rests_is_told_so(void **state)
{
    static const char *const word[] = { "i_to_0", "s_to_0" };
    struct plane_study s;
    struct scene c;

    (void) state;
    for (int k = 0; k < 2; k++) {
        plane_run(&s, &c,
                  k ? "s' = -s*i; i' = -0.5*s*i"
                    : "s' = -2*s*i; i' = 2*s*i - i",
                  "system.state={s: positive, i: positive}\n"
                  "window={s: [0.1, 1], i: [1, 3]}\nproducts=[basins]\n"
                  "basins.audit=20\n");
        has_share(&s, word[k], 1.0, 1e-12);
        plane_end(&s, &c);
    }
}

#define POSITIVE(window)                                                       \
    "system.state={z: positive, s: positive}\nwindow=" window                  \
    "\nproducts=[basins]\nbasins.audit=20\n"

/* Each attacks the other's supply: s falls straight to e^-1e14 where nothing
 * bends it, and one step would be that long.  What is written with a factor in
 * its power goes where it goes without; where orbits are stiff at first they
 * get as far as others; two that help each other are soon as many as doubles
 * can tell, and some leave on the last step before they count as stiff. */
static void ways_out_are_followed_to_their_ends(void **state)
{
    static const struct {
        const char *text, *settings, *word;
    } way[] = {
        { "z' = 0.15*s*z; s' = -0.3*s*z",
          POSITIVE("{z: [0.01, 10], s: [0.01, 10]}"), "s_to_0" },
        { "s' = 1 - s*z^3; z' = 0.6*(s*(0.3*z)^3 - z)",
          POSITIVE("{z: [0.01, 10], s: [0.01, 10]}"), "s_to_infinity_z_to_0" },
        { "s' = 1 - s*z^3; z' = 0.6*(s*z^3 - z)",
          POSITIVE("{z: [0.01, 10], s: [0.01, 10]}"), "s_to_infinity_z_to_0" },
        { "s' = s*(0.2 + 1.2*s - 0.2*z); z' = z*(0.8 + 3*s - 1.5*z)",
          POSITIVE("{z: [0.01, 10], s: [0.01, 10]}"),
          "s_to_infinity_z_to_infinity" },
        { "z' = z*(0.8 + 3*s/1065.7 - 1.5*z/613.6); "
          "s' = s*(0.13 + 1.2*s/1065.7 - 0.2*z/613.6)",
          POSITIVE("{z: [0.6136, 6136], s: [1.0657, 10657]}"),
          "z_to_infinity_s_to_infinity" },
    };
    struct plane_study s;
    struct scene c;

    (void) state;
    for (size_t k = 0; k < sizeof way / sizeof *way; k++) {
        plane_run(&s, &c, way[k].text, way[k].settings);
        has_share(&s, way[k].word, 1.0, 1e-12);
        plane_end(&s, &c);
    }
}

/* Stiff orbits rest where others do, 500 windows away. */
static void a_stiff_orbit_rests_far_out(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    for (int i = 0; i < 2; i++) {
        plane_run(&s, &c,
                  i ? "x' = 1 - x/1000; y' = -1000*(y - x)"
                    : "x' = 1 - x/1000; y' = -(y - x)",
                  WINDOW("[-1, 1]", "[-1, 1]"));
        has_share(&s, "x_to_1000_y_to_1000", 1.0, 1e-12);
        plane_end(&s, &c);
    }
}

#define TEST(test)                                                             \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

/* Josephson's junction: what winds on to the cycle of an angle goes to infinity
 * on a real axis; a pendulum with little friction, which rotates for long, and
 * one with none do not. */
static void rotations_that_attract_go_to_infinity(void **state)
{
    struct plane_study s;
    struct scene c;
    struct plane_goal goal;

    (void) state;
    plane_run(&s, &c, "x' = y; y' = 1.3 - sin(x) - 1.1*y",
              WINDOW("[-2, 2]", "[-2, 2]"));
    has_share(&s, "x_to_infinity", 1.0, 1e-12);
    plane_end(&s, &c);
    plane_run(&s, &c, "x' = -y; y' = 0.8 - sin(-x) - 0.7*y",
              "window={x: [-3.1, 3.1], y: [-2, 3]}\nproducts=[basins]\n"
              "basins.audit=50\n");
    assert_int_equal(s.basin.disagreements, 0);
    CHECK(s.basin.elsewhere.undecided.value < 0.01, "%g undecided",
          s.basin.elsewhere.undecided.value);
    plane_end(&s, &c);
    for (int i = 0; i < 2; i++) {
        plane_run(&s, &c,
                  i ? "x' = y; y' = -sin(x)" : "x' = y; y' = -sin(x) - 0.01*y",
                  "window={x: [-3, 3], y: [-3, 3]}\nproducts=[equilibria]\n");
        assert_int_equal(
            plane_orbit(&s, (struct vec2){ 0.0, 2.9 }, false, NULL, &goal),
            STATUS_OK);
        CHECK(goal.kind != PLANE_GOAL_BEYOND || goal.beyond.rests, "%d", i);
        plane_end(&s, &c);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_saddle_outside_the_window_divides_it),
        TEST(a_cycle_that_leaves_the_window_divides_it),
        TEST(narrow_windows_know_what_wide_ones_do),
        TEST(curves_that_cross_at_a_saddle_share_out_the_window),
        TEST(a_saddle_in_the_corner_has_manifolds),
        TEST(what_comes_back_from_afar_is_not_told_infinity),
        TEST(what_is_all_but_switched_off_comes_to_rest),
        TEST(what_is_slow_outside_does_not_rest_there),
        TEST(a_line_that_rests_goes_on_beyond_the_window),
        TEST(a_positive_state_comes_back_from_below_the_doubles),
        TEST(a_positive_state_that_is_0_in_time_is_told_so),
        TEST(what_dies_out_beside_a_line_that_rests_is_told_so),
        TEST(ways_out_are_followed_to_their_ends),
        TEST(a_stiff_orbit_rests_far_out),
        TEST(rotations_that_attract_go_to_infinity),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
