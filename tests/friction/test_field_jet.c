/* Taylor coefficients of the field and its observables against a second
 * implementation: the closed forms compiled once more for whole series of
 * 113-bit coefficients, with recurrences of their own. */
#include "block.h"

#include <math.h>
#include <string.h>

#include "setting.h"

#include "series_number.h"

#include "field_formula.h"

/* The rates of block.h's observables, times exp(-scale). */
static void series_rate(const struct law *law, const struct exact_anchor *at,
                        struct series_ctx *c, enum block_observable which,
                        quad scale, const quad *X, const quad *Y, quad *out)
{
    VAR(mu);
    VAR(v);

    series_exp(c, at->x0 + X[0] - scale, 1, X, v);
    switch (which) {
        case BLOCK_SLIP:
            memcpy(out, v, sizeof v);
            break;
        case BLOCK_EXCESS:
            series_expm1(c, expq(at->x0 - scale), at->x0 - scale, 1, X, out);
            break;
        default: /* BLOCK_WORK */
            series_mu(law, at, c, X, Y, mu);
            mu[0] += at->mu0;
            series_product(c, mu, v, out);
            break;
    }
}

/* A curve, the field along it in both kinds, and the rates. */
struct curve {
    double x[JET_SIZE], y[JET_SIZE];
    double f[2][JET_SIZE], rate[BLOCK_OBSERVABLES][JET_SIZE];
    double log_scale;
    bool straight;
    quad exact[2][N], exact_rate[BLOCK_OBSERVABLES][N], exact_scale;
};

static void exact_series(const struct setting *s, struct curve *c)
{
    struct series_ctx ctx = { 0 };
    quad X[N], Y[N];

    for (int k = 0; k < N; k++) {
        X[k] = c->x[k];
        Y[k] = c->y[k];
    }
    series_field(&s->law, &s->hand, &ctx, X, Y, c->exact[0], c->exact[1]);
    c->exact_scale = ctx.scale;
    for (int i = 0; i < BLOCK_OBSERVABLES; i++)
        series_rate(&s->law, &s->hand, &ctx, (enum block_observable) i,
                    ctx.scale, X, Y, c->exact_rate[i]);
}

/* Changes the parameter's unit, so that coefficients of the field neither grow
 * nor shrink; by powers of two, exactly. */
static void balance(struct curve *c)
{
    int unit = -1000;

    for (int i = 0; i < 2; i++) {
        const quad ref = fabsq(c->exact[i][0]) + fabsq(c->exact[i][1]) +
                         fabsq(c->exact[i][2]);
        for (int k = 8; k < N; k++) {
            const double size = (double) (fabsq(c->exact[i][k]) / ref);
            if (size > 0 && isfinite(size))
                unit = (int) fmax(unit, ceil(log2(size) / k));
        }
    }
    for (int k = 1; k < N && unit > -1000; k++) {
        c->x[k] = ldexp(c->x[k], -unit * k);
        c->y[k] = ldexp(c->y[k], -unit * k);
    }
}

/* The series of two curves, side by side. */
struct pairs {
    jet_pair x[JET_SIZE], y[JET_SIZE], f[2][JET_SIZE];
    jet_pair rate[BLOCK_OBSERVABLES][JET_SIZE];
    struct jet_work work;
};

static void pairs_put(struct pairs *p, size_t i, const struct curve *c)
{
    for (size_t k = 0; k < N; k++) {
        p->x[k][i] = c->x[k];
        p->y[k][i] = c->y[k];
    }
}

static void pairs_take(const struct pairs *p, size_t i, struct curve *c)
{
    for (int j = 0; j < 2; j++)
        jet_take(N - 1, p->f[j], i, c->f[j]);
    for (int j = 0; j < BLOCK_OBSERVABLES; j++)
        jet_take(N - 1, p->rate[j], i, c->rate[j]);
    c->log_scale = p->work.log_scale[i];
}

static void pairs_expand(struct pairs *p, const struct setting *s)
{
    for (size_t k = 0; k < N; k++) {
        tape_jet(&s->b.plane, &p->work, k, p->x, p->y, p->f[0], p->f[1]);
        for (size_t i = 0; i < BLOCK_OBSERVABLES; i++)
            tape_jet_rate(&s->b.plane, i, &p->work, k, p->x, p->y, p->rate[i]);
    }
}

/* Of two curves of one law; a may be b. */
static void double_series(const struct setting *s, struct curve *a,
                          struct curve *b)
{
    static struct pairs p;

    pairs_put(&p, 0, a);
    pairs_put(&p, 1, b);
    p.work.linear = a->straight && b->straight ? p.x : NULL;
    pairs_expand(&p, s);
    pairs_take(&p, 0, a);
    pairs_take(&p, 1, b);
}

/* A random polynomial curve through a point not far from the anchor; straight
 * in x if `straight`.  False where the law is too wild to compare: a state of
 * 300 makes exponents of 300. */
static bool draw_curve(const struct setting *s, bool straight, uint64_t *seed,
                       struct curve *c)
{
    const struct vec2 z = draw_near(-6, 0.7, seed);
    const double psi = law_psi_is_log(&s->law) ? fabs(s->b.at.y0 + z.y)
                                               : exp(s->b.at.y0 + z.y);
    const double psi_ss =
        fabs((double) steady_psi(&s->law, &s->m, s->x + (long double) z.x));

    if (!(psi < 300 && psi_ss < 300 && fabsq(s->hand.w0) < 1000))
        return false;
    *c = (struct curve){ .x = { z.x }, .y = { z.y } };
    for (int k = 1; k < N; k++) {
        c->x[k] = straight && k > 1 ? 0 : check_uniform(seed, -1, 1);
        c->y[k] = check_uniform(seed, -1, 1);
    }
    c->straight = straight;
    exact_series(s, c);
    balance(c);
    exact_series(s, c);
    return true;
}

/* Coefficient by coefficient, relative to the largest within four orders, or
 * to earlier ones less a factor four an order.  Under (45) with a sinh a
 * steep e^(2d) - 1 meets a steep exponential, which loses a factor up to three
 * an order where psi is close to psi_ss. */
static void check_series(const struct setting *s, const char *name,
                         const double *found, const quad *exact, quad shift,
                         quad floor)
{
    for (int k = 0; k < N; k++) {
        quad size = floor;
        for (int j = 0; j < N && j <= k + 4; j++) {
            const quad part = ldexp(1, j < k - 4 ? -2 * (k - j) : 0);
            size =
                fabsq(exact[j]) * part > size ? fabsq(exact[j]) * part : size;
        }
        const quad want = exact[k] * expq(shift);
        const double loss = law_freezes(&s->law) ? pow(3, k) : 1;
        CHECK(fabsq(found[k] - want) <=
                  fmax(1e-11 * (1 + k), 1e-14 * loss) * size * expq(shift) +
                      1e-300,
              "law %zu: %s[%d] = %.17g, not %.17g, size %g", s->number, name, k,
              found[k], (double) want, (double) size);
    }
}

static void coefficients_are_exact_to_order_24(void **state)
{
    static const char *const names[] = { "slip", "work", "excess" };
    uint64_t seed = check_seed();
    struct setting s;
    static struct curve c;
    size_t curves = 0;

    (void) state;
    for (size_t i = 0; i < LAWS * 2; i++) {
        if (!draw_setting(i, 6, &seed, &s) ||
            !draw_curve(&s, i / LAWS, &seed, &c))
            continue;
        curves++;
        double_series(&s, &c, &c);
        const quad shift = c.exact_scale - c.log_scale;
        /* mu is mu0 + (mu - mu0) */
        const quad mu0_v = fabsq(s.at.mu0 * c.exact_rate[BLOCK_SLIP][0]);
        check_series(&s, "fx", c.f[0], c.exact[0], shift, 0);
        check_series(&s, "fy", c.f[1], c.exact[1], shift, 0);
        for (int j = 0; j < BLOCK_OBSERVABLES; j++)
            check_series(&s, names[j], c.rate[j], c.exact_rate[j], shift,
                         j == BLOCK_WORK ? mu0_v : 0);
    }
    CHECK(curves > LAWS / 2, "only %zu curves", curves);
}

static void the_series_sums_to_the_field_on_the_curve(void **state)
{
    uint64_t seed = check_seed() + 1;
    struct setting s;
    static struct curve c;

    (void) state;
    for (size_t i = 0; i < LAWS; i++) {
        if (!draw_setting(i, 6, &seed, &s) || !draw_curve(&s, false, &seed, &c))
            continue;
        double_series(&s, &c, &c);
        const double t = check_uniform(&seed, -0.1, 0.1);
        const struct vec2 z = { jet_at(ORDER, c.x, t), jet_at(ORDER, c.y, t) };
        struct planar_field f;
        tape_field(&s.b.plane, z, &f);
        const double factor = exp(f.log_scale - c.log_scale);
        const double direction[2] = { f.direction.x, f.direction.y };
        for (int j = 0; j < 2; j++) {
            double size = 0;
            for (int k = 0; k < N; k++)
                size += fabs(c.f[j][k]) * pow(fabs(t), k);
            const double want = direction[j] * factor;
            const double sum = jet_at(ORDER, c.f[j], t);
            CHECK(fabs(sum - want) <= 1e-11 * (size + fabs(want)),
                  "law %zu at s=%g: f%d = %.17g, not %.17g", s.number, t, j,
                  sum, want);
        }
    }
}

static void the_shortcut_for_a_straight_x_changes_nothing(void **state)
{
    uint64_t seed = check_seed() + 2;
    struct setting s;
    static struct curve c, plain;

    (void) state;
    for (size_t i = 0; i < LAWS; i++) {
        if (!draw_setting(i, 6, &seed, &s) || !draw_curve(&s, true, &seed, &c))
            continue;
        plain = c;
        plain.straight = false;
        double_series(&s, &c, &c);
        double_series(&s, &plain, &plain);
        for (int j = 0; j < 2; j++)
            for (int k = 0; k < N; k++)
                CHECK(fabs(c.f[j][k] - plain.f[j][k]) <=
                          1e-13 * (double) k *
                              (fabs(c.f[j][k]) + (double) fabsq(c.exact[j][0]) +
                               (double) fabsq(c.exact[j][1]) + 1e-30),
                      "law %zu: f%d[%d] = %.17g and %.17g", s.number, j, k,
                      c.f[j][k], plain.f[j][k]);
    }
}

static void a_second_call_replaces_the_first(void **state)
{
    uint64_t seed = check_seed() + 3;
    struct setting s;
    static struct curve c;
    static struct pairs p, twice;

    (void) state;
    for (size_t i = 0; i < LAWS; i++) {
        if (!draw_setting(i, 6, &seed, &s) || !draw_curve(&s, false, &seed, &c))
            continue;
        pairs_put(&p, 0, &c);
        pairs_put(&p, 1, &c);
        twice = p;
        pairs_expand(&p, &s);
        for (size_t k = 0; k < N; k++) {
            twice.y[k] = 0.5 * p.y[k] + 0.25; /* a guess, then the value */
            tape_jet(&s.b.plane, &twice.work, k, twice.x, twice.y, twice.f[0],
                     twice.f[1]);
            twice.y[k] = p.y[k];
            tape_jet(&s.b.plane, &twice.work, k, twice.x, twice.y, twice.f[0],
                     twice.f[1]);
            for (int j = 0; j < JET_LANES; j++)
                assert_true(twice.f[0][k][j] == p.f[0][k][j] &&
                            twice.f[1][k][j] == p.f[1][k][j]);
        }
        assert_true(twice.work.log_scale[0] == p.work.log_scale[0]);
        assert_true(p.work.used <= JET_SLOTS);
    }
}

static bool same(const struct curve *a, const struct curve *b)
{
    return a->log_scale == b->log_scale &&
           memcmp(a->f, b->f, sizeof a->f) == 0 &&
           memcmp(a->rate, b->rate, sizeof a->rate) == 0;
}

static void two_curves_side_by_side_do_not_touch(void **state)
{
    uint64_t seed = check_seed() + 4;
    struct setting s;
    static struct curve c, d, alone_c, alone_d;
    size_t pairs = 0;

    (void) state;
    for (size_t i = 0; i < LAWS; i++) {
        if (!draw_setting(i, 6, &seed, &s) ||
            !draw_curve(&s, false, &seed, &c) ||
            !draw_curve(&s, i % 2, &seed, &d))
            continue;
        alone_c = c;
        alone_d = d;
        double_series(&s, &c, &d);
        double_series(&s, &alone_c, &alone_c);
        alone_d.straight = false;
        double_series(&s, &alone_d, &alone_d);
        CHECK(same(&c, &alone_c) && same(&d, &alone_d),
              "law %zu: a curve feels its neighbour", s.number);
        pairs++;
    }
    CHECK(pairs > LAWS / 4, "only %zu pairs", pairs);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(coefficients_are_exact_to_order_24),
        cmocka_unit_test(the_series_sums_to_the_field_on_the_curve),
        cmocka_unit_test(the_shortcut_for_a_straight_x_changes_nothing),
        cmocka_unit_test(a_second_call_replaces_the_first),
        cmocka_unit_test(two_curves_side_by_side_do_not_touch),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
