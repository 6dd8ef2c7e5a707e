#include "report_rabinowicz.h"

#include <math.h>

/* ---- forward ------------------------------------------------------------- */

static void print_cell(FILE *out, const struct quantity *q)
{
    if (quantity_exists(q))
        fprintf(out, " %12.6g", q->value);
    else
        fprintf(out, " %12s", "-");
}

/* Why a column has gaps, once for each reason in a row. */
static void print_gaps(FILE *out, const struct release *r)
{
    const char *told = NULL;

    for (size_t i = 0; i < r->rows; i++) {
        const struct quantity *q[] = { &r->row[i].v_k, &r->row[i].l_k,
                                       &r->row[i].l_k_33, &r->row[i].s_k_30 };
        for (size_t k = 0; k < sizeof q / sizeof *q; k++) {
            if (quantity_exists(q[k]) || q[k]->reason == told)
                continue;
            told = q[k]->reason;
            fprintf(out, "  - at tan alpha %g: %s\n", r->row[i].tan_alpha,
                    told);
        }
    }
}

static void print_rows(FILE *out, const struct release *r)
{
    if (quantity_exists(&r->K))
        fprintf(out, "K = %.15g\n", r->K.value);
    else
        fprintf(out, "K: %s\n", r->K.reason);
    fprintf(out, "critical release distances l_k and slips s_k (m), slip rate "
                 "v_k (m/s)\n");
    fprintf(out, "%10s %12s %12s %12s %12s %12s %12s\n", "tan alpha", "v_k",
            "l_k", "l_k (32)", "l_k (33)", "s_k", "s_k (30)");
    for (size_t i = 0; i < r->rows; i++) {
        const struct release_row *row = &r->row[i];
        fprintf(out, "%10.6g", row->tan_alpha);
        print_cell(out, &row->v_k);
        print_cell(out, &row->l_k);
        print_cell(out, &row->l_k_G);
        print_cell(out, &row->l_k_33);
        print_cell(out, &row->s_k);
        print_cell(out, &row->s_k_30);
        fprintf(out, "\n");
    }
    print_gaps(out, r);
}

/* ---- inverse ------------------------------------------------------------- */

static void print_fitted(FILE *out, const char *name, const struct quantity *q,
                         double deviation, double low, double high,
                         const char *unit)
{
    if (!quantity_exists(q))
        fprintf(out, "  %-8s -  (%s)\n", name, q->reason);
    else
        fprintf(out, "  %-8s %-13.7g +- %-9.2g 95 %%: %.6g .. %.6g%s\n", name,
                q->value, deviation, low, high, unit);
}

static void print_quality(FILE *out, double chi2, int64_t freedom,
                          double chance, double scatter, const char *warning)
{
    if (!isnan(scatter))
        fprintf(out, "  scatter  %.3g %% of a value\n", 100.0 * scatter);
    if (!isnan(chance))
        fprintf(out,
                "  chi2     %.4g with %lld degrees of freedom, chance "
                "%.3g\n",
                chi2, (long long) freedom, chance);
    if (warning)
        fprintf(out, "  warning: %s\n", warning);
}

static void print_parabola(FILE *out, const struct release *r)
{
    const struct parabola *p = &r->parabola;
    const struct release_material *m = &r->material;

    fprintf(out,
            "fit of (33) to %lld release distances (+-: one standard "
            "deviation)\n",
            (long long) p->points);
    print_fitted(out, "mu_s", &p->mu_s, p->mu_s_deviation, p->mu_s_low,
                 p->mu_s_high, "");
    print_fitted(out, "mu_half", &p->mu_half, p->mu_half_deviation,
                 p->mu_half_low, p->mu_half_high, "  = mu_ss(V_star/2)");
    print_fitted(out, "factor", &p->factor, p->factor_deviation, p->factor_low,
                 p->factor_high, " m  = eta L/(K (b - a))");
    print_fitted(out, "L", &m->L, m->L_deviation, m->L_low, m->L_high, " m");
    print_fitted(out, "mu_star", &m->mu_star, m->mu_star_deviation,
                 m->mu_star_low, m->mu_star_high, "");
    print_quality(out, p->chi2, p->freedom, p->chance, p->scatter, p->warning);
}

static void print_persistence(FILE *out, const struct persistence *p)
{
    fprintf(out, "fit of (30) to %lld persistence lengths\n",
            (long long) p->points);
    print_fitted(out, "L", &p->L, p->L_deviation, p->L_low, p->L_high, " m");
    print_fitted(out, "mu_star", &p->mu_star, p->mu_star_deviation,
                 p->mu_star_low, p->mu_star_high, "");
    print_quality(out, p->chi2, p->freedom, p->chance, p->scatter, p->warning);
}

/* Every tenth point: the file holds them all. */
static void print_slip(FILE *out, const struct slip_curve *c)
{
    enum { EACH = 10 };

    if (c->reason) {
        fprintf(out, "friction against slip: %s\n", c->reason);
        return;
    }
    const bool scaled = c->count > 0 && quantity_exists(&c->at[0].s_k);
    fprintf(out,
            "friction against slip (25), smoothing %.3g, %.3g "
            "parameters\n%12s %12s %12s\n",
            c->smoothing, c->freedom, "mu", scaled ? "s_k (m)" : "s_k/K (m)",
            "+- (95 %)");
    for (size_t i = 0; i < c->count; i += EACH) {
        const struct slip_point *p = &c->at[i];
        fprintf(out, "%12.6g %12.6g %12.2g\n", p->mu,
                scaled ? p->s_k.value : p->gradient,
                scaled ? p->s_k.error : p->gradient_error);
    }
}

void report_rabinowicz_print(FILE *out, const struct release *r)
{
    print_rows(out, r);
    if (r->parabola.points > 0) {
        print_parabola(out, r);
        print_slip(out, &r->slip);
    }
    if (r->persistence.points > 0)
        print_persistence(out, &r->persistence);
}
