/* Closed forms and roots found to the last bit: the errors are roundings,
 * magnified by 1/(b - a) in everything that hangs on v_sp0. */
#include "estimate_numbers.h"

#include <float.h>
#include <math.h>

#include "estimates.h"

static const char not_here[] =
    "the estimate needs hyperbolic kinetics, theta a logarithm of psi, b > a";
static const char beyond[] = "the estimate is beyond the range of a double";
static const char no_root[] =
    "dY/dX = -xi nowhere further than 1e-6 from ln v_sp";

static struct quantity in_range(double value, double error)
{
    return isfinite(value) && isfinite(error) ? quantity_of(value, error)
                                              : quantity_none(beyond);
}

/* What cannot be zero. */
static struct quantity number(double value, double relative)
{
    return fabs(value) >= DBL_MIN ? in_range(value, fabs(value) * relative)
                                  : quantity_none(beyond);
}

static struct estimate_numbers nothing(const double xi[], size_t n)
{
    const struct quantity none = quantity_none(not_here);
    struct estimate_numbers e = { .v_sp0 = none,
                                  .psi_sp0 = none,
                                  .x_k = none,
                                  .x_k_small_psi = none,
                                  .x_k_zero_slope = none,
                                  .mu_s_exact_v_plus = none,
                                  .alpha_f = none,
                                  .tan_alpha_f = none,
                                  .chi_v_minus = none,
                                  .chi_v_plus = none,
                                  .xi_count = n };

    for (size_t i = 0; i < n; i++)
        e.xi[i] = (struct xi_number){ xi[i], none, none, none, none };
    return e;
}

static const char no_angle[] = "(42) takes 2 eta above 1e-16";

struct maker {
    const struct material *m;
    const struct estimates *e;
    double tan_alpha;
    double unsure; /* error of ln v_sp0 */
    double unit;   /* relative error of what hangs on psi_sp0 */
};

static void add_chi(const struct maker *k, struct estimate_numbers *out)
{
    const bool there =
        quantity_exists(&out->v_sp0) && quantity_exists(&out->psi_sp0);
    struct estimates_root root[2];

    if (there)
        out->chi_roots =
            estimates_chi(k->m, k->e, k->tan_alpha, k->unsure, root);
    out->chi_v_minus = out->chi_v_plus = quantity_none(
        !there                ? beyond
        : out->chi_roots == 0 ? "chi(v) = 1 has no root"
                              : "both roots of chi(v) = 1 lie on one side of "
                                "v_sp");
    for (size_t i = 0; i < out->chi_roots; i++) {
        const double x = root[i].x;
        out->chi_root[i] =
            number(k->e->v_sp0 * exp(x),
                   expm1(k->unsure + root[i].error) + 4.0 * DBL_EPSILON);
        if (x < 0.0)
            out->chi_v_minus = out->chi_root[i];
        else if (!quantity_exists(&out->chi_v_plus))
            out->chi_v_plus = out->chi_root[i];
    }
}

/* What hangs on a root x, if there is one. */
static struct quantity of_root(double x, double value, double relative)
{
    return isnan(x) ? quantity_none(no_root) : number(value, relative);
}

static struct xi_number xi_number(const struct maker *k, double xi)
{
    const struct estimates_xi x = estimates_xi_at(k->m, k->e, k->tan_alpha, xi);
    const struct estimates_strength s = estimates_strength_at(
        k->m, k->tan_alpha, k->e->v_sp0, k->e->x_k, x.plus);
    const double unit = 8.0 * k->unit;

    return (struct xi_number){
        .xi = xi,
        .v_minus = of_root(x.minus, k->e->v_sp0 * exp(x.minus), unit),
        .v_plus = of_root(x.plus, k->e->v_sp0 * exp(x.plus), unit),
        .mu_s = of_root(x.plus, s.mu_s, 4.0 * unit),
        .G = of_root(x.plus, s.G, 4.0 * unit),
    };
}

/* (41) with the exact v_plus: (32) is then the fracture energy, which keeps
 * its digits where v_plus is next to v_sp. */
static struct quantity strength(const struct maker *k, const struct block *b,
                                const struct critical_numbers *c)
{
    const struct quantity *G = &c->fracture_energy;

    if (!quantity_exists(G))
        return quantity_none("there is no v_plus");
    const double x_k = estimates_persistence(k->e->eta, b->at.psi0);
    const double rise = G->value / x_k;
    const double error =
        G->error / x_k + 8.0 * k->unit * rise + DBL_EPSILON * k->tan_alpha;

    return in_range(k->tan_alpha + rise, error);
}

struct estimate_numbers numbers_estimates(const struct block *b,
                                          const double xi[], size_t xi_count,
                                          const struct critical_numbers *c)
{
    const struct material *m = &b->material;
    const double t = (double) b->tan_alpha;
    const size_t n = xi_count < ESTIMATES_XI_MAX ? xi_count : ESTIMATES_XI_MAX;
    struct estimate_numbers out = nothing(xi, n);
    struct estimates e;

    if (!estimates_at(&b->law, m, t, &e))
        return out;
    const double given = (fabs(m->mu_star) + fabs(t)) / (m->b - m->a);
    const double saddle = 4.0 + 2.0 * (given + fabs(e.ln_v_sp0));
    const double lost = given + fabs(e.ln_v_sp0) * (1.0 + e.psi_sp0);
    const struct maker k = { m, &e, t, DBL_EPSILON * saddle,
                             DBL_EPSILON * (4.0 + 2.0 * lost) };
    out.v_sp0 = number(e.v_sp0, k.unsure);
    out.psi_sp0 = number(e.psi_sp0, k.unsure);
    out.x_k = number(e.x_k, 2.0 * k.unsure * (1.0 + e.psi_sp0));
    out.x_k_small_psi = in_range(
        e.x_k_small_psi, 2.0 * k.unsure * (1.0 + fabs(e.x_k_small_psi)));
    out.x_k_zero_slope = in_range(
        e.x_k_zero_slope, 2.0 * k.unsure * (1.0 + fabs(e.x_k_zero_slope)));
    if (isfinite(e.tan_alpha_f)) {
        out.alpha_f = number(e.alpha_f, 8.0 * DBL_EPSILON);
        out.tan_alpha_f = number(e.tan_alpha_f, 8.0 * DBL_EPSILON);
    } else {
        out.alpha_f = out.tan_alpha_f = quantity_none(no_angle);
    }
    out.mu_s_exact_v_plus = strength(&k, b, c);
    add_chi(&k, &out);
    for (size_t i = 0; i < n; i++)
        out.xi[i] = xi_number(&k, xi[i]);
    return out;
}
