/* Sentences as codes and as words of CF. */
#include "sweep_reason.h"

#include <ctype.h>
#include <string.h>

#include "check.h"
#include "fault_alloc.h"

static void sentences_become_words(void **state)
{
    static const char *const say[][2] = {
        { "there is no saddle at this slope",
          "there_is_no_saddle_at_this_slope" },
        { "ends at v_minus > 0 and never meets v = 0",
          "ends_at_v_minus_above_0_and_never_meets_v_equals_0" },
        { "open: v has no limit, b < a", "open_v_has_no_limit_b_below_a" },
        { "leaves [1e-300, 1e300].", "leaves_1e-300_1e300" },
    };
    struct sweep_reasons r;
    int8_t code;

    (void) state;
    assert_int_equal(sweep_reasons_init(&r), STATUS_OK);
    assert_string_equal(r.word[REASON_ABSENT], "absent");
    assert_string_equal(r.word[REASON_PRESENT], "present");
    for (int i = 0; i < 4; i++) {
        for (int again = 0; again < 2; again++) {
            assert_int_equal(sweep_reasons_code(&r, say[i][0], &code),
                             STATUS_OK);
            assert_int_equal(code, REASON_FIRST + i);
        }
        assert_string_equal(r.word[code], say[i][1]);
        assert_string_equal(r.text[code], say[i][0]);
    }
    assert_null(r.word[REASON_FIRST + 4]);
    sweep_reasons_free(&r);
    sweep_reasons_free(&r);
}

static void what_finds_no_room_is_just_absent(void **state)
{
    struct sweep_reasons r;
    int8_t code = -1;

    (void) state;
    assert_int_equal(sweep_reasons_init(&r), STATUS_OK);
    for (int i = REASON_FIRST; i < REASONS_MAX + 5; i++) {
        char text[32];
        snprintf(text, sizeof text, "reason %d", i);
        assert_int_equal(sweep_reasons_code(&r, text, &code), STATUS_OK);
        assert_int_equal(code, i < REASONS_MAX ? i : REASON_ABSENT);
    }
    assert_null(r.word[REASONS_MAX]);
    assert_int_equal(sweep_reasons_code(&r, "reason 77", &code), STATUS_OK);
    assert_int_equal(code, 77);
    sweep_reasons_free(&r);
}

static void a_failed_allocation_leaves_the_list_as_it_was(void **state)
{
    enum status status = STATUS_NO_MEMORY;
    struct sweep_reasons r;

    (void) state;
    for (long k = 0; status != STATUS_OK; k++) {
        int8_t code = -1;
        fault_alloc_at(k);
        status = sweep_reasons_init(&r);
        if (status == STATUS_OK)
            status = sweep_reasons_code(&r, "none", &code);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        assert_int_equal(code, status ? -1 : REASON_FIRST);
        assert_true(r.count == 0 || r.count == REASON_FIRST ||
                    status == STATUS_OK);
        sweep_reasons_free(&r);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sentences_become_words),
        cmocka_unit_test(what_finds_no_room_is_just_absent),
        cmocka_unit_test(a_failed_allocation_leaves_the_list_as_it_was),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
