#include "steady_curve.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "numbers.h"
#include "numbers_tolerance.h"
#include "response.h"
#include "tolerance.h"

#define V FIELD(steady_point, REAL, v, "V_star", "slip rate in units of V_star")
#define PSI                                                                    \
    FIELD(steady_point, QUANTITY, psi, "psi", "interfacial state psi_ss(v)")
#define MU                                                                     \
    FIELD(steady_point, QUANTITY, mu, "1",                                     \
          "steady-state friction coefficient mu_ss(v)")

const struct record_type record_friction = RECORD(
    steady_point, "friction_law", "friction in steady sliding, Fig 1(a)", V,
    PSI, MU, FIELD(steady_point, QUANTITY, slope, "1", "d mu_ss/d ln v"));

const struct record_type record_bifurcation = RECORD(
    steady_point, "bifurcation", "steady states over all slopes, Fig 3", V,
    FIELD(steady_point, QUANTITY, alpha, "rad",
          "slope angle on which the block slides steadily"),
    FIELD_CODE(steady_point, type, equilibrium_type_names, "linear type there"),
    PSI, MU,
    FIELD(steady_point, QUANTITY, lambda_minus, "V_star/L",
          "smaller eigenvalue, per L/V_star"),
    FIELD(steady_point, QUANTITY, lambda_plus, "V_star/L",
          "larger eigenvalue, per L/V_star"));

/* ---- one steady state ---------------------------------------------------- */

/* Type and eigenvalues on the slope that v takes: a saddle where mu_ss falls, a
 * stable node where it rises, (14).  The eigenvalues cannot tell where a frozen
 * state takes one of them below the smallest number. */
static void set_type(struct block *b, long double x, bool fold,
                     struct steady_point *p)
{
    const struct law *law = &b->law;
    const struct material *m = &b->material;
    const double top = law_psi_is_log(law) ? TOL_RANGE : LN_RANGE;
    struct equilibrium e;

    p->type = -1;
    p->lambda_minus = p->lambda_plus = quantity_none(
        quantity_exists(&p->alpha) ? "the state is beyond [1e-300, 1e300]"
                                   : p->alpha.reason);
    if (!quantity_exists(&p->alpha) ||
        !(fabsl(steady_y(law, m, x)) <= (long double) top))
        return;
    block_lean(b, steady_mu(law, m, x));
    block_anchor(b, x, true);
    const struct planar sys = block_planar(b);
    equilibrium_at(&sys, fold, &e);
    const struct steady_number n = numbers_steady(b, &e);
    p->type = (int8_t) (fold                   ? EQUILIBRIUM_SADDLE_NODE
                        : p->slope.value < 0.0 ? EQUILIBRIUM_SADDLE
                                               : EQUILIBRIUM_STABLE_NODE);
    p->lambda_minus = n.lambda_minus;
    p->lambda_plus = n.lambda_plus;
}

static struct steady_point point_at(struct block *b, double v, bool fold)
{
    const struct law *law = &b->law;
    const struct material *m = &b->material;
    const long double x = logl((long double) v);
    const struct response r = response_at(law, m, x);
    const double psi = (double) steady_psi(law, m, x);
    const double mu = (double) steady_mu(law, m, x);
    const double slope = (double) r.slope;
    const double noise =
        (double) (r.slope_error * (1 + fabsl(x)) +
                  16 * LDBL_EPSILON * (long double) fabs(m->mu_star));
    struct steady_point p = {
        .v = v,
        .psi = quantity_of(psi, 2.0 * DBL_EPSILON * fabs(psi)),
        .mu = quantity_of(mu, DBL_EPSILON * fabs(mu) + noise),
        .slope = quantity_of(slope, DBL_EPSILON * fabs(slope) +
                                        (double) r.slope_error),
    };

    p.alpha = extremum_angle(&p.mu);
    set_type(b, x, fold, &p);
    return p;
}

/* ---- the curve ----------------------------------------------------------- */

/* As far as the block's chart and the law reach; false if nowhere. */
static bool clip(const struct law *law, const double v[2], double out[2])
{
    const long double top = steady_x_max(law); /* psi = -ln v > 0: v < 1 */

    out[0] = fmax(v[0], 1.0 / TOL_RANGE);
    out[1] = fmin(v[1], TOL_RANGE);
    if (logl((long double) out[1]) >= top)
        out[1] = (double) expl(top) * (1.0 - TOL_ASIDE);
    return out[0] < out[1];
}

/* After those with smaller v; an extremum replaces the point it falls on. */
static void append(struct block *b, double v, bool fold, struct steady_curve *c)
{
    const double last = c->count > 0 ? c->at[c->count - 1].v : 0.0;

    if (v > last)
        c->at[c->count++] = point_at(b, v, fold);
    else if (fold)
        c->at[c->count - 1] = point_at(b, v, true);
}

static void fill(const struct law *law, const struct material *m,
                 const double v[2], struct steady_curve *c)
{
    const int last = STUDY_CURVE_POINTS - 1;
    const long double ratio = logl((long double) v[1] / (long double) v[0]);
    size_t next = 0;
    struct block b;

    block_init(&b, law, m, 0.0L);
    while (next < c->extrema && c->extremum[next].v.value < v[0])
        next++;
    for (int i = 0; i <= last; i++) {
        const long double grown = expl(ratio * i / last);
        const double at =
            i < last ? (double) ((long double) v[0] * grown) : v[1];
        for (; next < c->extrema && c->extremum[next].v.value < at; next++)
            append(&b, c->extremum[next].v.value, true, c);
        append(&b, at, false, c);
    }
}

enum status steady_curve_find(const struct law *law, const struct material *m,
                              const double v[2], struct steady_curve *c)
{
    double reach[2];

    *c = (struct steady_curve){ .at = NULL };
    c->at = malloc((STUDY_CURVE_POINTS + EXTREMA_MAX) * sizeof *c->at);
    if (c->at == NULL)
        return STATUS_NO_MEMORY;
    c->extrema = extremum_find(law, m, c->extremum);
    if (clip(law, v, reach))
        fill(law, m, reach, c);
    return STATUS_OK;
}

void steady_curve_free(struct steady_curve *c)
{
    free(c->at);
    *c = (struct steady_curve){ .at = NULL };
}
