/* A study does what its scene asks for, no more; and what it does is right. */
#include "study.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "curve_rows.h"
#include "reference_rows.h"
#include "remark.h"
#include "starved_study.h"
#include "study_tolerance.h"

static char law_option[] = "law.preset=spinodal_gen";
static char slope_option[] = "slope.alpha=0.34";

/* A scene of these products at the given settings; asserts it is right. */
static void scene_of(struct scene *s, char *products, char *slope, char *extra)
{
    char *set[4] = { law_option, slope ? slope : slope_option, products,
                     extra };
    struct fault why;
    const enum status status = scene_read(s, NULL, set, extra ? 4 : 3, &why);

    CHECK(status == STATUS_OK, "%s", why.text);
}

static void run(struct study *s, const struct scene *scene)
{
    struct fault why;
    const enum status status = study_run(s, scene, NULL, &why);

    CHECK(status == STATUS_OK, "%s", why.text);
}

/* ---- only what a scene needs --------------------------------------------- */

static void each_product_runs_its_stages_and_no_other(void **state)
{
    (void) state;
    for (int p = 0; p < PRODUCTS; p++) {
        char products[64];
        struct scene scene;
        struct study s;
        snprintf(products, sizeof products, "products=[%s]", product_names[p]);
        scene_of(&scene, products, NULL, NULL);
        scene.spread = p == PRODUCT_TRAJECTORIES ? 2 : 0;
        scene.cells[0] = scene.cells[1] = 40;
        run(&s, &scene);
        const unsigned planned = plan_stages(scene.products) | 1u;
        for (int i = 0; i < STAGES; i++) {
            CHECK(s.cost[i].ran == (bool) plan_has(planned, (enum stage) i),
                  "%s: stage %s", product_names[p], stage_table[i].name);
            CHECK(s.cost[i].ran || s.cost[i].field_evaluations == 0,
                  "%s: stage %s evaluated the field", product_names[p],
                  stage_table[i].name);
        }
        study_free(&s);
        study_free(&s);
        scene_free(&scene);
    }
}

static void equilibria_alone_cost_no_allocation_and_no_manifold(void **state)
{
    char products[] = "products=[equilibria]";
    struct scene scene;
    struct study s;

    (void) state;
    scene_of(&scene, products, NULL, NULL);
    const long before = fault_alloc_count();
    run(&s, &scene);
    assert_int_equal(fault_alloc_count(), before);
    assert_int_equal(s.slider.plane.equilibria, 3);
    assert_int_equal(s.stable[0].curve.count + s.stable[1].curve.count, 0);
    CHECK(s.cost[STAGE_STEADY].field_evaluations <= 8, "%zu evaluations",
          s.cost[STAGE_STEADY].field_evaluations);
    study_free(&s);
    scene_free(&scene);
}

static void every_allocation_of_a_study_may_fail(void **state)
{
    char products[] = "products=[equilibria, nullclines, manifolds, "
                      "trajectories, field_arrows, knees, estimates]";
    char starts[] = "trajectories.starts=[{v: 1258.9, psi: 100}]";
    struct scene scene;

    (void) state;
    scene_of(&scene, products, NULL, starts);
    scene.spread = 2;
    scene.rtol = 1e-6;
    starve_study(&scene, LONG_MAX);
    scene_free(&scene);
}

/* ---- what it says is right ----------------------------------------------- */

/* Distance in the chart of (v, psi) from the branch's own dense output. */
static double distance_to(const struct solved *s, const struct branch *b,
                          struct vec2 z)
{
    double best = HUGE_VAL;

    (void) s;
    if (b->end == BRANCH_LIMIT_X && b->sign * (z.y - b->limit.y) > 0.0)
        best = fabs(z.x - b->limit.x);
    if (b->end == BRANCH_LIMIT_Y && b->sign * (z.x - b->limit.x) > 0.0)
        best = fabs(z.y - b->limit.y);
    for (size_t i = 0; i < b->curve.count; i++) {
        double at[CURVE_DIM_MAX], slope[CURVE_DIM_MAX], theta = 0.5;
        for (int k = 0; k < 60; k++) { /* Gauss-Newton to the nearest point */
            curve_at(&b->curve, i, theta, at);
            curve_slope_at(&b->curve, i, theta, slope);
            const double size = slope[0] * slope[0] + slope[1] * slope[1];
            theta -=
                ((at[0] - z.x) * slope[0] + (at[1] - z.y) * slope[1]) / size;
            theta = fmin(fmax(theta, 0.0), 1.0);
        }
        curve_at(&b->curve, i, theta, at);
        best = fmin(best, hypot(at[0] - z.x, at[1] - z.y));
    }
    return best;
}

static void listed_points_lie_on_the_dense_output(void **state)
{
    static const struct box everywhere = { { -60, -60 }, { 60, 60 } };
    struct csv c;
    size_t rows = 0;

    (void) state;
    solve_reach = &everywhere;
    csv_open(&c, "manifold_points.csv");
    while (csv_next(&c)) {
        struct solved s;
        assert_int_equal(solve_row(&s, &c, 1e-12), STATUS_OK);
        const bool upper = strcmp(csv_text(&c, "branch"), "upper") == 0;
        const double psi = csv_number(&c, "psi", 0);
        const struct vec2 z = {
            csv_number(&c, "ln_v_over_vsp", 0),
            law_psi_is_log(&s.block.law) ? psi - s.block.at.y0
                                         : log(psi / s.block.at.psi0),
        };
        const double d = distance_to(&s, upper ? &s.upper : &s.lower, z);
        CHECK(d <= 1e-9, "row %zu %s %s: %.3g off", c.row, csv_text(&c, "law"),
              csv_text(&c, "alpha"), d);
        solved_free(&s);
        rows++;
    }
    solve_reach = NULL;
    assert_int_equal(rows, 280);
}

/* Those of a row, psi_mark1 ... v_mark3; their number. */
static size_t check_marks(const struct csv *c, const struct solved *s)
{
    size_t marks = 0;

    for (int i = 1; i <= 3; i++) {
        char psi_name[16], v_name[16];
        snprintf(psi_name, sizeof psi_name, "psi_mark%d", i);
        snprintf(v_name, sizeof v_name, "v_mark%d", i);
        const double psi = csv_number(c, psi_name, NAN);
        const double v = csv_number(c, v_name, NAN);
        if (isnan(v))
            continue;
        const struct vec2 z = { log(v / s->block.at.v0),
                                law_psi_is_log(&s->block.law)
                                    ? psi - s->block.at.y0
                                    : log(psi / s->block.at.psi0) };
        if (z.y > s->system.domain.hi.y)
            continue; /* ruina's third */
        const double d = distance_to(s, &s->upper, z);
        CHECK(d <= 1e-11, "row %zu %s %s: %s is %.3g off", c->row,
              csv_text(c, "law"), csv_text(c, "alpha"), v_name, d);
        marks++;
    }
    return marks;
}

static void open_branches_pass_the_listed_marks(void **state)
{
    static const struct box everywhere = { { -60, -60 }, { 60, 1000 } };
    struct csv c;
    size_t marks = 0;

    (void) state;
    solve_reach = &everywhere;
    csv_open(&c, "manifold.csv");
    while (csv_next(&c)) {
        struct solved s;
        if (csv_text(&c, "v_mark1")[0] == '\0')
            continue;
        assert_int_equal(solve_row(&s, &c, 1e-12), STATUS_OK);
        marks += check_marks(&c, &s);
        solved_free(&s);
    }
    solve_reach = NULL;
    CHECK(marks > 100, "%zu marks", marks);
}

/* The Hermite cubic a reader of the file builds between rows a and b, against
 * a point of the curve: distance over the flatter coordinate. */
static double hermite_error(const struct branch_row *a,
                            const struct branch_row *b, double x, double y)
{
    const bool flat = fabs(a->slope) < 1.0;
    const double s0 = flat ? log(a->v) : log(a->psi);
    const double s1 = flat ? log(b->v) : log(b->psi);
    const double u0 = flat ? log(a->psi) : log(a->v);
    const double u1 = flat ? log(b->psi) : log(b->v);
    const double d0 = flat ? a->slope : 1.0 / a->slope;
    const double d1 = flat ? b->slope : 1.0 / b->slope;
    const double h = s1 - s0, t = ((flat ? x : y) - s0) / h;
    const double u = (1 - t) * (1 - t) * ((1 + 2 * t) * u0 + t * h * d0) +
                     t * t * ((3 - 2 * t) * u1 + (t - 1) * h * d1);

    return fabs(u - (flat ? y : x));
}

static void stored_rows_interpolate_to_a_millionth(void **state)
{
    char products[] = "products=[manifolds]";
    struct scene scene;
    struct study s;
    struct rows r = rows_of(&record_branch);

    (void) state;
    scene_of(&scene, products, NULL, NULL);
    run(&s, &scene);
    assert_int_equal(curve_rows_branch(&s, &s.stable[SIDE_UPPER], &r),
                     STATUS_OK);
    const struct branch_row *row = r.at;
    for (size_t i = 0; i < s.stable[SIDE_UPPER].curve.count; i++)
        for (int k = 1; k < 10; k++) {
            double at[CURVE_DIM_MAX];
            curve_at(&s.stable[SIDE_UPPER].curve, i, 0.1 * k, at);
            const double x = s.slider.block.at.x0 + at[0],
                         y = s.slider.block.at.y0 + at[1];
            size_t j = 0;
            while (j + 2 < r.count && row[j + 1].psi < exp(y))
                j++;
            CHECK(hermite_error(&row[j], &row[j + 1], x, y) <= 1e-6,
                  "piece %zu at %g: %.3g", i, 0.1 * k,
                  hermite_error(&row[j], &row[j + 1], x, y));
        }
    rows_free(&r);
    study_free(&s);
    scene_free(&scene);
}

/* Of (27) along a branch, whose slip and work it carries. */
static double branch_defect(const struct study *s, const struct branch *b)
{
    double first[CURVE_DIM_MAX], last[CURVE_DIM_MAX];
    size_t slip = 0, work = 0;

    for (size_t i = 0; i < b->carry.count; i++) {
        slip = b->carry.which[i] == BLOCK_SLIP ? i + 2 : slip;
        work = b->carry.which[i] == BLOCK_WORK ? i + 2 : work;
    }
    curve_at(&b->curve, 1, 0.0, first);
    curve_at(&b->curve, b->curve.count - 1, 1.0, last);
    return block_energy_defect(
        &s->slider.block, s->slider.block.at.v0 * exp(first[0]),
        s->slider.block.at.v0 * exp(last[0]), last[slip] - first[slip],
        last[work] - first[work]);
}

static void energy_balances_along_every_trajectory_and_branch(void **state)
{
    char products[] = "products=[manifolds, trajectories]";
    char starts[] = "trajectories.starts=[{v: 1258.9, psi: 100}, "
                    "{v: 1e5, psi: 0.01}, {v: 1e-5, psi: 0.01}]";
    static char slope[][24] = { "slope.alpha=0.3", "slope.alpha=0.34",
                                "slope.alpha=0.38" };

    (void) state;
    for (int k = 0; k < 3; k++) {
        struct scene scene;
        struct study s;
        scene_of(&scene, products, slope[k], starts);
        scene.spread = 8;
        run(&s, &scene);
        for (size_t i = 0; i < s.chosen.count; i++) {
            const double d =
                slider_energy_defect(&s.slider, &s.chosen.at[i].curve);
            CHECK(fabs(d) <= 10.0 * TOL_ORBIT_RTOL, "start %zu: %.3g", i, d);
        }
        for (size_t i = 0; i < s.portrait.trajectories.count; i++) {
            const struct trajectory *t = &s.portrait.trajectories.at[i];
            const double d = t->curve.count
                                 ? slider_energy_defect(&s.slider, &t->curve)
                                 : 0.0;
            CHECK(fabs(d) <= 10.0 * TOL_DRAWN, "spread %zu: %.3g", i, d);
        }
        for (int i = 0; i < SIDES; i++) {
            const double d = branch_defect(&s, &s.stable[i]);
            CHECK(fabs(d) <= 1e-10, "branch %d: %.3g", i, d);
        }
        study_free(&s);
        scene_free(&scene);
    }
}

static void no_steady_state_is_ever_a_focus(void **state)
{
    uint64_t rng = check_seed();
    size_t found = 0;

    (void) state;
    for (int i = 0; i < 10000; i++) {
        struct law law = *law_preset_at((size_t) (check_bits(&rng) % 8));
        struct material m = material_bristol_board();
        struct block b;
        struct steady_root root[EQUILIBRIA_MAX];
        law.form = check_bits(&rng) % 2 ? FRICTION_LOG : FRICTION_ASINH;
        m.a = exp(check_uniform(&rng, log(1e-3), log(1.0)));
        m.b = m.a * exp(check_uniform(&rng, -1.0, 3.0));
        m.c = exp(check_uniform(&rng, log(1e-8), log(10.0)));
        m.R = exp(check_uniform(&rng, log(1e-3), log(1e8)));
        m.V_c = exp(check_uniform(&rng, log(1e-3), log(1e8)));
        m.g *= exp(check_uniform(&rng, log(1e-6), log(1e6)));
        m.mu_star = check_uniform(&rng, 0.0, 2.0);
        const double alpha = check_uniform(&rng, 0.01, 1.5);
        block_init(&b, &law, &m, tanl((long double) alpha));
        struct planar sys = block_planar(&b);
        const size_t n = equilibrium_find(sys.steady, sys.ctx, root);
        for (size_t k = 0; k < n; k++) {
            struct equilibrium e;
            block_anchor(&b, root[k].x, true);
            sys = block_planar(&b);
            equilibrium_at(&sys, root[k].fold, &e);
            CHECK(e.type == EQUILIBRIUM_SADDLE ||
                      e.type == EQUILIBRIUM_STABLE_NODE ||
                      e.type == EQUILIBRIUM_SADDLE_NODE,
                  "draw %d, %s: %s at v = %g", i, law.preset,
                  equilibrium_type_names[e.type], b.at.v0);
            CHECK(e.lambda[0] <= e.lambda[1] && !isnan(e.lambda[0]),
                  "draw %d: eigenvalues %g %g", i, e.lambda[0], e.lambda[1]);
            found++;
        }
    }
    print_message("# %zu steady states\n", found);
    CHECK(found > 5000, "only %zu steady states", found);
}

static void what_is_missing_is_said(void **state)
{
    char products[] = "products=[equilibria, manifolds, knees]";
    char slope[] = "slope.alpha=0.28";
    const char *text[4];
    struct scene scene;
    struct study s;

    (void) state;
    scene_of(&scene, products, slope, NULL);
    run(&s, &scene);
    assert_int_equal(study_remarks(&s, text, 4), 1);
    CHECK(strstr(text[0], "no saddle"), "%s", text[0]);
    CHECK(!quantity_exists(&s.slider.critical.v_plus), "v_plus %g",
          s.slider.critical.v_plus.value);
    CHECK(strstr(s.slider.critical.v_plus.reason, "no saddle"), "%s",
          s.slider.critical.v_plus.reason);
    study_free(&s);
    scene_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_product_runs_its_stages_and_no_other),
        cmocka_unit_test(equilibria_alone_cost_no_allocation_and_no_manifold),
        cmocka_unit_test(every_allocation_of_a_study_may_fail),
        cmocka_unit_test(listed_points_lie_on_the_dense_output),
        cmocka_unit_test(open_branches_pass_the_listed_marks),
        cmocka_unit_test(stored_rows_interpolate_to_a_millionth),
        cmocka_unit_test(energy_balances_along_every_trajectory_and_branch),
        cmocka_unit_test(no_steady_state_is_ever_a_focus),
        cmocka_unit_test(what_is_missing_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
