/* The catalogue of extreme cases, its judge and its oracle.  A value that is
 * planted wrong must be called a lie. */
#include "stress_run.h"

#include <malloc.h>
#include <math.h>
#include <omp.h>
#include <string.h>

#include "check.h"
#include "fault_alloc.h"
#include "laws.h"

/* ---- one slope, solved --------------------------------------------------- */

struct slope {
    struct scene scene;
    struct study study;
    struct stress_truth truth;
    struct stress_answer answer;
};

/* Skips where 113 bits are not what they should be. */
static void find(struct slope *s, const char *law, const char *alpha)
{
    char preset[64], slope[64], products[] = "products=[knees, sensitivities]";
    char *set[] = { preset, slope, products };
    struct fault why;

    if (laws_emulated())
        skip();
    snprintf(preset, sizeof preset, "law.preset=%s", law);
    snprintf(slope, sizeof slope, "slope.alpha=%s", alpha);
    assert_int_equal(scene_read(&s->scene, NULL, set, 3, &why), STATUS_OK);
    assert_int_equal(study_run(&s->study, &s->scene, NULL, &why), STATUS_OK);
    stress_truth_find(&s->scene.law, &s->scene.material, s->scene.tan_alpha,
                      &s->truth);
    s->answer = stress_answer_of(&s->study);
}

static void release(struct slope *s)
{
    study_free(&s->study);
    scene_free(&s->scene);
}

static struct stress_row judge(const struct slope *s)
{
    struct stress_row row = { .agree = -1 };

    stress_judge(&s->truth, &s->answer, &row);
    return row;
}

/* A number of the answer, to be planted wrong. */
static struct quantity *number_of(struct slope *s, enum stress_number which)
{
    return (struct quantity *) (uintptr_t) stress_answer_number(&s->answer,
                                                                which);
}

static void a_wrong_value_in_any_number_is_a_lie(void **state)
{
    static struct slope s;
    size_t planted = 0;

    (void) state;
    find(&s, "spinodal_gen", "0.34");
    CHECK(judge(&s).outcome != STRESS_LIE, "%s", judge(&s).reason);
    for (int i = 0; i < STRESS_NUMBERS; i++) {
        struct quantity *q = number_of(&s, (enum stress_number) i);
        const double right = q->value;
        if (!quantity_exists(q))
            continue;
        q->value += 3.0 * q->error;
        const struct stress_row v = judge(&s);
        CHECK(v.outcome == STRESS_LIE && v.bar > 1.0 &&
                  strcmp(v.worst, stress_number_name((enum stress_number) i)) ==
                      0,
              "%s: %s, bar %g", stress_number_name((enum stress_number) i),
              stress_outcome_names[v.outcome], v.bar);
        q->value = right;
        planted++;
    }
    assert_int_equal(planted, STRESS_NUMBERS - 1); /* psi_at_v0 is none */
    release(&s);
}

static void a_missing_invented_or_misplaced_knee_is_a_lie(void **state)
{
    static struct slope s;

    (void) state;
    find(&s, "spinodal_gen", "0.34");
    struct critical_numbers *c = &s.answer.critical;
    const struct critical_numbers right = *c;
    for (int side = 0; side < SIDES; side++) {
        const bool up = side == SIDE_UPPER;
        struct knee_number *knee = up ? c->knees_upper : c->knees_lower;
        size_t *count = up ? &c->knees_upper_count : &c->knees_lower_count;
        size_t *crossings = up ? &c->crossings_upper : &c->crossings_lower;
        assert_int_equal(*count, 1);
        *count = *crossings = 0;
        assert_int_equal(judge(&s).outcome, STRESS_LIE);
        *c = right;
        ++*crossings; /* falling */
        assert_int_equal(judge(&s).outcome, STRESS_LIE);
        *c = right;
        knee[1] = knee[0];
        ++*count; /* a falling one as a knee */
        assert_int_equal(judge(&s).outcome, STRESS_LIE);
        *c = right;
        knee[0].psi.value += 3.0 * knee[0].psi.error;
        assert_int_equal(judge(&s).outcome, STRESS_LIE);
        *c = right;
        knee[0].v = quantity_none("undecided");
        assert_int_equal(judge(&s).outcome, STRESS_DEGRADED);
        *c = right;
        assert_int_not_equal(judge(&s).outcome, STRESS_LIE);
    }
    release(&s);
}

static void a_value_that_is_no_number_is_a_lie(void **state)
{
    static struct slope s;

    (void) state;
    find(&s, "dieterich_gen", "0.34");
    s.answer.critical.v_plus.value = (double) NAN;
    assert_int_equal(judge(&s).outcome, STRESS_LIE);
    release(&s);
}

static void a_wrong_end_or_existence_is_a_lie(void **state)
{
    static struct slope s;

    (void) state;
    find(&s, "dieterich_gen", "0.34");
    s.answer.critical.lower_end = END_V_0;
    assert_int_equal(judge(&s).outcome, STRESS_LIE);
    s.answer = stress_answer_of(&s.study);
    s.answer.has_saddle = false;
    assert_int_equal(judge(&s).outcome, STRESS_LIE);
    s.answer.has_saddle = true;
    s.truth.saddle = false;
    assert_int_equal(judge(&s).outcome, STRESS_LIE);
    s.answer.has_saddle = false;
    assert_int_equal(judge(&s).outcome, STRESS_NONE);
    release(&s);
}

static void a_doubt_or_lost_digits_degrade(void **state)
{
    static struct slope s;

    (void) state;
    find(&s, "dieterich_gen", "0.34");
    struct quantity *q = &s.answer.critical.x_excess;
    q->value *= 1.0 + 1e-9;
    q->error = 1e-8 * q->value;
    const struct stress_row v = judge(&s);
    CHECK(v.outcome == STRESS_DEGRADED && v.missing > 4.0 && v.digits < 9.1 &&
              strcmp(v.worst, "x_excess") == 0,
          "%s, lacks %g of %s", stress_outcome_names[v.outcome], v.missing,
          v.worst);
    s.answer = stress_answer_of(&s.study);
    s.truth.number[STRESS_V_MINUS].error = s.truth.number[STRESS_V_MINUS].value;
    assert_int_equal(judge(&s).outcome, STRESS_DEGRADED);
    release(&s);
}

/* ---- the oracle ---------------------------------------------------------- */

static void the_oracle_knows_the_side_of_a_state(void **state)
{
    static struct slope s;

    (void) state;
    find(&s, "dieterich_gen", "0.34");
    const struct stress_truth *t = &s.truth;
    const quad v_plus = t->number[STRESS_LN_V_PLUS].value;
    const quad v_minus = t->number[STRESS_LN_V_MINUS].value;
    const quad small = 1e-9;

    assert_int_equal(stress_truth_side(t, v_plus + small, 200), STRESS_SLIDES);
    assert_int_equal(stress_truth_side(t, v_plus - small, 200), STRESS_STOPS);
    assert_int_equal(stress_truth_side(t, v_minus + small, -200),
                     STRESS_SLIDES);
    assert_int_equal(stress_truth_side(t, v_minus - small, -200), STRESS_STOPS);
    assert_int_equal(stress_truth_side(t, -400, 300), STRESS_STOPS);
    assert_int_equal(stress_truth_side(t, 400, -300), STRESS_SLIDES);
    assert_int_equal(stress_truth_side(t, t->at.x0 + 1, t->at.y0 + 1),
                     STRESS_STOPS);
    const quad *here = t->upper.path[1], *next = t->upper.path[2];
    assert_int_equal(stress_truth_side(t, t->at.x0 + (here[0] + next[0]) / 2,
                                       t->at.y0 + (here[1] + next[1]) / 2),
                     STRESS_UNTOLD);
    assert_int_equal(
        stress_truth_fates(t, &s.scene.law, &s.scene.material, STRESS_STOPS),
        1u << FATE_REST_FINITE);
    assert_int_equal(
        stress_truth_fates(t, &s.scene.law, &s.scene.material, STRESS_SLIDES),
        1u << FATE_RUNAWAY);
    release(&s);
}

/* ---- the catalogue ------------------------------------------------------- */

static void the_catalogue_is_long_and_its_names_are_its_own(void **state)
{
    struct stress_list list, some;
    struct fault why;

    (void) state;
    assert_int_equal(stress_list_init(&list, NULL, false, &why), STATUS_OK);
    CHECK(list.count >= 300, "%zu cases", list.count);
    for (size_t i = 0; i < list.count; i++)
        for (size_t k = 0; k < i; k++)
            CHECK(strcmp(list.at[i].name, list.at[k].name) != 0, "%s twice",
                  list.at[i].name);
    assert_int_equal(stress_list_init(&some, "eps2/*/log", false, &why),
                     STATUS_OK);
    assert_int_equal(some.count, 2 * 7 * 3);
    stress_list_free(&some);
    stress_list_free(&some);
    stress_list_free(&list);
}

/* The cases whose names hold the pattern, run. */
static struct stress run(struct stress_list *list, const char *pattern)
{
    struct stress s;
    struct fault why;

    if (laws_emulated())
        skip();
    assert_int_equal(stress_list_init(list, pattern, false, &why), STATUS_OK);
    CHECK(list->count > 0, "%s", pattern);
    assert_int_equal(stress_run(&s, list, NULL), STATUS_OK);
    return s;
}

static void extreme_cases_come_to_what_they_must(void **state)
{
    static const struct {
        const char *pattern;
        enum stress_outcome outcome;
    } expected[] = {
        { "eps2/dieterich_gen/asinh/1e-09/0.34", STRESS_EXACT },
        { "b/a-1/dieterich_gen/log/1e-06/2", STRESS_EXACT },
        { "b/a-1/spinodal_gen/asinh/1000/-2", STRESS_EXACT },
        /* psi = -ln v is a small difference there */
        { "edge/ln_c_psi.minus_log.slip.sinh/asinh/-1e-06", STRESS_EXACT },
        { "far/dieterich_gen/asinh/0.001/-100", STRESS_EXACT },
        { "fold-max/spinodal_gen/log/1e-12", STRESS_NONE },
        { "fold-max/spinodal_gen/log/-1e-12", STRESS_EXACT },
        { "R/spinodal_gen/log/0.001", STRESS_NONE },
        /* eigenvalues 1e266 apart: numbers, and no bound for some */
        { "far/dieterich_gen/asinh/0.001/-300", STRESS_DEGRADED },
        /* a fast start is no rest */
        { "start/spinodal_gen/asinh/1,1e+06", STRESS_EXACT },
        { "start/spinodal_phi_gen/asinh/1e-200,1e+06", STRESS_EXACT },
        /* a corner of the plane */
        { "start/dieterich/asinh/1e-300,1e+300", STRESS_EXACT },
    };

    (void) state;
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        struct stress_list list;
        struct stress s = run(&list, expected[i].pattern);
        const struct stress_row *row = &s.row[0];
        assert_int_equal(s.count, 1);
        CHECK(row->outcome == (int8_t) expected[i].outcome, "%s: %s, %s",
              row->name, stress_outcome_names[row->outcome], row->reason);
        stress_free(&s);
        stress_free(&s);
        stress_list_free(&list);
    }
}

/* Unset memory is filled, so that whoever reads it is found out. */
static void bands_as_thin_as_rounding_have_no_area(void **state)
{
    struct stress_list list;

    (void) state;
    mallopt(M_PERTURB, 0xa5);
    struct stress s = run(&list, "window/kato_tullis/asinh/0.38");
    mallopt(M_PERTURB, 0);
    CHECK(s.row[0].outcome == STRESS_EXACT, "%s",
          stress_outcome_names[s.row[0].outcome]);
    stress_free(&s);
    stress_list_free(&list);
}

static void threads_change_nothing_but_seconds(void **state)
{
    static const char pattern[] = "eps2/spinodal_gen/asinh/1000000";
    struct stress_list list[2];
    struct stress s[2];

    (void) state;
    omp_set_num_threads(1);
    s[0] = run(&list[0], pattern);
    omp_set_num_threads(3);
    s[1] = run(&list[1], pattern);
    assert_int_equal(s[0].count, 6);
    for (size_t i = 0; i < s[0].count; i++) {
        const struct stress_row *a = &s[0].row[i], *b = &s[1].row[i];
        assert_string_equal(a->name, b->name);
        CHECK(a->outcome == b->outcome && a->digits == b->digits &&
                  a->allowed == b->allowed && a->bar == b->bar &&
                  a->steps == b->steps && a->agree == b->agree &&
                  a->oracle_evaluations == b->oracle_evaluations,
              "%s", a->name);
    }
    for (int i = 0; i < 2; i++) {
        stress_free(&s[i]);
        stress_list_free(&list[i]);
    }
}

static int stop_at_once(void *ctx, const char *stage, uint64_t done,
                        uint64_t total)
{
    (void) ctx, (void) stage;
    return done > 0 && total > 0;
}

static void a_monitor_can_stop_it(void **state)
{
    const struct monitor monitor = { stop_at_once, NULL };
    struct stress_list list;
    struct stress s;
    struct fault why;

    (void) state;
    assert_int_equal(stress_list_init(&list, "steep/ruina", false, &why),
                     STATUS_OK);
    assert_int_equal(stress_run(&s, &list, &monitor), STATUS_STOPPED);
    assert_null(s.row);
    stress_list_free(&list);
}

static enum status list_and_run(const char *pattern)
{
    struct stress_list list;
    struct stress s = { .row = NULL };
    struct fault why;
    enum status status = stress_list_init(&list, pattern, false, &why);

    if (status == STATUS_OK)
        status = stress_run(&s, &list, NULL);
    CHECK(status != STATUS_OK || s.outcome[STRESS_LIE] == 0, "%s", pattern);
    stress_free(&s);
    stress_list_free(&list);
    return status;
}

static void it_bears_any_lack_of_memory(void **state)
{
    static const char *const pattern[] = { "R/spinodal_gen/log/0.001",
                                           "start/spinodal/asinh/1e+06,1e-06",
                                           "field/dieterich/asinh/0,1e-06" };

    (void) state;
    if (laws_emulated())
        skip();
    omp_set_num_threads(1);
    for (int i = 0; i < 3; i++) {
        enum status status = STATUS_NO_MEMORY;
        for (long k = 0; status != STATUS_OK; k += k < 20 ? 1 : 61) {
            fault_alloc_at(k);
            status = list_and_run(pattern[i]);
            fault_alloc_at(FAULT_ALLOC_NEVER);
            CHECK(status == STATUS_OK || status == STATUS_NO_MEMORY, "%ld: %s",
                  k, status_text(status));
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        /* first: what others freed would not be filled */
        cmocka_unit_test(bands_as_thin_as_rounding_have_no_area),
        cmocka_unit_test(a_wrong_value_in_any_number_is_a_lie),
        cmocka_unit_test(a_missing_invented_or_misplaced_knee_is_a_lie),
        cmocka_unit_test(a_value_that_is_no_number_is_a_lie),
        cmocka_unit_test(a_wrong_end_or_existence_is_a_lie),
        cmocka_unit_test(a_doubt_or_lost_digits_degrade),
        cmocka_unit_test(the_oracle_knows_the_side_of_a_state),
        cmocka_unit_test(the_catalogue_is_long_and_its_names_are_its_own),
        cmocka_unit_test(extreme_cases_come_to_what_they_must),
        cmocka_unit_test(threads_change_nothing_but_seconds),
        cmocka_unit_test(a_monitor_can_stop_it),
        cmocka_unit_test(it_bears_any_lack_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
