/*
 * bench_manifold -- both branches, v_plus, v_minus and x_excess with their
 * bars, against plain.h at the same error; then a sweep over 1000 slopes.
 * Generalised Dieterich law, Table 2.  Prints times and ratios of one run; a
 * ratio below 1 means that Slipway is faster.
 */
#include <math.h>
#include <stdio.h>

#include "numbers.h"
#include "plain.h"

enum { REPEATS = 15, INNER = 40, SWEEP = 1000 };

struct answer {
    double v_plus, v_minus, x_excess;
};

static struct answer our_answer(struct block *b, double rtol, bool all)
{
    const struct answer none = { NAN, NAN, NAN };
    struct planar sys = block_planar(b);
    struct steady_root root[EQUILIBRIA_MAX];
    struct grow_options o = grow_defaults(rtol);
    struct branch branch[2];
    struct equilibrium e;
    struct local_series u;

    if (equilibrium_find(sys.steady, sys.ctx, root) == 0)
        return none;
    block_anchor(b, root[0].x, true);
    sys = block_planar(b);
    equilibrium_at(&sys, false, &e);
    o.carry = (struct carry){ { BLOCK_EXCESS }, 1 };
    if (local_at(&sys, &e, MANIFOLD_STABLE, &o.carry, o.order, 0.01 * rtol,
                 &u) != STATUS_OK ||
        grow_branches(&sys, &u, &o, branch) != STATUS_OK)
        return none;
    struct critical_numbers n = numbers_critical(b, &e, &branch[0], &branch[1]);
    if (all)
        numbers_knees(b, &sys, &branch[0], &branch[1], &n);
    branch_free(&branch[0]);
    branch_free(&branch[1]);
    return (struct answer){ n.v_plus.value, n.v_minus.value, n.x_excess.value };
}

static struct block block_at(const struct law *law, double alpha)
{
    const struct material m = material_bristol_board();
    struct block b;

    block_init(&b, law, &m, tanl((long double) alpha));
    return b;
}

static double worst(struct plain_answer a, struct answer exact)
{
    return fmax(fabs(a.v_plus / exact.v_plus - 1.0),
                fmax(fabs(a.v_minus / exact.v_minus - 1.0),
                     fabs(a.x_excess / exact.x_excess - 1.0)));
}

static double our_time(struct block *b, double rtol, bool all)
{
    const double t = plain_now();

    for (int i = 0; i < INNER; i++)
        our_answer(b, rtol, all);
    return (plain_now() - t) / INNER;
}

static double plain_time(struct plain *p, double tol)
{
    const double t = plain_now();

    for (int i = 0; i < INNER; i++)
        plain_branches(p, tol);
    return (plain_now() - t) / INNER;
}

static void race(enum friction_form form, double alpha, double accuracy)
{
    struct law law = *law_preset_find("dieterich_gen");
    struct equilibrium e;

    law.form = form;
    struct block b = block_at(&law, alpha);
    const struct answer exact = our_answer(&b, 1e-13, false);
    const struct answer ours = our_answer(&b, accuracy, false);
    const struct planar sys = block_planar(&b);
    equilibrium_at(&sys, false, &e);
    struct plain p = plain_of(&b, &e);
    double tol = accuracy, user = HUGE_VAL, few = HUGE_VAL, all = HUGE_VAL;
    for (int i = 0; i < 12 && worst(plain_branches(&p, tol), exact) > accuracy;
         i++)
        tol *= 0.5;
    for (int r = 0; r < REPEATS; r++) {
        user = fmin(user, plain_time(&p, tol));
        few = fmin(few, our_time(&b, accuracy, false));
        all = fmin(all, our_time(&b, accuracy, true));
    }
    printf(
        "%-5s %.2f %-7.0e %8.1f %9.1e %6zu %8.1f %9.1e %8.2f %8.2f\n",
        friction_form_names[form], alpha, accuracy, 1e6 * user,
        worst(plain_branches(&p, tol), exact), p.calls, 1e6 * few,
        worst((struct plain_answer){ ours.v_plus, ours.v_minus, ours.x_excess },
              exact),
        few / user, all / user);
}

/* 1000 slopes, one after another and on all cores, over 1000 times one. */
static void sweep(void)
{
    const struct law *law = law_preset_find("dieterich_gen");
    struct block b = block_at(law, 0.34);
    double one = HUGE_VAL, serial = HUGE_VAL, parallel = HUGE_VAL, sum = 0.0;

    for (int r = 0; r < 5; r++) {
        one = fmin(one, our_time(&b, 1e-12, true));
        double t = plain_now();
        for (int i = 0; i < SWEEP; i++) {
            struct block s = block_at(law, 0.28 + 1e-4 * i);
            sum += our_answer(&s, 1e-12, true).v_plus;
        }
        serial = fmin(serial, plain_now() - t);
        t = plain_now();
#pragma omp parallel for schedule(dynamic, 8) reduction(+ : sum)
        for (int i = 0; i < SWEEP; i++) {
            struct block s = block_at(law, 0.28 + 1e-4 * i);
            sum += our_answer(&s, 1e-12, true).v_plus;
        }
        parallel = fmin(parallel, plain_now() - t);
    }
    printf("\n%d slopes 0.28 .. 0.38: %.2f times %d single ones (alpha 0.34); "
           "on all cores %.2f times faster; checksum %.6g\n",
           SWEEP, serial / one / SWEEP, SWEEP, serial / parallel, sum);
}

int main(void)
{
    static const double alpha[] = { 0.30, 0.34, 0.38 };

    printf("form  alpha accuracy  GSL us   error   calls  ours us   error  "
           "ratio  with knees\n");
    for (int form = FRICTION_LOG; form >= FRICTION_ASINH; form--)
        for (int i = 0; i < 3; i++) {
            race((enum friction_form) form, alpha[i], 1e-12);
            race((enum friction_form) form, alpha[i], 1e-6);
        }
    sweep();
    return 0;
}
