/* Maps of a sweep: those of a study at each point, in the side file only, and
 * there again after a stop. */
#include "sweep_layer.h"

#include <math.h>
#include <omp.h>
#include <unistd.h>

#include "failing_study.h"
#include "fault_alloc.h"
#include "own_folder.h"
#include "sweeps.h"

#define LAW "law.preset=spinodal_gen"

static const char *const maps[] = {
    LAW,
    "products=[basins, slip, field_arrows, chi]",
    "sweep={key: slope.alpha, values: [0.28, 0.33, 0.36, 0.4]}",
    "basins={cells: [2, 65], audit: 0, rtol: 1e-3}",
    "chi.alpha=[0.3, 0.35]",
    NULL
};

static struct sweep_options in_file(bool resume)
{
    return (struct sweep_options){ .journal = own_path("a.part"),
                                   .resume = resume,
                                   .version = "1" };
}

static size_t find(const struct sweep *s, const char *name)
{
    size_t k = 0;

    while (k < s->layers.count && strcmp(s->layers.at[k].name, name) != 0)
        k++;
    CHECK(k < s->layers.count, "no layer %s", name);
    return k;
}

/* All of a layer; owned by the caller. */
static void *all_of(const struct sweep *s, const char *name, size_t point)
{
    const size_t k = find(s, name);
    void *values = malloc(sweep_layer_size(&s->layers.at[k]));
    struct fault why;

    CHECK(sweep_read(s, k, point, values, &why) == STATUS_OK, "%s", why.text);
    return values;
}

/* ---- what they hold ------------------------------------------------------ */

/* As files have it: missing where there is no other fate. */
static void without_infinities(double margin[], size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (isinf(margin[i]))
            margin[i] = (double) NAN;
}

static void check_labels(const struct sweep *s, size_t point,
                         const struct study *study)
{
    const size_t cells = study->basins.rows * study->basins.columns;
    int8_t *is = malloc(cells), *label = all_of(s, "basin_label", point);
    double *margin = malloc(2 * cells * sizeof *margin);
    double *v = all_of(s, "basin_margin", point);
    double *psi = all_of(s, "basin_margin_psi", point);

    assert_int_equal(basin_map_rows(&study->basins, 0, 66, is), STATUS_OK);
    assert_memory_equal(is, label, cells);
    assert_int_equal(
        basin_map_margins(&study->basins, 0, 66, margin, margin + cells),
        STATUS_OK);
    without_infinities(margin, 2 * cells);
    assert_memory_equal(margin, v, cells * sizeof *v);
    assert_memory_equal(margin + cells, psi, cells * sizeof *psi);
    free(is);
    free(label);
    free(margin);
    free(v);
    free(psi);
}

/* Its member at `offset` of all cells. */
static void check_field(const struct sweep *s, const char *name, size_t point,
                        const struct cell cell[], size_t cells, size_t offset)
{
    double *value = all_of(s, name, point);

    for (size_t i = 0; i < cells; i++) {
        double is;
        memcpy(&is, (const char *) &cell[i] + offset, sizeof is);
        CHECK(memcmp(&is, &value[i], sizeof is) == 0,
              "%s of cell %zu: %.17g, not %.17g", name, i, value[i], is);
    }
    free(value);
}

static void check_fields(const struct sweep *s, size_t point,
                         const struct study *study)
{
    const size_t cells = study->basins.rows * study->basins.columns;
    struct cell *cell = malloc(cells * sizeof *cell);
    int8_t *exit_reason = all_of(s, "basin_exit_reason", point);

    assert_int_equal(fields_find(&study->fields, 0, 66, NULL, cell), STATUS_OK);
    check_field(s, "basin_slip", point, cell, cells,
                offsetof(struct cell, slip));
    check_field(s, "basin_slip_error", point, cell, cells,
                offsetof(struct cell, slip_error));
    check_field(s, "basin_v_peak", point, cell, cells,
                offsetof(struct cell, v_peak));
    check_field(s, "basin_mu_peak_error", point, cell, cells,
                offsetof(struct cell, mu_peak_error));
    for (size_t i = 0; i < cells; i++)
        assert_int_equal(exit_reason[i], cell[i].exit_reason);
    free(cell);
    free(exit_reason);
}

static void check_others(const struct sweep *s, size_t point,
                         const struct study *study)
{
    const struct arrows *a = &study->portrait.arrows;
    const struct chi_curves *c = &study->diagrams.chi;
    double *speed = all_of(s, "arrow_log10_speed", point);
    double *ln_chi = all_of(s, "chi_ln_chi", point);

    for (size_t i = 0; i < a->columns * a->rows; i++)
        assert_true(speed[i] == a->at[i].log10_speed);
    assert_memory_equal(ln_chi, c->ln_chi,
                        c->slopes * c->points * sizeof *ln_chi);
    free(speed);
    free(ln_chi);
}

static void every_map_is_that_of_the_study_at_its_point(void **state)
{
    static const char *const sets[] = {
        LAW,
        "products=[basins, margin, slip, peak, field_arrows, chi]",
        "sweep={key: slope.alpha, values: [0.33, 0.4]}",
        "basins={cells: [2, 66], audit: 0, rtol: 1e-4}",
        "chi.alpha=[0.3, 0.35]",
        NULL
    };
    const struct sweep_options o = in_file(false);
    struct swept w;

    (void) state;
    sweep_of(&w, sets, &o);
    for (size_t i = 0; i < w.s.points; i++) {
        struct scene point;
        struct study study;
        struct fault why;
        scene_at(&w.scene, &w.s.axis[0].value[i], &point);
        assert_int_equal(study_run(&study, &point, NULL, &why), STATUS_OK);
        check_labels(&w.s, i, &study);
        check_fields(&w.s, i, &study);
        check_others(&w.s, i, &study);
        study_free(&study);
    }
    swept_free(&w);
}

static bool near(double x, double y)
{
    return fabs(x - y) <= 1e-14 * fabs(y);
}

static void axes_are_where_the_cells_are(void **state)
{
    static const char *const forms[] = { "window.axes=log",
                                         "window.axes=linear" };
    const struct sweep_options o = in_file(false);

    (void) state;
    for (int i = 0; i < 2; i++) {
        const char *const sets[] = {
            LAW,      "products=[basins, field_arrows, chi]",
            maps[3],  "sweep={key: slope.alpha, values: [0.33]}",
            forms[i], NULL
        };
        struct swept w;
        struct study study;
        struct fault why;
        sweep_of(&w, sets, &o);
        const struct sweep_dim_axis *d = w.s.dims.of;
        assert_int_equal(study_run(&study, &w.scene, NULL, &why), STATUS_OK);
        const struct basin_map *m = &study.basins;
        const struct arrows *a = &study.portrait.arrows;
        assert_int_equal(d[DIM_V].count, m->columns);
        assert_int_equal(d[DIM_PSI].count, m->rows);
        assert_memory_equal(d[DIM_V].value, m->v, m->columns * sizeof *m->v);
        assert_memory_equal(d[DIM_PSI].value, m->psi, m->rows * sizeof *m->psi);
        for (size_t k = 0; k < a->columns * a->rows; k++)
            CHECK(
                near(exp(a->at[k].z.x), d[DIM_ARROW_V].value[k % a->columns]) &&
                    near(exp(a->at[k].z.y),
                         d[DIM_ARROW_PSI].value[k / a->columns]),
                "arrow %zu", k);
        assert_memory_equal(d[DIM_CHI_V].value, study.diagrams.chi.v,
                            d[DIM_CHI_V].count * sizeof(double));
        study_free(&study);
        swept_free(&w);
    }
}

static void a_failed_point_has_no_map(void **state)
{
    const struct sweep_options o = in_file(false);
    struct swept w;

    (void) state;
    failing_slopes[1] = 0.3;
    sweep_of(&w, maps, &o);
    failing_slopes[1] = 0.0;
    assert_int_equal(w.s.failed, 1);
    for (size_t i = 0; i < 2; i++) {
        double *slip = all_of(&w.s, "basin_slip", i);
        int8_t *label = all_of(&w.s, "basin_label", i);
        for (size_t k = 0; k < 2 * 65; k++)
            assert_true(isnan(slip[k]) == (i == 0) &&
                        (label[k] == -1) == (i == 0));
        free(slip);
        free(label);
    }
    swept_free(&w);
}

/* Nobody would see them. */
static void without_a_side_file_no_map_is_computed(void **state)
{
    const struct sweep_options plainly = { .journal = NULL };
    struct swept w;

    (void) state;
    sweep_of(&w, maps, &plainly);
    assert_int_equal(w.s.layers.count, 0);
    assert_true(sweep_find(&w.s, "basin_fraction_log_creep") >= 0);
    const unsigned products = sweep_point_products(&w.scene, false);
    assert_false(plan_has(plan_stages(products), STAGE_FIELDS));
    assert_false(plan_has(plan_stages(products), STAGE_ARROWS));
    assert_true(plan_has(plan_stages(products), STAGE_BASINS));
    swept_free(&w);
}

/* ---- threads, stops ------------------------------------------------------ */

static void any_number_of_threads_gives_the_same_maps(void **state)
{
    const struct sweep_options one = in_file(false);
    const struct sweep_options many = { .journal = own_path("b.part"),
                                        .resume = false,
                                        .version = "1" };
    struct swept a, b;

    (void) state;
    omp_set_num_threads(1);
    sweep_of(&a, maps, &one);
    for (int threads = 2; threads <= 4; threads += 2) {
        omp_set_num_threads(threads);
        sweep_of(&b, maps, &many);
        sweeps_are_the_same(&a.s, &b.s);
        swept_free(&b);
    }
    swept_free(&a);
}

struct patience {
    uint64_t points;
};

static int lose_patience(void *ctx, const char *stage, uint64_t done,
                         uint64_t total)
{
    const struct patience *p = ctx;

    (void) stage, (void) total;
    return done >= p->points;
}

static void maps_that_are_there_are_not_computed_again(void **state)
{
    const struct sweep_options o = in_file(true);
    const struct sweep_options other = { .journal = own_path("b.part"),
                                         .resume = false,
                                         .version = "1" };
    struct patience p = { 2 };
    const struct monitor monitor = { lose_patience, &p };
    struct swept whole, part;
    struct fault why;

    (void) state;
    omp_set_num_threads(1);
    sweep_of(&whole, maps, &other);
    scene_set(&part.scene, maps);
    assert_int_equal(sweep_run(&part.s, &part.scene, &o, &monitor, &why),
                     STATUS_STOPPED);
    failing_slopes[1] = 0.3; /* were it computed, it would fail */
    p.points = 5;
    assert_int_equal(sweep_run(&part.s, &part.scene, &o, &monitor, &why),
                     STATUS_OK);
    failing_slopes[1] = 0.0;
    assert_int_equal(part.s.taken, 2);
    sweeps_are_the_same(&whole.s, &part.s);
    swept_free(&part);
    swept_free(&whole);
}

/* Wherever it is cut, what is left of it is right. */
static void a_side_file_with_maps_cut_anywhere_is_taken_up(void **state)
{
    static const char *const sets[] = {
        LAW, "products=[basins, slip]",
        "sweep={key: slope.alpha, values: [0.33, 0.34, 0.36]}",
        "basins={cells: [6, 5], audit: 0}", NULL
    };
    const struct sweep_options o = in_file(true);
    const struct sweep_options other = { .journal = own_path("b.part"),
                                         .resume = false,
                                         .version = "1" };
    uint64_t seed = check_seed();
    struct swept whole, part;
    size_t size;

    (void) state;
    omp_set_num_threads(1);
    sweep_of(&whole, sets, &other);
    char *bytes = file_read(other.journal, &size);
    for (int i = 0; i < 12; i++) {
        file_write(o.journal, bytes, (size_t) (check_bits(&seed) % size));
        sweep_of(&part, sets, &o);
        assert_true(part.s.taken < whole.s.points);
        sweeps_are_the_same(&whole.s, &part.s);
        swept_free(&part);
    }
    free(bytes);
    swept_free(&whole);
}

static void each_failed_allocation_is_told(void **state)
{
    static const char *const sets[] = {
        LAW,
        "products=[basins, slip, margin, field_arrows, trajectories]",
        "sweep={key: slope.alpha, values: [0.33]}",
        "basins={cells: [3, 2], audit: 1}",
        "trajectories.starts=[{v: 1, psi: 1}]",
        NULL
    };
    const struct sweep_options o = in_file(false);
    enum status status = STATUS_NO_MEMORY;
    struct scene scene;
    struct fault why;
    struct sweep s;
    long step = 1;

    (void) state;
    scene_set(&scene, sets);
    omp_set_num_threads(1);
    for (long k = 0; status != STATUS_OK;
         k += step, step += k > 60 ? k / 60 : 0) {
        fault_alloc_at(k);
        status = sweep_run(&s, &scene, &o, NULL, &why);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        CHECK(status == STATUS_OK || status == STATUS_NO_MEMORY, "%ld: %s", k,
              why.text);
        if (status == STATUS_NO_MEMORY)
            assert_string_equal(why.text, "out of memory");
    }
    assert_int_equal(s.failed, 0);
    sweep_free(&s);
    sweep_free(&s);
    scene_free(&scene);
}

#define IN_FOLDER(test)                                                        \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(every_map_is_that_of_the_study_at_its_point),
        IN_FOLDER(axes_are_where_the_cells_are),
        IN_FOLDER(a_failed_point_has_no_map),
        IN_FOLDER(without_a_side_file_no_map_is_computed),
        IN_FOLDER(any_number_of_threads_gives_the_same_maps),
        IN_FOLDER(maps_that_are_there_are_not_computed_again),
        IN_FOLDER(a_side_file_with_maps_cut_anywhere_is_taken_up),
        IN_FOLDER(each_failed_allocation_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
