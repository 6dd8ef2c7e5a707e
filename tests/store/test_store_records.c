/* What other programs find in a file. */
#include "store_records.h"

#include <hdf5.h>
#include <hdf5_hl.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "own_folder.h"
#include "sample_store.h"

static void every_reader_opens_the_sample(void **state)
{
    const char *root = getenv("SOURCE_ROOT");
    const char *path = own_path("out.h5");
    char command[1024];

    (void) state;
    if (root == NULL)
        skip();
    sample_must_write(path);
    snprintf(command, sizeof command,
             "/usr/bin/python3 '%s/tests/open_file.py' '%s' >&2", root, path);
    assert_int_equal(system(command), 0);
}

static herr_t is_tied(hid_t set, unsigned dimension, hid_t axis, void *ctx)
{
    int *ties = ctx;

    assert_int_equal(H5DSis_attached(set, axis, dimension), 1);
    ++*ties;
    return 0;
}

static herr_t count_ties(hid_t root, const char *name, const H5O_info_t *info,
                         void *ctx)
{
    const hid_t set = H5Oopen(root, name, H5P_DEFAULT);
    int *ties = ctx;

    if (info->type == H5O_TYPE_DATASET && H5DSis_scale(set) == 0) {
        const hid_t space = H5Dget_space(set);
        const int rank = H5Sget_simple_extent_ndims(space);
        const int before = *ties;
        for (int i = 0; i < rank; i++)
            H5DSiterate_scales(set, (unsigned) i, NULL, is_tied, ties);
        CHECK(*ties == before + rank, "%s", name);
        H5Sclose(space);
    }
    H5Oclose(set);
    return 0;
}

static void every_data_set_knows_its_axes_and_they_know_it(void **state)
{
    int ties = 0;
    hid_t file;

    (void) state;
    sample_must_write(own_path("out.h5"));
    file = H5Fopen(own_path("out.h5"), H5F_ACC_RDONLY, H5P_DEFAULT);
    H5Ovisit2(file, H5_INDEX_CRT_ORDER, H5_ITER_INC, count_ties, &ties,
              H5O_INFO_BASIC);
    H5Fclose(file);
    assert_int_equal(ties, SAMPLE_TIES);
}

static void read_set(const char *name, hid_t type, void *values)
{
    const hid_t file = H5Fopen(own_path("out.h5"), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t set = H5Dopen2(file, name, H5P_DEFAULT);
    assert_true(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
    H5Dclose(set);
    H5Fclose(file);
}

static void columns_hold_what_the_records_held(void **state)
{
    double v[2], lambda[2], error[2], conditioning[2], arc[SAMPLE_POINTS];
    double lo[2], hi[2];
    int8_t type[2], exists[2], proved[2], scalar_type;
    int64_t rank[2], n[2];

    (void) state;
    sample_must_write(own_path("out.h5"));
    read_set("/equilibria/v", H5T_NATIVE_DOUBLE, v);
    read_set("/equilibria/lambda", H5T_NATIVE_DOUBLE, lambda);
    read_set("/equilibria/lambda_error", H5T_NATIVE_DOUBLE, error);
    read_set("/equilibria/lambda_conditioning", H5T_NATIVE_DOUBLE,
             conditioning);
    read_set("/equilibria/lambda_exists", H5T_NATIVE_INT8, exists);
    read_set("/equilibria/lambda_lo", H5T_NATIVE_DOUBLE, lo);
    read_set("/equilibria/lambda_hi", H5T_NATIVE_DOUBLE, hi);
    read_set("/equilibria/lambda_proved", H5T_NATIVE_INT8, proved);
    read_set("/equilibria/type", H5T_NATIVE_INT8, type);
    read_set("/equilibria/rank", H5T_NATIVE_INT64, rank);
    read_set("/equilibria/n", H5T_NATIVE_INT64, n);
    read_set("/manifold/stable_lower/arc", H5T_NATIVE_DOUBLE, arc);
    read_set("/absent/type", H5T_NATIVE_INT8, &scalar_type);
    assert_true(v[0] == 0.25 && v[1] == 4.0);
    assert_true(lambda[0] == 1.5 && isnan(lambda[1]));
    assert_true(error[0] == 1e-9 && isnan(error[1]));
    assert_true(conditioning[0] == 2e-15 && isnan(conditioning[1]));
    assert_true(exists[0] == 1 && exists[1] == 0);
    assert_true(lo[0] == 1.25 && hi[0] == 1.75 && proved[0] == 1);
    assert_true(isnan(lo[1]) && isnan(hi[1]) && proved[1] == 0);
    assert_true(type[0] == 0 && type[1] == -1 && scalar_type == -1);
    assert_true(rank[0] == 7 && rank[1] == 8 && n[0] == 0 && n[1] == 1);
    for (int i = 0; i < SAMPLE_POINTS; i++)
        CHECK(arc[i] == i + 0.03, "arc[%d] = %g", i, arc[i]);
}

static void texts_are_stored_in_utf_8(void **state)
{
    char *note[2], *reason[2], *why[2];
    hid_t type;

    (void) state;
    sample_must_write(own_path("out.h5"));
    type = H5Tcopy(H5T_C_S1);
    H5Tset_cset(type, H5T_CSET_UTF8);
    H5Tset_size(type, H5T_VARIABLE);
    read_set("/equilibria/note", type, note);
    read_set("/equilibria/lambda_reason", type, reason);
    read_set("/equilibria/lambda_not_proved", type, why);
    H5Tclose(type);
    assert_string_equal(note[0], "Gr\xc3\xbc\xc3\x9f");
    assert_string_equal(note[1], "");
    assert_string_equal(reason[0], "");
    assert_string_equal(reason[1], "no window");
    assert_string_equal(why[0], "");
    assert_string_equal(why[1], "no tube");
    for (int i = 0; i < 2; i++) {
        H5free_memory(note[i]);
        H5free_memory(reason[i]);
    }
}

static void a_grid_keeps_its_rows_and_fills_the_rest(void **state)
{
    static double cell[SAMPLE_ROWS][SAMPLE_COLUMNS];
    static int8_t code[SAMPLE_ROWS][SAMPLE_COLUMNS];

    (void) state;
    sample_must_write(own_path("out.h5"));
    read_set("/basin/margin", H5T_NATIVE_DOUBLE, cell);
    read_set("/basin/label", H5T_NATIVE_INT8, code);
    for (size_t i = 0; i + 1 < SAMPLE_ROWS; i++)
        for (size_t j = 0; j < SAMPLE_COLUMNS; j++) {
            CHECK(cell[i][j] == sample_margin(i, j), "[%zu][%zu] %g", i, j,
                  cell[i][j]);
            CHECK(code[i][j] == (int8_t) (j % 2), "[%zu][%zu]", i, j);
        }
    assert_true(isnan(cell[SAMPLE_ROWS - 1][0]) &&
                code[SAMPLE_ROWS - 1][0] == -1);
}

#define TEST(name)                                                             \
    cmocka_unit_test_setup_teardown(name, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(every_reader_opens_the_sample),
        TEST(every_data_set_knows_its_axes_and_they_know_it),
        TEST(columns_hold_what_the_records_held),
        TEST(texts_are_stored_in_utf_8),
        TEST(a_grid_keeps_its_rows_and_fills_the_rest),
    };
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
