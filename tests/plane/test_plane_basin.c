/* Shares of basins that are known: by symmetry, as areas, as nothing. */
#include "plane_map.h"
#include "plane_shares.h"
#include "plane_tolerance.h"

#define WINDOW                                                                 \
    "window={x: [-2, 2], y: [-2, 2]}\nproducts=[basins]\nbasins.audit=200\n"

static void wells_that_know_nothing_of_each_other_have_a_quarter_each(
    void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = x - x^3; y' = y - y^3", WINDOW);
    for (int i = 0; i < 4; i++) {
        char name[32];
        snprintf(name, sizeof name, "stable_node_%d", i);
        has_share(&s, name, 0.25, 1e-9);
    }
    assert_int_equal(s.basin.boundaries, 8);
    plane_end(&s, &c);
}

static void symmetric_systems_share_alike(void **state)
{
    static const char *const ode[] = {
        "x' = 10*(x - x^3/3 - y); y' = x - 3*y",
        "x' = y; y' = x - x^3 - 0.1*y",
        "x' = y; y' = x - x^3 - 0.35*y",
        "x' = y; y' = x - x^5 - 0.2*y",
    };
    struct plane_study s;
    struct scene c;

    (void) state;
    for (int i = 0; i < 4; i++) {
        plane_run(&s, &c, ode[i],
                  "window={x: [-1.5, 1.5], y: [-1.5, 1.5]}\n"
                  "products=[basins]\nbasins.audit=100\n");
        for (int k = 0; k < 2; k++)
            has_share(&s,
                      i == 0 ? (k ? "stable_node_1" : "stable_node_0")
                             : (k ? "stable_focus_1" : "stable_focus_0"),
                      0.5, 1e-11);
        plane_end(&s, &c);
    }
}

/* x = q(y) divides the window: the area to its left is known. */
static void a_bent_separatrix_has_the_area_beside_it(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c,
              "X = x - 0.3*y - 0.2*y^2; dy = -2*y; "
              "x' = X - X^3 + (0.3 + 0.4*y)*dy; y' = dy",
              WINDOW);
    /* the mean of 0.3 y + 0.2 y^2 over [-2, 2] */
    has_share(&s, "stable_node_0", 0.5 + 0.2 * 4.0 / 3.0 / 4.0, 1e-11);
    plane_end(&s, &c);
    plane_run(&s, &c, /* the same with a fold, upside down */
              "X = x - 0.3*y - 0.2*y^2; dy = -2*y; y' = dy; "
              "x' = X - X^3 + (0.3 + 0.4*y)*dy",
              WINDOW);
    has_share(&s, "stable_node_0", 0.5 + 0.2 * 4.0 / 3.0 / 4.0, 1e-11);
    plane_end(&s, &c);
}

static void a_cycle_that_attracts_has_all_of_van_der_pol(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = y; y' = (1 - x^2)*y - x",
              "window={x: [-4, 4], y: [-3, 3]}\nproducts=[basins]\n"
              "basins.audit=50\n");
    has_share(&s, "cycle_0", 1.0, 1e-12);
    plane_end(&s, &c);
}

/* Where x jumps, rounds are e^(10^6) nearer to it, and series are held back
 * between. */
static void a_cycle_that_jumps_is_one(void **state)
{
    static const char *const ode[] = {
        "x' = 1000*(x - x^3/3 + y); y' = -x/1000",
        "x' = (x - x^3/3 - y)/1e-6; y' = x",
    };
    struct plane_study s;
    struct scene c;

    (void) state;
    for (int i = 0; i < 2; i++) {
        plane_run(&s, &c, ode[i],
                  "window={x: [-3, 3], y: [-2, 2]}\nproducts=[basins]\n"
                  "basins.audit=50\n");
        has_share(&s, "cycle_0", 1.0, 1e-12);
        plane_end(&s, &c);
    }
}

/* r' = r (r^4 (1 - r^2) - 1e-5): what goes to the origin, r < 0.0563, is seen
 * by few orbits, and it takes 64,000 rounds to leave it backward. */
static void what_attracts_has_what_is_about_it(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c,
              "r2 = x^2 + y^2; g = r2^2*(1 - r2) - 1e-5; x' = x*g - y; "
              "y' = y*g + x",
              WINDOW);
    assert_int_equal(s.basin.disagreements, 0);
    const double held = s.basin.share[0].fraction.value,
                 open = s.basin.elsewhere.undecided.value;
    CHECK(held + open > M_PI / 16.0 * 0.0563 * 0.0563 && held + open < 0.01,
          "%g of the focus and %g undecided", held, open);
    plane_end(&s, &c);
}

/* r' = r (r^2 - 1): the unit disc goes to the origin. */
static void a_cycle_that_repels_is_a_boundary(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "g = x^2 + y^2 - 1; x' = x*g - y; y' = y*g + x", WINDOW);
    has_share(&s, "stable_focus_0", M_PI / 16.0, 1e-9);
    has_share(&s, "infinity", 1.0 - M_PI / 16.0, 1e-9);
    assert_int_equal(s.basin.boundaries, 1);
    assert_string_equal(s.basin.boundary[0].of, "cycle_0");
    plane_end(&s, &c);
}

/* r' = r (1 - r^2)(r^2 - 4): each round is e^150 nearer to r = 2. */
static void cycles_that_attract_at_once_are_seen(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c,
              "g = (1 - x^2 - y^2)*(x^2 + y^2 - 4); x' = x*g - y; y' = y*g + x",
              "window={x: [-3, 3], y: [-3, 3]}\nproducts=[basins]\n"
              "basins.audit=50\n");
    has_share(&s, "stable_focus_0", M_PI / 36.0, 1e-9);
    has_share(&s, "cycle_1", 1.0 - M_PI / 36.0, 1e-9);
    plane_end(&s, &c);
}

/* A pendulum that is driven round: its divergence is -c everywhere, which
 * forbids closed orbits with an inside, not one around the cylinder.  Beyond
 * g = 1 that has all. */
static void a_driven_pendulum_rotates(void **state)
{
    static const char *const of[][2] = { { "0.3", "1.5" }, { "3", "1.5" } };
    struct plane_study s;
    struct scene c;
    char ode[80];

    (void) state;
    for (int i = 0; i < 2; i++) {
        snprintf(ode, sizeof ode, "x' = y; y' = %s - sin(x) - %s*y", of[i][1],
                 of[i][0]);
        plane_run(&s, &c, ode,
                  "system.state.x=angle\nwindow={y: [-3, 3]}\n"
                  "products=[basins]\nbasins.audit=50\n");
        has_share(&s, "cycle_0", 1.0, 1e-12);
        plane_end(&s, &c);
    }
    plane_run(&s, &c, "x' = y; y' = 0.6 - sin(x) - 0.3*y",
              "system.state.x=angle\nwindow={y: [-3, 3]}\n"
              "products=[manifolds, basins]\nbasins.audit=200\n");
    assert_int_equal(s.cycles, 1);
    assert_int_equal(s.branch[2].end, PLANE_END_CYCLE);
    assert_int_equal(s.branch[3].end, PLANE_END_EQUILIBRIUM);
    CHECK(s.basin.elsewhere.undecided.value < 1e-12, "%g undecided",
          s.basin.elsewhere.undecided.value);
    plane_end(&s, &c);
}

/* Closed orbits round a cylinder or a torus need not be highest anywhere: they
 * return where an angle has gone round.  One is a straight line; one locks 1:1,
 * and one 1:2, with another that repels beside it; r = 1/2 repels between
 * two. */
static void cycles_round_angles_are_seen(void **state)
{
    static const struct {
        const char *ode, *angles;
        double share; /* of cycle_0 */
        size_t cycles;
    } of[] = {
        { "x' = 1; y' = -y", "system.state.x=angle\nwindow={y: [-3, 3]}\n", 1.0,
          1 },
        { "y' = 0.6 - sin(x) - 1.3*y; x' = y + 1",
          "system.state.x=angle\nwindow={y: [-3, 3]}\n", 1.0, 1 },
        { "x' = 1 + 0.3*sin(y - x); y' = 1.2 + 0.3*sin(x - y)",
          "system.state={x: angle, y: angle}\n", 1.0, 2 },
        { "x' = 1 + 0.3*sin(y - 2*x) + 0.1*sin(3*x); "
          "y' = 2.1 - 0.3*sin(y - 2*x)",
          "system.state={x: angle, y: angle}\n", 1.0, 2 },
        { "r' = r*(1 - r)*(r - 0.5); x' = 1 + 0.2*cos(x)",
          "system.state.x=angle\nwindow={r: [-0.5, 1.5]}\n", 0.5, 3 },
        { "x' = 1 + 0.2*cos(x); r' = r*(1 - r)*(r - 0.5)",
          "system.state.x=angle\nwindow={r: [-0.5, 1.5]}\n", 0.5, 3 },
    };
    struct plane_study s;
    struct scene c;
    char text[200];

    (void) state;
    for (size_t i = 0; i < sizeof of / sizeof of[0]; i++) {
        snprintf(text, sizeof text, "%sproducts=[basins]\nbasins.audit=50\n",
                 of[i].angles);
        plane_run(&s, &c, of[i].ode, text);
        has_share(&s, "cycle_0", of[i].share, 1e-11);
        assert_int_equal(s.cycles, of[i].cycles);
        plane_end(&s, &c);
    }
}

/* Morris and Lecar's cell: a weak focus within a cycle that repels, within one
 * that attracts, beside a node. */
static void a_weak_focus_has_its_share(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c,
              "V' = (I - 2*(V + 60) - 8*w*(V + 84) - 2*(1 + tanh((V + "
              "1.2)/18))*(V - 120))/20; w' = 0.23*((1 + tanh((V - 12)/17.4))/2 "
              "- w)*cosh((V - 12)/34.8); I = 37",
              "window={V: [-70, 60], w: [-0.1, 0.8]}\nproducts=[basins]\n"
              "basins.audit=50\n");
    assert_int_equal(s.cycles, 2);
    const double focus = share_of(&s, "stable_focus_0")->fraction.value;
    CHECK(focus > 3e-3 && focus < 4e-3, "%g", focus);
    assert_int_equal(s.basin.disagreements, 0);
    plane_end(&s, &c);
    plane_run(&s, &c, "x' = -y - x*(x^2 + y^2); y' = x - y*(x^2 + y^2)",
              WINDOW);
    has_share(&s, "nonhyperbolic_0", 1.0, 1e-12);
    plane_end(&s, &c);
}

static void orbits_that_all_close_are_no_attractors(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = x*(1.1 - 0.4*y); y' = y*(0.1*x - 0.4)",
              "system.state={x: positive, y: positive}\n"
              "window={x: [0.1, 20], y: [0.1, 10]}\nproducts=[basins]\n");
    assert_int_equal(s.cycles, 0);
    has_share(&s, "undecided", 1.0, 1e-12);
    plane_end(&s, &c);
}

static void what_rests_outside_is_said_to(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = x - x^3; y' = -y",
              "window={x: [-0.5, 2], y: [-1, 1]}\nproducts=[basins]\n"
              "basins.audit=20\n");
    has_share(&s, "stable_node_0", 0.8, 1e-12);
    has_share(&s, "x_to_-1_y_to_0", 0.2, 1e-12);
    plane_end(&s, &c);
    plane_run(&s, &c, "x' = x - x^3; y' = -y",
              "window={x: [-0.5, 0.5], y: [-1, 1]}\nproducts=[basins]\n"
              "basins.audit=20\n");
    has_share(&s, "x_to_-1_y_to_0", 0.5, 1e-12);
    has_share(&s, "x_to_1_y_to_0", 0.5, 1e-12);
    assert_int_equal(s.basin.boundaries, 2);
    plane_end(&s, &c);
}

/* Lotka and Volterra: each alone is an attractor on an axis, which the chart
 * has at infinity; the species are alike. */
static void those_who_compete_share_alike(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = x*(1 - x - b*y); y' = y*(1 - y - b*x); b = 1.5",
              "system.state={x: positive, y: positive}\n"
              "window={x: [0.01, 2], y: [0.01, 2]}\nproducts=[basins]\n"
              "basins.audit=50\n");
    has_share(&s, "x_to_0_y_to_1", 0.5, 1e-12);
    has_share(&s, "x_to_1_y_to_0", 0.5, 1e-12);
    assert_int_equal(s.basin.boundaries, 2);
    assert_string_equal(s.basin.boundary[0].of, "saddle_0");
    plane_end(&s, &c);
}

/* Both die out: the chart has that at infinity, where the terms of x' are much
 * less than those they are the difference of. */
static void whoever_dies_out_is_followed_to_the_end(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = x*(x - 0.2)*(1 - x) - x*y; y' = y*(x - 0.5)",
              "system.state={x: positive, y: positive}\n"
              "window={x: [0.01, 1.5], y: [0.01, 1]}\nproducts=[basins]\n"
              "basins.audit=50\n");
    has_share(&s, "x_to_0_y_to_0", 1.0, 1e-12);
    plane_end(&s, &c);
}

/* Where orbits from one side of all borders have nothing in common, nothing is
 * said. */
static void ways_to_infinity_are_told_apart_where_they_differ(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = x; y' = -y", WINDOW);
    has_share(&s, "x_to_-infinity", 0.5, 1e-12);
    has_share(&s, "x_to_infinity", 0.5, 1e-12);
    plane_end(&s, &c);
    plane_run(&s, &c, "x' = x; y' = y", WINDOW);
    has_share(&s, "infinity", 1.0, 1e-12);
    plane_end(&s, &c);
    plane_run(&s, &c, "x' = x - y; y' = x + y", WINDOW);
    has_share(&s, "infinity", 1.0, 1e-12);
    plane_end(&s, &c);
    plane_run(&s, &c, "x' = x^2 - 1; y' = y", WINDOW);
    has_share(&s, "infinity", 1.0, 1e-12);
    plane_end(&s, &c);
}

/* y comes to 1/x, more and more slowly, and 0 is where no orbit is seen. */
static void what_falls_with_a_power_is_told_no_limit(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = 1/(1 + x^2); y' = 1/x - y",
              "window={x: [1, 3], y: [0.1, 1]}\nproducts=[basins]\n");
    has_share(&s, "x_to_infinity", 1.0, 1e-12);
    plane_end(&s, &c);
}

static void rows_of_the_map_agree_with_single_states(void **state)
{
    struct plane_study s;
    struct scene c;
    int8_t map[20 * 10], one;

    (void) state;
    plane_run(&s, &c, "x' = y; y' = x - x^3 - 0.3*y", WINDOW);
    assert_int_equal(plane_map_fill(&s, 20, 10, 0, 10, map), STATUS_OK);
    for (size_t i = 0; i < 200; i++) {
        const struct vec2 z = { plane_map_cell(&s, 0, i % 20, 20, true),
                                plane_map_cell(&s, 1, i / 20, 10, true) };
        assert_int_equal(plane_map_at(&s, z, true, &one), STATUS_OK);
        assert_int_equal(one, map[i]);
    }
    assert_int_equal(plane_map_at(&s, (struct vec2){ 0.0, 0.0 }, true, &one),
                     STATUS_OK);
    assert_int_equal(one, -1);
    plane_end(&s, &c);
}

#define TEST(test)                                                             \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

/* In (x, u), u = y - x^3/5, two wells that know nothing of each other: four
 * saddles, borders x = 0 and y = x^3/5, which are flat where they meet. */
static void a_border_that_ends_flat_is_one(void **state)
{
    static const double share[] = { 0.2, 0.3, 0.3, 0.2 };
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c,
              "x' = x - x^3; y' = y - w - (y - w)^3 + 0.6*x^2*(x - x^3); "
              "w = 0.2*x^3",
              WINDOW);
    for (int i = 0; i < 4; i++) {
        char name[32];
        snprintf(name, sizeof name, "stable_node_%d", i);
        has_share(&s, name, share[i], 2e-14);
    }
    plane_end(&s, &c);
}

/* Some 150 bands that the separatrices of two wells wind between them: a state
 * and its opposite go to opposite wells. */
static void bands_between_turns_go_where_their_side_leads(void **state)
{
    struct plane_study s;
    struct scene c;
    int8_t map[16 * 16];

    (void) state;
    plane_run(&s, &c, "x' = y; y' = x - x^3 - 0.01*y",
              "window={x: [-2, 2], y: [-2, 2]}\nproducts=[basins]\n"
              "basins.audit=50\n");
    has_share(&s, "stable_focus_0", 0.5, 1e-4);
    has_share(&s, "stable_focus_1", 0.5, 1e-4);
    assert_true(s.basin.steps < TOL_PLANE_WORK);
    assert_int_equal(plane_map_fill(&s, 16, 16, 0, 16, map), STATUS_OK);
    for (int k = 0; k < 128; k++)
        CHECK(map[k] + map[255 - k] == 1, "cell %d: %d, %d", k, map[k],
              map[255 - k]);
    plane_end(&s, &c);
}

/* Some hundred bands that go to as many equilibria outside the window, more
 * than there is work for: what is told is right. */
static void what_there_is_no_work_for_has_no_label(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = y; y' = -sin(x) - 0.003*y",
              "window={x: [-4, 4], y: [-3, 3]}\nproducts=[basins]\n"
              "basins.audit=100\n");
    assert_true(s.basin.unknown[PLANE_UNKNOWN_WORK]);
    CHECK(s.basin.elsewhere.undecided.value > 0.3, "%g undecided",
          s.basin.elsewhere.undecided.value);
    assert_int_equal(s.basin.disagreements, 0);
    plane_end(&s, &c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(wells_that_know_nothing_of_each_other_have_a_quarter_each),
        TEST(symmetric_systems_share_alike),
        TEST(a_bent_separatrix_has_the_area_beside_it),
        TEST(a_cycle_that_attracts_has_all_of_van_der_pol),
        TEST(a_cycle_that_jumps_is_one),
        TEST(what_attracts_has_what_is_about_it),
        TEST(a_cycle_that_repels_is_a_boundary),
        TEST(cycles_that_attract_at_once_are_seen),
        TEST(a_driven_pendulum_rotates),
        TEST(cycles_round_angles_are_seen),
        TEST(a_weak_focus_has_its_share),
        TEST(orbits_that_all_close_are_no_attractors),
        TEST(what_rests_outside_is_said_to),
        TEST(those_who_compete_share_alike),
        TEST(whoever_dies_out_is_followed_to_the_end),
        TEST(ways_to_infinity_are_told_apart_where_they_differ),
        TEST(what_falls_with_a_power_is_told_no_limit),
        TEST(rows_of_the_map_agree_with_single_states),
        TEST(a_border_that_ends_flat_is_one),
        TEST(bands_between_turns_go_where_their_side_leads),
        TEST(what_there_is_no_work_for_has_no_label),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
