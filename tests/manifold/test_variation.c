/* Branches that are moved along with the whole plane: under z -> z + p V(z) a
 * field f becomes f + p (DV f - Df V), and its manifolds move by V. */
#include "variation.h"

#include <math.h>

#include "check.h"
#include "fixtures.h"
#include "grow.h"

/* V = constant + linear + bent, one parameter each and all together. */
enum { MOTIONS = 4 };

struct motion {
    struct vec2 V;
    struct mat2 DV;
};

static struct motion motion_at(int which, struct vec2 z)
{
    const struct motion part[] = {
        { { 0.7, -0.4 }, { 0, 0, 0, 0 } },
        { { 0.3 * z.x - z.y, 0.5 * z.x + 0.2 * z.y }, { 0.3, -1, 0.5, 0.2 } },
        { { sin(z.y), 0.5 * z.x * z.x }, { 0, cos(z.y), z.x, 0 } },
    };
    struct motion all = { 0 };

    if (which < 3)
        return part[which];
    for (int i = 0; i < 3; i++) {
        all.V = vec2_add(all.V, part[i].V);
        all.DV.xx += part[i].DV.xx;
        all.DV.xy += part[i].DV.xy;
        all.DV.yx += part[i].DV.yx;
        all.DV.yy += part[i].DV.yy;
    }
    return all;
}

static struct vec2 times(struct mat2 m, struct vec2 v)
{
    return (struct vec2){ m.xx * v.x + m.xy * v.y, m.yx * v.x + m.yy * v.y };
}

static void gradient(const void *ctx, struct vec2 z,
                     const struct planar_field *f, struct vec2 out[])
{
    const struct planar *sys = ctx;
    struct planar_jacobian J;

    sys->jacobian(sys->ctx, z, &J);
    for (int i = 0; i < MOTIONS; i++) {
        const struct motion m = motion_at(i, z);
        out[i] = vec2_sub(times(m.DV, f->direction), times(J.matrix, m.V));
    }
}

/* A branch of at most `steps` steps on one side of the fixture's saddle. */
static void branch_of(const struct planar *sys, int side, size_t steps,
                      double rtol, struct branch *b)
{
    struct grow_options o = grow_defaults(rtol);
    struct local_series u;
    struct equilibrium e;

    o.max_steps = steps;
    equilibrium_at(sys, false, &e);
    enum status s =
        local_at(sys, &e, MANIFOLD_STABLE, &o.carry, o.order, 0.01 * rtol, &u);
    assert_int_equal(s, STATUS_OK);
    s = grow_branch(sys, &u, side, &o, b);
    assert_int_equal(s, STATUS_OK);
}

/* The piece's graph is over the coordinate that is linear along it. */
static int graph_at_end(const struct branch *b)
{
    const size_t last = b->curve.count - 1, n = b->curve.piece[last].degree;
    const double *x = curve_component(&b->curve, last, 0);

    for (size_t k = 2; k <= n; k++)
        if (x[k] != 0.0)
            return 1;
    return x[1] == 0.0;
}

/* The largest error of eta at the branch's end, relative to V. */
static double error_at_end(const struct planar *sys, const struct branch *b,
                           size_t nodes, double tol)
{
    const struct variation v = { MOTIONS, gradient, sys, nodes, tol };
    double at[CURVE_DIM_MAX], end[MOTIONS], rest[MOTIONS], worst = 0.0;

    variation_along(sys, b, &v, end, rest);
    curve_at(&b->curve, b->curve.count - 1, 1.0, at);
    const struct vec2 z = { at[0], at[1] };
    const int ind = graph_at_end(b);
    const double slope = local_slope(sys, ind, z);
    for (int i = 0; i < MOTIONS; i++) {
        const struct vec2 V = motion_at(i, z).V;
        const double want = ind == 0 ? V.y - slope * V.x : V.x - slope * V.y;
        const double size = fabs(V.x) + fabs(V.y) + 1.0;
        worst = fmax(worst, fabs(end[i] - want) / size);
    }
    return worst;
}

/* Far out, where the motion of the plane turns in every direction within one
 * step of the branch, nobody can follow it. */
static bool is_near(const struct branch *b)
{
    double at[CURVE_DIM_MAX];

    curve_at(&b->curve, b->curve.count - 1, 1.0, at);
    return fabs(at[0]) < 6.0 && fabs(at[1]) < 6.0;
}

static void a_branch_moves_with_the_plane(void **state)
{
    uint64_t seed = check_seed();
    int compared = 0;

    (void) state;
    for (int i = 0; i < 200; i++) {
        struct fixture f;
        struct branch b;
        const enum fixture_base base = (enum fixture_base)(i % FIXTURE_BASES);
        fixture_random(&f, base, &seed);
        const struct planar sys = fixture_planar(&f);
        const size_t steps = 1 + (size_t) (check_bits(&seed) % 4);
        branch_of(&sys, i / FIXTURE_BASES % 2 ? 1 : -1, steps, 1e-13, &b);
        if (!is_near(&b)) {
            branch_free(&b);
            continue;
        }
        const double error = error_at_end(&sys, &b, 10, 1e-14);
        CHECK(error < 1e-11, "fixture %d of base %d, %zu steps: off by %g", i,
              (int) base, b.steps, error);
        compared++;
        branch_free(&b);
    }
    CHECK(compared > 100, "only %d of 200", compared);
}

static void the_series_alone_moves_too(void **state)
{
    uint64_t seed = check_seed();

    (void) state;
    for (int i = 0; i < 4 * FIXTURE_BASES; i++) {
        struct fixture f;
        struct branch b;
        fixture_random(&f, (enum fixture_base)(i % FIXTURE_BASES), &seed);
        const struct planar sys = fixture_planar(&f);
        branch_of(&sys, 1, 0, 1e-13, &b);
        assert_int_equal(b.curve.count, 1);
        const double error = error_at_end(&sys, &b, 10, 1e-14);
        CHECK(error < 1e-11, "fixture %d: off by %g", i, error);
        branch_free(&b);
    }
}

static void more_points_leave_less_error(void **state)
{
    uint64_t seed = check_seed();
    double coarse = 0.0, fine = 0.0;

    (void) state;
    for (int i = 0; i < 40; i++) {
        struct fixture f;
        struct branch b;
        fixture_random(&f, (enum fixture_base)(i % FIXTURE_BASES), &seed);
        const struct planar sys = fixture_planar(&f);
        branch_of(&sys, 1, 3, 1e-13, &b);
        if (is_near(&b)) {
            coarse = fmax(coarse, error_at_end(&sys, &b, 2, 1e9));
            fine = fmax(fine, error_at_end(&sys, &b, 6, 1e9));
        }
        branch_free(&b);
    }
    CHECK(fine < 0.1 * coarse && coarse > 1e-9, "%g at 2 points, %g at 6",
          coarse, fine);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_branch_moves_with_the_plane),
        cmocka_unit_test(the_series_alone_moves_too),
        cmocka_unit_test(more_points_leave_less_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
