/* Every call of HDF5 fails once: an error in one line, no handle left open, no
 * file half written. */
#include <ctype.h>
#include <glob.h>
#include <hdf5.h>
#include <stdbool.h>
#include <string.h>
#include <unistd.h>

#include "check.h"
#include "fault_hdf.h"
#include "own_folder.h"
#include "sample_store.h"
#include "store_compare.h"
#include "store_grid.h"
#include "store_read.h"
#include "store_records.h"

/* ---- a small file of every kind of thing --------------------------------- */

enum { ROWS = 4, COLUMNS = 3 };

static void put_grid(struct store *st)
{
    static const char *const psi_v[] = { "psi", "v" };
    static const struct record_field margin = {
        .name = "margin", .unit = "1", .text = "distance", .kind = RECORD_REAL
    };
    static const double axis[ROWS] = { 1, 2, 3, 4 }, cells[ROWS * COLUMNS];

    (void) !store_put_axis(st, "/basin", "psi", "1", "state", ROWS, axis);
    (void) !store_put_axis(st, "/basin", "v", "1", "rate", COLUMNS, axis);
    (void) !store_put_cube(st, "/basin", &margin, 2, psi_v);
    (void) !store_put_rows(st, "/basin", &margin, 0, 1, cells);
    (void) !store_put_rows(st, "/basin", &margin, 1, ROWS - 1, cells);
    (void) !store_put_real(st, "/basin", "fraction", 0.125);
    (void) !store_put_count(st, "/basin", "audited", 1000);
}

static enum status put(struct store *st)
{
    const struct record_array *a = &sample_states;

    (void) !store_put_text(st, "/provenance", "version", "1");
    (void) !store_put_text(st, "/provenance", "overrides", "");
    (void) !store_put_records(st, "/steady", a, NULL);
    (void) !store_put_scalars(st, "/steady/one", a->type, a->at);
    put_grid(st);
    return store_put_text(st, "/provenance", "scene", "law: a\n");
}

/* The first failure sticks: commit says it again. */
static bool on_disk; /* else in memory */

static enum status write_file(const char *path, struct fault *why)
{
    struct store *st = NULL;
    enum status s = (on_disk ? store_create_on_disk
                             : store_create)(path, "sample", &st, why);

    if (s == STATUS_OK) {
        const enum status all = put(st);
        s = store_commit(st, why);
        assert_true(all == STATUS_OK || all == s);
    }
    store_free(&st);
    return s;
}

static void must_write(const char *path)
{
    struct fault why = { "" };
    const enum status s = write_file(path, &why);

    CHECK(s == STATUS_OK, "%s", why.text);
}

/* ---- every call ---------------------------------------------------------- */

/* Calls whose answer says nothing about the result: what they close or free is
 * gone, and the reason that HDF5 would give has a general word. */
static bool may_be_ignored(const char *name)
{
    static const char *const known[] = { "H5Idec_ref", "H5Dvlen_reclaim",
                                         "H5Ewalk2", "H5Eset_auto2" };

    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (strcmp(known[i], name) == 0)
            return true;
    return false;
}

/* The status of a work during which call k failed.  True: go on with k + 1. */
static bool judge(long k, enum status s, const struct fault *why)
{
    const char *failed = fault_hdf_failed();

    fault_hdf_at(FAULT_HDF_NEVER);
    sample_no_handles();
    if (failed == NULL) {
        CHECK(s == STATUS_OK, "%ld: %s", k, why->text);
        return false;
    }
    CHECK(s == STATUS_IO || (s == STATUS_OK && may_be_ignored(failed)),
          "%ld, %s: %s", k, failed, status_text(s));
    CHECK(s == STATUS_OK || (why->text[0] && !strchr(why->text, '\n')),
          "%ld, %s: '%s'", k, failed, why->text);
    return true;
}

static void written_whole_or_not_at_all(void)
{
    const char *path = own_path("out.h5");
    size_t size;
    long k = 0;
    bool more = true;

    must_write(path);
    char *whole = file_read(path, &size);
    for (; more; k++) {
        struct fault why = { "" };
        file_write(path, "old", 3);
        fault_hdf_at(k);
        const enum status s = write_file(path, &why);
        more = judge(k, s, &why);
        if (s == STATUS_OK) {
            size_t now;
            char *bytes = file_read(path, &now);
            assert_int_equal(now, size);
            assert_memory_equal(bytes, whole, size);
            free(bytes);
        } else {
            file_holds(path, "old");
        }
        assert_int_equal(own_folder_entries(), 1);
    }
    free(whole);
    CHECK(k > 400, "only %ld calls", k);
}

static void a_file_is_written_whole_or_not_at_all(void **state)
{
    (void) state;
    written_whole_or_not_at_all();
}

static void so_is_one_that_grows_on_disk(void **state)
{
    (void) state;
    on_disk = true;
    written_whole_or_not_at_all();
    on_disk = false;
}

static int see(void *ctx, const struct store_item *item)
{
    size_t *seen = ctx;

    *seen += strlen(item->path) + strlen(item->units) +
             strlen(item->long_name) + strlen(item->key) + strlen(item->text);
    return 0;
}

static void hear(void *ctx, const struct store_difference *d)
{
    size_t *told = ctx;

    (void) d;
    ++*told;
}

/* What is told of a file, in letters: nothing may be left out in silence. */
static enum status visit(const char *path, size_t *seen, struct fault *why)
{
    struct store *st;
    enum status s = store_open(path, &st, why);

    *seen = 0;
    if (s == STATUS_OK)
        s = store_visit(st, see, seen, why);
    store_free(&st);
    return s;
}

static void a_visit_tells_of_everything_or_fails(void **state)
{
    const char *path = own_path("out.h5");
    struct fault why = { "" };
    size_t all, seen;
    long k = 0;

    (void) state;
    must_write(path);
    assert_int_equal(visit(path, &all, &why), STATUS_OK);
    for (bool more = true; more; k++) {
        fault_hdf_at(k);
        const enum status s = visit(path, &seen, &why);
        CHECK(s != STATUS_OK || seen == all, "%ld, %s: %zu of %zu", k,
              fault_hdf_failed(), seen, all);
        more = judge(k, s, &why);
    }
    CHECK(k > 200, "only %ld calls", k);
}

static enum status read_version(const char *path, char **text,
                                struct fault *why)
{
    struct store *st;
    enum status s = store_open(path, &st, why);

    *text = NULL;
    if (s == STATUS_OK)
        s = store_read_text(st, "/provenance", "version", text, why);
    store_free(&st);
    return s;
}

static void a_text_is_read_or_there_is_none(void **state)
{
    const char *path = own_path("out.h5");
    bool more = true;

    (void) state;
    must_write(path);
    for (long k = 0; more; k++) {
        struct fault why = { "" };
        char *text;
        fault_hdf_at(k);
        const enum status s = read_version(path, &text, &why);
        if (s == STATUS_OK)
            assert_string_equal(text, "1");
        else
            assert_null(text);
        free(text);
        more = judge(k, s, &why);
    }
}

static enum status compare(const char *a, const char *b, size_t *told,
                           struct fault *why)
{
    struct store *x = NULL, *y = NULL;
    enum status s = store_open(a, &x, why);

    *told = 0;
    if (s == STATUS_OK)
        s = store_open(b, &y, why);
    if (s == STATUS_OK)
        s = store_compare(x, y, hear, told, why);
    store_free(&x);
    store_free(&y);
    return s;
}

static void nothing_is_told_to_differ_because_a_call_failed(void **state)
{
    const char *a = own_path("a.h5"), *b = own_path("b.h5");
    bool more = true;
    long k = 0;

    (void) state;
    must_write(a);
    must_write(b);
    for (; more; k++) {
        struct fault why = { "" };
        size_t told;
        fault_hdf_at(k);
        const enum status s = compare(a, b, &told, &why);
        CHECK(told == 0, "%ld, %s", k, fault_hdf_failed());
        more = judge(k, s, &why);
    }
    CHECK(k > 400, "only %ld calls", k);
}

/* Calls of HDF5 in a source text; all must be known. */
static size_t count_calls(const char *text)
{
    size_t calls = 0;

    for (const char *at = text; (at = strstr(at, "H5")) != NULL; at += 2) {
        char name[64];
        const size_t n = strspn(at, "abcdefghijklmnopqrstuvwxyz"
                                    "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_");
        if (at[n] != '(' || (at > text && isalnum((unsigned char) at[-1])))
            continue;
        snprintf(name, sizeof name, "%.*s", (int) n, at);
        CHECK(fault_hdf_knows(name), "%s cannot be made to fail", name);
        calls++;
    }
    return calls;
}

static void no_call_of_the_store_is_forgotten(void **state)
{
    char pattern[600];
    size_t calls = 0;
    glob_t found;

    (void) state;
    snprintf(pattern, sizeof pattern, "%s/lib/store/*.c",
             getenv("SOURCE_ROOT"));
    assert_int_equal(glob(pattern, 0, NULL, &found), 0);
    for (size_t i = 0; i < found.gl_pathc; i++) {
        size_t size;
        char *text = file_read(found.gl_pathv[i], &size);
        text[size] = '\0';
        calls += count_calls(text);
        free(text);
    }
    globfree(&found);
    CHECK(calls > 80, "only %zu", calls);
}

/* A file that no path names is left in the working folder, which is the test's
 * own. */
static int work_in_own_folder(void **state)
{
    return own_folder_make(state) == 0 ? chdir(own_path("")) : -1;
}

#define TEST(name)                                                             \
    cmocka_unit_test_setup_teardown(name, work_in_own_folder, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_file_is_written_whole_or_not_at_all),
        TEST(so_is_one_that_grows_on_disk),
        TEST(a_visit_tells_of_everything_or_fails),
        TEST(a_text_is_read_or_there_is_none),
        TEST(nothing_is_told_to_differ_because_a_call_failed),
        TEST(no_call_of_the_store_is_forgotten),
    };
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
