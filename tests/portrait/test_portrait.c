#include "portrait.h"

#include <math.h>
#include <omp.h>
#include <string.h>

#include "check.h"
#include "fault_alloc.h"
#include "fixtures.h"
#include "tolerance.h"

/* x' = p0 x, y' = p1 y, exp(scale) times as fast; NaN for x > hole. */
struct linear {
    double p[2], scale, hole;
};

static void linear_jacobian(const void *ctx, struct vec2 z,
                            struct planar_jacobian *J)
{
    const struct linear *s = ctx;

    J->field =
        (struct planar_field){ { s->p[0] * z.x, s->p[1] * z.y }, s->scale };
    J->matrix = (struct mat2){ s->p[0], 0.0, 0.0, s->p[1] };
    if (z.x > s->hole)
        J->field.direction.x = J->matrix.xx = (double) NAN;
}

static void linear_field(const void *ctx, struct vec2 z, struct planar_field *f)
{
    struct planar_jacobian J;

    linear_jacobian(ctx, z, &J);
    *f = J.field;
}

static struct planar planar_of(const struct linear *s)
{
    return (struct planar){
        .name = "linear",
        .domain = { { -50.0, -50.0 }, { 50.0, 50.0 } },
        .field = linear_field,
        .jacobian = linear_jacobian,
        .ctx = s,
    };
}

static const struct linear saddle = { { -1.0, 2.0 }, 0.0, INFINITY };

static void the_drawing_and_the_chart_are_inverse(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 2000; i++) {
        const struct window w = {
            .box = { { check_uniform(&rng, -20, 0), -3.0 },
                     { check_uniform(&rng, 0.1, 20), 700.0 } },
            .exponential = { i & 1, i & 2 },
        };
        const struct vec2 u = { check_uniform(&rng, 0.01, 1),
                                check_uniform(&rng, 0.01, 1) };
        const struct vec2 z = window_at(&w, u), back = window_unit(&w, z);
        const struct vec2 d = { check_uniform(&rng, -1, 1), 0.3 };
        const struct vec2 on =
            window_unit(&w, vec2_add(z, vec2_scale(1e-6, d)));
        const struct vec2 push = window_push(&w, z, d);
        CHECK(fabs(back.x - u.x) < 1e-12 && fabs(back.y - u.y) < 1e-12,
              "(%g, %g) from (%g, %g)", back.x, back.y, u.x, u.y);
        CHECK(fabs((on.x - back.x) / 1e-6 - push.x) < 1e-5 &&
                  fabs((on.y - back.y) / 1e-6 - push.y) < 1e-5,
              "(%g, %g)", push.x, push.y);
        if (w.exponential[0]) /* evenly what exp(x) is */
            CHECK(fabs((exp(z.x) - exp(w.box.lo.x)) /
                           (exp(w.box.hi.x) - exp(w.box.lo.x)) / u.x -
                       1.0) < 1e-9,
                  "x = %g", z.x);
        for (int corner = 0; corner < 4; corner++) {
            const struct vec2 c = { corner & 1, corner & 2 ? 1.0 : 0.0 };
            const struct vec2 at = window_at(&w, c);
            assert_true(at.x == (corner & 1 ? w.box.hi.x : w.box.lo.x));
            assert_true(at.y == (corner & 2 ? w.box.hi.y : w.box.lo.y));
        }
    }
}

static void arrows_point_where_the_flow_goes_in_the_drawing(void **state)
{
    (void) state;
    for (int axes = 0; axes < 4; axes++) {
        struct linear s = saddle;
        const struct planar sys = planar_of(&s);
        const struct window w = { .box = { { -3.0, -2.0 }, { 1.0, 2.0 } },
                                  .exponential = { axes & 1, axes & 2 } };
        struct arrows a;
        s.scale = axes % 2 ? 1e5 : 0.0;
        assert_int_equal(arrows_find(&sys, &w, 7, 5, &a), STATUS_OK);
        assert_int_equal(a.columns * a.rows, 35);
        assert_int_equal(a.evaluations, 35);
        for (size_t i = 0; i < 35; i++) {
            const struct vec2 z = a.at[i].z, f = { -z.x, 2.0 * z.y };
            const struct vec2 u = window_unit(&w, z);
            const double h = 1e-6;
            const struct vec2 on =
                window_unit(&w, vec2_add(z, vec2_scale(h, f)));
            const struct vec2 d = vec2_scale(1.0 / h, vec2_sub(on, u));
            const double l = vec2_length(d);
            CHECK(fabs(u.x - ((double) (i % 7) + 0.5) / 7.0) < 1e-12 &&
                      fabs(u.y - ((double) (i / 7) + 0.5) / 5.0) < 1e-12,
                  "(%g, %g)", u.x, u.y);
            CHECK(fabs(a.at[i].direction.x - d.x / l) < 1e-4 &&
                      fabs(a.at[i].direction.y - d.y / l) < 1e-4,
                  "(%g, %g)", a.at[i].direction.x, a.at[i].direction.y);
            CHECK(fabs(a.at[i].log10_speed - log10(vec2_length(f)) -
                       s.scale / log(10.0)) < 1e-9,
                  "speed 10^%g", a.at[i].log10_speed);
        }
        arrows_free(&a);
        arrows_free(&a);
    }
}

static void arrows_know_points_at_rest(void **state)
{
    const struct planar sys = planar_of(&saddle);
    const struct window w = { .box = { { -1.0, -1.0 }, { 1.0, 1.0 } } };
    struct arrows a;

    (void) state;
    assert_int_equal(arrows_find(&sys, &w, 1, 1, &a), STATUS_OK);
    assert_true(a.at[0].direction.x == 0.0 && a.at[0].direction.y == 0.0);
    assert_true(a.at[0].log10_speed == -INFINITY);
    arrows_free(&a);
    assert_int_equal(arrows_find(&sys, &w, 0, 1, &a), STATUS_BAD_ARGUMENT);
    assert_int_equal(arrows_find(&sys, &w, SIZE_MAX, 2, &a),
                     STATUS_BAD_ARGUMENT);
}

static void trajectories_are_the_closed_form_up_to_the_margin(void **state)
{
    const struct planar sys = planar_of(&saddle);
    const struct window w = { .box = { { -2.0, -1.0 }, { 2.0, 1.0 } } };
    const struct trajectory_options o = trajectory_defaults(&sys, 1.0);
    const struct vec2 start[] = {
        { 2.0, 0.1 }, { -1.5, -0.01 }, { 0.5, 1e-3 }, { 40.0, 0.0 }
    };
    struct trajectories t;

    (void) state;
    assert_int_equal(trajectory_run(&sys, &w, start, 4, &o, &t), STATUS_OK);
    assert_int_equal(t.count, 4);
    for (size_t i = 0; i < 3; i++) {
        const struct curve *c = &t.at[i].curve;
        double u[CURVE_DIM_MAX];
        assert_int_equal(t.at[i].status, STATUS_OK);
        assert_int_equal(t.at[i].end, ORBIT_LEFT_WINDOW);
        for (size_t k = 0; k < c->count; k++) {
            curve_at(c, k, 0.7, u);
            CHECK(fabs(u[0] - start[i].x * exp(-u[2])) < 1e-6 &&
                      fabs(u[1] - start[i].y * exp(2.0 * u[2])) < 1e-6,
                  "(%g, %g) at t = %g", u[0], u[1], u[2]);
        }
        curve_at(c, c->count - 1, 1.0, u);
        CHECK(fabs(fabs(u[1]) - 1.1) < 1e-9, "left at y = %.15g", u[1]);
    }
    /* Not in the window at all. */
    assert_int_equal(t.at[3].end, ORBIT_LEFT_WINDOW);
    assert_int_equal(t.at[3].curve.count, 0);
    trajectory_free(&t);
    trajectory_free(&t);
}

static void trajectories_arrive_where_they_should(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 20; i++) {
        const struct window w = { .box = { { -2.0, -2.0 }, { 2.0, 2.0 } } };
        struct fixture f;
        struct vec2 target[2];
        struct trajectories t;
        fixture_random(&f, FIXTURE_PITCHFORK, &rng);
        const struct planar sys = fixture_planar(&f);
        struct trajectory_options o =
            trajectory_defaults(&sys, exp(f.log_rate));
        for (size_t k = 0; k < 2; k++)
            target[k] = vec2_sub(f.equilibrium[1 + k].z, sys.origin);
        o.orbit.target = target;
        o.orbit.targets = 2;
        o.seed = check_bits(&rng);
        assert_int_equal(trajectory_spread(&sys, &w, 12, &o, &t), STATUS_OK);
        for (size_t k = 0; k < t.count; k++) {
            const struct vec2 z = vec2_sub(t.at[k].start, sys.origin);
            const double side = fixture_implicit(&f, FIXTURE_STABLE, z);
            assert_true(box_holds(w.box, t.at[k].start));
            if (t.at[k].end == ORBIT_ARRIVED)
                CHECK((t.at[k].end_index == 1) == (side > 0.0),
                      "to %zu from side %g", t.at[k].end_index, side);
            else
                CHECK(t.at[k].end == ORBIT_LEFT_WINDOW, "%s from (%g, %g)",
                      status_text(t.at[k].status), z.x, z.y);
        }
        trajectory_free(&t);
    }
}

static void same(const struct trajectories *a, const struct trajectories *b)
{
    assert_int_equal(a->count, b->count);
    assert_int_equal(a->evaluations, b->evaluations);
    for (size_t i = 0; i < a->count; i++) {
        const struct trajectory *p = &a->at[i], *q = &b->at[i];
        assert_memory_equal(&p->start, &q->start, sizeof p->start);
        assert_int_equal(p->end, q->end);
        assert_int_equal(p->curve.coefs, q->curve.coefs);
        assert_memory_equal(p->curve.coef, q->curve.coef,
                            p->curve.coefs * sizeof *p->curve.coef);
    }
}

static void the_number_of_threads_changes_nothing(void **state)
{
    const struct window w = { .box = { { -2.0, -2.0 }, { 2.0, 2.0 } } };
    struct fixture f;
    struct trajectories one, t;

    (void) state;
    fixture_plain(&f, FIXTURE_DUFFING);
    const struct planar sys = fixture_planar(&f);
    struct trajectory_options o = trajectory_defaults(&sys, 1.0);
    o.orbit.reach[0] = 20.0;
    omp_set_num_threads(1);
    assert_int_equal(trajectory_spread(&sys, &w, 23, &o, &one), STATUS_OK);
    for (int threads = 2; threads <= 5; threads++) {
        omp_set_num_threads(threads);
        assert_int_equal(trajectory_spread(&sys, &w, 23, &o, &t), STATUS_OK);
        same(&one, &t);
        trajectory_free(&t);
    }
    /* What the seed is for. */
    o.seed = 1;
    assert_int_equal(trajectory_spread(&sys, &w, 23, &o, &t), STATUS_OK);
    assert_true(
        memcmp(&one.at[0].start, &t.at[0].start, sizeof t.at[0].start) != 0);
    trajectory_free(&t);
    trajectory_free(&one);
}

/* Distance in the drawing from u to the nearest of the trajectories. */
static double gap(const struct trajectories *t, const struct window *w,
                  struct vec2 u)
{
    double least = INFINITY, at[CURVE_DIM_MAX];

    for (size_t i = 0; i < t->count; i++)
        for (size_t k = 0; k < t->at[i].curve.count; k++)
            for (int j = 0; j <= 8; j++) {
                curve_at(&t->at[i].curve, k, j / 8.0, at);
                const struct vec2 z = { at[0], at[1] };
                least =
                    fmin(least, vec2_length(vec2_sub(window_unit(w, z), u)));
            }
    return least;
}

static void a_spread_fills_the_window_with_whole_orbits(void **state)
{
    const struct planar sys = planar_of(&saddle);
    const struct window w = { .box = { { -2.0, -1.0 }, { 2.0, 1.0 } } };
    const struct trajectory_options o = trajectory_defaults(&sys, 1.0);
    double widest = 0.0;
    struct trajectories t;

    (void) state;
    assert_int_equal(trajectory_spread(&sys, &w, 31, &o, &t), STATUS_OK);
    assert_int_equal(t.count, 31);
    for (size_t i = 0; i < t.count; i++) {
        const struct vec2 z = t.at[i].start;
        CHECK(fabs(z.x) == 2.0 && fabs(z.y) < 1.0,
              "comes in at the sides, not at (%g, %g)", z.x, z.y);
    }
    for (int i = 0; i < 900; i++) {
        const struct vec2 u = { (i % 30 + 0.5) / 30.0, (i / 30 + 0.5) / 30.0 };
        widest = fmax(widest, gap(&t, &w, u));
    }
    CHECK(widest < 0.08, "nothing within %g", widest);
    trajectory_free(&t);
}

/* What is drawn already, here the y axis, is kept away from. */
static void a_spread_keeps_away_from_what_is_drawn(void **state)
{
    const struct planar sys = planar_of(&saddle);
    const struct window w = { .box = { { -2.0, -1.0 }, { 2.0, 1.0 } } };
    struct trajectory_options o = trajectory_defaults(&sys, 1.0);
    struct curve axis = CURVE_EMPTY(2);
    const struct trajectory_drawn drawn = { &axis, { 0.0, 0.0 } };
    struct trajectories t;
    double *coef;

    (void) state;
    assert_int_equal(curve_push(&axis, 1, &coef), STATUS_OK);
    memcpy(coef, (double[]){ 0.0, 0.0, -1.0, 2.0 }, 4 * sizeof *coef);
    o.halfway = true;
    o.drawn = &drawn;
    o.drawn_count = 1;
    assert_int_equal(trajectory_spread(&sys, &w, 8, &o, &t), STATUS_OK);
    for (size_t i = 0; i < t.count; i++)
        CHECK(fabs(t.at[i].start.x) > 0.3, "chosen at (%g, %g)",
              t.at[i].start.x, t.at[i].start.y);
    trajectory_free(&t);
    curve_free(&axis);
}

static void orbits_that_go_on_or_fail_are_given_up_one_by_one(void **state)
{
    const struct linear s = { { 1.0, 1.0 }, 0.0, 1.0 };
    const struct planar sys = planar_of(&s);
    const struct window w = { .box = { { -2.0, -2.0 }, { 2.0, 2.0 } } };
    struct trajectory_options o = trajectory_defaults(&sys, 1.0);
    const struct vec2 start[] = { { 0.5, 0.1 }, { -0.5, 0.1 } };
    const struct vec2 outside[] = { { 60.0, 0.0 } };
    struct trajectories t;

    (void) state;
    assert_int_equal(trajectory_run(&sys, &w, start, 2, &o, &t), STATUS_OK);
    assert_int_equal(t.at[0].status, STATUS_NO_CONVERGENCE);
    assert_int_equal(t.at[0].end, ORBIT_RUNNING);
    assert_true(t.at[0].curve.count > 0);
    assert_int_equal(t.at[1].status, STATUS_OK);
    trajectory_free(&t);
    o.orbit.max_steps = 3;
    assert_int_equal(trajectory_run(&sys, &w, start, 2, &o, &t), STATUS_OK);
    assert_int_equal(t.at[1].status, STATUS_TOO_MANY_STEPS);
    assert_in_range(t.at[1].curve.count, 1, 3);
    trajectory_free(&t);
    assert_int_equal(trajectory_run(&sys, &w, outside, 1, &o, &t),
                     STATUS_BAD_ARGUMENT);
    o.margin = -1.0;
    assert_int_equal(trajectory_run(&sys, &w, start, 2, &o, &t),
                     STATUS_BAD_ARGUMENT);
}

static int refuse(void *ctx, const char *stage, uint64_t done, uint64_t total)
{
    (void) stage;
    *(uint64_t *) ctx = done;
    return total == 30 && done >= 8;
}

static void the_monitor_stops_a_spread(void **state)
{
    const struct planar sys = planar_of(&saddle);
    const struct window w = { .box = { { -2.0, -1.0 }, { 2.0, 1.0 } } };
    struct trajectory_options o = trajectory_defaults(&sys, 1.0);
    uint64_t done = 0;
    const struct monitor m = { refuse, &done };
    struct trajectories t = TRAJECTORIES_EMPTY;

    (void) state;
    o.monitor = &m;
    assert_int_equal(trajectory_spread(&sys, &w, 30, &o, &t), STATUS_STOPPED);
    assert_int_equal(done, 8);
    assert_null(t.at);
}

static void each_part_is_built_only_when_asked_for(void **state)
{
    const struct planar sys = planar_of(&saddle);
    const struct window w = { .box = { { -2.0, -1.0 }, { 2.1, 1.1 } } };
    const struct window bad = { .box = { { -2.0, -1.0 }, { 2.0, 99.0 } } };
    const struct trajectory_options o = trajectory_defaults(&sys, 1.0);
    struct portrait p;

    (void) state;
    assert_int_equal(portrait_init(&p, &sys, &bad), STATUS_BAD_ARGUMENT);
    portrait_free(&p);
    assert_int_equal(portrait_init(&p, &sys, &w), STATUS_OK);
    assert_int_equal(portrait_find_nullclines(&p, 1e-3), STATUS_OK);
    assert_int_equal(p.nullcline[NULLCLINE_X].count, 1);
    assert_int_equal(p.nullcline[NULLCLINE_Y].count, 1);
    assert_true(p.nullcline[NULLCLINE_X].evaluations > 0);
    assert_int_equal(p.arrows.evaluations + p.trajectories.evaluations, 0);
    assert_int_equal(portrait_find_arrows(&p, 3, 4), STATUS_OK);
    assert_int_equal(portrait_find_arrows(&p, 0, 4), STATUS_BAD_ARGUMENT);
    assert_int_equal(p.arrows.evaluations, 12);
    assert_int_equal(portrait_spread_trajectories(&p, 5, &o), STATUS_OK);
    assert_int_equal(p.trajectories.count, 5);
    assert_true(p.trajectories.evaluations > 100);
    assert_int_equal(portrait_spread_trajectories(&p, 0, &o), STATUS_OK);
    assert_int_equal(p.trajectories.count, 0);
    assert_int_equal(portrait_find_nullclines(&p, -1.0), STATUS_BAD_ARGUMENT);
    assert_int_equal(p.nullcline[NULLCLINE_X].count, 1);
    portrait_free(&p);
    portrait_free(&p);
    assert_null(p.arrows.at);
}

static enum status build(struct portrait *p, const struct trajectory_options *o)
{
    enum status s = portrait_find_nullclines(p, 1e-3);

    if (s == STATUS_OK)
        s = portrait_find_arrows(p, 5, 5);
    if (s == STATUS_OK)
        s = portrait_spread_trajectories(p, 6, o);
    return s;
}

static void every_allocation_fails_once(void **state)
{
    const struct planar sys = planar_of(&saddle);
    const struct window w = { .box = { { -2.0, -1.0 }, { 2.1, 1.1 } } };
    const struct trajectory_options o = trajectory_defaults(&sys, 1.0);
    enum status s = STATUS_NO_MEMORY;
    long k = 0;

    (void) state;
    for (; s != STATUS_OK; k++) {
        struct portrait p;
        assert_int_equal(portrait_init(&p, &sys, &w), STATUS_OK);
        fault_alloc_at(k);
        s = build(&p, &o);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        CHECK(s == STATUS_OK || s == STATUS_NO_MEMORY, "%s", status_text(s));
        CHECK((p.trajectories.count == 6) == (s == STATUS_OK), "%zu",
              p.trajectories.count);
        portrait_free(&p);
    }
    CHECK(k > 20, "only %ld allocations", k - 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_drawing_and_the_chart_are_inverse),
        cmocka_unit_test(arrows_point_where_the_flow_goes_in_the_drawing),
        cmocka_unit_test(arrows_know_points_at_rest),
        cmocka_unit_test(trajectories_are_the_closed_form_up_to_the_margin),
        cmocka_unit_test(trajectories_arrive_where_they_should),
        cmocka_unit_test(the_number_of_threads_changes_nothing),
        cmocka_unit_test(a_spread_fills_the_window_with_whole_orbits),
        cmocka_unit_test(a_spread_keeps_away_from_what_is_drawn),
        cmocka_unit_test(orbits_that_go_on_or_fail_are_given_up_one_by_one),
        cmocka_unit_test(the_monitor_stops_a_spread),
        cmocka_unit_test(each_part_is_built_only_when_asked_for),
        cmocka_unit_test(every_allocation_fails_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
