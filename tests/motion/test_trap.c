/* Labels by forward integration into the saddle's quadrants. */
#include "trap.h"

#include "fault_alloc.h"
#include "slope.h"

static const char *const steady_only[] = { "products=[equilibria]", NULL };

static int label_of(const struct trap *t, struct vec2 z, size_t *evaluations)
{
    const struct vec2 offset = vec2_sub(z, t->slider->plane.system.origin);
    int8_t label = FATE_NONE;
    const enum status status = trap_label(t, offset, &label, evaluations);

    CHECK(status == STATUS_OK, "%s", status_text(status));
    return label;
}

static void check_row(struct slope *s, const struct csv *c)
{
    struct trap t;

    trap_init(&t, &s->study.slider);
    const int label = label_of(&t, row_point(s, c), NULL);
    CHECK(label == row_fate(c), "row %zu: %s", c->row, fate_names[label]);
}

static void every_reference_state_is_labelled_right(void **state)
{
    (void) state;
    const int rows = each_basin_row(1e-6, steady_only, check_row);
    CHECK(rows >= 440, "%d rows", rows);
}

/* And the orbits from inside them say so. */
static void quadrants_hold_the_fates_of_their_orbits(void **state)
{
    static const struct {
        const char *law;
        int8_t slow, fast;
    } expected[] = {
        { "spinodal_gen", FATE_CREEP, FATE_SLIDING },
        { "spinodal", FATE_CREEP, FATE_SLIDING },
        { "dieterich_gen", FATE_REST_FINITE, FATE_RUNAWAY },
        { "dieterich", FATE_REST_ASYMPTOTIC, FATE_RUNAWAY },
        { "ruina", FATE_REST_ASYMPTOTIC, FATE_RUNAWAY },
    };

    (void) state;
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        struct slope s;
        struct trap t;
        slope_make(&s, expected[i].law, NULL, "0.34", steady_only);
        trap_init(&t, &s.study.slider);
        CHECK(t.set && t.fate[0] == expected[i].slow &&
                  t.fate[1] == expected[i].fast,
              "%s: %d, %d", expected[i].law, t.fate[0], t.fate[1]);
        for (int k = 0; k < 2; k++) {
            const double step = k == 0 ? -0.5 : 0.5;
            const struct vec2 z = { s.study.slider.plane.system.origin.x + step,
                                    s.study.slider.plane.system.origin.y -
                                        step };
            struct fate_result r;
            assert_int_equal(
                fate_find(&s.study.slider, z, 1e-6, true, NULL, &r), 0);
            CHECK((int8_t) r.fate == t.fate[k], "%s: %s", expected[i].law,
                  fate_names[r.fate]);
        }
        slope_free(&s);
    }
}

static void inside_a_quadrant_nothing_is_integrated(void **state)
{
    const double step[] = { 1e-12, 1.0, 300.0 };
    size_t evaluations = 0;
    struct slope s;
    struct trap t;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", steady_only);
    trap_init(&t, &s.study.slider);
    const struct vec2 o = s.study.slider.plane.system.origin;
    for (int i = 0; i < 3; i++) {
        const struct vec2 slow = { o.x - step[i], o.y + step[i] };
        const struct vec2 fast = { o.x + step[i], o.y - step[i] };
        assert_int_equal(label_of(&t, slow, &evaluations), FATE_CREEP);
        assert_int_equal(label_of(&t, fast, &evaluations), FATE_SLIDING);
    }
    assert_int_equal(evaluations, 0);
    label_of(&t, (struct vec2){ o.x - 1.0, o.y - 1.0 }, &evaluations);
    assert_true(evaluations > 0);
    slope_free(&s);
}

/* Where the curve is a coordinate away on either side. */
static void nearer_the_boundary_it_works_harder(void **state)
{
    size_t far = 0, near = 0;
    struct slope s;
    struct trap t;

    (void) state;
    slope_make(&s, "spinodal_gen", "asinh", "0.34", steady_only);
    trap_init(&t, &s.study.slider);
    /* v_plus, to all digits that psi = e^5 does not change */
    const double x = log(2850.8257094);
    for (int i = -1; i <= 1; i += 2) {
        const int expected = i < 0 ? FATE_CREEP : FATE_SLIDING;
        assert_int_equal(label_of(&t, (struct vec2){ x + i * 0.5, 5.0 }, &far),
                         expected);
        assert_int_equal(
            label_of(&t, (struct vec2){ x + i * 1e-9, 5.0 }, &near), expected);
    }
    CHECK(near > 3 * far, "%zu against %zu", near, far);
    slope_free(&s);
}

static void without_a_saddle_orbits_are_followed_to_their_ends(void **state)
{
    struct slope s;
    struct trap t;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.2", steady_only);
    trap_init(&t, &s.study.slider);
    assert_false(t.set);
    assert_int_equal(label_of(&t, (struct vec2){ 5.0, 1.0 }, NULL), FATE_CREEP);
    slope_free(&s);
}

static void every_allocation_may_fail(void **state)
{
    enum status status = STATUS_NO_MEMORY;
    int8_t label = FATE_NONE;
    struct slope s;
    struct trap t;
    long k = 0;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.2", steady_only);
    trap_init(&t, &s.study.slider);
    for (; status == STATUS_NO_MEMORY; k++) {
        fault_alloc_at(k);
        status = trap_label(&t, (struct vec2){ 5.0, 1.0 }, &label, NULL);
    }
    fault_alloc_at(FAULT_ALLOC_NEVER);
    assert_int_equal(status, STATUS_OK);
    assert_int_equal(label, FATE_CREEP);
    CHECK(k > 6, "%ld allocations", k);
    slope_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_reference_state_is_labelled_right),
        cmocka_unit_test(quadrants_hold_the_fates_of_their_orbits),
        cmocka_unit_test(inside_a_quadrant_nothing_is_integrated),
        cmocka_unit_test(nearer_the_boundary_it_works_harder),
        cmocka_unit_test(without_a_saddle_orbits_are_followed_to_their_ends),
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
