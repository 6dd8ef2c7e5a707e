/* What store_compare tells of two files. */
#include "store_compare.h"

#include <hdf5.h>
#include <string.h>

#include "check.h"
#include "fault_alloc.h"
#include "own_folder.h"
#include "sample_store.h"

struct told {
    char text[512];
    size_t count;
};

static void hear(void *ctx, const struct store_difference *d)
{
    struct told *t = ctx;
    const size_t n = strlen(t->text);

    snprintf(t->text + n, sizeof t->text - n, "%s|%s|%s\n", d->path, d->key,
             d->what);
    t->count++;
}

static enum status compare(const char *a, const char *b, struct told *t,
                           struct fault *why)
{
    struct store *x = NULL, *y = NULL;
    enum status s = store_open(a, &x, why);

    *t = (struct told){ .count = 0 };
    if (s == STATUS_OK)
        s = store_open(b, &y, why);
    if (s == STATUS_OK)
        s = store_compare(x, y, hear, t, why);
    store_free(&x);
    store_free(&y);
    sample_no_handles();
    return s;
}

static hid_t change(const char *path)
{
    const hid_t file = H5Fopen(path, H5F_ACC_RDWR, H5P_DEFAULT);
    assert_true(file >= 0);
    return file;
}

static void expect_told(const char *a, const char *b, const char *text)
{
    struct told t;
    struct fault why = { "" };

    assert_int_equal(compare(a, b, &t, &why), STATUS_OK);
    assert_string_equal(t.text, text);
}

static void the_same_calls_make_files_that_do_not_differ(void **state)
{
    const char *a = own_path("a.h5"), *b = own_path("b.h5");

    (void) state;
    sample_must_write(a);
    sample_must_write(b);
    expect_told(a, b, "");
}

static void one_other_value_is_counted(void **state)
{
    const char *a = own_path("a.h5"), *b = own_path("b.h5");
    double v[2] = { 0.0 };

    (void) state;
    sample_must_write(a);
    sample_must_write(b);
    const hid_t file = change(b);
    const hid_t set = H5Dopen2(file, "/equilibria/v", H5P_DEFAULT);
    assert_true(H5Dread(set, H5T_NATIVE_DOUBLE, 0, 0, 0, v) >= 0);
    v[1] = v[1] * 1.000001 + 1e-300;
    assert_true(H5Dwrite(set, H5T_NATIVE_DOUBLE, 0, 0, 0, v) >= 0);
    H5Dclose(set);
    H5Fclose(file);
    expect_told(
        a, b,
        "/equilibria/v||1 of 2 values differ, by up to 1.0e-06 of them\n");
}

static void another_text_is_shown_beside_the_first(void **state)
{
    const char *a = own_path("a.h5"), *b = own_path("b.h5");

    (void) state;
    sample_must_write(a);
    sample_must_write(b);
    const hid_t file = change(b), type = H5Tcopy(H5T_C_S1);
    const hid_t space = H5Screate(H5S_SCALAR);
    const hid_t group = H5Gopen2(file, "/provenance", H5P_DEFAULT);
    H5Tset_size(type, 3);
    H5Adelete(group, "version");
    const hid_t text = H5Acreate2(group, "version", type, space, 0, 0);
    assert_true(H5Awrite(text, type, "2.0") >= 0);
    H5Aclose(text);
    H5Gclose(group);
    H5Sclose(space);
    H5Tclose(type);
    H5Fclose(file);
    expect_told(a, b, "/provenance|version|'1' and '2.0'\n");
}

static void what_one_file_lacks_is_told_of_either_side(void **state)
{
    const char *a = own_path("a.h5"), *b = own_path("b.h5");

    (void) state;
    sample_must_write(a);
    sample_must_write(b);
    const hid_t file = change(b);
    H5Ldelete(file, "/critical", H5P_DEFAULT);
    H5Adelete_by_name(file, "/provenance", "version", H5P_DEFAULT);
    H5Fclose(file);
    struct told t;
    struct fault why = { "" };
    assert_int_equal(compare(a, b, &t, &why), STATUS_OK);
    assert_non_null(strstr(t.text, "/critical||only in the first\n"));
    assert_non_null(strstr(t.text, "/provenance|version|only in the first\n"));
    assert_int_equal(compare(b, a, &t, &why), STATUS_OK);
    assert_non_null(strstr(t.text, "/critical||only in the second\n"));
    assert_non_null(strstr(t.text, "/provenance|version|only in the second\n"));
}

static void a_group_in_place_of_a_data_set_is_told(void **state)
{
    const char *a = own_path("a.h5"), *b = own_path("b.h5");

    (void) state;
    sample_must_write(a);
    sample_must_write(b);
    const hid_t file = change(b);
    H5Ldelete(file, "/equilibria/mu", H5P_DEFAULT);
    H5Ldelete(file, "/equilibria/v", H5P_DEFAULT);
    H5Gclose(H5Gcreate2(file, "/equilibria/v", 0, 0, 0));
    H5Fclose(file);
    struct told t;
    struct fault why = { "" };
    assert_int_equal(compare(a, b, &t, &why), STATUS_OK);
    assert_non_null(strstr(
        t.text, "/equilibria/v||a group in one, a data set in the other\n"));
}

static void another_shape_is_told(void **state)
{
    const char *a = own_path("a.h5"), *b = own_path("b.h5");
    const hsize_t three = 3;

    (void) state;
    sample_must_write(a);
    sample_must_write(b);
    const hid_t file = change(b), space = H5Screate_simple(1, &three, NULL);
    H5Ldelete(file, "/equilibria/v", H5P_DEFAULT);
    H5Dclose(H5Dcreate2(file, "/equilibria/v", H5T_IEEE_F64LE, space, 0, 0, 0));
    H5Sclose(space);
    H5Fclose(file);
    struct told t;
    struct fault why = { "" };
    assert_int_equal(compare(a, b, &t, &why), STATUS_OK);
    assert_non_null(strstr(t.text, "/equilibria/v||another shape\n"));
}

static void any_allocation_may_fail(void **state)
{
    const char *a = own_path("a.h5"), *b = own_path("b.h5");
    enum status s = STATUS_NO_MEMORY;
    long k = 0;

    (void) state;
    sample_must_write(a);
    sample_must_write(b);
    for (; s != STATUS_OK; k++) {
        struct told t;
        struct fault why = { "" };
        fault_alloc_at(k);
        s = compare(a, b, &t, &why);
        const bool failed = fault_alloc_count() > k;
        fault_alloc_at(FAULT_ALLOC_NEVER);
        CHECK(s == (failed ? STATUS_NO_MEMORY : STATUS_OK), "%ld", k);
        CHECK(!failed || strstr(why.text, ".h5: out of memory"), "%s",
              why.text);
        CHECK(t.count == 0, "%ld: %s", k, t.text);
    }
    CHECK(k > 100, "only %ld allocations", k);
}

int main(void)
{
#define CASE(test)                                                             \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)
    const struct CMUnitTest tests[] = {
        CASE(the_same_calls_make_files_that_do_not_differ),
        CASE(one_other_value_is_counted),
        CASE(another_text_is_shown_beside_the_first),
        CASE(what_one_file_lacks_is_told_of_either_side),
        CASE(a_group_in_place_of_a_data_set_is_told),
        CASE(another_shape_is_told),
        CASE(any_allocation_may_fail),
    };
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
