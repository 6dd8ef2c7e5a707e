/* Presets as formulas against their components: slopes of friction, extrema,
 * fields, gradients and series. */
#include "law_typed.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "block.h"
#include "check.h"
#include "cusp.h"
#include "equilibrium.h"
#include "laws.h"
#include "response.h"

static struct law_typed typed;

/* The preset in this form as formulas. */
static struct law formulas_of(const struct law *preset)
{
    enum law_part wrong;
    struct fault why = { "" };

    law_typed_of_preset(preset, &typed);
    const enum status s = law_typed_make(&typed, &wrong, &why);
    CHECK(s == STATUS_OK, "%s: %s", preset->preset, why.text);
    return law_of_typed(&typed);
}

static struct material some_material(uint64_t *seed, const struct law *law)
{
    struct material m = material_bristol_board();

    m.a = check_uniform(seed, 0.01, 0.1);
    m.b = m.a * check_uniform(seed, 1.1, 2);
    if (law->psi_ss == PSI_SS_LAMBERT && check_uniform(seed, 0, 1) < 0.7)
        m.b = m.a * check_uniform(seed, 0.7, 0.95);
    m.c = laws_power(seed, -5, -1);
    m.R = laws_power(seed, 0, 4);
    m.V_c = laws_power(seed, -1, 2);
    m.mu_star = check_uniform(seed, 0.2, 0.6);
    return m;
}

static bool is_near(long double found, long double exact, long double digits)
{
    return fabsl(found - exact) <= digits * (fabsl(exact) + 1e-300L);
}

enum { PRESETS = 8 };

static struct law preset_at(int i)
{
    struct law law = *law_preset_at((size_t) (i % PRESETS));

    law.form = i / PRESETS % 2 ? FRICTION_LOG : FRICTION_ASINH;
    return law;
}

/* In 113 bits, and in long double. */
static void slopes_are_those_of_the_components(void **state)
{
    uint64_t seed = check_seed();

    (void) state;
    for (int i = 0; i < 6 * PRESETS; i++) {
        const struct law law = preset_at(i), text = formulas_of(&law);
        const struct material m = some_material(&seed, &law);
        for (int n = 0; n < 20; n++) {
            const long double x = check_uniform(&seed, -30, 30);
            const long double found = response_at(&text, &m, x).slope,
                              exact = response_at(&law, &m, x).slope;
            CHECK(fabsl(found - exact) < 1e-18L * (1 + fabsl(x)),
                  "%s at %.17Lg: %Lg, not %Lg", law.preset, x, found, exact);
        }
    }
}

static void extrema_are_found_without_being_told(void **state)
{
    uint64_t seed = check_seed();
    size_t most = 0;

    (void) state;
    for (int i = 0; i < 10 * PRESETS; i++) {
        const struct law law = preset_at(i), text = formulas_of(&law);
        const struct material m = some_material(&seed, &law);
        long double found[4], exact[4];
        const size_t n = law_typed_extrema(&text, &m, found),
                     all = steady_extrema(&law, &m, exact);
        CHECK(n == all, "%s: %zu extrema, not %zu", law.preset, n, all);
        for (size_t k = 0; k < n; k++)
            CHECK(fabsl(found[k] - exact[k]) < 1e-16L * (1 + fabsl(exact[k])),
                  "%s: extremum at %.17Lg, not %.17Lg", law.preset, found[k],
                  exact[k]);
        most = n > most ? n : most;
    }
    assert_int_equal(most, 2);
}

/* Just below the cusp of Fig 4 both extrema lie within an e-fold of v, above it
 * there are none. */
static void extrema_that_nearly_meet_are_found(void **state)
{
    uint64_t seed = check_seed() + 1;

    (void) state;
    for (int i = 0; i < 80; i++) {
        seed = i == 40 ? 3 : seed; /* one beside where the slope is sampled */
        struct law law = *law_preset_find("spinodal_gen");
        law.form = i % 2 ? FRICTION_LOG : FRICTION_ASINH;
        const struct law text = formulas_of(&law);
        struct material m = some_material(&seed, &law);
        const double off = laws_power(&seed, -6, -2);
        long double x[4], exact[4];
        m.c = (double) cusp_find(&law, &m).c * (1 - off);
        assert_int_equal(steady_extrema(&law, &m, exact), 2);
        const size_t n = law_typed_extrema(&text, &m, x);
        CHECK(n == 2, "%zu extrema at %g below the cusp", n, off);
        for (int k = 0; k < 2; k++)
            CHECK(fabsl(x[k] - exact[k]) < 1e-9L, "%.17Lg, not %.17Lg", x[k],
                  exact[k]);
        m.c *= (1 + off) / (1 - off);
        assert_int_equal(law_typed_extrema(&text, &m, x), 0);
    }
}

/* psi_ss = -ln v ends at v = 1: mu_ss = mu_star + a x + b ln(-x) is largest at
 * x = -b/a. */
static void an_extremum_beside_the_end_of_mu_ss_is_found(void **state)
{
    uint64_t seed = check_seed() + 2;

    (void) state;
    for (int i = 0; i < 40; i++) {
        struct law law = { .preset = "composed",
                           .equation = "",
                           .form = i % 2 ? FRICTION_LOG : FRICTION_ASINH,
                           .theta = THETA_LN_PSI,
                           .psi_ss = PSI_SS_MINUS_LOG };
        const struct law text = formulas_of(&law);
        struct material m = material_bristol_board();
        long double x[4];
        m.b = m.a * laws_power(&seed, -2, 2);
        const size_t n = law_typed_extrema(&text, &m, x);
        CHECK(n == 1 && fabsl(x[0] + (long double) m.b / (long double) m.a) <
                            1e-13L * (1 + (long double) (m.b / m.a)),
              "%zu at %.17Lg, b/a = %g", n, x[0], m.b / m.a);
    }
}

/* Both anchored at the same point of the steady curve. */
static void anchor_both(const struct law *law, const struct law *text,
                        const struct material *m, uint64_t *seed,
                        struct block b[2])
{
    const long double x = check_uniform(seed, -5, 5);
    const long double at =
        fminl(x, steady_x_max(law) - (long double) 1); /* minus_log */

    for (int i = 0; i < 2; i++) {
        block_init(&b[i], i ? text : law, m, steady_mu(law, m, at));
        block_anchor(&b[i], at, true);
    }
}

static void the_field_is_that_of_the_components(void **state)
{
    static struct block b[2];
    uint64_t seed = check_seed();
    double worst = 0;

    (void) state;
    for (int i = 0; i < 20 * PRESETS; i++) {
        const struct law law = preset_at(i), text = formulas_of(&law);
        const struct material m = some_material(&seed, &law);
        anchor_both(&law, &text, &m, &seed, b);
        const struct planar s = block_planar(&b[0]), t = block_planar(&b[1]);
        for (int n = 0; n < 10; n++) {
            const double r = laws_power(&seed, -12, 0.7);
            const double angle = check_uniform(&seed, 0, 6.3);
            const struct vec2 z = { r * cos(angle), r * sin(angle) };
            struct planar_jacobian J, K;
            s.jacobian(s.ctx, z, &J);
            t.jacobian(t.ctx, z, &K);
            const double same = exp(K.field.log_scale - J.field.log_scale);
            const double u[6] = { J.field.direction.x, J.field.direction.y,
                                  J.matrix.xx,         J.matrix.xy,
                                  J.matrix.yx,         J.matrix.yy };
            const double w[6] = { K.field.direction.x, K.field.direction.y,
                                  K.matrix.xx,         K.matrix.xy,
                                  K.matrix.yx,         K.matrix.yy };
            /* in a sum that nearly vanishes digits are those of its terms */
            for (int k = 0; k < 6; k++) {
                const double row =
                    k < 2 ? fabs(k ? z.x * u[4] + z.y * u[5]
                                   : z.x * u[2] + z.y * u[3]) +
                                fabs(u[k]) +
                                r * (fabs(u[2 + 2 * k]) + fabs(u[3 + 2 * k]))
                          : fabs(u[k]) + fabs(u[k - k % 2]) +
                                fabs(u[k - k % 2 + 1]);
                const double off = fabs(w[k] * same - u[k]) / (row + 1e-290);
                worst = off > worst ? off : worst;
                /* exponents of hundreds are rounded once */
                const double limit = 1e-13 + 4e-15 * fabs(J.field.log_scale);
                CHECK(off < limit, "%s %d at %g %g: %.17g, not %.17g",
                      law.preset, k, z.x, z.y, w[k] * same, u[k]);
            }
            CHECK(is_near(block_mu(&b[1], z), block_mu(&b[0], z), 1e-13L),
                  "%s: mu", law.preset);
        }
    }
    print_message("fields differ by %.2g at most\n", worst);
}

static void series_are_those_of_the_components(void **state)
{
    static struct block b[2];
    static struct jet_work w;
    static jet_pair x[JET_SIZE], y[JET_SIZE], f[2][2][JET_SIZE];
    uint64_t seed = check_seed();

    (void) state;
    for (int i = 0; i < 20 * PRESETS; i++) {
        const struct law law = preset_at(i), text = formulas_of(&law);
        const struct material m = some_material(&seed, &law);
        anchor_both(&law, &text, &m, &seed, b);
        memset(x, 0, sizeof x);
        memset(y, 0, sizeof y);
        for (int k = 0; k < 3; k++)
            for (int j = 0; j < JET_LANES; j++) {
                x[k][j] = check_uniform(&seed, -1, 1);
                y[k][j] = check_uniform(&seed, -1, 1);
            }
        jet_pair scale[2];
        for (int way = 0; way < 2; way++) {
            const struct planar s = block_planar(&b[way]);
            w.linear = NULL;
            w.used = 0;
            for (size_t k = 0; k < 12; k++)
                s.jet(s.ctx, &w, k, x, y, f[way][0], f[way][1]);
            scale[way] = w.log_scale;
        }
        for (size_t k = 0; k < 12; k++)
            for (int j = 0; j < JET_LANES; j++)
                for (int c = 0; c < 2; c++) {
                    const double same = exp(scale[1][j] - scale[0][j]);
                    const double u = f[0][c][k][j], v = f[1][c][k][j] * same;
                    double most = 0;
                    for (size_t q = 0; q <= k; q++)
                        most = fmax(most, fabs(f[0][c][q][j]));
                    CHECK(fabs(u - v) <= 1e-11 * most, "%s %zu: %g, not %g",
                          law.preset, k, v, u);
                }
    }
}

static long double less(long double v, int i)
{
    return i == 0   ? expm1l(v)
           : i == 1 ? log1pl(v)
           : i == 2 ? 2 * v / (sqrtl(1 + 2 * v) + 1)
                    : 2 * v * v / ((v + 1) * (v + 1) + 1 - v * v);
}

/* Of 1 beside v: some in all digits, and where the block slides as far off as
 * the bar says. */
static void formulas_that_cancel_keep_their_digits(void **state)
{
    static const char *const text[] = { "1/(exp(v) - 1)", "1/ln(1 + v)",
                                        "1/(sqrt(1 + 2*v) - 1)",
                                        "((v + 1)^2 + 1 - v^2)/(2*v^2)" };
    uint64_t seed = check_seed() + 5;

    (void) state;
    for (int i = 0; i < 400; i++) {
        enum law_part wrong;
        struct fault why = { "" };
        struct steady_root root[EQUILIBRIA_MAX];
        struct block b;
        struct material m = material_bristol_board();
        law_typed_of_preset(law_preset_find("dieterich"), &typed);
        strcpy(typed.text[LAW_PSI_SS], text[i % 4]);
        assert_int_equal(law_typed_make(&typed, &wrong, &why), STATUS_OK);
        const struct law law = law_of_typed(&typed);
        const long double x = check_uniform(&seed, i % 8 < 4 ? -30 : -40, -2);
        const long double psi = 1 / less(expl(x), i % 4);
        const long double found = steady_psi(&law, &m, x),
                          y = steady_y(&law, &m, x);
        CHECK(i % 8 > 3 || (is_near(found, psi, 0x1p-56L) &&
                            fabsl(y - logl(psi)) < 0x1p-56L * (1 + fabsl(y))),
              "%s at %Lg: %.20Lg, not %.20Lg", text[i % 4], x, found, psi);
        block_init(&b, &law, &m,
                   steady_mu(&law, &m, x) * (1 + 1e-6L * (i % 7)));
        if (equilibrium_find(&b.steady, &b, root) == 0)
            continue;
        block_anchor(&b, root[0].x, true);
        const long double v = expl(root[0].x), h = 1e-4L;
        const long double lost =
            b.tau - (m.mu_star + m.a * root[0].x - m.b * logl(less(v, i % 4)));
        const long double slope = (steady_mu_log(&law, &m, root[0].x + h) -
                                   steady_mu_log(&law, &m, root[0].x - h)) /
                                  (2 * h);
        CHECK(fabsl(lost / slope) < 1.1L * b.bar,
              "%s at %Lg: off by %Lg, not %g", text[i % 4], root[0].x,
              fabsl(lost / slope), b.bar);
    }
}

/* psi_ss = 1/v + 1/50 from an anchor at a v where it is 1e13 and 1e43: both
 * terms of d are as large there, and d itself is a few where the block slides.
 */
static void far_from_the_saddle_the_state_is_the_formulas_own(void **state)
{
    static const char *const kinetics[] = { "d", "sinh(d)", "d + d^3",
                                            "rate -v*(psi - 1/v - 1/50)",
                                            "1 - exp(-d)" };
    const struct material m = material_bristol_board();
    uint64_t seed = check_seed() + 6;

    (void) state;
    for (int i = 0; i < 150; i++) {
        enum law_part wrong;
        struct fault why = { "" };
        struct block b;
        law_typed_of_preset(law_preset_find("dieterich"), &typed);
        const int k = i % 5;
        strcpy(typed.text[LAW_PSI_SS], "1/v + 1/50");
        strcpy(typed.text[LAW_K], k != 3 ? kinetics[k] : "");
        if (k == 3) {
            typed.text[LAW_PSI_SS][0] = typed.text[LAW_T][0] = '\0';
            strcpy(typed.text[LAW_RATE], kinetics[k] + 5);
        }
        assert_int_equal(law_typed_make(&typed, &wrong, &why), STATUS_OK);
        const struct law law = law_of_typed(&typed);
        const double anchor = check_uniform(&seed, -100, -30);
        block_init(&b, &law, &m, steady_mu(&law, &m, anchor));
        block_anchor(&b, anchor, true);
        const double x = check_uniform(&seed, -1, 10);
        const double y = check_uniform(&seed, -5, 2);
        const struct planar s = block_planar(&b);
        struct planar_field f;
        s.field(s.ctx, block_offset(&b, exp(x), exp(y)), &f);
        const double psi = exp(y), ss = exp(-x) + 1.0 / 50, d = psi - ss;
        const double K[] = { d, sinh(d), d + d * d * d, d, -expm1(-d) };
        const double slope[] = { 1, cosh(d), 1 + 3 * d * d, 1, exp(-d) };
        const double exact = -K[k] * exp(x - y);
        const double found = f.direction.y * exp(f.log_scale);
        const double size = fabs(exact) + slope[k] * (psi + ss) * exp(x - y);
        CHECK(fabs(found - exact) <= 1e-12 * size,
              "K = %s, x %g, y %g from %g: %.17g, not %.17g", kinetics[k], x, y,
              anchor, found, exact);
    }
}

/* (ln v)^3 of v < 1, whose exponent is exact. */
static void whole_powers_of_what_is_negative_are_known(void **state)
{
    const struct material m = material_bristol_board();
    enum law_part wrong;
    struct fault why = { "" };

    (void) state;
    law_typed_of_preset(law_preset_find("dieterich"), &typed);
    strcpy(typed.text[LAW_MU], "mu_star + a*ln(v) + ln(v)^3/1024 + b*ln(psi)");
    assert_int_equal(law_typed_make(&typed, &wrong, &why), STATUS_OK);
    const struct law law = law_of_typed(&typed);
    for (int i = 1; i < 40; i++) {
        const long double x = -i / 4.0L, most = 1 + x * x * x / 1024;
        const long double exact =
            m.mu_star + ((long double) m.a - m.b) * x + x * x * x / 1024;
        const long double off = steady_mu_log_off(&law, &m, x);
        CHECK(fabsl(steady_mu_log(&law, &m, x) - exact) <= off + 0x1p-60L &&
                  off < 0x1p-54L * fabsl(most),
              "at %Lg: off by %Lg", x, off);
    }
}

/* A law of another whole exponent is made once and kept; others share one. */
static void exponents_that_are_whole_have_laws_of_their_own(void **state)
{
    enum law_part wrong;
    struct fault why = { "" };
    struct law_typed *t = calloc(1, sizeof *t);
    const double n[] = { 3, 2.5, 3, 2.25, -1, 2, 3.5, 1e9 };
    const struct law_typed *found[8];

    (void) state;
    assert_non_null(t);
    law_typed_of_preset(law_preset_find("dieterich"), t);
    strcpy(t->text[LAW_MU], "mu_star + a*ln(v) + q*ln(v)^n/1024 + b*ln(psi)");
    t->own[0] = (struct law_own){ "n", 2, false };
    t->own[1] = (struct law_own){ "q", 1, false };
    t->owns = 2;
    assert_int_equal(law_typed_make(t, &wrong, &why), STATUS_OK);
    assert_true(t->own[0].exponent && !t->own[1].exponent);
    for (size_t i = 0; i < sizeof n / sizeof *n; i++) {
        struct material m = material_bristol_board();
        m.own[0] = n[i];
        m.own[1] = 2;
        found[i] = law_typed_at(t, m.own);
        const struct law law = law_of_typed(found[i]);
        const long double mu = steady_mu_log(&law, &m, -3),
                          exact = m.mu_star - 3 * ((long double) m.a - m.b) +
                                  powl(-3, n[i]) / 512;
        CHECK(isfinite(exact) && n[i] < 1e4 ? is_near(mu, exact, 1e-15L)
                                            : !isfinite(mu),
              "n = %g: %Lg, not %Lg", n[i], mu, exact);
    }
    assert_true(found[0] == found[2] && found[5] == t);
    assert_true(found[1] == found[3] && found[1] == found[6]);
    assert_true(found[1] == found[7] && found[1] != found[0]);
    law_typed_free(t);
}

static void a_law_that_lacks_a_part_or_has_a_wrong_one_says_so(void **state)
{
    static const struct {
        enum law_part part;
        const char *text, *says;
        enum law_part wrong;
    } cases[] = {
        { LAW_PSI_SS, "", "psi_ss is missing", LAW_PARTS },
        { LAW_THETA, "", "theta is missing", LAW_PARTS },
        { LAW_T, "", "T is missing", LAW_PARTS },
        { LAW_RATE, "-d", "rate beside T", LAW_PARTS },
        { LAW_T, "1/w", "unknown name w", LAW_T },
        { LAW_PSI_SS, "1/psi", "expected a formula of v", LAW_PSI_SS },
        { LAW_K, "abs(d)", "not analytic", LAW_K },
        { LAW_THETA, "lambert(psi)", "cannot be used", LAW_PARTS },
    };
    const struct law *law = law_preset_find("spinodal_gen");

    (void) state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        enum law_part wrong;
        struct fault why = { "" };
        law_typed_of_preset(law, &typed);
        strcpy(typed.text[cases[i].part], cases[i].text);
        assert_int_equal(law_typed_make(&typed, &wrong, &why),
                         STATUS_BAD_SCENE);
        CHECK(strstr(why.text, cases[i].says) && wrong == cases[i].wrong,
              "%zu: %d %s", i, wrong, why.text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slopes_are_those_of_the_components),
        cmocka_unit_test(extrema_are_found_without_being_told),
        cmocka_unit_test(extrema_that_nearly_meet_are_found),
        cmocka_unit_test(an_extremum_beside_the_end_of_mu_ss_is_found),
        cmocka_unit_test(the_field_is_that_of_the_components),
        cmocka_unit_test(series_are_those_of_the_components),
        cmocka_unit_test(formulas_that_cancel_keep_their_digits),
        cmocka_unit_test(far_from_the_saddle_the_state_is_the_formulas_own),
        cmocka_unit_test(whole_powers_of_what_is_negative_are_known),
        cmocka_unit_test(exponents_that_are_whole_have_laws_of_their_own),
        cmocka_unit_test(a_law_that_lacks_a_part_or_has_a_wrong_one_says_so),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
