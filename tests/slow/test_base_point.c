/* States as points of the slow curve. */
#include "base_point.h"

#include "cells.h"
#include "place.h"
#include "tolerance.h"

/* Of the offset z. */
static struct base_point base_of(const struct place *p, struct vec2 z,
                                 double promise)
{
    struct layer_job job = { z, layer_defaults(promise) };
    struct layer l;

    job.options.peaks = false;
    job.options.through = true;
    layer_follow(&p->c, layer_width(8), &job, 1, &l);
    return base_point_of(&p->c, &l);
}

/* 1 if the base point told it. */
static int check_state(const struct place *p, struct vec2 z)
{
    const unsigned which = 1u << CELL_SLIP | 1u << CELL_TIME;
    const struct vec2 at = vec2_add(z, p->s.study.slider.plane.system.origin);
    const struct base_point b = base_of(p, z, 1e-6);
    struct cell c;
    struct layer l;

    if (isnan(b.y) || !base_point_tell(&p->c, &b, &l))
        return 0;
    assert_int_equal(
        cells_find(&p->s.study.slider, &at, 1, 1e-7, which, NULL, &c), 0);
    CHECK(l.fate == c.exit_reason, "(%.17g, %.17g): fate %d, not %d", z.x, z.y,
          l.fate, c.exit_reason);
    if (l.fate == FATE_RUNAWAY)
        return l.end == LAYER_RAN;
    CHECK(fabs(l.time - c.time) <= l.time_error + c.time_error,
          "(%.17g, %.17g): %.15g, not %.15g +- %g", z.x, z.y, l.time, c.time,
          l.time_error + c.time_error);
    CHECK(fabs(l.slip - c.slip) <= l.slip_error + c.slip_error,
          "(%.17g, %.17g): %.15g, not %.15g +- %g", z.x, z.y, l.slip, c.slip,
          l.slip_error + c.slip_error);
    return 1;
}

static void a_base_point_tells_what_its_state_does(void **state)
{
    static const char *const law[] = { "spinodal_gen", "dieterich_gen",
                                       "spinodal", "spinodal_phi_gen" };
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 4; i++) {
        struct place p;
        int told = 0;
        place_make(&p, law[i], "0.34");
        for (int k = 0; k < 12; k++)
            told +=
                check_state(&p, (struct vec2){ check_uniform(&rng, -4, 8),
                                               check_uniform(&rng, -2, 2) });
        CHECK(told > 2, "%s: %d told", law[i], told);
        place_drop(&p);
    }
}

/* The sixth difference of base points on a line across it is that of a smooth
 * function, and the fates change with the sign. */
static void it_is_smooth_across_the_separatrix(void **state)
{
    static const char *const law[] = { "spinodal_gen", "dieterich_gen" };
    static const double binomial[] = { 1, -6, 15, -20, 15, -6, 1 };
    const double h = 0.004;

    (void) state;
    for (int i = 0; i < 2; i++) {
        struct place p;
        double sum = 0.0;
        place_make(&p, law[i], "0.34");
        const double middle = base_of(&p, (struct vec2){ 1.0, 0.0 }, 1e-9).y;
        for (int k = -3; k <= 3; k++) {
            const struct vec2 z = { 1.0, k * h - middle };
            const struct base_point b = base_of(&p, z, 1e-9);
            CHECK((b.y > 0.0) == (k > 0) || k == 0, "%d: %g", k, b.y);
            CHECK(b.y_error < 1e-7, "%g", b.y_error);
            sum += binomial[k + 3] * b.y;
        }
        CHECK(fabs(sum) < 1e-8, "%s: %g", law[i], sum);
        place_drop(&p);
    }
}

static void bars_grow_towards_the_separatrix_until_nothing_is_told(void **state)
{
    struct place p;
    struct layer l;
    double before = 0.0;

    (void) state;
    place_make(&p, "spinodal_gen", "0.34");
    for (double y = 0.1; y > 2e-6; y *= 0.1) {
        const struct base_point b = { y, 1e-7, 0.0, 0.0, 1.0 };
        assert_true(base_point_tell(&p.c, &b, &l));
        CHECK(l.time_error > 5.0 * before && l.fate == FATE_CREEP, "%g: %g", y,
              l.time_error);
        before = l.time_error;
    }
    const struct base_point near = { 5e-7, 1e-7, 0.0, 0.0, 1.0 };
    const struct base_point nowhere = { 50.0, 1e-7, 0.0, 0.0, 1.0 };
    assert_false(base_point_tell(&p.c, &near, &l));
    assert_false(base_point_tell(&p.c, &nowhere, &l));
    assert_int_equal(l.fate, FATE_UNDECIDED);
    place_drop(&p);
}

/* All that meets one is said to pass it, and what it says of them holds. */
static void what_may_pass_a_box_is_not_told(void **state)
{
    struct place p;
    struct layer l;

    (void) state;
    place_make(&p, "spinodal_gen", "0.34");
    const struct study *s = &p.s.study;
    const struct equilibrium *node = &s->slider.plane.equilibrium[0];
    const struct vec2 at = vec2_sub(node->z, s->slider.plane.system.origin);
    for (double way = -0.98; way < 1.0; way += 0.28) {
        const struct vec2 z = { at.x - 0.5, at.y + way * TOL_ARREST };
        const struct base_point b = base_of(&p, z, 1e-8);
        CHECK(base_point_passes(&p.c, b.y, b.y), "%g: %.17g", way, b.y);
        assert_false(base_point_tell(&p.c, &b, &l));
    }
    const double below = at.y - 2.0 * TOL_ARREST;
    const double above = at.y + 2.0 * TOL_ARREST;
    assert_false(base_point_passes(&p.c, below, below));
    assert_false(base_point_passes(&p.c, above, above));
    assert_true(base_point_passes(&p.c, above, below));
    place_drop(&p);
}

static void what_is_lost_has_none(void **state)
{
    const struct layer lost = { .end = LAYER_LOST, .y = 1.0, .time = 1.0 };
    struct place p;

    (void) state;
    place_make(&p, "spinodal_gen", "0.34");
    assert_true(isnan(base_point_of(&p.c, &lost).y));
    place_drop(&p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_base_point_tells_what_its_state_does),
        cmocka_unit_test(it_is_smooth_across_the_separatrix),
        cmocka_unit_test(
            bars_grow_towards_the_separatrix_until_nothing_is_told),
        cmocka_unit_test(what_may_pass_a_box_is_not_told),
        cmocka_unit_test(what_is_lost_has_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
