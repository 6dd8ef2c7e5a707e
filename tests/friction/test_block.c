#include "block.h"

#include <math.h>
#include <string.h>

#include "plain.h"
#include "setting.h"

enum { ORDER = 20 };

/* Relative to b. */
static bool near(double a, double b, double off)
{
    return fabs(a - b) <= off * fabs(b) + 1e-300;
}

static void the_system_is_the_field_around_the_anchor(void **state)
{
    uint64_t seed = check_seed();
    struct setting s;

    (void) state;
    for (size_t i = 0; i < LAWS; i++) {
        if (!draw_setting(i, 10, &seed, &s))
            continue;
        const struct planar p = block_planar(&s.b);
        const struct vec2 z = draw_near(-2, 0, &seed);
        struct planar_field f, g;
        struct planar_jacobian J;
        struct jet_work w = { 0 };
        const jet_pair x = JET_PAIR(z.x), y = JET_PAIR(z.y);
        jet_pair fx, fy, rate;
        double r;
        struct vec2 gradient;

        assert_true(p.origin.x == s.b.at.x0 && p.origin.y == s.b.at.y0);
        p.field(p.ctx, z, &f);
        p.jacobian(p.ctx, z, &J);
        tape_field(&s.b.plane, z, &g);
        assert_memory_equal(&f, &g, sizeof f);
        assert_memory_equal(&J.field, &g, sizeof g);
        p.jet(p.ctx, &w, 0, &x, &y, &fx, &fy);
        for (int l = 0; l < JET_LANES; l++) {
            const double lent = exp(w.log_scale[l] - f.log_scale);
            const double off = 1e-15 * (2 + fabs(f.log_scale));
            CHECK(near(fx[l] * lent, f.direction.x, off) &&
                      near(fy[l] * lent, f.direction.y, off),
                  "law %zu: %g %g", s.number, fx[l] * lent, fy[l] * lent);
        }
        for (size_t j = 0; j < p.observable_count; j++) {
            p.rate_gradient(p.ctx, j, z, &r, &gradient);
            const double both = r;
            p.rate_gradient(p.ctx, j, z, &r, NULL);
            assert_true(r == both);
            p.rate_jet(p.ctx, j, &w, 0, &x, &y, &rate);
            const double want = r * exp(-w.log_scale[0]);
            CHECK(fabs(rate[0] - want) <=
                      1e-15 * fabs(want) * (2 + fabs(w.log_scale[0])) + 1e-300,
                  "law %zu: %s %g %g", s.number, p.observables[j].name, rate[0],
                  want);
        }
    }
}

static void axes_and_observables_say_what_they_are(void **state)
{
    const struct material m = material_bristol_board();
    struct block b;

    (void) state;
    block_init(&b, law_preset_find("spinodal"), &m, 0.35L);
    block_anchor(&b, 1.0L, false);
    const struct planar p = block_planar(&b);
    assert_string_equal(p.name, "spinodal");
    assert_string_equal(p.axis[0].name, "v");
    assert_string_equal(p.axis[1].name, "psi");
    assert_true(p.axis[0].is_log && p.axis[1].is_log);
    assert_true(p.domain.hi.x == LN_RANGE && p.domain.lo.y == -LN_RANGE);
    assert_int_equal(p.observable_count, BLOCK_OBSERVABLES);
    assert_string_equal(p.observables[BLOCK_SLIP].name, "slip");
    assert_string_equal(p.observables[BLOCK_WORK].name, "work");
    assert_string_equal(p.observables[BLOCK_EXCESS].name, "excess");

    block_init(&b, law_preset_find("perrin"), &m, 0.35L);
    block_anchor(&b, 1.0L, false);
    const struct planar q = block_planar(&b);
    assert_false(q.axis[1].is_log);
    assert_true(q.domain.lo.y == -TOL_RANGE);
    assert_true(q.domain.hi.y == TOL_PSI_ROOM); /* y0 = -1 */
}

/* The balance changes sign only at the steady states the bisection between
 * its turning points finds, and the field is zero there. */
static void equilibria_are_roots_of_the_balance(void **state)
{
    uint64_t seed = check_seed() + 1;
    struct setting s;
    size_t found = 0;

    (void) state;
    for (size_t i = 0; i < LAWS * 4; i++) {
        if (!draw_setting(i, 10, &seed, &s))
            continue;
        const struct planar_steady *c = &s.b.steady;
        for (size_t k = 0; k <= c->turnings; k++) {
            long double lo = k == 0 ? -40 : c->turning[k - 1];
            long double hi = k < c->turnings ? c->turning[k]
                             : c->hi < 40    ? c->hi - 1e-9L
                                             : 40;
            const bool rises = c->balance(&s.b, lo) < 0;
            if (rises == (c->balance(&s.b, hi) < 0))
                continue;
            for (int n = 0; n < 100; n++) {
                const long double mid = (lo + hi) / 2;
                if ((c->balance(&s.b, mid) < 0) == rises)
                    lo = mid;
                else
                    hi = mid;
            }
            block_anchor(&s.b, lo, true);
            struct planar_field f;
            tape_field(&s.b.plane, (struct vec2){ 0, 0 }, &f);
            assert_true(f.direction.x == 0 && f.direction.y == 0);
            /* w = mu_log/a is known to the digits of its terms, mu_log/a */
            const quad mu = plain_mu_ss(&s.law, &s.m, lo);
            const quad terms = 1 + fabsq(s.tan_alpha) +
                               s.m.b * fabsq(s.b.at.psi0) +
                               (s.m.a + s.m.b) * (1 + fabsq(lo));
            CHECK(fabsq(mu - s.tan_alpha) <= 64 * laws_long_epsilon() * terms,
                  "law %zu at x = %Lg: mu_ss - tan(alpha) = %g", s.number, lo,
                  (double) (mu - s.tan_alpha));
            assert_true(fabsl(c->y(&s.b, lo) - (long double) s.b.at.y0) <=
                        (1.2e-16L + laws_long_epsilon()) *
                            fabsl(c->y(&s.b, lo)));
            found++;
        }
    }
    CHECK(found > LAWS / 2, "only %zu equilibria", found);
}

static void block_mu_is_the_friction_coefficient(void **state)
{
    uint64_t seed = check_seed() + 2;
    struct setting s;

    (void) state;
    for (size_t i = 0; i < LAWS * 8; i++) {
        if (!draw_setting(i, 10, &seed, &s))
            continue;
        const struct vec2 z = draw_near(-15, 1.3, &seed);
        const quad y = s.at.y0 + z.y,
                   psi = law_psi_is_log(&s.law) ? y : expq(y);
        const quad mu = plain_mu(&s.law, &s.m, s.at.x0 + z.x, psi);
        /* differences from the anchor: to the digits of mu0 and of the change
         * of a ln v + b theta, whose psi is y0's e-fold */
        const quad terms = fabsq(s.at.mu0) + fabsq(mu) +
                           s.m.a * (1 + fabsq(z.x)) +
                           s.m.b * (1 + fabsq(z.y) + fabsq(s.at.y0));
        CHECK(fabsq(block_mu(&s.b, z) - mu) <= 16 * 0x1p-53 * terms,
              "law %zu: mu = %.17g, not %.17g", s.number, block_mu(&s.b, z),
              (double) mu);
    }
}

static void steady_sliding_balances_its_energy(void **state)
{
    const struct material m = material_bristol_board();
    const double tangent = 0.35, v = 12.5, slip = 80.0;
    struct block b;

    (void) state;
    block_init(&b, law_preset_find("dieterich"), &m, (long double) tangent);
    assert_true(fabs(block_energy_defect(&b, v, v, slip, tangent * slip)) <
                1e-15);
    assert_true(block_energy_defect(&b, v, v, 0.0, 0.0) == 0.0);
    /* a hundredth too much work is a hundredth of the largest term */
    assert_true(
        fabs(block_energy_defect(&b, v, v, slip, 1.01 * tangent * slip) -
             0.01 / 1.01) < 1e-14);
}

/* Frictionless on the slope: eps^2 (v1^2 - v0^2)/2 = sin(alpha) slip. */
static void free_sliding_turns_height_into_speed(void **state)
{
    const struct material m = material_bristol_board();
    const double tangent = 0.75, v0 = 3.0, v1 = 5000.0; /* sin = 0.6 */
    const double slip = material_eps2(&m) * (v1 * v1 - v0 * v0) / (2 * 0.6);
    struct block b;

    (void) state;
    block_init(&b, law_preset_find("dieterich"), &m, (long double) tangent);
    assert_true(fabs(block_energy_defect(&b, v0, v1, slip, 0.0)) < 1e-15);
    assert_true(fabs(block_energy_defect(&b, v0, v1, 1.5 * slip, 0.0) +
                     0.5 / 1.5) < 1e-14);
}

/* One Taylor step of the orbit in the time of the field's own scale. */
static void orbit_step(const struct setting *s, struct vec2 *z,
                       double integral[BLOCK_OBSERVABLES])
{
    static jet_pair x[JET_SIZE], y[JET_SIZE], fx[JET_SIZE], fy[JET_SIZE];
    static jet_pair rate[BLOCK_OBSERVABLES][JET_SIZE];
    static struct jet_work w;
    double end[2][JET_SIZE];

    x[0] = JET_PAIR(z->x);
    y[0] = JET_PAIR(z->y);
    for (size_t k = 0; k < ORDER; k++) {
        tape_jet(&s->b.plane, &w, k, x, y, fx, fy);
        x[k + 1] = fx[k] / (double) (k + 1);
        y[k + 1] = fy[k] / (double) (k + 1);
        for (int i = 0; i < BLOCK_OBSERVABLES; i++)
            tape_jet_rate(&s->b.plane, (size_t) i, &w, k, x, y, rate[i]);
    }
    double h = 0.1;
    for (int k = ORDER - 1; k <= ORDER; k++)
        h = fmin(h,
                 0.5 * pow(1e-16 / (fabs(x[k][0]) + fabs(y[k][1])), 1.0 / k));
    for (int i = 0; i < BLOCK_OBSERVABLES; i++) {
        double power = h;
        for (int k = 0; k < ORDER; k++, power *= h)
            integral[i] += rate[i][k][0] * power / (k + 1);
    }
    jet_take(ORDER, x, 0, end[0]);
    jet_take(ORDER, y, 1, end[1]);
    *z = (struct vec2){ jet_at(ORDER, end[0], h), jet_at(ORDER, end[1], h) };
}

static void every_orbit_keeps_its_energy(void **state)
{
    uint64_t seed = check_seed() + 3;

    (void) state;
    for (size_t i = 0; law_preset_at(i); i++)
        for (int form = 0; form < FRICTION_FORMS; form++) {
            struct setting s = { .number = i,
                                 .law = *law_preset_at(i),
                                 .m = material_bristol_board() };
            s.law.form = (enum friction_form) form;
            assert_true(set_anchor(&s, check_uniform(&seed, -3, 3), 0, true));
            struct vec2 z = draw_near(-1, -0.5, &seed);
            double integral[BLOCK_OBSERVABLES] = { 0 };
            const double v0 = exp(s.b.at.x0 + z.x);
            for (int k = 0; k < 60; k++)
                orbit_step(&s, &z, integral);
            const double v1 = exp(s.b.at.x0 + z.x);
            const double defect = block_energy_defect(
                &s.b, v0, v1, integral[BLOCK_SLIP], integral[BLOCK_WORK]);
            const double none =
                block_energy_defect(&s.b, v0, v1, integral[BLOCK_SLIP],
                                    0.999 * integral[BLOCK_WORK]);
            CHECK(fabs(defect) < 1e-12, "%s: defect %g, v %g to %g",
                  s.law.preset, defect, v0, v1);
            CHECK(fabs(none) > 1e-5, "%s: blind to a thousandth of the work",
                  s.law.preset);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_system_is_the_field_around_the_anchor),
        cmocka_unit_test(axes_and_observables_say_what_they_are),
        cmocka_unit_test(equilibria_are_roots_of_the_balance),
        cmocka_unit_test(block_mu_is_the_friction_coefficient),
        cmocka_unit_test(steady_sliding_balances_its_energy),
        cmocka_unit_test(free_sliding_turns_height_into_speed),
        cmocka_unit_test(every_orbit_keeps_its_energy),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
