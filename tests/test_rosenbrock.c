#include "rosenbrock.h"

#include <math.h>

#include "check.h"

/* Rotation with a limit cycle, polar radius r and angle phi:
 *     r' = r (1 - r^2)/2, phi' = 1, and integrals of x and x y.
 * r^2 = 1/(1 + (1/r0^2 - 1) e^-t), phi = phi0 + t. */
static void cycle_slope(struct vec2 z, struct cascade_linear *l)
{
    const double g = 0.5 * (1.0 - z.x * z.x - z.y * z.y);

    l->du[0] = g * z.x - z.y;
    l->du[1] = g * z.y + z.x;
    l->du[2] = z.x;
    l->du[3] = z.x * z.y;
    l->slope[0] = (struct vec2){ g - z.x * z.x, -z.x * z.y - 1.0 };
    l->slope[1] = (struct vec2){ 1.0 - z.x * z.y, g - z.y * z.y };
    l->slope[2] = (struct vec2){ 1.0, 0.0 };
    l->slope[3] = (struct vec2){ z.y, z.x };
}

static void cycle(const void *ctx, struct vec2 z, double du[])
{
    struct cascade_linear l;

    (void) ctx;
    cycle_slope(z, &l);
    for (size_t i = 0; i < 4; i++)
        du[i] = l.du[i];
}

static const struct cascade cycle_system = { 4, cycle, NULL };

/* x and y exactly; from r0 = 1/2, phi0 = 0 at t = 0. */
static struct vec2 cycle_exact(double t)
{
    const double r = 1.0 / sqrt(1.0 + 3.0 * exp(-t));
    return (struct vec2){ r * cos(t), r * sin(t) };
}

/* The integrals by Simpson's rule with 2000 intervals: error below 1e-13. */
static void integrals_exact(double t, double q[2])
{
    const int n = 2000;

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
    double u[4] = { 0.5, 0.0, 0.0, 0.0 }, u1[4], q[2];
    const double h = t / steps;
    struct errors e = { 0.0, 0.0, 0.0, 0.0 };

    for (int n = 0; n < steps; n++) {
        struct rosenbrock w;
        struct cascade_linear l;
        double coef[4 * (ROSENBROCK_DEGREE + 1)];
        cycle_slope((struct vec2){ u[0], u[1] }, &l);
        rosenbrock_try(&w, &cycle_system, &l, u, h, u1);
        rosenbrock_dense(&w, 4, u, u1, coef);
        for (double theta = 0.125; theta < 1.0; theta += 0.125) {
            const struct vec2 z = cycle_exact((n + theta) * h);
            double x = 0.0;
            for (size_t j = ROSENBROCK_DEGREE + 1; j-- > 0;)
                x = x * theta + coef[j];
            e.dense = fmax(e.dense, fabs(x - z.x));
        }
        e.estimate = fmax(e.estimate, fabs(w.k[7][0]));
        for (size_t i = 0; i < 4; i++)
            u[i] = u1[i];
    }
    const struct vec2 z = cycle_exact(t);
    integrals_exact(t, q);
    e.end = hypot(u[0] - z.x, u[1] - z.y);
    e.integral = hypot(u[2] - q[0], u[3] - q[1]);
    return e;
}

static void orders_are_five_and_four(void **state)
{
    (void) state;
    for (int sign = -1; sign <= 1; sign += 2) {
        const struct errors a = integrate(40, sign * 2.0);
        const struct errors b = integrate(80, sign * 2.0);
        const double end = log2(a.end / b.end);
        const double integral = log2(a.integral / b.integral);
        const double dense = log2(a.dense / b.dense);
        const double estimate = log2(a.estimate / b.estimate);
        CHECK(fabs(end - 5.0) < 0.35, "order %g: %g, %g", end, a.end, b.end);
        CHECK(fabs(integral - 5.0) < 0.5, "order %g: %g, %g", integral,
              a.integral, b.integral);
        CHECK(dense > 3.8, "order %g: %g, %g", dense, a.dense, b.dense);
        CHECK(fabs(estimate - 5.0) < 0.3, "estimate of order %g", estimate);
        CHECK(b.end < 1e-7, "error %g", b.end);
    }
}

/* y' = -rate (y - cos x) - sin x, x' = 1: y = cos x at any rate. */
struct prothero {
    double rate;
};

static void prothero(const void *ctx, struct vec2 z, double du[])
{
    const struct prothero *p = ctx;

    du[0] = 1.0;
    du[1] = -p->rate * (z.y - cos(z.x)) - sin(z.x);
}

static void stiffness_costs_no_accuracy_at_the_end_of_a_step(void **state)
{
    (void) state;
    for (double rate = 1e2; rate < 1e13; rate *= 10.0) {
        const struct prothero p = { rate };
        const struct cascade system = { 2, prothero, &p };
        const double h = 0.1, u[2] = { 0.3, cos(0.3) };
        struct cascade_linear l;
        struct rosenbrock w;
        double u1[2];
        prothero(&p, (struct vec2){ u[0], u[1] }, l.du);
        l.slope[0] = (struct vec2){ 0.0, 0.0 };
        l.slope[1] = (struct vec2){ -rate * sin(u[0]) - cos(u[0]), -rate };
        rosenbrock_try(&w, &system, &l, u, h, u1);
        CHECK(fabs(u1[0] - 0.4) < 1e-14, "x = %.17g", u1[0]);
        CHECK(fabs(u1[1] - cos(0.4)) < 1e-6, "rate %g: error %g", rate,
              u1[1] - cos(0.4));
    }
}

/* R(z) -> 0: one step of size 1 at rate 1e10 forgets the initial value. */
static void infinitely_fast_decay_ends_in_one_step(void **state)
{
    const struct prothero p = { 1e10 };
    const struct cascade system = { 2, prothero, &p };
    const double u[2] = { 0.0, 5.0 };
    struct cascade_linear l = { .slope = { { 0, 0 }, { -1.0, -1e10 } } };
    struct rosenbrock w;
    double u1[2];

    (void) state;
    prothero(&p, (struct vec2){ u[0], u[1] }, l.du);
    rosenbrock_try(&w, &system, &l, u, 0.01, u1);
    CHECK(fabs(u1[1] - cos(0.01)) < 1e-6, "y = %.17g", u1[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(orders_are_five_and_four),
        cmocka_unit_test(stiffness_costs_no_accuracy_at_the_end_of_a_step),
        cmocka_unit_test(infinitely_fast_decay_ends_in_one_step),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
