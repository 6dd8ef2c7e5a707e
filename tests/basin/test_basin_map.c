/* Basin maps of the laws: labels, shares, audit. */
#include "basin_map.h"

#include <omp.h>

#include "fault_alloc.h"
#include "slope.h"

#define SET(...)                                                               \
    ((const char *const[]){ "products=[basins]", __VA_ARGS__, NULL })

/* The default window on a few cells, audited by nobody. */
#define FEW       SET("basins={cells: [61, 53], audit: 0}")
#define FEW_EXACT SET("basins={cells: [61, 53], audit: 0, exact: true}")

static int8_t *labels_of(const struct basin_map *m)
{
    int8_t *label = malloc(m->columns * m->rows);

    assert_non_null(label);
    assert_int_equal(basin_map_rows(m, 0, m->rows, label), STATUS_OK);
    return label;
}

/* ---- reference ----------------------------------------------------------- */

static void check_row(struct slope *s, const struct csv *c)
{
    struct fate_told label;

    assert_int_equal(labels_find(&s->study.basins.labels,
                                 vec2_sub(row_point(s, c),
                                          s->study.slider.plane.system.origin),
                                 NULL, &label),
                     STATUS_OK);
    CHECK(label.fate == row_fate(c), "row %zu: %s", c->row,
          fate_names[label.fate]);
}

/* Its states lie down to psi = 1e-4. */
static void every_reference_state_is_on_its_side_of_the_separatrix(void **state)
{
    (void) state;
    const int rows = each_basin_row(
        0.0, SET("basins={cells: [4, 4], audit: 0}", "window.psi=[1e-4, 1e3]"),
        check_row);
    assert_int_equal(rows, 465);
}

/* ---- cells --------------------------------------------------------------- */

/* One row after another, in any number of threads. */
static void rows_are_the_same_alone_together_and_in_threads(void **state)
{
    const int threads = omp_get_max_threads();
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34",
               SET("basins={cells: [7, 9001], audit: 0}"));
    const struct basin_map *m = &s.study.basins;
    omp_set_num_threads(1);
    int8_t *one = labels_of(m);
    omp_set_num_threads(3);
    int8_t *three = labels_of(m);
    assert_memory_equal(one, three, m->columns * m->rows);
    omp_set_num_threads(threads);
    for (size_t j = 0; j < m->rows; j += 100) {
        int8_t row[7];
        assert_int_equal(basin_map_rows(m, j, 1, row), STATUS_OK);
        assert_memory_equal(row, one + j * m->columns, m->columns);
    }
    free(one);
    free(three);
    slope_free(&s);
}

static void exact_rows_are_the_same_in_threads(void **state)
{
    const int threads = omp_get_max_threads();
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", FEW_EXACT);
    omp_set_num_threads(1);
    int8_t *one = labels_of(&s.study.basins);
    omp_set_num_threads(3);
    int8_t *three = labels_of(&s.study.basins);
    omp_set_num_threads(threads);
    assert_memory_equal(one, three, 61 * 53);
    free(one);
    free(three);
    slope_free(&s);
}

/* How far the cell is from another fate along its row or its column. */
static double distance(const struct basin_map *m, size_t cell)
{
    double *v = malloc(m->columns * sizeof *v);
    double *psi = malloc(m->columns * sizeof *psi);

    assert_true(v && psi);
    assert_int_equal(basin_map_margins(m, cell / m->columns, 1, v, psi),
                     STATUS_OK);
    const double found =
        fmin(fabs(v[cell % m->columns]), fabs(psi[cell % m->columns]));
    free(v);
    free(psi);
    return found;
}

/* The same map from both sides that share nothing but the field. */
static void compare(const char *law, const char *alpha)
{
    struct slope cut, exact;

    slope_make(&cut, law, NULL, alpha, FEW);
    slope_make(&exact, law, NULL, alpha, FEW_EXACT);
    int8_t *a = labels_of(&cut.study.basins),
           *b = labels_of(&exact.study.basins);
    for (size_t i = 0; i < 61 * 53; i++)
        CHECK(a[i] == b[i] || distance(&cut.study.basins, i) < 1e-6,
              "%s, cell %zu: %d by the separatrix, %d by its orbit", law, i,
              a[i], b[i]);
    free(a);
    free(b);
    slope_free(&cut);
    slope_free(&exact);
}

static void cells_have_the_fates_of_their_orbits(void **state)
{
    (void) state;
    compare("spinodal_gen", "0.34");
    compare("spinodal_gen", "0.30");
    compare("dieterich_gen", "0.34");
    compare("spinodal", "0.34");
}

static void without_a_saddle_there_is_one_fate(void **state)
{
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.28", FEW);
    int8_t *label = labels_of(&s.study.basins);
    for (size_t i = 0; i < 61 * 53; i++)
        assert_int_equal(label[i], FATE_CREEP);
    assert_true(s.study.basins.fraction[FATE_CREEP].log.value == 1.0);
    assert_true(isinf(distance(&s.study.basins, 0)));
    free(label);
    slope_free(&s);
}

/* ---- shares -------------------------------------------------------------- */

static void fractions_sum_to_one_and_are_those_of_cells(void **state)
{
    static const char *const law[] = { "spinodal_gen", "dieterich_gen",
                                       "spinodal" };

    (void) state;
    for (int k = 0; k < 3; k++) {
        struct slope s;
        slope_make(&s, law[k], NULL, "0.34",
                   SET("basins={cells: [500, 500], audit: 0}"));
        const struct basin_map *m = &s.study.basins;
        int8_t *label = labels_of(m);
        double log_sum = 0.0, linear_sum = 0.0, counted[FATES] = { 0.0 };
        for (size_t i = 0; i < m->columns * m->rows; i++)
            counted[label[i]] += 1.0 / 250000.0;
        for (int i = 0; i < FATES; i++) {
            const struct quantity *q = &m->fraction[i].log;
            CHECK(fabs(q->value - counted[i]) < 1.0 / 500.0, "%s: %g, not %g",
                  fate_names[i], q->value, counted[i]);
            assert_true(q->error >= 0.0 && q->error < 1e-9);
            log_sum += q->value;
            linear_sum += m->fraction[i].linear.value;
        }
        CHECK(fabs(log_sum - 1.0) < 1e-12, "%.17g", log_sum);
        CHECK(fabs(linear_sum - 1.0) < 1e-12, "%.17g", linear_sum);
        free(label);
        slope_free(&s);
    }
}

/* ---- margins ------------------------------------------------------------- */

/* A step across the margin changes the label, one short of it does not. */
static void margins_lead_onto_the_boundary(void **state)
{
    struct slope s;
    size_t crossed = 0;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", FEW);
    const struct basin_map *m = &s.study.basins;
    const struct regions *r = &m->labels.regions;
    double v[61], psi[61];
    struct crossing at[8];
    assert_true(r->most < 8);
    for (size_t j = 0; j < m->rows; j++) {
        assert_int_equal(basin_map_margins(m, j, 1, v, psi), STATUS_OK);
        for (size_t i = 0; i < m->columns; i++) {
            const struct vec2 z = { m->dx[i], m->dy[j] };
            const int8_t label = r->region[regions_at(r, z, at)].label;
            for (double part = 0.999999; part < 1.1; part += 2e-6) {
                const struct vec2 push = { z.x + part * v[i], z.y };
                if (isinf(v[i]) || part > 1.000002)
                    break;
                crossed++;
                CHECK((r->region[regions_at(r, push, at)].label == label) ==
                          (part < 1.0),
                      "(%g, %g): %g", z.x, z.y, v[i]);
            }
        }
    }
    CHECK(crossed > 1000, "%zu", crossed);
    slope_free(&s);
}

/* ---- audit --------------------------------------------------------------- */

static void an_audit_agrees_unless_a_label_is_wrong(void **state)
{
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", SET("basins.audit=300"));
    struct basin_map *m = &s.study.basins;
    assert_int_equal(m->audit.cells, 300);
    assert_int_equal(m->audit.disagreements, 0);
    const double share = m->fraction[FATE_CREEP].log.value;
    for (size_t i = 0; i < m->labels.regions.count; i++)
        if (m->labels.regions.region[i].label == FATE_CREEP)
            m->labels.regions.region[i].label = FATE_RUNAWAY;
    assert_int_equal(basin_map_audit(m, 300, 7, NULL), STATUS_OK);
    const double wrong = (double) m->audit.disagreements / 300.0;
    CHECK(fabs(wrong - share) < 0.1, "%g, not %g", wrong, share);
    for (size_t i = 0; i < m->audit.disagreements; i++) {
        int8_t row[512];
        const size_t cell = m->audit.wrong[i];
        assert_int_equal(basin_map_rows(m, cell / 512, 1, row), STATUS_OK);
        assert_int_equal(row[cell % 512], FATE_RUNAWAY);
    }
    slope_free(&s);
}

static void the_seed_and_nothing_else_chooses_the_cells(void **state)
{
    const int threads = omp_get_max_threads();
    size_t wrong[3][64];
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", FEW);
    struct basin_map *m = &s.study.basins;
    for (size_t i = 0; i < m->labels.regions.count; i++)
        m->labels.regions.region[i].label = FATE_RUNAWAY;
    for (int run = 0; run < 3; run++) {
        omp_set_num_threads(run == 1 ? 3 : 1);
        assert_int_equal(basin_map_audit(m, 64, run == 2 ? 8 : 7, NULL),
                         STATUS_OK);
        assert_int_equal(m->audit.disagreements, 64);
        memcpy(wrong[run], m->audit.wrong, sizeof wrong[run]);
    }
    omp_set_num_threads(threads);
    assert_memory_equal(wrong[0], wrong[1], sizeof wrong[0]);
    assert_memory_not_equal(wrong[0], wrong[2], sizeof wrong[0]);
    slope_free(&s);
}

/* ---- errors -------------------------------------------------------------- */

static void every_allocation_may_fail(void **state)
{
    enum status status = STATUS_NO_MEMORY;
    struct slope s;
    struct basin_map m;
    long k = 0;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", FEW);
    omp_set_num_threads(1);
    for (; status == STATUS_NO_MEMORY; k++) {
        double v[61], psi[61];
        fault_alloc_at(k);
        status = basin_map_init(&m, &s.study.slider, &s.scene, NULL);
        if (status == STATUS_OK)
            status = basin_map_margins(&m, 0, 1, v, psi);
        if (status == STATUS_OK)
            status = basin_map_audit(&m, 3, 1, NULL);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        basin_map_free(&m);
        basin_map_free(&m);
    }
    assert_int_equal(status, STATUS_OK);
    CHECK(k > 20, "%ld allocations", k);
    slope_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(
            every_reference_state_is_on_its_side_of_the_separatrix),
        cmocka_unit_test(rows_are_the_same_alone_together_and_in_threads),
        cmocka_unit_test(exact_rows_are_the_same_in_threads),
        cmocka_unit_test(cells_have_the_fates_of_their_orbits),
        cmocka_unit_test(without_a_saddle_there_is_one_fate),
        cmocka_unit_test(fractions_sum_to_one_and_are_those_of_cells),
        cmocka_unit_test(margins_lead_onto_the_boundary),
        cmocka_unit_test(an_audit_agrees_unless_a_label_is_wrong),
        cmocka_unit_test(the_seed_and_nothing_else_chooses_the_cells),
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
