#include "nullcline.h"

#include <math.h>
#include <string.h>

#include "block.h"
#include "check.h"
#include "fault_alloc.h"
#include "law.h"
#include "shear.h"
#include "tolerance.h"

/* A scalar function with its gradient. */
typedef double scalar(const double p[], struct vec2 z, struct vec2 *gradient);

/* z' = (x(z), y(z)) exp(log_scale), both moved by shears. */
struct plain {
    scalar *x, *y;
    double p[4];
    struct shear shear[3];
    size_t shears;
    struct vec2 origin;
    double log_scale;
};

static double moved(const struct plain *s, scalar *f, struct vec2 z,
                    struct vec2 *gradient)
{
    struct shear_frame frame = { .z = vec2_add(z, s->origin) };

    for (size_t i = s->shears; i-- > 0;)
        frame.z = shear_undo(&s->shear[i], frame.z);
    const double value = f(s->p, frame.z, &frame.gradient);
    for (size_t i = 0; i < s->shears; i++)
        shear_carry(&s->shear[i], &frame);
    *gradient = frame.gradient;
    return value;
}

static void plain_jacobian(const void *ctx, struct vec2 z,
                           struct planar_jacobian *J)
{
    const struct plain *s = ctx;
    struct vec2 gx, gy;

    J->field.direction.x = moved(s, s->x, z, &gx);
    J->field.direction.y = moved(s, s->y, z, &gy);
    J->field.log_scale = s->log_scale;
    J->matrix = (struct mat2){ gx.x, gx.y, gy.x, gy.y };
}

static void plain_field(const void *ctx, struct vec2 z, struct planar_field *f)
{
    struct planar_jacobian J;

    plain_jacobian(ctx, z, &J);
    *f = J.field;
}

static struct planar planar_of(const struct plain *s)
{
    return (struct planar){
        .name = "plain",
        .domain = { { -50.0, -50.0 }, { 50.0, 50.0 } },
        .origin = s->origin,
        .field = plain_field,
        .jacobian = plain_jacobian,
        .ctx = s,
    };
}

static double one(const double p[], struct vec2 z, struct vec2 *g)
{
    (void) p, (void) z;
    *g = (struct vec2){ 0.0, 0.0 };
    return 1.0;
}

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

static double height(const double p[], struct vec2 z, struct vec2 *g)
{
    *g = (struct vec2){ 0.0, 1.0 };
    return z.y - p[1];
}

static double square(const double p[], struct vec2 z, struct vec2 *g)
{
    *g = (struct vec2){ 2.0 * (z.x - p[1]), 0.0 };
    return (z.x - p[1]) * (z.x - p[1]);
}

/* y^2 - x^3 */
static double cusp(const double p[], struct vec2 z, struct vec2 *g)
{
    (void) p;
    *g = (struct vec2){ -3.0 * z.x * z.x, 2.0 * z.y };
    return z.y * z.y - z.x * z.x * z.x;
}

/* x y - p0: two branches that all but touch */
static double hyperbola(const double p[], struct vec2 z, struct vec2 *g)
{
    *g = (struct vec2){ z.y, z.x };
    return z.x * z.y - p[0];
}

static void find(const struct planar *sys, const struct window *w,
                 struct nullcline out[NULLCLINES])
{
    const enum status s = nullcline_find(sys, w, TOL_NULLCLINE_CHORD, out);
    CHECK(s == STATUS_OK, "%s", status_text(s));
}

static void drop(struct nullcline n[NULLCLINES])
{
    for (int k = 0; k < NULLCLINES; k++) {
        nullcline_free(&n[k]);
        nullcline_free(&n[k]);
    }
}

static bool on_edge(struct box b, struct vec2 z)
{
    return z.x == b.lo.x || z.x == b.hi.x || z.y == b.lo.y || z.y == b.hi.y;
}

static bool is_closed(const struct polyline *p)
{
    return memcmp(&p->at[0], &p->at[p->count - 1], sizeof p->at[0]) == 0;
}

/* Inside the window, closed or with both ends exactly on its edge. */
static void check_ends(const struct nullcline *n, const struct window *w)
{
    assert_int_equal(n->loose, 0);
    for (size_t i = 0; i < n->count; i++) {
        const struct polyline *p = &n->piece[i];
        const struct vec2 a = p->at[0], b = p->at[p->count - 1];
        CHECK(p->count >= 2, "%zu points", p->count);
        CHECK(is_closed(p) || (on_edge(w->box, a) && on_edge(w->box, b)),
              "from (%.17g, %.17g) to (%.17g, %.17g)", a.x, a.y, b.x, b.y);
        for (size_t k = 0; k < p->count; k++)
            CHECK(box_holds(w->box, p->at[k]), "(%g, %g)", p->at[k].x,
                  p->at[k].y);
    }
}

/* The largest distance in chart coordinates from a point to the zero set. */
static double worst(const struct plain *s, scalar *f, const struct nullcline *n)
{
    double most = 0.0;

    for (size_t i = 0; i < n->count; i++)
        for (size_t k = 0; k < n->piece[i].count; k++) {
            struct vec2 g;
            const struct vec2 z = vec2_sub(n->piece[i].at[k], s->origin);
            const double v = moved(s, f, z, &g);
            most = fmax(most, fabs(v) / fmax(vec2_length(g), 1e-6));
        }
    return most;
}

static double length_of(const struct polyline *p)
{
    double sum = 0.0;

    for (size_t k = 1; k < p->count; k++)
        sum += vec2_length(vec2_sub(p->at[k], p->at[k - 1]));
    return sum;
}

/* Distance from a point to a polyline, in units of the window's sides. */
static double distance(const struct nullcline *n, const struct window *w,
                       struct vec2 z)
{
    const struct vec2 u = window_unit(w, z);
    double least = INFINITY;

    for (size_t i = 0; i < n->count; i++)
        for (size_t k = 1; k < n->piece[i].count; k++) {
            const struct vec2 a = window_unit(w, n->piece[i].at[k - 1]);
            const struct vec2 b = window_unit(w, n->piece[i].at[k]);
            const struct vec2 d = vec2_sub(b, a), e = vec2_sub(u, a);
            const double l2 = d.x * d.x + d.y * d.y;
            const double t =
                l2 > 0.0 ? fmin(1, fmax(0, (d.x * e.x + d.y * e.y) / l2)) : 0.0;
            least = fmin(least, vec2_length(vec2_sub(e, vec2_scale(t, d))));
        }
    return least;
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
            CHECK(distance(n, w, z) < 1.2 * TOL_NULLCLINE_CHORD,
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

static void branches_that_all_but_touch_stay_apart(void **state)
{
    const struct window w = { .box = { { -1.0, -1.0 }, { 1.01, 1.02 } } };

    (void) state;
    for (int k = 2; k <= 8; k++) {
        const struct plain s = { .x = hyperbola,
                                 .y = one,
                                 .p = { pow(10.0, -k) } };
        const struct planar sys = planar_of(&s);
        struct nullcline n[NULLCLINES];
        find(&sys, &w, n);
        check_ends(&n[0], &w);
        CHECK(n[0].count == 2, "%zu pieces at 1e-%d", n[0].count, k);
        CHECK(worst(&s, s.x, &n[0]) < 1e-12, "off by %g", worst(&s, s.x, n));
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

static void cusps_are_loose_ends(void **state)
{
    const struct plain s = { .x = cusp, .y = one };
    const struct planar sys = planar_of(&s);
    const struct window w = { .box = { { -1.0, -1.1 }, { 1.0, 1.2 } } };
    struct nullcline n[NULLCLINES];

    (void) state;
    find(&sys, &w, n);
    assert_int_equal(n[0].count, 2);
    assert_int_equal(n[0].loose, 2);
    for (size_t k = 0; k < 2; k++) {
        const struct polyline *p = &n[0].piece[k];
        CHECK(fabs(p->at[0].x - 1.0) == 0.0, "starts at %g", p->at[0].x);
        CHECK(vec2_length(p->at[p->count - 1]) < 1e-3, "ends at (%g, %g)",
              p->at[p->count - 1].x, p->at[p->count - 1].y);
    }
    drop(n);
}

/* x' = x - 0.3 y, y' = exp(2000 y): direction.x underflows for y > 0.37. */
struct steep {
    bool keeps_sign;
};

static void steep_jacobian(const void *ctx, struct vec2 z,
                           struct planar_jacobian *J)
{
    const struct steep *s = ctx;
    const double scale = fmax(0.0, 2000.0 * z.y), e = exp(-scale);
    double x = (z.x - 0.3 * z.y) * e;

    if (x == 0.0 && !s->keeps_sign)
        x = 0.0;
    J->field = (struct planar_field){ { x, exp(2000.0 * z.y - scale) }, scale };
    J->matrix =
        (struct mat2){ e, -0.3 * e, 0.0, 2000.0 * J->field.direction.y };
}

static void steep_field(const void *ctx, struct vec2 z, struct planar_field *f)
{
    struct planar_jacobian J;

    steep_jacobian(ctx, z, &J);
    *f = J.field;
    if (f->direction.x == 0.0 && !((const struct steep *) ctx)->keeps_sign)
        f->direction.x = 0.0;
}

static void check_on_steep_line(const struct nullcline *n)
{
    for (size_t k = 0; k < n->piece[0].count; k++) {
        const struct vec2 z = n->piece[0].at[k];
        CHECK(fabs(z.x - 0.3 * z.y) < 3e-11, "(%g, %g)", z.x, z.y);
    }
}

static void underflow_is_not_taken_for_a_zero(void **state)
{
    const struct window w = { .box = { { -1.0, -1.0 }, { 1.0, 1.0 } } };

    (void) state;
    for (int keeps = 0; keeps < 2; keeps++) {
        const struct steep s = { keeps };
        const struct planar sys = { .domain = { { -9.0, -9.0 }, { 9.0, 9.0 } },
                                    .field = steep_field,
                                    .jacobian = steep_jacobian,
                                    .ctx = &s };
        struct nullcline n[NULLCLINES];
        find(&sys, &w, n);
        assert_int_equal(n[1].count, 0);
        assert_int_equal(n[0].count, 1);
        assert_int_equal(n[0].loose, keeps ? 0 : 1);
        check_on_steep_line(&n[0]);
        const double top = n[0].piece[0].at[n[0].piece[0].count - 1].y;
        CHECK(keeps ? top == 1.0 : top > 0.3 && top < 0.373, "up to y = %g",
              top);
        drop(n);
    }
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
            CHECK(d < TOL_NULLCLINE_CHORD, "off by %g at x = %g", d, x);
        }
        drop(n);
    }
}

static void friction_nullclines_are_the_closed_forms(void **state)
{
    const struct material m = material_bristol_board();
    const struct law *law;
    size_t laws = 0;

    (void) state;
    for (size_t i = 0; (law = law_preset_at(i)); i++) {
        struct block b;
        struct nullcline n[NULLCLINES];
        const double y = law_psi_is_log(law) ? 1.0 : 0.0;
        const struct window w = { .box = { { -12.0, -11.5 - 10.0 * y },
                                           { 12.0, 11.0 + 10.0 * y } } };
        block_init(&b, law, &m, 0.35L);
        block_anchor(&b, -0.2L, false);
        const struct planar sys = block_planar(&b);
        find(&sys, &w, n);
        CHECK(n[0].count == 1 && n[0].loose == 0, "%s: %zu pieces, %zu loose",
              law->preset, n[0].count, n[0].loose);
        CHECK(n[1].count == 1 && n[1].loose == 0, "%s: %zu pieces, %zu loose",
              law->preset, n[1].count, n[1].loose);
        check_ends(&n[0], &w);
        check_ends(&n[1], &w);
        for (size_t k = 0; k < n[0].piece[0].count; k++) {
            const struct vec2 z = n[0].piece[0].at[k];
            const double mu = block_mu(&b, vec2_sub(z, sys.origin));
            CHECK(fabs(mu - 0.35) < 1e-12, "%s: mu = %.15g at (%g, %g)",
                  law->preset, mu, z.x, z.y);
        }
        for (size_t k = 0; k < n[1].piece[0].count; k++) {
            const struct vec2 z = n[1].piece[0].at[k];
            const double off = z.y - (double) sys.steady->y(&b, z.x);
            CHECK(fabs(off) < 1e-10, "%s: off by %g at (%g, %g)", law->preset,
                  off, z.x, z.y);
        }
        CHECK(n[0].evaluations + n[1].evaluations < 30000, "%zu evaluations",
              n[0].evaluations + n[1].evaluations);
        drop(n);
        laws++;
    }
    CHECK(laws > 5, "%zu laws", laws);
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
        cmocka_unit_test(branches_that_all_but_touch_stay_apart),
        cmocka_unit_test(zeros_on_grid_nodes_make_one_piece),
        cmocka_unit_test(cusps_are_loose_ends),
        cmocka_unit_test(underflow_is_not_taken_for_a_zero),
        cmocka_unit_test(linear_axes_get_the_points_they_need),
        cmocka_unit_test(friction_nullclines_are_the_closed_forms),
        cmocka_unit_test(windows_without_zeros_are_fine_and_bad_ones_are_not),
        cmocka_unit_test(every_allocation_fails_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
