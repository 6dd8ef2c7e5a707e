/* cells_find: threads, arguments, memory. */
#include <omp.h>

#include "cells_of.h"
#include "fault_alloc.h"

static void a_cell_is_the_same_alone_and_at_any_number_of_threads(void **state)
{
    enum { N = 300 };
    const int threads = omp_get_max_threads();
    static struct cell one[N], three[N];
    uint64_t rng = check_seed();
    struct vec2 z[N];
    struct slope s;
    struct cell c;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", steady_only);
    for (int i = 0; i < N; i++)
        z[i] = (struct vec2){ check_uniform(&rng, -10, 13),
                              check_uniform(&rng, -6, 6) };
    omp_set_num_threads(1);
    find(&s, z, N, 1e-3, ALL, one);
    omp_set_num_threads(3);
    find(&s, z, N, 1e-3, ALL, three);
    omp_set_num_threads(threads);
    for (int i = 0; i < N; i++)
        CHECK(same(&one[i], &three[i]), "cell %d", i);
    find(&s, &z[N - 1], 1, 1e-3, ALL, &c);
    assert_true(same(&c, &one[N - 1]));
    slope_free(&s);
}

static void wrong_arguments_leave_the_cells_untouched(void **state)
{
    static const double rtol[] = { 0.0, 1.0, -1.0, NAN };
    struct cell c[2] = { { .exit_reason = 77 }, { .exit_reason = 78 } };
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", steady_only);
    const struct vec2 z[] = { { 0.0, 0.0 }, { 700.0, 0.0 } };
    for (int i = 0; i < 4; i++)
        assert_int_equal(
            cells_find(&s.study.slider, z, 1, rtol[i], ALL, NULL, c),
            STATUS_BAD_ARGUMENT);
    assert_int_equal(cells_find(&s.study.slider, z, 2, 1e-6, ALL, NULL, c),
                     STATUS_BAD_ARGUMENT);
    assert_true(c[0].exit_reason == 77 && c[1].exit_reason == 78);
    assert_int_equal(cells_find(&s.study.slider, z, 0, 1e-6, ALL, NULL, c),
                     STATUS_OK);
    slope_free(&s);
}

struct hearing {
    uint64_t done;
    int calls, most;
};

static int hear(void *ctx, const char *stage, uint64_t done, uint64_t total)
{
    struct hearing *h = ctx;

    assert_string_equal(stage, "cells");
    assert_true(done > h->done && done <= total);
    h->done = done;
    return ++h->calls == h->most;
}

static void a_monitor_hears_of_cells_and_may_stop(void **state)
{
    enum { N = 600 };
    static struct vec2 z[N];
    static struct cell c[N];
    struct hearing all = { .most = -1 }, few = { .most = 2 };
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", steady_only);
    for (int i = 0; i < N; i++)
        z[i] = s.study.slider.plane.equilibrium[0].z;
    assert_int_equal(cells_find(&s.study.slider, z, N, 1e-3, 0,
                                &(struct monitor){ hear, &all }, c),
                     STATUS_OK);
    assert_int_equal(all.done, N);
    assert_int_equal(cells_find(&s.study.slider, z, N, 1e-3, 0,
                                &(struct monitor){ hear, &few }, c),
                     STATUS_STOPPED);
    assert_true(few.calls == 2 && few.done < N);
    slope_free(&s);
}

static void every_allocation_may_fail(void **state)
{
    const int threads = omp_get_max_threads();
    enum status status = STATUS_NO_MEMORY;
    struct slope s;
    struct cell c;
    long k = 0;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", steady_only);
    const struct vec2 z = slope_point(&s, 1.0, 0.05);
    omp_set_num_threads(1);
    for (; status == STATUS_NO_MEMORY; k++) {
        fault_alloc_at(k);
        status = cells_find(&s.study.slider, &z, 1, 1e-3, ALL, NULL, &c);
    }
    fault_alloc_at(FAULT_ALLOC_NEVER);
    omp_set_num_threads(threads);
    assert_int_equal(status, STATUS_OK);
    CHECK(k > 10, "%ld allocations", k);
    slope_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cell_is_the_same_alone_and_at_any_number_of_threads),
        cmocka_unit_test(wrong_arguments_leave_the_cells_untouched),
        cmocka_unit_test(a_monitor_hears_of_cells_and_may_stop),
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
