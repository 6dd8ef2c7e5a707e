/* ln chi rather than chi, which leaves the range of a double below v = 1/700;
 * psi_sp0 - 1/v and the force both vanish at v_sp0, so both are written in x =
 * ln(v/v_sp0). */
#include "chi_curve.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "estimate_numbers.h"
#include "numbers_tolerance.h"

const struct record_type record_chi_slope =
    RECORD(chi_slope, "chi", "chi(v) of (34), Fig 10",
           FIELD(chi_slope, REAL, alpha, "rad", "slope angle"),
           FIELD(chi_slope, QUANTITY, v_sp0, "V_star",
                 "slip rate of the saddle, (29)"),
           FIELD(chi_slope, QUANTITY, v_low, "V_star",
                 "lower root of chi(v) = 1, (34)"),
           FIELD(chi_slope, QUANTITY, v_high, "V_star",
                 "upper root of chi(v) = 1, (34)"));

/* ---- one slope ----------------------------------------------------------- */

/* What does not depend on v. */
struct chi_terms {
    double ln_v_sp0, error; /* and its absolute error */
    double psi_sp0;
    double constant; /* ln(eps^2/(eta a cos alpha psi_sp0)) */
};

static struct chi_terms terms_of(const struct law *law,
                                 const struct material *m, double alpha,
                                 const struct quantity *v_sp0)
{
    const double x = log(v_sp0->value);

    return (struct chi_terms){
        .ln_v_sp0 = x,
        .error = v_sp0->error / v_sp0->value + DBL_EPSILON * fabs(x),
        .psi_sp0 = 1.0 / v_sp0->value,
        .constant =
            log(material_eps2(m) / (law_eta(law, m) * m->a * cos(alpha))) + x,
    };
}

/* ln sinh u, u > 0 */
static double log_sinh(double u)
{
    return u > 1.0 ? u + log(-0.5 * expm1(-2.0 * u)) : log(sinh(u));
}

/* ln(sinh(psi_sp0 - 1/v)/x), of two numbers of the same sign */
static double log_ratio(const struct chi_terms *t, double x)
{
    return x == 0.0 ? log(t->psi_sp0)
                    : log_sinh(fabs(t->psi_sp0 * expm1(-x))) - log(fabs(x));
}

/* Its derivative by ln v_sp0 is below 2 + 2 psi_sp0, that by ln v below 2 + 2
 * psi_sp0 + 2/v: the bar is that times the error of each, and the roundings of
 * the terms. */
static struct quantity ln_chi(const struct chi_terms *t, double v)
{
    const double ln_v = log(v), x = ln_v - t->ln_v_sp0;
    const double ratio = log_ratio(t, x);
    const double bend = 2.0 + 2.0 * t->psi_sp0;
    const double sizes = 4.0 + 2.0 * fabs(ln_v) + fabs(t->ln_v_sp0) +
                         fabs(t->constant) + fabs(ratio);
    const double rounding =
        4.0 * sizes + (bend + 2.0 / v) * (2.0 + fabs(ln_v) + fabs(x));

    return quantity_of(2.0 * ln_v + t->constant + ratio,
                       bend * t->error + DBL_EPSILON * rounding);
}

/* ---- all of them --------------------------------------------------------- */

static struct chi_slope slope_of(const struct law *law,
                                 const struct material *m, double alpha)
{
    static const char no_root[] = "chi(v) = 1 has no root";
    const struct critical_numbers none = numbers_no_critical();
    struct block b;

    block_init(&b, law, m, tanl((long double) alpha));
    const struct estimate_numbers e = numbers_estimates(&b, NULL, 0, &none);
    const bool any = e.chi_roots == 2;
    const struct quantity missing =
        quantity_exists(&e.v_sp0) ? quantity_none(no_root) : e.v_sp0;
    return (struct chi_slope){
        .alpha = alpha,
        .v_sp0 = e.v_sp0,
        .v_low = any ? e.chi_root[0] : missing,
        .v_high = any ? e.chi_root[1] : missing,
    };
}

static void fill_row(const struct law *law, const struct material *m,
                     struct chi_curves *c, size_t row)
{
    const struct chi_slope *s = &c->slope[row];
    const bool any = quantity_exists(&s->v_sp0) && s->v_sp0.value > 0.0;
    struct chi_terms t = { 0 };

    if (any)
        t = terms_of(law, m, s->alpha, &s->v_sp0);
    for (size_t i = 0; i < c->points; i++) {
        const struct quantity q =
            any ? ln_chi(&t, c->v[i]) : quantity_none(s->v_sp0.reason);
        c->ln_chi[row * c->points + i] = q.value;
        c->error[row * c->points + i] = q.error;
    }
}

static enum status make_room(struct chi_curves *c, size_t slopes)
{
    *c = (struct chi_curves){ .slopes = slopes, .points = STUDY_CURVE_POINTS };
    c->slope = malloc(slopes * sizeof *c->slope);
    c->v = malloc(c->points * sizeof *c->v);
    c->ln_chi = malloc(slopes * c->points * sizeof *c->ln_chi);
    c->error = malloc(slopes * c->points * sizeof *c->error);
    if (c->slope && c->v && c->ln_chi && c->error)
        return STATUS_OK;
    chi_curves_free(c);
    return STATUS_NO_MEMORY;
}

void chi_curves_points(const double range[2], double v[])
{
    const double last = STUDY_CURVE_POINTS - 1;
    const double length = log(range[1]) - log(range[0]);

    for (size_t i = 0; i < STUDY_CURVE_POINTS; i++)
        v[i] = exp(log(range[0]) + (double) i / last * length);
    v[0] = range[0];
    v[STUDY_CURVE_POINTS - 1] = range[1];
}

enum status chi_curves_find(const struct law *law, const struct material *m,
                            const double alpha[], size_t slopes,
                            const double v[2], struct chi_curves *c)
{
    const enum status status = make_room(c, slopes);
    const char *reason = NULL;
    bool any = false;

    if (status != STATUS_OK)
        return status;
    chi_curves_points(v, c->v);
    for (size_t k = 0; k < slopes; k++) {
        c->slope[k] = slope_of(law, m, alpha[k]);
        fill_row(law, m, c, k);
        any |= quantity_exists(&c->slope[k].v_sp0);
        reason = c->slope[k].v_sp0.reason;
    }
    c->reason = any ? NULL : reason;
    return STATUS_OK;
}

void chi_curves_free(struct chi_curves *c)
{
    free(c->slope);
    free(c->v);
    free(c->ln_chi);
    free(c->error);
    *c = (struct chi_curves){ .slope = NULL };
}
