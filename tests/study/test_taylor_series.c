/* The manifold's power series in v against the recursion that the equations
 * (17) themselves give for its coefficients, in 113 bits. */
#include "taylor_series.h"

#include <math.h>
#include <string.h>

#include "asked.h"
#include "quad.h"
#include "random_slope.h"
#include "study_tolerance.h"

enum { MANY = 200 };

static void ask_series(struct asked *a, const char *law, const char *alpha)
{
    a->sets = 0;
    ask(a, "law.preset", law);
    ask(a, "law.friction", "log");
    ask(a, "slope.alpha", alpha);
    ask(a, "products", "[taylor_series]");
    asked_run(a);
}

/* The log form of dieterich_gen with S = psi/psi_sp, w = (v - v_sp)/v_sp:
 *     psi_sp S' F = v_sp G,  F = -cos(alpha) (a ln(1 + w) + b ln S)/eps^2,
 *     G = -v sinh(psi_sp (S - 1/(1 + w))). */
struct recursion {
    quad v, psi, F_a, F_b; /* F = F_a ln(1 + w) + F_b ln S */
    quad S[MANY], log_S[MANY], sinh_u[MANY], cosh_u[MANY], u[MANY];
};

static quad sign(int k)
{
    return k % 2 ? -1 : 1;
}

/* The helper series at k, of S up to k. */
static void follow(struct recursion *r, int k)
{
    quad sum = 0;

    for (int j = 1; j < k; j++)
        sum += j * r->log_S[j] * r->S[k - j];
    r->log_S[k] = r->S[k] - sum / k;
    r->u[k] = r->psi * (r->S[k] - sign(k));
    r->sinh_u[k] = r->cosh_u[k] = 0;
    for (int j = 1; j <= k; j++) {
        r->sinh_u[k] += j * r->u[j] * r->cosh_u[k - j] / k;
        r->cosh_u[k] += j * r->u[j] * r->sinh_u[k - j] / k;
    }
}

/* Coefficient k of psi_sp S' F - v_sp G; linear in S_k. */
static quad defect(struct recursion *r, int k, quad S_k)
{
    quad sum = r->v * r->v * r->sinh_u[k - 1];

    r->S[k] = S_k;
    follow(r, k);
    sum += r->v * r->v * r->sinh_u[k];
    for (int j = 0; j < k; j++)
        sum += r->psi * (j + 1) * r->S[j + 1] *
               (r->F_b * r->log_S[k - j] - r->F_a * sign(k - j) / (k - j));
    return sum;
}

static void recur(struct recursion *r, const struct study *s)
{
    const struct material *m = &s->slider.block.material;
    const quad cosine = cosl((long double) s->scene->alpha);
    const quad scale = -cosine * m->L * m->g / ((quad) m->V_star * m->V_star);

    memset(r, 0, sizeof *r);
    r->v = expq((m->mu_star - (quad) s->slider.block.tan_alpha) /
                ((quad) m->b - m->a));
    r->psi = 1 / r->v;
    r->F_a = scale * m->a;
    r->F_b = scale * m->b;
    r->S[0] = r->cosh_u[0] = 1;
    /* psi F_b S_1^2 + (psi F_a + v^2 psi) S_1 + v^2 psi = 0: F_b < 0, and the
     * stable direction is the rising one */
    const quad half = (r->F_a + r->v * r->v) / 2;
    const quad root = sqrtq(half * half - r->F_b * r->v * r->v);
    r->S[1] = half > 0 ? -(half + root) / r->F_b : r->v * r->v / (root - half);
    follow(r, 1);
    for (int k = 2; k < MANY; k++) {
        const quad by_S_k =
            k * (r->F_a + r->F_b * r->S[1]) + r->F_b * r->S[1] + r->v * r->v;
        r->S[k] = -defect(r, k, 0) / (r->psi * by_S_k);
        follow(r, k);
    }
}

static const char *const slopes[] = { "0.25", "0.28", "0.3",
                                      "0.34", "0.36", "0.38" };
enum { SLOPES = sizeof slopes / sizeof *slopes };

static void coefficients_are_those_of_the_equations(void **state)
{
    static struct recursion r;

    (void) state;
    for (int i = 0; i < SLOPES; i++) {
        static struct asked a;
        ask_series(&a, "dieterich_gen", slopes[i]);
        const struct taylor_series *t = &a.study.taylor;
        recur(&r, &a.study);
        assert_int_equal(t->terms, JET_SIZE);
        for (int k = 1; k < JET_SIZE; k++) { /* psi_sp: see test_steady.c */
            const struct quantity *c = &t->term[k].coefficient;
            const double want = (double) (r.S[k] * r.psi);
            assert_int_equal(t->term[k].order, k);
            CHECK(fabs(c->value - want) <= c->error,
                  "alpha %s, k = %d: %.17g +- %.1e, not %.17g", slopes[i], k,
                  c->value, c->error, want);
        }
        asked_free(&a);
    }
}

/* Two hundred ratios, and no circle reaches the end of the curve. */
static void the_radius_is_within_its_bar(void **state)
{
    static struct recursion r;

    (void) state;
    for (int i = 1; i < SLOPES; i++) {
        static struct asked a;
        ask_series(&a, "dieterich_gen", slopes[i]);
        const struct quantity *R = &a.study.taylor.radius;
        recur(&r, &a.study);
        const double more =
            (double) (r.v * fabsq(r.S[MANY - 2] / r.S[MANY - 1]));
        const double end = (double) r.v - a.study.slider.critical.v_minus.value;
        CHECK(fabs(R->value - more) <= R->error + 0.002 * more,
              "alpha %s: %.6g +- %.1e, with 200 terms %.6g", slopes[i],
              R->value, R->error, more);
        CHECK(R->value <= end * (1.0 + 1e-12) &&
                  R->value + R->error > 0.999999 * end &&
                  R->error < 0.3 * R->value,
              "alpha %s: %.6g +- %.1e, curve ends at %.6g", slopes[i], R->value,
              R->error, end);
        asked_free(&a);
    }
}

/* Points of the branch, half a radius around the saddle. */
static void check_near(const struct asked *a, const struct curve *c)
{
    const struct block *b = &a->study.slider.block;
    const bool is_log = law_psi_is_log(&b->law);
    double at[CURVE_DIM_MAX];
    size_t near = 0;

    for (size_t i = 0; i < 32 * c->count; i++) {
        curve_at(c, i / 32, (double) (i % 32) / 32.0, at);
        const double v = b->at.v0 * exp(at[0]);
        if (fabs(v - b->at.v0) > 0.4 * a->study.taylor.radius.value)
            continue;
        const double psi = is_log ? b->at.y0 + at[1] : b->at.psi0 * exp(at[1]);
        const double sum =
            taylor_series_at(&a->study.taylor, JET_SIZE - 1, v, b->at.v0);
        CHECK(fabs(sum - psi) < 1e-9 * (is_log ? 1.0 : psi),
              "%s: v = %.9g: sum %.15g, curve %.15g", b->law.preset, v, sum,
              psi);
        near++;
    }
    assert_true(near > 0);
}

static void near_the_saddle_the_sum_is_the_curve(void **state)
{
    static const char *const laws[] = { "dieterich", "dieterich_gen",
                                        "spinodal",  "spinodal_gen",
                                        "ruina",     "perrin" };

    (void) state;
    for (size_t i = 0; i < sizeof laws / sizeof *laws; i++) {
        static struct asked a;
        ask_series(&a, laws[i], "0.34");
        for (int side = 0; side < SIDES; side++)
            check_near(&a, &a.study.stable[side].curve);
        asked_free(&a);
    }
}

/* The paper's finding: a small neighbourhood, far from both knees. */
static void order_14_leaves_the_curve_before_the_upper_knee(void **state)
{
    static struct asked a;

    (void) state;
    ask_series(&a, "dieterich_gen", "0.34");
    const struct taylor_series *t = &a.study.taylor;
    const double v_sp = a.study.slider.block.at.v0;
    CHECK(t->agrees_from.value < v_sp && v_sp < t->agrees_to.value &&
              t->agrees_to.value < 4.0 * v_sp &&
              t->agrees_to.value < 0.01 * a.study.slider.critical.v_plus.value,
          "from %.6g to %.6g around %.6g", t->agrees_from.value,
          t->agrees_to.value, v_sp);
    asked_free(&a);
}

static void is_held(const struct slope *s, const struct quantity *q,
                    const struct quantity *tight)
{
    CHECK(quantity_exists(q) || !quantity_exists(tight) ||
              strstr(q->reason, "not told") != NULL,
          "alpha %.17g, rtol %g: %s, not %.17g", s->scene.alpha, s->scene.rtol,
          q->reason, tight->value);
    if (quantity_exists(q) && quantity_exists(tight))
        CHECK(fabs(q->value - tight->value) <= q->error + tight->error,
              "alpha %.17g, rtol %g: %.17g +- %.2g, not %.17g", s->scene.alpha,
              s->scene.rtol, q->value, q->error, tight->value);
}

static void places_of_a_loose_curve_are_those_of_a_tight_one(void **state)
{
    const char *const more[] = { "products=[taylor_series]", NULL };
    uint64_t rng = check_seed();

    (void) state;
    for (size_t i = 0; i < 40; i++) {
        static struct slope s;
        struct fault why;
        random_slope_of(&s, i % random_presets(), &rng, more);
        const struct taylor_series tight = s.study.taylor;
        study_free(&s.study);
        s.scene.rtol = random_power(&rng, -9, -3);
        const enum status status = study_run(&s.study, &s.scene, NULL, &why);
        CHECK(status == STATUS_OK, "%s", why.text);
        is_held(&s, &s.study.taylor.agrees_from, &tight.agrees_from);
        is_held(&s, &s.study.taylor.agrees_to, &tight.agrees_to);
        slope_free(&s);
    }
}

/* v moves by 3 % from the saddle to where psi has no limit, most of it in the
 * tails: a loose curve is grown to where order 14 still agrees. */
static void order_14_leaves_a_curve_that_has_no_end(void **state)
{
    static const char *const rtols[] = { "1e-13", "1e-10", "1e-8", "1e-4" };
    struct quantity from[sizeof rtols / sizeof *rtols];

    (void) state;
    for (size_t i = 0; i < sizeof rtols / sizeof *rtols; i++) {
        static struct asked a;
        a.sets = 0;
        ask(&a, "law.preset", "dieterich_gen");
        ask(&a, "law.friction", "log");
        ask(&a, "slope.alpha", "0.40977156611943044");
        ask(&a, "material.a", "0.04");
        ask(&a, "material.L", "1.76013192e-05");
        ask(&a, "material.V_star", "2.015541296e-08");
        ask(&a, "products", "[taylor_series]");
        ask(&a, "accuracy.rtol", rtols[i]);
        asked_run(&a);
        from[i] = a.study.taylor.agrees_from;
        CHECK(quantity_exists(&from[i]), "rtol %s: %s", rtols[i],
              from[i].reason);
        CHECK(fabs(from[i].value - from[0].value) <=
                  from[i].error + from[0].error,
              "rtol %s: %.17g +- %.2g, not %.17g", rtols[i], from[i].value,
              from[i].error, from[0].value);
        asked_free(&a);
    }
}

static void without_a_saddle_there_is_a_reason(void **state)
{
    static struct asked a;

    (void) state;
    ask_series(&a, "spinodal_gen", "0.28");
    CHECK(a.study.taylor.terms == 0 &&
              !quantity_exists(&a.study.taylor.radius) &&
              !quantity_exists(&a.study.taylor.agrees_to),
          "%zu terms", a.study.taylor.terms);
    asked_free(&a);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(coefficients_are_those_of_the_equations),
        cmocka_unit_test(the_radius_is_within_its_bar),
        cmocka_unit_test(near_the_saddle_the_sum_is_the_curve),
        cmocka_unit_test(order_14_leaves_the_curve_before_the_upper_knee),
        cmocka_unit_test(places_of_a_loose_curve_are_those_of_a_tight_one),
        cmocka_unit_test(order_14_leaves_a_curve_that_has_no_end),
        cmocka_unit_test(without_a_saddle_there_is_a_reason),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
