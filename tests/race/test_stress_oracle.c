/* What the 113-bit oracle says of slopes, and that one is asked of it once. */
#include "stress_oracle.h"

#include "check.h"
#include "laws.h"
#include "reference_rows.h"
#include "rest_form.h"
#include "stress_case.h"

static struct stress_oracle oracle;

static void open_scene(struct scene *scene, const char *law, const char *alpha)
{
    char preset[64], slope[64];
    char *set[] = { preset, slope };
    struct fault why;

    snprintf(preset, sizeof preset, "law.preset=%s", law);
    snprintf(slope, sizeof slope, "slope.alpha=%s", alpha);
    assert_int_equal(scene_read(scene, NULL, set, 2, &why), STATUS_OK);
}

/* What the oracle said last is spoiled, to see whether it is asked again. */
static bool is_asked_again(struct scene *scene)
{
    const size_t spoiled = 7;
    struct stress_row row = { .name = NULL };

    oracle.truth.evaluations = spoiled;
    const struct stress_truth *t = stress_oracle_ask(&oracle, scene, &row);
    assert_int_equal(row.oracle_evaluations, t->evaluations);
    assert_true(row.oracle_seconds >= 0.0);
    return t->evaluations != spoiled;
}

static void one_slope_is_asked_once(void **state)
{
    struct scene scene;

    (void) state;
    open_scene(&scene, "perrin", "0.34");
    oracle = (struct stress_oracle){ .asked = false };
    assert_true(is_asked_again(&scene));
    assert_false(is_asked_again(&scene));
    scene.rtol /= 2.0; /* which truth does not depend on */
    assert_false(is_asked_again(&scene));
    scene_free(&scene);
}

static void another_slope_law_form_or_value_is_asked_anew(void **state)
{
    struct scene scene;

    (void) state;
    open_scene(&scene, "perrin", "0.34");
    oracle = (struct stress_oracle){ .asked = false };
    assert_true(is_asked_again(&scene));
    scene.tan_alpha += 0.01L;
    assert_true(is_asked_again(&scene));
    scene.material.a *= 0.99;
    assert_true(is_asked_again(&scene));
    scene.law.form =
        scene.law.form == FRICTION_LOG ? FRICTION_ASINH : FRICTION_LOG;
    assert_true(is_asked_again(&scene));
    scene.law.theta = THETA_LN_C_PSI;
    assert_true(is_asked_again(&scene));
    scene_free(&scene);
}

/* Both by theory, but not by the same table. */
static void the_oracle_and_the_law_agree_on_rests(void **state)
{
    static const struct stress_truth saddle_alone = { .saddle = true };
    const struct material m = material_bristol_board();
    struct fault why;

    (void) state;
    for (size_t i = 0; i < LAWS; i++) {
        const struct law law = laws_at(i);
        if (law_check(&law, &m, &why) != STATUS_OK)
            continue;
        const enum fate fate = rest_form_of(&law, &m).fate;
        CHECK(stress_truth_fates(&saddle_alone, &law, &m, STRESS_STOPS) ==
                  1u << fate,
              "law %zu: %s", i, fate_names[fate]);
    }
}

/* Where the slope of the lower branch vanishes within its last steps, two
 * tolerances once were 1e9 of their errors apart. */
static void the_oracle_sees_a_slope_vanish_within_a_step(void **state)
{
    const struct law law = { .theta = THETA_LN_C_1PR_PSI,
                             .psi_ss = PSI_SS_SPINODAL_UNIT,
                             .timescale = TIMESCALE_AGEING44,
                             .kinetics = KINETICS_SINH };
    static struct quad_branch coarse, fine;
    static struct stress_truth t;
    struct material m = material_bristol_board();

    (void) state;
    m.a = 0.0010751969461387607;
    m.b = 0.78795855415868077;
    m.V_star = 0.00017760922346875596;
    m.g = 6.5926412565087274e-08;
    stress_truth_find(&law, &m, tanl(1.3137799586495715L), &t);
    assert_true(t.saddle);
    assert_true(quad_branch_grow(&law, &t.at, -1, 1e-18, &coarse));
    assert_true(quad_branch_grow(&law, &t.at, -1, 1e-22, &fine));
    const double off = (double) fabsq(coarse.x - fine.x);
    CHECK(off < 1e-16, "%g", off);
}

/* The row's value of a column, and how far a decimal of few digits is off. */
static void hold_to_table(const struct csv *c, const char *column,
                          const struct stress_true *t, double loss,
                          size_t *held)
{
    const double want = csv_number(c, column, (double) NAN);

    CHECK(t->exists == !isnan(want), "row %zu: %s", c->row, column);
    if (isnan(want))
        return;
    const double off = fabs((double) t->value - want);
    CHECK(off <= (1e-14 + loss) * fabs(want), "row %zu: %s is %.17g, not %.17g",
          c->row, column, (double) t->value, want);
    ++*held;
}

static void hold_row(const struct csv *c, size_t *held)
{
    const struct law law = row_law(c);
    const struct material m = row_material(c);
    const long double alpha = (long double) csv_number(c, "alpha", 0);
    /* the table's inputs are decimals, ours their nearest doubles */
    const double upper =
        pow(10.0, csv_number(c, "digits_lost_alpha_vplus", 0) - 14.0);
    const double lower =
        pow(10.0, csv_number(c, "digits_lost_alpha_lower", 0) - 14.0);
    struct stress_truth t;

    stress_truth_find(&law, &m, tanl(alpha), &t);
    CHECK(t.saddle == (csv_number(c, "has_saddle", 1) > 0), "row %zu", c->row);
    if (!t.saddle)
        return;
    hold_to_table(c, "v_sp", &t.number[STRESS_V_SP], upper, held);
    hold_to_table(c, "lambda_minus", &t.number[STRESS_LAMBDA_MINUS],
                  fmax(upper, lower), held);
    hold_to_table(c, "lambda_plus", &t.number[STRESS_LAMBDA_PLUS],
                  fmax(upper, lower), held);
    hold_to_table(c, "v_plus", &t.number[STRESS_V_PLUS], upper, held);
    hold_to_table(c, "v_minus", &t.number[STRESS_V_MINUS], lower, held);
    hold_to_table(c, "psi_at_v0", &t.number[STRESS_PSI_AT_V0], lower, held);
    hold_to_table(c, "x_excess", &t.number[STRESS_X_EXCESS], 10 * upper, held);
    hold_to_table(c, "x_deficit_lower", &t.number[STRESS_X_DEFICIT], 10 * lower,
                  held);
}

/* Whether the catalogue has the row's slope. */
static bool is_in(const struct stress_list *list, const struct csv *c)
{
    const struct law law = row_law(c);
    struct material m = row_material(c);
    const double alpha = csv_number(c, "alpha", 0);

    for (size_t i = 0; i < list->count; i++) {
        const struct scene *s = &list->at[i].scene;
        struct material other = s->material;
        bool same = strcmp(s->law.preset, law.preset) == 0 &&
                    s->law.form == law.form && s->starts == 0 &&
                    fabs(s->alpha - alpha) < 1e-12;
        for (int key = 0; key < MATERIAL_KEYS && same; key++) {
            const enum material_key which = (enum material_key) key;
            const double a = *material_member(&m, which);
            const double b = *material_member(&other, which);
            same = !law_uses(&law, which) || fabs(a - b) <= 1e-12 * fabs(a) ||
                   a == b;
        }
        if (same)
            return true;
    }
    return false;
}

static void cases_of_the_reference_table_are_as_it_says(void **state)
{
    struct stress_list list;
    struct fault why;
    struct csv c;
    size_t rows = 0, held = 0;

    (void) state;
    if (laws_emulated())
        skip();
    assert_int_equal(stress_list_init(&list, NULL, false, &why), STATUS_OK);
    csv_open(&c, "extreme.csv");
    while (csv_next(&c))
        if (is_in(&list, &c) && rows++ % 2 == 0)
            hold_row(&c, &held);
    CHECK(rows >= 25 && held >= 70, "%zu rows, %zu numbers", rows, held);
    stress_list_free(&list);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_slope_is_asked_once),
        cmocka_unit_test(another_slope_law_form_or_value_is_asked_anew),
        cmocka_unit_test(the_oracle_and_the_law_agree_on_rests),
        cmocka_unit_test(the_oracle_sees_a_slope_vanish_within_a_step),
        cmocka_unit_test(cases_of_the_reference_table_are_as_it_says),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
