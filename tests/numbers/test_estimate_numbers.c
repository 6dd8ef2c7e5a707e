/* The paper's estimates (29)-(42), through a study, against estimates.csv. */
#include "estimate_numbers.h"

#include <math.h>

#include "asked.h"

/* "none" and what a double cannot hold do not exist; the rest is right to
 * 1e-12 and inside its bar. */
static void check_number(const struct csv *c, const char *column,
                         const struct quantity *q)
{
    const double want = csv_number(c, column, NAN);
    const double off = fabs(q->value - want);

    if (isnan(want)) {
        CHECK(!quantity_exists(q), "row %zu: %s = %g", c->row, column,
              q->value);
        return;
    }
    if (fabs(want) <= 1e-300)
        return;
    CHECK(quantity_exists(q), "row %zu: %s: %s", c->row, column, q->reason);
    CHECK(off <= 1e-12 * fabs(want), "row %zu: %s = %.17g, not %.17g (%.2g)",
          c->row, column, q->value, want, off / fabs(want));
    CHECK(off <= q->error, "row %zu: %s = %.17g +- %.2g is off by %.2g", c->row,
          column, q->value, q->error, off);
}

static void check_xi(const struct csv *c, const struct xi_number *xi)
{
    static const char *const ends[] = { "v_minus", "v_plus", "mu_s41", "G32" };
    const struct quantity *q[] = { &xi->v_minus, &xi->v_plus, &xi->mu_s,
                                   &xi->G };

    for (int i = 0; i < 4; i++) {
        char column[64];
        snprintf(column, sizeof column, "xi%g_%s", xi->xi, ends[i]);
        check_number(c, column, q[i]);
    }
}

static void check_row(const struct csv *c, const struct estimate_numbers *e)
{
    check_number(c, "v_sp0", &e->v_sp0);
    check_number(c, "psi_sp0", &e->psi_sp0);
    check_number(c, "x_k30", &e->x_k);
    check_number(c, "x_k31", &e->x_k_small_psi);
    check_number(c, "chi_v_minus", &e->chi_v_minus);
    check_number(c, "chi_v_plus", &e->chi_v_plus);
    assert_int_equal(e->xi_count, 4);
    for (size_t i = 0; i < e->xi_count; i++)
        check_xi(c, &e->xi[i]);
}

/* R = inf: eta = 1, a law without R; else one with it.  The estimates are
 * those of the log form with c = 0 whatever the law's own. */
static void run_row(struct asked *a, const struct csv *c, const char *form)
{
    static const char *const common[] = { "mu_star", "a",      "b",
                                          "L",       "V_star", NULL };
    static const char *const own[] = { "R", NULL };
    const bool has_R = isfinite(csv_number(c, "R", INFINITY));

    a->sets = 0;
    ask(a, "law.preset", has_R ? "spinodal_gen" : "dieterich_gen");
    ask(a, "law.friction", form);
    ask(a, "slope.alpha", csv_text(c, "alpha"));
    ask(a, "gravity", csv_text(c, "g"));
    ask(a, "products", "[estimates]");
    ask_material(a, c, common);
    if (has_R)
        ask_material(a, c, own);
    asked_run(a);
}

static void every_estimate_is_right(void **state)
{
    static const char *const forms[] = { "log", "asinh" };
    struct csv c;
    size_t rows = 0;

    (void) state;
    csv_open(&c, "estimates.csv");
    for (; csv_next(&c); rows++)
        for (int form = 0; form < 2; form++) {
            static struct asked a;
            run_row(&a, &c, forms[form]);
            check_row(&c, &a.study.estimates);
            asked_free(&a);
        }
    assert_int_equal(rows, 18);
}

/* Where eta = 1, (41) with v_plus of the exact manifold, and that v_plus; the
 * table's digits lost to alpha stay below one. */
static void mu_s_41_takes_the_exact_v_plus(void **state)
{
    struct csv c;

    (void) state;
    csv_open(&c, "estimates.csv");
    while (csv_next(&c)) {
        static struct asked a;
        if (isfinite(csv_number(&c, "R", INFINITY)))
            continue;
        run_row(&a, &c, "asinh");
        check_number(&c, "mu_s41_exact_vplus",
                     &a.study.estimates.mu_s_exact_v_plus);
        asked_free(&a);
    }
}

static void estimates_need_hyperbolic_kinetics_and_a_logarithm(void **state)
{
    static const char *const laws[] = { "dieterich", "spinodal", "ruina",
                                        "perrin" };

    (void) state;
    for (int i = 0; i < 4; i++) {
        static struct asked a;
        a.sets = 0;
        ask(&a, "law.preset", laws[i]);
        ask(&a, "slope.alpha", "0.34");
        ask(&a, "products", "[estimates]");
        asked_run(&a);
        CHECK(!quantity_exists(&a.study.estimates.v_sp0) &&
                  !quantity_exists(&a.study.estimates.xi[0].v_plus),
              "%s has estimates", laws[i]);
        asked_free(&a);
    }
}

/* One slope of dieterich_gen, where only estimates are asked for. */
static void estimate_at(struct asked *a, const char *alpha, const char *b)
{
    a->sets = 0;
    ask(a, "law.preset", "dieterich_gen");
    ask(a, "slope.alpha", alpha);
    ask(a, "material.b", b);
    ask(a, "products", "[estimates]");
    asked_run(a);
}

/* v_sp0 = 3.2e-21 and 7.8e-245: both roots of chi are v_sp0 to a double, and
 * their bars say so. */
static void roots_of_chi_have_digits_however_small_v_sp0_is(void **state)
{
    static const char *const alpha[] = { "0.45", "0.8", "1.2", "1.45" };

    (void) state;
    for (int i = 0; i < 4; i++) {
        static struct asked a;
        estimate_at(&a, alpha[i], "0.0489");
        const struct estimate_numbers *e = &a.study.estimates;
        const struct quantity *q[] = { &e->chi_v_minus, &e->chi_v_plus };
        assert_int_equal(e->chi_roots, 2);
        for (int k = 0; k < 2; k++) {
            const double far = fabs(q[k]->value / e->v_sp0.value - 1.0);
            CHECK(quantity_exists(q[k]) && q[k]->error > 0.0 &&
                      q[k]->error < 1e-11 * q[k]->value,
                  "%s: %.17g +- %.2g", alpha[i], q[k]->value, q[k]->error);
            CHECK(i == 0 ? far > 1e-3 : far < 1e-12, "%s: %.3g from v_sp0",
                  alpha[i], far);
        }
        asked_free(&a);
    }
}

/* v_sp0 = e^-980 and e^+1280. */
static void what_a_double_cannot_hold_has_a_reason(void **state)
{
    static const char *const at[][2] = { { "1.5", "0.0489" },
                                         { "0.05", "0.03515" } };
    static struct asked a;

    (void) state;
    for (int i = 0; i < 2; i++) {
        estimate_at(&a, at[i][0], at[i][1]);
        const struct estimate_numbers *e = &a.study.estimates;
        const struct quantity *q[] = { &e->v_sp0, &e->psi_sp0, &e->chi_v_minus,
                                       &e->chi_v_plus };
        for (int k = 0; k < 4; k++)
            CHECK(!quantity_exists(q[k]) &&
                      strcmp(q[k]->reason,
                             "the estimate is beyond the range of a double") ==
                          0,
                  "alpha %s: number %d is %g (%s)", at[i][0], k, q[k]->value,
                  q[k]->reason);
        CHECK(quantity_exists(&e->x_k_small_psi) &&
                  e->x_k_small_psi.error < 1e-10 * fabs(e->x_k_small_psi.value),
              "%g +- %g", e->x_k_small_psi.value, e->x_k_small_psi.error);
        asked_free(&a);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_estimate_is_right),
        cmocka_unit_test(mu_s_41_takes_the_exact_v_plus),
        cmocka_unit_test(estimates_need_hyperbolic_kinetics_and_a_logarithm),
        cmocka_unit_test(roots_of_chi_have_digits_however_small_v_sp0_is),
        cmocka_unit_test(what_a_double_cannot_hold_has_a_reason),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
