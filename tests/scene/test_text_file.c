/* Whole files in memory. */
#include "text_file.h"

#include <string.h>

#include "check.h"
#include "fault_alloc.h"
#include "own_folder.h"

enum { MOST = 10000 };

static void put(const char *path, size_t size)
{
    FILE *file = fopen(path, "w");

    assert_non_null(file);
    for (size_t i = 0; i < size; i++)
        fputc((int) ('a' + i % 26), file);
    assert_int_equal(fclose(file), 0);
}

static void all_bytes_are_there_and_a_zero_behind_them(void **state)
{
    static const size_t sizes[] = { 0, 1, 4095, 4096, 4097, 8192, MOST };
    const char *path = own_path("a.txt");

    (void) state;
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        struct fault why;
        char *text;
        size_t size;
        put(path, sizes[k]);
        assert_int_equal(text_file_read(path, MOST, &text, &size, &why),
                         STATUS_OK);
        assert_int_equal(size, sizes[k]);
        assert_int_equal(text[size], '\0');
        for (size_t i = 0; i < size; i++)
            assert_int_equal(text[i], 'a' + i % 26);
        free(text);
    }
}

static void of_a_longer_file_no_more_is_read_than_tells_so(void **state)
{
    const char *path = own_path("long.txt");
    struct fault why;
    char *text;
    size_t size;

    (void) state;
    put(path, 1000 * MOST);
    assert_int_equal(text_file_read(path, MOST, &text, &size, &why), STATUS_OK);
    CHECK(size > MOST && size < 4 * MOST, "%zu bytes", size);
    free(text);
}

static void a_file_that_cannot_be_read_is_named_with_the_reason(void **state)
{
    struct fault why;
    char *text;
    size_t size;

    (void) state;
    assert_int_equal(
        text_file_read(own_path("none.txt"), MOST, &text, &size, &why),
        STATUS_IO);
    CHECK(strstr(why.text, "none.txt: cannot read: No such file"), "%s",
          why.text);
    assert_null(text);
    assert_int_equal(text_file_read(own_path("."), MOST, &text, &size, &why),
                     STATUS_IO);
    CHECK(strstr(why.text, "cannot read: Is a directory"), "%s", why.text);
    assert_null(text);
}

static void memory_that_runs_out_leaves_nothing(void **state)
{
    const char *path = own_path("b.txt");
    enum status s = STATUS_NO_MEMORY;
    long k;

    (void) state;
    put(path, MOST);
    for (k = 0; s != STATUS_OK; k++) {
        struct fault why;
        char *text;
        size_t size;
        fault_alloc_at(k);
        s = text_file_read(path, MOST, &text, &size, &why);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        assert_true((text == NULL) == (s != STATUS_OK));
        free(text);
    }
    CHECK(k > 3, "%ld allocations", k);
}

#define IN_OWN_FOLDER(test)                                                    \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_OWN_FOLDER(all_bytes_are_there_and_a_zero_behind_them),
        IN_OWN_FOLDER(of_a_longer_file_no_more_is_read_than_tells_so),
        IN_OWN_FOLDER(a_file_that_cannot_be_read_is_named_with_the_reason),
        IN_OWN_FOLDER(memory_that_runs_out_leaves_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
