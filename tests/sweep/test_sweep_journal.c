/* The side file: what was written comes back, what was torn or changed does
 * not. */
#include "sweep_journal.h"

#include <string.h>

#include "check.h"
#include "fault_alloc.h"
#include "own_folder.h"

enum { ENTRIES = 3, ROWS = 5, KEY = 77, BLOCK = 40 };

static struct sweep_rows some_rows(void)
{
    struct sweep_rows rows = sweep_rows_of(ENTRIES, false);

    assert_int_equal(sweep_rows_add(&rows, ROWS), STATUS_OK);
    for (size_t i = 0; i < ROWS * rows.width; i++)
        rows.at[i] = 0.1 * (double) i;
    return rows;
}

/* The block of row i, some of its bytes zero. */
static const char *block_of(size_t i)
{
    static char block[BLOCK];

    memset(block, 0, sizeof block);
    snprintf(block, sizeof block, "the maps of point %zu", i);
    return block;
}

/* What comes out of a file. */
struct found {
    struct sweep_journal j;
    struct sweep_rows rows;
    struct sweep_reasons reasons;
    bool replaced;
    struct fault why;
};

static enum status open_it(struct found *f, uint64_t key, bool resume)
{
    *f = (struct found){ .rows = sweep_rows_of(ENTRIES, false) };
    const enum status status = sweep_reasons_init(&f->reasons);
    return status ? status
                  : sweep_journal_open(&f->j, own_path("a.part"), key, BLOCK,
                                       resume, &f->rows, &f->reasons,
                                       &f->replaced, &f->why);
}

static void leave(struct found *f)
{
    sweep_journal_close(&f->j);
    sweep_journal_close(&f->j);
    sweep_rows_free(&f->rows);
    sweep_reasons_free(&f->reasons);
}

/* Three rows, a reason, two rows. */
static void write_all(void)
{
    struct sweep_rows rows = some_rows();
    struct found f;

    assert_int_equal(open_it(&f, KEY, false), STATUS_OK);
    for (size_t i = 0; i < ROWS; i++) {
        if (i == 3)
            assert_int_equal(sweep_journal_reason(&f.j, "too steep", &f.why),
                             STATUS_OK);
        assert_int_equal(sweep_journal_row(&f.j, &rows, i, block_of(i), &f.why),
                         STATUS_OK);
    }
    leave(&f);
    sweep_rows_free(&rows);
}

/* Only rows as they were written, from the first on, each with its block. */
static size_t count_back(struct found *f)
{
    struct sweep_rows rows = some_rows();

    assert_true(f->rows.count <= ROWS);
    for (size_t i = 0; i < f->rows.count; i++) {
        char block[BLOCK] = "";
        *sweep_rows_place(&rows, i) = *sweep_rows_place(&f->rows, i);
        for (size_t k = 0; k < BLOCK; k += 8)
            assert_int_equal(sweep_journal_read(&f->j, &f->rows, i, k,
                                                block + k, 8, &f->why),
                             STATUS_OK);
        assert_memory_equal(block, block_of(i), BLOCK);
    }
    if (f->rows.count > 0)
        assert_memory_equal(rows.at, f->rows.at,
                            f->rows.count * rows.width * sizeof(double));
    if (f->rows.count > 3) {
        assert_int_equal(f->reasons.count, REASON_FIRST + 1);
        assert_string_equal(f->reasons.text[REASON_FIRST], "too steep");
    }
    sweep_rows_free(&rows);
    return f->rows.count;
}

static void what_was_written_comes_back(void **state)
{
    struct found f;

    (void) state;
    write_all();
    for (int i = 0; i < 2; i++) {
        assert_int_equal(open_it(&f, KEY, true), STATUS_OK);
        assert_int_equal(count_back(&f), ROWS);
        assert_false(f.replaced);
        leave(&f);
    }
}

static void a_file_cut_at_any_byte_keeps_its_whole_records(void **state)
{
    size_t size, before = 0;

    (void) state;
    write_all();
    char *bytes = file_read(own_path("a.part"), &size);
    for (size_t cut = 0; cut <= size; cut++) {
        struct found f;
        file_write(own_path("a.part"), bytes, cut);
        assert_int_equal(open_it(&f, KEY, true), STATUS_OK);
        const size_t rows = count_back(&f);
        CHECK(rows == before || rows == before + 1, "%zu rows of %zu bytes",
              rows, cut);
        before = rows;
        leave(&f);
    }
    assert_int_equal(before, ROWS);
    free(bytes);
}

static void a_changed_byte_ends_what_is_believed(void **state)
{
    enum { HEAD = 32 };
    size_t size;

    (void) state;
    write_all();
    char *bytes = file_read(own_path("a.part"), &size);
    for (size_t i = HEAD; i < size; i++) {
        struct found f;
        bytes[i] ^= 0x10;
        file_write(own_path("a.part"), bytes, size);
        bytes[i] ^= 0x10;
        assert_int_equal(open_it(&f, KEY, true), STATUS_OK);
        CHECK(count_back(&f) < ROWS, "byte %zu", i);
        leave(&f);
        size_t kept;
        free(file_read(own_path("a.part"), &kept));
        CHECK(kept <= i, "%zu bytes where byte %zu is wrong", kept, i);
    }
    free(bytes);
}

static void rows_go_on_behind_a_torn_one(void **state)
{
    struct sweep_rows rows = some_rows();
    struct found f;
    size_t size;

    (void) state;
    write_all();
    char *bytes = file_read(own_path("a.part"), &size);
    file_write(own_path("a.part"), bytes, size - 3);
    assert_int_equal(open_it(&f, KEY, true), STATUS_OK);
    assert_int_equal(count_back(&f), ROWS - 1);
    assert_int_equal(
        sweep_journal_row(&f.j, &rows, ROWS - 1, block_of(ROWS - 1), &f.why),
        STATUS_OK);
    leave(&f);
    size_t again;
    char *now = file_read(own_path("a.part"), &again);
    assert_int_equal(again, size);
    assert_memory_equal(now, bytes, size);
    free(now);
    free(bytes);
    sweep_rows_free(&rows);
}

static void another_key_or_another_file_is_refused(void **state)
{
    struct found f;

    (void) state;
    write_all();
    assert_int_equal(open_it(&f, KEY + 1, true), STATUS_BAD_SCENE);
    assert_non_null(strstr(f.why.text, "another scene or version"));
    leave(&f);
    assert_int_equal(open_it(&f, KEY + 1, false), STATUS_OK);
    assert_true(f.replaced);
    assert_int_equal(f.rows.count, 0);
    leave(&f);
    file_write(own_path("a.part"), "my diary", 8);
    for (int resume = 0; resume < 2; resume++) {
        assert_int_equal(open_it(&f, KEY, resume), STATUS_BAD_SCENE);
        assert_non_null(strstr(f.why.text, "not a side file of slipway"));
        leave(&f);
        file_holds(own_path("a.part"), "my diary");
    }
}

/* Rows of the same length, but other maps. */
static void blocks_of_another_length_are_refused(void **state)
{
    struct found f = { .rows = sweep_rows_of(ENTRIES, false) };

    (void) state;
    write_all();
    assert_int_equal(sweep_reasons_init(&f.reasons), STATUS_OK);
    assert_int_equal(sweep_journal_open(&f.j, own_path("a.part"), KEY,
                                        BLOCK + 8, true, &f.rows, &f.reasons,
                                        &f.replaced, &f.why),
                     STATUS_BAD_SCENE);
    assert_non_null(strstr(f.why.text, "another scene or version"));
    leave(&f);
}

static void a_block_beyond_the_end_is_told(void **state)
{
    char block[BLOCK];
    struct found f;

    (void) state;
    write_all();
    assert_int_equal(open_it(&f, KEY, true), STATUS_OK);
    *sweep_rows_place(&f.rows, 0) = 1e9;
    assert_int_equal(
        sweep_journal_read(&f.j, &f.rows, 0, 0, block, BLOCK, &f.why),
        STATUS_IO);
    assert_non_null(strstr(f.why.text, "a.part: Input/output error"));
    leave(&f);
}

static void two_runs_do_not_share_a_file(void **state)
{
    struct found f, g;

    (void) state;
    assert_int_equal(open_it(&f, KEY, false), STATUS_OK);
    assert_int_equal(open_it(&g, KEY, true), STATUS_IO);
    assert_non_null(strstr(g.why.text, "another run is writing it"));
    leave(&g);
    leave(&f);
}

static void what_cannot_be_opened_is_told(void **state)
{
    struct found f = { .rows = sweep_rows_of(ENTRIES, false) };

    (void) state;
    assert_int_equal(sweep_reasons_init(&f.reasons), STATUS_OK);
    assert_int_equal(sweep_journal_open(&f.j, own_path(""), KEY, BLOCK, false,
                                        &f.rows, &f.reasons, &f.replaced,
                                        &f.why),
                     STATUS_IO);
    assert_non_null(strstr(f.why.text, ": Is a directory"));
    leave(&f);
}

static void each_failed_allocation_is_told(void **state)
{
    enum status status = STATUS_NO_MEMORY;
    struct found f;

    (void) state;
    write_all();
    for (long k = 0; status != STATUS_OK; k++) {
        fault_alloc_at(k);
        status = open_it(&f, KEY, true);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        assert_true(status == STATUS_OK || status == STATUS_NO_MEMORY);
        if (status == STATUS_OK)
            assert_int_equal(count_back(&f), ROWS);
        leave(&f);
    }
}

#define IN_FOLDER(test)                                                        \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(what_was_written_comes_back),
        IN_FOLDER(a_file_cut_at_any_byte_keeps_its_whole_records),
        IN_FOLDER(a_changed_byte_ends_what_is_believed),
        IN_FOLDER(rows_go_on_behind_a_torn_one),
        IN_FOLDER(another_key_or_another_file_is_refused),
        IN_FOLDER(blocks_of_another_length_are_refused),
        IN_FOLDER(a_block_beyond_the_end_is_told),
        IN_FOLDER(two_runs_do_not_share_a_file),
        IN_FOLDER(what_cannot_be_opened_is_told),
        IN_FOLDER(each_failed_allocation_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
