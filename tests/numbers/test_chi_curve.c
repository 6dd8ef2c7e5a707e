/* chi(v) against (34) as it is printed, in 113 bits. */
#include "chi_curve.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "fault_alloc.h"
#include "quad.h"
#include "study_tolerance.h"

static struct chi_curves curves_of(const struct law *law,
                                   const struct material *m,
                                   const double alpha[], size_t slopes,
                                   double from, double to)
{
    const double v[2] = { from, to };
    struct chi_curves c;

    assert_int_equal(chi_curves_find(law, m, alpha, slopes, v, &c), STATUS_OK);
    assert_int_equal(c.slopes, slopes);
    assert_int_equal(c.points, STUDY_CURVE_POINTS);
    return c;
}

/* ---- the formula --------------------------------------------------------- */

static quad printed_eta(const struct law *law, const struct material *m)
{
    return law_uses(law, MATERIAL_R) ? (quad) m->R / (1 + (quad) m->R) : 1;
}

/* ln |sinh u| */
static quad log_sinh(quad u)
{
    const quad size = fabsq(u);
    return size < 30 ? logq(fabsq(sinhq(u)))
                     : size + log1pq(-expq(-2 * size)) - logq(2);
}

/* (34): v/psi_sp eps^2 sinh(psi_sp - psi_ss)/(eta psi_ss (mu cos - sin)). */
static quad printed_ln_chi(const struct law *law, const struct material *m,
                           double alpha, quad v)
{
    const quad cosine = cosl((long double) alpha);
    const quad sine = sinl((long double) alpha);
    const quad a = m->a, b = m->b, mu_star = m->mu_star;
    const quad ln_psi = -(mu_star - sine / cosine) / (b - a);
    const quad psi = expq(ln_psi), psi_ss = 1 / v;
    const quad mu = mu_star + a * logq(v) + b * ln_psi;
    const quad eps2 =
        (quad) m->V_star * (quad) m->V_star / ((quad) m->g * (quad) m->L);

    CHECK((psi > psi_ss) == (mu * cosine > sine), "v = %.17g, psi_sp = %g",
          (double) v, (double) psi);
    return logq(v / psi * eps2 / (printed_eta(law, m) * psi_ss)) +
           log_sinh(psi - psi_ss) - logq(fabsq(mu * cosine - sine));
}

/* A law and a material with a saddle in the range of doubles. */
static const struct law *draw(uint64_t *seed, struct material *m)
{
    static const char *const name[] = { "dieterich_gen", "spinodal_gen",
                                        "spinodal_phi_gen" };

    *m = material_bristol_board();
    m->mu_star = check_uniform(seed, 0.3, 0.7);
    m->a = check_uniform(seed, 0.005, 0.05);
    m->b = m->a + check_uniform(seed, 0.01, 0.05);
    m->L = pow(10.0, check_uniform(seed, -7, -3));
    m->V_star = pow(10.0, check_uniform(seed, -8, -4));
    m->R = pow(10.0, check_uniform(seed, -2, 4));
    return law_preset_find(name[check_bits(seed) % 3]);
}

enum { DRAWS = 300 };

static void chi_is_as_printed_within_its_bar_whatever_the_material(void **state)
{
    uint64_t seed = check_seed();

    (void) state;
    for (int i = 0; i < DRAWS; i++) {
        struct material m;
        const struct law *law = draw(&seed, &m);
        const double alpha = check_uniform(&seed, 0.2, 0.6);
        const double from = pow(10.0, check_uniform(&seed, -12, 0));
        struct chi_curves c = curves_of(law, &m, &alpha, 1, from, 1e7 * from);
        for (size_t k = 0; k < c.points; k += 1 + check_bits(&seed) % 40) {
            const quad want = printed_ln_chi(law, &m, alpha, (quad) c.v[k]);
            const double off = (double) fabsq((quad) c.ln_chi[k] - want);
            const double size = 1.0 + fabs(c.ln_chi[k]) + 1.0 / c.v[k] +
                                1.0 / c.slope[0].v_sp0.value;
            CHECK(off <= c.error[k], "%s v = %.17g: %.17g +- %.1g is off %.1g",
                  law->preset, c.v[k], c.ln_chi[k], c.error[k], off);
            CHECK(c.error[k] < 1e-11 * size, "%s v = %.17g: %.17g +- %.1g",
                  law->preset, c.v[k], c.ln_chi[k], c.error[k]);
        }
        chi_curves_free(&c);
    }
}

/* Below the lower root chi > 1, between both < 1, above the upper one > 1.
 * Where v_sp0 is next to nothing, both lie within each other's bars, which are
 * then next to nothing, too. */
static void chi_passes_through_one_within_the_bars_of_its_roots(void **state)
{
    uint64_t seed = check_seed();
    size_t roots = 0, apart = 0;

    (void) state;
    for (int i = 0; i < DRAWS; i++) {
        struct material m;
        const struct law *law = draw(&seed, &m);
        const double alpha = check_uniform(&seed, 0.2, i % 2 ? 1.2 : 0.6);
        struct chi_curves c = curves_of(law, &m, &alpha, 1, 1e-3, 1e3);
        const struct quantity *at[] = { &c.slope[0].v_low, &c.slope[0].v_high };
        CHECK(quantity_exists(at[0]) == quantity_exists(at[1]), "draw %d", i);
        for (int k = 0; k < 2 && quantity_exists(at[k]); k++) {
            const quad v = at[k]->value, bar = at[k]->error;
            const quad out = k == 0 ? v - bar : v + bar;
            const quad in = k == 0 ? v + bar : v - bar;
            const bool alone =
                at[0]->value + at[0]->error < at[1]->value - at[1]->error;
            CHECK(printed_ln_chi(law, &m, alpha, out) > 0 &&
                      (!alone || printed_ln_chi(law, &m, alpha, in) < 0),
                  "root %d at %.17g +- %.1g, v_sp0 = %g", k, at[k]->value,
                  at[k]->error, c.slope[0].v_sp0.value);
            CHECK(at[k]->error < 1e-11 * at[k]->value, "%.17g +- %.1g",
                  at[k]->value, at[k]->error);
            roots++;
            apart += alone;
        }
        chi_curves_free(&c);
    }
    CHECK(roots > DRAWS / 2 && apart > DRAWS / 4 && apart < roots,
          "%zu roots, %zu apart", roots, apart);
}

static void the_numbers_of_the_paper_come_out(void **state)
{
    static const double alpha[] = { 0.2, 0.28, 0.34, 0.38 };
    const struct law *law = law_preset_find("spinodal_gen");
    const struct material m = material_bristol_board();
    struct chi_curves c = curves_of(law, &m, alpha, 4, 1e-4, 1e6);

    (void) state;
    const struct chi_slope *s = &c.slope[2];
    CHECK(fabs(s->v_low.value - 0.050262025) < 1e-9, "%.9g", s->v_low.value);
    CHECK(fabs(s->v_high.value - 1312.6136) < 1e-4, "%.9g", s->v_high.value);
    for (size_t k = 0; k < 4; k++) {
        s = &c.slope[k];
        assert_true(s->alpha == alpha[k]);
        CHECK((s->v_high.value > s->v_sp0.value) == (k > 0),
              "at %g: %g and v_sp %g", alpha[k], s->v_high.value,
              s->v_sp0.value);
    }
    chi_curves_free(&c);
}

/* ---- its frame ----------------------------------------------------------- */

static void points_are_even_in_ln_v_and_rows_belong_to_slopes(void **state)
{
    static const double alpha[] = { 0.38, 0.3 };
    const struct law *law = law_preset_find("dieterich_gen");
    const struct material m = material_bristol_board();
    struct chi_curves both = curves_of(law, &m, alpha, 2, 1e-300, 1e300);
    struct chi_curves one = curves_of(law, &m, &alpha[1], 1, 1e-300, 1e300);
    const double step = log(1e300) / (STUDY_CURVE_POINTS - 1) * 2;

    (void) state;
    assert_true(both.v[0] == 1e-300 && both.reason == NULL);
    for (size_t k = 1; k < both.points; k++)
        CHECK(fabs(log(both.v[k]) - log(both.v[k - 1]) - step) < 1e-10, "%zu",
              k);
    assert_memory_equal(both.ln_chi + both.points, one.ln_chi,
                        one.points * sizeof *one.ln_chi);
    for (size_t k = 0; k < 2 * both.points; k++)
        CHECK(isfinite(both.ln_chi[k]) && isfinite(both.error[k]), "%zu", k);
    chi_curves_free(&both);
    chi_curves_free(&one);
}

/* The formula has 0/0 there. */
static void the_curve_passes_the_saddle_smoothly(void **state)
{
    static const double beside[] = { 1e-1, 1e-3, 1e-6, 1e-9, 1e-12 };
    const double alpha = 0.34;
    const struct law *law = law_preset_find("dieterich_gen");
    const struct material m = material_bristol_board();
    struct chi_curves at = curves_of(law, &m, &alpha, 1, 1.0, 10.0);
    const double v = at.slope[0].v_sp0.value;

    (void) state;
    for (size_t i = 0; i < sizeof beside / sizeof *beside; i++) {
        struct chi_curves c = curves_of(law, &m, &alpha, 1, v * (1 - beside[i]),
                                        v * (1 + beside[i]));
        for (size_t k = 0; k < c.points; k += 25) {
            const quad want = printed_ln_chi(law, &m, alpha, (quad) c.v[k]);
            const double off = (double) fabsq((quad) c.ln_chi[k] - want);
            CHECK(off <= c.error[k] && c.error[k] < 1e-12,
                  "%g beside: %.17g +- %.1g is off %.1g", beside[i],
                  c.ln_chi[k], c.error[k], off);
        }
        chi_curves_free(&c);
    }
    chi_curves_free(&at);
}

static void a_law_without_estimates_says_why(void **state)
{
    const double alpha = 0.34;
    const struct material m = material_bristol_board();
    struct chi_curves c =
        curves_of(law_preset_find("ruina"), &m, &alpha, 1, 0.1, 10.0);

    (void) state;
    assert_non_null(strstr(c.reason, "hyperbolic kinetics"));
    assert_false(quantity_exists(&c.slope[0].v_low));
    assert_string_equal(c.slope[0].v_high.reason, c.reason);
    assert_true(isnan(c.ln_chi[0]) && isnan(c.error[0]));
    chi_curves_free(&c);
}

static void an_allocation_that_fails_leaves_nothing(void **state)
{
    const double alpha = 0.34, v[2] = { 0.1, 10.0 };
    const struct law *law = law_preset_find("dieterich_gen");
    const struct material m = material_bristol_board();
    struct chi_curves c;

    (void) state;
    for (int i = 0; i < 4; i++) {
        fault_alloc_at(i);
        assert_int_equal(chi_curves_find(law, &m, &alpha, 1, v, &c),
                         STATUS_NO_MEMORY);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        assert_true(c.slope == NULL && c.v == NULL && c.slopes == 0);
        chi_curves_free(&c);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(
            chi_is_as_printed_within_its_bar_whatever_the_material),
        cmocka_unit_test(chi_passes_through_one_within_the_bars_of_its_roots),
        cmocka_unit_test(the_numbers_of_the_paper_come_out),
        cmocka_unit_test(points_are_even_in_ln_v_and_rows_belong_to_slopes),
        cmocka_unit_test(the_curve_passes_the_saddle_smoothly),
        cmocka_unit_test(a_law_without_estimates_says_why),
        cmocka_unit_test(an_allocation_that_fails_leaves_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
