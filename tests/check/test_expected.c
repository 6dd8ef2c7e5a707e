/* What a table may state; the rest is refused before anything is computed. */
#include "expected.h"

#include <math.h>

#include "checked.h"

static void refused(const char *text, const char *line)
{
    struct table t;
    struct expected s;
    struct fault why;

    assert_int_equal(table_parse(&t, text, strlen(text), "t.csv", &why),
                     STATUS_OK);
    assert_int_equal(expected_read(&s, &t, &why), STATUS_BAD_SCENE);
    assert_string_equal(why.text, line);
    assert_null(s.column);
    table_free(&t);
}

static void what_makes_no_sense_is_refused_in_one_line(void **state)
{
    (void) state;
    refused("law,alpha,v_pluss\ndieterich,0.3,1\n",
            "t.csv:1:11: unknown column 'v_pluss', did you mean v_plus? (see "
            "docs/check.md)");
    refused("law,alpha,v_plus,v_minus_tol\ndieterich,0.3,1,1\n",
            "t.csv:1:18: unknown column 'v_minus_tol' (see docs/check.md)");
    refused("law,alpha,upper_end,upper_end_tol\ndieterich,0.3,open,1\n",
            "t.csv:1:21: unknown column 'upper_end_tol', did you mean "
            "upper_end? (see docs/check.md)");
    refused("law,alpha,v_sp\ndieterich,0.3,1\n",
            "t.csv:1:11: unknown column 'v_sp' (see docs/check.md)");
    refused("law,alpha\ndieterich,0.3\n",
            "t.csv:1:1: no column states a number to check");
    refused("alpha,v_plus\n0.3,1\n",
            "t.csv:2:1: no law, expected one in a column law");
    refused("law,alpha,v_plus\ndietrich,0.3,1\n",
            "t.csv:2:1: law: no law 'dietrich' (see slipway laws)");
    refused("law,alpha,v_plus\nruina|x,0.3,1\n",
            "t.csv:2:1: law: no law 'x' (see slipway laws)");
    refused("law,v_plus\ndieterich,1\n",
            "t.csv:2:1: no alpha, expected an angle in rad");
    refused("law,alpha,v_plus\ndieterich,1.6,1\n",
            "t.csv:2:11: alpha: 1.6 is not allowed, expected an angle in rad, "
            "0 < alpha < pi/2");
    refused("law,alpha,a,v_plus\ndieterich,0.3,x,1\n",
            "t.csv:2:15: a: 'x' is no number, expected a decimal number");
    refused("law,alpha,a,v_plus\ndieterich,0.3,-1,1\n",
            "t.csv:2:1: law: a = -1 must be positive and finite");
    refused("law,alpha,v_plus\nkato_tullis,0.3,1\n",
            "t.csv:2:1: law: kato_tullis needs V_c");
    refused("law,form,alpha,v_plus\ndieterich,exp,0.3,1\n",
            "t.csv:2:11: form is 'exp', expected asinh or log");
    refused("theta,psi_ss,alpha,v_plus\nln_psi,inverse,0.3,1\n",
            "t.csv:2:1: timescale is missing, expected slip, spinodal, "
            "ageing44 or slip45");
    refused("law,alpha,v_plus\nruina,0.3,nan\n",
            "t.csv:2:11: v_plus: 'nan' makes no sense here, expected a decimal "
            "number or none");
    refused("law,alpha,lower_end\nruina,0.3,down\n",
            "t.csv:2:11: lower_end: 'down' makes no sense here, expected "
            "psi_inf, open, psi_0, v_0 or truncated");
    refused("law,alpha,v_plus,v_plus_tol\nruina,0.3,1,-1\n",
            "t.csv:2:13: v_plus_tol: '-1' is no tolerance, expected a number "
            ">= 0");
    refused("law,alpha,v_plus,tolerance\nruina,0.3,1,inf\n",
            "t.csv:2:13: tolerance: 'inf' is no tolerance, expected a number "
            ">= 0");
}

static void cells_say_nothing_none_a_number_or_a_word(void **state)
{
    static const char text[] = "law,alpha,v_plus,lower_end,x_deficit,"
                               "folds_mu_s\n"
                               "ruina,0.3,28.320e2,v_0,2,\n"
                               "ruina,0.3,-inf,none,1,5\n"
                               "ruina,0.3,2832,,,1e-3\n";
    struct table t;
    struct expected s;
    struct fault why;

    (void) state;
    assert_int_equal(table_parse(&t, text, strlen(text), "t.csv", &why),
                     STATUS_OK);
    assert_int_equal(expected_read(&s, &t, &why), STATUS_OK);
    assert_int_equal(s.columns, 4);
    struct expected_value v = expected_at(&s, 0, 0);
    assert_int_equal(v.kind, EXPECTED_NUMBER);
    assert_true(v.number == 2832.0);
    CHECK(fabs(v.printed - 0.05) < 1e-15, "%g", v.printed);
    assert_int_equal(expected_at(&s, 0, 1).code, 3);
    assert_true(expected_at(&s, 0, 2).number == 2.0);
    assert_int_equal(expected_at(&s, 0, 3).kind, EXPECTED_NOTHING);
    assert_int_equal(expected_at(&s, 1, 0).kind, EXPECTED_NONE);
    assert_int_equal(expected_at(&s, 1, 1).kind, EXPECTED_NONE);
    assert_true(expected_at(&s, 1, 3).printed == 0.5);
    assert_true(expected_at(&s, 2, 0).printed == 0.5);
    assert_int_equal(expected_at(&s, 2, 1).kind, EXPECTED_NOTHING);
    CHECK(fabs(expected_at(&s, 2, 3).printed - 5e-4) < 1e-18, "half of 1e-3");
    assert_string_equal(s.column[3].number->name, "folds_mu_s");
    expected_free(&s);
    expected_free(&s);
    table_free(&t);
}

/* Were its power to wrap around, any number would agree with it. */
static void a_power_beyond_all_bounds_is_no_tolerance_of_everything(
    void **state)
{
    static const char text[] = "law,alpha,v_plus\n"
                               "ruina,0.3,1.25e-99999999999999999999\n";
    struct table t;
    struct expected s;
    struct fault why;

    (void) state;
    assert_int_equal(table_parse(&t, text, strlen(text), "t.csv", &why),
                     STATUS_OK);
    assert_int_equal(expected_read(&s, &t, &why), STATUS_OK);
    assert_true(expected_at(&s, 0, 0).printed == 0.0);
    expected_free(&s);
    table_free(&t);
}

static void a_row_asks_for_no_more_than_it_states(void **state)
{
    static const char text[] = "law,alpha,v_plus,saddle_v,folds_v_M,"
                               "sensitivities_v_minus_c\n"
                               "spinodal,,,,1,\n"
                               "spinodal,0.3,,1,,\n"
                               "spinodal,0.3,1,,,\n"
                               "spinodal,0.3,,,,1\n";
    struct table t;
    struct expected s;
    struct fault why;

    (void) state;
    assert_int_equal(table_parse(&t, text, strlen(text), "t.csv", &why),
                     STATUS_OK);
    assert_int_equal(expected_read(&s, &t, &why), STATUS_OK);
    assert_int_equal(expected_products(&s, 0), 1u << PRODUCT_FOLDS);
    assert_int_equal(expected_products(&s, 1), 1u << PRODUCT_EQUILIBRIA);
    assert_int_equal(expected_products(&s, 2), 1u << PRODUCT_KNEES);
    assert_int_equal(expected_products(&s, 3), 1u << PRODUCT_SENSITIVITIES);
    expected_free(&s);
    table_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cells_say_nothing_none_a_number_or_a_word),
        cmocka_unit_test(
            a_power_beyond_all_bounds_is_no_tolerance_of_everything),
        cmocka_unit_test(a_row_asks_for_no_more_than_it_states),
        cmocka_unit_test(what_makes_no_sense_is_refused_in_one_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
