/* Where a saddle is, of random laws and materials beside a fold, against 113
 * bits. */
#include "drawn.h"
#include "records.h"

/* Whether it is loose. */
static bool hold_place(const struct draw *d, const char *what,
                       const struct quantity *q, quad want)
{
    const double off = (double) fabsq(q->value - want);

    CHECK(off <= q->error, "%s: %s = %.17g +- %.2g is off by %.2g", d->name,
          what, q->value, q->error, off);
    return q->error > 100.0 * off;
}

/* What the root of the balance leaves of a saddle's place, in long double. */
static void a_saddle_beside_a_fold_is_known_to_its_bar(void **state)
{
    uint64_t seed = check_seed();
    size_t loose[2] = { 0 }, count = 0;

    (void) state;
    if (laws_emulated())
        skip();
    while (count < 300) {
        struct draw d;
        struct steady_root root[EQUILIBRIA_MAX];
        struct block b;
        if (!draw_one(check_bits(&seed), &seed, draw_near_fold, &d))
            continue;
        block_init(&b, &d.law, &d.m, d.tan_alpha);
        const struct planar sys = block_planar(&b);
        for (size_t i = 0, n = equilibrium_find(sys.steady, sys.ctx, root);
             i < n; i++) {
            struct equilibrium e;
            block_anchor(&b, root[i].x, true);
            const struct planar at = block_planar(&b);
            equilibrium_at(&at, root[i].fold, &e);
            if (e.type != EQUILIBRIUM_SADDLE || !draw_solve_saddle(&d, &b))
                continue;
            const struct steady_number s = numbers_steady(&b, &e);
            const quad psi = law_psi_is_log(&d.law) ? d.at.y0 : expq(d.at.y0);
            loose[0] += hold_place(&d, "v", &s.v, d.at.v0);
            loose[1] += hold_place(&d, "psi", &s.psi, psi);
            count++;
        }
    }
    print_message("# of %zu, bars above 100 times the error: %zu of v, %zu of "
                  "psi\n",
                  count, loose[0], loose[1]);
    for (int i = 0; i < 2; i++)
        CHECK(10 * loose[i] <= count, "%zu of %zu bars are loose", loose[i],
              count);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_saddle_beside_a_fold_is_known_to_its_bar),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
