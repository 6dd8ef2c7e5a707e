/* Knees in tubes around polynomials beside a branch that is known, p: that of
 * w' = -w/theta. */
#include "proof_knee.h"

#include "made_tube.h"

static struct interval_graph graph;
static struct interval_tape tape;

/* Two pieces, of five cells. */
struct branch_made {
    struct proof_piece piece[2];
    struct proof_cell cell[6];
    struct proof_branch b;
};

static struct made field(int ind, const double p[TERMS])
{
    struct made f = {
        .cone = true,
        .L = { -1 },
        .E = { 1 },
        .piece = { .ind = ind, .step = 1, .degree = TERMS - 1 },
    };

    memcpy(f.piece.coef, p, TERMS * sizeof *p);
    tape_of(&f, &graph, &tape);
    return f;
}

static void field_free(void)
{
    interval_tape_free(&tape);
    interval_graph_free(&graph);
}

/* Along p + off theta: a cone, and cells from there to `end`; what is known
 * holds p. */
static void set_branch(struct branch_made *m, const struct made *f, double off,
                       double cone, double end, size_t cells)
{
    const double wide = 1.01 * fabs(off) + 1e-12;

    *m = (struct branch_made){ .piece = { f->piece } };
    m->b = (struct proof_branch){ .side = 1,
                                  .cone = { .reach = cone, .slope = wide },
                                  .piece = m->piece,
                                  .pieces = 1,
                                  .cell = m->cell,
                                  .cells = cells };
    m->piece[0].coef[1] += off;
    m->piece[0].cells = cells;
    for (size_t k = 0; k < cells; k++) {
        const double size = (end - cone) / (double) cells;
        m->cell[k].from = cone + (double) k * size;
        m->cell[k].to = m->cell[k].from + size;
        m->cell[k].before = m->cell[k].after = m->cell[k].radius = wide * end;
    }
}

static bool holds(struct interval u, double x)
{
    return u.lo <= x && x <= u.hi;
}

/* Both ways round, in the cone and in cells, beside it on both sides; a cell
 * ends between the knee and where it would be on the polynomial. */
static void a_knee_is_where_the_slope_rises_through_1(void **state)
{
    static const double rises[TERMS] = { 0, 0, 0.5 };
    static const double falls[TERMS] = { 0, 2, -0.5 };

    (void) state;
    for (int k = 0; k < 8; k++) {
        const int ind = k % 2;
        const double off = k / 2 % 2 ? 0.05 : -0.05;
        const struct made f = field(ind, ind ? falls : rises);
        struct branch_made m;
        set_branch(&m, &f, off, k < 4 ? 1.5 : 0.5, off > 0 ? 1.46 : 1.37,
                   k < 4 ? 0 : 5);
        m.b.beyond = 1;
        proof_knees(&tape, &m.b);
        CHECK(m.b.no_more == NULL && m.b.knees == 1, "%d: %zu, %s", k,
              m.b.knees, m.b.no_more);
        CHECK(holds(m.b.knee[0].X, ind ? 1.5 : 1) &&
                  holds(m.b.knee[0].Y, ind ? 1 : 0.5),
              "%d: [%Lg, %Lg] [%Lg, %Lg]", k, m.b.knee[0].X.lo,
              m.b.knee[0].X.hi, m.b.knee[0].Y.lo, m.b.knee[0].Y.hi);
        m.b.beyond = 0;
        proof_knees(&tape, &m.b);
        CHECK(m.b.no_more, "%d: there may be more", k);
        field_free();
    }
}

/* Its slope 1.02 - (theta - 1)^2 is above 1 for a while, as it is not on the
 * polynomial. */
static void a_tube_in_which_there_may_be_a_knee_has_not_none(void **state)
{
    static const double hump[TERMS] = { 0, 0.02, 1, -1. / 3 };
    const struct made f = field(0, hump);
    struct branch_made m;

    (void) state;
    set_branch(&m, &f, 0.05, 0.5, 1.5, 1);
    m.b.beyond = -1;
    proof_knees(&tape, &m.b);
    assert_non_null(m.b.no_more);
    field_free();
}

/* On to y = slope + slope theta, x = 1 + theta. */
static void turn(struct branch_made *m, double slope)
{
    const double cell = 0.25;

    m->piece[1] = (struct proof_piece){ .ind = 1,
                                        .start = slope,
                                        .step = slope,
                                        .degree = 1,
                                        .coef = { 1, 1 },
                                        .first = m->b.cells,
                                        .cells = 1 };
    m->cell[m->b.cells] = (struct proof_cell){
        .to = cell, .before = 1e-9, .after = 1e-9, .radius = 1e-9
    };
    m->b.pieces = 2;
    m->b.cells++;
}

/* y = 2 x has none, unless it is not known where it turns; and y = -2 x, whose
 * dx/dy is below 1, neither. */
static void no_knee_is_found_at_a_turn(void **state)
{
    static const double up[TERMS] = { 0, 2 }, down[TERMS] = { 0, -2 };
    struct branch_made m;

    (void) state;
    for (int k = 0; k < 5; k++) {
        const struct made f = field(0, k < 4 ? up : down);
        set_branch(&m, &f, 0, 0.5, 1, 2);
        turn(&m, k < 4 ? 2 : -2);
        m.b.beyond = k < 4 ? 1 : -1;
        m.cell[1].after = k == 1 ? 3 : k == 2 ? 1.2 : 1e-9;
        m.cell[2].before = k == 3 ? 3 : 1e-9;
        proof_knees(&tape, &m.b);
        CHECK(m.b.knees == 0 && (m.b.no_more == NULL) == (k == 0), "%d: %zu %s",
              k, m.b.knees, m.b.no_more);
        field_free();
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_knee_is_where_the_slope_rises_through_1),
        cmocka_unit_test(a_tube_in_which_there_may_be_a_knee_has_not_none),
        cmocka_unit_test(no_knee_is_found_at_a_turn),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
