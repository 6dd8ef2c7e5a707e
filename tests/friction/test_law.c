#include "law.h"

#include <math.h>
#include <string.h>

#include "check.h"
#include "laws.h"

/* Table of section 1 of the paper's laws, typed in again. */
/* clang-format off */
static const struct law table[] = {
    { "dieterich", "Dieterich law", "(3)_1",
      FRICTION_ASINH, THETA_LN_PSI, PSI_SS_INVERSE,
      TIMESCALE_SLIP, KINETICS_LINEAR, NULL },
    { "dieterich_gen", "Generalised Dieterich law", "(5)",
      FRICTION_ASINH, THETA_LN_PSI, PSI_SS_INVERSE,
      TIMESCALE_SLIP, KINETICS_SINH, NULL },
    { "ruina", "Ruina law", "(6)",
      FRICTION_ASINH, THETA_PSI, PSI_SS_MINUS_LOG,
      TIMESCALE_SLIP, KINETICS_LINEAR, NULL },
    { "perrin", "Perrin law", "(7)",
      FRICTION_ASINH, THETA_PSI, PSI_SS_MINUS_LOG,
      TIMESCALE_SLIP, KINETICS_SINH, NULL },
    { "spinodal", "Spinodal law", "(8)",
      FRICTION_ASINH, THETA_LN_C_PSI, PSI_SS_SPINODAL,
      TIMESCALE_SPINODAL, KINETICS_LINEAR, NULL },
    { "spinodal_gen", "Generalised spinodal law", "(10)",
      FRICTION_ASINH, THETA_LN_C_PSI, PSI_SS_SPINODAL,
      TIMESCALE_SPINODAL, KINETICS_SINH, NULL },
    { "spinodal_phi_gen", "Generalised spinodal law of φ", "before (8)",
      FRICTION_ASINH, THETA_LN_C_1PR_PSI,
      PSI_SS_SPINODAL_UNIT, TIMESCALE_SPINODAL, KINETICS_SINH, NULL },
    { "kato_tullis", "Kato and Tullis law", "Kato & Tullis (2001)",
      FRICTION_ASINH, THETA_LN_PSI,
      PSI_SS_LAMBERT, TIMESCALE_SLIP, KINETICS_COMPOSITE, NULL },
};
/* clang-format on */
enum { PRESETS = sizeof table / sizeof *table };

static void presets_are_the_laws_of_the_paper(void **state)
{
    (void) state;
    for (size_t i = 0; i < PRESETS; i++) {
        const struct law *want = &table[i], *law = law_preset_at(i);
        assert_non_null(law);
        assert_string_equal(law->preset, want->preset);
        assert_string_equal(law->words, want->words);
        assert_string_equal(law->equation, want->equation);
        assert_int_equal(law->form, want->form);
        assert_int_equal(law->theta, want->theta);
        assert_int_equal(law->psi_ss, want->psi_ss);
        assert_int_equal(law->timescale, want->timescale);
        assert_int_equal(law->kinetics, want->kinetics);
        assert_ptr_equal(law_preset_find(want->preset), law);
    }
    assert_null(law_preset_at(PRESETS));
}

static void an_unknown_preset_is_not_found(void **state)
{
    (void) state;
    assert_null(law_preset_find("spinodal_ge"));
    assert_null(law_preset_find("composed"));
    assert_null(law_preset_find(""));
}

static size_t count(const char *const *names)
{
    size_t n = 0;

    while (names[n])
        n++;
    return n;
}

static void components_have_the_names_of_scenes(void **state)
{
    (void) state;
    assert_int_equal(count(friction_form_names), FRICTION_FORMS);
    assert_int_equal(count(theta_names), THETAS);
    assert_int_equal(count(psi_ss_names), PSI_SS_LAMBERT);
    assert_int_equal(count(timescale_names), TIMESCALES);
    assert_int_equal(count(kinetics_names), KINETICS_COMPOSITE);
    assert_string_equal(friction_form_names[FRICTION_LOG], "log");
    assert_string_equal(theta_names[THETA_LN_C_1PR_PSI], "ln_c_1pR_psi");
    assert_string_equal(psi_ss_names[PSI_SS_MINUS_LOG], "minus_log");
    assert_string_equal(psi_ss_names[PSI_SS_SPINODAL_UNIT], "spinodal_unit");
    assert_string_equal(timescale_names[TIMESCALE_SLIP45], "slip45");
    assert_string_equal(kinetics_names[KINETICS_SINH], "sinh");
}

static void a_material_is_reached_by_name(void **state)
{
    static const char *const names[] = { "mu_star", "a", "b",      "c", "R",
                                         "V_c",     "L", "V_star", "g" };
    struct material m = material_bristol_board();
    const double want[] = { 0.369, 0.0349, 0.0489, 1e-3, 100,
                            1,     0.9e-6, 1e-6,   9.81 };

    (void) state;
    for (int key = 0; key < MATERIAL_KEYS; key++) {
        assert_string_equal(material_key_name((enum material_key) key),
                            names[key]);
        assert_true(*material_member(&m, (enum material_key) key) == want[key]);
    }
}

static void table_2_has_the_eps_and_eta_of_the_paper(void **state)
{
    const struct material m = material_bristol_board();
    const double eps2 = 1.1326311020500621e-7, eps = 3.3654585156410146e-4;
    struct material endless = m;

    (void) state;
    CHECK(fabs(material_eps2(&m) / eps2 - 1) < 4e-16, "%.17g",
          material_eps2(&m));
    CHECK(fabs(sqrt(material_eps2(&m)) / eps - 1) < 4e-16, "%.17g",
          sqrt(material_eps2(&m)));
    endless.R = HUGE_VAL;
    for (size_t i = 0; i < PRESETS; i++) {
        const struct law *law = law_preset_at(i);
        const bool has_R = strncmp(law->preset, "spinodal", 8) == 0;
        assert_true(law_eta(law, &m) == (has_R ? 100.0 / 101.0 : 1.0));
        assert_true(law_eta(law, &endless) == 1.0);
    }
}

static void a_law_uses_the_parameters_in_its_formulas(void **state)
{
    char text[200];

    (void) state;
    for (size_t i = 0; i < LAWS; i++) {
        const struct law law = laws_at(i);
        law_formula(&law, text, sizeof text);
        const bool c = strstr(text, "(c + ") != NULL;
        const bool R = strchr(text, 'R') != NULL;
        const bool V_c = strstr(text, "V_c") != NULL;
        assert_true(law_uses(&law, MATERIAL_C) == c);
        assert_true(law_uses(&law, MATERIAL_R) == R);
        assert_true(law_uses(&law, MATERIAL_V_C) == V_c);
        for (int key = 0; key < MATERIAL_KEYS; key++)
            if (key != MATERIAL_C && key != MATERIAL_R && key != MATERIAL_V_C)
                assert_true(law_uses(&law, (enum material_key) key));
    }
}

static void a_formula_reads_like_the_paper(void **state)
{
    char text[200], small[8];

    (void) state;
    law_formula(law_preset_find("dieterich_gen"), text, sizeof text);
    assert_string_equal(text,
                        "theta = ln(psi), psi_ss = 1/v, T = 1/v, K = sinh(d)");
    law_formula(law_preset_find("spinodal"), text, sizeof text);
    assert_string_equal(text,
                        "theta = ln(c + psi), psi_ss = (1 + R)/(1 + R*v), "
                        "T = R/(1 + R*v), K = d");
    law_formula(law_preset_find("kato_tullis"), text, sizeof text);
    assert_string_equal(text,
                        "theta = ln(psi), psi_ss = exp(lambert(v/V_c))/v, "
                        "dpsi/dt = v*psi*(exp(-v/V_c - ln(v*psi)) - "
                        "ln(v*psi))");
    law_formula(law_preset_find("ruina"), small, sizeof small);
    assert_string_equal(small, "theta =");
}

static void every_preset_accepts_table_2(void **state)
{
    const struct material m = material_bristol_board();
    struct fault why = { "" };

    (void) state;
    for (size_t i = 0; i < PRESETS; i++)
        assert_int_equal(law_check(law_preset_at(i), &m, &why), STATUS_OK);
    assert_string_equal(why.text, "");
}

/* law_check's answer after setting one parameter; a refusal must say which
 * parameter and which value. */
static enum status check_with(const char *preset, enum material_key key,
                              double value)
{
    struct material m = material_bristol_board();
    struct fault why = { "" };
    char start[64];

    *material_member(&m, key) = value;
    const enum status s = law_check(law_preset_find(preset), &m, &why);
    snprintf(start, sizeof start, "%s = %.17g must be ", material_key_name(key),
             value);
    if (s != STATUS_OK)
        CHECK(strncmp(why.text, start, strlen(start)) == 0, "%s", why.text);
    return s;
}

static void a_parameter_out_of_range_is_refused_by_name(void **state)
{
    static const enum material_key positive[] = {
        MATERIAL_A, MATERIAL_B,      MATERIAL_L,
        MATERIAL_R, MATERIAL_V_STAR, MATERIAL_G,
    };
    const double bad[] = { 0.0, -1.0, -HUGE_VAL, nan("") };

    (void) state;
    for (size_t k = 0; k < sizeof positive / sizeof *positive; k++)
        for (size_t i = 0; i < 4; i++)
            assert_int_equal(
                check_with("spinodal_phi_gen", positive[k], bad[i]),
                STATUS_BAD_ARGUMENT);
    for (size_t k = 0; k < sizeof positive / sizeof *positive; k++)
        if (positive[k] != MATERIAL_R)
            assert_int_equal(check_with("spinodal", positive[k], HUGE_VAL),
                             STATUS_BAD_ARGUMENT);
    for (size_t i = 1; i < 4; i++)
        assert_int_equal(check_with("spinodal", MATERIAL_C, bad[i]),
                         STATUS_BAD_ARGUMENT);
    for (size_t i = 0; i < 4; i++)
        assert_int_equal(check_with("kato_tullis", MATERIAL_V_C, bad[i]),
                         STATUS_BAD_ARGUMENT);
    assert_int_equal(check_with("ruina", MATERIAL_MU_STAR, HUGE_VAL),
                     STATUS_BAD_ARGUMENT);
    assert_int_equal(check_with("ruina", MATERIAL_MU_STAR, nan("")),
                     STATUS_BAD_ARGUMENT);
    assert_int_equal(check_with("spinodal", MATERIAL_C, HUGE_VAL),
                     STATUS_BAD_ARGUMENT);
}

static void limits_that_exist_are_accepted(void **state)
{
    (void) state;
    assert_int_equal(check_with("spinodal", MATERIAL_C, 0.0), STATUS_OK);
    assert_int_equal(check_with("ruina", MATERIAL_MU_STAR, -1.0), STATUS_OK);
    assert_int_equal(check_with("spinodal", MATERIAL_R, HUGE_VAL), STATUS_OK);
    assert_int_equal(check_with("spinodal_gen", MATERIAL_R, HUGE_VAL),
                     STATUS_OK);
}

static void parameters_a_law_ignores_are_not_checked(void **state)
{
    (void) state;
    assert_int_equal(check_with("dieterich", MATERIAL_C, -1.0), STATUS_OK);
    assert_int_equal(check_with("dieterich", MATERIAL_R, nan("")), STATUS_OK);
    assert_int_equal(check_with("spinodal", MATERIAL_V_C, 0.0), STATUS_OK);
}

static void refuses(const struct law *law, double R, const char *reason)
{
    struct material m = material_bristol_board();
    struct fault why = { "" };

    m.R = R;
    assert_int_equal(law_check(law, &m, &why), STATUS_BAD_ARGUMENT);
    CHECK(strstr(why.text, reason) != NULL, "%s", why.text);
}

static void compositions_without_meaning_are_refused(void **state)
{
    struct law law = *law_preset_find("dieterich");

    (void) state;
    law.psi_ss = PSI_SS_MINUS_LOG;
    law.timescale = TIMESCALE_AGEING44;
    refuses(&law, 100, "ageing44");

    law = *law_preset_find("dieterich");
    law.psi_ss = PSI_SS_LAMBERT;
    refuses(&law, 100, "kato_tullis");
    law = *law_preset_find("dieterich");
    law.kinetics = KINETICS_COMPOSITE;
    refuses(&law, 100, "kato_tullis");
    law = *law_preset_find("kato_tullis");
    law.theta = THETA_PSI;
    refuses(&law, 100, "kato_tullis");
    law = *law_preset_find("kato_tullis");
    law.timescale = TIMESCALE_SPINODAL;
    refuses(&law, 100, "kato_tullis");
}

static void an_infinite_R_is_refused_where_no_limit_exists(void **state)
{
    struct law law = *law_preset_find("spinodal");

    (void) state;
    law.theta = THETA_LN_C_1PR_PSI;
    refuses(&law, HUGE_VAL, "R = inf");
    law = *law_preset_find("spinodal");
    law.psi_ss = PSI_SS_SPINODAL_UNIT;
    refuses(&law, HUGE_VAL, "R = inf");
    law = *law_preset_find("spinodal");
    law.timescale = TIMESCALE_AGEING44;
    refuses(&law, HUGE_VAL, "R = inf");
    law.timescale = TIMESCALE_SLIP45;
    refuses(&law, HUGE_VAL, "R = inf");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(presets_are_the_laws_of_the_paper),
        cmocka_unit_test(an_unknown_preset_is_not_found),
        cmocka_unit_test(components_have_the_names_of_scenes),
        cmocka_unit_test(a_material_is_reached_by_name),
        cmocka_unit_test(table_2_has_the_eps_and_eta_of_the_paper),
        cmocka_unit_test(a_law_uses_the_parameters_in_its_formulas),
        cmocka_unit_test(a_formula_reads_like_the_paper),
        cmocka_unit_test(every_preset_accepts_table_2),
        cmocka_unit_test(a_parameter_out_of_range_is_refused_by_name),
        cmocka_unit_test(limits_that_exist_are_accepted),
        cmocka_unit_test(parameters_a_law_ignores_are_not_checked),
        cmocka_unit_test(compositions_without_meaning_are_refused),
        cmocka_unit_test(an_infinite_R_is_refused_where_no_limit_exists),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
