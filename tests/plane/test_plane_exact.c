/* Models as those who use XPPAUT write them, whose right-hand sides stand here
 * twice: as formulas, and in C over 113-bit numbers, which a method of another
 * kind follows.  No bar lies. */
#include <math.h>

#include "formulas.h"
#include "quad_way.h"

struct model {
    const char *name, *ode, *window;
    quad_rates *rates;
};

#define RATES(f, first, second)                                                \
    static void f(const void *ctx, quad t, const quad z[2], quad out[2])       \
    {                                                                          \
        const quad x = z[0], y = z[1];                                         \
        (void) ctx, (void) t;                                                  \
        out[0] = first;                                                        \
        out[1] = second;                                                       \
    }
/* A decimal as it is typed, of so many thousandths. */
#define D(n) ((quad) (n) / 1000)

static quad hill(quad x, quad n)
{
    return 1 / (1 + powq(x, n));
}
static quad logistic(quad x)
{
    return 1 / (1 + expq(-x));
}
static quad tanh_of(quad x)
{
    return sinhq(x) / coshq(x);
}

RATES(fitzhugh, x - x * x * x / 3 - y + D(500),
      D(80) * (x + D(700) - D(800) * y))
RATES(bistable, x *(x - D(250)) * (1 - x) - y, D(50) * (x - 6 * y))
RATES(van_der_pol, y, D(300) * (1 - x * x) * y - x)
RATES(duffing, y, x - x * x * x - D(300) * y)
RATES(pendulum, y, -sinq(x) - D(200) * y + D(500))
RATES(lotka, x *(1 - y), y *(x - 1) * D(700))
RATES(competition, x *(3 - x - 2 * y), y *(2 - x - y))
RATES(holling, x *(1 - x / 3) - x * y / (1 + x), y *(x / (1 + x) - D(400)))
RATES(allee, x *(x - D(200)) * (1 - x) - x * y, y *(x - D(600)))
RATES(toggle, 3 * hill(y, 3) - x, 3 * hill(x, 3) - y)
RATES(brusselator, 1 - 3 * x + x * x * y, 2 * x - x * x * y)
RATES(selkov, -x + D(80) * y + x * x * y, D(600) - D(80) * y - x * x * y)
RATES(schnakenberg, D(100) - x + x * x * y, D(900) - x * x * y)
RATES(wilson, -x + logistic(12 * x - 10 * y - 2),
      -y + logistic(10 * x - 2 * y - 4))
RATES(hopfield, -x + 2 * tanh_of(x) - D(500) * tanh_of(y),
      -y + 2 * tanh_of(y) - D(500) * tanh_of(x))
RATES(sir, D(20) - 2 * x * y - D(20) * x, 2 * x * y - D(520) * y)
RATES(chemostat, y *(2 * x / (D(500) + x) - D(600)),
      D(600) * (2 - x) + 0 * y - y * 2 * x / (D(500) + x))
RATES(lienard, y - (x * x * x - x), -x + D(200) * x * x)
RATES(bogdanov, y, D(-200) + D(100) * y + x * x + x * y)
RATES(hopf, D(-300) * x - y + x * (x * x + y * y),
      x - D(300) * y + y * (x * x + y * y))
RATES(limit, y, -x + D(500) * x * x * x - D(100) * y + D(100) * y * y)
RATES(rotor, y, cosq(x) - D(400) * y - D(300))
RATES(shear, D(1000) * (y - x * x * x + x), D(-500) * x - y)
RATES(stirred, -x + D(300) * (1 - x) * expq(2 * y / (1 + y / 10)),
      -y - D(500) * y + D(600) * (1 - x) * expq(2 * y / (1 + y / 10)))
RATES(autocatalysis, D(100) - D(50) * x - x * y * y,
      x *y *y + D(10) * x - D(150) * y)
RATES(genetic, D(50) + x * x / (D(100) + x * x) - D(800) * x, x - y)
RATES(channel,
      D(-500) * (x + D(700)) - logistic((x + D(200)) * 20) * (x - 1) -
          y * (x + 1),
      logistic((x + D(100)) * 10) - y)
RATES(three_well, y, -x *(x *x - 1) * (x * x - 4) - D(500) * y)
RATES(gradient, x - x * x * x + D(200) * y, y - y * y * y + D(200) * x)
RATES(laser, x *(y - 1 - x * x / 10), D(1500) - y - D(500) * x * x * y)
RATES(rational, y, x / (1 + x * x) - D(300) * x - D(200) * y)
RATES(slow_fast, (y - x * x * x + 2 * x) * 5, D(300) - x - D(300) * y)

#define SQUARE  "window={x: [-3, 3], y: [-3, 3]}"
#define QUARTER "window={x: [0.01, 4], y: [-0.5, 4]}"

static const struct model models[] = {
    { "fitzhugh",
      "x' = x - x^3/3 - y + i; y' = e*(x + a - b*y); i = 0.5; e = 0.08; a = "
      "0.7; b = 0.8",
      SQUARE, fitzhugh },
    { "bistable",
      "x' = x*(x - a)*(1 - x) - y; y' = e*(x - g*y); a = 0.25; e = 0.05; g = 6",
      SQUARE, bistable },
    { "van der pol", "x' = y; y' = mu*(1 - x^2)*y - x; mu = 0.3", SQUARE,
      van_der_pol },
    { "duffing", "x' = y; y' = x - x^3 - d*y; d = 0.3", SQUARE, duffing },
    { "pendulum", "x' = y; y' = -sin(x) - c*y + t0; c = 0.2; t0 = 0.5", SQUARE,
      pendulum },
    { "lotka", "x' = x*(1 - y); y' = r*y*(x - 1); r = 0.7", SQUARE, lotka },
    { "competition", "x' = x*(3 - x - 2*y); y' = y*(2 - x - y)", SQUARE,
      competition },
    { "holling",
      "x' = x*(1 - x/k) - x*y/(1 + x); y' = y*(x/(1 + x) - m); k = 3; m = 0.4",
      QUARTER, holling },
    { "allee", "x' = x*(x - a)*(1 - x) - x*y; y' = y*(x - m); a = 0.2; m = 0.6",
      SQUARE, allee },
    { "toggle", "x' = a/(1 + y^3) - x; y' = a/(1 + x^3) - y; a = 3",
      "window={x: [0, 4], y: [0, 4]}", toggle },
    { "brusselator",
      "x' = a - (b + 1)*x + x^2*y; y' = b*x - x^2*y; a = 1; b = 2", SQUARE,
      brusselator },
    { "selkov",
      "x' = -x + a*y + x^2*y; y' = b - a*y - x^2*y; a = 0.08; b = 0.6", SQUARE,
      selkov },
    { "schnakenberg", "x' = a - x + x^2*y; y' = b - x^2*y; a = 0.1; b = 0.9",
      SQUARE, schnakenberg },
    { "wilson",
      "x' = -x + 1/(1 + exp(-(12*x - 10*y - 2))); y' = -y + 1/(1 + exp(-(10*x "
      "- 2*y - 4)))",
      SQUARE, wilson },
    { "hopfield",
      "x' = -x + 2*tanh(x) - w*tanh(y); y' = -y + 2*tanh(y) - w*tanh(x); w = "
      "0.5",
      SQUARE, hopfield },
    { "sir",
      "x' = m - b*x*y - m*x; y' = b*x*y - (g + m)*y; m = 0.02; b = 2; g = 0.5",
      SQUARE, sir },
    { "chemostat",
      "x' = y*(m*x/(h + x) - d); y' = d*(2 - x) - y*m*x/(h + x); m = 2; h = "
      "0.5; d = 0.6",
      QUARTER, chemostat },
    { "lienard", "x' = y - (x^3 - x); y' = -x + a*x^2; a = 0.2", SQUARE,
      lienard },
    { "bogdanov", "x' = y; y' = b1 + b2*y + x^2 + x*y; b1 = -0.2; b2 = 0.1",
      SQUARE, bogdanov },
    { "hopf",
      "x' = m*x - y + x*(x^2 + y^2); y' = x + m*y + y*(x^2 + y^2); m = -0.3",
      SQUARE, hopf },
    { "limit", "x' = y; y' = -x + b*x^3 - c*y + c*y^2; b = 0.5; c = 0.1",
      SQUARE, limit },
    { "rotor", "x' = y; y' = cos(x) - c*y - t0; c = 0.4; t0 = 0.3", SQUARE,
      rotor },
    { "shear", "x' = y - x^3 + x; y' = -b*x - y; b = 0.5", SQUARE, shear },
    { "stirred",
      "x' = -x + d*(1 - x)*exp(2*y/(1 + y/10)); y' = -y - b*y + 2*d*(1 - "
      "x)*exp(2*y/(1 + y/10)); d = 0.3; b = 0.5",
      SQUARE, stirred },
    { "autocatalysis",
      "x' = f - k*x - x*y^2; y' = x*y^2 + u*x - v*y; f = 0.1; k = 0.05; u = "
      "0.01; v = 0.15",
      SQUARE, autocatalysis },
    { "genetic",
      "x' = r + x^2/(h + x^2) - d*x; y' = x - y; r = 0.05; h = 0.1; d = 0.8",
      SQUARE, genetic },
    { "channel",
      "x' = -g*(x + 0.7) - (x - 1)/(1 + exp(-(x + 0.2)*20)) - y*(x + 1); y' = "
      "1/(1 + exp(-(x + 0.1)*10)) - y; g = 0.5",
      SQUARE, channel },
    { "three wells", "x' = y; y' = -x*(x^2 - 1)*(x^2 - 4) - c*y; c = 0.5",
      SQUARE, three_well },
    { "gradient", "x' = x - x^3 + k*y; y' = y - y^3 + k*x; k = 0.2", SQUARE,
      gradient },
    { "laser",
      "x' = x*(y - 1 - x^2/10); y' = p - y - s*x^2*y; p = 1.5; s = 0.5", SQUARE,
      laser },
    { "rational", "x' = y; y' = x/(1 + x^2) - k*x - c*y; k = 0.3; c = 0.2",
      SQUARE, rational },
    { "slow and fast",
      "x' = 5*(y - x^3 + 2*x); y' = a - x - b*y; a = 0.3; b = 0.3", SQUARE,
      slow_fast },
};
enum { MODELS = sizeof models / sizeof *models };

/* ---- 113 bits ------------------------------------------------------------ */

static struct quad_way way_at(const struct model *m,
                              const struct plane_study *s,
                              const struct plane_rest *r)
{
    struct quad_way w = { .rates = m->rates,
                          .side = { s->scale.side.x, s->scale.side.y },
                          .accuracy = 1e-22,
                          .most = 0.01,
                          .z = { r->exact.state[0].value,
                                 r->exact.state[1].value } };

    if (r->type != PLANE_NONHYPERBOLIC) /* its Jacobian may be singular */
        quad_way_settle(&w);
    return w;
}

/* A bar that is the rounding of its value is a double as well. */
static void within(const struct quantity *q, quad truth, quad slack,
                   const char *model, const char *what)
{
    CHECK(fabsq((quad) q->value - truth) <= nextafter(q->error, 1.0) + slack,
          "%s: %s %.17g +- %g, not %.17g", model, what, q->value, q->error,
          (double) truth);
}

static void equilibria_hold(const struct model *m, const struct plane_study *s)
{
    for (size_t i = 0; i < s->rests; i++) {
        const struct plane_rest *r = &s->rest[i];
        const struct quad_way w = way_at(m, s, r);
        const quad *z = w.z;
        quad re[2], im;

        if (r->type == PLANE_NONHYPERBOLIC)
            continue;
        quad_way_eigenvalues(&w, re, &im);
        for (int k = 0; k < 2; k++) {
            CHECK(fabsq(r->exact.state[k].value - z[k]) <=
                      r->exact.state[k].error + (quad) 1e-28,
                  "%s: equilibrium %zu is off by %g, bar %g", m->name, i,
                  (double) (r->exact.state[k].value - z[k]),
                  r->exact.state[k].error);
            within(&r->state[k], z[k], 0, m->name, r->name);
            within(&r->lambda[k].re, re[k], (quad) 1e-17, m->name, r->name);
            within(&r->lambda[k].im, k ? im : -im, (quad) 1e-17, m->name,
                   r->name);
        }
    }
}

static void run(const struct model *m, const char *product,
                struct plane_study *s, struct scene *c)
{
    char more[120];

    snprintf(more, sizeof more, "%s\nproducts=[%s]\n", m->window, product);
    plane_run(s, c, m->ode, more);
}

static void every_equilibrium_is_held_to_113_bits(void **state)
{
    size_t count = 0;

    (void) state;
    for (int i = 0; i < MODELS; i++) {
        const struct model *m = &models[i];
        struct plane_study s;
        struct scene c;
        run(m, "equilibria", &s, &c);
        CHECK(s.rests > 0, "%s has none", m->name);
        equilibria_hold(m, &s);
        count += s.rests;
        plane_end(&s, &c);
    }
    print_message("# %d models, %zu equilibria\n", MODELS, count);
}

/* ---- branches ------------------------------------------------------------ */

enum { POINTS = 6 };

/* Some points of a branch, from the saddle on. */
static void branch_holds(const struct model *m, const struct plane_study *s,
                         const struct plane_branch *b, size_t *points)
{
    const struct record_type type = { .size = sizeof(struct plane_point) };
    struct plane_point some[POINTS];
    struct rows r = rows_of(&type);
    quad off[POINTS];
    bool lost;

    assert_int_equal(plane_rows_branch(s, b, &r), STATUS_OK);
    const struct plane_point *all = (const struct plane_point *) r.at;
    CHECK(r.count > POINTS, "%s: %zu points", m->name, r.count);
    for (size_t i = 0; i < POINTS; i++)
        some[i] = all[(i + 1) * (r.count - 1) / (POINTS + 1)];
    struct quad_way w = way_at(m, s, &s->rest[b->rest]);
    w.step = b->kind == MANIFOLD_STABLE ? -1 : 1;
    quad_way_leave(&w, all[1].at);
    const size_t held = quad_way_follow(&w, some, POINTS, 1e-20, off, &lost);
    CHECK(held == POINTS,
          "%s: %.17g, %.17g (arc %g) is off by %g, bar %g, or not come to",
          m->name, some[held].at[0], some[held].at[1], some[held].arc,
          (double) off[held], some[held].error);
    *points += held;
    rows_free(&r);
}

static void every_branch_is_held_to_113_bits(void **state)
{
    size_t branches = 0, points = 0;

    (void) state;
    for (int i = 0; i < MODELS; i++) {
        const struct model *m = &models[i];
        struct plane_study s;
        struct scene c;
        run(m, "manifolds", &s, &c);
        for (size_t k = 0; k < s.branches; k++)
            branch_holds(m, &s, &s.branch[k], &points);
        branches += s.branches;
        plane_end(&s, &c);
    }
    print_message("# %zu branches, %zu of %zu points are met\n", branches,
                  points, POINTS * branches);
    assert_int_equal(points, POINTS * branches);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_equilibrium_is_held_to_113_bits),
        cmocka_unit_test(every_branch_is_held_to_113_bits),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
