/* Results in a file as other programs find them. */
#include "store_results.h"

#include <hdf5.h>
#include <hdf5_hl.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "own_folder.h"
#include "tolerance.h"

enum { ROWS = 2 * STORE_CHUNK + 3, COLUMNS = 5 };

/* A run: axes of a grid, whose cells are numbered, and some numbers. */
struct run {
    struct at {
        double x;
    } row[ROWS], column[COLUMNS];
    struct number {
        struct quantity q;
        int8_t word;
        const char *text;
        double real;
    } number[3];
    size_t largest; /* block of rows asked for */
};

static const char *const words[] = { "no", "yes", NULL };

static const struct record_field y_fields[] = {
    { .name = "y",
      .unit = "1",
      .text = "a row",
      .offset = offsetof(struct at, x),
      .kind = RECORD_REAL },
};
static const struct record_field x_fields[] = {
    FIELD(at, REAL, x, "1", "a column"),
};
static const struct record_field number_fields[] = {
    FIELD(number, QUANTITY, q, "m", "a number"),
    FIELD_CODE(number, word, words, "a word"),
    FIELD(number, TEXT, text, "1", "a text"),
    FIELD(number, REAL, real, "1", "a real number"),
};
struct cell {
    double number, twice;
};
static const struct record_field cell_fields[] = {
    FIELD(cell, REAL, number, "1", "the number of a cell"),
    FIELD(cell, REAL, twice, "1", "twice that"),
};
static const struct record_type y_type = RECORD_TYPE("y", "", y_fields, at);
static const struct record_type x_type = RECORD_TYPE("x", "", x_fields, at);
static const struct record_type number_type =
    RECORD_TYPE("number", "", number_fields, number);
/* Of the same records each a member. */
static const struct record_type one_type = { "one", "", cell_fields, 1,
                                             sizeof(struct cell) };
static const struct record_type two_type = { "two", "", cell_fields + 1, 1,
                                             sizeof(struct cell) };

RESULT_VIEW(view_y, run, s->row, ROWS)
RESULT_VIEW(view_x, run, s->column, COLUMNS)
RESULT_VIEW(view_number, run, &s->number[k], 1)
RESULT_VIEW(view_numbers, run, s->number, 3)

static enum status no_view(const void *run, size_t k, struct result_view *out)
{
    (void) run, (void) k, (void) out;
    return STATUS_OK;
}

static size_t calls; /* of cells */

static enum status cells(const void *run, size_t first, size_t count,
                         const struct monitor *monitor, void *records)
{
    struct cell *c = records;

    (void) run;
    calls++;
    for (size_t i = 0; i < count * COLUMNS; i++)
        c[i] = (struct cell){ (double) (first * COLUMNS + i),
                              2.0 * (double) (first * COLUMNS + i) };
    return monitor_tell(monitor, "rows", first, ROWS) ? STATUS_STOPPED
                                                      : STATUS_OK;
}

enum { WANTED = 1, UNWANTED = 2 };

static const struct result table[] = {
    { "/grid", NULL, "", RESULT_COLUMNS, .axis = "y", .type = &y_type,
      .view = view_y },
    { "/grid", NULL, "", RESULT_COLUMNS, .axis = "x", .type = &x_type,
      .view = view_x },
    { "/grid", NULL, "", RESULT_LAYERS, .axis = "y, x", .type = &one_type,
      .rows = cells },
    { "/grid", NULL, "", RESULT_LAYERS, .axis = "y, x", .type = &two_type,
      .rows = cells, .needs = WANTED },
    { "/grid", NULL, "", RESULT_ATTRIBUTES, .member = "of_*_{a,b,c}",
      .type = &number_type, .view = view_number },
    { "/number_{a,b,c}", NULL, "", .type = &number_type, .view = view_number },
    { "/numbers", NULL, "", RESULT_COLUMNS, .type = &number_type,
      .view = view_numbers },
    { "/unwanted", NULL, "", .type = &number_type, .needs = UNWANTED,
      .view = view_number },
    { "/absent", NULL, "", .type = &number_type, .view = no_view },
    { NULL, "only in JSON", "", .type = &number_type, .view = view_number },
    { .path = NULL },
};
static const struct result *const tables[] = { table, NULL };

static void fill(struct run *r)
{
    *r =
        (struct run){ .number = { { quantity_of(1.5, 0.25), 1, "one", 3.0 },
                                  { quantity_none("not there"), -1, NULL, NAN },
                                  { quantity_of(2.5, 0.5), 0, "two", 4.0 } } };
    for (int i = 0; i < ROWS; i++)
        r->row[i].x = i;
    for (int i = 0; i < COLUMNS; i++)
        r->column[i].x = i;
}

static enum status write(const struct monitor *monitor, const char *path)
{
    const struct results all = { .table = tables, .asked = WANTED };
    struct results mine = all;
    struct fault why;
    struct store *st;
    struct run run;

    fill(&run);
    mine.run = &run;
    calls = 0;
    enum status s = store_create(path, "title", &st, &why);
    if (s == STATUS_OK)
        s = store_put_results(st, &mine, monitor);
    if (s == STATUS_OK)
        s = store_commit(st, &why);
    store_free(&st);
    return s;
}

static void a_grid_comes_in_blocks_of_rows_made_once(void **state)
{
    static double one[ROWS * COLUMNS], two[ROWS * COLUMNS];
    const char *path = own_path("results.h5");

    (void) state;
    assert_int_equal(write(NULL, path), STATUS_OK);
    assert_int_equal(calls, 3);
    const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    assert_true(H5LTread_dataset_double(file, "/grid/number", one) >= 0);
    assert_true(H5LTread_dataset_double(file, "/grid/twice", two) >= 0);
    for (int i = 0; i < ROWS * COLUMNS; i++)
        CHECK(one[i] == i && two[i] == 2 * i, "%d: %g %g", i, one[i], two[i]);
    H5Fclose(file);
}

static void attributes_without_a_value_are_left_out(void **state)
{
    static const char *const there[] = { "of_q_a", "of_q_a_error", "of_word_a",
                                         "of_text_a", "of_real_a" };
    const char *path = own_path("results.h5");
    double value;

    (void) state;
    assert_int_equal(write(NULL, path), STATUS_OK);
    const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    for (size_t i = 0; i < sizeof there / sizeof *there; i++)
        CHECK(H5Aexists_by_name(file, "/grid", there[i], H5P_DEFAULT) > 0, "%s",
              there[i]);
    for (size_t i = 0; i < sizeof there / sizeof *there; i++) {
        char name[32];
        snprintf(name, sizeof name, "%s", there[i]);
        name[strcspn(name + 3, "_") + 4] = 'b'; /* of_q_b */
        CHECK(H5Aexists_by_name(file, "/grid", name, H5P_DEFAULT) == 0, "%s",
              name);
    }
    H5LTget_attribute_double(file, "/grid", "of_q_c_error", &value);
    assert_true(value == 0.5);
    H5Fclose(file);
}

static void what_is_not_asked_or_not_there_has_no_group(void **state)
{
    const char *path = own_path("results.h5");
    double value[3];

    (void) state;
    assert_int_equal(write(NULL, path), STATUS_OK);
    const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    assert_true(H5Lexists(file, "/unwanted", H5P_DEFAULT) == 0);
    assert_true(H5Lexists(file, "/absent", H5P_DEFAULT) == 0);
    assert_true(H5LTread_dataset_double(file, "/number_c/q", value) >= 0);
    assert_true(value[0] == 2.5);
    assert_true(H5LTread_dataset_double(file, "/numbers/q_error", value) >= 0);
    assert_true(value[0] == 0.25 && isnan(value[1]) && value[2] == 0.5);
    H5Fclose(file);
}

static int at_once(void *ctx, const char *stage, uint64_t done, uint64_t total)
{
    (void) ctx, (void) stage, (void) total;
    return done > 0;
}

static void a_monitor_stops_between_blocks(void **state)
{
    const struct monitor stop = { .tell = at_once };

    (void) state;
    assert_int_equal(write(&stop, own_path("results.h5")), STATUS_STOPPED);
    assert_int_equal(calls, 2);
}

#define OWN(test)                                                              \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        OWN(a_grid_comes_in_blocks_of_rows_made_once),
        OWN(attributes_without_a_value_are_left_out),
        OWN(what_is_not_asked_or_not_there_has_no_group),
        OWN(a_monitor_stops_between_blocks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
