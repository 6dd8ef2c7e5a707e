#include "explicit8.h"

#include <math.h>
#include <string.h>

#include "check.h"
#include "control.h"
#include "event.h"
#include "explicit8_table.h"
#include "newton.h"

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

/* Steps from s to s_end, or to an event that stops, onto a curve. */
struct walk {
    struct curve curve;
    struct event_log log;
    double s, u[4], error;
    bool stopped;
};

static void follow(struct walk *w, const struct ode *ode, double tol, double h,
                   double s_end, const struct event *e, size_t events)
{
    const double atol[4] = { tol, tol, tol, tol };
    struct control control = CONTROL_INIT(8.0);
    struct explicit8 work;
    double u1[4], error[4], *coef, factor;

    event_begin(&w->log, e, events, w->s, w->u);
    while (w->s != s_end && !w->stopped) {
        const double way = s_end - w->s;
        const bool last = !(h < fabs(way));
        const double step = last ? way : copysign(h, way);
        ode->rhs(ode->ctx, w->s, w->u, work.k[0]);
        const double off =
            explicit8_try(&work, ode, w->s, w->u, step, atol, tol, u1, error);
        const bool good = control_judge(&control, off, &factor);
        h = fabs(step) * factor;
        if (!good)
            continue;
        double end = 1.0;
        size_t which;
        assert_int_equal(curve_push(&w->curve, EXPLICIT8_DEGREE, &coef),
                         STATUS_OK);
        explicit8_dense(&work, ode, w->s, w->u, step, u1, coef);
        assert_int_equal(
            event_scan(&w->log, e, events, &w->curve, w->s, step, &end, &which),
            STATUS_OK);
        w->stopped = which < events;
        if (w->stopped)
            event_trim(&w->log, &w->curve, end);
        w->s = last && !w->stopped ? s_end : w->s + end * step;
        curve_at(&w->curve, w->curve.count - 1, 1.0, w->u);
        w->error += error[0];
    }
}

static void walk_free(struct walk *w)
{
    curve_free(&w->curve);
    event_free(&w->log);
}

static void error_follows_the_tolerance_there_and_back(void **state)
{
    (void) state;
    for (double tol = 1e-5; tol > 1e-13; tol *= 0.1) {
        struct walk w = { .curve = CURVE_EMPTY(4) };
        double u0[4], exact[4];
        kepler_exact(0.0, u0);
        kepler_exact(7.0, exact);
        memcpy(w.u, u0, sizeof u0);
        follow(&w, &kepler_ode, tol, 1e-3, 7.0, NULL, 0);
        const double there = distance(w.u, exact, 4);
        CHECK(there < 200.0 * tol, "tol %g: error %g", tol, there);
        follow(&w, &kepler_ode, tol, 1e-3, 0.0, NULL, 0);
        const double back = distance(w.u, u0, 4);
        CHECK(back < 400.0 * tol, "tol %g: error %g", tol, back);
        CHECK(w.error > 0.1 * tol, "estimate %g", w.error);
        walk_free(&w);
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
#define CIRCLE                                                                 \
    {                                                                          \
        .curve = CURVE_EMPTY(3), .u = { 1.0, 0.0, 0.0 }                        \
    }

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
    struct walk f = CIRCLE;
    size_t seen[3] = { 0, 0, 0 };

    (void) state;
    follow(&f, &circle_ode, 1e-13, 1e-3, 20.0 * pi, e, 3);
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
    walk_free(&f);
}

static void double_crossing_within_a_step_is_seen(void **state)
{
    const double level = 0.97; /* above it for an arc of 0.49 only */
    const struct event e = { .value = height, .ctx = &level };
    struct walk f = CIRCLE;

    (void) state;
    follow(&f, &circle_ode, 1.0, 2.5, 2.5, &e, 1);
    CHECK(f.curve.count == 1, "%zu steps", f.curve.count);
    CHECK(f.log.count == 2, "%zu hits", f.log.count);
    CHECK(fabs(f.log.hit[0].s + f.log.hit[1].s - acos(-1.0)) < 1e-2, "%g, %g",
          f.log.hit[0].s, f.log.hit[1].s);
    walk_free(&f);
}

static void stop_event_cuts_the_curve(void **state)
{
    const double level = 0.6;
    const struct event e[] = {
        { .value = cosine },
        { .value = height, .ctx = &level, .stop = true, .direction = -1 }
    };
    const double s = acos(-1.0) - asin(0.6);
    struct walk f = CIRCLE;
    double at[3];

    (void) state;
    follow(&f, &circle_ode, 1e-13, 1e-3, 100.0, e, 2);
    CHECK(f.stopped && f.log.hit[f.log.count - 1].which == 1, "no stop");
    CHECK(fabs(f.s - s) < 1e-12, "s - true = %g", f.s - s);
    curve_at(&f.curve, f.curve.count - 1, 1.0, at);
    CHECK(fabs(at[1] - 0.6) < 1e-14 && distance(at, f.u, 3) == 0.0,
          "ends at %.17g", at[1]);
    assert_int_equal(f.log.count, 2);
    CHECK(f.log.hit[1].theta == 1.0, "theta = %.17g", f.log.hit[1].theta);
    walk_free(&f);
}

/* Starting on the section is no event, arriving exactly on it is one. */
static void start_on_a_section_is_no_event(void **state)
{
    const double level = 0.0;
    const struct event e = { .value = height, .ctx = &level };
    struct walk f = CIRCLE;

    (void) state;
    follow(&f, &circle_ode, 1e-12, 1e-3, 4.0, &e, 1);
    assert_int_equal(f.log.count, 1);
    CHECK(fabs(f.log.hit[0].s - acos(-1.0)) < 1e-11, "s = %g", f.log.hit[0].s);
    walk_free(&f);
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
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
