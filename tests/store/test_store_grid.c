/* Cubes of up to four axes, written a slab at a time, as HDF5 reads them. */
#include "store_grid.h"

#include <hdf5.h>
#include <hdf5_hl.h>
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "own_folder.h"
#include "sample_store.h"
#include "tolerance.h"

enum { RANK = 4 };

static const char *const axis[RANK] = { "b", "c", "psi", "v" };

static const struct record_field slip = {
    .name = "slip", .unit = "1", .text = "slip", .kind = RECORD_REAL
};
static const char *const fates[] = { "stays", "goes", NULL };
static const struct record_field fate = { .name = "fate",
                                          .unit = "1",
                                          .text = "what it does",
                                          .kind = RECORD_CODE,
                                          .codes = fates };

/* Of a cell by its number from the first on; the last slab of each is left
 * out. */
static double slip_of(size_t i)
{
    return 0.5 + (double) i;
}

static int8_t fate_of(size_t i)
{
    return (int8_t) (i / 3 % 2);
}

/* All slabs of the first `fixed` indices but the last. */
static void put_slabs(struct store *st, const size_t extent[RANK], size_t fixed)
{
    size_t slabs = 1, size = 1;

    for (size_t k = 0; k < RANK; k++)
        *(k < fixed ? &slabs : &size) *= extent[k];
    double *x = malloc(size * sizeof *x);
    int8_t *code = malloc(size);
    for (size_t s = 0; s + 1 < slabs; s++) {
        size_t at[RANK], rest = s;
        for (size_t k = fixed; k-- > 0; rest /= extent[k])
            at[k] = rest % extent[k];
        for (size_t i = 0; i < size; i++) {
            x[i] = slip_of(s * size + i);
            code[i] = fate_of(s * size + i);
        }
        assert_int_equal(store_put_slab(st, "/sweep", &slip, fixed, at, x),
                         STATUS_OK);
        assert_int_equal(store_put_slab(st, "/sweep", &fate, fixed, at, code),
                         STATUS_OK);
    }
    free(x);
    free(code);
}

static void write_cubes(const char *path, const size_t extent[RANK],
                        size_t fixed)
{
    struct store *st;
    struct fault fault;

    assert_int_equal(store_create(path, "cubes", &st, &fault), STATUS_OK);
    for (size_t k = 0; k < RANK; k++) {
        double *x = malloc(extent[k] * sizeof *x);
        for (size_t i = 0; i < extent[k]; i++)
            x[i] = (double) i;
        (void) !store_put_axis(st, "/sweep", axis[k], "1", "an axis", extent[k],
                               x);
        free(x);
    }
    (void) !store_put_cube(st, "/sweep", &slip, RANK, axis);
    (void) !store_put_cube(st, "/sweep", &fate, RANK, axis);
    put_slabs(st, extent, fixed);
    CHECK(store_commit(st, &fault) == STATUS_OK, "%s", fault.text);
    store_free(&st);
    sample_no_handles();
}

/* The axes of a data set, by name. */
static void check_axes(hid_t file, hid_t set)
{
    for (unsigned k = 0; k < RANK; k++) {
        char path[32];
        snprintf(path, sizeof path, "/sweep/%s", axis[k]);
        const hid_t scale = H5Dopen2(file, path, H5P_DEFAULT);
        assert_true(H5DSis_scale(scale) > 0);
        assert_true(H5DSis_attached(set, scale, k) > 0);
        H5Dclose(scale);
    }
}

static void check_cells(hid_t file, size_t cells, size_t slab)
{
    const hid_t x = H5Dopen2(file, "/sweep/slip", H5P_DEFAULT);
    const hid_t code = H5Dopen2(file, "/sweep/fate", H5P_DEFAULT);
    double *value = malloc(cells * sizeof *value);
    int8_t *word = malloc(cells);

    check_axes(file, x);
    check_axes(file, code);
    assert_true(H5Dread(x, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                        value) >= 0);
    assert_true(H5Dread(code, H5T_NATIVE_INT8, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                        word) >= 0);
    for (size_t i = 0; i < cells; i++) {
        const bool left_out = i >= cells - slab;
        CHECK(left_out ? isnan(value[i]) : value[i] == slip_of(i), "%zu: %g", i,
              value[i]);
        CHECK(word[i] == (left_out ? -1 : fate_of(i)), "%zu: %d", i, word[i]);
    }
    free(value);
    free(word);
    H5Dclose(x);
    H5Dclose(code);
}

static bool is_compressed(hid_t file)
{
    const hid_t set = H5Dopen2(file, "/sweep/slip", H5P_DEFAULT);
    const hid_t list = H5Dget_create_plist(set);
    const bool chunked = H5Pget_layout(list) == H5D_CHUNKED;
    hsize_t chunk[RANK];

    if (chunked) {
        assert_int_equal(H5Pget_chunk(list, RANK, chunk), RANK);
        assert_true(chunk[0] == 1 && chunk[1] == 1);
    }
    H5Pclose(list);
    H5Dclose(set);
    return chunked;
}

static void slabs_are_where_they_were_put(void **state)
{
    static const size_t extent[][RANK] = { { 2, 3, 5, 7 },
                                           { 3, 2, 40, 30 },
                                           { 1, 2, 300, 260 } };

    (void) state;
    for (size_t i = 0; i < sizeof extent / sizeof *extent; i++)
        for (size_t fixed = 1; fixed < RANK; fixed++) {
            const char *path = own_path("cubes.h5");
            size_t cells = 1, slab = 1;
            for (size_t k = 0; k < RANK; k++) {
                cells *= extent[i][k];
                slab *= k < fixed ? 1 : extent[i][k];
            }
            if (cells / slab > 5000)
                continue;
            write_cubes(path, extent[i], fixed);
            const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
            check_cells(file, cells, slab);
            assert_int_equal(is_compressed(file), cells >= STORE_LARGE);
            H5Fclose(file);
        }
}

static void an_axis_that_was_not_put_is_told(void **state)
{
    static const char *const names[] = { "b", "nowhere" };
    const double one = 1.0;
    struct store *st;
    struct fault fault;

    (void) state;
    assert_int_equal(store_create(own_path("a.h5"), "cubes", &st, &fault),
                     STATUS_OK);
    assert_int_equal(store_put_axis(st, "/sweep", "b", "1", "b", 1, &one),
                     STATUS_OK);
    assert_int_equal(store_put_cube(st, "/sweep", &slip, 2, names), STATUS_IO);
    assert_int_equal(store_commit(st, &fault), STATUS_IO);
    store_free(&st);
    sample_no_handles();
    assert_int_equal(own_folder_entries(), 0);
}

#define TEST(name)                                                             \
    cmocka_unit_test_setup_teardown(name, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(slabs_are_where_they_were_put),
        TEST(an_axis_that_was_not_put_is_told),
    };
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
