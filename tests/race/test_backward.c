/* The second route against systems whose manifolds are known exactly. */
#include "backward.h"

#include <math.h>

#include "backward_end.h"
#include "check.h"
#include "eigen_frame.h"
#include "fault_alloc.h"
#include "fixtures.h"
#include "stops.h"

/* ---- exact systems ------------------------------------------------------- */

static struct backward_options options_of(double rtol)
{
    struct backward_options o = backward_defaults(rtol);

    o.max_steps = 400; /* loops never end */
    o.carry =
        (struct carry){ { FIXTURE_X_MOVED, FIXTURE_Y_MOVED, CARRY_TIME }, 3 };
    return o;
}

/* One branch of a fixture's saddle at its origin. */
static struct branch branch_of(const struct planar *sys, int side, double rtol)
{
    const struct backward_options o = options_of(rtol);
    struct equilibrium e;
    struct branch b;

    equilibrium_at(sys, false, &e);
    const enum status s = backward_branch(sys, &e, side, &o, &b);
    CHECK(s == STATUS_OK, "side %d: %s", side, status_text(s));
    CHECK(b.curve.count > 5, "%zu pieces", b.curve.count);
    return b;
}

/* Distance from the exact manifold, first order: implicit over its gradient. */
static double distance(const struct fixture *f, struct vec2 z)
{
    const double h = 1e-6 * (1.0 + fabs(z.x) + fabs(z.y));
    const double here = fixture_implicit(f, FIXTURE_STABLE, z);
    double slope[2];

    for (int i = 0; i < 2; i++) {
        const struct vec2 step = { i == 0 ? h : 0.0, i == 1 ? h : 0.0 };
        const double up =
            fixture_implicit(f, FIXTURE_STABLE, vec2_add(z, step));
        const double down =
            fixture_implicit(f, FIXTURE_STABLE, vec2_sub(z, step));
        slope[i] = (up - down) / (2.0 * h);
    }
    return here == 0.0 ? 0.0 : fabs(here) / hypot(slope[0], slope[1]);
}

/* Where the exact formulas are well conditioned. */
static bool is_nearby(struct vec2 u)
{
    return fabs(u.x) < 1.2 && fabs(u.y) < 3.0;
}

static void check_point(const struct fixture *f, const double at[], double tol)
{
    const struct vec2 z = { at[0], at[1] };
    const struct vec2 u = fixture_base_point(f, z);
    const double size = 1.0 + fabs(z.x) + fabs(z.y);

    CHECK(distance(f, z) <= tol * size, "base %d, u = (%g, %g): %.3g off",
          (int) f->base, u.x, u.y, distance(f, z));
    CHECK(hypot(at[2] - u.x, at[3] - u.y) <= 100.0 * tol * size,
          "base %d: integrals (%.15g, %.15g), not (%.15g, %.15g)",
          (int) f->base, at[2], at[3], u.x, u.y);
}

static void check_curve(const struct fixture *f, const struct curve *c,
                        double tol)
{
    double at[CURVE_DIM_MAX];

    for (size_t i = 0; i < 4 * c->count; i++) {
        curve_at(c, i / 4, 0.25 * (double) (i % 4 + 1), at);
        if (!is_nearby(fixture_base_point(f, (struct vec2){ at[0], at[1] })))
            return;
        check_point(f, at, tol);
    }
}

static void check_fixture(const struct fixture *f, double rtol)
{
    const struct planar sys = fixture_planar(f);

    for (int side = -1; side <= 1; side += 2) {
        struct branch b = branch_of(&sys, side, rtol);
        check_curve(f, &b.curve, 100.0 * rtol + 1e-12);
        branch_free(&b);
        branch_free(&b);
    }
}

static void systems_have_their_exact_manifolds(void **state)
{
    (void) state;
    fixture_each(200, check_fixture);
}

/* ---- coordinates --------------------------------------------------------- */

static struct vec2 in_W(const struct equilibrium *e, const double z[])
{
    return eigen_coordinates(eigen_basis(e), (struct vec2){ z[0], z[1] });
}

/* Y = S(X) with S(0) = S'(0) = 0. */
static void the_curve_leaves_the_saddle_along_the_first_axis(void **state)
{
    uint64_t rng = check_seed() + 2;

    (void) state;
    for (int i = 0; i < 50; i++) {
        struct fixture f;
        const int side = i % 2 ? 1 : -1;
        fixture_random(&f, (enum fixture_base)(i % FIXTURE_BASES), &rng);
        const struct planar sys = fixture_planar(&f);
        struct branch b = branch_of(&sys, side, 1e-10);
        struct equilibrium e;
        double at[CURVE_DIM_MAX], slope[CURVE_DIM_MAX], end[CURVE_DIM_MAX];
        equilibrium_at(&sys, false, &e);
        curve_at(&b.curve, 0, 0.0, at);
        curve_slope_at(&b.curve, 0, 0.0, slope);
        curve_at(&b.curve, 0, 1.0, end);
        CHECK(at[0] == 0.0 && at[1] == 0.0, "(%g, %g)", at[0], at[1]);
        const struct vec2 way = in_W(&e, slope), W = in_W(&e, end);
        CHECK(side * way.x > 0.0 && fabs(way.y) <= 1e-14 * fabs(way.x),
              "side %d: (%g, %g)", side, way.x, way.y);
        CHECK(fabs(W.y) <= fabs(W.x), "Y = %g at X = %g", W.y, W.x);
        branch_free(&b);
    }
}

/* ---- ends ---------------------------------------------------------------- */

/*
 *     x' = -tanh x,  y' = (y - tanh^2 x)/cosh^2 x,  q' = tanh x/cosh^2 x,
 *
 * a saddle at 0 whose stable manifold is y = tanh^2(x)/3: with T = tanh x,
 * dy/dT = T - y/T.  y -> 1/3, and q outwards grows by int dx/cosh^2 x = 1.
 */
static void flat_field(const void *ctx, struct vec2 z, struct planar_field *f)
{
    const double s = 1.0 / cosh(z.x), t = tanh(z.x);

    (void) ctx;
    f->direction.x = -t;
    f->direction.y = (z.y - t * t) * s * s;
    f->log_scale = 0.0;
}

static void flat_jacobian(const void *ctx, struct vec2 z,
                          struct planar_jacobian *J)
{
    const double s = 1.0 / cosh(z.x), t = tanh(z.x);

    flat_field(ctx, z, &J->field);
    J->matrix.xx = -s * s;
    J->matrix.xy = 0.0;
    J->matrix.yx = -2.0 * t * s * s * (s * s + z.y - t * t);
    J->matrix.yy = s * s;
}

static void flat_rate(const void *ctx, size_t which, struct vec2 z,
                      double *rate, struct vec2 *gradient)
{
    (void) ctx, (void) which;
    const double s = 1.0 / cosh(z.x), t = tanh(z.x);

    *rate = t * s * s;
    if (gradient)
        *gradient = (struct vec2){ s * s * (1.0 - 3.0 * t * t), 0.0 };
}

static const struct planar flat = {
    .name = "flat",
    .domain = { { -60.0, -60.0 }, { 60.0, 60.0 } },
    .field = flat_field,
    .jacobian = flat_jacobian,
    .observable_count = 1,
    .rate_gradient = flat_rate,
};

static void a_limit_and_an_integral_are_inside_their_bars(void **state)
{
    struct equilibrium e;

    (void) state;
    equilibrium_at(&flat, false, &e);
    for (int k = 4; k <= 12; k += 2)
        for (int side = -1; side <= 1; side += 2) {
            struct backward_options o = backward_defaults(pow(10.0, -k));
            struct branch q;
            o.carry = (struct carry){ { 0 }, 1 };
            assert_int_equal(backward_branch(&flat, &e, side, &o, &q),
                             STATUS_OK);
            const struct branch *b = &q;
            assert_int_equal(b->end, BRANCH_LIMIT_Y);
            assert_int_equal(b->sign, side);
            const double off = fabs(b->limit.y - 1.0 / 3.0);
            CHECK(off <= b->error.y, "limit off by %g, bar %g", off,
                  b->error.y);
            CHECK(b->error.y <= 1000.0 * o.rtol, "bar %g", b->error.y);
            const double missing = fabs(fabs(b->total[0]) - 1.0);
            CHECK(missing <= b->total_error[0], "total off by %g, bar %g",
                  missing, b->total_error[0]);
            CHECK(b->total_error[0] <= 1000.0 * o.rtol, "bar %g",
                  b->total_error[0]);
            branch_free(&q);
        }
}

/* The same, but a limit is not in sight before the edge. */
static void a_branch_that_leaves_the_domain_says_so(void **state)
{
    struct planar small = flat;
    struct equilibrium e;
    const struct backward_options o = backward_defaults(1e-12);
    struct branch b;

    (void) state;
    small.domain = (struct box){ { -2.0, -2.0 }, { 2.0, 2.0 } };
    equilibrium_at(&small, false, &e);
    assert_int_equal(backward_branch(&small, &e, 1, &o, &b), STATUS_OK);
    assert_int_equal(b.end, BRANCH_DOMAIN);
    assert_true(fabs(b.limit.x - 2.0) < 1e-9);
    branch_free(&b);
}

static void integrals_converge_whose_rate_vanishes_at_the_saddle(void **state)
{
    const struct carry carry = { { FIXTURE_X_MOVED, FIXTURE_CLOCK, CARRY_TIME },
                                 3 };
    struct fixture f;

    (void) state;
    fixture_plain(&f, FIXTURE_DUFFING);
    const struct planar sys = fixture_planar(&f);
    const struct backward_way g = backward_way_of(&sys, &carry);
    assert_true(g.converges[0]);
    assert_false(g.converges[1]);
    assert_false(g.converges[2]);
}

/* ---- what it refuses ----------------------------------------------------- */

static void wrong_arguments_are_refused(void **state)
{
    struct equilibrium e;
    struct branch b;
    struct backward_options o = backward_defaults(1e-12);
    struct planar far = flat;

    (void) state;
    equilibrium_at(&flat, false, &e);
    assert_int_equal(backward_branch(&flat, &e, 0, &o, &b),
                     STATUS_BAD_ARGUMENT);
    assert_int_equal(backward_branch(&flat, &e, 2, &o, &b),
                     STATUS_BAD_ARGUMENT);
    far.origin.x = 61.0; /* outside the domain */
    assert_int_equal(backward_branch(&far, &e, 1, &o, &b), STATUS_BAD_ARGUMENT);
    o.rtol = 1.0;
    assert_int_equal(backward_branch(&flat, &e, 1, &o, &b),
                     STATUS_BAD_ARGUMENT);
    o.rtol = NAN;
    assert_int_equal(backward_branch(&flat, &e, 1, &o, &b),
                     STATUS_BAD_ARGUMENT);
    o.rtol = 1e-9;
    o.carry.count = LOCAL_CARRY_MAX + 1;
    assert_int_equal(backward_branch(&flat, &e, 1, &o, &b),
                     STATUS_BAD_ARGUMENT);
    assert_int_equal(b.curve.count, 0);
    branch_free(&b);
}

static void a_node_has_no_such_manifold(void **state)
{
    const struct backward_options o = backward_defaults(1e-12);
    struct fixture f;
    struct equilibrium e;
    struct branch b;

    (void) state;
    fixture_plain(&f, FIXTURE_PITCHFORK);
    fixture_center(&f, f.equilibrium[1].base);
    const struct planar sys = fixture_planar(&f);
    equilibrium_at(&sys, false, &e);
    assert_int_equal(backward_branch(&sys, &e, 1, &o, &b),
                     STATUS_NOT_HYPERBOLIC);
    branch_free(&b);
}

static void broken_field(const void *ctx, struct vec2 z, struct planar_field *f)
{
    (void) ctx, (void) z;
    f->direction = (struct vec2){ NAN, NAN };
    f->log_scale = 0.0;
}

static void a_field_of_nan_is_no_endless_search(void **state)
{
    const struct backward_options o = backward_defaults(1e-12);
    struct planar broken = flat;
    struct equilibrium e;
    struct branch b;

    (void) state;
    equilibrium_at(&flat, false, &e);
    broken.field = broken_field;
    assert_int_equal(backward_branch(&broken, &e, 1, &o, &b),
                     STATUS_NO_CONVERGENCE);
    assert_int_equal(b.curve.count, 0);
}

static void the_monitor_can_stop_it(void **state)
{
    const struct monitor monitor = { stop_at_once, NULL };
    struct backward_options o = backward_defaults(1e-12);
    struct equilibrium e;
    struct branch b;

    (void) state;
    o.monitor = &monitor;
    equilibrium_at(&flat, false, &e);
    assert_int_equal(backward_branch(&flat, &e, 1, &o, &b), STATUS_STOPPED);
    assert_int_equal(b.curve.count, 0);
}

static void any_allocation_may_fail(void **state)
{
    const struct backward_options o = backward_defaults(1e-6);
    struct equilibrium e;
    struct branch b;
    enum status s = STATUS_NO_MEMORY;

    (void) state;
    equilibrium_at(&flat, false, &e);
    for (long k = 0; s != STATUS_OK; k++) {
        fault_alloc_at(k);
        s = backward_branch(&flat, &e, 1, &o, &b);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        CHECK(s == STATUS_OK || s == STATUS_NO_MEMORY, "%ld: %s", k,
              status_text(s));
        CHECK(s == STATUS_OK || b.curve.count == 0, "%ld: not empty", k);
        branch_free(&b);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(systems_have_their_exact_manifolds),
        cmocka_unit_test(the_curve_leaves_the_saddle_along_the_first_axis),
        cmocka_unit_test(a_limit_and_an_integral_are_inside_their_bars),
        cmocka_unit_test(a_branch_that_leaves_the_domain_says_so),
        cmocka_unit_test(integrals_converge_whose_rate_vanishes_at_the_saddle),
        cmocka_unit_test(wrong_arguments_are_refused),
        cmocka_unit_test(a_node_has_no_such_manifold),
        cmocka_unit_test(a_field_of_nan_is_no_endless_search),
        cmocka_unit_test(the_monitor_can_stop_it),
        cmocka_unit_test(any_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
