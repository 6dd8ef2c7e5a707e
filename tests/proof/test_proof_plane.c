/* A branch of a system of formulas to a goal that is given: to a line, to a
 * trap, along curves that are another's. */
#include "proof_plane.h"

#include <math.h>

#include "formulas.h"
#include "plane_proof.h"
#include "proof_short.h"

#define PROVED "products=[manifolds]\naccuracy.proved=true\n"

/* Where it crosses a given line, or why that, or a trap, is not proved. */
static const char *prove_given(const struct plane_study *s,
                               const struct plane_branch *b,
                               const struct proof_goal *goal,
                               struct interval at[2])
{
    const struct plane_rest *r = &s->rest[b->rest];
    struct proof_plane p;
    struct proof_branch tube;
    struct fault why;

    assert_int_equal(
        proof_plane_at(&p, &s->lowered->way[1][b->kind != MANIFOLD_STABLE],
                       s->lowered->value, r->exact.chart, &why),
        STATUS_OK);
    assert_int_equal(proof_plane_branch(&p, &b->curve, goal, &tube, at),
                     STATUS_OK);
    free(tube.piece);
    free(tube.cell);
    proof_plane_free(&p);
    return tube.not_proved;
}

/* A line that is given: half of y = x sqrt(1 - x^2/2), on the way back to the
 * saddle it comes from. */
static void duffings_loop_is_proved_at_any_line(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = y; y' = x - x^3",
              "window={x: [-2, 2], y: [-2, 2]}\n" PROVED);
    for (size_t i = 0; i < s.branches; i++) {
        const struct plane_branch *b = &s.branch[i];
        const double way = b->branch == 0 ? 1 : -1;
        struct interval at[2];
        struct proof_goal goal = { .axis = 0, .at = { 0.5 * way, 0.5 * way } };
        double z[CURVE_DIM_MAX] = { 0 };

        assert_int_equal(b->end_proved, PLANE_NOT_PROVED);
        for (; fabs(z[0]) < 0.5; goal.piece++)
            curve_at(&b->curve.curve, goal.piece, 1, z);
        goal.piece--;
        for (double h = 0.5; h > 1e-17; h /= 2) {
            curve_at(&b->curve.curve, goal.piece, goal.theta + h, z);
            goal.theta += fabs(z[0]) < 0.5 ? h : 0;
        }
        const char *why = prove_given(&s, b, &goal, at);
        CHECK(why == NULL, "%s", why);
        const long double y =
            (b->kind == MANIFOLD_STABLE ? -way : way) * 0.5L * sqrtl(0.875L);
        CHECK(at[1].lo <= y && y <= at[1].hi && at[1].hi - at[1].lo < 1e-14,
              "[%.20Lg, %.20Lg]", at[1].lo, at[1].hi);
    }
    plane_end(&s, &c);
}

/* One that is nowhere near, and one around where a curve that is off by 1e-6
 * ends its first piece. */
static void what_passes_beside_a_trap_does_not_come_into_it(void **state)
{
    const struct system_number n = { 0.5, 0.25 };
    const struct interval u = proof_plane_number(&n);
    struct plane_study s;
    struct scene c;

    (void) state;
    assert_true(u.lo <= 0.25L && 0.75L <= u.hi);
    plane_run(&s, &c, "x' = y; y' = x - x^3 - y",
              "window={x: [-2, 2], y: [-2, 2]}\n" PROVED);
    for (size_t i = 0; i < s.branches; i++) {
        const struct plane_branch *b = &s.branch[i];
        const size_t dep = (size_t) (1 - branch_graph(&b->curve, 0));
        const struct curve *curve = &b->curve.curve;
        struct proof_trap trap = {
            .xx = 1, .yy = 1, .level = 1e-16, .at = { { 9, 9 }, { 9, 9 } }
        };
        const struct proof_goal goal = { .trap = &trap };
        double z[CURVE_DIM_MAX] = { 0 };
        struct interval at[2];

        if (b->end_proved == PLANE_TRAPPED)
            assert_string_equal(prove_given(&s, b, &goal, at),
                                "it does not come into a trap");
        curve->coef[dep * (curve->piece[0].degree + 1) + 1] += 1e-6;
        curve_at(curve, 0, 1, z);
        trap.at[0] = point(z[0]);
        trap.at[1] = point(z[1]);
        assert_non_null(prove_given(&s, b, &goal, at));
    }
    plane_end(&s, &c);
}

/* x = theta on y = 0, which is the branch, and then x = 1/(1 - theta/2) over
 * y = 1/2 - theta/4, which is another orbit: all but the corner has a tube. */
static void another_orbit_behind_a_corner_is_not_the_branch(void **state)
{
    enum { N = 20 };
    const struct proof_goal goal = {
        .axis = 1, .at = point(0.375), .piece = 1, .theta = 0.5
    };
    struct plane_branch b = { .curve.curve = CURVE_EMPTY(2) };
    struct plane_study s;
    struct scene c;
    struct interval at[2];
    double *coef;

    (void) state;
    plane_run(&s, &c, "x' = -x; y' = y",
              "window={x: [-3, 3], y: [-3, 3]}\nproducts=[manifolds]\n");
    for (int piece = 0; piece < 2; piece++) {
        assert_int_equal(curve_push(&b.curve.curve, N, &coef), STATUS_OK);
        memset(coef, 0, 2 * (N + 1) * sizeof *coef);
        coef[1] = 1;
    }
    for (int k = 0; k <= N; k++)
        coef[k] = ldexp(1, -k);
    coef[N + 1] = 0.5;
    coef[N + 2] = -0.25;
    const char *why = prove_given(&s, &b, &goal, at);
    assert_non_null(why);
    assert_string_equal(why, "the tube was lost at a corner");
    curve_free(&b.curve.curve);
    plane_end(&s, &c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(duffings_loop_is_proved_at_any_line),
        cmocka_unit_test(what_passes_beside_a_trap_does_not_come_into_it),
        cmocka_unit_test(another_orbit_behind_a_corner_is_not_the_branch),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
