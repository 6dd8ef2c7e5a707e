/* Shares of basins where the field ends, is degenerate, or no curve is known
 * that divides. */
#include <time.h>

#include "plane_basin.h"
#include "plane_map.h"
#include "plane_numbers.h"
#include "plane_orbit.h"
#include "plane_shares.h"

#define WINDOW                                                                 \
    "window={x: [-2, 2], y: [-2, 2]}\nproducts=[basins]\nbasins.audit=200\n"
#define TEST(test)                                                             \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

/* A thousandth of the window ends in the fold at 0, where rounding decides
 * which way orbits go on: the audit meets some that the map does not show. */
static void orbits_that_end_nowhere_known_contradict_nothing(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = x^2*(1 - x); y' = -y",
              "window={x: [-0.002, 2], y: [-1, 1]}\nproducts=[basins]\n"
              "basins.audit=4000\n");
    assert_int_equal(s.basin.disagreements, 0);
    CHECK(s.basin.cells > 3980 && s.basin.cells < 4001, "%lld of 4000",
          (long long) s.basin.cells);
    plane_end(&s, &c);
}

/* Left of x = 0 orbits go to (0, 0), at no rate; right of it to infinity. */
static void next_to_a_fold_nothing_is_said(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = x^2; y' = -y", WINDOW);
    is_nearly(&s, "x_to_infinity", 0.5);
    CHECK(s.basin.elsewhere.undecided.value >= 0.5, "%g",
          s.basin.elsewhere.undecided.value);
    plane_end(&s, &c);
}

/* Poles, the edge of a domain, the manifold of a saddle that is outside: the
 * formulas' own curves are asked for by orbits. */
static void borders_that_are_not_known_are_closed_in_on(void **state)
{
    static const struct {
        const char *ode, *name;
        double share;
    } at[] = {
        { "x' = 1/x - x; y' = -y", "stable_node_0", 0.5 },
        { "x' = -tan(x); y' = -y", "stable_node_0", M_PI / 4.0 },
        { "x' = sqrt(x) - 1; y' = 1 - y", "singularity", 0.75 },
        { "X = x - y/5; x' = X^2 - X - y/5; y' = -y", "stable_node_0",
          1.0 - 0.225 / 11.6 },
    };
    struct plane_study s;
    struct scene c;
    int8_t map[16 * 16], one;

    (void) state;
    for (int i = 0; i < 4; i++) {
        plane_run(&s, &c, at[i].ode,
                  i < 3 ? WINDOW /* the saddle is at (1, 0) */
                        : "window={x: [-2, 0.9], y: [-2, 2]}\n"
                          "products=[basins]\nbasins.audit=200\n");
        is_nearly(&s, at[i].name, at[i].share);
        assert_int_equal(plane_map_fill(&s, 16, 16, 0, 16, map), STATUS_OK);
        for (size_t k = 0; k < 256; k++) {
            const struct vec2 z = { plane_map_cell(&s, 0, k % 16, 16, true),
                                    plane_map_cell(&s, 1, k / 16, 16, true) };
            assert_int_equal(plane_map_at(&s, z, true, &one), STATUS_OK);
            assert_int_equal(one < 0 ? (int8_t) s.basin.labels : one, map[k]);
        }
        plane_end(&s, &c);
    }
}

/* r' = r (1 - r^2)^2: orbits come to r = 1 from inside, and leave it outside.
 */
static void a_cycle_that_attracts_on_one_side_is_no_attractor(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    for (int i = 0; i < 2; i++) {
        plane_run(&s, &c,
                  i == 0 ? "g = (1 - x^2 - y^2)^2; x' = x*g - y; y' = y*g + x"
                         : "g = (1 - x^2 - y^2)^2; x' = y - x*g; y' = -y*g - x",
                  "window={x: [-1.5, 1.5], y: [-1.5, 1.5]}\n"
                  "products=[basins]\nbasins.audit=40\n");
        assert_int_equal(s.cycles, 0);
        const double value =
                         share_of(&s, i == 0 ? "infinity" : "stable_focus_0")
                             ->fraction.value,
                     disc = M_PI / 9.0;
        CHECK(value <= (i == 0 ? 1.0 - disc : disc), "%g", value);
        assert_int_equal(s.basin.disagreements, 0);
        plane_end(&s, &c);
    }
}

/* x' > 0 beside x = 0, or beside the centre manifold's origin: no orbit from
 * the left comes to (1, .), though a step may be as long. */
static void orbits_do_not_step_across_what_is_degenerate(void **state)
{
    static const char *const ode[] = {
        "x' = x^2*(1 - x); y' = -y",
        "x' = x^4*(1 - x); y' = -y",
        "x' = x^2*y - x^5; y' = -y + x^2",
    };
    struct plane_study s;
    struct scene c;

    (void) state;
    for (int i = 0; i < 3; i++) {
        plane_run(&s, &c, ode[i], WINDOW);
        const struct quantity *q = &share_of(&s, "stable_node_0")->fraction;
        CHECK(q->value <= 0.5 + q->error, "%s: %g", ode[i], q->value);
        CHECK(s.basin.elsewhere.undecided.value > 0.49, "%s", ode[i]);
        plane_end(&s, &c);
    }
}

/* Lotka and Volterra: closed orbits where both are positive; elsewhere all go
 * to infinity. */
static void orbits_about_a_centre_do_not_leave(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = x*(1 - y); y' = y*(x - 1)",
              "window={x: [-1, 3], y: [-1, 2]}\nproducts=[basins]\n"
              "basins.audit=20\n");
    const struct quantity *q = &s.basin.elsewhere.infinity;
    has_share(&s, "undecided", 0.5, 1e-11);
    CHECK(fabs(q->value - 0.5) <= q->error && q->error <= 1e-11,
          "%.17g +- %g go beyond all bounds", q->value, q->error);
    plane_end(&s, &c);
}

/* The field ends at x = 0, 1, 0, or at the poles of the tangent: all orbits run
 * there in a finite time, though one might step across. */
static void where_the_field_ends_is_not_infinity(void **state)
{
    static const struct {
        const char *ode;
        double singular, up;
    } at[] = {
        { "x' = -1/x; y' = -y", 1.0, 0.0 },
        { "x' = -x + 1/(1 - x); y' = -y", 1.0, 0.0 },
        { "x' = sqrt(x) - 1; y' = -y", 0.75, 0.25 },
        { "x' = sqrt(x) - 1; y' = -ln(y + 1)", 0.8125, 0.1875 },
        { "x' = tan(x); y' = -y", 1.0, 0.0 },
        { "x' = 1/(1 + x^2); y' = -y", 0.0, 1.0 },
    };
    struct plane_study s;
    struct scene c;

    (void) state;
    for (int i = 0; i < 6; i++) {
        plane_run(&s, &c, at[i].ode, WINDOW);
        if (at[i].singular > 0.0)
            has_share(&s, "singularity", at[i].singular, 1e-12);
        if (at[i].up > 0.0)
            has_share(&s, "x_to_infinity_y_to_0", at[i].up, 1e-12);
        CHECK(s.basin.elsewhere.undecided.value <= 0.0, "%s", at[i].ode);
        plane_end(&s, &c);
    }
}

/* Both poles repel on one side and attract on the other; orbits that run into
 * one are not followed along it until there is no work for others. */
static void orbits_that_end_at_a_pole_leave_work_for_the_others(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = 4/(1+y^3) - x; y' = 4/(1+x^3) - y",
              "window={x: [-2, 5], y: [-2, 5]}\nproducts=[basins]\n"
              "basins.audit=200\n");
    CHECK(s.basin.disagreements == 0, "%lld of %lld go elsewhere",
          (long long) s.basin.disagreements, (long long) s.basin.cells);
    CHECK(s.basin.elsewhere.undecided.value < 0.02, "%g undecided",
          s.basin.elsewhere.undecided.value);
    plane_end(&s, &c);
}

/* An electrostatic actuator: from the left of the plate at x = 1 orbits come to
 * (0.133, 0) or run into it, from the right of it, which repels without bound,
 * they come to (1.28, 0).  Bands between the turns of the saddle's manifold are
 * 0.2 to 1 % of the window high, and go across the plate. */
static void no_orbit_speaks_across_a_pole(void **state)
{
    enum { N = 64 };
    struct plane_study s;
    struct scene c;
    struct plane_goal goal;
    int8_t map[N * N];

    (void) state;
    plane_run(&s, &c, "x' = v; v' = -x - 0.2*v + 0.1/(1 - x)^2",
              "window={x: [-1, 2], v: [-1.5, 1.5]}\nproducts=[basins]\n"
              "basins.audit=500\n");
    assert_int_equal(plane_map_fill(&s, N, N, 0, N, map), STATUS_OK);
    for (size_t k = 0; k < N * N; k++) {
        const double x = plane_map_cell(&s, 0, k % N, N, true),
                     v = plane_map_cell(&s, 1, k / N, N, true);
        const char *name = s.basin.name[map[k]];
        CHECK(strcmp(name, "undecided") == 0 ||
                  (strcmp(name, "stable_focus_1") == 0) == (x > 1.0),
              "(%g, %g) goes to %s", x, v, name);
    }
    assert_int_equal(s.basin.disagreements, 0);
    CHECK(s.basin.elsewhere.undecided.value < 0.06, "%g undecided",
          s.basin.elsewhere.undecided.value);
    assert_int_equal(
        plane_orbit(&s, (struct vec2){ 0.617, 0.0234 }, false, NULL, &goal),
        STATUS_OK);
    CHECK(goal.kind == PLANE_GOAL_BEYOND && goal.beyond.breaks &&
              goal.steps < 500,
          "%d after %zu steps", goal.kind, goal.steps);
    plane_end(&s, &c);
}

/* Its own end, and the length to there; beside the pole that repels, which is
 * no border, cells are asked. */
static void manifolds_do_not_cross_poles(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = tan(x); y' = -y", WINDOW);
    for (int k = 0; k < 2; k++) {
        const struct plane_branch *b =
            plane_branch_of(&s, 0, MANIFOLD_UNSTABLE, k);
        assert_int_equal(b->end, PLANE_END_SINGULARITY);
        CHECK(fabs(b->length.value - M_PI_2) <= b->length.error &&
                  b->length.error < 1e-8,
              "%.17g +- %g", b->length.value, b->length.error);
    }
    plane_end(&s, &c);
    plane_run(&s, &c, "x' = 1/x - x; y' = -y", WINDOW);
    is_nearly(&s, "stable_node_0", 0.5);
    is_nearly(&s, "stable_node_1", 0.5);
    plane_end(&s, &c);
}

/* One straight piece runs from the saddle through the node to the pole; or
 * through what is degenerate to the node. */
static void manifolds_end_at_what_comes_first(void **state)
{
    static const struct {
        const char *ode;
        int end;
        double length;
    } at[] = {
        { "x' = (x^2 - 1)/(x - 2); y' = -y", PLANE_END_EQUILIBRIUM, 2.0 },
        { "x' = (x + 1)*x^2*(1 - x); y' = -y", -1, 1.0 },
    };
    struct plane_study s;
    struct scene c;

    (void) state;
    for (int i = 0; i < 2; i++) {
        plane_run(&s, &c, at[i].ode,
                  "window={x: [-3, 3], y: [-1, 1]}\nproducts=[manifolds]\n");
        const struct plane_branch *b =
            plane_branch_of(&s, 0, MANIFOLD_UNSTABLE, 0);
        assert_int_equal(b->end, at[i].end);
        CHECK(fabs(b->length.value - at[i].length) <= b->length.error + 1e-9 &&
                  b->length.error < 1e-6,
              "%s: %.17g +- %g", at[i].ode, b->length.value, b->length.error);
        plane_end(&s, &c);
    }
}

/* The pendulum's saddles beyond the window, to which curves go, are not the one
 * they come from; orbits to (3, 0), from the left, do not step across. */
static void outside_the_window_nothing_passes_an_equilibrium(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = y; y' = -sin(x)",
              "window={x: [-4, 4], y: [-3, 3]}\nproducts=[manifolds]\n");
    for (int k = 0; k < 2; k++) {
        const struct plane_branch *b =
            plane_branch_of(&s, 1, MANIFOLD_STABLE, k);
        assert_int_equal(b->end, PLANE_END_SADDLE);
        CHECK(b->length.value < 8.0, "%g", b->length.value);
    }
    plane_end(&s, &c);
    plane_run(&s, &c, "x' = (x - 3)^2*(x + 1); y' = -y",
              "window={x: [-2, 2], y: [-1, 1]}\nproducts=[basins]\n"
              "basins.audit=10\n");
    assert_int_equal(plane_branch_of(&s, 0, MANIFOLD_UNSTABLE, 0)->end,
                     PLANE_END_EDGE);
    has_share(&s, "x_to_-infinity", 0.25, 1e-12);
    has_share(&s, "infinity", 0.0, 1e-12);
    plane_end(&s, &c);
}

/* Whose orbits nearly all close: the integral of the divergence round them is
 * 0, though rounding may bring them nearer to each other. */
static void closed_orbits_of_a_well_attract_nothing(void **state)
{
    static const char *const ode[] = {
        "x' = y; y' = x - x^3",
        "x' = y; y' = -x",
        "x' = x*(1 - y) + 2*(1 - y); y' = (y + 3)*x",
    };
    struct plane_study s;
    struct scene c;

    (void) state;
    for (int i = 0; i < 3; i++) {
        plane_run(&s, &c, ode[i], WINDOW);
        CHECK(s.cycles == 0, "%s: %zu cycles", ode[i], s.cycles);
        plane_end(&s, &c);
    }
}

/* 13 by 19 equilibria, 54 of which attract. */
static void all_equilibria_of_a_wide_window_are_listed(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = sin(x); y' = -sin(y)",
              "window={x: [-20.5, 20.5], y: [-30.5, 30.5]}\n"
              "products=[basins]\nbasins.audit=200\n");
    assert_true(s.complete);
    assert_int_equal(s.listed, 13 * 19);
    assert_int_equal(s.basin.disagreements, 0);
    CHECK(share_of(&s, "undecided")->fraction.value < 0.03, "%g undecided",
          share_of(&s, "undecided")->fraction.value);
    plane_end(&s, &c);
}

/* When it was told last, the longest between, in seconds of the processor, and
 * when it stops. */
struct told {
    clock_t last, end;
    double longest;
};

static int tell(void *ctx, const char *stage, uint64_t done, uint64_t total)
{
    struct told *t = ctx;
    const clock_t now = clock();

    (void) stage;
    (void) done;
    (void) total;
    t->longest =
        fmax(t->longest, (double) (now - t->last) / (double) CLOCKS_PER_SEC);
    t->last = now;
    return now >= t->end;
}

/* All states of N = 0 rest, and the determinant there is a double 0: half of
 * the orbits come to that line, where no search finds one equilibrium. */
static void a_line_of_equilibria_is_not_searched_by_every_orbit(void **state)
{
    enum { SECONDS = 60 };
    struct told told = { .longest = 0.0 };
    const struct monitor monitor = { tell, &told };
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "n' = -n^2; p' = -0.29*n^2 - 1.42*n - 2*n*p",
              "window={n: [0, 10], p: [0, 10]}\nproducts=[equilibria]\n"
              "basins.audit=20\n");
    told.last = clock();
    told.end = told.last + SECONDS * CLOCKS_PER_SEC;
    assert_int_equal(plane_basin_find(&s, &monitor), STATUS_OK);
    CHECK(told.longest < 2.0, "an interrupt is heard after %g s", told.longest);
    CHECK(s.basin.unknown[PLANE_UNKNOWN_LOST] &&
              share_of(&s, "undecided")->fraction.value > 0.5,
          "%g undecided", share_of(&s, "undecided")->fraction.value);
    told.end = clock() + CLOCKS_PER_SEC / 10;
    plane_basin_free(&s.basin);
    assert_int_equal(plane_basin_find(&s, &monitor), STATUS_STOPPED);
    plane_end(&s, &c);
}

static void what_is_undecided_has_its_reasons(void **state)
{
    static const struct {
        const char *ode;
        enum plane_unknown why;
    } at[] = {
        { "x' = y; y' = -x", PLANE_UNKNOWN_CLOSED },
        { "x' = x^2; y' = -y", PLANE_UNKNOWN_LOST },
    };
    struct plane_study s;
    struct scene c;

    (void) state;
    for (int i = 0; i < 2; i++) {
        plane_run(&s, &c, at[i].ode, WINDOW);
        for (int k = 0; k < PLANE_UNKNOWN_CELLS; k++)
            CHECK(s.basin.unknown[k] == (k == (int) at[i].why), "%s: %d",
                  at[i].ode, k);
        CHECK(s.basin.unknown[PLANE_UNKNOWN_CELLS] == (i > 0), "%s", at[i].ode);
        for (int k = 0; k < PLANE_UNKNOWNS; k++)
            CHECK(plane_unknown_texts[k] != NULL, "%d", k);
        /* an audit that disagrees widens the bars of all shares */
        s.basin.share[s.basin.labels].fraction.error = 1.0;
        assert_true(plane_numbers_lack(&s));
        plane_end(&s, &c);
    }
}

/* Two branches come to the node that repels from above and from below; on the
 * row through it, between their ends, both sides are beside nothing. */
static void a_row_through_the_ends_of_two_branches_has_no_label(void **state)
{
    struct plane_study s;
    struct scene c;
    int8_t label;

    (void) state;
    plane_run(&s, &c,
              "x' = -sin(2*x)*cos(y) - 0.2*x;"
              "y' = -cos(2*x)*sin(y)/2 - 0.2*y",
              "window={x: [-4, 4], y: [-4, 4]}\nproducts=[basins]\n"
              "basins.audit=100\n");
    assert_int_equal(s.basin.disagreements, 0);
    for (int i = -39; i < 40; i++) {
        assert_int_equal(
            plane_map_at(&s, (struct vec2){ 0.1 * i, 0.0 }, true, &label),
            STATUS_OK);
        CHECK(label < 0 || label == (abs(i) < 18 ? 1
                                     : i < 0     ? 0
                                                 : 2),
              "x = %g: %d", 0.1 * i, label);
    }
    plane_end(&s, &c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(orbits_that_end_nowhere_known_contradict_nothing),
        TEST(next_to_a_fold_nothing_is_said),
        TEST(borders_that_are_not_known_are_closed_in_on),
        TEST(a_cycle_that_attracts_on_one_side_is_no_attractor),
        TEST(orbits_do_not_step_across_what_is_degenerate),
        TEST(orbits_about_a_centre_do_not_leave),
        TEST(where_the_field_ends_is_not_infinity),
        TEST(orbits_that_end_at_a_pole_leave_work_for_the_others),
        TEST(no_orbit_speaks_across_a_pole),
        TEST(manifolds_do_not_cross_poles),
        TEST(manifolds_end_at_what_comes_first),
        TEST(outside_the_window_nothing_passes_an_equilibrium),
        TEST(closed_orbits_of_a_well_attract_nothing),
        TEST(a_line_of_equilibria_is_not_searched_by_every_orbit),
        TEST(all_equilibria_of_a_wide_window_are_listed),
        TEST(what_is_undecided_has_its_reasons),
        TEST(a_row_through_the_ends_of_two_branches_has_no_label),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
