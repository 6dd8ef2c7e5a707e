/* The planar contract filled in by friction: thin wrappers around the tape of
 * the law's formulas (law_tape.h). */
#include "block.h"

#include <float.h>
#include <math.h>

#include "law_typed.h"
#include "quasistatic.h"
#include "tolerance.h"

static long double balance(const void *ctx, long double x)
{
    const struct block *b = ctx;
    return b->tau - steady_mu_log(&b->law, &b->material, x);
}

static long double steady_curve(const void *ctx, long double x)
{
    const struct block *b = ctx;
    return steady_y(&b->law, &b->material, x);
}

static const struct planar_observable observables[BLOCK_OBSERVABLES] = {
    [BLOCK_SLIP] = { "slip", "1", "slip in units of L" },
    [BLOCK_WORK] = { "work", "1",
                     "frictional work per unit normal force, units of L" },
    [BLOCK_EXCESS] = { "excess", "1",
                       "slip in excess of steady slip at v_sp, units of L" },
};

void block_init(struct block *b, const struct law *law,
                const struct material *m, long double tan_alpha)
{
    const long double top = steady_x_max(law);

    b->law = *law; /* what is large is not cleared: block_anchor fills it */
    b->material = *m;
    block_lean(b, tan_alpha);
    b->at = (struct anchor){ 0 };
    b->x = b->y = 0.0L;
    b->bar = 0.0;
    b->steep = (struct vec2){ m->a, m->b };
    b->waits = law->kinetics == KINETICS_SINH;
    b->traps = true;
    b->end = (struct block_end){ BLOCK_UNKNOWN, 0.0 };
    b->steady = (struct planar_steady){ 0 };
    b->steady.balance = balance;
    b->steady.y = steady_curve;
    b->steady.turnings = steady_extrema(law, m, b->steady.turning);
    b->steady.lo = -(long double) LN_RANGE;
    b->steady.hi = top < (long double) LN_RANGE ? top : (long double) LN_RANGE;
    if (law->typed)
        law_typed_range(law, m, &b->steady.lo, &b->steady.hi);
}

void block_lean(struct block *b, long double tan_alpha)
{
    b->tan_alpha = tan_alpha;
    b->tau = steady_tau(&b->law, &b->material, tan_alpha);
}

/* By mu_ss's slope; next to a fold by its curvature, which leaves noise >=
 * |mu_ss''| d^2/2; and where folds meet by the third derivative, which is never
 * far below a + b. */
static double bar_of_place(const struct block *b)
{
    const struct law *law = &b->law;
    const struct material *m = &b->material;
    const long double x = (long double) b->at.x0;
    const long double h = fminl(1e-5L, (steady_x_max(law) - x) / 2);
    const long double above = steady_mu_log(law, m, x + h);
    const long double below = steady_mu_log(law, m, x - h);
    const double slope = (double) fabsl((above - below) / (2 * h));
    const double bend = (double) fabsl(
        (above - 2 * steady_mu_log(law, m, x) + below) / (h * h));
    const double tau = (double) b->tau;
    const double ax = b->at.a * b->at.x0;
    const double size = fabs(tau) + fabs(m->mu_star) + fabs(ax) +
                        fabs(tau - m->mu_star - ax) + b->at.b;
    const double noise =
        (double) LDBL_EPSILON * size + (double) steady_mu_log_off(law, m, x);

    return fmin(fmin(noise / slope, sqrt(2.0 * noise / bend)),
                cbrt(6.0 * noise / (0.1 * (m->a + m->b))));
}

void block_anchor(struct block *b, long double x, bool equilibrium)
{
    b->x = x;
    b->y = steady_anchor(&b->law, &b->material, b->tan_alpha, x, equilibrium,
                         &b->at);
    b->bar = bar_of_place(b);
    if (!steady_plane(&b->law, &b->material, b->tan_alpha, x, equilibrium,
                      &b->plane))
        b->at.force0 = NAN;
}

void block_ask(struct block *b)
{
    if (!b->law.typed)
        return;
    b->end = quasistatic_typed_end(b);
    b->steep = quasistatic_typed_steep(b);
    b->waits = !quasistatic_typed_is_linear(b);
    b->traps = quasistatic_typed_traps(b);
}

struct vec2 block_offset(const struct block *b, double v, double psi)
{
    const long double y =
        law_psi_is_log(&b->law) ? (long double) psi : logl((long double) psi);

    return (struct vec2){ (double) (logl((long double) v) - b->x),
                          (double) (y - b->y) };
}

/* a e^u, where e^u may be no double and the product is. */
static double times_exp(double a, double u)
{
    const double e = exp(u), half = exp(0.5 * u);

    return isnormal(e) ? a * e : a * half * half;
}

double block_v(const struct block *b, double x)
{
    return times_exp(b->at.v0, x);
}

double block_psi(const struct block *b, double y)
{
    return law_psi_is_log(&b->law) ? b->at.y0 + y : times_exp(b->at.psi0, y);
}

struct planar block_planar(const struct block *b)
{
    const bool is_log = law_psi_is_log(&b->law);
    const double bottom = is_log ? -TOL_RANGE : -LN_RANGE;
    const double top = is_log ? fmax(b->at.y0, 0.0) + TOL_PSI_ROOM : LN_RANGE;

    struct planar s = tape_planar(&b->plane);
    s.name = b->law.preset;
    s.axis[0] = (struct planar_axis){ "v", "V_star",
                                      "slip rate in units of V_star", true };
    s.axis[1] =
        (struct planar_axis){ "psi", "psi", "interfacial state", !is_log };
    s.domain = (struct box){ { -LN_RANGE, bottom }, { LN_RANGE, top } };
    s.origin = (struct vec2){ b->at.x0, b->at.y0 };
    s.observables = observables;
    s.steady = &b->steady;
    return s;
}

double block_mu(const struct block *b, struct vec2 z)
{
    return tape_value(&b->plane, z);
}

double block_psi_slope(const struct block *b)
{
    struct law_long p;

    law_long_init(&p, &b->law, &b->material, 0);
    return (double) fabsl(law_long_along(&p, b->x, LAW_AT_PSI));
}

double block_energy_defect(const struct block *b, double v0, double v1,
                           double slip, double work)
{
    const double t = (double) b->tan_alpha, cosine = 1.0 / hypot(1.0, t);
    const double half = 0.5 * material_eps2(&b->material);
    const double kinetic = half * (v1 - v0) * (v1 + v0);
    const double most = half * fmax(v0, v1) * fmax(v0, v1);
    const double down = t * cosine * slip, up = cosine * work;
    const double scale = fmax(most, fmax(fabs(down), fabs(up)));

    return scale == 0.0 || isinf(scale) ? 0.0 : (kinetic - down + up) / scale;
}
