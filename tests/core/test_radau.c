#include "radau.h"

#include <math.h>
#include <string.h>

#include "check.h"
#include "tolerance.h"

enum { COEFS = RADAU_DEGREE + 1 };

/* A system as one function that gives everything at once. */
typedef void linear_function(const void *ctx, struct vec2 z,
                             struct cascade_linear *l);

struct system {
    linear_function *at;
    double p[8];
};

static void plane(const void *ctx, struct vec2 z, double du[])
{
    const struct system *s = ctx;
    struct cascade_linear l;

    s->at(s->p, z, &l);
    du[0] = l.du[0];
    du[1] = l.du[1];
}

static void integrals(const void *ctx, struct vec2 z, double du[])
{
    const struct system *s = ctx;
    struct cascade_linear l;

    s->at(s->p, z, &l);
    for (size_t i = 2; i < 4; i++)
        du[i] = l.du[i];
}

static struct cascade cascade_of(const struct system *s)
{
    return (struct cascade){ 4, plane, integrals, s };
}

/* A whole step from u, guessed straight, with the gradients from its middle;
 * false: not solved. */
static bool take(const struct system *s, const double u[], double h, double tol,
                 struct radau *w, double coef[], double error[])
{
    const struct cascade system = cascade_of(s);
    struct cascade_linear start, l;

    s->at(s->p, (struct vec2){ u[0], u[1] }, &start);
    w->rate = 1.0;
    radau_start(w, start.du, h);
    s->at(s->p,
          (struct vec2){ u[0] + w->z[RADAU_MIDDLE].x,
                         u[1] + w->z[RADAU_MIDDLE].y },
          &l);
    memcpy(l.du, start.du, sizeof l.du);
    if (!radau_solve(w, &system, &l, u, h, tol))
        return false;
    radau_finish(w, &system, &l, u, h, coef, error);
    return true;
}

static double at_theta(const double coef[], size_t i, double theta)
{
    double x = 0.0;

    for (size_t j = COEFS; j-- > 0;)
        x = x * theta + coef[i * COEFS + j];
    return x;
}

/* x' = 1, y' = 5 x^4, integrals of x^p0 and x^p1. */
static void powers(const void *ctx, struct vec2 z, struct cascade_linear *l)
{
    const double *p = ctx;

    l->du[0] = 1.0;
    l->du[1] = 5.0 * pow(z.x, 4.0);
    l->slope[0] = (struct vec2){ 0.0, 0.0 };
    l->slope[1] = (struct vec2){ 20.0 * pow(z.x, 3.0), 0.0 };
    for (size_t i = 0; i < 2; i++) {
        l->du[2 + i] = pow(z.x, p[i]);
        l->slope[2 + i] = (struct vec2){ p[i] * pow(z.x, p[i] - 1.0), 0.0 };
    }
}

static void quadrature_is_exact_to_degree_eight(void **state)
{
    (void) state;
    for (int degree = 0; degree <= 9; degree++) {
        const struct system s = { powers, { degree, 1.0 } };
        const double u[4] = { 0.5, 0.03125, 0.0, 0.0 }, h = 1.5;
        double coef[4 * COEFS], error[4];
        struct radau w;
        assert_true(take(&s, u, h, 1e-13, &w, coef, error));
        const double exact =
            (pow(2.0, degree + 1) - pow(0.5, degree + 1)) / (degree + 1);
        const double off = at_theta(coef, 2, 1.0) / exact - 1.0;
        CHECK(degree <= 8 ? fabs(off) < 1e-13 : fabs(off) > 1e-9,
              "degree %d: off by %g", degree, off);
        for (double t = 0.0; t <= 1.0; t += 0.125) {
            const double x = 0.5 + t * h;
            CHECK(fabs(at_theta(coef, 0, t) - x) < 1e-14 &&
                      fabs(at_theta(coef, 1, t) - pow(x, 5.0)) < 1e-12,
                  "(%.17g, %.17g) at x = %g", at_theta(coef, 0, t),
                  at_theta(coef, 1, t), x);
        }
        CHECK(w.z[RADAU_MIDDLE].x > 0.86 * h && w.z[RADAU_MIDDLE].x < 0.861 * h,
              "middle at %g", w.z[RADAU_MIDDLE].x / h);
    }
}

/* z' = J z, integrals of x and y. */
static void linear(const void *ctx, struct vec2 z, struct cascade_linear *l)
{
    const double *p = ctx;

    l->du[0] = p[0] * z.x + p[1] * z.y;
    l->du[1] = p[2] * z.x + p[3] * z.y;
    l->du[2] = z.x;
    l->du[3] = z.y;
    l->slope[0] = (struct vec2){ p[0], p[1] };
    l->slope[1] = (struct vec2){ p[2], p[3] };
    l->slope[2] = (struct vec2){ 1.0, 0.0 };
    l->slope[3] = (struct vec2){ 0.0, 1.0 };
}

/* The (4, 5) Pade approximant of e^z: coefficients from (9 - j)!/j!. */
static double pade(double z)
{
    double over = 0.0, under = 0.0, p = 1.0, q = 1.0;

    for (int j = 0; j <= 5; j++) {
        over += p;
        under += q;
        p *= z * (4.0 - j) / ((9.0 - j) * (j + 1.0));
        q *= -z * (5.0 - j) / ((9.0 - j) * (j + 1.0));
    }
    return over / under;
}

static void linear_systems_take_one_iteration(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 500; i++) { /* J = V diag(a, b) V^-1, det V = 1 */
        const double a = i % 3 ? -exp(check_uniform(&rng, -9, 3))
                               : check_uniform(&rng, 0, 3);
        const double b = -exp(check_uniform(&rng, -9, 3));
        const double m = check_uniform(&rng, -2, 2), n = 1.0 + m * m;
        const struct system s = { linear,
                                  { n * a - m * m * b, m * (b - a),
                                    n * m * (a - b), n * b - m * m * a } };
        /* u = V (1, 1), V = (1, m; m, n) */
        const double u[4] = { 1.0 + m, m + n, 0.0, 0.0 };
        double coef[4 * COEFS], error[4];
        struct radau w;
        assert_true(take(&s, u, 1.0, 1e-9, &w, coef, error));
        const double x = pade(a) + m * pade(b), y = m * pade(a) + n * pade(b);
        const double size = 1e-13 * (1.0 + n) * (1.0 + fabs(pade(a)));
        CHECK(w.iterations == 2, "%zu iterations", w.iterations);
        CHECK(w.rate <= TOL_RADAU_LEAST, "rate %g", w.rate);
        CHECK(fabs(at_theta(coef, 0, 1.0) - x) < 30 * size &&
                  fabs(at_theta(coef, 1, 1.0) - y) < 30 * size,
              "(%.17g, %.17g), exact (%.17g, %.17g), rates %g, %g, shear %g",
              at_theta(coef, 0, 1.0), at_theta(coef, 1, 1.0), x, y, a, b, m);
    }
}

/* Rotation with a limit cycle, polar radius r and angle phi:
 *     r' = r (1 - r^2)/2, phi' = 1, and integrals of x and x y.
 * r^2 = 1/(1 + (1/r0^2 - 1) e^-t), phi = phi0 + t. */
static void cycle(const void *ctx, struct vec2 z, struct cascade_linear *l)
{
    const double g = 0.5 * (1.0 - z.x * z.x - z.y * z.y);

    (void) ctx;
    l->du[0] = g * z.x - z.y;
    l->du[1] = g * z.y + z.x;
    l->du[2] = z.x;
    l->du[3] = z.x * z.y;
    l->slope[0] = (struct vec2){ g - z.x * z.x, -z.x * z.y - 1.0 };
    l->slope[1] = (struct vec2){ 1.0 - z.x * z.y, g - z.y * z.y };
    l->slope[2] = (struct vec2){ 1.0, 0.0 };
    l->slope[3] = (struct vec2){ z.y, z.x };
}

/* x and y exactly; from r0 = 1/2, phi0 = 0 at t = 0. */
static struct vec2 cycle_exact(double t)
{
    const double r = 1.0 / sqrt(1.0 + 3.0 * exp(-t));
    return (struct vec2){ r * cos(t), r * sin(t) };
}

/* The integrals by Simpson's rule with 4000 intervals: error below 1e-14. */
static void integrals_exact(double t, double q[2])
{
    const int n = 4000;

    q[0] = q[1] = 0.0;
    for (int i = 0; i <= n; i++) {
        const double w = i == 0 || i == n ? 1.0 : (i % 2 ? 4.0 : 2.0);
        const struct vec2 z = cycle_exact(t * i / n);
        q[0] += w * z.x * t / (3.0 * n);
        q[1] += w * z.x * z.y * t / (3.0 * n);
    }
}

struct errors {
    double end, integral, dense, estimate;
};

static struct errors integrate(int steps, double t)
{
    const struct system s = { cycle, { 0.0 } };
    const double h = t / steps;
    double u[4] = { 0.5, 0.0, 0.0, 0.0 }, q[2];
    struct errors e = { 0.0, 0.0, 0.0, 0.0 };

    for (int n = 0; n < steps; n++) {
        struct radau w;
        double coef[4 * COEFS], error[4];
        assert_true(take(&s, u, h, 1e-14, &w, coef, error));
        for (double theta = 0.125; theta < 1.0; theta += 0.125) {
            const struct vec2 z = cycle_exact((n + theta) * h);
            e.dense = fmax(e.dense, fabs(at_theta(coef, 0, theta) - z.x));
        }
        e.estimate = fmax(e.estimate, hypot(error[0], error[1]));
        for (size_t i = 0; i < 4; i++)
            u[i] = at_theta(coef, i, 1.0);
    }
    const struct vec2 z = cycle_exact(t);
    integrals_exact(t, q);
    e.end = hypot(u[0] - z.x, u[1] - z.y);
    e.integral = hypot(u[2] - q[0], u[3] - q[1]);
    return e;
}

static void orders_are_nine_and_five(void **state)
{
    (void) state;
    for (int sign = -1; sign <= 1; sign += 2) {
        const struct errors a = integrate(4, sign * 2.0);
        const struct errors b = integrate(8, sign * 2.0);
        const double end = log2(a.end / b.end);
        const double integral = log2(a.integral / b.integral);
        const double dense = log2(a.dense / b.dense);
        const double estimate = log2(a.estimate / b.estimate);
        CHECK(fabs(end - 9.0) < 0.7, "order %g: %g, %g", end, a.end, b.end);
        CHECK(fabs(integral - 9.0) < 0.7, "order %g: %g, %g", integral,
              a.integral, b.integral);
        CHECK(dense > 5.3, "order %g: %g, %g", dense, a.dense, b.dense);
        CHECK(fabs(estimate - 6.0) < 0.7, "estimate of order %g: %g, %g",
              estimate, a.estimate, b.estimate);
        CHECK(b.dense < b.estimate && b.end < b.estimate,
              "estimate %g of errors %g, %g", b.estimate, b.dense, b.end);
    }
}

/* y' = -rate (y - cos x) - sin x, x' = 1: y = cos x at any rate. */
static void prothero(const void *ctx, struct vec2 z, struct cascade_linear *l)
{
    const double rate = *(const double *) ctx;

    memset(l, 0, sizeof *l);
    l->du[0] = 1.0;
    l->du[1] = -rate * (z.y - cos(z.x)) - sin(z.x);
    l->slope[1] = (struct vec2){ -rate * sin(z.x) - cos(z.x), -rate };
}

static void stiffness_costs_no_accuracy(void **state)
{
    (void) state;
    for (double rate = 1e2; rate < 1e13; rate *= 10.0) {
        const struct system s = { prothero, { rate } };
        const double u[4] = { 0.3, cos(0.3) };
        double coef[4 * COEFS], error[4];
        struct radau w;
        assert_true(take(&s, u, 0.1, 1e-13, &w, coef, error));
        CHECK(fabs(at_theta(coef, 1, 1.0) - cos(0.4)) < 1e-11,
              "rate %g: error %g", rate, at_theta(coef, 1, 1.0) - cos(0.4));
        CHECK(fabs(error[1]) < 1e-7, "rate %g: estimate %g", rate, error[1]);
    }
}

static void the_estimate_covers_the_whole_of_a_stiff_step(void **state)
{
    (void) state;
    for (double rate = 1.0; rate < 1e13; rate *= 10.0) {
        const struct system s = { prothero, { rate } };
        const double u[4] = { 0.3, cos(0.3) }, h = 0.8;
        double coef[4 * COEFS], error[4], worst = 0.0;
        struct radau w;
        assert_true(take(&s, u, h, 1e-13, &w, coef, error));
        for (double t = 0.0; t <= 1.0; t += 0.01) {
            const double off = at_theta(coef, 1, t) - cos(0.3 + t * h);
            worst = fmax(worst, fabs(off));
        }
        CHECK(worst > 1e-8 && worst < 2.0 * fabs(error[1]),
              "rate %g: error %g, estimate %g", rate, worst, error[1]);
    }
}

static void infinitely_fast_decay_ends_in_one_step(void **state)
{
    const struct system s = { prothero, { 1e10 } };
    const double u[4] = { 0.0, 5.0 };
    double coef[4 * COEFS], error[4];
    struct radau w;

    (void) state;
    assert_true(take(&s, u, 0.01, 1e-12, &w, coef, error));
    CHECK(fabs(at_theta(coef, 1, 1.0) - cos(0.01)) < 1e-6, "y = %.17g",
          at_theta(coef, 1, 1.0));
}

static void polynomials_are_continued_exactly(void **state)
{
    const struct system s = { powers, { 1.0, 2.0 } };
    const struct cascade system = cascade_of(&s);
    const double u[4] = { 0.5, 0.03125 };

    (void) state;
    for (double ratio = 0.25; ratio <= TOL_ORBIT_EXTEND; ratio *= 2.0) {
        const double h = ratio * 0.25, u1[4] = { 0.75, pow(0.75, 5.0) };
        double coef[4 * COEFS], error[4];
        struct cascade_linear l;
        struct radau w;
        assert_true(take(&s, u, 0.25, 1e-14, &w, coef, error));
        radau_extend(&w, coef, ratio);
        w.rate = TOL_RADAU_LEAST;
        powers(s.p, (struct vec2){ u1[0], u1[1] }, &l);
        assert_true(radau_solve(&w, &system, &l, u1, h, 1e-9));
        CHECK(w.iterations == 1, "%zu iterations", w.iterations);
        CHECK(fabs(w.z[RADAU_STAGES - 1].y + u1[1] - pow(0.75 + h, 5.0)) <
                  1e-11,
              "ratio %g: y = %.17g", ratio, w.z[RADAU_STAGES - 1].y + u1[1]);
    }
}

/* However early the iteration stops. */
static void rates_are_those_at_the_stages(void **state)
{
    const struct system s = { cycle, { 0.0 } };
    const struct cascade system = cascade_of(&s);
    const double u[4] = { 0.5, 0.2 };

    (void) state;
    for (double tol = 1e-12; tol < 1e-2; tol *= 10.0) {
        double coef[4 * COEFS], error[4], du[4];
        struct radau w;
        assert_true(take(&s, u, 0.4, tol, &w, coef, error));
        for (size_t k = 0; k < RADAU_STAGES; k++) {
            const struct vec2 z = { u[0] + w.z[k].x, u[1] + w.z[k].y };
            system.plane(&s, z, du);
            system.integrals(&s, z, du);
            for (size_t i = 0; i < 4; i++)
                CHECK(fabs(w.du[k][i] - du[i]) < 20.0 * tol,
                      "tolerance %g, stage %zu: rate %zu off by %g", tol, k, i,
                      w.du[k][i] - du[i]);
        }
    }
}

static void a_rate_of_the_last_step_is_trusted_less(void **state)
{
    const struct system s = { cycle, { 0.0 } };
    const struct cascade system = cascade_of(&s);
    const double u[4] = { 0.5, 0.2 };
    struct cascade_linear l;

    (void) state;
    cycle(s.p, (struct vec2){ u[0], u[1] }, &l);
    for (int i = 0; i < 2; i++) {
        struct radau w = { .rate = i == 0 ? 0.5 : 0.04 };
        radau_start(&w, l.du, 0.1); /* off by less than 0.1 */
        assert_true(radau_solve(&w, &system, &l, u, 0.1, 0.1));
        CHECK(w.iterations == (i == 0 ? 2 : 1), "%zu iterations", w.iterations);
    }
}

static void rounding_is_no_reason_to_refuse(void **state)
{
    const struct system s = { cycle, { 0.0 } };
    const double u[4] = { 0.5, 0.2 };
    double coef[4 * COEFS], error[4];
    struct radau w;

    (void) state;
    assert_true(take(&s, u, 0.1, 1e-30, &w, coef, error));
}

static void rates_of_any_size_go_together(void **state)
{
    const struct system s = { linear, { -1e140, 0.0, 0.0, -1e-140 } };
    const double u[4] = { 0.0, 1.0 };
    double coef[4 * COEFS], error[4];

    (void) state;
    for (double h = 1e-100; h < 1e150; h *= 1e20) {
        struct radau w;
        assert_true(take(&s, u, h, 1e-9, &w, coef, error));
        CHECK(at_theta(coef, 0, 1.0) == 0.0, "x = %g", at_theta(coef, 0, 1.0));
        CHECK(fabs(at_theta(coef, 1, 1.0) - pade(-1e-140 * h)) < 1e-14,
              "y = %g", at_theta(coef, 1, 1.0));
        CHECK(fabs(error[0]) + fabs(error[1]) < 1e-5, "estimates %g, %g",
              error[0], error[1]);
    }
}

/* x' = 1, y' = y^2, NaN for x > p0; wrong gradients on purpose if p1 > 0. */
static void blow_up(const void *ctx, struct vec2 z, struct cascade_linear *l)
{
    const double *p = ctx;

    memset(l, 0, sizeof *l);
    l->du[0] = z.x > p[0] ? (double) NAN : 1.0;
    l->du[1] = z.y * z.y;
    l->slope[1] = (struct vec2){ 0.0, p[1] > 0.0 ? -9.0 : 2.0 * z.y };
}

static void steps_that_are_too_long_are_refused(void **state)
{
    const struct system good = { blow_up, { 10.0 } };
    const struct system hole = { blow_up, { 0.05 } };
    const struct system wrong = { blow_up, { 10.0, 1.0 } };
    const double u[4] = { 0.0, 1.0 };
    double coef[4 * COEFS], error[4];
    struct radau w;

    (void) state;
    assert_true(take(&good, u, 0.1, 1e-10, &w, coef, error));
    assert_false(take(&good, u, 30.0, 1e-10, &w, coef, error));
    assert_true(w.rate == 1.0);
    assert_false(take(&hole, u, 0.1, 1e-10, &w, coef, error));
    assert_int_equal(w.iterations, 1);
    assert_false(take(&wrong, u, 0.4, 1e-13, &w, coef, error));
    assert_true(w.iterations <= TOL_RADAU_ITERATIONS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(quadrature_is_exact_to_degree_eight),
        cmocka_unit_test(linear_systems_take_one_iteration),
        cmocka_unit_test(orders_are_nine_and_five),
        cmocka_unit_test(stiffness_costs_no_accuracy),
        cmocka_unit_test(the_estimate_covers_the_whole_of_a_stiff_step),
        cmocka_unit_test(infinitely_fast_decay_ends_in_one_step),
        cmocka_unit_test(polynomials_are_continued_exactly),
        cmocka_unit_test(rates_are_those_at_the_stages),
        cmocka_unit_test(a_rate_of_the_last_step_is_trusted_less),
        cmocka_unit_test(rounding_is_no_reason_to_refuse),
        cmocka_unit_test(rates_of_any_size_go_together),
        cmocka_unit_test(steps_that_are_too_long_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
