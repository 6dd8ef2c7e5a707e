/* Folds and the cusp of Fig 4, through a study, against folds.csv. */
#include <math.h>

#include "asked.h"

static const struct column {
    const char *name;
    size_t offset;
} columns[] = {
#define AT(member) offsetof(struct fold_numbers, member)
    { "v_M", AT(v_M) },
    { "mu_M", AT(mu_s) },
    { "alpha_cM", AT(alpha_cM) },
    { "v_m", AT(v_m) },
    { "alpha_cm", AT(alpha_cm) },
    { "vM_eq11", AT(v_M_eq11) },
    { "vm_eq12", AT(v_m_eq12) },
    { "c_star", AT(c_cusp) },
    { "alpha_cusp", AT(alpha_cusp) },
#undef AT
};

static void run_row(struct asked *a, const struct csv *c, const char *law)
{
    static const char *const keys[] = { "mu_star", "a", "b", "c", "R", NULL };

    a->sets = 0;
    ask(a, "law.preset", law);
    ask(a, "law.friction", csv_text(c, "form"));
    ask(a, "slope.alpha", "0.3");
    ask(a, "products", "[folds]");
    ask_material(a, c, keys);
    asked_run(a);
}

/* What rounding the row's inputs and the extremum itself to doubles costs
 * grows like 1/(1 - c/c*) towards the cusp. */
static double promise(const struct csv *c)
{
    const double share = csv_number(c, "c", 0) / csv_number(c, "c_star", 1);
    return 1e-12 / fmax(1.0 - share, 0.1);
}

static void check_column(const struct csv *c, const struct column *k,
                         const struct asked *a)
{
    const struct quantity *q =
        (const void *) ((const char *) &a->study.folds + k->offset);
    const double want = csv_number(c, k->name, NAN);
    const double off = fabs(q->value - want);

    CHECK(quantity_exists(q) == (bool) isfinite(want), "row %zu: %s = %g",
          c->row, k->name, q->value);
    if (!quantity_exists(q))
        return;
    CHECK(off <= promise(c) * fabs(want), "row %zu: %s = %.17g, not %.17g",
          c->row, k->name, q->value, want);
    /* some roundings of the inputs, magnified like b/(b - a) */
    const double rise = csv_number(c, "b", 0) / csv_number(c, "a", 0) - 1.0;
    const double input = 0x1p-52 * fabs(want) * 4.0 / rise;
    CHECK(off <= q->error + input * promise(c) / 1e-12,
          "row %zu: %s = %.17g +- %.2g is off by %.2g", c->row, k->name,
          q->value, q->error, off);
}

static void every_fold_and_cusp_is_right(void **state)
{
    static const char *const laws[] = { "spinodal", "spinodal_gen" };
    struct csv c;
    size_t rows = 0;

    (void) state;
    csv_open(&c, "folds.csv");
    for (; csv_next(&c); rows++)
        for (int law = 0; law < 2; law++) {
            static struct asked a;
            run_row(&a, &c, laws[law]);
            for (size_t i = 0; i < sizeof columns / sizeof *columns; i++)
                check_column(&c, &columns[i], &a);
            asked_free(&a);
        }
    assert_int_equal(rows, 26);
}

/* At the cusp both folds meet; a little below it they are there, above not. */
static void folds_vanish_at_the_cusp(void **state)
{
    (void) state;
    for (int above = 0; above < 2; above++) {
        static struct asked a;
        a.sets = 0;
        ask(&a, "law.preset", "spinodal_gen");
        ask(&a, "slope.alpha", "0.3");
        ask(&a, "products", "[folds]");
        ask(&a, "material.c", above ? "2.89991" : "2.89989");
        asked_run(&a);
        const struct fold_numbers *f = &a.study.folds;
        CHECK(quantity_exists(&f->v_M) == !above, "v_M %g", f->v_M.value);
        CHECK(quantity_exists(&f->alpha_cm) == !above, "alpha_cm %g",
              f->alpha_cm.value);
        if (!above)
            CHECK(fabs(f->alpha_cM.value - f->alpha_cusp.value) < 1e-6 &&
                      fabs(f->alpha_cm.value - f->alpha_cusp.value) < 1e-6,
                  "alpha_cM %.9g, alpha_cm %.9g, cusp %.9g", f->alpha_cM.value,
                  f->alpha_cm.value, f->alpha_cusp.value);
        asked_free(&a);
    }
}

/* A slope is positive: where mu_ss is not, as the logarithmic form may be at
 * the extremum of a weak friction, no slope balances it. */
static void a_fold_without_a_slope_has_a_reason(void **state)
{
    struct law law = *law_preset_find("spinodal_gen");
    size_t without = 0, with = 0;
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 400; i++) {
        law.form = i % 2 ? FRICTION_LOG : FRICTION_ASINH;
        struct material m = material_bristol_board();
        m.mu_star = exp(check_uniform(&rng, log(1e-4), log(0.3)));
        m.R = exp(check_uniform(&rng, log(1.0), log(1e4)));
        m.c = exp(check_uniform(&rng, log(1e-4), log(1.0)));
        const struct fold_numbers f = numbers_folds(&law, &m);
        const struct quantity *v[] = { &f.v_m, &f.v_M };
        const struct quantity *alpha[] = { &f.alpha_cm, &f.alpha_cM };
        for (int k = 0; k < 2; k++) {
            if (!quantity_exists(v[k]))
                continue;
            const double mu =
                (double) steady_mu(&law, &m, logl((long double) v[k]->value));
            CHECK(quantity_exists(alpha[k]) == (mu > 0.0), "%g: alpha %g, %s",
                  mu, alpha[k]->value, alpha[k]->reason);
            *(mu > 0.0 ? &with : &without) += 1;
            if (mu > 0.0)
                CHECK(fabs(tan(alpha[k]->value) - mu) < 1e-12, "%g, tan %g", mu,
                      alpha[k]->value);
            else
                assert_string_equal(alpha[k]->reason,
                                    "mu_ss is not positive there");
        }
    }
    CHECK(without > 20 && with > 100, "%zu, %zu", without, with);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_fold_and_cusp_is_right),
        cmocka_unit_test(folds_vanish_at_the_cusp),
        cmocka_unit_test(a_fold_without_a_slope_has_a_reason),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
