/* What is left out of an integral is in its enclosure: of a series that is cut
 * early, in a cell, and of a branch that is.  Enclosures of the
 * same number by longer series and branches, which are narrow, meet it. */
#include "proof.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "interval_math.h"
#include "proof_cell.h"
#include "reference_rows.h"

static const char *const presets[] = { "dieterich_gen", "perrin",
                                       "spinodal_gen" };

enum { PRESETS = 3, DEGREE = 3, CUTS = 3 };

static const double tan_alpha = 0.35;

/* The curves of a law to their ends, and what is proved along them. */
static void make(const char *preset, struct solved *s, struct proof *p)
{
    const struct material m = material_bristol_board();
    const struct box all = { { -700, -1e300 }, { 700, 1e300 } };
    const struct proof_inputs in = { .slope_in = ANGLE_TAN,
                                     .slope = tan_alpha };

    solve_reach = &all;
    assert_int_equal(
        solve(s, law_preset_find(preset), &m, (long double) tan_alpha, 1e-13),
        STATUS_OK);
    solve_reach = NULL;
    const struct branch both[] = { s->upper, s->lower };
    assert_int_equal(proof_along(&s->block, &in, both, p), STATUS_OK);
    assert_true(p->branch[0].end >= 0 && p->branch[1].end >= 0);
}

static struct interval sum_of(const struct proof_branch *b,
                              struct interval first)
{
    for (size_t k = 0; k < b->cells; k++)
        first = interval_add(first, b->cell[k].excess);
    return first;
}

static void meet(const char *preset, struct interval wide, struct interval thin)
{
    CHECK(wide.lo <= thin.lo && thin.hi <= wide.hi,
          "%s: [%.20Lg, %.20Lg] has no [%.20Lg, %.20Lg]", preset, wide.lo,
          wide.hi, thin.lo, thin.hi);
    CHECK(thin.hi - thin.lo < 0.1 * (wide.hi - wide.lo),
          "%s: [%.20Lg, %.20Lg] is no narrower than [%.20Lg, %.20Lg]", preset,
          thin.lo, thin.hi, wide.lo, wide.hi);
}

/* The integral over a straight piece in cells that are as small as `known`, an
 * interval before it, asks for. */
static struct interval straight(struct proof *p, struct interval known,
                                size_t degree)
{
    const struct proof_branch *b = &p->branch[0];
    struct proof_piece piece = b->piece[b->pieces - 1];
    struct proof_front front = { .error = 1e-12, .excess = known };
    struct proof_branch out = { .cells = 0 };
    enum status status = STATUS_OK;

    piece.degree = degree;
    for (size_t k = 1; k <= degree; k++)
        piece.coef[k] = 0;
    assert_true(proof_cells(&p->law.tape, &piece, 0, interval_point(1), &front,
                            &out, &status));
    const struct interval sum = sum_of(&out, interval_point(0));
    free(out.cell);
    return sum;
}

/* Where psi has grown v rests, a straight line, but its integral falls as
 * 1/sinh(psi). */
static void a_cell_holds_what_its_series_leaves_out(void **state)
{
    struct solved s;
    struct proof p;

    (void) state;
    for (int i = 0; i < PRESETS; i++) {
        make(presets[i], &s, &p);
        meet(presets[i], straight(&p, interval_within(1), DEGREE),
             straight(&p, interval_point(0), 20));
        proof_free(&p);
        solved_free(&s);
    }
}

/* Without its last pieces, as long as the end is proved. */
static void a_branch_that_is_cut_holds_what_it_has_lost(void **state)
{
    const struct proof_inputs in = { .slope_in = ANGLE_TAN,
                                     .slope = tan_alpha };
    size_t cuts = 0;
    struct solved s;
    struct proof p, q;

    (void) state;
    for (int i = 0; i < 2 * PRESETS; i++) {
        const int side = i % 2;
        make(presets[i / 2], &s, &p);
        struct branch both[] = { s.upper, s.lower };
        both[1 - side].curve.count = 0;
        for (size_t cut = 1; cut <= CUTS; cut++) {
            both[side].curve.count = p.branch[side].pieces - cut;
            assert_int_equal(proof_along(&s.block, &in, both, &q), STATUS_OK);
            const bool closed = q.branch[side].end >= 0;
            if (closed) {
                const struct interval u = q.branch[side].excess;
                const struct interval w = p.branch[side].excess;
                CHECK(u.lo <= w.hi && w.lo <= u.hi,
                      "%s: [%.20Lg, %.20Lg] is beside [%.20Lg, %.20Lg]",
                      presets[i / 2], u.lo, u.hi, w.lo, w.hi);
                cuts++;
            }
            proof_free(&q);
            if (!closed)
                break;
        }
        proof_free(&p);
        solved_free(&s);
    }
    print_message("# %zu branches were cut\n", cuts);
    assert_true(cuts > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cell_holds_what_its_series_leaves_out),
        cmocka_unit_test(a_branch_that_is_cut_holds_what_it_has_lost),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
