#include "flow.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "explicit8_table.h"
#include "newton.h"

static int fail_at = -1;

void *__real_realloc(void *p, size_t n);
void *__wrap_realloc(void *p, size_t n);

void *__wrap_realloc(void *p, size_t n)
{
    if (fail_at-- == 0)
        return NULL;
    return __real_realloc(p, n);
}

/* Kepler's problem, eccentricity 1/2: nonlinear, exact, all trees at work. */
static const double eccentricity = 0.5;

static void kepler(const void *ctx, double s, const double u[], double du[])
{
    const double r = hypot(u[0], u[1]), r3 = r * r * r;

    (void) ctx;
    (void) s;
    du[0] = u[2];
    du[1] = u[3];
    du[2] = -u[0] / r3;
    du[3] = -u[1] / r3;
}

static double anomaly(const void *ctx, double E)
{
    return E - eccentricity * sin(E) - *(const double *) ctx;
}

static void kepler_exact(double t, double u[])
{
    const double root = sqrt(1.0 - eccentricity * eccentricity);
    struct newton_root E;

    assert_int_equal(newton_find(anomaly, &t, t - 1.0, t + 1.0, 0.0, &E),
                     STATUS_OK);
    const double c = cos(E.x), s = sin(E.x), rate = 1.0 / (1.0 - 0.5 * c);
    u[0] = c - eccentricity;
    u[1] = root * s;
    u[2] = -s * rate;
    u[3] = root * c * rate;
}

static const struct ode kepler_ode = { 4, kepler, NULL };

static double distance(const double u[], const double v[], size_t n)
{
    double worst = 0.0;

    for (size_t i = 0; i < n; i++)
        worst = fmax(worst, fabs(u[i] - v[i]));
    return worst;
}

/* One step of size h from t = 2.5: errors of the end, of the dense output and
 * the estimate. */
struct errors {
    double end, dense, estimate, term[EXPLICIT8_TERMS];
};

/* What estimate n of the last terms makes of a step. */
static double term_of(const struct explicit8 *w, int n, double h, size_t dim)
{
    double worst = 0.0;

    for (size_t i = 0; i < dim; i++) {
        double sum = 0.0;
        for (int j = 0; j < EXPLICIT8_STAGES; j++)
            sum += h * explicit8_term[n][j] * w->k[j][i];
        worst = fmax(worst, fabs(sum));
    }
    return worst;
}

static struct errors one_step(double h)
{
    struct explicit8 w;
    struct curve c = CURVE_EMPTY(4);
    const double atol[4] = { 1, 1, 1, 1 };
    double u[4], u1[4], error[4], exact[4], *coef;
    struct errors e = { 0 };

    kepler_exact(2.5, u);
    kepler(NULL, 2.5, u, w.k[0]);
    e.estimate =
        explicit8_try(&w, &kepler_ode, 2.5, u, h, atol, 0.0, u1, error);
    for (int n = 0; n < EXPLICIT8_TERMS; n++)
        e.term[n] = term_of(&w, n, h, 4);
    kepler_exact(2.5 + h, exact);
    e.end = distance(u1, exact, 4);
    assert_int_equal(curve_push(&c, EXPLICIT8_DEGREE, &coef), STATUS_OK);
    explicit8_dense(&w, &kepler_ode, 2.5, u, h, u1, coef);
    for (double theta = 0.0; theta <= 1.0; theta += 0.0625) {
        double at[4];
        kepler_exact(2.5 + theta * h, exact);
        curve_at(&c, 0, theta, at);
        e.dense = fmax(e.dense, distance(at, exact, 4));
    }
    curve_free(&c);
    return e;
}

static void step_has_order_8_and_dense_output_order_7(void **state)
{
    const struct errors a = one_step(0.8), b = one_step(0.4);

    (void) state;
    const double end = log2(a.end / b.end) - 1.0;
    const double dense = log2(a.dense / b.dense) - 1.0;
    const double estimate = log2(a.estimate / b.estimate);
    CHECK(fabs(end - 8.0) < 0.4, "order %g, errors %g, %g", end, a.end, b.end);
    CHECK(fabs(dense - 7.0) < 0.4, "order %g, errors %g, %g", dense, a.dense,
          b.dense);
    CHECK(estimate > 7.5 && estimate < 9.5, "estimate of order %g", estimate);
    CHECK(b.estimate > 0.5 * b.end && b.estimate < 100.0 * b.end,
          "estimate %g, true %g", b.estimate, b.end);
}

static void estimates_of_terms_are_of_order_6_and_7(void **state)
{
    static const double order[EXPLICIT8_TERMS] = { 6.0, 6.0, 7.0 };
    const struct errors a = one_step(0.2), b = one_step(0.1);

    (void) state;
    for (int n = 0; n < EXPLICIT8_TERMS; n++) {
        const double told = log2(a.term[n] / b.term[n]);
        CHECK(fabs(told - order[n]) < 0.4, "%d: order %g", n, told);
    }
}

/* u' = s^n: the nodes and weights as a quadrature formula. */
static void power(const void *ctx, double s, const double u[], double du[])
{
    (void) u;
    du[0] = pow(s, *(const double *) ctx);
}

static void quadrature_is_exact_up_to_degree_7(void **state)
{
    const double atol[1] = { 1.0 };

    (void) state;
    for (int n = 0; n <= 8; n++) {
        const double exponent = n, u[1] = { 0.0 };
        const struct ode ode = { 1, power, &exponent };
        struct explicit8 w;
        double u1[1], error[1], coef[EXPLICIT8_DEGREE + 1];
        power(&exponent, 0.0, u, w.k[0]);
        (void) explicit8_try(&w, &ode, 0.0, u, 1.0, atol, 0.0, u1, error);
        explicit8_dense(&w, &ode, 0.0, u, 1.0, u1, coef);
        const double off = fabs(u1[0] * (n + 1) - 1.0);
        CHECK(n == 8 ? off > 1e-9 : off < 1e-14, "n = %d: %g", n, off);
        for (int k = 0; k < EXPLICIT8_TERMS; k++) {
            const int first = k < 2 ? 5 : 6;
            const double term = term_of(&w, k, 1.0, 1);
            CHECK(n > first || fabs(term * (n + 1) - (n == first)) < 1e-11,
                  "n = %d, term %d: %g", n, k, term);
        }
        for (int j = 0; j <= EXPLICIT8_DEGREE && n < EXPLICIT8_DEGREE; j++) {
            const double ref = j == n + 1 ? 1.0 / j : 0.0;
            CHECK(fabs(coef[j] - ref) < 1e-12, "n = %d, theta^%d: %g", n, j,
                  coef[j]);
        }
    }
}

static struct flow_options options_at(double tol)
{
    struct flow_options o = { .rtol = tol, .max_steps = 100000 };

    for (size_t i = 0; i < CURVE_DIM_MAX; i++)
        o.atol[i] = tol;
    return o;
}

static enum status run(struct flow *f, double s_end)
{
    enum status s;

    do
        s = flow_step(f, s_end);
    while (s == STATUS_OK && f->end == FLOW_RUNNING);
    return s;
}

static void error_follows_the_tolerance_there_and_back(void **state)
{
    (void) state;
    for (double tol = 1e-5; tol > 1e-13; tol *= 0.1) {
        const struct flow_options o = options_at(tol);
        struct flow f;
        double u0[4], exact[4];
        kepler_exact(0.0, u0);
        kepler_exact(7.0, exact);
        assert_int_equal(flow_init(&f, &kepler_ode, 0.0, u0, &o), STATUS_OK);
        assert_int_equal(run(&f, 7.0), STATUS_OK);
        CHECK(f.end == FLOW_REACHED && f.s == 7.0, "s = %g", f.s);
        const double there = distance(f.u, exact, 4);
        CHECK(there < 200.0 * tol, "tol %g: error %g", tol, there);
        assert_int_equal(run(&f, 0.0), STATUS_OK);
        const double back = distance(f.u, u0, 4);
        CHECK(back < 400.0 * tol, "tol %g: error %g", tol, back);
        CHECK(f.error[0] > 0.1 * tol && f.steps == f.curve.count, "%zu steps",
              f.steps);
        flow_free(&f);
    }
}

/* The unit circle in s, with s itself as a component. */
static void circle(const void *ctx, double s, const double u[], double du[])
{
    (void) ctx;
    (void) s;
    du[0] = -u[1];
    du[1] = u[0];
    du[2] = 1.0;
}

static const struct ode circle_ode = { 3, circle, NULL };
static const double circle_start[3] = { 1.0, 0.0, 0.0 };

static double cosine(const void *ctx, double s, const double u[])
{
    (void) ctx;
    (void) s;
    return u[0];
}

static double height(const void *ctx, double s, const double u[])
{
    (void) s;
    return u[1] - *(const double *) ctx;
}

static void every_crossing_is_recorded_where_it_is(void **state)
{
    const double pi = acos(-1.0);
    const struct event e[] = { { .value = cosine },
                               { .value = cosine, .direction = 1 },
                               { .value = cosine, .direction = -1 } };
    struct flow_options o = options_at(1e-13);
    struct flow f;
    size_t seen[3] = { 0, 0, 0 };

    (void) state;
    o.event = e;
    o.events = 3;
    assert_int_equal(flow_init(&f, &circle_ode, 0.0, circle_start, &o),
                     STATUS_OK);
    assert_int_equal(run(&f, 20.0 * pi), STATUS_OK);
    for (size_t i = 0; i < f.log.count; i++) {
        const struct event_hit *hit = &f.log.hit[i];
        const double step = hit->which == 0 ? 1.0 : 2.0;
        const double from = hit->which == 1 ? 1.5 : 0.5;
        const double s = pi * (from + step * (double) seen[hit->which]++);
        CHECK(fabs(hit->s - s) < 2e-12 && fabs(hit->u[2] - s) < 2e-12,
              "event %zu at %.15g, true %.15g", hit->which, hit->s, s);
        CHECK(fabs(hit->u[0]) < 1e-14, "cos = %g", hit->u[0]);
        CHECK(i == 0 || hit->s >= f.log.hit[i - 1].s, "order");
    }
    CHECK(seen[0] == 20 && seen[1] == 10 && seen[2] == 10, "%zu %zu %zu",
          seen[0], seen[1], seen[2]);
    flow_free(&f);
}

static void double_crossing_within_a_step_is_seen(void **state)
{
    const double level = 0.97; /* above it for an arc of 0.49 only */
    const struct event e = { .value = height, .ctx = &level };
    struct flow_options o = options_at(1e-5);
    struct flow f;

    (void) state;
    o.event = &e;
    o.events = 1;
    o.first_step = 2.5;
    o.rtol = 1.0;
    assert_int_equal(flow_init(&f, &circle_ode, 0.0, circle_start, &o),
                     STATUS_OK);
    assert_int_equal(run(&f, 2.5), STATUS_OK);
    CHECK(f.steps == 1, "%zu steps", f.steps);
    CHECK(f.log.count == 2, "%zu hits", f.log.count);
    CHECK(fabs(f.log.hit[0].s + f.log.hit[1].s - acos(-1.0)) < 1e-2, "%g, %g",
          f.log.hit[0].s, f.log.hit[1].s);
    flow_free(&f);
}

static void stop_event_cuts_the_curve(void **state)
{
    const double level = 0.6;
    const struct event e[] = {
        { .value = cosine },
        { .value = height, .ctx = &level, .stop = true, .direction = -1 }
    };
    struct flow_options o = options_at(1e-13);
    const double s = acos(-1.0) - asin(0.6);
    struct flow f;
    double at[3];

    (void) state;
    o.event = e;
    o.events = 2;
    assert_int_equal(flow_init(&f, &circle_ode, 0.0, circle_start, &o),
                     STATUS_OK);
    assert_int_equal(run(&f, 100.0), STATUS_OK);
    CHECK(f.end == FLOW_EVENT && f.end_index == 1, "end %d", (int) f.end);
    CHECK(fabs(f.s - s) < 1e-12, "s - true = %g", f.s - s);
    curve_at(&f.curve, f.curve.count - 1, 1.0, at);
    CHECK(fabs(at[1] - 0.6) < 1e-14 && distance(at, f.u, 3) == 0.0,
          "ends at %.17g", at[1]);
    assert_int_equal(f.log.count, 2);
    CHECK(f.log.hit[1].theta == 1.0, "theta = %.17g", f.log.hit[1].theta);
    const size_t steps = f.steps;
    assert_int_equal(flow_step(&f, 100.0), STATUS_OK);
    assert_int_equal(f.steps, steps);
    flow_free(&f);
}

/* Starting on the section is no event, arriving exactly on it is one. */
static void start_on_a_section_is_no_event(void **state)
{
    const double level = 0.0;
    const struct event e = { .value = height, .ctx = &level };
    struct flow_options o = options_at(1e-12);
    struct flow f;

    (void) state;
    o.event = &e;
    o.events = 1;
    assert_int_equal(flow_init(&f, &circle_ode, 0.0, circle_start, &o),
                     STATUS_OK);
    assert_int_equal(run(&f, 4.0), STATUS_OK);
    assert_int_equal(f.log.count, 1);
    CHECK(fabs(f.log.hit[0].s - acos(-1.0)) < 1e-11, "s = %g", f.log.hit[0].s);
    flow_free(&f);
}

/* u' = 1 up to u = 1, undefined beyond. */
static void edge(const void *ctx, double s, const double u[], double du[])
{
    (void) ctx;
    (void) s;
    du[0] = u[0] < 1.0 ? 1.0 : (double) NAN;
}

static void blow_up(const void *ctx, double s, const double u[], double du[])
{
    (void) ctx;
    (void) s;
    du[0] = u[0] * u[0];
}

static void undefined_and_infinite_solutions_end_with_an_error(void **state)
{
    const struct ode wall = { 1, edge, NULL }, pole = { 1, blow_up, NULL };
    const struct flow_options o = options_at(1e-9);
    const double zero[1] = { 0.0 }, one[1] = { 1.0 };
    struct flow f;

    (void) state;
    assert_int_equal(flow_init(&f, &wall, 0.0, zero, &o), STATUS_OK);
    assert_int_equal(run(&f, 3.0), STATUS_NO_CONVERGENCE);
    CHECK(f.u[0] <= 1.0 && f.u[0] > 0.999999, "u = %.17g", f.u[0]);
    CHECK(f.steps + f.rejected < 2000, "%zu steps", f.steps + f.rejected);
    flow_free(&f);
    assert_int_equal(flow_init(&f, &pole, 0.0, one, &o), STATUS_OK);
    assert_int_equal(run(&f, 3.0), STATUS_NO_CONVERGENCE);
    CHECK(fabs(f.s - 1.0) < 1e-6, "s = %.17g", f.s);
    flow_free(&f);
    assert_int_equal(flow_init(&f, &wall, 0.0, one, &o), STATUS_NO_CONVERGENCE);
    flow_free(&f);
}

/* u' = 1 but for a pinhole, where only dense output looks. */
static void pinhole(const void *ctx, double s, const double u[], double du[])
{
    (void) ctx;
    (void) u;
    du[0] = fabs(s - 0.1) < 1e-9 ? (double) NAN : 1.0;
}

static void dense_output_is_finite_or_the_step_is_rejected(void **state)
{
    const struct ode ode = { 1, pinhole, NULL };
    struct flow_options o = options_at(1e-9);
    const double zero[1] = { 0.0 };
    struct flow f;

    (void) state;
    o.first_step = 1.0;
    assert_int_equal(flow_init(&f, &ode, 0.0, zero, &o), STATUS_OK);
    assert_int_equal(run(&f, 3.0), STATUS_OK);
    CHECK(f.rejected > 0, "not noticed");
    for (size_t i = 0; i < f.curve.coefs; i++)
        CHECK(isfinite(f.curve.coef[i]), "coefficient %zu", i);
    flow_free(&f);
}

static void a_bound_stops_long_work(void **state)
{
    struct flow_options o = options_at(1e-12);
    struct flow f;

    (void) state;
    o.max_steps = 1000;
    assert_int_equal(flow_init(&f, &circle_ode, 0.0, circle_start, &o),
                     STATUS_OK);
    assert_int_equal(run(&f, 1e6), STATUS_TOO_MANY_STEPS);
    CHECK(f.steps + f.rejected == 1000, "%zu steps", f.steps);
    flow_free(&f);
    flow_free(&f);
}

static void options_out_of_range_are_refused(void **state)
{
    const struct flow_options good = options_at(1e-9);
    struct flow_options bad[4] = { good, good, good, good };
    const double nan3[3] = { 0.0, NAN, 0.0 };
    struct flow f;

    (void) state;
    bad[0].rtol = 0.0;
    bad[1].atol[2] = -1.0;
    bad[2].first_step = NAN;
    bad[3].events = EVENT_COUNT_MAX + 1;
    for (size_t i = 0; i < 4; i++)
        assert_int_equal(flow_init(&f, &circle_ode, 0.0, circle_start, &bad[i]),
                         STATUS_BAD_ARGUMENT);
    assert_int_equal(flow_init(&f, &circle_ode, 0.0, nan3, &good),
                     STATUS_BAD_ARGUMENT);
    flow_free(&f);
}

static void every_allocation_may_fail(void **state)
{
    const struct event e = { .value = cosine };
    struct flow_options o = options_at(1e-13);
    enum status s = STATUS_NO_MEMORY;
    int k = 0;

    (void) state;
    o.event = &e;
    o.events = 1;
    for (; s != STATUS_OK; k++) {
        struct flow f;
        double at[3];
        assert_int_equal(flow_init(&f, &circle_ode, 0.0, circle_start, &o),
                         STATUS_OK);
        fail_at = k;
        s = run(&f, 120.0);
        fail_at = -1;
        CHECK(s == STATUS_OK || s == STATUS_NO_MEMORY, "%s", status_text(s));
        if (f.curve.count > 0) {
            curve_at(&f.curve, f.curve.count - 1, 1.0, at);
            CHECK(distance(at, f.u, 3) < 1e-13, "end of the curve");
        }
        flow_free(&f);
    }
    CHECK(k > 5, "only %d allocations failed", k - 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(step_has_order_8_and_dense_output_order_7),
        cmocka_unit_test(estimates_of_terms_are_of_order_6_and_7),
        cmocka_unit_test(quadrature_is_exact_up_to_degree_7),
        cmocka_unit_test(error_follows_the_tolerance_there_and_back),
        cmocka_unit_test(every_crossing_is_recorded_where_it_is),
        cmocka_unit_test(double_crossing_within_a_step_is_seen),
        cmocka_unit_test(stop_event_cuts_the_curve),
        cmocka_unit_test(start_on_a_section_is_no_event),
        cmocka_unit_test(undefined_and_infinite_solutions_end_with_an_error),
        cmocka_unit_test(dense_output_is_finite_or_the_step_is_rejected),
        cmocka_unit_test(a_bound_stops_long_work),
        cmocka_unit_test(options_out_of_range_are_refused),
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
