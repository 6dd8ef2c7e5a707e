/* Planes of formulas against what is known of them in closed form. */
#include "plane_study.h"

#include <math.h>

#include "formulas.h"

#define WINDOW "window={x: [-2, 2], y: [-2, 2]}\nproducts=[manifolds]\n"

static double uniform(uint64_t *rng, double lo, double hi)
{
    *rng = *rng * 6364136223846793005u + 1442695040888963407u;
    return lo + (hi - lo) * (double) (*rng >> 11) * 0x1p-53;
}

/* ---- separatrices -------------------------------------------------------- */

static double of_duffing(const void *ctx, double x, double y, double *steep)
{
    (void) ctx;
    *steep = 2.0 * fabs(y) + fabs(2.0 * x - 2.0 * x * x * x) + 1e-15;
    return y * y - x * x + 0.5 * x * x * x * x;
}

static void homoclinic_loops_of_duffing_are_known(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = y; y' = x - x^3", WINDOW);
    assert_int_equal(s.rests, 3);
    assert_int_equal(s.saddles, 1);
    assert_int_equal(s.rest[0].type, PLANE_NONHYPERBOLIC);
    assert_string_equal(s.rest[1].name, "saddle_0");
    assert_int_equal(s.branches, 4);
    for (size_t i = 0; i < 4; i++) {
        plane_on(&s, &s.branch[i], of_duffing, NULL, 3.0, 1e-12);
        assert_int_equal(s.branch[i].end, PLANE_END_SADDLE);
        assert_int_equal(s.branch[i].to, 1);
    }
    plane_end(&s, &c);
}

static double of_pendulum(const void *ctx, double x, double y, double *steep)
{
    (void) ctx;
    *steep = 1.0 + fabs(sin(0.5 * x));
    return fabs(y) - 2.0 * fabs(cos(0.5 * x));
}

static void an_angle_has_one_saddle_in_a_period(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = y; y' = -sin(x)",
              "system.state.x=angle\nwindow={y: [-3, 3]}\n"
              "products=[manifolds]\n");
    assert_int_equal(s.rests, 2);
    assert_int_equal(s.saddles, 1);
    for (size_t i = 0; i < s.branches; i++) {
        plane_on(&s, &s.branch[i], of_pendulum, NULL, 5.0, 1e-12);
        assert_int_equal(s.branch[i].end, PLANE_END_SADDLE);
        CHECK(fabs(s.branch[i].length.value - 7.640395578055425) <=
                  s.branch[i].length.error,
              "length %.17g +- %g", s.branch[i].length.value,
              s.branch[i].length.error);
    }
    plane_end(&s, &c);
}

static double of_front(const void *ctx, double u, double v, double *steep)
{
    (void) ctx;
    *steep = 1.0 + fabs(1.0 - 2.0 * u);
    return v - u * (1.0 - u) / sqrt(2.0);
}

static void fronts_of_nagumo_join_two_saddles(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    for (int i = 1; i < 5; i++) {
        char ode[160];
        snprintf(ode, sizeof ode,
                 "u' = v; v' = c*v - u*(1 - u)*(u - a); a = 0.%d; "
                 "c = (1 - 2*a)/sqrt(2)",
                 i);
        plane_run(&s, &c, ode,
                  "window={u: [-0.5, 1.5], v: [-1, 1]}\n"
                  "products=[manifolds]\n");
        assert_int_equal(s.saddles, 2);
        const struct plane_branch *out =
            plane_branch_of(&s, 0, MANIFOLD_UNSTABLE, 0);
        const struct plane_branch *in =
            plane_branch_of(&s, 1, MANIFOLD_STABLE, 1);
        plane_on(&s, out, of_front, NULL, 0.9, 1e-12);
        plane_on(&s, in, of_front, NULL, 0.5, 1e-12);
        assert_int_equal(out->end, PLANE_END_SADDLE);
        assert_int_equal(out->to, (int64_t) in->rest);
        plane_end(&s, &c);
    }
}

static void a_front_into_a_saddle_beyond_the_window_ends_there(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c,
              "u' = v; v' = (1 - 2*a)/sqrt(2)*v - u*(1 - u)*(u - a); a = 0.25",
              "window={u: [-0.2, 0.8], v: [-0.5, 0.5]}\n"
              "products=[manifolds]\n");
    assert_int_equal(s.saddles, 1);
    const struct plane_branch *out =
        plane_branch_of(&s, 0, MANIFOLD_UNSTABLE, 0);
    assert_int_equal(out->end, PLANE_END_SADDLE);
    assert_int_equal(out->to, RECORD_COUNT_NONE);
    CHECK(fabs(out->leaves[0].value - 0.8) <= out->leaves[0].error, "%.17g",
          out->leaves[0].value);
    CHECK(fabs(out->leaves[1].value - 0.16 / sqrt(2.0)) <=
                  out->leaves[1].error &&
              out->leaves[1].error < 1e-10,
          "%.17g +- %.1e", out->leaves[1].value, out->leaves[1].error);
    plane_end(&s, &c);
}

/* ---- random systems ------------------------------------------------------ */

static double of_line(const void *ctx, double x, double y, double *steep)
{
    const double *d = ctx;

    *steep = 1.0;
    return (x * d[1] - y * d[0]) / hypot(d[0], d[1]);
}

/* x' = A x with A = V diag(-p, q) V^-1 */
static void linear_saddles_have_straight_manifolds(void **state)
{
    uint64_t rng = 20261122;

    (void) state;
    for (int i = 0; i < 12; i++) {
        const double a = uniform(&rng, 0.0, 3.0), e = a + uniform(&rng, 0.3, 2);
        const double p = uniform(&rng, 0.1, 3), q = uniform(&rng, 0.1, 3);
        const double v[2] = { cos(a), sin(a) }, w[2] = { cos(e), sin(e) };
        const double det = v[0] * w[1] - v[1] * w[0];
        const double A[4] = { (-p * v[0] * w[1] - q * w[0] * v[1]) / det,
                              (p + q) * v[0] * w[0] / det,
                              -(p + q) * v[1] * w[1] / det,
                              (p * v[1] * w[0] + q * w[1] * v[0]) / det };
        char ode[200];
        struct plane_study s;
        struct scene c;
        snprintf(ode, sizeof ode,
                 "x' = %.17g*x + %.17g*y; y' = %.17g*x + "
                 "%.17g*y",
                 A[0], A[1], A[2], A[3]);
        plane_run(&s, &c, ode, WINDOW);
        assert_int_equal(s.saddles, 1);
        CHECK(fabs(s.rest[0].lambda[0].re.value + p) <=
                      s.rest[0].lambda[0].re.error + 1e-14 &&
                  fabs(s.rest[0].lambda[1].re.value - q) <=
                      s.rest[0].lambda[1].re.error + 1e-14,
              "seed 20261122, %d: %.17g %.17g", i, s.rest[0].lambda[0].re.value,
              s.rest[0].lambda[1].re.value);
        for (size_t k = 0; k < s.branches; k++) {
            const struct plane_branch *b = &s.branch[k];
            const double *d = b->kind == MANIFOLD_STABLE ? v : w;
            double at[CURVE_DIM_MAX];
            curve_at(&b->curve.curve, 0, 1.0, at);
            /* the entries of A are rounded */
            CHECK(fabs(of_line(d, at[0], at[1], at + 2)) <=
                      1e-13 * hypot(at[0], at[1]),
                  "seed 20261122, %d: %g", i, of_line(d, at[0], at[1], at + 2));
            CHECK(b->end == PLANE_END_INFINITY, "end %d", b->end);
        }
        plane_end(&s, &c);
    }
}

/* y = Y + p(X), then x = X + q(y), of X' = X - X^3, Y' = -b Y. */
struct moved {
    double p[2], q[2], b;
    bool stable;
};

static double of_moved(const void *ctx, double x, double y, double *steep)
{
    const struct moved *m = ctx;
    const double X = x - m->q[0] * y - m->q[1] * y * y;
    const double X_y = fabs(m->q[0] + 2.0 * m->q[1] * y);
    const double p = fabs(m->p[0] + 2.0 * m->p[1] * X);

    *steep = m->stable ? 1.0 + X_y : 1.0 + p * (1.0 + X_y);
    return m->stable ? X : y - m->p[0] * X - m->p[1] * X * X;
}

static void random_shears_move_manifolds_exactly(void **state)
{
    uint64_t rng = 171;

    (void) state;
    for (int i = 0; i < 12; i++) {
        struct moved m = { { uniform(&rng, -1, 1), uniform(&rng, -0.5, 0.5) },
                           { uniform(&rng, -0.5, 0.5),
                             uniform(&rng, -0.3, 0.3) },
                           uniform(&rng, 0.5, 3),
                           false };
        char ode[600];
        struct plane_study s;
        struct scene c;
        snprintf(ode, sizeof ode,
                 "p = %.17g; r = %.17g; q = %.17g; t = %.17g; b = %.17g; "
                 "X = x - q*y - t*y^2; Y = y - p*X - r*X^2; dX = X - X^3; "
                 "dy = -b*Y + (p + 2*r*X)*dX; x' = dX + (q + 2*t*y)*dy; "
                 "y' = dy",
                 m.p[0], m.p[1], m.q[0], m.q[1], m.b);
        plane_run(&s, &c, ode,
                  "window={x: [-3, 3], y: [-2.5, 2.5]}\n"
                  "products=[manifolds]\n");
        size_t origin = 0;
        for (size_t k = 0; k < s.rests; k++)
            if (s.rest[k].type == PLANE_SADDLE && fabs(s.rest[k].z.x) < 1e-9 &&
                fabs(s.rest[k].z.y) < 1e-9)
                origin = k;
        CHECK(s.rests >= 3, "seed 171, %d: %zu equilibria", i, s.rests);
        for (size_t k = 0; k < s.branches; k++) {
            const struct plane_branch *b = &s.branch[k];
            if (b->rest != origin)
                continue;
            m.stable = b->kind == MANIFOLD_STABLE;
            plane_on(&s, b, of_moved, &m, 0.5, 1e-11);
            CHECK(m.stable || b->end == PLANE_END_EQUILIBRIUM,
                  "seed 171, %d: end %d", i, b->end);
        }
        plane_end(&s, &c);
    }
}

/* ---- ends ---------------------------------------------------------------- */

static void invariant_lines_end_at_the_first_equilibrium(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = x - x^3; y' = y - y^3", WINDOW);
    assert_int_equal(s.rests, 9);
    assert_int_equal(s.saddles, 4);
    for (size_t i = 0; i < s.branches; i++) {
        const struct plane_branch *b = &s.branch[i];
        if (b->end == PLANE_END_INFINITY)
            continue;
        assert_int_equal(b->end, PLANE_END_EQUILIBRIUM);
        CHECK(fabs(b->length.value - 1.0) <= b->length.error,
              "length %.17g +- %g", b->length.value, b->length.error);
    }
    plane_end(&s, &c);
}

/* Bars of a curve that winds in grow with what is off, not with its turns. */
static void bars_stay_small_along_spirals(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = y; y' = x - x^3 - 0.1*y", WINDOW);
    for (size_t i = 0; i < s.branches; i++) {
        const struct plane_branch *b = &s.branch[i];
        for (size_t k = 0; k < b->shown; k++)
            CHECK(b->curve.curve.piece[k].error <= 1e-9, "piece %zu: %g", k,
                  b->curve.curve.piece[k].error);
    }
    plane_end(&s, &c);
}

static void manifolds_wind_on_to_a_cycle(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = y; y' = -x + 0.5*(1 - x^2)*y + 0.02*x^3",
              "window={x: [-8, 8], y: [-5, 5]}\nproducts=[manifolds]\n");
    assert_int_equal(s.rests, 3);
    assert_int_equal(s.cycles, 1);
    size_t to_cycle = 0;
    for (size_t i = 0; i < s.branches; i++)
        to_cycle += s.branch[i].end == PLANE_END_CYCLE &&
                    s.branch[i].kind == MANIFOLD_UNSTABLE;
    assert_int_equal(to_cycle, 2);
    plane_end(&s, &c);
}

static void systems_without_equilibria_are_studied(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = 1 + x^2; y' = -y",
              "window={x: [-2, 2], y: [-2, 2]}\n"
              "products=[manifolds, nullclines, trajectories]\n"
              "trajectories.starts=[{x: 0, y: 1}]\n");
    assert_int_equal(s.rests, 0);
    assert_int_equal(s.branches, 0);
    assert_int_equal(s.portrait.trajectories.count, 1);
    plane_end(&s, &c);
}

static void positive_states_are_logarithms(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = x*(1 - x - 1.5*y); y' = y*(1 - y - 1.6*x)",
              "system.state={x: positive, y: positive}\n"
              "window={x: [0.01, 2], y: [0.01, 2]}\nproducts=[manifolds]\n");
    assert_int_equal(s.rests, 1);
    for (int i = 0; i < 2; i++)
        CHECK(fabs(s.rest[0].state[i].value - (i ? 3.0 : 2.5) / 7.0) <=
                  s.rest[0].state[i].error,
              "%.17g +- %g", s.rest[0].state[i].value,
              s.rest[0].state[i].error);
    plane_end(&s, &c);
}

#define TEST(test)                                                             \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

/* To an equilibrium outside of the window, and to infinity. */
static void ends_outside_are_what_is_on_the_way(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    for (int i = 0; i < 2; i++) {
        plane_run(&s, &c, i ? "x' = x + x^3; y' = -y" : "x' = x - x^3; y' = -y",
                  "window={x: [-0.5, 0.5], y: [-1, 1]}\n"
                  "products=[manifolds]\n");
        for (int k = 0; k < 2; k++) {
            assert_int_equal(plane_branch_of(&s, 0, MANIFOLD_UNSTABLE, k)->end,
                             i ? PLANE_END_INFINITY : PLANE_END_EQUILIBRIUM);
            assert_int_equal(plane_branch_of(&s, 0, MANIFOLD_STABLE, k)->end,
                             PLANE_END_INFINITY);
        }
        plane_end(&s, &c);
    }
}

/* Those about a centre; a focus's go on. */
static void orbits_that_have_closed_are_drawn_no_further(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    for (int i = 0; i < 2; i++) {
        plane_run(&s, &c, i ? "x' = y; y' = -x - 1e-4*y" : "x' = y; y' = -x",
                  "window={x: [-2, 2], y: [-2, 2]}\n"
                  "products=[trajectories]\ntrajectories.starts=[{x: 0.7, y: "
                  "0.2}]\n");
        const struct trajectory *t = &s.portrait.trajectories.at[0];
        assert_int_equal(t->end, ORBIT_RUNNING);
        assert_int_equal(t->status, i ? STATUS_TOO_MANY_STEPS : STATUS_OK);
        double at[CURVE_DIM_MAX];
        curve_at(&t->curve, t->curve.count - 1, 1.0, at);
        assert_true(i ? at[2] > 1e3 : at[2] > 6.28 && at[2] < 60.0);
        plane_end(&s, &c);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(homoclinic_loops_of_duffing_are_known),
        TEST(an_angle_has_one_saddle_in_a_period),
        TEST(fronts_of_nagumo_join_two_saddles),
        TEST(a_front_into_a_saddle_beyond_the_window_ends_there),
        TEST(linear_saddles_have_straight_manifolds),
        TEST(random_shears_move_manifolds_exactly),
        TEST(invariant_lines_end_at_the_first_equilibrium),
        TEST(bars_stay_small_along_spirals),
        TEST(manifolds_wind_on_to_a_cycle),
        TEST(systems_without_equilibria_are_studied),
        TEST(positive_states_are_logarithms),
        TEST(ends_outside_are_what_is_on_the_way),
        TEST(orbits_that_have_closed_are_drawn_no_further),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
