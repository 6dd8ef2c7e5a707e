/* Work-precision diagrams: the truth is true, ours never fail silently, ranks
 * are what they say.  Never a time. */
#include "workprec.h"

#include <float.h>
#include <math.h>
#include <omp.h>
#include <string.h>

#include "check.h"
#include "laws.h"
#include "quad_branch.h"
#include "workprec_count.h"
#include "workprec_own.h"
#include "workprec_system.h"
#include "workprec_tolerance.h"
#include "workprec_track.h"

/* A slope, and its task without a race. */
struct slope_task {
    struct scene scene;
    struct study study;
    struct workprec_task task;
};

static int make_task(void **state)
{
    static struct slope_task made, *s = &made;
    char preset[] = "law.preset=spinodal_gen", slope[] = "slope.alpha=0.34";
    char *const set[] = { preset, slope };
    struct fault why = { "" };

    *state = s;
    if (scene_read(&s->scene, NULL, set, 2, &why) != STATUS_OK)
        fail_msg("%s", why.text);
    s->scene.products = 1u << PRODUCT_EQUILIBRIA;
    if (study_run(&s->study, &s->scene, NULL, &why) != STATUS_OK)
        fail_msg("%s", why.text);
    assert_int_equal(workprec_task_init(&s->task, &s->study, 1, 4, NULL),
                     STATUS_OK);
    return 0;
}

static int drop_task(void **state)
{
    struct slope_task *s = *state;

    study_free(&s->study);
    scene_free(&s->scene);
    return 0;
}

/* ---- truth ----------------------------------------------------------- */

/* Two programs that share only the field: the limit of one lies on the last
 * stretch of the other. */
static void the_exact_curve_is_that_of_a_finer_tolerance(void **state)
{
    const struct slope_task *s = *state;
    const struct quad_anchor *at = &s->task.truth.slope.at;
    struct quad_branch b;

    for (int side = 0; side < WORKPREC_SIDES; side++) {
        const struct quad_branch *c = &s->task.truth.curve[side];
        assert_true(quad_branch_grow(&s->study.slider.block.law, at,
                                     side == SIDE_UPPER ? 1 : -1, 1e-26, &b));
        const quad off = c->x - b.x;
        CHECK((double) fabsq(off) < 1e-19, "off by %g", (double) off);
        for (size_t i = 0; i < b.points; i++) {
            const double far = workprec_curve_distance(c, b.path[i]);
            CHECK(far < 1e-19 * (1 + fabs((double) b.path[i][1])),
                  "point %zu: off by %g", i, far);
        }
    }
}

/* Of a knot moved across the curve, by much and by little. */
static void the_distance_from_the_curve_is_what_a_point_was_moved_by(
    void **state)
{
    const struct slope_task *s = *state;

    for (int side = 0; side < WORKPREC_SIDES; side++) {
        const struct quad_branch *c = &s->task.truth.curve[side];
        const size_t points = c->points;
        for (size_t i = points / 2; i + 2 < points; i += 7) {
            const quad *at = c->path[i];
            quad n[2];
            workprec_curve_tangent(c, at, n);
            for (double by = 1e-18; by < 1e-6; by *= 1e5) {
                const quad z[2] = { at[0] - by * n[1], at[1] + by * n[0] };
                const double found = workprec_curve_distance(c, z);
                CHECK(fabs(found / by - 1.0) < 1e-3, "knot %zu: %g for %g", i,
                      found, by);
            }
        }
    }
}

/* Also where one is followed to half the time, and on from there. */
static void orbits_of_two_tolerances_end_alike(void **state)
{
    const struct slope_task *s = *state;
    const struct quad_slope *q = &s->task.truth.slope;
    quad end[2][2], half[2];

    for (int k = 0; k < 12; k++) {
        const quad x = q->at.x0 + 4 - k, y = q->at.y0 + (quad) 2.5 - k / 2;
        const quad time = s->task.until * (k + 1) / 6;
        for (int i = 0; i < 2; i++)
            assert_true(quad_orbit_at(q, x, y, time,
                                      i ? 1e-13 : WORKPREC_ORBIT_TOL, end[i]));
        assert_true(quad_orbit_at(q, x, y, time / 2, WORKPREC_ORBIT_TOL, half));
        assert_true(quad_orbit_at(q, half[0], half[1], time - time / 2,
                                  WORKPREC_ORBIT_TOL, half));
        for (int i = 0; i < 2; i++) {
            CHECK((double) fabsq(end[0][i] - end[1][i]) < 1e-18, "%g",
                  (double) (end[0][i] - end[1][i]));
            CHECK((double) fabsq(half[i] - end[1][i]) < 1e-18, "%g",
                  (double) (half[i] - end[1][i]));
        }
    }
}

/* ---- methods --------------------------------------------------------- */

static void a_jacobian_is_the_slope_of_its_rates(void **state)
{
    const struct slope_task *s = *state;
    uint64_t seed = check_seed();

    for (int i = 0; i < 200; i++) {
        const struct workprec_system equations = {
            &s->study.slider.plane.system, i % 2 == 1,
            i % 4 >= 2 ? WORKPREC_ALONE
            : i % 2    ? BLOCK_EXCESS
                       : BLOCK_SLIP
        };
        struct method_system system = workprec_method_system(&equations);
        const size_t n = system.dim;
        const double u[METHOD_DIM] = { check_uniform(&seed, -3, 3),
                                       check_uniform(&seed, -3, 3), 0.3 };
        double J[METHOD_DIM * METHOD_DIM], lo[METHOD_DIM], hi[METHOD_DIM];
        assert_true(method_jacobian(&system, u, J));
        for (size_t j = 0; j < n; j++) {
            double near[METHOD_DIM] = { u[0], u[1], u[2] };
            near[j] = u[j] - 1e-5;
            assert_true(method_rates(&system, near, lo));
            near[j] = u[j] + 1e-5;
            assert_true(method_rates(&system, near, hi));
            for (size_t k = 0; k < n; k++) {
                const double slope = (hi[k] - lo[k]) / 2e-5;
                const double size = fabs(lo[k]) + fabs(hi[k]) + fabs(slope);
                CHECK(fabs(J[k * n + j] - slope) <= 1e-6 * size + 1e-12,
                      "%zu, %zu: %g, not %g", k, j, J[k * n + j], slope);
            }
        }
    }
}

/* u' = (u1, -u0): each method by its own tolerance, to 2 pi and back between
 * its steps. */
static void circle(const void *ctx, const double u[], double du[])
{
    (void) ctx;
    du[0] = u[1];
    du[1] = -u[0];
}

static void circle_slopes(const void *ctx, const double u[], double J[])
{
    (void) ctx, (void) u;
    J[0] = J[3] = 0.0;
    J[1] = 1.0;
    J[2] = -1.0;
}

static void every_method_follows_a_circle_and_looks_between_steps(void **state)
{
    (void) state;
    for (size_t i = 0; method_at(i); i++) {
        const struct method *m = method_at(i);
        struct method_system system = { 2,    circle, circle_slopes,
                                        NULL, 0,      1000000 };
        double u[METHOD_DIM] = { 0.0, 1.0 }, v[METHOD_DIM], s = 0.0, last = 0.0;
        void *run = m->open(m, &system, 1e-8, u, 1e-3);
        assert_non_null(run);
        while (s < 6.0) {
            last = s;
            assert_true(m->step(run, 6.0, &s, u));
            const double middle = 0.3 * last + 0.7 * s;
            if (!m->between)
                continue;
            assert_true(m->between(run, middle, v));
            CHECK(hypot(v[0] - sin(middle), v[1] - cos(middle)) < 1e-4,
                  "%s between %g and %g", m->name, last, s);
        }
        CHECK(hypot(u[0] - sin(6.0), u[1] - cos(6.0)) < 1e-5, "%s: %g %g",
              m->name, u[0], u[1]);
        CHECK(system.calls > 0, "%s", m->name);
        m->close(run);
    }
}

static void a_method_gives_up_after_so_many_calls(void **state)
{
    (void) state;
    for (size_t i = 0; method_at(i); i++) {
        const struct method *m = method_at(i);
        struct method_system system = {
            2, circle, circle_slopes, NULL, 0, 100
        };
        double u[METHOD_DIM] = { 0.0, 1.0 }, s = 0.0;
        void *run = m->open(m, &system, 1e-10, u, 1e-3);
        assert_non_null(run);
        size_t steps = 0;
        while (m->step(run, 1e6, &s, u))
            CHECK(++steps < 1000, "%s goes on", m->name);
        CHECK(system.calls < 2000, "%s: %zu calls", m->name, system.calls);
        m->close(run);
    }
}

/* As often as an orbit itself says, and somewhat more, for whoever follows it
 * looks at the field, too; and counting changes nothing. */
static void asking_is_counted(void **state)
{
    const struct slope_task *s = *state;
    static struct workprec_answer a, b;
    struct workprec_shared shared;

    assert_int_equal(workprec_shared_init(&shared, &s->task), STATUS_OK);
    for (int i = 0; i < 2; i++) {
        const enum workprec_own how = i ? WORKPREC_RADAU : WORKPREC_SLIPWAY;
        workprec_own_run(&s->task, &shared, how, WORKPREC_SLIP, 1e-6, &a);
        assert_int_equal(workprec_own_count(&s->task, how, 1e-6, &b),
                         STATUS_OK);
        assert_true(a.success && b.success);
        CHECK(a.value[0] == b.value[0], "counting changes %g to %g", a.value[0],
              b.value[0]);
    }
    CHECK(b.calls >= a.calls && b.calls <= a.calls + a.calls / 5,
          "%zu calls, not %zu", b.calls, a.calls);
    workprec_shared_free(&shared);
    workprec_shared_free(&shared);
}

/* ---- ranks ----------------------------------------------------------- */

static struct workprec_run made_run(const char *method, int8_t foreign,
                                    double error, double seconds)
{
    return (struct workprec_run){ .method = method,
                                  .foreign = foreign,
                                  .true_error = error,
                                  .seconds = seconds };
}

static void times_are_interpolated_between_errors(void **state)
{
    struct workprec_run run[] = { made_run("a", 0, 1e-2, 1.0),
                                  made_run("a", 0, 1e-6, 100.0),
                                  made_run("a", 0, 1e-9, 50.0),
                                  made_run("a", 0, 1e-13, 500.0) };

    (void) state;
    CHECK(fabs(workprec_time_at(run, 2, 1e-4) - 10.0) < 1e-12, "half way");
    CHECK(workprec_time_at(run, 4, 1e-1) == 1.0, "good enough");
    CHECK(fabs(workprec_time_at(run, 4, 1e-5) - pow(10, 1.5)) < 1e-9, "%g",
          workprec_time_at(run, 4, 1e-5));
    CHECK(workprec_time_at(run, 4, 1e-6) == 50.0, "a later one is faster");
    CHECK(isinf(workprec_time_at(run, 4, 1e-14)), "nobody gets there");
    run[3].status = WORKPREC_SILENT_FAILURE;
    CHECK(isinf(workprec_time_at(run, 4, 1e-13)), "failures do not count");
}

static void the_fastest_is_compared_with_the_best_of_others(void **state)
{
    const struct workprec_run run[] = { made_run("a", 0, 1e-14, 4.0),
                                        made_run("b", 0, 1e-8, 2.0),
                                        made_run("c", 1, 1e-10, 6.0),
                                        made_run("d", 1, 1e-4, 1.0) };
    struct workprec_fastest *f;
    size_t n;

    (void) state;
    assert_int_equal(workprec_rank(run, 4, &f, &n), STATUS_OK);
    assert_int_equal(n, 4);
    assert_string_equal(f[0].method, "d");
    assert_string_equal(f[0].own, "b");
    CHECK(f[0].ratio_to_best_foreign == 0.5, "%g", f[0].ratio_to_best_foreign);
    assert_string_equal(f[1].foreign, "c");
    CHECK(f[1].ratio_to_best_foreign == 3.0, "%g", f[1].ratio_to_best_foreign);
    assert_string_equal(f[2].own, "a");
    CHECK(f[3].foreign == NULL && isnan(f[3].ratio_to_best_foreign), "nobody");
    assert_string_equal(f[3].method, "a");
    free(f);
}

/* ---- races ----------------------------------------------------------- */

static void race(struct workprec *w, struct scene *scene, const char *law)
{
    char preset[64], slope[] = "slope.alpha=0.34";
    char *const set[] = { preset, slope };
    struct fault why = { "" };

    snprintf(preset, sizeof preset, "law.preset=%s", law);
    omp_set_num_threads(1);
    if (scene_read(scene, NULL, set, 2, &why) != STATUS_OK ||
        workprec_run(w, scene, true, NULL, &why) != STATUS_OK)
        fail_msg("%s: %s", law, why.text);
}

/* Whether a method promises a bar. */
static bool has_bar(const struct workprec_run *r)
{
    return strcmp(r->method, "slipway") == 0 ||
           strcmp(r->method, "slow_curve") == 0;
}

/* Ours have bars where they promise them, which hold, and never fail so. */
static void check_ours(const struct workprec_run *r)
{
    const char *what = workprec_quantity_names[r->quantity];

    CHECK(r->status != WORKPREC_SILENT_FAILURE, "%s fails silently at %s, %g",
          r->method, what, r->rtol);
    if (!has_bar(r))
        return;
    CHECK(r->status == WORKPREC_DONE, "%s fails at %s, %g", r->method, what,
          r->rtol);
    CHECK(r->true_error <= r->reported_error, "%s, %s, %g: off by %g, not %g",
          r->method, what, r->rtol, r->true_error, r->reported_error);
}

static void check_race(const struct workprec *w, size_t quantities)
{
    size_t n = 0;

    for (int q = 0; q < WORKPREC_QUANTITIES; q++)
        n += w->task.reason[q] == NULL;
    assert_int_equal(n, quantities);
    assert_int_equal(w->ranks, 4 * quantities);
    for (size_t i = 0; i < w->runs; i++) {
        const struct workprec_run *r = &w->run[i];
        CHECK(r->seconds > 0.0, "%s takes %g", r->method, r->seconds);
        CHECK(r->field_evaluations > 0 || strcmp(r->method, "slow_curve") == 0,
              "%s asks nothing", r->method);
        if (!r->foreign)
            check_ours(r);
        else
            CHECK(isnan(r->reported_error), "%s has no bars", r->method);
    }
}

static void ours_never_fail_silently_and_their_bars_hold(void **state)
{
    static struct workprec w;
    struct scene scene;

    (void) state;
    if (laws_emulated())
        skip();
    race(&w, &scene, "spinodal_gen");
    check_race(&w, WORKPREC_QUANTITIES);
    workprec_free(&w);
    workprec_free(&w);
    scene_free(&scene);
}

/* dieterich: an open upper branch, v = 0 on the lower one, no node to arrive
 * at. */
static void what_does_not_exist_says_why_and_has_no_runs(void **state)
{
    static const enum workprec_quantity none[] = {
        WORKPREC_V_PLUS, WORKPREC_V_MINUS, WORKPREC_X_EXCESS, WORKPREC_SLIP
    };
    static struct workprec w;
    struct scene scene;

    (void) state;
    if (laws_emulated())
        skip();
    race(&w, &scene, "dieterich");
    for (size_t k = 0; k < sizeof none / sizeof *none; k++) {
        assert_non_null(w.task.reason[none[k]]);
        for (size_t i = 0; i < w.runs; i++)
            assert_int_not_equal(w.run[i].quantity, none[k]);
    }
    check_race(&w, WORKPREC_QUANTITIES - 4);
    workprec_free(&w);
    scene_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_exact_curve_is_that_of_a_finer_tolerance),
        cmocka_unit_test(
            the_distance_from_the_curve_is_what_a_point_was_moved_by),
        cmocka_unit_test(orbits_of_two_tolerances_end_alike),
        cmocka_unit_test(a_jacobian_is_the_slope_of_its_rates),
        cmocka_unit_test(every_method_follows_a_circle_and_looks_between_steps),
        cmocka_unit_test(a_method_gives_up_after_so_many_calls),
        cmocka_unit_test(asking_is_counted),
        cmocka_unit_test(times_are_interpolated_between_errors),
        cmocka_unit_test(the_fastest_is_compared_with_the_best_of_others),
        cmocka_unit_test(ours_never_fail_silently_and_their_bars_hold),
        cmocka_unit_test(what_does_not_exist_says_why_and_has_no_runs),
    };
    return cmocka_run_group_tests(tests, make_task, drop_task);
}
