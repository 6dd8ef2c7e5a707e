/* Eigen-coordinates of a saddle: the basis, and a field seen in it. */
#include "eigen_frame.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>

#include "check.h"
#include "fixtures.h"

/* A random saddle with its system. */
static void draw_saddle(uint64_t *rng, size_t i, struct fixture *f,
                        struct planar *sys, struct equilibrium *e)
{
    fixture_random(f, (enum fixture_base)(i % FIXTURE_BASES), rng);
    *sys = fixture_planar(f);
    equilibrium_at(sys, false, e);
}

static void coordinates_there_and_back_are_the_point(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 1000; i++) {
        const struct mat2 P = { 1.0, check_uniform(&rng, -1, 1),
                                check_uniform(&rng, -0.5, 0.5), 1.0 };
        const struct vec2 z = { check_uniform(&rng, -9, 9),
                                check_uniform(&rng, -9, 9) };
        const struct vec2 back = eigen_point(P, eigen_coordinates(P, z));
        CHECK(hypot(back.x - z.x, back.y - z.y) <= 1e-13,
              "(%g, %g) became (%g, %g)", z.x, z.y, back.x, back.y);
    }
}

static void check_column(struct mat2 A, double lambda, struct vec2 u)
{
    const struct vec2 Au = eigen_point(A, u);
    const double size = fabs(A.xx) + fabs(A.xy) + fabs(A.yx) + fabs(A.yy);

    CHECK(hypot(Au.x - lambda * u.x, Au.y - lambda * u.y) <= 1e-13 * size,
          "A (%g, %g) = (%g, %g), lambda %g", u.x, u.y, Au.x, Au.y, lambda);
    CHECK(fabs(fmax(fabs(u.x), fabs(u.y)) - 1.0) <= 1e-15, "(%g, %g)", u.x,
          u.y);
    CHECK(u.x > 0.0 || (u.x == 0.0 && u.y > 0.0), "(%g, %g)", u.x, u.y);
}

static void columns_are_eigenvectors_of_size_one(void **state)
{
    uint64_t rng = check_seed() + 1;

    (void) state;
    for (size_t i = 0; i < 400; i++) {
        struct fixture f;
        struct planar sys;
        struct equilibrium e;
        draw_saddle(&rng, i, &f, &sys, &e);
        const struct mat2 P = eigen_basis(&e);
        check_column(e.matrix, e.scaled[0], (struct vec2){ P.xx, P.yx });
        check_column(e.matrix, e.scaled[1], (struct vec2){ P.xy, P.yy });
    }
}

/* dX/dt = lambda_- X, dY/dt = lambda_+ Y to first order. */
static void near_the_saddle_the_axes_go_their_own_ways(void **state)
{
    uint64_t rng = check_seed() + 2;

    (void) state;
    for (size_t i = 0; i < 400; i++) {
        struct fixture f;
        struct planar sys;
        struct equilibrium e;
        struct planar_field at;
        draw_saddle(&rng, i, &f, &sys, &e);
        const struct mat2 P = eigen_basis(&e);
        const struct vec2 W = { 1e-7, 2e-7 };
        sys.field(sys.ctx, eigen_point(P, W), &at);
        const struct vec2 v = eigen_coordinates(P, at.direction);
        const double unit = exp(at.log_scale);
        CHECK(fabs(unit * v.x - e.lambda[0] * W.x) <=
                  1e-5 * fabs(e.lambda[0] * W.x) + 1e-5 * unit * W.y,
              "Xdot = %g, lambda X = %g", unit * v.x, e.lambda[0] * W.x);
        CHECK(fabs(unit * v.y - e.lambda[1] * W.y) <=
                  1e-5 * fabs(e.lambda[1] * W.y) + 1e-5 * unit * W.x,
              "Ydot = %g, lambda Y = %g", unit * v.y, e.lambda[1] * W.y);
    }
}

/* ---- the stable manifold once more ----------------------------------------
 */

struct seen {
    const struct planar *sys;
    struct mat2 P;
};

/* The field in eigen-coordinates, backward in time, by arc length. */
static int backward(double s, const double W[], double dW[], void *ctx)
{
    const struct seen *a = ctx;
    struct planar_field f;

    (void) s;
    a->sys->field(a->sys->ctx, eigen_point(a->P, (struct vec2){ W[0], W[1] }),
                  &f);
    const struct vec2 d = eigen_coordinates(a->P, f.direction);
    dW[0] = -d.x / hypot(d.x, d.y);
    dW[1] = -d.y / hypot(d.x, d.y);
    return GSL_SUCCESS;
}

/* From the exact curve: what is not zero there over its gradient. */
static double distance(const struct fixture *f, struct vec2 z)
{
    const double h = 1e-6 * (1.0 + fabs(z.x) + fabs(z.y));
    const struct vec2 side[] = { { h, 0.0 }, { 0.0, h } };
    double slope[2];

    for (int i = 0; i < 2; i++)
        slope[i] = (fixture_implicit(f, FIXTURE_STABLE, vec2_add(z, side[i])) -
                    fixture_implicit(f, FIXTURE_STABLE, vec2_sub(z, side[i]))) /
                   (2.0 * h);
    return fabs(fixture_implicit(f, FIXTURE_STABLE, z)) /
           hypot(slope[0], slope[1]);
}

/* From where the X axis is the curve, by a foreign method without series. */
static void an_orbit_in_eigen_coordinates_runs_along_the_stable_manifold(
    void **state)
{
    uint64_t rng = check_seed() + 3;
    size_t held = 0;

    (void) state;
    for (size_t i = 0; i < 200; i++) {
        struct fixture f;
        struct planar sys;
        struct equilibrium e;
        draw_saddle(&rng, i, &f, &sys, &e);
        struct seen a = { &sys, eigen_basis(&e) };
        gsl_odeiv2_system system = { backward, NULL, 2, &a };
        gsl_odeiv2_driver *d = gsl_odeiv2_driver_alloc_y_new(
            &system, gsl_odeiv2_step_rk8pd, 1e-9, 1e-14, 1e-13);
        double s = 0.0, W[] = { i % 2 ? 1e-8 : -1e-8, 0.0 };
        for (int k = 1; k <= 8; k++) {
            assert_int_equal(gsl_odeiv2_driver_apply(d, &s, 0.1 * k, W), 0);
            const struct vec2 z = eigen_point(a.P, (struct vec2){ W[0], W[1] });
            const struct vec2 u = fixture_base_point(&f, z);
            if (!(fabs(u.x) < 1.2 && fabs(u.y) < 3.0))
                break;
            CHECK(distance(&f, z) <= 1e-10 * (1.0 + fabs(z.x) + fabs(z.y)),
                  "%zu, %d: %g off", i, k, distance(&f, z));
            held++;
        }
        gsl_odeiv2_driver_free(d);
    }
    CHECK(held > 800, "%zu points", held);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(coordinates_there_and_back_are_the_point),
        cmocka_unit_test(columns_are_eigenvectors_of_size_one),
        cmocka_unit_test(near_the_saddle_the_axes_go_their_own_ways),
        cmocka_unit_test(
            an_orbit_in_eigen_coordinates_runs_along_the_stable_manifold),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
