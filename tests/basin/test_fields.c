/* Fields over the grid of the basin map. */
#include "fields_of.h"

#include "fault_alloc.h"
#include "slope.h"

#define GRID "window={v: [1e-3, 1e5], psi: [1e-3, 10]}"

enum { COLUMNS = 24, ROWS = 70, N = COLUMNS * ROWS };

static const char *const small[] = { "products=[slip, friction]", GRID,
                                     "basins={cells: [24, 70], audit: 0, rtol: "
                                     "1e-4}",
                                     NULL };

static void products_say_which_fields(void **state)
{
    static const struct {
        const char *products;
        unsigned which;
    } ask[] = {
        { "products=[basins]", 0 },
        { "products=[slip]", 1u << CELL_SLIP },
        { "products=[time]", 1u << CELL_TIME },
        { "products=[friction]", 1u << CELL_MU_MEAN },
        { "products=[peak]", 1u << CELL_V_PEAK | 1u << CELL_MU_PEAK },
        { "products=[peak, slip, time, friction]", (1u << CELL_FIELDS) - 1 },
    };

    (void) state;
    for (size_t i = 0; i < sizeof ask / sizeof *ask; i++) {
        const char *const more[] = { ask[i].products, small[2], NULL };
        struct slope s;
        slope_make(&s, "spinodal_gen", NULL, "0.34", more);
        CHECK(s.study.fields.which == ask[i].which, "%s: %x", ask[i].products,
              s.study.fields.which);
        CHECK(s.study.cost[STAGE_FIELDS].ran == (ask[i].which != 0), "%s",
              ask[i].products);
        slope_free(&s);
    }
}

static void a_cell_of_the_grid_is_that_of_its_centre(void **state)
{
    static struct cell all[N], part[6 * COLUMNS];
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", small);
    const struct basin_map *m = &s.study.basins;
    const struct fields *f = &s.study.fields;
    assert_int_equal(fields_find(f, 0, ROWS, NULL, all), STATUS_OK);
    assert_int_equal(fields_find(f, 61, 6, NULL, part), STATUS_OK);
    for (size_t i = 0; i < 6 * COLUMNS; i++)
        CHECK(all[61 * COLUMNS + i].slip == part[i].slip, "cell %zu", i);
    for (size_t i = 0; i < N; i += 23) {
        const struct vec2 z = { log(m->v[i % COLUMNS]),
                                log(m->psi[i / COLUMNS]) };
        struct fate_result r;
        assert_int_equal(fate_find(&s.study.slider, z, 1e-12, true, NULL, &r),
                         0);
        CHECK(r.fate == (enum fate) all[i].exit_reason, "cell %zu", i);
        CHECK(fabs(r.slip.value - all[i].slip) <=
                      all[i].slip_error + r.slip.error &&
                  fabs(r.mu_mean.value - all[i].mu_mean) <=
                      all[i].mu_mean_error + r.mu_mean.error &&
                  all[i].slip_error <= 1e-4 * all[i].slip && isnan(all[i].time),
              "cell %zu: %g +- %g", i, all[i].slip, all[i].slip_error);
    }
    slope_free(&s);
}

static void a_raster_shows_the_window_of_the_grid(void **state)
{
    static struct cell cell[N], raster[N];
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", small);
    assert_int_equal(fields_find(&s.study.fields, 0, ROWS, NULL, cell),
                     STATUS_OK);
    assert_int_equal(
        fields_raster(&s.study.fields, COLUMNS, ROWS, NULL, raster), STATUS_OK);
    for (int i = 0; i < N; i++)
        CHECK(fabs(raster[i].slip / cell[i].slip - 1.0) < 1e-3 &&
                  isnan(raster[i].v_peak),
              "%d: %g, %g", i, raster[i].slip, cell[i].slip);
    assert_int_equal(fields_raster(&s.study.fields, 3, 2, NULL, raster),
                     STATUS_OK);
    CHECK(raster[2].slip > raster[0].slip, "%g, %g", raster[2].slip,
          raster[0].slip);
    slope_free(&s);
}

/* Its slip grows without bound, and what runs away has none. */
static void what_no_cell_has_costs_nothing(void **state)
{
    static struct cell cell[N];
    struct slope s;

    (void) state;
    slope_make(&s, "ruina", NULL, "0.34", small);
    CHECK(s.study.fields.patches.sampled == 0, "%zu states",
          s.study.fields.patches.sampled);
    assert_int_equal(fields_find(&s.study.fields, 0, ROWS, NULL, cell),
                     STATUS_OK);
    for (int i = 0; i < N; i++)
        CHECK((cell[i].exit_reason == FATE_REST_ASYMPTOTIC ||
               cell[i].exit_reason == FATE_RUNAWAY) &&
                  isnan(cell[i].slip) && isnan(cell[i].mu_mean),
              "cell %d: %g", i, cell[i].slip);
    slope_free(&s);
}

static int stop(void *ctx, const char *stage, uint64_t done, uint64_t total)
{
    int *calls = ctx;

    assert_string_equal(stage, "cells");
    CHECK(done == (PATCHWORK_TILE + 3) * COLUMNS && total == N, "%g of %g",
          (double) done, (double) total);
    return ++*calls;
}

static void a_monitor_hears_of_the_whole_grid(void **state)
{
    static struct cell cell[6 * COLUMNS];
    struct slope s;
    int calls = 0;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", small);
    assert_int_equal(fields_find(&s.study.fields, PATCHWORK_TILE, 3,
                                 &(struct monitor){ stop, &calls }, cell),
                     STATUS_STOPPED);
    assert_int_equal(calls, 1);
    slope_free(&s);
}

static void allocations_may_fail(void **state)
{
    enum status status = STATUS_NO_MEMORY;
    struct slope s;
    struct cell raster[1];
    long k = 0;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", small);
    for (; status == STATUS_NO_MEMORY; k++) {
        fault_alloc_at(k);
        status = fields_raster(&s.study.fields, 1, 1, NULL, raster);
    }
    fault_alloc_at(FAULT_ALLOC_NEVER);
    assert_int_equal(status, STATUS_OK);
    CHECK(k > 4, "%ld allocations", k);
    slope_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(products_say_which_fields),
        cmocka_unit_test(a_cell_of_the_grid_is_that_of_its_centre),
        cmocka_unit_test(a_raster_shows_the_window_of_the_grid),
        cmocka_unit_test(what_no_cell_has_costs_nothing),
        cmocka_unit_test(a_monitor_hears_of_the_whole_grid),
        cmocka_unit_test(allocations_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
