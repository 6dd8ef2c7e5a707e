/* Tables hold until one of their numbers is changed. */
#include "regression.h"

#include <math.h>
#include <omp.h>
#include <string.h>

#include "check.h"
#include "checked.h"
#include "fault_alloc.h"
#include "old_names.h"
#include "tolerance.h"

/* ---- the reference tables ------------------------------------------------ */

static const char *const reference[] = { "manifold.csv", "extreme.csv",
                                         "equilibria.csv", "folds.csv" };
static const size_t reference_values[] = { 1582, 1400, 1116, 420 };

static void untouched_reference_tables_hold(void **state)
{
    static const double rtol[] = { 1e-12, CHECK_RTOL };

    (void) state;
    for (int i = 0; i < 4; i++) {
        struct old_table t;
        size_t compared = 0;
        old_open(&t, reference[i]);
        while (old_next(&t))
            for (int k = 0; k < 2; k++) {
                char text[3 * CSV_LINE];
                struct checked c;
                old_write(&t, CSV_COLUMNS, "", text, sizeof text);
                check_at(&c, text, rtol[k]);
                CHECK(c.r.moved == 0, "%s row %zu: %s moved by %.3g (%.3g)",
                      reference[i], t.csv.row, c.r.row[0].finding->column,
                      c.r.row[0].finding->difference,
                      c.r.row[0].finding->tolerance);
                compared += c.r.compared;
                checked_free(&c);
            }
        CHECK(compared == 2 * reference_values[i], "%s: %zu values",
              reference[i], compared / 2);
    }
}

/* What a row of the reference tables is good to, relative: the promise plus
 * what the digits lost to the rounding of alpha cost.  0: no number. */
static double row_tolerance(const struct csv *c, size_t column)
{
    static const char *const upper[] = { "v_plus",      "x_excess", "mu_s_num",
                                         "mu_s_mean",   "G_num",    "knee_up_v",
                                         "knee_up_psi", NULL };
    static const char *const coarse[] = {
        "x_excess",    "x_deficit_lower", "mu_s_num",     "mu_s_mean",
        "G_num",       "knee_up_v",       "knee_up_psi",  "knee_lo_v",
        "knee_lo_psi", "lambda_plus",     "lambda_minus", NULL
    };
    const char *name = c->name[column];
    const double up = csv_number(c, "digits_lost_alpha_vplus", 0.0);
    const double low = csv_number(c, "digits_lost_alpha_lower", 0.0);
    double lost = fmax(fmax(up, low), 0.0), promise = 1e-12;

    for (int i = 0; upper[i]; i++)
        lost = strcmp(name, upper[i]) == 0 ? fmax(up, 0.0) : lost;
    for (int i = 0; coarse[i]; i++)
        promise = strcmp(name, coarse[i]) == 0 ? 1e-11 : promise;
    if (strncmp(name, "dln", 3) == 0)
        return 1e-9 + pow(10.0, lost - 12.0);
    return promise + pow(10.0, lost - 15.0);
}

static bool is_number(const struct result_numbers *all,
                      const struct old_table *t, size_t column)
{
    const double value = csv_number(&t->csv, t->csv.name[column], NAN);
    const char *text = t->csv.cell[column];
    char name[48];

    /* 0.91 in the tables is all that is known of that row's mu_s_mean */
    old_name(t, column, name);
    return result_numbers_find(all, name) && isfinite(value) &&
           strlen(text) > 8;
}

/* For each law of the row it is this column that moved, and nothing else. */
static void only_of_row(const struct checked *now, const struct old_table *t,
                        size_t column)
{
    const size_t laws = strchr(csv_text(&t->csv, "law"), '|') ? 2 : 1;
    char name[48];

    old_name(t, column, name);
    CHECK(now->r.moved == laws, "row %zu %s: %s planted, %zu moved", t->csv.row,
          csv_text(&t->csv, "law"), name, now->r.moved);
    for (size_t i = 0; i < laws; i++)
        assert_string_equal(now->r.row[0].finding[i].column, name);
}

/* In every so manieth row. */
static size_t plant_in_rows(const char *name, size_t stride)
{
    struct result_numbers all;
    struct old_table t;
    size_t planted = 0;

    old_open(&t, name);
    assert_int_equal(study_numbers(&all, EXPECTED_STAGES), STATUS_OK);
    while (old_next(&t)) {
        if (t.csv.row % stride != 0)
            continue;
        for (size_t i = 0; i < t.csv.columns; i++) {
            char text[3 * CSV_LINE], cell[64];
            struct checked now;
            if (!is_number(&all, &t, i))
                continue;
            const long double by = (planted % 2 ? 10.0L : -10.0L) *
                                   (long double) row_tolerance(&t.csv, i);
            snprintf(cell, sizeof cell, "%.21Lg",
                     strtold(t.csv.cell[i], NULL) * (1.0L + by));
            old_write(&t, i, cell, text, sizeof text);
            check_text(&now, text);
            only_of_row(&now, &t, i);
            checked_free(&now);
            planted++;
        }
    }
    result_numbers_free(&all);
    return planted;
}

static void ten_tolerances_planted_in_any_quantity_are_found(void **state)
{
    (void) state;
    const size_t n =
        plant_in_rows("manifold.csv", 9) + plant_in_rows("extreme.csv", 8) +
        plant_in_rows("equilibria.csv", 15) + plant_in_rows("folds.csv", 4);
    print_message("# %zu planted\n", n);
    CHECK(n > 400, "only %zu planted", n);
}

static void words_and_counts_are_compared(void **state)
{
    (void) state;
    holds("law,alpha,upper_end,lower_end,saddle_v,equilibria_0_type,"
          "equilibria_1_type\n"
          "dieterich_gen,0.34,psi_inf,psi_0,2.9749,saddle,none\n"
          "spinodal_gen,0.41,none,none,none,stable_node,none\n");
    moves("law,alpha,upper_end\ndieterich_gen,0.34,open\n", "upper_end");
    moves("law,alpha,lower_end\ndieterich_gen,0.34,v_0\n", "lower_end");
    moves("law,alpha,saddle_v\ndieterich_gen,0.34,none\n", "saddle_v");
    moves("law,alpha,equilibria_0_type\ndieterich_gen,0.34,stable_node\n",
          "equilibria_0_type");
    moves("law,alpha,equilibria_0_type\ndieterich_gen,0.34,none\n",
          "equilibria_0_type");
    moves("law,alpha,v_plus\ndieterich_gen,0.34,none\n", "v_plus");
    moves("law,alpha,v_minus\ndieterich,0.30,1\n", "v_minus");
    holds("law,alpha,v_minus,v_plus\ndieterich,0.30,none,inf\n");
    holds("law,alpha,v_minus,upper_end\ndieterich,0.30,,open\n");
}

/* ---- tolerances ---------------------------------------------------------- */

static void a_row_may_bring_its_own_tolerances(void **state)
{
    struct checked c;

    (void) state; /* v_plus is 2832.2233588..., v_minus 0.0428... */
    holds("law,alpha,v_plus,v_plus_tol\ndieterich_gen,0.34,2832,0.23\n");
    moves("law,alpha,v_plus,v_plus_tol\ndieterich_gen,0.34,2832,0.22\n",
          "v_plus");
    holds("law,alpha,v_plus,tolerance\ndieterich_gen,0.34,2830,8e-4\n");
    moves("law,alpha,v_plus,tolerance\ndieterich_gen,0.34,2830,7e-4\n",
          "v_plus");
    moves("law,alpha,v_plus,v_plus_tol,tolerance\n"
          "dieterich_gen,0.34,2830,0.1,1\n",
          "v_plus"); /* its own counts */
    holds("law,alpha,v_plus,v_plus_tol,tolerance\n"
          "dieterich_gen,0.34,2830,,1\n");
    holds("law,alpha,v_plus\ndieterich_gen,0.34,2832.2\n"); /* as printed */
    moves("law,alpha,v_plus\ndieterich_gen,0.34,2832.3\n", "v_plus");
    moves("law,alpha,v_plus\ndieterich_gen,0.34,2832.20\n", "v_plus");
    holds("law,alpha,v_plus,digits_lost\ndieterich_gen,0.34,2832.20,10\n");
    check_text(&c, "law,alpha,v_plus,v_plus_tol\n"
                   "dieterich_gen,0.34,2831,0.5\n");
    const struct finding *f = only(&c, "v_plus");
    assert_true(f->tolerance == 0.5);
    assert_true(fabs(f->difference - 1.2233588539) < 1e-9);
    assert_true(fabs(f->now - 2832.2233588539) < 1e-9);
    assert_int_equal(f->stored->line, 2);
    assert_string_equal(f->law, "dieterich_gen");
    checked_free(&c);
}

static void both_laws_of_a_row_are_checked(void **state)
{
    struct checked c;

    (void) state;
    check_text(&c, "law,alpha,upper_end\n"
                   "spinodal_gen|spinodal,0.34,psi_inf\n");
    assert_string_equal(only(&c, "upper_end")->law, "spinodal");
    assert_string_equal(only(&c, "upper_end")->word, "open");
    assert_int_equal(c.r.compared, 2);
    checked_free(&c);
}

static void inputs_of_any_spelling_give_the_same_slope(void **state)
{
    (void) state;
    holds("law,form,eps2,alpha,v_plus\n"
          "dieterich_gen,log,1.1326311020500623e-7,0.34,2832.2233562376912\n");
    holds("theta,psi_ss,timescale,kinetics,alpha,v_plus\n"
          "ln_psi,inverse,slip,sinh,0.34,2832.2233588539274\n");
    moves("law,eps2,alpha,v_plus\n"
          "dieterich_gen,1.13e-7,0.34,2832.2233588539274\n",
          "v_plus");
    holds("law,eps2,g,L,V_star,alpha,fracture_energy,x_deficit,"
          "folds_mu_s,folds_c_cusp\n"
          "spinodal_gen,1.1326311020500623e-7,9.81,0.9e-6,1e-6,0.34,,,"
          "0.40467912,2.8999009732745033\n");
}

static void steady_states_go_by_number(void **state)
{
    (void) state;
    holds("law,alpha,equilibria_0_type,equilibria_0_v,equilibria_2_type\n"
          "spinodal_gen,0.34,stable_node,0.0011727,stable_node\n");
    moves("law,alpha,equilibria_1_type\nspinodal_gen,0.34,stable_node\n",
          "equilibria_1_type");
    moves("law,alpha,equilibria_3_v\nspinodal_gen,0.34,1\n", "equilibria_3_v");
}

/* ---- running ------------------------------------------------------------- */

static const char three[] = "law,alpha,v_plus,sensitivities_v_plus_alpha,"
                            "saddle_v\ndieterich_gen,0.34,1,1,1\n"
                            "spinodal_gen,0.35,2,,\nruina,0.3,3,,1\n";

static void threads_do_not_change_the_result(void **state)
{
    struct checked one, two;

    (void) state;
    omp_set_num_threads(1);
    check_text(&one, three);
    omp_set_num_threads(3);
    check_text(&two, three);
    omp_set_num_threads(1);
    assert_int_equal(one.r.moved, 6);
    assert_int_equal(two.r.moved, 6);
    for (size_t i = 0; i < 3; i++)
        for (size_t k = 0; k < one.r.row[i].findings; k++) {
            const struct finding *a = &one.r.row[i].finding[k];
            const struct finding *b = &two.r.row[i].finding[k];
            assert_string_equal(a->column, b->column);
            assert_memory_equal(&a->now, &b->now, sizeof a->now);
            assert_memory_equal(&a->tolerance, &b->tolerance,
                                sizeof a->tolerance);
        }
    checked_free(&one);
    checked_free(&two);
}

static int stop_at_second(void *ctx, const char *stage, uint64_t done,
                          uint64_t total)
{
    uint64_t *last = ctx;

    (void) stage;
    CHECK(total == 3 && done == *last + 1, "%d of %d", (int) done, (int) total);
    *last = done;
    return done == 2;
}

static void the_monitor_counts_rows_and_stops(void **state)
{
    uint64_t last = 0;
    const struct monitor monitor = { stop_at_second, &last };
    struct table t;
    struct regression r;
    struct fault why;

    (void) state;
    omp_set_num_threads(1);
    assert_int_equal(table_parse(&t, three, strlen(three), "t.csv", &why),
                     STATUS_OK);
    assert_int_equal(regression_run(&r, &t, CHECK_RTOL, &monitor, &why),
                     STATUS_STOPPED);
    assert_int_equal(last, 2);
    assert_null(r.row);
    table_free(&t);
}

static void a_row_that_cannot_be_computed_is_data(void **state)
{
    static const char text[] = "law,alpha,saddle_v,v_plus\n"
                               "dieterich,0.3,70.93,\n"
                               "dieterich_gen,0.001,,none\n"
                               "spinodal,0.3,1,\n";
    struct table t;
    struct regression r;
    struct fault why;

    (void) state;
    assert_int_equal(table_parse(&t, text, strlen(text), "t.csv", &why),
                     STATUS_OK);
    /* more than a series can */
    assert_int_equal(regression_run(&r, &t, 1e-300, NULL, &why), STATUS_OK);
    assert_int_equal(r.failed, 1);
    assert_int_equal(r.moved, 1);
    assert_null(r.row[0].reason);
    assert_int_equal(r.row[1].status, STATUS_NO_CONVERGENCE);
    CHECK(r.row[1].reason && strstr(r.row[1].reason, "the stable manifold"),
          "%s", r.row[1].reason);
    regression_free(&r);
    table_free(&t);
}

static void every_allocation_of_a_check_may_fail(void **state)
{
    struct table t;
    struct fault why;
    enum status s = STATUS_NO_MEMORY;
    size_t failed = 0;

    (void) state;
    omp_set_num_threads(1);
    assert_int_equal(table_parse(&t, three, strlen(three), "t.csv", &why),
                     STATUS_OK);
    for (long k = 0; s != STATUS_OK; k += k < 60 ? 1 : 17) {
        struct regression r;
        fault_alloc_at(k);
        s = regression_run(&r, &t, 1e-6, NULL, &why);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        CHECK(s == STATUS_OK || s == STATUS_NO_MEMORY, "%ld: %.400s", k,
              why.text);
        CHECK(s == STATUS_OK || strcmp(why.text, "out of memory") == 0, "%s",
              why.text);
        CHECK(s != STATUS_OK || (r.moved == 6 && r.failed == 0),
              "%ld: %zu moved", k, r.moved);
        failed += s != STATUS_OK;
        regression_free(&r);
    }
    CHECK(failed > 20, "only %zu failed", failed);
    table_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(untouched_reference_tables_hold),
        cmocka_unit_test(ten_tolerances_planted_in_any_quantity_are_found),
        cmocka_unit_test(words_and_counts_are_compared),
        cmocka_unit_test(a_row_may_bring_its_own_tolerances),
        cmocka_unit_test(both_laws_of_a_row_are_checked),
        cmocka_unit_test(inputs_of_any_spelling_give_the_same_slope),
        cmocka_unit_test(steady_states_go_by_number),
        cmocka_unit_test(threads_do_not_change_the_result),
        cmocka_unit_test(the_monitor_counts_rows_and_stops),
        cmocka_unit_test(a_row_that_cannot_be_computed_is_data),
        cmocka_unit_test(every_allocation_of_a_check_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
