/* What `store_visit` finds, and what damaged files do to it. */
#include "store_read.h"

#include <hdf5.h>
#include <string.h>

#include "check.h"
#include "fault_alloc.h"
#include "own_folder.h"
#include "sample_store.h"
#include "tolerance.h"

enum { LONG_TEXT = 100000 };

struct seen {
    char text[8192];
    size_t length;
    int budget; /* items before it asks to stop */
};

static int see(void *ctx, const struct store_item *item)
{
    static const char mark[] = { 'G', 'D', 'T' };
    struct seen *seen = ctx;
    char *at = seen->text + seen->length;
    const size_t room = sizeof seen->text - seen->length;
    int took = snprintf(at, room, "%c %s", mark[item->kind], item->path);

    for (int i = 0; item->kind == STORE_DATASET && i < item->rank; i++)
        took += snprintf(at + took, room - (size_t) took, " %d",
                         (int) item->extent[i]);
    took += snprintf(at + took, room - (size_t) took, "|%s|%s|%s|%s\n",
                     item->units, item->long_name, item->key, item->text);
    seen->length += (size_t) took;
    return --seen->budget == 0;
}

static enum status visit_file(const char *name, struct seen *seen,
                              struct fault *fault)
{
    struct store *st;
    enum status s = store_open(name, &st, fault);

    if (s == STATUS_OK)
        s = store_visit(st, see, seen, fault);
    store_free(&st);
    sample_no_handles();
    return s;
}

static void a_visit_tells_of_everything_in_the_order_put(void **state)
{
    const char *path = own_path("out.h5");
    static const char *const lines[] = {
        "G /||||\n",
        "T /|||Conventions|CF-1.10\n",
        "G /provenance||||\n",
        "T /provenance|||scene|law: a\nslope: b\n",
        "T /provenance|||version|1\n",
        "D /equilibria/n 2|1|index||\n",
        "D /equilibria/v 2|m s-1|slip rate||\n",
        "D /manifold/stable_upper/arc 40|1|column arc||\n",
        "D /absent/lambda|s-1|eigenvalue||\n",
        "T /absent/lambda|||comment|no window\n",
        "D /basin/label 300 20|1|fate||\n",
        "T /basin/label|||flag_meanings|saddle stable_node\n",
    };
    static struct seen seen;
    struct fault fault = { "" };
    const char *at = seen.text;

    (void) state;
    sample_must_write(path);
    seen = (struct seen){ .budget = -1 };
    assert_int_equal(visit_file(path, &seen, &fault), STATUS_OK);
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        char *found = strstr(at, lines[i]);
        CHECK(found != NULL, "not in order: %s", lines[i]);
        at = found;
    }
    assert_null(strstr(seen.text, "DIMENSION_SCALE"));
    seen = (struct seen){ .budget = 3 };
    assert_int_equal(visit_file(path, &seen, &fault), STATUS_STOPPED);
}

static void a_text_of_any_length_reads_back(void **state)
{
    const char *path = own_path("out.h5");
    static char longer[LONG_TEXT + 1];
    struct store *st;
    struct fault fault = { "" };
    char *text;

    (void) state;
    memset(longer, 'x', LONG_TEXT);
    assert_int_equal(store_create(path, "", &st, &fault), STATUS_OK);
    assert_int_equal(store_put_text(st, "/a", "long", longer), STATUS_OK);
    assert_int_equal(store_put_text(st, "/a", "empty", ""), STATUS_OK);
    assert_int_equal(store_commit(st, &fault), STATUS_OK);
    store_free(&st);
    assert_int_equal(store_open(path, &st, &fault), STATUS_OK);
    assert_int_equal(store_read_text(st, "/a", "long", &text, &fault), 0);
    assert_string_equal(text, longer);
    free(text);
    assert_int_equal(store_read_text(st, "/a", "empty", &text, &fault), 0);
    assert_string_equal(text, "");
    free(text);
    assert_int_equal(store_read_text(st, "/a", "none", &text, &fault),
                     STATUS_IO);
    assert_null(text);
    CHECK(strstr(fault.text, "no text 'none' in /a"), "%s", fault.text);
    store_free(&st);
    sample_no_handles();
}

/* More than stand in an object's header. */
enum { MANY = 3 * STORE_COMPACT };

struct many {
    int texts, groups;
};

/* Names fall in the alphabet as they are put. */
static const char *many_name(const char *before, int k)
{
    static char name[16];

    snprintf(name, sizeof name, "%s%04d", before, MANY - k);
    return name;
}

static int see_many(void *ctx, const struct store_item *item)
{
    struct many *seen = ctx;

    if (item->kind == STORE_GROUP && strcmp(item->path, "/") != 0)
        assert_string_equal(item->path, many_name("/g", seen->groups++));
    if (item->kind == STORE_TEXT && item->key[0] == 'k')
        assert_string_equal(item->key, many_name("k", seen->texts++));
    return 0;
}

static void many_groups_and_texts_keep_the_order_put(void **state)
{
    const char *path = own_path("out.h5");
    struct many seen = { 0, 0 };
    struct store *st;
    struct fault fault = { "" };

    (void) state;
    assert_int_equal(store_create(path, "", &st, &fault), STATUS_OK);
    for (int k = 0; k < MANY; k++) {
        (void) !store_put_text(st, "/", many_name("k", k), "text");
        (void) !store_put_text(st, many_name("/g", k), "text", "text");
    }
    assert_int_equal(store_commit(st, &fault), STATUS_OK);
    store_free(&st);
    assert_int_equal(store_open(path, &st, &fault), STATUS_OK);
    assert_int_equal(store_visit(st, see_many, &seen, &fault), STATUS_OK);
    store_free(&st);
    assert_int_equal(seen.groups, MANY);
    assert_int_equal(seen.texts, MANY);
}

static void damaged_files_are_refused_in_one_line(void **state)
{
    const char *path = own_path("out.h5");
    struct fault fault = { "" };
    static struct seen seen;
    size_t size;

    (void) state;
    sample_must_write(path);
    char *bytes = file_read(path, &size);
    for (size_t keep = 0; keep < size; keep += 1 + keep / 3) {
        file_write(path, bytes, keep);
        seen = (struct seen){ .budget = -1 };
        fault.text[0] = '\0';
        CHECK(visit_file(path, &seen, &fault) == STATUS_IO, "%zu", keep);
        CHECK(strncmp(fault.text, path, strlen(path)) == 0 &&
                  strchr(fault.text, '\n') == NULL,
              "%s", fault.text);
    }
    free(bytes);
}

static void any_allocation_may_fail(void **state)
{
    const char *path = own_path("out.h5");
    enum status s = STATUS_NO_MEMORY;
    long k = 0;

    (void) state;
    sample_must_write(path);
    for (; s != STATUS_OK; k++) {
        static struct seen seen;
        struct fault fault = { "" };
        seen = (struct seen){ .budget = -1 };
        fault_alloc_at(k);
        s = visit_file(path, &seen, &fault);
        const bool failed = fault_alloc_count() > k;
        fault_alloc_at(FAULT_ALLOC_NEVER);
        CHECK(s == (failed ? STATUS_NO_MEMORY : STATUS_OK), "%ld", k);
        CHECK(!failed || strstr(fault.text, "out.h5: out of memory"), "%s",
              fault.text);
    }
    CHECK(k > 50, "only %ld allocations", k);
}

#define TEST(name)                                                             \
    cmocka_unit_test_setup_teardown(name, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_visit_tells_of_everything_in_the_order_put),
        TEST(a_text_of_any_length_reads_back),
        TEST(many_groups_and_texts_keep_the_order_put),
        TEST(damaged_files_are_refused_in_one_line),
        TEST(any_allocation_may_fail),
    };
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
