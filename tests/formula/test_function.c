/* Functions as text: each needs those before it only, and they are found. */
#include "function.h"

#include <string.h>

#include "check.h"

static void functions_come_after_those_they_call(void **state)
{
    (void) state;
    for (int i = 0; i < FUNCTIONS; i++) {
        assert_true(strlen(functions[i].name) <= 9);
        assert_int_equal(functions[i].body == NULL,
                         functions[i].meaning == NULL);
        for (int j = i; j < FUNCTIONS && functions[i].body; j++)
            CHECK(!function_is_called(functions[i].body, functions[j].name),
                  "%s calls %s", functions[i].name, functions[j].name);
    }
}

static void a_call_is_a_whole_word_and_a_bracket(void **state)
{
    (void) state;
    assert_true(function_is_called("2*em1(u_)", "em1"));
    assert_true(function_is_called("xem1+em1(u_)", "em1"));
    assert_false(function_is_called("xem1(u_)", "em1"));
    assert_false(function_is_called("em1+em12(u_)", "em1"));
    assert_int_equal(function_arguments(FUNCTION_EXP), 1);
    assert_int_equal(function_arguments(FUNCTION_BEND), 3);
    assert_int_equal(function_arguments(FUNCTION_CHOOSE), 4);
}

static void what_is_called_is_needed_too(void **state)
{
    bool needed[FUNCTIONS] = { [FUNCTION_BEND] = true };

    (void) state;
    function_complete(needed);
    assert_true(needed[FUNCTION_BENDFAR] && needed[FUNCTION_BENDNEAR]);
    assert_true(needed[FUNCTION_ASINH] && needed[FUNCTION_LN1P]);
    assert_true(needed[FUNCTION_EM1]);
    assert_false(needed[FUNCTION_GROWTH] || needed[FUNCTION_LAMBERT]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(functions_come_after_those_they_call),
        cmocka_unit_test(a_call_is_a_whole_word_and_a_bracket),
        cmocka_unit_test(what_is_called_is_needed_too),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
