#include "nullcline.h"

#include "fault_alloc.h"
#include "fixtures.h"
#include "level.h"

/* (x^2 + y^2 - p0^2)(y - p1) */
static double circle_and_line(const double p[], struct vec2 z, struct vec2 *g)
{
    const double c = z.x * z.x + z.y * z.y - p[0] * p[0], l = z.y - p[1];

    *g = (struct vec2){ 2.0 * z.x * l, 2.0 * z.y * l + c };
    return c * l;
}

static double circle(const double p[], struct vec2 z, struct vec2 *g)
{
    *g = (struct vec2){ 2.0 * z.x, 2.0 * z.y };
    return z.x * z.x + z.y * z.y - p[0] * p[0];
}

/* (x - p2)(x + p2)(y - p3) */
static double three_lines(const double p[], struct vec2 z, struct vec2 *g)
{
    const double q = (z.x - p[2]) * (z.x + p[2]), l = z.y - p[3];

    *g = (struct vec2){ 2.0 * z.x * l, q };
    return q * l;
}

/* y - p0 sin x */
static double wave(const double p[], struct vec2 z, struct vec2 *g)
{
    *g = (struct vec2){ -p[0] * cos(z.x), 1.0 };
    return z.y - p[0] * sin(z.x);
}

static double square(const double p[], struct vec2 z, struct vec2 *g)
{
    *g = (struct vec2){ 2.0 * (z.x - p[1]), 0.0 };
    return (z.x - p[1]) * (z.x - p[1]);
}

static void loops_and_lines_are_all_found_once(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 200; i++) {
        const struct plain s = {
            .x = circle_and_line,
            .y = three_lines,
            .p = { check_uniform(&rng, 0.3, 2.5), check_uniform(&rng, -3, 3),
                   check_uniform(&rng, 0.3, 2.5), check_uniform(&rng, -3, 3) },
            .origin = { check_uniform(&rng, -1, 1), 0.5 },
            .log_scale = i % 2 ? 1e5 : -1e5,
        };
        const struct planar sys = planar_of(&s);
        const struct window w = { .box = { { -4.0, -4.0 }, { 4.1, 4.0 } } };
        struct nullcline n[NULLCLINES];
        size_t closed = 0;
        find(&sys, &w, n);
        for (int k = 0; k < NULLCLINES; k++)
            check_ends(&n[k], &w);
        CHECK(n[0].count == 2, "%zu: r = %.17g, y = %.17g", n[0].count, s.p[0],
              s.p[1]);
        CHECK(n[1].count == 3, "%zu: x = %.17g, y = %.17g", n[1].count, s.p[2],
              s.p[3]);
        for (size_t k = 0; k < 2; k++) {
            const double length = length_of(&n[0].piece[k]);
            const bool loop = is_closed(&n[0].piece[k]);
            const double exact = loop ? 2.0 * M_PI * s.p[0] : 8.1;
            closed += loop;
            CHECK(fabs(length / exact - 1.0) < (loop ? 0.02 : 1e-12),
                  "length %g, not %g: r = %.17g, y = %.17g", length, exact,
                  s.p[0], s.p[1]);
        }
        assert_int_equal(closed, 1);
        CHECK(worst(&s, s.x, &n[0]) < 1e-9, "off by %g", worst(&s, s.x, n));
        CHECK(worst(&s, s.y, &n[1]) < 1e-9, "off by %g", worst(&s, s.y, n + 1));
        drop(n);
    }
}

static void curves_that_leave_and_come_back_are_cut_exactly(void **state)
{
    const struct window w = { .box = { { -10.0, -1.0 }, { 10.0, 1.0 } } };
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 50; i++) {
        const struct plain s = { .x = wave,
                                 .y = one,
                                 .p = { check_uniform(&rng, 1.01, 5.0) },
                                 .origin = { 0.3, 0.7 } };
        const struct planar sys = planar_of(&s);
        struct nullcline n[NULLCLINES];
        find(&sys, &w, n);
        check_ends(&n[0], &w);
        /* One rise or fall around each multiple of pi within reach. */
        assert_int_equal(n[0].count, 7);
        assert_int_equal(n[1].count, 0);
        for (size_t k = 0; k < n[0].count; k++) {
            const struct polyline *p = &n[0].piece[k];
            const double x = p->at[0].x, turn = x - M_PI * round(x / M_PI);
            CHECK(fabs(fabs(turn) - asin(1.0 / s.p[0])) < 1e-12, "x = %.17g",
                  x);
        }
        CHECK(worst(&s, s.x, &n[0]) < 1e-13, "off by %g", worst(&s, s.x, n));
        drop(n);
    }
}

/* Exact points of X = r cos, Y = r sin moved by the shears, in order. */
static struct vec2 on_circle(const struct plain *s, double turn)
{
    struct vec2 z = { s->p[0] * cos(turn), s->p[0] * sin(turn) };

    for (size_t i = 0; i < s->shears; i++)
        z = shear_apply(&s->shear[i], z);
    return z;
}

/* Whether nothing else of the curve is within one and a half cells of z, on it,
 * nor the window's edge: what the search promises not to miss. */
static bool is_open(const struct plain *s, const struct window *w,
                    struct vec2 z)
{
    const double cell = 1.5 / TOL_NULLCLINE_CELLS;
    const struct vec2 u = window_unit(w, z);
    const struct box inner = { { cell, cell }, { 1.0 - cell, 1.0 - cell } };
    int changes = 0, corners = 0;

    for (int side = 0; side < 4; side++) {
        double before = 0.0;
        for (int i = -8; i <= 8; i++) {
            const double b = side < 2 ? cell : -cell, a = b * i / 8.0;
            const struct vec2 at = { u.x + (side % 2 ? a : b),
                                     u.y + (side % 2 ? b : a) };
            struct vec2 g;
            const double v =
                moved(s, s->y, vec2_sub(window_at(w, at), s->origin), &g);
            changes += before * v < 0.0;
            corners += i == -8 && v < 0.0;
            before = v;
        }
    }
    return changes == 2 && corners % 4 != 0 && box_holds(inner, u);
}

/* Both ways: every point of the curve is near the line, and the line is not
 * longer than the curve. */
static void check_covers(const struct plain *s, const struct window *w,
                         const struct nullcline *n)
{
    const int steps = 20000;
    double exact = 0.0, found = 0.0;
    struct vec2 before = on_circle(s, 0.0);

    for (int i = 1; i <= steps; i++) {
        const struct vec2 z = on_circle(s, 2.0 * M_PI * i / steps);
        if (box_holds(w->box, z) && box_holds(w->box, before))
            exact += vec2_length(vec2_sub(z, before));
        if (i % 50 == 0 && is_open(s, w, z))
            CHECK(distance(n, w, z) < 1.2 * LEVEL_CHORD,
                  "(%g, %g) is off by %g", z.x, z.y, distance(n, w, z));
        before = z;
    }
    for (size_t i = 0; i < n->count; i++)
        found += length_of(&n->piece[i]);
    CHECK(found < 1.02 * exact + 0.02, "length %g, not %g, in %zu pieces",
          found, exact, n->count);
}

static struct shear random_shear(uint64_t *rng, bool vertical)
{
    struct shear s = { .vertical = vertical, .degree = 3 };

    for (int k = 0; k <= 3; k++)
        s.coef[k] = check_uniform(rng, -0.5, 0.5);
    return s;
}

static void sheared_circles_are_followed_everywhere(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 300; i++) {
        struct plain s = { .x = one,
                           .y = circle,
                           .p = { check_uniform(&rng, 0.5, 2.0) },
                           .shears = 3,
                           .origin = { 0.1, 0.1 } };
        const struct planar sys = planar_of(&s);
        const struct window w = { .box = {
                                      { -2.0, check_uniform(&rng, -3, 0) },
                                      { check_uniform(&rng, 0, 3), 2.0 } } };
        struct nullcline n[NULLCLINES];
        for (size_t k = 0; k < 3; k++)
            s.shear[k] = random_shear(&rng, (i + (int) k) % 2);
        find(&sys, &w, n);
        check_ends(&n[1], &w);
        check_covers(&s, &w, &n[1]);
        CHECK(worst(&s, s.y, &n[1]) < 1e-12, "off by %g",
              worst(&s, s.y, &n[1]));
        drop(n);
    }
}

static void a_loop_that_touches_the_edge_stays_whole(void **state)
{
    (void) state;
    for (int i = -1; i <= 1; i++) {
        const struct plain s = { .x = circle,
                                 .y = one,
                                 .p = { 1.0 + i * 1e-3 } };
        const struct planar sys = planar_of(&s);
        const struct window w = { .box = { { -1.0, -2.0 }, { 1.0, 2.0 } } };
        struct nullcline n[NULLCLINES];
        find(&sys, &w, n);
        check_ends(&n[0], &w);
        assert_int_equal(n[0].count, i == 1 ? 2 : 1);
        assert_int_equal(is_closed(&n[0].piece[0]), i < 1);
        drop(n);
    }
}

/* In the unit square at `lo` there is one arc of the circle around 0. */
static void check_one_arc(struct vec2 lo, double radius, double length)
{
    const struct plain s = { .x = circle, .y = one, .p = { radius } };
    const struct planar sys = planar_of(&s);
    const struct window w = { .box = { lo, { lo.x + 1.0, lo.y + 1.0 } } };
    struct nullcline n[NULLCLINES];

    find(&sys, &w, n);
    check_ends(&n[0], &w);
    CHECK(n[0].count == 1, "%zu pieces: radius %.17g, corner (%.17g, %.17g)",
          n[0].count, radius, lo.x, lo.y);
    CHECK(fabs(length_of(&n[0].piece[0]) / length - 1.0) < 0.02,
          "length %g, not %g: radius %.17g, corner (%.17g, %.17g)",
          length_of(&n[0].piece[0]), length, radius, lo.x, lo.y);
    drop(n);
}

static void arcs_a_cell_wide_are_found_however_flat(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 200; i++) {
        const double half =
            check_uniform(&rng, 0.51, 5.0) / TOL_NULLCLINE_CELLS;
        const double r = half * check_uniform(&rng, 1.5, 20.0);
        const double off = sqrt((r - half) * (r + half));
        const double along = -check_uniform(&rng, 0.2, 0.8);
        const double across = i % 4 < 2 ? off : -off - 1.0;
        const struct vec2 lo = { i % 2 ? along : across,
                                 i % 2 ? across : along };
        check_one_arc(lo, r, 2.0 * r * asin(half / r));
    }
}

static void corners_cut_off_are_found_however_small(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 100; i++) {
        const double r = pow(10.0, -check_uniform(&rng, 1.0, 5.0));
        const struct vec2 lo = { i % 2 ? 0.0 : -1.0, i % 4 < 2 ? 0.0 : -1.0 };
        check_one_arc(lo, r, 0.5 * M_PI * r);
    }
}

static void fixtures_have_nullclines_through_their_equilibria(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 100; i++) {
        struct fixture f;
        struct nullcline n[NULLCLINES];
        fixture_random(&f, (enum fixture_base)(i % FIXTURE_BASES), &rng);
        const struct planar sys = fixture_planar(&f);
        const struct window w = {
            .box = { vec2_sub(f.origin, (struct vec2){ 1.5, 1.5 }),
                     vec2_add(f.origin, (struct vec2){ 1.5, 1.6 }) }
        };
        find(&sys, &w, n);
        for (int k = 0; k < NULLCLINES; k++) {
            check_ends(&n[k], &w);
            CHECK(n[k].count > 0, "none through (%g, %g)", f.origin.x,
                  f.origin.y);
            for (size_t e = 0; e < f.equilibria; e++) {
                const struct vec2 z = f.equilibrium[e].z;
                if (box_holds(w.box, z))
                    CHECK(distance(&n[k], &w, z) < 1.2 * LEVEL_CHORD,
                          "equilibrium (%g, %g) is off", z.x, z.y);
            }
        }
        drop(n);
    }
}

static void zeros_on_grid_nodes_make_one_piece(void **state)
{
    /* The grid has nodes at y = 0; p1 = 1: the window's own edge. */
    const struct plain s = { .x = height, .y = square };
    const struct planar sys = planar_of(&s);
    const struct window w = { .box = { { -1.0, -1.0 }, { 1.0, 1.0 } } };
    struct nullcline n[NULLCLINES];

    (void) state;
    find(&sys, &w, n);
    check_ends(&n[0], &w);
    assert_int_equal(n[0].count, 1);
    CHECK(fabs(length_of(&n[0].piece[0]) - 2.0) < 1e-12, "length %g",
          length_of(&n[0].piece[0]));
    assert_int_equal(n[1].count, 0); /* even order */
    drop(n);
}

static void linear_axes_get_the_points_they_need(void **state)
{
    /* y = -x: psi = 1/v on linear axes. */
    const struct shear down = { .vertical = true,
                                .degree = 1,
                                .coef = { 0.0, -1.0 } };
    struct plain s = { .x = one, .y = height, .shear = { down }, .shears = 1 };
    const struct planar sys = planar_of(&s);

    (void) state;
    for (int axes = 0; axes < 4; axes++) {
        const struct window w = {
            .box = { { -9.0, -9.0 }, { 3.0, 3.0 } },
            .exponential = { axes & 1, axes & 2 },
        };
        struct nullcline n[NULLCLINES];
        find(&sys, &w, n);
        check_ends(&n[1], &w);
        assert_int_equal(n[1].count, 1);
        CHECK(axes == 0 || n[1].piece[0].count > 20, "%zu points",
              n[1].piece[0].count);
        for (int i = 0; i <= 3000; i++) {
            const double x = -3.0 + 6.0 * i / 3000.0;
            const double d = distance(&n[1], &w, (struct vec2){ x, -x });
            CHECK(d < LEVEL_CHORD, "off by %g at x = %g", d, x);
        }
        drop(n);
    }
}

static void windows_without_zeros_are_fine_and_bad_ones_are_not(void **state)
{
    const struct plain s = { .x = one, .y = height, .p = { 0.0, 10.0 } };
    const struct planar sys = planar_of(&s);
    const struct window good = { .box = { { -1.0, -1.0 }, { 1.0, 1.0 } } };
    const struct box bad[] = { { { 1.0, -1.0 }, { 1.0, 1.0 } },
                               { { -1.0, NAN }, { 1.0, 1.0 } },
                               { { -1.0, -1.0 }, { 1.0, INFINITY } },
                               { { -51.0, -1.0 }, { 1.0, 1.0 } } };
    struct nullcline n[NULLCLINES];

    (void) state;
    find(&sys, &good, n);
    assert_int_equal(n[0].count + n[1].count, 0);
    assert_int_equal(n[0].loose + n[1].loose, 0);
    drop(n);
    for (size_t i = 0; i < 4; i++) {
        const struct window w = { .box = bad[i] };
        assert_int_equal(nullcline_find(&sys, &w, 1e-3, n),
                         STATUS_BAD_ARGUMENT);
    }
    assert_int_equal(nullcline_find(&sys, &good, 0.0, n), STATUS_BAD_ARGUMENT);
    assert_int_equal(nullcline_find(&sys, &good, NAN, n), STATUS_BAD_ARGUMENT);
}

static void every_allocation_fails_once(void **state)
{
    const struct plain s = { .x = circle_and_line,
                             .y = three_lines,
                             .p = { 1.0, 0.3, 1.5, 0.2 } };
    const struct planar sys = planar_of(&s);
    const struct window w = { .box = { { -4.0, -4.0 }, { 4.1, 4.0 } } };
    enum status status = STATUS_NO_MEMORY;
    long k = 0;

    (void) state;
    for (; status != STATUS_OK; k++) {
        struct nullcline n[NULLCLINES] = { NULLCLINE_EMPTY, NULLCLINE_EMPTY };
        fault_alloc_at(k);
        status = nullcline_find(&sys, &w, 1e-4, n);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        CHECK(status == STATUS_OK || status == STATUS_NO_MEMORY, "%s",
              status_text(status));
        CHECK(status == STATUS_OK || (n[0].piece == NULL && n[1].count == 0),
              "touched");
        drop(n);
    }
    CHECK(k > 15, "only %ld allocations", k - 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(loops_and_lines_are_all_found_once),
        cmocka_unit_test(curves_that_leave_and_come_back_are_cut_exactly),
        cmocka_unit_test(sheared_circles_are_followed_everywhere),
        cmocka_unit_test(a_loop_that_touches_the_edge_stays_whole),
        cmocka_unit_test(arcs_a_cell_wide_are_found_however_flat),
        cmocka_unit_test(corners_cut_off_are_found_however_small),
        cmocka_unit_test(fixtures_have_nullclines_through_their_equilibria),
        cmocka_unit_test(zeros_on_grid_nodes_make_one_piece),
        cmocka_unit_test(linear_axes_get_the_points_they_need),
        cmocka_unit_test(windows_without_zeros_are_fine_and_bad_ones_are_not),
        cmocka_unit_test(every_allocation_fails_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
