/* Cells, on fields whose branches are known. */
#include "proof_cell.h"

#include "made_tube.h"

enum { DRAWS = 160 };

/* From cell to cell up to theta = end, which is in the last one. */
static void check_cells(const struct made *f, const struct proof_branch *b,
                        double end, long double u[2], int n)
{
    enum { PARTS = 4, STEPS = 40 };
    double from = 0;

    for (size_t i = 0; i < b->cells; i++) {
        const struct proof_cell *c = &b->cell[i];
        const double stop = fmin(c->to, end), before = (double) u[1];
        for (int k = 0; k < PARTS; k++) {
            const double at = from + (stop - from) * k / PARTS;
            const double to = from + (stop - from) * (k + 1) / PARTS;
            follow(f, at, to, STEPS, u);
            part_of("w within", f, u[0], c->radius, n);
        }
        part_of("w after", f, u[0], c->after, n);
        check_integral(f, u[1] - before, c->excess, n);
        from = stop;
    }
}

/* Cells to anywhere in `to`; what is known of the integral is so wide that
 * remainders of it are felt. */
static void check_all(const struct made *f, struct interval_tape *tape,
                      struct interval to, struct tally *t, int n)
{
    const struct interval known = interval_within(10);
    struct proof_front front = { .error = fabs(f->error), .excess = known };
    struct proof_branch out = { .cells = 0 };
    enum status status = STATUS_OK;

    if (proof_cells(tape, &f->piece, 0, to, &front, &out, &status)) {
        for (int i = 0; i < 2; i++) {
            long double u[2] = { f->error, 0 };
            check_cells(f, &out, (double) (i ? to.hi : to.lo), u, n);
            const double near = part_of("error", f, u[0], front.error, n);
            t->nearest = fmax(t->nearest, near);
            check_integral(f, u[1],
                           (struct interval){ front.excess.lo + known.hi,
                                              front.excess.hi - known.hi },
                           n);
        }
        t->proved++;
    }
    free(out.cell);
}

static void a_cell_holds_the_branch_and_its_integral(void **state)
{
    uint64_t rng = check_seed();
    struct tally t = { 0 };
    static struct interval_graph g;
    static struct interval_tape tape;

    (void) state;
    for (int n = 0; n < DRAWS; n++) {
        struct made f;
        draw(&f, false, &rng);
        const struct interval to = { 1 - perhaps(&rng, 0, 0.2), 1 };
        tape_of(&f, &g, &tape);
        check_all(&f, &tape, to, &t, n);
        interval_tape_free(&tape);
        interval_graph_free(&g);
    }
    print_message("# %d of %d are proved, w up to %g of its bound\n", t.proved,
                  DRAWS, t.nearest);
    CHECK(t.proved > DRAWS / 5 && t.nearest > 0.8, "%d, %g", t.proved,
          t.nearest);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cell_holds_the_branch_and_its_integral),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
