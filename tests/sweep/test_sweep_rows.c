/* Rows of points: sorted, found, grown. */
#include "sweep_rows.h"

#include <string.h>

#include "check.h"
#include "fault_alloc.h"

static void rows_are_found_where_they_are_and_nowhere_else(void **state)
{
    enum { COUNT = 200, COLUMNS = 9 };
    struct sweep_rows r = sweep_rows_of(COLUMNS, true);
    uint64_t seed = check_seed();

    (void) state;
    assert_int_equal(sweep_rows_find(&r, (double[2]){ 0 }), 0);
    for (size_t i = 0; i < COUNT; i++) {
        assert_int_equal(sweep_rows_add(&r, 1), STATUS_OK);
        sweep_rows_x(&r, i)[0] = (double) (check_bits(&seed) % 20);
        sweep_rows_x(&r, i)[1] = (double) i;
        for (size_t k = 0; k < COLUMNS; k++) {
            memset(sweep_rows_real(&r, i, k), 1, 3 * sizeof(double));
            *sweep_rows_code(&r, i, k) = (int8_t) (i % 100);
        }
    }
    sweep_rows_sort(&r);
    for (size_t i = 0; i < COUNT; i++) {
        const double *x = sweep_rows_x(&r, i);
        const double other[] = { x[0], x[1] + 0.5 };
        assert_int_equal(sweep_rows_find(&r, x), i);
        assert_int_equal(sweep_rows_find(&r, other), COUNT);
        assert_int_equal(*sweep_rows_code(&r, i, 8), (size_t) x[1] % 100);
        if (i > 0)
            assert_true(x[0] > sweep_rows_x(&r, i - 1)[0] ||
                        (x[0] == sweep_rows_x(&r, i - 1)[0] &&
                         x[1] > sweep_rows_x(&r, i - 1)[1]));
    }
    sweep_rows_free(&r);
    sweep_rows_free(&r);
}

static void a_failed_allocation_leaves_the_rows(void **state)
{
    struct sweep_rows r = sweep_rows_of(4, false);

    (void) state;
    assert_int_equal(sweep_rows_add(&r, 3), STATUS_OK);
    *sweep_rows_code(&r, 2, 3) = 7;
    fault_alloc_at(0);
    assert_int_equal(sweep_rows_add(&r, 1000), STATUS_NO_MEMORY);
    fault_alloc_at(FAULT_ALLOC_NEVER);
    assert_int_equal(r.count, 3);
    assert_int_equal(*sweep_rows_code(&r, 2, 3), 7);
    sweep_rows_free(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_are_found_where_they_are_and_nowhere_else),
        cmocka_unit_test(a_failed_allocation_leaves_the_rows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
