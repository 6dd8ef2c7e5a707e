/* Traps as large as a turn: none reaches beyond what its focus attracts. */
#include "plane_turn.h"

#include "plane_cycle.h"
#include "plane_rest.h"
#include "plane_shares.h"

#define TEST(test)                                                             \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)
#define MORE   "products=[equilibria]\n"
#define WINDOW "window={x: [-2, 2], y: [-2, 2]}\n"

static size_t focus_at(const struct plane_study *s, double x)
{
    size_t i = 0;

    while (i < s->rests && !(fabs(s->rest[i].z.x - x) < 1e-9))
        i++;
    assert_true(i < s->rests);
    return i;
}

/* 2 V = y^2 - x^2 + x^4/2 falls along orbits, by 8/3 of the damping on a round
 * from the saddle, where it is 0: what is higher by more than that is of other
 * wells' bands, too. */
static void a_turn_is_nearly_all_of_a_well(void **state)
{
    static const double damping[] = { 0.3, 0.03, 0.003, 0.0003 };
    struct plane_study s;
    struct scene c;
    char ode[80];

    (void) state;
    for (int k = 0; k < 4; k++) {
        snprintf(ode, sizeof ode, "x' = y; y' = x - x^3 - %g*y", damping[k]);
        plane_run(&s, &c, ode, WINDOW MORE);
        const struct plane_rest *r = &s.rest[focus_at(&s, 1.0)];
        const struct plane_turn *t = &r->turn[0];
        assert_true(t->corners > 20 && r->turn[1].corners == 0);
        for (size_t i = 0; i < t->corners; i++) {
            const double x = r->z.x + 4.0 * t->at[i].x, y = 4.0 * t->at[i].y;
            CHECK(x > 0.0 && y * y - x * x + x * x * x * x / 2 < 4 * damping[k],
                  "%g: %g, %g", damping[k], x, y);
        }
        CHECK(4.0 * (t->box.hi.x - t->box.lo.x) > 1.1, "%g: %g wide",
              damping[k], 4.0 * (t->box.hi.x - t->box.lo.x));
        assert_true(plane_turn_holds(&s, r, false, (struct vec2){ 0.7, 0.1 }));
        assert_false(plane_turn_holds(&s, r, false, (struct vec2){ 0.7, 1.0 }));
        assert_false(plane_turn_holds(&s, r, true, (struct vec2){ 0.7, 0.1 }));
        plane_end(&s, &c);
    }
}

/* r' = -r^3/8 and less: as slow as that, and all go to it. */
static void a_focus_of_third_order_has_all_of_the_window(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = y - x^3; y' = -x",
              WINDOW "products=[basins]\nbasins.audit=50\n");
    has_share(&s, "nonhyperbolic_0", 1.0, 1e-9);
    assert_int_equal(s.basin.cells, 51);
    plane_end(&s, &c);
    plane_run(&s, &c, "x' = y + x^3; y' = -x", WINDOW MORE);
    assert_false(plane_rest_attracts(&s.rest[0], false));
    assert_true(plane_rest_attracts(&s.rest[0], true));
    plane_end(&s, &c);
}

/* A centre, rings of them, and what attracts only within a cycle, r = 2, or
 * r = 1. */
static void what_does_not_attract_has_no_turn(void **state)
{
    static const struct {
        const char *ode;
        double most; /* of x */
    } at[] = {
        { "x' = y; y' = -x", 0 },
        { "x' = y; y' = -x - x^3", 0 },
        { "x' = y + x^5/100; y' = -x", 0 },
        { "x' = y; y' = -x - 0.01*(1 - x^2)*y", 2 },
        { "q = 1 - x^2 - y^2; x' = y - 0.02*x*q; y' = -x - 0.02*y*q", 1 },
        { "q = 1 - x^2 - y^2; x' = y - x*q^2*(0.9 - x^2 - y^2); "
          "y' = -x - y*q^2*(0.9 - x^2 - y^2)",
          0.95 },
    };
    struct plane_study s;
    struct scene c;

    (void) state;
    for (int k = 0; k < 6; k++) {
        plane_run(&s, &c, at[k].ode, WINDOW MORE);
        const struct plane_turn *t = &s.rest[focus_at(&s, 0.0)].turn[0];
        CHECK(4.0 * t->box.hi.x <= at[k].most &&
                  (t->corners == 0 || at[k].most > 0),
              "%s: %zu corners, to %g", at[k].ode, t->corners,
              4.0 * t->box.hi.x);
        plane_end(&s, &c);
    }
}

/* Over x y the divergence is -1/(100 y): no orbit of those who eat and are
 * eaten closes, however long it goes beside the axes. */
static void over_coordinates_there_is_no_cycle(void **state)
{
    struct plane_study s;
    struct scene c;
    bool none;

    (void) state;
    plane_run(&s, &c, "x' = x*(1 - x/100 - y); y' = y*(x - 1)",
              "window={x: [0.01, 4], y: [0.01, 4]}\nproducts=[basins]\n"
              "basins.audit=50\n");
    assert_int_equal(s.cycles, 0);
    has_share(&s, "stable_focus_0", 1.0, 1e-9);
    assert_true(s.rest[0].turn[0].corners > 0);
    assert_int_equal(
        plane_turn_forbids(&s, (struct box){ { 0.1, 0.1 }, { 90, 90 } }, &none),
        STATUS_OK);
    assert_true(none);
    assert_int_equal(
        plane_turn_forbids(&s, (struct box){ { -9, -9 }, { 90, 90 } }, &none),
        STATUS_OK);
    assert_false(none);
    plane_end(&s, &c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_turn_is_nearly_all_of_a_well),
        TEST(a_focus_of_third_order_has_all_of_the_window),
        TEST(what_does_not_attract_has_no_turn),
        TEST(over_coordinates_there_is_no_cycle),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
