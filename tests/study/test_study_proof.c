/* Proofs beside bars. */
#include "study_proof.h"

#include <math.h>
#include <string.h>

#include "check.h"
#include "slope.h"

static void run(struct slope *s, const char *law)
{
    static const char *const numbers[] = { "products=[equilibria, knees]",
                                           NULL };

    slope_make(s, law, NULL, "0.34", numbers);
}

static void each_bar_of_a_slope_meets_what_is_proved(void **state)
{
    static const char *const laws[] = { "dieterich_gen", "ruina", "perrin",
                                        "spinodal_gen" };
    static struct slope s;

    (void) state;
    for (size_t i = 0; i < sizeof laws / sizeof *laws; i++) {
        run(&s, laws[i]);
        assert_int_equal(study_prove(&s.study), STATUS_OK);
        assert_string_equal(s.study.proof.lie.text, "");
        const struct quantity *v = &s.study.saddle_numbers.v;
        assert_non_null(v->proved);
        assert_null(v->proved->not_proved);
        CHECK(v->proved->hi - v->proved->lo <= 1e-15 * v->value, "%s: %g",
              laws[i], v->proved->hi - v->proved->lo);
        slope_free(&s);
    }
}

/* By 1e-9 of itself, which no bar here allows. */
static void move(struct quantity *q)
{
    q->value *= 1 + 1e-9;
}

static void a_bar_beside_what_is_proved_is_told_by_name(void **state)
{
    static struct slope s;

    (void) state;
    run(&s, "perrin");
    move(&s.study.slider.critical.x_excess);
    assert_int_equal(study_prove(&s.study), STATUS_OK);
    CHECK(strstr(s.study.proof.lie.text, "x_excess"), "%s",
          s.study.proof.lie.text);
    slope_free(&s);
    run(&s, "perrin");
    move(&s.study.saddle_numbers.lambda_plus);
    assert_int_equal(study_prove(&s.study), STATUS_OK);
    CHECK(strstr(s.study.proof.lie.text, "lambda_plus"), "%s",
          s.study.proof.lie.text);
    slope_free(&s);
}

static void a_number_that_is_proved_to_be_none_is_told_too(void **state)
{
    static struct slope s;

    (void) state;
    run(&s, "ruina");
    s.study.slider.critical.v_plus = quantity_of(1e9, 1.0);
    assert_int_equal(study_prove(&s.study), STATUS_OK);
    CHECK(strstr(s.study.proof.lie.text, "v_plus"), "%s",
          s.study.proof.lie.text);
    slope_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_bar_of_a_slope_meets_what_is_proved),
        cmocka_unit_test(a_bar_beside_what_is_proved_is_told_by_name),
        cmocka_unit_test(a_number_that_is_proved_to_be_none_is_told_too),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
