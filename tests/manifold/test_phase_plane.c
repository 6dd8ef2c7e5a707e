/* Steady states of a pitchfork: nodes at X = +-1 beside the saddle X = 0. */
#include "phase_plane.h"

#include <math.h>

#include "check.h"
#include "fixtures.h"

static struct fixture pitchfork(void)
{
    struct fixture f = { .base = FIXTURE_PITCHFORK, .a = 2.0, .b = 5.0 };

    fixture_center(&f, (struct vec2){ 0.0, 0.0 });
    return f;
}

/* Node, saddle, node; the first `n` from `from` on. */
static struct phase_plane plane_of(const struct fixture *f, size_t from,
                                   size_t n)
{
    const struct planar sys = fixture_planar(f);
    struct equilibrium e[3] = {
        { .type = EQUILIBRIUM_STABLE_NODE, .z = { -1.0, 0.0 } },
        { .type = EQUILIBRIUM_SADDLE, .z = { 0.0, 0.0 } },
        { .type = EQUILIBRIUM_STABLE_NODE, .z = { 1.0, 0.0 } },
    };

    return phase_plane_of(&sys, e + from, n);
}

static void its_saddle_is_found_and_orbits_arrive_at_the_others(void **state)
{
    const struct fixture f = pitchfork();
    const struct phase_plane p = plane_of(&f, 0, 3);
    struct vec2 goal[EQUILIBRIA_MAX];

    (void) state;
    assert_int_equal(p.saddles, 1);
    assert_int_equal(p.saddle[0], 1);
    assert_ptr_equal(phase_plane_saddle(&p), &p.equilibrium[1]);
    assert_int_equal(phase_plane_goals(&p, goal), 2);
    assert_true(goal[0].x == -1.0 && goal[1].x == 1.0);
    assert_true(phase_plane_offset(&p, 2).x == 1.0);
}

static void the_fastest_rate_is_the_origins(void **state)
{
    const struct fixture f = pitchfork();
    const struct phase_plane p = plane_of(&f, 0, 3);

    (void) state;
    CHECK(fabs(p.fastest_rate - 5.0) < 1e-14, "%.17g", p.fastest_rate);
}

static void without_a_saddle_there_is_none(void **state)
{
    const struct fixture f = pitchfork();
    const struct phase_plane p = plane_of(&f, 2, 1);
    struct vec2 goal[EQUILIBRIA_MAX];

    (void) state;
    assert_int_equal(p.saddles, 0);
    assert_null(phase_plane_saddle(&p));
    assert_int_equal(phase_plane_goals(&p, goal), 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(its_saddle_is_found_and_orbits_arrive_at_the_others),
        cmocka_unit_test(the_fastest_rate_is_the_origins),
        cmocka_unit_test(without_a_saddle_there_is_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
