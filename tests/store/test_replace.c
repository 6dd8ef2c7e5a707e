/* A file appears whole or not at all, whatever the system refuses. */
#include "replace.h"

#include <errno.h>
#include <stdbool.h>
#include <string.h>

#include "check.h"
#include "fault_write.h"
#include "own_folder.h"

enum { SIZE = 1000 };

static const char *fresh_bytes(void)
{
    static char bytes[SIZE + 1];

    memset(bytes, 'n', SIZE);
    return bytes;
}

/* All but its rename may have happened: "old" or the new one whole. */
static void is_old_or_new(const char *path, bool is_new)
{
    file_holds(path, is_new ? fresh_bytes() : "old");
    assert_int_equal(own_folder_entries(), 1);
}

static void every_call_of_the_system_may_fail(void **state)
{
    static const int errors[] = { ENOSPC, EIO, EDQUOT, EROFS };
    const char *path = own_path("out"), *failed = "";

    (void) state;
    for (size_t e = 0; e < sizeof errors / sizeof *errors; e++)
        for (long k = 0; failed != NULL || k == 0; k++) {
            struct fault why = { "" };
            file_write(path, "old", 3);
            fault_write_at(k, errors[e]);
            const enum status s = replace_file(path, fresh_bytes(), SIZE, &why);
            failed = fault_write_failed();
            fault_write_at(FAULT_WRITE_NEVER, 0);
            /* a file that has no name yet is only the first thing tried */
            CHECK(s == STATUS_IO || !failed || strcmp(failed, "open") == 0,
                  "%ld, %s: %s", k, failed, status_text(s));
            CHECK(s == STATUS_OK || strstr(why.text, strerror(errors[e])), "%s",
                  why.text);
            is_old_or_new(path, s == STATUS_OK);
        }
}

static void an_interrupted_call_is_made_again(void **state)
{
    const char *path = own_path("out"), *failed = "";

    (void) state;
    for (long k = 0; failed != NULL; k++) {
        struct fault why = { "" };
        file_write(path, "old", 3);
        fault_write_at(k, EINTR);
        const enum status s = replace_file(path, fresh_bytes(), SIZE, &why);
        failed = fault_write_failed();
        fault_write_at(FAULT_WRITE_NEVER, 0);
        if (failed && (!strcmp(failed, "write") || !strcmp(failed, "fsync")))
            CHECK(s == STATUS_OK, "%s: %s", failed, why.text);
        is_old_or_new(path, s == STATUS_OK);
    }
}

static void a_write_may_take_a_part_only(void **state)
{
    const char *path = own_path("out");
    struct fault why = { "" };

    (void) state;
    file_write(path, "old", 3);
    fault_write_most(7);
    const enum status s = replace_file(path, fresh_bytes(), SIZE, &why);
    fault_write_most(0);
    CHECK(s == STATUS_OK, "%s", why.text);
    is_old_or_new(path, true);
}

#define TEST(name)                                                             \
    cmocka_unit_test_setup_teardown(name, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(every_call_of_the_system_may_fail),
        TEST(an_interrupted_call_is_made_again),
        TEST(a_write_may_take_a_part_only),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
