/* The two routes to the critical numbers against each other, on the reference
 * tables and on random parameter sets.  VERIFY_SETS: how many of these, instead
 * of what fits into a test run. */
#include "verify.h"

#include <math.h>

#include "check.h"
#include "laws.h"
#include "records.h"
#include "reference_rows.h"
#include "stops.h"

enum { SETS = 1000 };

static size_t sets_asked(void)
{
    const char *s = getenv("VERIFY_SETS");
    return s ? (size_t) strtoull(s, NULL, 10) : SETS;
}

static enum status verify(const struct solved *s, double rtol,
                          struct verification *v)
{
    return verify_numbers(&s->block, &s->system, &s->saddle, &s->numbers, rtol,
                          NULL, v);
}

/* ---- random parameter sets ----------------------------------------------- */

/* Wide: a, b/a, c up to the cusp's, R, and eps^2 by 18 orders. */
static struct material draw_material(uint64_t *rng)
{
    struct material m = material_bristol_board();

    m.mu_star = check_uniform(rng, 0.0, 1.5);
    m.a = laws_power(rng, -4.0, log10(0.5));
    m.b = m.a * (1.0 + laws_power(rng, -3.0, log10(29.0)));
    m.R = check_bits(rng) % 8 ? laws_power(rng, 0.0, 6.0) : HUGE_VAL;
    const double rise = m.b - m.a, R = fmin(m.R, 1e6);
    const double cusp = (1.0 + R) * rise * rise / (4.0 * m.a * m.b);
    m.c = check_bits(rng) % 4 ? cusp * laws_power(rng, -8.0, 0.0) : 0.0;
    m.V_c = laws_power(rng, -3.0, 5.0);
    m.V_star *= laws_power(rng, -4.5, 4.5);
    return m;
}

static size_t count_presets(void)
{
    size_t n = 0;

    while (law_preset_at(n))
        n++;
    return n;
}

/* A preset every other time, else any composition. */
static struct law draw_law(uint64_t *rng)
{
    const size_t number = (size_t) check_bits(rng);

    if (number % 2)
        return laws_at(number / 2 % LAWS);
    struct law law = *law_preset_at(number / 2 % count_presets());
    law.form = (enum friction_form)(check_bits(rng) % FRICTION_FORMS);
    return law;
}

/* tan(alpha): anywhere; or beside a fold; or where there is a given steady
 * state. */
static long double draw_slope(uint64_t *rng, const struct law *law,
                              const struct material *m)
{
    long double fold[4];
    const size_t folds = steady_extrema(law, m, fold);
    const uint64_t how = check_bits(rng) % 4;
    const double near = laws_power(rng, -13.0, -6.0);
    const double x = check_uniform(rng, -40.0, 40.0);
    const double alpha = check_uniform(rng, 0.001, 1.57);

    if (how == 0 && folds > 0)
        return steady_mu(law, m, fold[check_bits(rng) % folds]) *
               (1.0L + (check_bits(rng) % 2 ? near : -near));
    if (how == 1 && x < (double) steady_x_max(law))
        return steady_mu(law, m, (long double) x);
    return tanl((long double) alpha);
}

struct set {
    struct law law;
    struct material m;
    long double tan_alpha;
    char text[320];
};

static void draw_set(uint64_t *rng, struct set *s)
{
    struct fault why;

    do {
        s->law = draw_law(rng);
        s->m = draw_material(rng);
        s->tan_alpha = draw_slope(rng, &s->law, &s->m);
    } while (law_check(&s->law, &s->m, &why) != STATUS_OK ||
             !(s->tan_alpha > 1e-6L && s->tan_alpha < 1e3L));
    const struct law *l = &s->law;
    const struct material *m = &s->m;
    snprintf(s->text, sizeof s->text,
             "%s (%s, %s, %s, %s) %s, a %.17g b %.17g c %.17g R %.17g V_star "
             "%.17g V_c %.17g mu_star %.17g tan(alpha) %.21Lg",
             l->preset, theta_names[l->theta], psi_ss_names[l->psi_ss],
             timescale_names[l->timescale], kinetics_names[l->kinetics],
             friction_form_names[l->form], m->a, m->b, m->c, m->R, m->V_star,
             m->V_c, m->mu_star, s->tan_alpha);
}

/* What became of the sets. */
struct tally {
    size_t saddles;
    size_t outside;  /* of doubles: a saddle off the chart, or eigenvalues
                        further apart than 1e300 */
    size_t failures; /* of the first route, which says so */
    size_t deep;     /* of the second: is_deep */
    size_t compared, loose, disagree;
};

static bool is_outside(const struct solved *s)
{
    const double *scaled = s->saddle.scaled;

    return !box_holds(s->system.domain, s->system.origin) ||
           equilibrium_is_beyond(&s->saddle) ||
           fabs(scaled[1]) < 1e-300 * fabs(scaled[0]);
}

static void say_disagreement(const struct verification *v)
{
    for (size_t i = 0; i < VERIFIED_ENDS; i++)
        if (!v->end[i].agree)
            print_message("#   %s: %s, then %s\n", v->end[i].name,
                          end_names[v->end[i].first],
                          end_names[v->end[i].second]);
    for (size_t i = 0; i < VERIFIED_NUMBERS; i++) {
        const struct verified_number *n = &v->number[i];
        if (!n->agree)
            print_message("#   %s: %.17g +- %.2g, then %.17g +- %.2g\n",
                          n->name, n->first.value, n->first.error,
                          n->second.value, n->second.error);
    }
}

static bool is_finite(const struct quantity *q)
{
    return !quantity_exists(q) || (isfinite(q->value) && isfinite(q->error));
}

static void judge(const struct set *set, const struct verification *v,
                  struct tally *t)
{
    for (size_t i = 0; i < VERIFIED_NUMBERS; i++) {
        const struct quantity *a = &v->number[i].first;
        const struct quantity *b = &v->number[i].second;
        CHECK(is_finite(a) && is_finite(b), "%s: %s", v->number[i].name,
              set->text);
        if (!quantity_exists(b))
            continue;
        t->compared++;
        t->loose += b->error > 1e-8 * fabs(b->value);
    }
    if (v->disagreements == 0)
        return;
    t->disagree++;
    print_message("# %s\n", set->text);
    say_disagreement(v);
}

/* Below this the second route gives up. */
static bool is_deep(const struct solved *s)
{
    return !s->system.axis[1].is_log &&
           (s->numbers.lower_end == END_TRUNCATED ||
            s->numbers.psi_at_v0.value < -1e9);
}

static void try_set(const struct set *set, struct tally *t)
{
    struct solved s;
    struct verification v;
    const enum status first =
        solve(&s, &set->law, &set->m, set->tan_alpha, 1e-12);

    if (s.has_saddle) {
        t->saddles++;
        if (is_outside(&s)) {
            t->outside++;
        } else {
            const enum status second = verify(&s, 1e-12, &v);
            CHECK(second == STATUS_OK || is_deep(&s), "%s: %s",
                  status_text(second), set->text);
            if (second != STATUS_OK)
                t->deep++;
            else if (first == STATUS_OK)
                judge(set, &v, t);
            else
                t->failures++;
        }
    }
    solved_free(&s);
}

static void both_routes_agree_on_random_sets(void **state)
{
    uint64_t rng = check_seed();
    struct tally t = { 0 };
    const size_t sets = sets_asked();

    (void) state;
    for (size_t i = 0; i < sets; i++) {
        struct set set;
        draw_set(&rng, &set);
        try_set(&set, &t);
    }
    print_message("# CHECK_SEED=%llu: %zu sets, %zu with a saddle (%zu beyond "
                  "doubles); the first route failed in %zu, the second in "
                  "%zu; %zu numbers "
                  "compared, %zu with a bar above 1e-8; %zu sets disagree\n",
                  (unsigned long long) check_seed(), sets, t.saddles, t.outside,
                  t.failures, t.deep, t.compared, t.loose, t.disagree);
    CHECK(t.disagree == 0, "%zu sets disagree", t.disagree);
    CHECK(t.saddles * 4 > sets, "only %zu saddles", t.saddles);
    CHECK(t.failures * 20 < t.saddles, "%zu failures", t.failures);
    CHECK(t.loose * 20 < t.compared, "%zu loose bars", t.loose);
}

/* ---- the reference tables ------------------------------------------------ */

static void check_table(const char *name, double rtol)
{
    struct csv c;
    size_t numbers = 0;

    csv_open(&c, name);
    while (csv_next(&c)) {
        struct solved s;
        struct verification v;
        assert_int_equal(solve_row(&s, &c, rtol), STATUS_OK);
        if (s.has_saddle) {
            const enum status second = verify(&s, rtol, &v);
            assert_true(second == STATUS_OK || is_deep(&s));
            if (second == STATUS_OK)
                say_disagreement(&v);
            CHECK(second != STATUS_OK || v.disagreements == 0,
                  "%s row %zu, rtol %g", name, c.row, rtol);
            for (size_t i = 0; second == STATUS_OK && i < VERIFIED_NUMBERS; i++)
                numbers += v.number[i].first.reason == NULL;
        }
        solved_free(&s);
    }
    assert_true(numbers > 50);
}

static void both_routes_agree_on_every_row_at_every_accuracy(void **state)
{
    (void) state;
    for (int k = 6; k <= 12; k += 2) {
        check_table("manifold.csv", pow(10.0, -k));
        check_table("extreme.csv", pow(10.0, -k));
        check_table("composed.csv", pow(10.0, -k));
        check_table("random.csv", pow(10.0, -k));
    }
}

/* sinh(psi - psi_ss) changes over 1/psi in ln psi, here 1e-30 and 1e-100: so
 * small is what a branch does. */
static void branches_may_be_short_beyond_measure(void **state)
{
    struct material m = material_bristol_board();

    (void) state;
    for (int digits = 30; digits <= 100; digits += 70) {
        const long double x = -(long double) digits * logl(10.0L);
        const struct law *law = law_preset_find("dieterich_gen");
        struct solved s;
        struct verification v;
        m.mu_star = 3.5;
        assert_int_equal(solve(&s, law, &m, steady_mu(law, &m, x), 1e-12),
                         STATUS_OK);
        assert_true(s.has_saddle);
        assert_int_equal(verify(&s, 1e-12, &v), STATUS_OK);
        assert_int_equal(v.disagreements, 0);
        const double size = pow(10.0, -digits);
        const double X = s.upper.limit.x, error = s.upper.error.x;
        CHECK(X > 10.0 * size && X < 1e4 * size, "1e-%d: %g", digits, X);
        CHECK(s.lower.limit.x < -10.0 * size && s.lower.limit.x > -1e4 * size,
              "1e-%d: %g", digits, s.lower.limit.x);
        CHECK(error < 1e-9 * X, "1e-%d: %g +- %g", digits, X, error);
        solved_free(&s);
    }
}

/* ---- what it says -------------------------------------------------------- */

/* Table 2, alpha = 0.34, one law. */
static struct verification verify_default(const char *preset,
                                          const struct critical_numbers *wrong)
{
    const struct material m = material_bristol_board();
    struct solved s;
    struct verification v;

    assert_int_equal(solve(&s, law_preset_find(preset), &m, tanl(0.34L), 1e-12),
                     STATUS_OK);
    if (wrong)
        s.numbers = *wrong;
    assert_int_equal(verify(&s, 1e-12, &v), STATUS_OK);
    solved_free(&s);
    return v;
}

static struct critical_numbers numbers_default(void)
{
    const struct verification v = verify_default("dieterich_gen", NULL);
    struct critical_numbers n = numbers_no_critical();

    assert_int_equal(v.disagreements, 0);
    n.upper_end = v.end[0].first;
    n.lower_end = v.end[1].first;
    n.v_plus = v.number[0].first;
    n.v_minus = v.number[1].first;
    n.x_excess = v.number[3].first;
    n.x_deficit = v.number[4].first;
    return n;
}

static void a_number_moved_by_two_bars_is_noticed(void **state)
{
    struct critical_numbers n = numbers_default();
    struct quantity *moved[] = { &n.v_plus, &n.v_minus, &n.x_excess,
                                 &n.x_deficit };
    static const size_t at[] = { 0, 1, 3, 4 };

    (void) state;
    for (int i = 0; i < 4; i++) {
        const struct quantity was = *moved[i];
        moved[i]->value *= 1.0 + 1e-8;
        const struct verification v = verify_default("dieterich_gen", &n);
        assert_int_equal(v.disagreements, 1);
        assert_false(v.number[at[i]].agree);
        CHECK(fabs(v.number[at[i]].difference - 1e-8 * was.value) <=
                  1e-10 * was.value,
              "%s: difference %g", v.number[at[i]].name,
              v.number[at[i]].difference);
        *moved[i] = was;
    }
}

static void another_end_and_a_missing_number_are_noticed(void **state)
{
    struct critical_numbers n = numbers_default();

    (void) state;
    n.lower_end = END_V_0;
    n.psi_at_v0 = quantity_of(1.0, 0.5);
    n.v_minus = quantity_none("not there");
    const struct verification v = verify_default("dieterich_gen", &n);
    assert_int_equal(v.disagreements, 3);
    assert_true(v.end[0].agree);
    assert_false(v.end[1].agree);
    assert_string_equal(v.end[1].name, "lower_end");
    assert_false(v.number[1].agree);
    assert_true(isnan(v.number[1].difference));
    assert_false(v.number[2].agree);
}

static void numbers_that_do_not_exist_agree(void **state)
{
    (void) state;
    const struct verification v = verify_default("dieterich", NULL);
    assert_int_equal(v.disagreements, 0);
    assert_string_equal(v.number[0].name, "v_plus");
    assert_true(!quantity_exists(&v.number[0].first));
    assert_true(!quantity_exists(&v.number[0].second));
    assert_true(v.number[0].agree && isnan(v.number[0].difference));
    assert_true(v.field_evaluations > 1000);
}

static void the_monitor_can_stop_it(void **state)
{
    const struct monitor monitor = { stop_at_once, NULL };
    const struct material m = material_bristol_board();
    struct solved s;
    struct verification v;

    (void) state;
    assert_int_equal(solve(&s, law_preset_at(0), &m, tanl(0.34L), 1e-12),
                     STATUS_OK);
    assert_int_equal(verify_numbers(&s.block, &s.system, &s.saddle, &s.numbers,
                                    1e-12, &monitor, &v),
                     STATUS_STOPPED);
    solved_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_routes_agree_on_random_sets),
        cmocka_unit_test(both_routes_agree_on_every_row_at_every_accuracy),
        cmocka_unit_test(branches_may_be_short_beyond_measure),
        cmocka_unit_test(a_number_moved_by_two_bars_is_noticed),
        cmocka_unit_test(another_end_and_a_missing_number_are_noticed),
        cmocka_unit_test(numbers_that_do_not_exist_agree),
        cmocka_unit_test(the_monitor_can_stop_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
