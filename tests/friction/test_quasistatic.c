/* The block without inertia: where friction balances the slope, and how fast
 * psi grows there. */
#include "quasistatic.h"

#include <math.h>

#include "check.h"
#include "laws.h"
#include "rest_form.h"

/* A law by which blocks rest, on a slope that has a steady state; false where
 * there is none. */
static bool draw(size_t i, uint64_t *rng, struct block *b)
{
    struct law law;
    struct material m;

    if (!laws_draw(i, rng, &law, &m))
        return false;
    const struct rest_form form = rest_form_of(&law, &m);
    const long double x = (long double) check_uniform(rng, -8.0, 4.0);
    if (form.fate == FATE_CREEP || form.inertial || x >= steady_x_max(&law))
        return false;
    const double mu = (double) steady_mu(&law, &m, x);
    if (!(mu > 0.05 && mu < 2.0))
        return false;
    block_init(b, &law, &m, (long double) mu);
    block_anchor(b, x, true);
    return true;
}

static void it_is_where_friction_balances_the_slope(void **state)
{
    uint64_t rng = check_seed();
    int tried = 0;

    (void) state;
    for (size_t i = 0; i < 8 * LAWS; i++) {
        struct block b;
        if (!draw(i % LAWS, &rng, &b))
            continue;
        const double Y = check_uniform(&rng, 0.01, 60.0), h = 1e-3;
        double slope, s;
        const double X = quasistatic_x(&b, Y, &slope);
        const double t = (double) b.tan_alpha;
        const double scale = 1e-15 * (fabs(X) + Y) * (b.at.a + b.at.b) + 1e-14;
        CHECK(fabs(block_mu(&b, (struct vec2){ X, Y }) - t) < scale,
              "law %zu, Y %g: %g, not %g", i, Y,
              block_mu(&b, (struct vec2){ X, Y }), t);
        const double rise =
            (quasistatic_x(&b, Y + h, &s) - quasistatic_x(&b, Y - h, &s)) /
            (2.0 * h);
        CHECK(fabs(rise - slope) < 1e-5 * fabs(slope) + 1e-9, "%g, not %g",
              slope, rise);
        const double excess = pow(10.0, check_uniform(&rng, -10.0, 0.0));
        const double up = quasistatic_above(&b, X, Y, excess);
        const double mu = block_mu(&b, (struct vec2){ X + up, Y });
        CHECK(fabs(mu - t - excess) < scale + 1e-13 * excess, "%g, not %g",
              mu - t, excess);
        tried++;
    }
    CHECK(tried > 100, "%d", tried);
}

static void psi_grows_as_the_field_says(void **state)
{
    uint64_t rng = check_seed();
    int tried = 0;

    (void) state;
    for (size_t i = 0; i < 8 * LAWS; i++) {
        struct block b;
        if (!draw(i % LAWS, &rng, &b))
            continue;
        const struct planar p = block_planar(&b);
        const double Y = check_uniform(&rng, 0.5, 40.0);
        double slope;
        const double X = quasistatic_x(&b, Y, &slope);
        struct planar_field f;
        p.field(p.ctx, (struct vec2){ X, Y }, &f);
        const double rate = quasistatic_log_rate(&b, X, Y);
        const double found = log(f.direction.y) + f.log_scale;
        if (!(f.direction.y > 1e-300) || !isfinite(found))
            continue; /* next to what inertia does, nothing */
        CHECK(fabs(rate - found) < 1e-12 * (1.0 + fabs(found) + fabs(X) + Y),
              "law %zu, (%g, %g): %.16g, not %.16g", i, X, Y, rate, found);
        tried++;
    }
    CHECK(tried > 100, "%d", tried);
}

/* dieterich: psi grows by 1 - v psi, v psi = e^(-u), at psi = e^1e5, too. */
static void it_has_no_end(void **state)
{
    struct material m = material_bristol_board();
    struct block b;
    double slope;

    (void) state;
    block_init(&b, law_preset_find("dieterich"), &m, 0.34L);
    block_anchor(&b, 2.0L, false);
    const double X = quasistatic_x(&b, 1e5, &slope);
    assert_true(fabs(slope + m.b / m.a) < 1e-15 * m.b / m.a);
    CHECK(fabs(quasistatic_log_rate(&b, X, 1e5) + 1e5 + b.at.y0) < 1e-10,
          "%.16g", quasistatic_log_rate(&b, X, 1e5));
    assert_true(isnan(quasistatic_log_rate(&b, 1.0, 1.0)));
}

/* kato_tullis: psi grows by exp(-v/V_c)/(v psi) - ln(v psi), whatever v0/V_c,
 * which is 5e7 here. */
static void a_saddle_far_above_the_cutoff_takes_no_digits(void **state)
{
    struct material m = material_bristol_board();
    struct block b;
    double slope;

    (void) state;
    m.a = 0.005;
    m.b = 0.0104;
    m.V_c = 2.96778;
    block_init(&b, law_preset_find("kato_tullis"), &m, 0.2672L);
    block_anchor(&b, 18.889497341434065L, false);
    for (int i = 0; i < 200; i++) {
        const double Y = 0.1 + 0.2 * i, X = quasistatic_x(&b, Y, &slope);
        const long double x = (long double) b.at.x0 + X;
        const long double z = x + b.at.y0 + Y;
        const long double v = expl(x), E = expl(-v / (long double) m.V_c - z);
        const double truth = (double) (x + logl(E - z));
        const double rate = quasistatic_log_rate(&b, X, Y);
        CHECK(fabs(rate - truth) < 1e-13, "Y %g: %.16g, not %.16g", Y, rate,
              truth);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_is_where_friction_balances_the_slope),
        cmocka_unit_test(psi_grows_as_the_field_says),
        cmocka_unit_test(it_has_no_end),
        cmocka_unit_test(a_saddle_far_above_the_cutoff_takes_no_digits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
