/* From a piece to the next, on fields whose branches are known. */
#include "proof_join.h"

#include "made_tube.h"

enum { DRAWS = 500 };

static long double dep_at(const struct made *f, double theta, long double u[2])
{
    u[0] = f->error;
    u[1] = 0;
    follow(f, 1, theta, 20, u);
    return poly(f->piece.coef, theta) + u[0];
}

/* The place nearest to theta = 1, within `most`, where the branch has that dep;
 * false: there is none. */
static bool meet(const struct made *f, double dep, double most, double *theta,
                 long double u[2])
{
    enum { STEPS = 200 };
    const long double off = dep_at(f, 1, u) - dep;
    const bool below = off < 0;

    *theta = 1;
    if (fabsl(off) < 1e-15L)
        return true;
    for (int i = 1; i <= 2 * STEPS; i++) {
        const double h = (i % 2 ? 1 : -1) * most / STEPS;
        double lo = 1 + (i - 1) / 2 * h, hi = lo + h;
        if ((dep_at(f, hi, u) < dep) == below)
            continue;
        for (int k = 0; k < 50; k++) {
            *theta = lo / 2 + hi / 2;
            *((dep_at(f, *theta, u) < dep) == below ? &lo : &hi) = *theta;
        }
        return true;
    }
    return false;
}

static void check_turn(const struct made *f, const struct proof_piece *next,
                       const struct proof_front *front, struct tally *t, int n)
{
    const struct proof_piece *p = &f->piece;
    double theta = 1;
    long double u[2];

    CHECK(meet(f, next->start, 1.01 * front->error / fabs(p->step) + 1e-9,
               &theta, u),
          "draw %d: %g is not met within %g", n, next->start, front->error);
    const double at = p->start + p->step * theta;
    t->nearest = fmax(t->nearest,
                      part_of("turn", f, at - next->coef[0], front->error, n));
    const double more =
        part_of("integral of a turn", f, u[1], (double) front->excess.hi, n);
    t->excess = fmax(t->excess, more);
}

/* Anywhere in [1 - less, 1] the next piece may begin along the same axis. */
static void check_same(const struct made *f, struct interval_tape *tape,
                       double less, int n)
{
    const struct proof_piece *p = &f->piece;
    const struct interval theta = { 1 - less, 1 };
    struct proof_piece next = *p;
    struct proof_front front = { .error = fabs(f->error) };

    next.coef[0] += f->error;
    assert_true(proof_join(tape, p, &next, theta, &front));
    const struct proof_place at = proof_place_on(p, theta, fabs(f->error), 1);
    const struct interval dep = p->ind ? at.X : at.Y;
    for (int i = 0; i < 2; i++) {
        const long double w = poly(p->coef, i ? 1 : 1 - less) - f->error;
        part_of("join", f, w - next.coef[0], front.error, n);
        CHECK(dep.lo <= w && w <= dep.hi, "draw %d: %Lg", n, w);
    }
    next.start += f->error;
    const struct interval end = proof_piece_end(p, &next);
    const long double exact = ((long double) next.start - p->start) / p->step;
    CHECK(end.lo <= exact && exact <= end.hi && end.hi - end.lo < 1e-13,
          "draw %d: %Lg", n, exact);
}

static void a_turn_holds_the_branch_and_its_integral(void **state)
{
    uint64_t rng = check_seed();
    struct tally t = { 0 };
    static struct interval_graph g;
    static struct interval_tape tape;

    (void) state;
    for (int n = 0; n < DRAWS; n++) {
        struct made f;
        draw(&f, false, &rng);
        struct proof_front front = { .error = fabs(f.error) };
        struct proof_piece next = { .ind = 1 - f.piece.ind };
        const double gap = pow(10, check_uniform(&rng, -4, -0.5));
        next.start = (double) poly(f.piece.coef, 1) + perhaps(&rng, -gap, gap);
        next.coef[0] = f.piece.start + f.piece.step + perhaps(&rng, -gap, gap);
        tape_of(&f, &g, &tape);
        check_same(&f, &tape, perhaps(&rng, 0, 0.2), n);
        if (proof_join(&tape, &f.piece, &next, interval_point(1), &front)) {
            check_turn(&f, &next, &front, &t, n);
            t.proved++;
        }
        interval_tape_free(&tape);
        interval_graph_free(&g);
    }
    print_message("# %d of %d are proved, up to %g of the bounds, %g of "
                  "integrals\n",
                  t.proved, DRAWS, t.nearest, t.excess);
    CHECK(t.proved > DRAWS / 4 && t.nearest > 0.99 && t.excess > 0.9,
          "%d, %g, %g", t.proved, t.nearest, t.excess);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_turn_holds_the_branch_and_its_integral),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
