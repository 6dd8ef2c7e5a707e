/* Where branches of systems of formulas come to: lines that they cross, and
 * traps. */
#include "proof_plane.h"

#include <math.h>

#include "formulas.h"
#include "interval_long.h"
#include "proof_cell.h"

#define TEST(test)                                                             \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)
#define MORE "products=[equilibria]\n"

/* ---- traps --------------------------------------------------------------- */

/* About equilibrium i, in the time in which what it attracts comes backward. */
static void about(struct proof_plane *p, struct plane_study *s, size_t i,
                  bool backward)
{
    struct fault why;

    assert_int_equal(proof_plane_at(p, &s->lowered->way[1][backward],
                                    s->lowered->value, s->rest[i].exact.chart,
                                    &why),
                     STATUS_OK);
}

/* x' = -x + x^3: all within |x| < 1 go to 0. */
static void a_trap_is_of_what_attracts_and_no_larger_than_its_basin(
    void **state)
{
    struct plane_study s;
    struct scene c;
    struct proof_plane p;
    const struct interval nothing = { 0, 0 }, half = { 0, 0.5 }, one = { 1, 1 };

    (void) state;
    plane_run(&s, &c, "x' = -x + x^3; y' = -y",
              "window={x: [-0.5, 0.5], y: [-1, 1]}\n" MORE);
    about(&p, &s, 0, true);
    struct proof_trap trap = { { nothing, nothing }, 1, 0, 1, 4 };
    assert_true(proof_trap_verify(&p.tape, &trap));
    assert_true(trap.level < 1 && trap.level > 0.01);
    assert_false(proof_trap_holds(&trap, (struct interval[]){ one, nothing }));
    trap.level = 0.26;
    assert_true(proof_trap_holds(&trap, (struct interval[]){ half, nothing }));
    assert_false(proof_trap_holds(&trap, (struct interval[]){ half, half }));
    struct proof_trap none = { { nothing, nothing }, 1, 1.5, 1, 0.01 };
    assert_false(proof_trap_verify(&p.tape, &none)); /* Q is no ellipse */
    none = (struct proof_trap){ { nothing, nothing }, -1, 0, -1, 0.01 };
    assert_false(proof_trap_verify(&p.tape, &none));
    proof_plane_free(&p);
    about(&p, &s, 0, false);
    trap.level = 0.01;
    assert_false(proof_trap_verify(&p.tape, &trap)); /* it repels */
    proof_plane_free(&p);
    plane_end(&s, &c);
}

/* V falls along no orbit about a centre, and not along all about a saddle, nor
 * where Q is that of another matrix; where Q is not > 0 V < c is no place. */
static void what_does_not_attract_has_no_trap(void **state)
{
    static const struct {
        const char *ode;
        double xx, xy, yy;
    } at[] = {
        { "x' = y; y' = -x", 1, 0, 1 },
        { "x' = x; y' = -y", 1, 0, 1 },
        { "x' = -x + 4*y; y' = -y", 1, 0, 1 },
        { "x' = -x; y' = -y", -1, 0, -1 },
        { "x' = x/8 + 3*y/8; y' = 3*x/8 + y/8", -1, 3, -1 }, /* Q A = 1 */
    };
    struct plane_study s;
    struct scene c;
    struct proof_plane p;

    (void) state;
    for (int i = 0; i < 5; i++) {
        plane_run(&s, &c, at[i].ode, "window={x: [-1, 1], y: [-1, 1]}\n" MORE);
        for (int way = 0; way < 2; way++) {
            struct proof_trap trap = {
                { { 0, 0 }, { 0, 0 } }, at[i].xx, at[i].xy, at[i].yy, 1e-6
            };
            about(&p, &s, 0, way == 1);
            assert_false(proof_trap_verify(&p.tape, &trap));
            proof_plane_free(&p);
        }
        plane_end(&s, &c);
    }
}

/* ---- what is on the way -------------------------------------------------- */

/* dy/dx = 1.1 - x: from x = 0.5 no branch rises by more than 0.18. */
static void a_line_is_reached_as_the_slopes_on_the_way_allow(void **state)
{
    struct plane_study s;
    struct scene c;
    struct proof_plane p;
    struct fault why;
    const struct system_number origin[2] = { { 0, 0 }, { 0, 0 } };
    const struct proof_piece piece = { .start = 0.5, .step = 1, .degree = 1 };
    const struct interval here = { 0, 0 };
    struct proof_front f = { .error = 0.2 };
    double way;

    (void) state;
    plane_run(&s, &c, "x' = x; y' = x*(1.1 - x)",
              "window={x: [-1, 1], y: [-1, 1]}\nproducts=[equilibria]\n");
    assert_int_equal(proof_plane_at(&p, &s.lowered->way[1][0], s.lowered->value,
                                    origin, &why),
                     STATUS_OK);
    assert_false(proof_reach(&p.tape, &piece, here, here, &f, &way));
    f.error = 0.005;
    assert_true(proof_reach(&p.tape, &piece, here, here, &f, &way));
    CHECK(way > 0.6 - sqrt(0.35) && way < 0.011, "%g", way);
    const struct interval line = { 0.6, 0.6 };
    assert_false(proof_reach(&p.tape, &piece, line, here, &f, &way));
    proof_plane_free(&p);
    plane_end(&s, &c);
}

/* A piece beside the branch makes the tube wide: what is in the trap at last is
 * all of it. */
static void all_of_the_tube_comes_into_the_trap(void **state)
{
    struct plane_study s;
    struct scene c;
    struct proof_plane p;
    struct proof_branch tube;
    struct interval none[2];
    const struct interval one = { 1, 1 }, y = { 0.0149999, 0.0150001 };
    struct proof_trap trap = { { one, y }, 1, 0, 1000, 0.01 };
    const struct proof_goal goal = { .trap = &trap };

    (void) state;
    plane_run(&s, &c, "x' = x - x^3; y' = -2*y + 0.03*x^2",
              "window={x: [-2, 2], y: [-2, 2]}\nproducts=[manifolds]\n");
    struct branch *b = &s.branch[2].curve; /* unstable */
    size_t last_far = 1;
    while (curve_component(&b->curve, last_far + 1, 0)[0] < 0.85)
        last_far++;
    assert_true(last_far + 2 < b->curve.count);
    const struct curve_piece *far = &b->curve.piece[last_far];
    b->curve.coef[far->first + far->degree + 1] += 0.005; /* of y */
    about(&p, &s, s.branch[2].rest, true);
    assert_true(proof_trap_verify(&p.tape, &trap));
    assert_int_equal(proof_plane_branch(&p, b, &goal, &tube, none), STATUS_OK);
    CHECK(tube.not_proved == NULL, "%s", tube.not_proved);
    const struct proof_cell *last = &tube.cell[tube.cells - 1];
    const struct proof_place at =
        proof_place_on(&tube.piece[tube.pieces - 1],
                       (struct interval){ last->to, last->to }, 0, 0);
    for (int i = -1; i < 2; i += 2) {
        const struct interval by = { i * last->after, i * last->after };
        const bool x = tube.piece[tube.pieces - 1].ind == 1;
        const struct interval z[2] = { x ? interval_add(at.X, by) : at.X,
                                       x ? at.Y : interval_add(at.Y, by) };
        assert_true(proof_trap_holds(&trap, z));
    }
    free(tube.piece);
    free(tube.cell);
    proof_plane_free(&p);
    plane_end(&s, &c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_trap_is_of_what_attracts_and_no_larger_than_its_basin),
        TEST(what_does_not_attract_has_no_trap),
        TEST(a_line_is_reached_as_the_slopes_on_the_way_allow),
        TEST(all_of_the_tube_comes_into_the_trap),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
