/* Where psi is a logarithm: branches and saddles at psi that no e^psi would
 * survive, against 113 bits.  CHECK_COUNT sets how many slopes. */
#include "stress_truth.h"

#include <math.h>

#include "check.h"
#include "laws.h"
#include "records.h"
#include "reference_rows.h"
#include "steady.h"

static void hold(const char *what, const char *text, const struct quantity *q,
                 const struct stress_true *t)
{
    CHECK(quantity_exists(q), "%s: %s: %s", text, what, q->reason);
    CHECK(t->exists, "%s: %s: no truth", text, what);
    const double off = (double) fabsq((quad) q->value - t->value);
    CHECK(off <= q->error, "%s: %s = %.17g +- %.2g is off by %.2g", text, what,
          q->value, q->error, off);
}

/* The slope's numbers, which are to be told; returns psi_at_v0, NaN where the
 * lower branch has a limit. */
static double hold_slope(const struct law *law, const struct material *m,
                         long double tan_alpha, const char *text)
{
    static struct stress_truth t;
    struct solved s;

    assert_int_equal(solve(&s, law, m, tan_alpha, 1e-12), STATUS_OK);
    CHECK(s.has_saddle, "%s: no saddle", text);
    stress_truth_find(law, m, tan_alpha, &t);
    const struct critical_numbers *n = &s.numbers;
    CHECK(n->upper_end == t.upper_end, "%s: upper_end %s", text,
          end_names[n->upper_end]);
    CHECK(n->lower_end == t.lower_end, "%s: lower_end %s", text,
          end_names[n->lower_end]);
    if (n->lower_end == END_V_0)
        hold("psi_at_v0", text, &n->psi_at_v0, &t.number[STRESS_PSI_AT_V0]);
    else
        hold("v_minus", text, &n->v_minus, &t.number[STRESS_V_MINUS]);
    hold("x_deficit", text, &n->x_deficit, &t.number[STRESS_X_DEFICIT]);
    if (n->upper_end == END_PSI_INF)
        hold("v_plus", text, &n->v_plus, &t.number[STRESS_V_PLUS]);
    const double psi = n->psi_at_v0.value;
    solved_free(&s);
    return psi;
}

/* Slip and time run on while psi falls without friction to mind it. */
static void a_lower_branch_is_followed_down_to_any_psi(void **state)
{
    static const double alpha[] = { 0.22, 0.23, 0.235, 0.24, 0.245 };
    struct law law = *law_preset_find("ruina");
    const struct material m = material_bristol_board();

    (void) state;
    if (laws_emulated())
        skip();
    for (size_t i = 0; i < sizeof alpha / sizeof *alpha; i++) {
        char text[32];
        snprintf(text, sizeof text, "alpha %g", alpha[i]);
        law.form = FRICTION_ASINH;
        const double psi =
            hold_slope(&law, &m, tanl((long double) alpha[i]), text);
        CHECK(alpha[i] != 0.24 || fabs(psi + 395531.763458) < 1e-5, "%.12g",
              psi);
    }
}

/* v = 0 lies below all doubles of psi there, a logarithm itself. */
static void a_lower_branch_that_leaves_all_psi_says_so(void **state)
{
    static const double alpha[] = { 0.21, 0.2, 0.15, 0.1 };
    static const char far[] =
        "the lower branch leaves psi > -1e300 while v > 0";
    struct law law = *law_preset_find("ruina");
    const struct material m = material_bristol_board();
    struct solved s;

    (void) state;
    for (size_t i = 0; i < sizeof alpha / sizeof *alpha; i++) {
        law.form = FRICTION_ASINH;
        assert_int_equal(
            solve(&s, &law, &m, tanl((long double) alpha[i]), 1e-12),
            STATUS_OK);
        assert_int_equal(s.numbers.lower_end, END_TRUNCATED);
        assert_string_equal(s.numbers.psi_at_v0.reason, far);
        assert_string_equal(s.numbers.v_minus.reason, far);
        solved_free(&s);
    }
}

/* First-order kinetics and psi_ss = -ln v: psi_at_v0 from -1e1 to -1e100. */
static void random_lower_branches_end_where_they_do(void **state)
{
    const char *count = getenv("CHECK_COUNT");
    const size_t rows = count ? strtoul(count, NULL, 10) : 8;
    uint64_t seed = check_seed();
    size_t far = 0;

    (void) state;
    if (laws_emulated())
        skip();
    for (size_t i = 0; i < rows; i++) {
        struct law law = *law_preset_find("ruina");
        struct material m = material_bristol_board();
        char text[160];
        law.form = (enum friction_form)(i % 2);
        m.a *= laws_power(&seed, -0.3, 0.3);
        m.b = m.a * check_uniform(&seed, 1.2, 2.0);
        m.L = laws_power(&seed, -7, -4);
        /* slip on the way to v_sp, at v = 0 without friction */
        const double slip = laws_power(&seed, 0.8, 1.5);
        const double x = 0.5 * log(slip / material_eps2(&m));
        const long double tangent = steady_mu(&law, &m, (long double) x);
        if (!(tangent > 0.01L))
            continue;
        snprintf(text, sizeof text, "%s a %.17g b %.17g L %.17g x %.17g",
                 friction_form_names[law.form], m.a, m.b, m.L, x);
        far += hold_slope(&law, &m, tangent, text) < -1e6;
    }
    print_message("# %zu slopes, %zu below -1e6\n", rows, far);
    assert_true(far > 0);
}

/* psi_ss = 1/v and theta = psi: saddles at psi of 1e3 to 1e9. */
static void saddles_at_any_psi_have_manifolds(void **state)
{
    const char *count = getenv("CHECK_COUNT");
    const size_t rows = count ? strtoul(count, NULL, 10) : 8;
    uint64_t seed = check_seed() + 1;

    (void) state;
    if (laws_emulated())
        skip();
    for (size_t i = 0; i < rows; i++) {
        struct law law = { .preset = "composed",
                           .equation = "",
                           .form = (enum friction_form)(i % 2),
                           .theta = THETA_PSI,
                           .psi_ss = PSI_SS_INVERSE,
                           .timescale = TIMESCALE_SLIP,
                           .kinetics = (enum kinetics)(i / 2 % 2) };
        const struct material m = material_bristol_board();
        const double x = -log(laws_power(&seed, 3, 9));
        char text[96];
        snprintf(text, sizeof text, "%s %s x %.17g",
                 friction_form_names[law.form], kinetics_names[law.kinetics],
                 x);
        (void) hold_slope(&law, &m, steady_mu(&law, &m, (long double) x), text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_lower_branch_is_followed_down_to_any_psi),
        cmocka_unit_test(a_lower_branch_that_leaves_all_psi_says_so),
        cmocka_unit_test(random_lower_branches_end_where_they_do),
        cmocka_unit_test(saddles_at_any_psi_have_manifolds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
