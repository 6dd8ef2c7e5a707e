/* The laws as people would type them, on slopes: in windows of e^-100 ...
 * e^100 as many equilibria as the steady curve has, and there. */
#include <math.h>
#include <string.h>

#include "block.h"
#include "check.h"
#include "equilibria.h"
#include "equilibrium.h"

static struct formula_system s;
static struct system_equilibria found;
static struct fault why;
static const struct formula_place at = { "typed", 1, 1 };

static void parameter(const char *name, long double value)
{
    char text[60];

    sprintf(text, "%.21Lg", value);
    CHECK(formula_system_parameter(&s, name, text, at, &why) == STATUS_OK,
          "%s: %s", name, why.text);
}

static void define(const char *name, const char *text)
{
    CHECK(formula_system_define(&s, name, text, at, &why) == STATUS_OK, "%s",
          why.text);
}

static const char *const theta[THETAS] = { "ln(psi)", "psi", "ln(c + psi)",
                                           "ln(c + (1 + R)*psi)" };
static const char *const psi_ss[] = { "1/v", "-ln(v)", "(1 + R)/(1 + R*v)",
                                      "1/(1 + R*v)" };

static void type_law(const struct law *law, const struct material *m,
                     long double tan_alpha)
{
    enum status status;

    formula_system_init(&s);
    status = formula_system_state(&s, "v", CHART_POSITIVE, NULL, at, &why);
    assert_int_equal(status, STATUS_OK);
    status = formula_system_state(
        &s, "psi", law_psi_is_log(law) ? CHART_REAL : CHART_POSITIVE, NULL, at,
        &why);
    assert_int_equal(status, STATUS_OK);
    parameter("mu_star", m->mu_star);
    parameter("a", m->a);
    parameter("b", m->b);
    parameter("c", m->c);
    parameter("R", m->R);
    parameter("tan_alpha", tan_alpha);
    define("theta", theta[law->theta]);
    define("psi_ss", psi_ss[law->psi_ss]);
    define("T", law->timescale == TIMESCALE_SLIP ? "1/v" : "R/(1 + R*v)");
    define("mu", law->form == FRICTION_LOG
                     ? "mu_star + a*ln(v) + b*theta"
                     : "a*asinh(v/2*exp((mu_star + b*theta)/a))");
    status = formula_system_rate(&s, "v", "(tan_alpha - mu)*1e5", at, &why);
    CHECK(status == STATUS_OK, "%s", why.text);
    status = formula_system_rate(&s, "psi",
                                 law->kinetics == KINETICS_SINH
                                     ? "-sinh(psi - psi_ss)/T"
                                     : "-(psi - psi_ss)/T",
                                 at, &why);
    CHECK(status == STATUS_OK, "%s", why.text);
}

/* Both know all there are where |ln v|, |ln psi| < reach; each of one is one of
 * the other. */
static void compare(const struct law *law, const struct material *m,
                    long double tan_alpha, double reach)
{
    const struct system_window wide = { { -reach, -reach }, { reach, reach } };
    struct steady_root root[EQUILIBRIA_MAX];
    struct block b;

    block_init(&b, law, m, tan_alpha);
    const struct planar sys = block_planar(&b);
    const size_t all = equilibrium_find(sys.steady, sys.ctx, root);
    int expected = 0;
    for (size_t i = 0; i < all; i++) {
        const double y =
            (double) steady_y(law, m, root[i].x); /* of the chart */
        if (fabsl(root[i].x) < reach && fabs(y) < reach)
            root[expected++] = root[i];
    }
    type_law(law, m, tan_alpha);
    const enum status status = system_equilibria_find(&s, &wide, &found, &why);
    CHECK(status == STATUS_OK, "%s", why.text);
    CHECK(found.complete && found.count == expected,
          "%s %s tan %.12Lg: %d found, %d undecided, %ld boxes, expected %d",
          law->preset, friction_form_names[law->form], tan_alpha, found.count,
          found.undecided_count, found.boxes, expected);
    for (int i = 0; i < expected; i++) {
        const double off =
            (double) (found.equilibrium[i].chart[0].value - root[i].x);
        CHECK(fabs(off) < 1e-9, "%s: %g at %Lg", law->preset, off, root[i].x);
        CHECK(found.equilibrium[i].chart[0].error < 1e-20, "%g",
              found.equilibrium[i].chart[0].error);
    }
}

static void each_law_on_a_slope_has_those_of_its_steady_curve(void **state)
{
    const struct material m = material_bristol_board();

    (void) state;
    for (size_t i = 0; law_preset_at(i); i++)
        for (int form = 0; form < 2; form++) {
            struct law law = *law_preset_at(i);
            if (law.kinetics == KINETICS_COMPOSITE)
                continue;
            law.form = form ? FRICTION_LOG : FRICTION_ASINH;
            for (int k = 0; k < 8; k++)
                compare(&law, &m, tanl(0.22L + 0.03L * k), 100);
        }
}

static void so_has_any_material(void **state)
{
    uint64_t seed = check_seed();

    (void) state;
    for (int run = 0; run < 100; run++) {
        struct material m = material_bristol_board();
        struct law law = *law_preset_at(check_bits(&seed) % 7);
        law.form = check_bits(&seed) % 2 ? FRICTION_LOG : FRICTION_ASINH;
        m.mu_star = check_uniform(&seed, 0.1, 1);
        m.a = exp(check_uniform(&seed, -9, -2));
        m.b = exp(check_uniform(&seed, -9, -2));
        m.c = exp(check_uniform(&seed, -12, 1));
        m.R = exp(check_uniform(&seed, -1, 12));
        compare(&law, &m, tanl(atanl(m.mu_star) + 0.1L * (run % 3 - 1)), 300);
    }
}

/* A relative distance of 1e-9 on both sides of each extremum of mu_ss. */
static void next_to_a_fold_there_are_two_or_none(void **state)
{
    const struct material m = material_bristol_board();
    int folds = 0;

    (void) state;
    for (size_t i = 0; law_preset_at(i); i++) {
        const struct law law = *law_preset_at(i);
        long double x[4];
        if (law.kinetics == KINETICS_COMPOSITE)
            continue;
        const size_t n = steady_extrema(&law, &m, x);
        for (size_t k = 0; k < n; k++, folds++) {
            const long double mu = steady_mu(&law, &m, x[k]);
            compare(&law, &m, mu * (1 + 1e-9L), 100);
            compare(&law, &m, mu * (1 - 1e-9L), 100);
        }
    }
    assert_true(folds > 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_law_on_a_slope_has_those_of_its_steady_curve),
        cmocka_unit_test(so_has_any_material),
        cmocka_unit_test(next_to_a_fold_there_are_two_or_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
