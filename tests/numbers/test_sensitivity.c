/* Sensitivities against tables, against exact relations between them, and
 * against differences. */
#include "sensitivity.h"

#include <float.h>
#include <math.h>

#include "check.h"
#include "laws.h"
#include "reference_rows.h"

/* A solved slope and its sensitivities; free with solved_free(&p->s). */
struct point {
    struct law law;
    struct material m;
    double alpha, t, eps2;
    struct solved s;
    struct sensitivities d;
};

static bool find(struct point *p, const struct law *law,
                 const struct material *m, double alpha, double rtol)
{
    size_t evaluations = 0;

    p->law = *law;
    p->m = *m;
    p->alpha = alpha;
    p->t = tan(alpha);
    p->eps2 = material_eps2(m);
    enum status status = solve(&p->s, law, m, tanl((long double) alpha), 1e-12);
    if (status != STATUS_OK || !p->s.has_saddle)
        return false;
    status = sensitivity_find(&p->s.block, &p->s.saddle, &p->s.numbers, rtol,
                              &p->d, &evaluations);
    CHECK(status == STATUS_OK, "%s, alpha = %g: %.300s", law->preset, alpha,
          status_text(status));
    assert_true(evaluations > 0);
    return true;
}

static bool has_all(const struct sensitivity_numbers *d, size_t count,
                    const enum parameter which[])
{
    for (size_t i = 0; i < count; i++)
        if (!quantity_exists(&d->by[which[i]]))
            return false;
    return true;
}

/* ---- tables ------------------------------------------------------------- */

/* The tables' derivatives hold 9 to 12 digits. */
static void check_row(const struct csv *c, const struct quantity *got,
                      double want, const char *side, size_t *compared)
{
    if (isnan(want))
        return;
    CHECK(quantity_exists(got), "row %zu, %s: %s", c->row, side, got->reason);
    CHECK(fabs(got->value - want) <= got->error + 2e-11 * fabs(want),
          "row %zu, %s: %.15g +- %.1e, not %.15g", c->row, side, got->value,
          got->error, want);
    CHECK(got->error <= 1e-9 * fabs(want), "row %zu, %s: bar %g of %g", c->row,
          side, got->error, want);
    ++*compared;
}

static size_t check_table(const char *name)
{
    struct csv c;
    size_t compared = 0;

    csv_open(&c, name);
    while (csv_next(&c)) {
        const struct law law = row_law(&c);
        const struct material m = row_material(&c);
        const bool limit = strcmp(csv_text(&c, "lower_end"), "psi_0") == 0;
        struct point p;
        if (!find(&p, &law, &m, csv_number(&c, "alpha", 0), 1e-12))
            continue;
        check_row(&c, &p.d.v_plus.by[PARAMETER_ALPHA],
                  csv_number(&c, "dlnvplus_dalpha", NAN), "v_plus", &compared);
        if (limit)
            check_row(&c, &p.d.v_minus.by[PARAMETER_ALPHA],
                      csv_number(&c, "dlnlower_dalpha", NAN), "v_minus",
                      &compared);
        solved_free(&p.s);
    }
    return compared;
}

static void derivatives_by_alpha_are_those_of_the_tables(void **state)
{
    (void) state;
    const size_t compared =
        check_table("manifold.csv") + check_table("extreme.csv");
    CHECK(compared > 200, "only %zu", compared);
}

/* ---- exact relations ---------------------------------------------------- */

/* coef . sensitivities = want, within the bars. */
struct relation {
    double sum, bar, size;
};

static void add(struct relation *r, double coef,
                const struct sensitivity_numbers *d, enum parameter p)
{
    r->sum += coef * d->by[p].value;
    r->bar += fabs(coef) * d->by[p].error;
    r->size += fabs(coef * d->by[p].value);
}

static void check_relation(const struct point *p, const char *what,
                           const struct relation *r, size_t *compared)
{
    CHECK(fabs(r->sum) <= r->bar + 4 * DBL_EPSILON * (1 + r->size),
          "%s: %s (theta %d, psi_ss %d, T %d, K %d, form %d), alpha = %.17g: "
          "%g of %g, bars %g",
          what, p->law.preset, (int) p->law.theta, (int) p->law.psi_ss,
          (int) p->law.timescale, (int) p->law.kinetics, (int) p->law.form,
          p->alpha, r->sum, r->size, r->bar);
    ++*compared;
}

/* mu is homogeneous of degree 1 in (a, b, mu_star): all of them, tan(alpha)
 * and eps^2/cos(alpha) times k change nothing. */
static void check_homogeneity(const struct point *p,
                              const struct sensitivity_numbers *d, size_t *n)
{
    static const enum parameter needed[] = { PARAMETER_ALPHA, PARAMETER_A,
                                             PARAMETER_B, PARAMETER_MU_STAR,
                                             PARAMETER_EPS2 };
    const double by_tan = 1 / (1 + p->t * p->t);
    struct relation r = { 0 };

    if (!has_all(d, 5, needed))
        return;
    add(&r, p->m.a, d, PARAMETER_A);
    add(&r, p->m.b, d, PARAMETER_B);
    add(&r, p->m.mu_star, d, PARAMETER_MU_STAR);
    add(&r, p->t * by_tan, d, PARAMETER_ALPHA);
    add(&r, (1 - p->t * p->t * by_tan) * p->eps2, d, PARAMETER_EPS2);
    check_relation(p, "homogeneity", &r, n);
}

/* Log form: only tan(alpha) - mu_star and eps^2/cos(alpha) matter. */
static void check_slope(const struct point *p,
                        const struct sensitivity_numbers *d, size_t *n)
{
    static const enum parameter needed[] = { PARAMETER_ALPHA, PARAMETER_MU_STAR,
                                             PARAMETER_EPS2 };
    struct relation r = { 0 };

    if (p->law.form != FRICTION_LOG || !has_all(d, 3, needed))
        return;
    add(&r, 1, d, PARAMETER_ALPHA);
    add(&r, 1 + p->t * p->t, d, PARAMETER_MU_STAR);
    add(&r, -p->t * p->eps2, d, PARAMETER_EPS2);
    check_relation(p, "slope", &r, n);
}

static bool is_preset(const struct law *law, const char *name)
{
    const struct law *preset = law_preset_find(name);

    return law->theta == preset->theta && law->psi_ss == preset->psi_ss &&
           law->timescale == preset->timescale &&
           law->kinetics == preset->kinetics;
}

/* No velocity of its own: v times k, psi over k [less ln k] gives the same
 * motion at mu_star + (a - b) ln k, eps^2 k^2. */
static void check_scale(const struct point *p,
                        const struct sensitivity_numbers *d, size_t *n)
{
    static const enum parameter needed[] = { PARAMETER_MU_STAR,
                                             PARAMETER_EPS2 };
    struct relation r = { .sum = 1 };

    if (!has_all(d, 2, needed) ||
        !(is_preset(&p->law, "dieterich") || is_preset(&p->law, "ruina") ||
          is_preset(&p->law, "perrin")))
        return;
    add(&r, p->m.a - p->m.b, d, PARAMETER_MU_STAR);
    add(&r, 2 * p->eps2, d, PARAMETER_EPS2);
    check_relation(p, "scale", &r, n);
}

/* With w = R v and phi = psi [psi/(1+R)] only c/(1+R), eps^2/R^2 and
 * mu_star - a ln R + b ln(1+R) matter. */
static void check_range(const struct point *p,
                        const struct sensitivity_numbers *d, size_t *n)
{
    static const enum parameter needed[] = { PARAMETER_MU_STAR, PARAMETER_C,
                                             PARAMETER_R, PARAMETER_EPS2 };
    const double part = p->m.R / (1 + p->m.R);
    struct relation r = { .sum = 1 };

    if (!has_all(d, 4, needed) || !(is_preset(&p->law, "spinodal") ||
                                    is_preset(&p->law, "spinodal_phi_gen")))
        return;
    add(&r, p->m.R, d, PARAMETER_R);
    add(&r, p->m.a - p->m.b * part, d, PARAMETER_MU_STAR);
    add(&r, p->m.c * part, d, PARAMETER_C);
    add(&r, 2 * p->eps2, d, PARAMETER_EPS2);
    check_relation(p, "range", &r, n);
}

enum { RELATIONS = 4 };

static void check_relations(const struct point *p, size_t compared[RELATIONS])
{
    const struct sensitivity_numbers *d[] = { &p->d.v_plus, &p->d.v_minus };

    for (int i = 0; i < 2; i++) {
        check_homogeneity(p, d[i], &compared[0]);
        check_slope(p, d[i], &compared[1]);
        check_scale(p, d[i], &compared[2]);
        check_range(p, d[i], &compared[3]);
    }
}

/* psi_ss = -ln v under a theta that wants psi > 0 has its saddle anywhere down
 * to psi = 0, where steady states are not found to all digits. */
static bool is_edge(const struct solved *s)
{
    return s->block.law.psi_ss == PSI_SS_MINUS_LOG &&
           !law_psi_is_log(&s->block.law) && fabs(s->block.at.x0) < 1e-9;
}

static void exact_relations_hold_within_the_bars(void **state)
{
    uint64_t seed = check_seed();
    size_t compared[RELATIONS] = { 0 };
    struct point p;

    (void) state;
    for (size_t i = 0; i < 800; i++) {
        struct law law;
        struct material m;
        if (!laws_draw(i % LAWS, &seed, &law, &m) ||
            !find(&p, &law, &m, check_uniform(&seed, 0.05, 0.8), 1e-12))
            continue;
        if (!is_edge(&p.s))
            check_relations(&p, compared);
        solved_free(&p.s);
    }
    for (int i = 0; law_preset_at((size_t) i); i++)
        for (double alpha = 0.25; alpha < 0.41; alpha += 0.01) {
            struct law law = *law_preset_at((size_t) i);
            const struct material m = material_bristol_board();
            law.form = i % 2 ? FRICTION_LOG : FRICTION_ASINH;
            if (!find(&p, &law, &m, alpha, 1e-10))
                continue;
            check_relations(&p, compared);
            solved_free(&p.s);
        }
    for (int i = 0; i < RELATIONS; i++)
        CHECK(compared[i] > 5, "relation %d: only %zu", i, compared[i]);
}

/* ---- bars --------------------------------------------------------------- */

static void bars_follow_the_accuracy_asked_for(void **state)
{
    static const char *const law[] = { "dieterich_gen", "spinodal_gen",
                                       "spinodal_phi_gen", "perrin" };
    const struct material m = material_bristol_board();

    (void) state;
    for (int i = 0; i < 4 * 5; i++) {
        struct point best, p;
        const double alpha = 0.296 + 0.0218 * (i / 4);
        assert_true(find(&best, law_preset_find(law[i % 4]), &m, alpha, 1e-14));
        double first = 0.0, last = 0.0;
        for (int digits = 4; digits <= 12; digits += 2) {
            assert_true(find(&p, &best.law, &m, alpha, pow(10, -digits)));
            for (int k = 0; k < PARAMETERS; k++) {
                const struct quantity *q = &p.d.v_plus.by[k];
                const struct quantity *exact = &best.d.v_plus.by[k];
                if (!quantity_exists(q))
                    continue;
                const double off = fabs(q->value - exact->value);
                CHECK(off <= q->error + exact->error,
                      "%s, alpha = %g, rtol 1e-%d, p = %d: %.15g +- %.1e, not "
                      "%.15g",
                      best.law.preset, alpha, digits, k, q->value, q->error,
                      exact->value);
                last = q->error / fabs(q->value);
                first = digits == 4 && k == 0 ? last : first;
            }
            solved_free(&p.s);
        }
        CHECK(last < 1e-5 * first, "%s, alpha = %g: bars from %g to %g",
              best.law.preset, alpha, first, last);
        solved_free(&best.s);
    }
}

/* ---- differences -------------------------------------------------------- */

/* ln v_plus (side 0), ln v_minus at a parameter times 1 + h; NaN: none. */
static double moved(const struct point *p, enum parameter which, double h,
                    int side)
{
    struct material m = p->m;
    double alpha = p->alpha;
    struct solved s;

    *(which == PARAMETER_ALPHA     ? &alpha
      : which == PARAMETER_A       ? &m.a
      : which == PARAMETER_B       ? &m.b
      : which == PARAMETER_MU_STAR ? &m.mu_star
      : which == PARAMETER_C       ? &m.c
      : which == PARAMETER_R       ? &m.R
                                   : &m.L) *=
        which == PARAMETER_EPS2 ? 1 / (1 + h) : 1 + h;
    if (solve(&s, &p->law, &m, tanl((long double) alpha), 1e-13) != STATUS_OK)
        return NAN;
    const struct quantity *q =
        side == 0 ? &s.numbers.ln_v_plus : &s.numbers.ln_v_minus;
    const double value = s.has_saddle && quantity_exists(q) ? q->value : NAN;
    solved_free(&s);
    return value;
}

/* d ln v/d ln p by central differences of falling step, extrapolated (Ridders
 * 1982); *error: what the table says of itself. */
static double difference(const struct point *p, enum parameter which, double h,
                         int side, double *error)
{
    double last[10], row[10], best = NAN;

    *error = HUGE_VAL;
    for (int i = 0; i < 10; i++, h /= 1.6) {
        double factor = 1.0;
        row[0] =
            (moved(p, which, h, side) - moved(p, which, -h, side)) / (2 * h);
        for (int j = 1; j <= i; j++) {
            factor *= 1.6 * 1.6;
            row[j] = row[j - 1] + (row[j - 1] - last[j - 1]) / (factor - 1);
            const double off =
                fmax(fabs(row[j] - row[j - 1]), fabs(row[j] - last[j - 1]));
            if (off < *error) {
                *error = off;
                best = row[j];
            }
        }
        for (int j = 0; j <= i; j++)
            last[j] = row[j];
    }
    return best;
}

static double value_of(const struct point *p, enum parameter which)
{
    return which == PARAMETER_ALPHA     ? p->alpha
           : which == PARAMETER_A       ? p->m.a
           : which == PARAMETER_B       ? p->m.b
           : which == PARAMETER_MU_STAR ? p->m.mu_star
           : which == PARAMETER_C       ? p->m.c
           : which == PARAMETER_R       ? p->m.R
                                        : p->eps2;
}

/* Every sensitivity of a point against differences that start at a relative
 * step h. */
static void check_differences(const char *preset, enum friction_form form,
                              double alpha, double h)
{
    struct law law = *law_preset_find(preset);
    const struct material m = material_bristol_board();
    struct point p;

    law.form = form;
    assert_true(find(&p, &law, &m, alpha, 1e-12));
    for (int k = 0; k < 2 * PARAMETERS; k++) {
        const enum parameter which = (enum parameter)(k / 2);
        const struct sensitivity_numbers *d =
            k % 2 ? &p.d.v_minus : &p.d.v_plus;
        const struct quantity *q = &d->by[which];
        double error;
        if (!quantity_exists(q))
            continue;
        const double scale = value_of(&p, which);
        const struct quantity *log_v =
            k % 2 ? &p.s.numbers.ln_v_minus : &p.s.numbers.ln_v_plus;
        const double size = fabs(log_v->value) + fabs(q->value * scale);
        const double noise = (log_v->error + 8 * DBL_EPSILON * size) / h;
        const double want = difference(&p, which, h, k % 2, &error) / scale;
        const double off = fabs(q->value - want);
        CHECK(off <= q->error + (10 * error + 4 * noise) / scale,
              "%s, alpha = %.10g, p = %d, side %d: %.15g +- %.1e, not %.15g "
              "+- %.1e",
              preset, alpha, (int) which, k % 2, q->value, q->error, want,
              error / scale);
        CHECK(error / scale <= 1e-4 * fabs(want) + 1e-5 / scale,
              "%s, alpha = %.10g, p = %d, side %d: differences are good to %g "
              "of %g only",
              preset, alpha, (int) which, k % 2, error / scale, want);
    }
    solved_free(&p.s);
}

static void differences_of_branches_say_the_same(void **state)
{
    (void) state;
    check_differences("spinodal_gen", FRICTION_ASINH, 0.34, 2e-3);
    check_differences("spinodal_gen", FRICTION_LOG, 0.30, 2e-3);
    check_differences("spinodal_phi_gen", FRICTION_ASINH, 0.36, 2e-3);
    check_differences("dieterich_gen", FRICTION_ASINH, 0.31, 2e-3);
    check_differences("perrin", FRICTION_LOG, 0.1, 2e-3);
}

/* 1e-3, 1e-4, 1e-5 rad below the fold; the slope grows without bound. */
static void steep_sensitivities_near_a_fold_are_right(void **state)
{
    const struct material m = material_bristol_board();
    const double fold =
        numbers_folds(law_preset_find("spinodal_gen"), &m).alpha_cM.value;
    double before = 0.0;

    (void) state;
    for (int digits = 3; digits <= 5; digits++) {
        const double distance = pow(10, -digits);
        struct point p;
        check_differences("spinodal_gen", FRICTION_ASINH, fold - distance,
                          0.02 * distance);
        assert_true(find(&p, law_preset_find("spinodal_gen"), &m,
                         fold - distance, 1e-12));
        const double steep = fabs(p.d.v_plus.by[PARAMETER_ALPHA].value);
        CHECK(steep > 1.5 * before, "%g at %g from the fold, before %g", steep,
              distance, before);
        before = steep;
        solved_free(&p.s);
    }
}

/* ---- what does not exist ------------------------------------------------ */

static void what_does_not_exist_says_why(void **state)
{
    struct material m = material_bristol_board();
    struct law law = *law_preset_find("dieterich");
    struct point p;

    (void) state;
    assert_true(find(&p, &law, &m, 0.34, 1e-12)); /* open, and v = 0 */
    for (int k = 0; k < PARAMETERS; k++) {
        assert_non_null(p.d.v_plus.by[k].reason);
        assert_non_null(p.d.v_minus.by[k].reason);
    }
    assert_string_equal(p.d.v_plus.by[PARAMETER_A].reason,
                        p.s.numbers.v_plus.reason);
    assert_string_equal(p.d.v_plus.by[PARAMETER_C].reason,
                        "the law does not use c");
    solved_free(&p.s);

    law = *law_preset_find("spinodal_gen"); /* v_minus ~ c ln c */
    law.form = FRICTION_LOG;
    m.c = 0.0;
    m.R = HUGE_VAL;
    assert_true(find(&p, &law, &m, 0.34, 1e-12));
    assert_true(quantity_exists(&p.s.numbers.v_minus));
    assert_non_null(p.d.v_minus.by[PARAMETER_C].reason);
    assert_null(p.d.v_plus.by[PARAMETER_C].reason);
    assert_null(p.d.v_minus.by[PARAMETER_A].reason);
    assert_string_equal(p.d.v_plus.by[PARAMETER_R].reason, "R is infinite");
    solved_free(&p.s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(derivatives_by_alpha_are_those_of_the_tables),
        cmocka_unit_test(exact_relations_hold_within_the_bars),
        cmocka_unit_test(bars_follow_the_accuracy_asked_for),
        cmocka_unit_test(differences_of_branches_say_the_same),
        cmocka_unit_test(steep_sensitivities_near_a_fold_are_right),
        cmocka_unit_test(what_does_not_exist_says_why),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
