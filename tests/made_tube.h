/* made_tube.h -- fields whose branches are known, for proofs of what is beside
 * them: beside a polynomial candidate p the exact branch p + w has, with theta
 * the piece's,
 *
 *     w' = (A + L w + C w^2)/E,               theta' = -E          in a cell,
 *     w' = (theta A + L w + C w^2)/(theta E), theta' = -theta E    in a cone,
 *
 * A, L and E polynomials, A one of 2 theta - 1 in a cell; w is followed by
 * steps of Runge and Kutta.  Terms are left out and signs agree so often that
 * every inequality is nearly an equality for some draw: one that is weaker is
 * seen to be wrong. */
#pragma once

#include "interval_math.h"
#include "made_plane.h"
#include "proof_tube.h"

enum { TERMS = 6 };

struct made {
    bool cone, by_dep; /* by_dep: A is one of p + w, and p = theta */
    double A[TERMS], L[TERMS], E[TERMS], obs[TERMS], C, across, rise;
    double obs_across, common; /* e^(common theta) is a factor of all rates */
    double error;              /* w where it begins */
    struct proof_piece piece;
};

/* ---- the field ----------------------------------------------------------- */

static inline long double poly(const double c[], long double at)
{
    long double sum = 0;

    for (int k = TERMS; k-- > 0;)
        sum = c[k] + at * sum;
    return sum;
}

static inline long double rate_of(const struct made *f, long double theta,
                                  long double w)
{
    const long double y = poly(f->piece.coef, theta) + w;

    return (poly(f->E, theta) + f->across * y) * expl(f->rise * theta);
}

/* w' and that of the integral of the observable over time, by theta. */
static inline void move(const struct made *f, long double theta,
                        const long double u[], long double out[])
{
    const long double y = poly(f->piece.coef, theta) + u[0];
    const long double by = f->by_dep ? y : theta;
    const long double A = poly(f->A, f->cone ? by : 2 * by - 1);
    const long double E = rate_of(f, theta, u[0]);
    const long double obs =
        (f->cone ? theta : 1) * poly(f->obs, theta) + f->obs_across * y;
    const long double t = f->cone ? theta : 1;

    out[0] = (t * A + poly(f->L, by) * u[0] + f->C * u[0] * u[0]) / (t * E);
    out[1] = obs / (t * E);
}

/* From theta = a to b; in a cone in steps of its logarithm. */
static inline void follow(const struct made *f, double a, double b, int steps,
                          long double u[2])
{
    const long double h = (f->cone ? logl(b) - logl(a) : b - a) / steps;

    for (int i = 0; i < steps; i++) {
        long double k[4][2], at[2];
        for (int s = 0; s < 4; s++) {
            const long double part = s == 0 ? 0 : s == 3 ? h : h / 2;
            const long double t =
                f->cone ? a * expl(i * h + part) : a + i * h + part;
            for (int j = 0; j < 2; j++)
                at[j] = u[j] + (s ? part * k[s - 1][j] : 0);
            move(f, t, at, k[s]);
            for (int j = 0; f->cone && j < 2; j++)
                k[s][j] *= t;
        }
        for (int j = 0; j < 2; j++)
            u[j] += h / 6 * (k[0][j] + 2 * k[1][j] + 2 * k[2][j] + k[3][j]);
    }
}

/* ---- as formulas --------------------------------------------------------- */

static inline const char *horner(const double c[], const char *at)
{
    static char text[8][400];
    static int next;
    char *out = text[next++ % 8];
    size_t used = 0, last = 0;

    for (size_t k = 0; k < TERMS; k++)
        last = c[k] < 0 || c[k] > 0 ? k : last;
    for (size_t k = 0; k < last; k++)
        used += (size_t) snprintf(out + used, 400 - used, "(%.17g) + %s*(",
                                  c[k], at);
    used += (size_t) snprintf(out + used, 400 - used, "(%.17g)", c[last]);
    for (size_t k = 0; k < last; k++)
        used += (size_t) snprintf(out + used, 400 - used, ")");
    assert_true(used < 400);
    return out;
}

static inline void tape_about_0(const char *const rate[2], const char *observed,
                                bool equilibrium, struct interval_graph *g,
                                struct interval_tape *t)
{
    static const int observable[] = { 2 };
    static const bool positive[2];
    struct fault why = { "" };
    mpfi_t zero;

    CHECK(lower(rate, positive, observed, equilibrium, &why) == STATUS_OK, "%s",
          why.text);
    assert_int_equal(interval_graph_init(g, &lowered.f, lowered.t.needs, 160),
                     STATUS_OK);
    mpfi_init2(zero, 53);
    mpfi_set_d(zero, 0);
    for (int i = 0; i < 2; i++) {
        interval_graph_set(g, parameters[i].name, zero);
        interval_graph_set(g, lowered.f.node[lowered.p.chart[i]].name, zero);
    }
    mpfi_clear(zero);
    CHECK(interval_graph_run(g, &why) == STATUS_OK, "%s", why.text);
    assert_int_equal(interval_tape_init(t, &lowered.t, g, observable, 1),
                     STATUS_OK);
}

/* About (0, 0). */
static inline void tape_of(const struct made *f, struct interval_graph *g,
                           struct interval_tape *t)
{
    static char rate[2][3000], over[600], w[400], theta[60];
    static char obs[500], twice[80], common[100];
    const struct proof_piece *p = &f->piece;
    const char *ind = p->ind ? "y" : "x", *dep = p->ind ? "x" : "y";
    const char *t_or_1 = f->cone ? theta : "1";
    const char *by = f->by_dep ? dep : theta;
    double rise[TERMS] = { 0 };

    for (int k = 0; k + 1 < TERMS; k++)
        rise[k] = (k + 1) * p->coef[k + 1];
    snprintf(theta, sizeof theta, "((%s - (%.17g))/(%.17g))", ind, p->start,
             p->step);
    snprintf(over, sizeof over, "((%s) + (%.17g)*%s)*exp((%.17g)*%s)",
             horner(f->E, theta), f->across, dep, f->rise, theta);
    snprintf(twice, sizeof twice, "(2*%s - 1)", by);
    snprintf(w, sizeof w, "(%s - (%s))", dep, horner(p->coef, theta));
    snprintf(common, sizeof common, "exp((%.17g)*%s)", f->common, theta);
    snprintf(rate[p->ind], sizeof *rate, "-(%.17g)*%s*(%s)*%s", p->step, t_or_1,
             over, common);
    snprintf(rate[1 - p->ind], sizeof *rate,
             "-(%s*((%s)*(%s) + (%s)) + (%s)*%s + (%.17g)*%s*%s)*%s", t_or_1,
             horner(rise, theta), over, horner(f->A, f->cone ? by : twice),
             horner(f->L, by), w, f->C, w, w, common);
    snprintf(obs, sizeof obs, "(%s*(%s) + (%.17g)*%s)*%s", t_or_1,
             horner(f->obs, theta), f->obs_across, dep, common);
    tape_about_0((const char *[]){ rate[0], rate[1] }, obs, f->cone, g, t);
}

/* ---- draws --------------------------------------------------------------- */

/* 0 as often as not. */
static inline double perhaps(uint64_t *rng, double lo, double hi)
{
    const double u = check_uniform(rng, lo, hi);

    return check_bits(rng) % 2 ? u : 0;
}

/* One term beside a constant A: an E that falls, an L that has its largest
 * value inside or at the rim, or the order of A that a remainder has to hold.
 */
static inline void draw_few(struct made *f, double size, uint64_t *rng)
{
    const size_t last = f->piece.degree + check_bits(rng) % 2;
    const double L = check_uniform(rng, 1, 4);
    const struct made few = {
        .cone = f->cone,
        .by_dep = f->by_dep,
        .piece = f->piece,
        .A = { size },
        .E = { 1 },
        .obs = { 1 },
    };

    *f = few;
    if (!f->cone && check_bits(rng) % 2) { /* w grows as fast as it may */
        f->A[0] = 0;
        f->error = size;
        f->L[0] = check_uniform(rng, -2, 2);
        f->L[1] = perhaps(rng, 0, 3);
        f->L[2] = f->by_dep ? 10 : 0; /* least inside of a cell */
        f->C = perhaps(rng, 0, 2) / size;
        f->across = perhaps(rng, -0.2, 0.2);
        f->obs_across = check_uniform(rng, -1, 1);
        return;
    }
    if (!f->cone) {
        f->A[last] +=
            size * check_uniform(rng, 0, 0.5) * (check_bits(rng) % 2 ? 1 : 60);
        return;
    }
    f->L[0] = -0.02;
    switch (check_bits(rng) % 4) {
        case 3: /* a node, of whose branches one comes in with a slope */
            f->L[0] = check_uniform(rng, 0.5, 0.75);
            break;
        case 0:
            f->E[1] = -check_uniform(rng, 1.2, 1.42);
            break;
        case 1:
            f->L[1] = 5 * L;
            f->L[2] = -f->L[1] * check_uniform(rng, 1.3, 1.5);
            break;
        default:
            f->L[1] = L;
            f->L[2] = -L / 1.4;
    }
}

static inline void draw(struct made *f, bool cone, uint64_t *rng)
{
    const double size = pow(10, check_uniform(rng, -4, -0.5));
    const double sign = check_bits(rng) % 2 ? 1 : -1;
    const bool even = check_bits(rng) % 2, plain_L = check_bits(rng) % 2;
    const bool plain_E = check_bits(rng) % 2;

    *f = (struct made){ .cone = cone, .by_dep = check_bits(rng) % 4 == 0 };
    f->piece = (struct proof_piece){
        .ind = (int) (check_bits(rng) % 2),
        .start = cone ? 0 : (double) (check_bits(rng) % 9) / 4 - 1,
        .step = (check_bits(rng) % 2 ? 1 : -1) *
                ldexp(1, (int) (check_bits(rng) % 3) - 1),
        .degree = 2 + (check_bits(rng) % 3),
    };
    for (size_t k = cone; k <= f->piece.degree; k++)
        f->piece.coef[k] = f->by_dep ? k == 1 : perhaps(rng, -1, 1);
    f->error = cone || check_bits(rng) % 3 == 0 ? 0 : sign * size;
    for (int k = 0; k < TERMS; k++) {
        f->A[k] = even && k % 2 ? 0
                                : sign * size * perhaps(rng, 0, 1) *
                                      (check_bits(rng) % 4 || even
                                           ? 1
                                           : check_uniform(rng, -30, 30));
        f->L[k] = k == 0 || (!plain_L && k < 3) ? perhaps(rng, -5, 3) : 0;
        f->E[k] = k == 0 ? 1 : !plain_E && k < 4 ? perhaps(rng, -0.3, 0.3) : 0;
        f->obs[k] = perhaps(rng, -1, 1);
    }
    f->C = sign * perhaps(rng, -0.5, cone ? 30 : 0.5) / size;
    f->across = plain_E ? 0 : perhaps(rng, -0.2, 0.2);
    f->rise = plain_E ? 0 : perhaps(rng, -1, 1);
    f->common = perhaps(rng, -30, 30);
    f->obs_across = perhaps(rng, -1, 1);
    if (cone) { /* L is largest inside where L[2] < 0 */
        f->L[0] = -pow(10, check_uniform(rng, -1.7, 1));
        f->L[1] = perhaps(rng, 0, 1) * pow(10, check_uniform(rng, -0.5, 1.3));
        f->L[2] = -f->L[1] * perhaps(rng, 0.5, 1.5);
        f->E[1] = plain_E ? 0 : perhaps(rng, -1.4, 0.3);
    }
    if (check_bits(rng) % 4 == 0)
        draw_few(f, sign * size, rng);
}

/* How near to their bounds things were. */
struct tally {
    int proved;
    double nearest, excess;
};

/* truth within bound, up to the truth's own error */
static inline double part_of(const char *what, const struct made *f,
                             long double truth, double bound, int draw_)
{
    const long double room = 1e-9L;

    CHECK(fabsl(truth) <= bound + room,
          "draw %d, %s%s: %s %.17Lg is beyond %.17g", draw_,
          f->cone ? "cone" : "cell", f->by_dep ? " by dep" : "", what, truth,
          bound);
    return bound > 1e-6 ? (double) (fabsl(truth) / bound) : 0;
}

static inline void check_integral(const struct made *f, long double truth,
                                  struct interval u, int n)
{
    const long double middle = u.lo / 2 + u.hi / 2;

    part_of("integral", f, truth - middle, (double) (u.hi - u.lo) / 2, n);
}
