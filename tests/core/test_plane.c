#include "plane.h"

#include <float.h>
#include <math.h>

#include "check.h"
#include "quad.h" /* products of doubles are exact */

static quad det_reference(struct mat2 A)
{
    return (quad) A.xx * A.yy - (quad) A.xy * A.yx;
}

static void det_keeps_its_bound_near_singular_matrices(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 100000; i++) {
        struct mat2 A = { check_uniform(&rng, -3, 3),
                          check_uniform(&rng, -3, 3),
                          check_uniform(&rng, -3, 3), 0 };
        A.yy = A.xy * A.yx / A.xx; /* det = rounding error of this line */
        const quad ref = det_reference(A);
        const double error = (double) (mat2_det(A) - ref);
        CHECK(fabs(error) <= DBL_EPSILON * fabs((double) ref),
              "A = [%a %a; %a %a]  error = %a", A.xx, A.xy, A.yx, A.yy, error);
    }
}

/* S diag(p, q) S^-1 with S = [1 b; c 1], rounded: all entries of one scale. */
static struct mat2 with_eigenvalues(double p, double q, double b, double c)
{
    const double d = 1.0 - b * c;

    return (struct mat2){ (p - b * c * q) / d, b * (q - p) / d, c * (p - q) / d,
                          (q - b * c * p) / d };
}

static void known_eigenvalues_are_found_at_every_scale(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 100000; i++) {
        const double scale = exp(check_uniform(&rng, -200, 200));
        const double p = scale * check_uniform(&rng, -1, 1);
        const double q = scale * check_uniform(&rng, -1, 1);
        const struct mat2 A = with_eigenvalues(
            p, q, check_uniform(&rng, -0.5, 0.5), check_uniform(&rng, 0, 0.5));
        const struct eigen2 e = mat2_eigenvalues(A);
        /* The rounding of A itself splits a pair by sqrt(eps). */
        const double tol = fabs(p - q) > 1e-4 * scale ? 1e-11 : 1e-7;
        CHECK(fabs(e.re[0] - fmin(p, q)) <= tol * scale &&
                  fabs(e.re[1] - fmax(p, q)) <= tol * scale,
              "%a, %a, true %a, %a", e.re[0], e.re[1], fmin(p, q), fmax(p, q));
        CHECK(e.im <= 1e-7 * scale, "im = %a", e.im);
    }
}

/* A triangular matrix is its own reference: rates 1e-12 and -1e8 keep all
 * their digits. */
static void eigenvalues_far_apart_keep_their_digits(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 100000; i++) {
        const double near = exp(check_uniform(&rng, -30, 0));
        const double far = -exp(check_uniform(&rng, 1, 30));
        const double corner = exp(check_uniform(&rng, -30, 30));
        const struct mat2 A = { far, corner, 0.0, near };
        const struct eigen2 e = mat2_eigenvalues(A);
        CHECK(fabs(e.re[0] - far) <= 4 * DBL_EPSILON * fabs(far), "%a, %a",
              e.re[0], far);
        CHECK(fabs(e.re[1] - near) <= 8 * DBL_EPSILON * near, "%a, %a", e.re[1],
              near);
    }
}

static void complex_pairs_are_found(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 10000; i++) {
        const double re = check_uniform(&rng, -1, 1);
        const double im = check_uniform(&rng, 0.1, 2);
        const double skew = exp(check_uniform(&rng, -5, 5));
        const struct mat2 A = { re, im * skew, -im / skew, re };
        const struct eigen2 e = mat2_eigenvalues(A);
        CHECK(e.re[0] == e.re[1] && fabs(e.re[0] - re) < 1e-14, "%a", e.re[0]);
        CHECK(fabs(e.im - im) < 1e-14, "%a, true %a", e.im, im);
    }
}

static void eigenvectors_solve_their_equation(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 100000; i++) {
        const double scale = exp(check_uniform(&rng, -200, 200));
        const struct mat2 A = with_eigenvalues(
            scale * check_uniform(&rng, 0.1, 1),
            -scale * exp(check_uniform(&rng, -20, 0)),
            check_uniform(&rng, -0.5, 0.5), check_uniform(&rng, -0.5, 0.5));
        const struct eigen2 e = mat2_eigenvalues(A);
        for (int k = 0; k < 2; k++) {
            const struct vec2 v = mat2_eigenvector(A, e.re[k]);
            const double rx = (A.xx - e.re[k]) * v.x + A.xy * v.y;
            const double ry = A.yx * v.x + (A.yy - e.re[k]) * v.y;
            CHECK(hypot(rx, ry) <= 8 * DBL_EPSILON * scale, "residual %a of %a",
                  hypot(rx, ry), scale);
            CHECK(fabs(vec2_length(v) - 1.0) < 4 * DBL_EPSILON, "length");
            CHECK(v.x > 0.0 || (v.x == 0.0 && v.y > 0.0), "side");
        }
    }
}

static void special_matrices_have_unit_eigenvectors(void **state)
{
    const struct mat2 identity = { 2, 0, 0, 2 }, shear = { 1, 0, 1, 1 };

    (void) state;
    const struct vec2 u = mat2_eigenvector(identity, 2.0);
    CHECK(u.x == 1.0 && u.y == 0.0, "(%g, %g)", u.x, u.y);
    const struct vec2 v = mat2_eigenvector(shear, 1.0);
    CHECK(v.x == 0.0 && v.y == 1.0, "(%g, %g)", v.x, v.y);
    const struct eigen2 e = mat2_eigenvalues((struct mat2){ 0, 0, 0, 0 });
    CHECK(e.re[0] == 0.0 && e.re[1] == 0.0 && e.im == 0.0, "zero matrix");
}

static void boxes_are_closed_and_lengths_do_not_overflow(void **state)
{
    const struct box b = { { -1, 0 }, { 1, 2 } };

    (void) state;
    assert_true(box_holds(b, (struct vec2){ 1, 2 }));
    assert_true(box_holds(b, (struct vec2){ -1, 0 }));
    assert_false(box_holds(b, (struct vec2){ 1.0 + DBL_EPSILON, 1 }));
    assert_false(box_holds(b, (struct vec2){ 0, NAN }));
    CHECK(vec2_length((struct vec2){ 3e300, 4e300 }) == 5e300, "length");
    const struct vec2 w =
        vec2_add(vec2_scale(2.0, (struct vec2){ 1, 2 }),
                 vec2_sub((struct vec2){ 5, 5 }, (struct vec2){ 1, 2 }));
    CHECK(w.x == 6.0 && w.y == 7.0, "(%g, %g)", w.x, w.y);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(det_keeps_its_bound_near_singular_matrices),
        cmocka_unit_test(known_eigenvalues_are_found_at_every_scale),
        cmocka_unit_test(eigenvalues_far_apart_keep_their_digits),
        cmocka_unit_test(complex_pairs_are_found),
        cmocka_unit_test(eigenvectors_solve_their_equation),
        cmocka_unit_test(special_matrices_have_unit_eigenvectors),
        cmocka_unit_test(boxes_are_closed_and_lengths_do_not_overflow),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
