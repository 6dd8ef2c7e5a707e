/* Tables of texts from CSV, with every cell's place. */
#include "table.h"

#include <string.h>

#include "check.h"
#include "fault_alloc.h"
#include "own_folder.h"
#include "tolerance.h"

static void parse(struct table *t, const char *text)
{
    struct fault why;
    const enum status s = table_parse(t, text, strlen(text), "t.csv", &why);

    CHECK(s == STATUS_OK, "%s", why.text);
}

/* The text is refused with exactly this line. */
static void refused_bytes(const char *text, size_t size, const char *line)
{
    struct table t;
    struct fault why;

    assert_int_equal(table_parse(&t, text, size, "t.csv", &why),
                     STATUS_BAD_SCENE);
    assert_string_equal(why.text, line);
    assert_null(t.cell);
    table_free(&t);
}

static void refused(const char *text, const char *line)
{
    refused_bytes(text, strlen(text), line);
}

static void cell_is(const struct table *t, size_t row, size_t column,
                    const char *text, unsigned line, unsigned byte)
{
    const struct table_cell *cell = table_at(t, row, column);

    assert_string_equal(cell->text, text);
    assert_int_equal(cell->line, line);
    assert_int_equal(cell->column, byte);
}

static void cells_and_their_places_are_read(void **state)
{
    struct table t;

    (void) state;
    parse(&t, "a,b\n1,2\n3,4");
    assert_int_equal(t.rows, 2);
    assert_int_equal(t.columns, 2);
    assert_string_equal(table_header(&t, 1)->text, "b");
    cell_is(&t, 0, 0, "1", 2, 1);
    cell_is(&t, 1, 1, "4", 3, 3);
    table_free(&t);
    table_free(&t);
}

static void blanks_comments_crlf_and_byte_order_mark_do_not_count(void **state)
{
    struct table t;

    (void) state;
    parse(&t, "\xef\xbb\xbf# a comment, \"open\r\n\r\n a , b\t\r\n  \r\n"
              "1 x,  \r\n#\r\n,2\r\n");
    assert_int_equal(t.rows, 2);
    assert_string_equal(table_header(&t, 0)->text, "a");
    assert_string_equal(table_header(&t, 1)->text, "b");
    cell_is(&t, 0, 0, "1 x", 5, 1);
    cell_is(&t, 0, 1, "", 5, 7);
    cell_is(&t, 1, 0, "", 7, 1);
    cell_is(&t, 1, 1, "2", 7, 2);
    table_free(&t);
}

static void quoted_cells_hold_commas_quotes_and_line_ends(void **state)
{
    struct table t;

    (void) state;
    parse(&t, "a,b\n\"x,\"\"y\"\"\",\" \r\n\nz\"\n\"#1\",\"\"\n");
    assert_int_equal(t.rows, 2);
    cell_is(&t, 0, 0, "x,\"y\"", 2, 1);
    cell_is(&t, 0, 1, " \n\nz", 2, 11);
    cell_is(&t, 1, 0, "#1", 5, 1);
    cell_is(&t, 1, 1, "", 5, 6);
    table_free(&t);
}

static void cells_are_found_by_name(void **state)
{
    struct table t;

    (void) state;
    parse(&t, "a,b\n1,2\n,4\n");
    assert_string_equal(table_find(&t, 1, "b")->text, "4");
    assert_null(table_find(&t, 1, "a")); /* empty */
    assert_null(table_find(&t, 1, "c"));
    table_free(&t);
}

static void what_is_no_table_is_refused_in_one_line(void **state)
{
    (void) state;
    refused("", "t.csv:1:1: no header, expected names of columns");
    refused("# x\n\n", "t.csv:3:1: no header, expected names of columns");
    refused("a,b\n", "t.csv:2:1: no rows below the header");
    refused("a,b\n1\n", "t.csv:2:1: 1 cells, the header has 2");
    refused("a,b\n1,2,3\n", "t.csv:2:5: more cells than the header has");
    refused("a,b,a\n", "t.csv:1:5: two columns are named 'a'");
    refused("a,\n1,2\n", "t.csv:1:3: a column without a name");
    refused("a\n\"x\n\n", "t.csv:2:1: a quote that is never closed");
    refused("a\nx\"y\"\n", "t.csv:2:2: a quote inside a cell");
    refused("a\n\"x\"y\n", "t.csv:2:4: text behind a closing quote");
    refused("a\n1\r2\n", "t.csv:2:2: byte 0x0d is no text, expected CSV");
    refused("a\n\"\x01\"\n", "t.csv:2:2: byte 0x01 is no text, expected CSV");
    refused("a\n1\x7f\n", "t.csv:2:2: byte 0x7f is no text, expected CSV");
    refused_bytes("a\n1\0\n2\n", 7,
                  "t.csv:2:2: byte 0x00 is no text, expected CSV");
    refused_bytes("\xff\xfe"
                  "a\0",
                  4, "t.csv:1:4: byte 0x00 is no text, expected CSV");
}

static void huge_cells_and_headers_are_refused(void **state)
{
    const size_t size = 1000000;
    char *text = malloc(size + 8);

    (void) state;
    assert_non_null(text);
    memset(text, 'x', size);
    memcpy(text, "a\n", 2);
    refused_bytes(text, size, "t.csv:2:1: a cell of more than 4096 bytes");
    text[2] = text[size - 1] = '"';
    refused_bytes(text, size, "t.csv:2:1: a cell of more than 4096 bytes");
    text[2 + TABLE_CELL] = '\n';
    struct table t;
    struct fault why;
    text[2] = 'x';
    assert_int_equal(
        table_parse(&t, text, (size_t) TABLE_CELL + 3, "t.csv", &why),
        STATUS_OK);
    table_free(&t);
    for (size_t i = 0; i < size; i++)
        text[i] = i % 2 ? ',' : 'x';
    refused_bytes(text, size, "t.csv:1:2049: more than 1024 columns");
    free(text);
}

static void random_bytes_never_do_harm(void **state)
{
    static const char letters[] = "a1\",\n\r#  \x01\xef\xbb\xbf.";
    uint64_t rng = check_seed();
    size_t good = 0;

    (void) state;
    for (int i = 0; i < 20000; i++) {
        char text[40];
        const size_t size = check_bits(&rng) % sizeof text;
        struct table t;
        struct fault why;
        for (size_t k = 0; k < size; k++)
            text[k] = letters[check_bits(&rng) % (sizeof letters - 1)];
        const enum status s = table_parse(&t, text, size, "t.csv", &why);
        CHECK(s == STATUS_OK || s == STATUS_BAD_SCENE, "draw %d", i);
        CHECK(s == STATUS_OK || strchr(why.text, '\n') == NULL, "%s", why.text);
        for (size_t k = 0; s == STATUS_OK && k < t.rows * t.columns; k++)
            good +=
                strlen(table_at(&t, k / t.columns, k % t.columns)->text) > 0;
        table_free(&t);
    }
    CHECK(good > 100, "only %zu cells", good);
}

static void every_allocation_may_fail(void **state)
{
    char path[512], text[1000] = "a,b\n";
    enum status s = STATUS_NO_MEMORY;
    long k = 0;

    (void) state;
    for (int i = 0; i < 80; i++)
        strcat(text, "1,22222\n");
    strcpy(path, own_path("t.csv"));
    file_write(path, text, strlen(text));
    for (; s != STATUS_OK; k++) {
        struct table t;
        struct fault why;
        fault_alloc_at(k);
        s = table_read(&t, path, &why);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        CHECK(s == STATUS_OK || s == STATUS_NO_MEMORY, "%ld: %.400s", k,
              why.text);
        CHECK(s == STATUS_OK || strcmp(why.text, "out of memory") == 0, "%s",
              why.text);
        table_free(&t);
    }
    CHECK(k > 3, "%ld", k);
    s = STATUS_NO_MEMORY;
    for (k = 0; s != STATUS_OK; k++) {
        struct table t;
        struct fault why;
        fault_alloc_at(k);
        s = table_parse(&t, text, strlen(text), "t.csv", &why);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        table_free(&t);
    }
}

static void files_that_cannot_be_read_are_named(void **state)
{
    struct table t;
    struct fault why;

    (void) state;
    assert_int_equal(table_read(&t, own_path("none.csv"), &why), STATUS_IO);
    CHECK(strstr(why.text, "none.csv: cannot read: No such file"), "%s",
          why.text);
    assert_int_equal(table_read(&t, own_path(""), &why), STATUS_IO);
    CHECK(strstr(why.text, "Is a directory"), "%s", why.text);
}

static void files_of_more_than_64_mebibytes_are_refused(void **state)
{
    char path[512];
    struct table t;
    struct fault why;

    (void) state;
    strcpy(path, own_path("long.csv"));
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_int_equal(fseek(file, (long) TABLE_BYTES, SEEK_SET), 0);
    fputc('x', file);
    fclose(file);
    assert_int_equal(table_read(&t, path, &why), STATUS_IO);
    CHECK(strstr(why.text, "long.csv: cannot read: more than 64 MiB"), "%s",
          why.text);
}

#define IN_OWN_FOLDER(test)                                                    \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cells_and_their_places_are_read),
        cmocka_unit_test(blanks_comments_crlf_and_byte_order_mark_do_not_count),
        cmocka_unit_test(quoted_cells_hold_commas_quotes_and_line_ends),
        cmocka_unit_test(cells_are_found_by_name),
        cmocka_unit_test(what_is_no_table_is_refused_in_one_line),
        cmocka_unit_test(huge_cells_and_headers_are_refused),
        cmocka_unit_test(random_bytes_never_do_harm),
        IN_OWN_FOLDER(every_allocation_may_fail),
        IN_OWN_FOLDER(files_that_cannot_be_read_are_named),
        IN_OWN_FOLDER(files_of_more_than_64_mebibytes_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
