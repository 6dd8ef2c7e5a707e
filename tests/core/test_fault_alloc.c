#include "fault_alloc.h"

#include <string.h>

#include "check.h"
#include "curve.h"

/* volatile: the compiler may otherwise drop an allocation nobody reads. */
static void *volatile kept;

static void the_chosen_allocation_fails_once(void **state)
{
    (void) state;
    fault_alloc_at(2);
    for (int k = 0; k < 5; k++) {
        kept = k % 2 ? calloc(1, 8) : malloc(8);
        assert_int_equal(kept == NULL, k == 2);
        free(kept);
    }
    assert_int_equal(fault_alloc_count(), 5);
}

static void a_failed_realloc_leaves_the_block(void **state)
{
    char *volatile block = malloc(4);

    (void) state;
    assert_non_null(block);
    memcpy(block, "abc", 4);
    fault_alloc_at(0);
    kept = realloc(block, 400);
    assert_null(kept);
    assert_string_equal(block, "abc");
    free(block);
}

static void never_means_never(void **state)
{
    (void) state;
    fault_alloc_at(FAULT_ALLOC_NEVER);
    for (int k = 0; k < 100; k++) {
        kept = malloc(8);
        assert_non_null(kept);
        free(kept);
    }
}

/* Pieces 0, 1, 2, ..., each one number: its index. */
static enum status fill(struct curve *c, size_t pieces)
{
    for (size_t i = 0; i < pieces; i++) {
        double *coef;
        const enum status s = curve_push(c, 0, &coef);
        if (s != STATUS_OK)
            return s;
        *coef = (double) i;
    }
    return STATUS_OK;
}

static void every_allocation_of_a_curve_fails_once(void **state)
{
    enum status s = STATUS_NO_MEMORY;
    long k = 0;

    (void) state;
    for (; s != STATUS_OK; k++) {
        struct curve c = CURVE_EMPTY(1);
        fault_alloc_at(k);
        s = fill(&c, 1000);
        CHECK(s == STATUS_OK || s == STATUS_NO_MEMORY, "%s", status_text(s));
        CHECK(s == STATUS_OK || fault_alloc_count() == k + 1,
              "allocated after allocation %ld failed", k);
        CHECK(c.coefs == c.count, "%zu and %zu", c.coefs, c.count);
        for (size_t i = 0; i < c.count; i++)
            CHECK(*curve_component(&c, i, 0) == (double) i, "piece %zu", i);
        curve_free(&c);
    }
    CHECK(k > 2, "only %ld allocations were seen", k - 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_chosen_allocation_fails_once),
        cmocka_unit_test(a_failed_realloc_leaves_the_block),
        cmocka_unit_test(never_means_never),
        cmocka_unit_test(every_allocation_of_a_curve_fails_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
