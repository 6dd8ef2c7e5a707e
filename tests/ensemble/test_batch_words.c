/* Texts that draws leave behind. */
#include "batch_words.h"

#include <stdio.h>
#include <string.h>

#include "check.h"
#include "fault_alloc.h"
#include "sweep_reason.h"

enum { TEXTS = 3 * REASONS_MAX, DRAWS = 20 * TEXTS };

static void write(int i, char text[24])
{
    snprintf(text, 24, "stable_focus_%d", i % TEXTS);
}

/* Beyond the room that there is for codes, too: else it would hang on the
 * threads which texts are kept. */
static void test_threads_that_meet_many_texts_at_once_keep_each_of_them(
    void **state)
{
    static const char *kept[DRAWS];
    struct batch_words w = { .text = NULL };

    (void) state;
#pragma omp parallel for schedule(static, 1) num_threads(4)
    for (int i = 0; i < DRAWS; i++) {
        char text[24];
        write(5 * i, text);
        kept[i] = batch_words_keep(&w, text);
    }
    for (int i = 0; i < DRAWS; i++) {
        char text[24];
        write(5 * i, text);
        assert_string_equal(kept[i], text);
        assert_ptr_equal(kept[i], kept[i % TEXTS]);
    }
    assert_int_equal(w.count, TEXTS);
    batch_words_free(&w);
    batch_words_free(&w);
}

static void test_without_memory_what_was_kept_stays(void **state)
{
    (void) state;
    for (long k = 0; k < 2; k++) {
        struct batch_words w = { .text = NULL };
        char text[24];
        const char *kept = NULL;
        fault_alloc_at(k);
        for (int i = 0; i < 20 && (i == 0 || kept); i++) {
            write(i, text);
            kept = batch_words_keep(&w, text);
        }
        fault_alloc_at(FAULT_ALLOC_NEVER);
        assert_null(kept);
        for (size_t i = 0; i < w.count; i++) {
            write((int) i, text);
            assert_string_equal(w.text[i], text);
        }
        batch_words_free(&w);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(
            test_threads_that_meet_many_texts_at_once_keep_each_of_them),
        cmocka_unit_test(test_without_memory_what_was_kept_stays),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
