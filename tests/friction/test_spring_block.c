/* The stick-slip boundary against the eigenvalues of the block, its spring and
 * its interface: a matrix of differences of the printed law in 113 bits, whose
 * pair of roots crosses the imaginary axis. */
#include "spring_block.h"

#include <float.h>

#include "check.h"
#include "laws.h"
#include "plain.h"
#include "response.h"
#include "steady.h"

/* A pulled block and the state it slides in; speeds in V_star, lengths in L. */
struct pulled {
    struct law law;
    struct material m;
    struct spring_block block;
    quad x;
};

static quad evolution(const struct pulled *p, quad x, quad psi)
{
    const quad v = expq(x);

    if (p->law.kinetics == KINETICS_COMPOSITE)
        return expq(-v / (quad) p->m.V_c) - v * psi * logq(v * psi);
    const quad d = psi - plain_psi_ss(&p->law, &p->m, x);
    return -(p->law.kinetics == KINETICS_SINH ? sinhq(d) : d) *
           expq(-plain_log_T(&p->law, &p->m, x));
}

/* Partial derivatives by ln v and psi of mu and dpsi/dt. */
struct partial {
    quad mu_x, mu_psi, f_x, f_psi;
};

static struct partial partials(const struct pulled *p)
{
    const quad psi = plain_psi_ss(&p->law, &p->m, p->x), h = (quad) 1e-10;
    const quad step = h * (fabsq(psi) < 1 ? fabsq(psi) : 1);
    const quad near = h / (1 + fabsq(psi)); /* sinh is linear so far */

#define SLOPE(f, x_, psi_, d)                                                  \
    ((f(p->x + (x_), psi + (psi_)) - f(p->x - (x_), psi - (psi_))) / (2 * (d)))
#define MU(x, psi) plain_mu(&p->law, &p->m, x, psi)
#define F(x, psi)  evolution(p, x, psi)
    return (struct partial){ SLOPE(MU, h, 0, h), SLOPE(MU, 0, step, step),
                             SLOPE(F, near, 0, near), SLOPE(F, 0, step, step) };
#undef SLOPE
#undef MU
#undef F
}

/* The real root r < 0 of l^3 + a l^2 + b l + c, a and c positive. */
static quad real_root(quad a, quad b, quad c)
{
    quad lo = -(a + sqrtq(fabsq(b)) + expq(logq(c) / 3)) * 2, hi = 0;

    for (int i = 0; i < 220; i++) {
        const quad mid = (lo + hi) / 2;
        if (((mid + a) * mid + b) * mid + c < 0)
            lo = mid;
        else
            hi = mid;
    }
    return lo;
}

/* Real part of the pair of eigenvalues of
 *     d(lag, v, psi)/dt = [0 -1 0; k/M -mu_v/M -mu_psi/M; 0 f_v f_psi]
 * with everything per sigma, M = m V_star^2/(L sigma), k in sigma/L; without
 * mass the middle row is a constraint. */
static quad growth(const struct pulled *p, quad k)
{
    const struct partial d = partials(p);
    const quad v = expq(p->x), mu_v = d.mu_x / v, f_v = d.f_x / v;
    const quad V = (quad) p->m.V_star;
    const quad M =
        (quad) p->block.mass * V * V / ((quad) p->m.L * (quad) p->block.sigma);

    if (M == 0) /* dv = (k lag - mu_psi dpsi)/mu_v: the trace of what is left */
        return (-k / mu_v + d.f_psi - f_v * d.mu_psi / mu_v) / 2;
    const quad trace = -mu_v / M + d.f_psi;
    const quad minors = k / M - mu_v * d.f_psi / M + d.mu_psi * f_v / M;
    const quad det = k * d.f_psi / M;
    const quad r = real_root(-trace, minors, -det);
    return (minors - det / r) / r / 2; /* = (trace - r)/2, but for rounding */
}

/* A random one; false where the state is out of reach. */
static bool draw(size_t i, uint64_t *seed, struct pulled *p)
{
    const double x = check_uniform(seed, -8, 8);

    if (!laws_draw(i % LAWS, seed, &p->law, &p->m) ||
        (long double) x >= steady_x_max(&p->law) || fabs(x) < 1e-2)
        return false;
    p->x = (quad) x;
    p->block = (struct spring_block){ laws_power(seed, 1, 8), 0.0 };
    if (check_bits(seed) % 3)
        p->block.mass = p->block.sigma * laws_power(seed, -3, 2);
    return true;
}

/* Whether the state hardly ever changes, or there is next to no friction: of
 * 33 digits none is left for the crossing. */
static bool faint(const struct pulled *p)
{
    const struct response r = response_at(&p->law, &p->m, (long double) p->x);
    return r.rate < 1e-6L || r.direct < 1e-6L;
}

static struct spring_limit limit_of(const struct pulled *p)
{
    return spring_block_limit(&p->block, &p->law, &p->m, (long double) p->x);
}

/* From Pa/m to sigma/L. */
static quad scaled(const struct pulled *p, long double k)
{
    return (quad) k * (quad) p->m.L / (quad) p->block.sigma;
}

static void a_pair_of_eigenvalues_crosses_the_axis_at_the_boundary(void **state)
{
    uint64_t seed = check_seed();
    struct pulled p;
    int crossed = 0;

    (void) state;
    if (laws_emulated())
        return;
    for (size_t i = 0; i < LAWS * 20; i++) {
        if (!draw(i, &seed, &p))
            continue;
        const struct spring_limit at = limit_of(&p);
        const double error = (double) at.relative_error;
        if (!(at.k > 0) || error > 1e-10 || faint(&p))
            continue;
        /* differences are good to 1e-18 of what they are taken of, which
         * cancels towards an extremum as the slope does */
        const double part = 100 * error + 1e-14;
        const quad k = scaled(&p, at.k);
        CHECK(growth(&p, k * (1 - (quad) part)) > 0 &&
                  growth(&p, k * (1 + (quad) part)) < 0,
              "law %zu x = %g mass %g: k = %Lg: growth %g, %g", i % LAWS,
              (double) p.x, p.block.mass, at.k,
              (double) growth(&p, k * (1 - (quad) part)),
              (double) growth(&p, k * (1 + (quad) part)));
        crossed++;
    }
    CHECK(crossed > LAWS, "%d of %d", crossed, LAWS * 20);
}

static void where_friction_rises_no_spring_is_soft_enough(void **state)
{
    uint64_t seed = check_seed();
    struct pulled p;
    int rising = 0;

    (void) state;
    if (laws_emulated())
        return;
    for (size_t i = 0; i < LAWS * 10; i++) {
        if (!draw(i, &seed, &p))
            continue;
        const struct response r = response_at(&p.law, &p.m, (long double) p.x);
        const struct spring_limit at = limit_of(&p);
        CHECK((at.k > 0) == (r.slope < 0), "law %zu: k = %Lg, slope %Lg",
              i % LAWS, at.k, r.slope);
        if (r.slope <= 0)
            continue;
        for (int decade = -12; decade <= 6; decade += 6)
            CHECK(growth(&p, expq(decade * logq(10))) < 0,
                  "law %zu at k = 1e%d", i % LAWS, decade);
        rising++;
    }
    CHECK(rising > LAWS, "%d", rising);
}

static void inertia_only_widens_stick_slip(void **state)
{
    uint64_t seed = check_seed();
    struct pulled p;

    (void) state;
    if (laws_emulated())
        return;
    for (size_t i = 0; i < LAWS * 10; i++) {
        if (!draw(i, &seed, &p))
            continue;
        const struct spring_limit at = limit_of(&p);
        p.block.mass = 0.0;
        const struct spring_limit light = limit_of(&p);
        CHECK(fabsl(at.k) >= fabsl(at.k_quasistatic), "law %zu", i % LAWS);
        CHECK(light.k == light.k_quasistatic && light.k == at.k_quasistatic,
              "law %zu: %Lg, %Lg", i % LAWS, light.k, at.k_quasistatic);
    }
}

/* Rice & Ruina's: sigma (b - a)/L, with inertia 1 + m V^2/(sigma a L) times
 * that. */
static void dieterich_s_boundary_is_the_textbook_s(void **state)
{
    const struct material m = material_bristol_board();
    const struct spring_block block = { 1e3, 100.0 };
    const double textbook = 1e3 * (m.b - m.a) / m.L;
    struct law law = *law_preset_find("dieterich");

    (void) state;
    law.form = FRICTION_LOG;
    for (int x = -15; x <= 15; x += 3) {
        const struct spring_limit at = spring_block_limit(&block, &law, &m, x);
        const double V = exp(x) * m.V_star;
        const double inertia = 1 + 100.0 * V * V / (1e3 * m.a * m.L);
        CHECK(fabs((double) at.k_quasistatic / textbook - 1) < 1e-14,
              "x = %d: %Lg", x, at.k_quasistatic);
        CHECK(fabs((double) at.k / (textbook * inertia) - 1) < 1e-13,
              "x = %d: %Lg", x, at.k);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(
            a_pair_of_eigenvalues_crosses_the_axis_at_the_boundary),
        cmocka_unit_test(where_friction_rises_no_spring_is_soft_enough),
        cmocka_unit_test(inertia_only_widens_stick_slip),
        cmocka_unit_test(dieterich_s_boundary_is_the_textbook_s),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
