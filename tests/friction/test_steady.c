#include "steady.h"

#include <math.h>
#include <string.h>

#include "block.h"
#include "check.h"
#include "csv.h"
#include "exact_anchor.h"
#include "laws.h"
#include "quad_block.h"

enum { DRAWS = 1000 };

/* A random point of the steady-state curve, where it exists. */
static long double random_x(const struct law *law, uint64_t *seed, double top)
{
    const double hi = steady_x_max(law) < (long double) top ? -1e-3 : top;
    return (long double) check_uniform(seed, -top, hi);
}

static void steady_friction_is_the_model_s(void **state)
{
    uint64_t seed = check_seed();
    struct law law;
    struct material m;

    (void) state;
    for (size_t i = 0; i < LAWS * 20; i++) {
        if (!laws_draw(i % LAWS, &seed, &law, &m))
            continue;
        const long double x = random_x(&law, &seed, 100);
        const quad psi = plain_psi_ss(&law, &m, x);
        const quad theta = plain_theta(&law, &m, psi);
        const quad mu = plain_mu(&law, &m, x, psi);
        const quad mu_log = plain_mu_log(&law, &m, x, psi);
        /* each of the three terms of mu_log is rounded, theta within one ulp
         * of psi_ss more */
        const quad ulp = 4 * laws_long_epsilon() *
                         (fabsq(m.mu_star) + fabsq(m.a * (quad) x) +
                          m.b * (2 + 2 * fabsq(theta) + fabsq(x)));
        CHECK(fabsq(steady_mu(&law, &m, x) - mu) <= ulp,
              "law %zu x=%Lg: mu_ss %.20Lg, not %.20Lg", i % LAWS, x,
              steady_mu(&law, &m, x), (long double) mu);
        CHECK(fabsq(steady_mu_log(&law, &m, x) - mu_log) <= ulp,
              "law %zu x=%Lg: mu_log", i % LAWS, x);
        CHECK(fabsq(steady_psi(&law, &m, x) / psi - 1) <=
                  4 * (1 + fabsq(x)) * laws_long_epsilon(),
              "law %zu x=%Lg: psi_ss", i % LAWS, x);
        const quad y = law_psi_is_log(&law) ? psi : logq(psi);
        CHECK(fabsq(steady_y(&law, &m, x) - y) <=
                  4 * (1 + fabsq(x) + fabsq(y)) * laws_long_epsilon(),
              "law %zu x=%Lg: y_ss", i % LAWS, x);
    }
}

static void tau_is_the_mu_log_of_a_slope(void **state)
{
    uint64_t seed = check_seed();
    struct law law = *law_preset_find("spinodal");

    (void) state;
    for (int i = 0; i < 1000; i++) {
        struct material m = laws_material(&seed);
        const long double t = (long double) laws_power(&seed, -6, 1);
        law.form = FRICTION_LOG;
        assert_true(steady_tau(&law, &m, t) == t);
        law.form = FRICTION_ASINH;
        const quad tau = steady_tau(&law, &m, t), a = m.a;
        const quad w = tau / a;
        const quad mu = w > 5000 ? tau : a * asinhq(expq(w) / 2);
        CHECK(fabsq(mu / t - 1) <= 8 * (1 + fabsq(w)) * laws_long_epsilon(),
              "tan(alpha)=%Lg a=%g: mu(tau) off by %Lg", t, m.a,
              (long double) (mu / t - 1));
    }
}

/* One fold of the reference table against extremum x.  What rounding the
 * decimals to doubles costs: v_M ~ a/((b-a) R), so (a+b)/(b-a) half ulps, and
 * as much again over the square root where the folds are close to merging
 * (c = 2.5: the discriminant is a seventh of its terms). */
static void check_fold(const struct csv *c, const struct law *law,
                       const struct material *m, long double x,
                       const char *const names[3])
{
    const double cost = 4 * (m->a + m->b) / (m->b - m->a) * 0x1p-53;
    const quad v = strtof128(csv_text(c, names[0]), NULL);
    const quad mu = strtof128(csv_text(c, names[1]), NULL);
    const quad alpha = strtof128(csv_text(c, names[2]), NULL);
    const long double found = steady_mu(law, m, x);
    const double off_v = fabs((double) (expq(x) / v - 1));
    const double off_mu = fabs((double) (found / mu - 1));
    const double off_alpha = fabs((double) (atanl(found) / alpha - 1));

    CHECK(off_v <= fmin(1e-12, 1e-15 + 7 * cost), "row %zu: %s off by %g",
          c->row, names[0], off_v);
    CHECK(off_mu <= 2e-15, "row %zu: %s off by %g", c->row, names[1], off_mu);
    CHECK(off_alpha <= 2e-15, "row %zu: %s off by %g", c->row, names[2],
          off_alpha);
}

static void folds_agree_with_the_reference_table(void **state)
{
    static const char *const top[] = { "v_M", "mu_M", "alpha_cM" };
    static const char *const bottom[] = { "v_m", "mu_m", "alpha_cm" };
    struct csv c;
    size_t rows = 0;

    (void) state;
    for (csv_open(&c, "folds.csv"); csv_next(&c); rows++) {
        struct law law = *law_preset_find("spinodal");
        struct material m = material_bristol_board();
        long double x[4];
        if (strcmp(csv_text(&c, "form"), "log") == 0)
            law.form = FRICTION_LOG;
        m.mu_star = csv_number(&c, "mu_star", 0);
        m.a = csv_number(&c, "a", 0);
        m.b = csv_number(&c, "b", 0);
        m.c = csv_number(&c, "c", 0);
        m.R = csv_number(&c, "R", 0);
        const bool has_top = *csv_text(&c, "v_M") != '\0';
        const bool has_bottom = *csv_text(&c, "v_m") != '\0';
        const size_t n = steady_extrema(&law, &m, x);
        CHECK(n == (size_t) has_top + has_bottom, "row %zu: %zu extrema", c.row,
              n);
        if (has_top)
            check_fold(&c, &law, &m, x[0], top);
        if (has_bottom)
            check_fold(&c, &law, &m, x[1], bottom);
    }
    assert_true(rows >= 26);
}

/* d mu_log/dx by central differences in 113 bits; mu_ss rises with mu_log. */
static quad slope(const struct law *law, const struct material *m, quad x)
{
    const quad h = (quad) 1e-9, r = x + h, l = x - h;
    return (plain_mu_log(law, m, r, plain_psi_ss(law, m, r)) -
            plain_mu_log(law, m, l, plain_psi_ss(law, m, l))) /
           (2 * h);
}

/* Between the extrema found (and out to +-60) the slope keeps one sign, and
 * at each of them it changes. */
static void check_turnings(size_t number, const struct law *law,
                           const struct material *m)
{
    enum { POINTS = 40 };
    long double x[4];
    const size_t n = steady_extrema(law, m, x);
    const long double top = steady_x_max(law);
    bool rises = false;

    for (size_t i = 0; i <= n; i++) {
        const long double lo = i == 0 ? -60 : x[i - 1];
        const long double hi = i < n ? x[i] : top < 60 ? top - 1e-6L : 60;
        assert_true(lo < hi);
        for (int k = 0; k < POINTS; k++) {
            const quad at = lo + (hi - lo) * (k + 0.5L) / POINTS;
            const bool up = slope(law, m, at) > 0;
            if (k == 0 && i > 0)
                CHECK(up != rises, "law %zu: no turn at x=%Lg", number, lo);
            if (k == 0)
                rises = up;
            CHECK(up == rises, "law %zu, %zu extrema: a turn before x=%Lg",
                  number, n, (long double) at);
        }
    }
}

static void extrema_are_where_the_slope_changes_sign(void **state)
{
    uint64_t seed = check_seed();
    struct law law;
    struct material m;
    size_t found[3] = { 0 };

    (void) state;
    print_message("# seed %llu\n", (unsigned long long) seed);
    for (size_t i = 0; i < LAWS || found[0] + found[1] + found[2] < DRAWS;
         i++) {
        long double x[4];
        if (!laws_draw(i % LAWS, &seed, &law, &m))
            continue;
        if (law.kinetics == KINETICS_COMPOSITE) /* two extrema now and then */
            m.b = m.a * check_uniform(&seed, 0.7, 1.1);
        check_turnings(i % LAWS, &law, &m);
        found[steady_extrema(&law, &m, x)]++;
    }
    print_message("# draws with 0, 1, 2 extrema: %zu %zu %zu\n", found[0],
                  found[1], found[2]);
    assert_true(found[0] > 50 && found[1] > 50 && found[2] > 50);
}

static void kato_tullis_turns_twice_or_never(void **state)
{
    uint64_t seed = check_seed();
    const struct law *law = law_preset_find("kato_tullis");
    size_t turning = 0;

    (void) state;
    for (int i = 0; i < 100; i++) {
        struct material m = laws_material(&seed);
        long double x[4];
        m.b = m.a / check_uniform(&seed, 0.95, 1.3);
        check_turnings(LAWS - 1, law, &m);
        turning += steady_extrema(law, &m, x) == 2;
    }
    assert_true(turning > 20 && turning < 80);
}

static void psi_ss_leaves_the_domain_at_v_1_under_minus_log(void **state)
{
    struct law law = *law_preset_find("dieterich");

    (void) state;
    assert_true(isinf((double) steady_x_max(&law)));
    assert_true(isinf((double) steady_x_max(law_preset_find("ruina"))));
    law.psi_ss = PSI_SS_MINUS_LOG;
    assert_true(steady_x_max(&law) == 0);
}

/* A double made from a long double within `slack` of the exact member. */
static void same(const char *name, size_t law, double found, quad exact,
                 quad slack)
{
    const quad ulp = fabsq(exact) * 0x1.01p-53 + 0x1p-1072 +
                     (slack + 4 * fabsq(exact)) * laws_long_epsilon();
    CHECK(fabsq(found - exact) <= ulp, "law %zu: %s = %.17g, not %.17g", law,
          name, found, (double) exact);
}

static void anchors_are_right_to_the_last_bit(void **state)
{
    uint64_t seed = check_seed();
    struct law law;
    struct material m;
    struct anchor at;

    (void) state;
    for (size_t i = 0; i < LAWS * 10; i++) {
        if (!laws_draw(i % LAWS, &seed, &law, &m))
            continue;
        const size_t n = i % LAWS;
        const long double x = random_x(&law, &seed, 5);
        const long double tangent = (long double) laws_power(&seed, -2, 0);
        const bool equilibrium = check_bits(&seed) % 2;
        steady_anchor(&law, &m, tangent, x, equilibrium, &at);
        const struct exact_anchor q =
            exact_anchor_at(&law, &m, tangent, x, equilibrium);
        /* mu is a sum of terms as large as b psi, b/a of them in w0 */
        const quad terms =
            8 * (1 + m.a * 5 + m.b * (16 + fabsq(q.psi0))) + 8 * tangent;
        same("x0", n, at.x0, q.x0, 0);
        same("y0", n, at.y0, q.y0, 20);
        same("v0", n, at.v0, q.v0, 2 * q.v0);
        same("psi0", n, at.psi0, q.psi0, 20 * fabsq(q.psi0));
        same("mu0", n, at.mu0, q.mu0, terms);
        same("force0", n, at.force0, q.force0, equilibrium ? 0 : terms);
        same("a", n, at.a, q.a, 0);
        same("b", n, at.b, q.b, 0);
        same("theta_r", n, at.theta_r, q.theta_r, 20 * q.theta_r);
        same("theta_s", n, at.theta_s, q.theta_s, 20 * q.theta_s);
        same("log_inertia", n, at.log_inertia, q.log_inertia, 60);
        same("log_rate", n, at.log_rate, q.log_rate, 60);
        same("w0", n, at.w0, q.w0, terms / q.a);
    }
}

/* Coordinates of the same root to 113 and 64 bits. */
static void bisection_finds_the_equilibrium_of_the_balance(void **state)
{
    const struct material m = material_bristol_board();
    const long double tangent = tanl(0.34L);
    struct block b;

    (void) state;
    block_init(&b, law_preset_find("spinodal_gen"), &m, tangent);
    assert_int_equal(b.steady.turnings, 2);
    const quad x = quad_block_equilibrium(
        &b.law, &m, tangent, b.steady.turning[0], b.steady.turning[1]);
    CHECK(fabsq(quad_block_mu_ss(&b.law, &m, x) - tangent) < 1e-32, "off by %g",
          (double) (quad_block_mu_ss(&b.law, &m, x) - tangent));
    CHECK(fabsq(b.steady.balance(&b, (long double) x)) <
              8 * laws_long_epsilon(),
          "%g", (double) b.steady.balance(&b, (long double) x));
    CHECK(fabsq(b.steady.y(&b, (long double) x) -
                quad_block_y_ss(&b.law, &m, x)) < 8 * laws_long_epsilon(),
          "y = %Lg", b.steady.y(&b, (long double) x));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steady_friction_is_the_model_s),
        cmocka_unit_test(tau_is_the_mu_log_of_a_slope),
        cmocka_unit_test(folds_agree_with_the_reference_table),
        cmocka_unit_test(extrema_are_where_the_slope_changes_sign),
        cmocka_unit_test(kato_tullis_turns_twice_or_never),
        cmocka_unit_test(psi_ss_leaves_the_domain_at_v_1_under_minus_log),
        cmocka_unit_test(anchors_are_right_to_the_last_bit),
        cmocka_unit_test(bisection_finds_the_equilibrium_of_the_balance),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
