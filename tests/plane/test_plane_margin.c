/* How far another fate is, where the border has a formula. */
#include "plane_margin.h"

#include <math.h>

#include "formulas.h"
#include "plane_map.h"

enum { DRAWS = 200, CELLS = 12 };

/* |value - truth| <= error, and that is small. */
static void is_near(const struct quantity *q, double truth, const char *what,
                    struct vec2 z)
{
    CHECK(q->reason == NULL, "%s at %g, %g: %s", what, z.x, z.y, q->reason);
    CHECK(fabs(q->value - truth) <= q->error &&
              q->error <= 1e-11 * (1.0 + fabs(truth)),
          "%s at %g, %g: %.17g +- %g, not %.17g", what, z.x, z.y, q->value,
          q->error, truth);
}

/* x = 0.3 y + 0.2 y^2 divides the window into two. */
static void a_bent_border_is_as_far_as_it_is(void **state)
{
    struct plane_study s;
    struct scene c;
    struct quantity kick[2];

    (void) state;
    plane_run(&s, &c,
              "X = x - 0.3*y - 0.2*y^2; dy = -2*y; "
              "x' = X - X^3 + (0.3 + 0.4*y)*dy; y' = dy",
              "window={x: [-2, 2], y: [-2, 2]}\nproducts=[basins]\n");
    for (int i = 0; i < DRAWS; i++) {
        const struct vec2 z = window_at(&s.window, vec2_spread(0.5, i + 1.0));
        const double root = sqrt(0.09 + 0.8 * z.x);
        const double up = (-0.3 + root) / 0.4, down = (-0.3 - root) / 0.4;
        const double nearest = fabs(up - z.y) < fabs(down - z.y) ? up : down;
        assert_int_equal(plane_margin_at(&s, z, kick), STATUS_OK);
        is_near(&kick[0], 0.3 * z.y + 0.2 * z.y * z.y - z.x, "x", z);
        if (root >= 0.0 && fabs(nearest) < 2.0)
            is_near(&kick[1], nearest - z.y, "y", z);
        else
            assert_non_null(kick[1].reason);
    }
    plane_end(&s, &c);
}

/* Where formulas end, at y = 0, is no curve that is known; x = 1 is one. */
static void beside_what_is_not_known_no_kick_is_told(void **state)
{
    struct plane_study s;
    struct scene c;
    struct quantity kick[2];
    const struct vec2 z = { 1.9, 0.5 };

    (void) state;
    plane_run(&s, &c, "x' = sqrt(x) - 1; y' = -ln(y)",
              "window={x: [-2, 2], y: [-2, 2]}\nproducts=[basins]\n");
    assert_int_equal(plane_margin_at(&s, z, kick), STATUS_OK);
    is_near(&kick[0], -0.9, "x", z);
    assert_string_equal(kick[1].reason,
                        "where fates change there is not known");
    plane_end(&s, &c);
}

/* A switch of two genes that are alike: u = v divides it; factors. */
static void of_positive_states_it_is_a_factor(void **state)
{
    struct plane_study s;
    struct scene c;
    struct quantity kick[2];

    (void) state;
    plane_run(&s, &c, "u' = 3/(1 + v^2) - u; v' = 3/(1 + u^2) - v",
              "system.state={u: positive, v: positive}\n"
              "window={u: [0.05, 5], v: [0.05, 5]}\nproducts=[basins]\n");
    for (int i = 0; i < DRAWS; i++) {
        const struct vec2 z = window_at(&s.window, vec2_spread(0.5, i + 1.0));
        assert_int_equal(plane_margin_at(&s, z, kick), STATUS_OK);
        is_near(&kick[0], exp(z.y - z.x), "u", z);
        is_near(&kick[1], exp(z.x - z.y), "v", z);
    }
    plane_end(&s, &c);
}

static void what_does_not_exist_has_a_reason(void **state)
{
    struct plane_study s;
    struct scene c;
    struct quantity kick[2];

    (void) state;
    plane_run(&s, &c, "x' = x - x^3; y' = -y",
              "window={x: [-2, 2], y: [-1, 1]}\nproducts=[basins]\n");
    assert_int_equal(plane_margin_at(&s, (struct vec2){ 0.5, 0.2 }, kick),
                     STATUS_OK);
    is_near(&kick[0], -0.5, "x", (struct vec2){ 0.5, 0.2 });
    assert_string_equal(kick[1].reason,
                        "no other fate in the window along this line");
    assert_int_equal(plane_margin_at(&s, (struct vec2){ 0.0, 0.2 }, kick),
                     STATUS_OK);
    assert_string_equal(kick[0].reason,
                        "whereto the state itself goes is not known");
    assert_int_equal(plane_margin_at(&s, (struct vec2){ 3.0, 0.2 }, kick),
                     STATUS_OK);
    assert_string_equal(kick[0].reason, "the state is outside the window");
    plane_end(&s, &c);
}

static void the_map_says_the_same(void **state)
{
    struct plane_study s;
    struct scene c;
    struct quantity kick[2];
    struct plane_margins map[CELLS * CELLS];

    (void) state;
    plane_run(&s, &c, "x' = y; y' = x - x^3 - 0.2*y",
              "window={x: [-2, 2], y: [-1.5, 1.5]}\nproducts=[margin]\n"
              "basins.cells=[12, 12]\n");
    for (size_t row = 0; row < CELLS; row += 4)
        assert_int_equal(
            plane_margin_fill(&s, CELLS, CELLS, row, 4, map + CELLS * row),
            STATUS_OK);
    for (size_t i = 0; i < CELLS * CELLS; i++) {
        const struct vec2 z = { plane_map_cell(&s, 0, i % CELLS, CELLS, true),
                                plane_map_cell(&s, 1, i / CELLS, CELLS, true) };
        assert_int_equal(plane_margin_at(&s, z, kick), STATUS_OK);
        for (int k = 0; k < 2; k++)
            CHECK(kick[k].reason ? isnan(map[i].by[k])
                                 : map[i].by[k] == kick[k].value,
                  "cell %zu, axis %d: %.17g, not %.17g", i, k, map[i].by[k],
                  kick[k].value);
    }
    plane_end(&s, &c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_bent_border_is_as_far_as_it_is),
        cmocka_unit_test(beside_what_is_not_known_no_kick_is_told),
        cmocka_unit_test(of_positive_states_it_is_a_factor),
        cmocka_unit_test(what_does_not_exist_has_a_reason),
        cmocka_unit_test(the_map_says_the_same),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
