/* Columns of a sweep beyond those of knees: against studies, runs and releases
 * of their own. */
#include "sweep_column.h"

#include <math.h>
#include <omp.h>

#include "simulation.h"
#include "sweeps.h"

static const struct sweep_options plainly = { .journal = NULL };

#define LAW    "law.preset=spinodal_gen"
#define SLOPES "sweep={key: slope.alpha, values: [0.28, 0.33, 0.36, 0.4]}"
#define STARTS                                                                 \
    "trajectories.starts=[{v: 1e3, psi: 1}, {v: 0.01, psi: 10}, {v: 5, psi: "  \
    "0.2}]"

/* The scene at a point, as --set makes it; borrows. */
static struct scene point_of(const struct swept *w, size_t i)
{
    struct scene point;

    scene_at(&w->scene, &w->s.axis[0].value[i], &point);
    return point;
}

static void check(const struct sweep *s, const char *column, size_t point,
                  size_t entry, const struct quantity *is)
{
    const int k = sweep_find(s, column);

    CHECK(k >= 0, "no column %s", column);
    const struct quantity q = sweep_entry(s, k, point, entry);
    CHECK(quantity_exists(&q) == quantity_exists(is), "%s of point %zu: %s",
          column, point, quantity_exists(is) ? q.reason : is->reason);
    if (quantity_exists(&q))
        CHECK(q.value == is->value && q.error == is->error,
              "%s of point %zu: %.17g, not %.17g", column, point, q.value,
              is->value);
    else
        assert_string_equal(q.reason, is->reason);
}

static void check_code(const struct sweep *s, const char *column, size_t point,
                       size_t entry, int8_t is)
{
    const int k = sweep_find(s, column);

    CHECK(k >= 0 && sweep_entry_code(s, k, point, entry) == is,
          "%s of point %zu", column, point);
}

/* ---- basins -------------------------------------------------------------- */

static void shares_and_audit_are_those_of_the_basins(void **state)
{
    static const char *const sets[] = { LAW, "products=[basins]", SLOPES,
                                        "basins={cells: [16, 12], audit: 20}",
                                        NULL };
    struct swept w;

    (void) state;
    sweep_of(&w, sets, &plainly);
    assert_int_equal(w.s.layers.count, 0);
    for (size_t i = 0; i < w.s.points; i++) {
        const struct scene point = point_of(&w, i);
        struct study study;
        struct fault why;
        double sum = 0.0;
        assert_int_equal(study_run(&study, &point, NULL, &why), STATUS_OK);
        for (int k = 0; k < FATES; k++) {
            const struct basin_fraction *f = &study.basins.fraction[k];
            char name[64];
            snprintf(name, sizeof name, "basin_fraction_log_%s", fate_names[k]);
            check(&w.s, name, i, 0, &f->log);
            snprintf(name, sizeof name, "basin_fraction_linear_%s",
                     fate_names[k]);
            check(&w.s, name, i, 0, &f->linear);
            sum += f->log.value;
        }
        const struct quantity cells = quantity_of(20.0, 0.0);
        const struct quantity none = quantity_of(0.0, 0.0);
        check(&w.s, "basin_audit_cells", i, 0, &cells);
        check(&w.s, "basin_audit_disagreements", i, 0, &none);
        CHECK(fabs(sum - 1.0) < 1e-12, "%.17g in all", sum);
        study_free(&study);
    }
    swept_free(&w);
}

static void without_an_audit_there_are_no_counts(void **state)
{
    static const char *const sets[] = { LAW, "products=[margin]", SLOPES,
                                        "basins={cells: [4, 4], audit: 0}",
                                        NULL };
    struct swept w;

    (void) state;
    sweep_of(&w, sets, &plainly);
    assert_int_equal(sweep_find(&w.s, "basin_audit_cells"), -1);
    assert_true(sweep_find(&w.s, "basin_fraction_log_creep") >= 0);
    swept_free(&w);
}

/* ---- steady states ------------------------------------------------------- */

static void steady_states_go_by_what_they_are(void **state)
{
    static const char *const sets[] = { LAW, "products=[equilibria]", SLOPES,
                                        NULL };
    static const struct quantity no_creep = {
        .reason = "there is no creep node at this slope"
    };
    static const struct quantity no_sliding = {
        .reason = "there is no sliding node at this slope"
    };
    static const struct quantity no_saddle = {
        .reason = "there is no saddle at this slope"
    };
    struct swept w;

    (void) state;
    sweep_of(&w, sets, &plainly);
    const struct sweep *s = &w.s;
    check(s, "sliding_v", 0, 0, &no_sliding);
    check(s, "saddle_ln_psi", 0, 0, &no_saddle);
    check(s, "creep_lambda_minus", 3, 0, &no_creep);
    for (size_t i = 1; i < 3; i++) {
        const struct quantity v[] = {
            sweep_quantity(s, sweep_find(s, "equilibria_0_v"), i),
            sweep_quantity(s, sweep_find(s, "equilibria_2_v"), i)
        };
        check(s, "creep_v", i, 0, &v[0]);
        check(s, "sliding_v", i, 0, &v[1]);
        const struct quantity psi =
            sweep_quantity(s, sweep_find(s, "saddle_psi"), i);
        const struct quantity ln_psi =
            sweep_quantity(s, sweep_find(s, "saddle_ln_psi"), i);
        CHECK(fabs(exp(ln_psi.value) - psi.value) <=
                  psi.error + psi.value * ln_psi.error,
              "%.17g: ln %.17g", psi.value, ln_psi.value);
        assert_true(ln_psi.error > 0.0 && ln_psi.error < 1e-13);
    }
    assert_int_equal(sweep_find(s, "saddle_lambda_plus") >= 0, true);
    swept_free(&w);
}

static void a_logarithm_has_no_logarithm(void **state)
{
    static const char *const sets[] = { "law.preset=ruina",
                                        "products=[equilibria]", SLOPES, NULL };
    struct swept w;

    (void) state;
    sweep_of(&w, sets, &plainly);
    assert_int_equal(sweep_find(&w.s, "saddle_ln_psi"), -1);
    assert_true(sweep_find(&w.s, "saddle_ln_v") >= 0);
    swept_free(&w);
}

/* ---- runs ---------------------------------------------------------------- */

static void check_run(const struct sweep *s, size_t i, size_t start,
                      const struct transient *t)
{
    const struct quantity defect = quantity_of(t->sum.energy_defect, 0.0);

    check_code(s, "trajectory_fate", i, start, t->sum.fate);
    check_code(s, "trajectory_end", i, start, t->sum.end);
    check(s, "trajectory_time", i, start, &t->sum.time);
    check(s, "trajectory_slip", i, start, &t->sum.slip);
    check(s, "trajectory_mu_mean", i, start, &t->sum.mu_mean);
    check(s, "trajectory_energy_defect", i, start, &defect);
    for (size_t k = 0; k < PHASES; k++) {
        const size_t at = start * PHASES + k;
        check(s, "trajectory_phase_start_time", i, at, &t->phase[k].start_time);
        check(s, "trajectory_phase_end_time", i, at, &t->phase[k].end_time);
        check(s, "trajectory_phase_start_slip", i, at, &t->phase[k].start_slip);
        check(s, "trajectory_phase_end_slip", i, at, &t->phase[k].end_slip);
    }
}

/* The first of each kind, and of each level. */
static void check_events(const struct sweep *s, size_t i, size_t start,
                         const struct transient *t)
{
    const struct sweep_dim_axis *level = &s->dims.of[DIM_LEVEL];
    bool seen[MOMENTS] = { false }, near[MOMENT_LEVELS_MAX] = { false };

    for (size_t n = 0; n < t->events; n++) {
        const struct transient_event *e = &t->event[n];
        char name[64];
        snprintf(name, sizeof name, "trajectory_%s_time",
                 moment_names[e->what]);
        if (!seen[e->what] && sweep_find(s, name) >= 0)
            check(s, name, i, start, &e->time);
        seen[e->what] = true;
        for (size_t k = 0; k < level->count && e->what == MOMENT_MU_NEARS; k++)
            if (e->level == level->value[k] && !near[k]) {
                near[k] = true;
                check(s, "trajectory_mu_nears_slip", i,
                      start * level->count + k, &e->slip);
            }
    }
    assert_true(seen[MOMENT_MU_NEARS] && seen[MOMENT_ARREST]);
}

static void runs_are_those_of_simulate(void **state)
{
    static const char *const sets[] = { LAW, "products=[trajectories]", SLOPES,
                                        STARTS, NULL };
    struct swept w;

    (void) state;
    sweep_of(&w, sets, &plainly);
    assert_int_equal(w.s.dims.of[DIM_START].count, 3);
    assert_int_equal(sweep_find(&w.s, "v_plus"), -1);
    for (size_t i = 0; i < w.s.points; i++) {
        static struct simulation simulation;
        const struct scene point = point_of(&w, i);
        struct fault why;
        assert_int_equal(simulation_run(&simulation, &point, NULL, &why),
                         STATUS_OK);
        for (size_t k = 0; k < simulation.runs; k++) {
            check_run(&w.s, i, k, &simulation.run[k]);
            check_events(&w.s, i, k, &simulation.run[k]);
        }
        simulation_free(&simulation);
    }
    swept_free(&w);
}

/* ---- others -------------------------------------------------------------- */

static void release_distances_are_those_of_rabinowicz(void **state)
{
    static const char *const sets[] = {
        LAW, "products=[folds]",
        "sweep={key: slope.tan_alpha, values: [0.31, 0.34, 0.37]}",
        "rabinowicz={block_mass: 0.1, ball_mass: 0.01, restitution: 0.5}", NULL
    };
    struct swept w;

    (void) state;
    sweep_of(&w, sets, &plainly);
    assert_int_equal(sweep_find(&w.s, "v_plus"), -1);
    for (size_t i = 0; i < w.s.points; i++) {
        const struct scene point = point_of(&w, i);
        struct release r;
        struct fault why;
        assert_int_equal(release_run(&r, &point, NULL, &why), STATUS_OK);
        check(&w.s, "rabinowicz_l_k", i, 0, &r.row[0].l_k);
        check(&w.s, "rabinowicz_l_k_33", i, 0, &r.row[0].l_k_33);
        check(&w.s, "rabinowicz_s_k", i, 0, &r.row[0].s_k);
        check(&w.s, "rabinowicz_v_k", i, 0, &r.row[0].v_k);
        assert_true(quantity_exists(&r.row[0].l_k));
        release_free(&r);
    }
    swept_free(&w);
}

static void series_and_chi_are_those_of_the_study(void **state)
{
    static const char *const sets[] = { LAW, "products=[taylor_series, chi]",
                                        SLOPES, "chi.alpha=[0.3, 0.35]", NULL };
    struct swept w;

    (void) state;
    sweep_of(&w, sets, &plainly);
    assert_int_equal(w.s.dims.of[DIM_TERM].count, JET_SIZE);
    for (size_t i = 0; i < w.s.points; i++) {
        const struct scene point = point_of(&w, i);
        const struct quantity none =
            quantity_none("there is no saddle at this slope");
        struct study study;
        struct fault why;
        assert_int_equal(study_run(&study, &point, NULL, &why), STATUS_OK);
        check(&w.s, "taylor_series_radius", i, 0, &study.taylor.radius);
        for (size_t k = 0; k < JET_SIZE; k++)
            check(&w.s, "taylor_series_coefficient", i, k,
                  slider_saddle(&study.slider) < 0
                      ? &none
                      : &study.taylor.term[k].coefficient);
        for (size_t k = 0; k < 2; k++)
            check(&w.s, "chi_v_high", i, k,
                  &study.diagrams.chi.slope[k].v_high);
        study_free(&study);
    }
    swept_free(&w);
}

static void two_keys_with_one_last_word_are_told_apart(void **state)
{
    static const char *const sets[] = {
        LAW, "products=[equilibria]", "slope.alpha=0.34",
        "sweep=[{key: accuracy.rtol, values: [1e-9, 1e-8]}, {key: basins.rtol, "
        "values: [1e-5, 1e-4]}]",
        NULL
    };
    struct swept w;

    (void) state;
    sweep_of(&w, sets, &plainly);
    assert_string_equal(w.s.axis[0].name, "accuracy.rtol");
    assert_string_equal(w.s.axis[1].name, "basins.rtol");
    swept_free(&w);
}

static void threads_do_not_matter_to_runs(void **state)
{
    static const char *const sets[] = {
        LAW,    "products=[trajectories, basins]",  SLOPES,
        STARTS, "basins={cells: [8, 8], audit: 8}", NULL
    };
    struct swept one, many;

    (void) state;
    omp_set_num_threads(1);
    sweep_of(&one, sets, &plainly);
    for (int threads = 2; threads <= 4; threads += 2) {
        omp_set_num_threads(threads);
        sweep_of(&many, sets, &plainly);
        sweeps_are_the_same(&one.s, &many.s);
        swept_free(&many);
    }
    swept_free(&one);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shares_and_audit_are_those_of_the_basins),
        cmocka_unit_test(without_an_audit_there_are_no_counts),
        cmocka_unit_test(steady_states_go_by_what_they_are),
        cmocka_unit_test(a_logarithm_has_no_logarithm),
        cmocka_unit_test(runs_are_those_of_simulate),
        cmocka_unit_test(release_distances_are_those_of_rabinowicz),
        cmocka_unit_test(series_and_chi_are_those_of_the_study),
        cmocka_unit_test(two_keys_with_one_last_word_are_told_apart),
        cmocka_unit_test(threads_do_not_matter_to_runs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
