/* Levenberg-Marquardt trust region, GSL's (More, Lect. Notes Math. 630, 1978,
 * 105-116).  Weights that depend on the fit: iteratively reweighted least
 * squares (Wedderburn, Biometrika 61, 1974, 439-447). */
#include "least.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <math.h>
#include <stdlib.h>

#include "tolerance.h"

/* ---- what GSL calls ------------------------------------------------------ */

struct problem {
    least_model *model;
    const void *ctx;
    const struct measured *m;
    size_t parameters;
};

static void evaluate(const struct problem *q, const gsl_vector *p, size_t i,
                     double *value, double gradient[])
{
    double at[LEAST_MAX] = { 0.0 };

    for (size_t k = 0; k < q->parameters; k++)
        at[k] = gsl_vector_get(p, k);
    q->model(q->ctx, q->m->x[i], at, value, gradient);
}

static int residuals(const gsl_vector *p, void *problem, gsl_vector *f)
{
    const struct problem *q = problem;
    double value, gradient[LEAST_MAX];

    for (size_t i = 0; i < q->m->count; i++) {
        evaluate(q, p, i, &value, gradient);
        gsl_vector_set(f, i, value - q->m->value[i]);
    }
    return GSL_SUCCESS;
}

static int jacobian(const gsl_vector *p, void *problem, gsl_matrix *J)
{
    const struct problem *q = problem;
    double value, gradient[LEAST_MAX];

    for (size_t i = 0; i < q->m->count; i++) {
        evaluate(q, p, i, &value, gradient);
        for (size_t k = 0; k < q->parameters; k++)
            gsl_matrix_set(J, i, k, gradient[k]);
    }
    return GSL_SUCCESS;
}

/* ---- weights ------------------------------------------------------------- */

static double weight_of(const struct measured *m, size_t i, double value)
{
    const double error = m->error ? m->error[i] : value;

    return 1.0 / (error * error);
}

/* From the fitted curve, where that is as positive as what was measured. */
static void weigh_again(const struct problem *q, const gsl_vector *p,
                        gsl_vector *weight)
{
    double value, gradient[LEAST_MAX];

    for (size_t i = 0; i < q->m->count; i++) {
        evaluate(q, p, i, &value, gradient);
        if (value > FIT_WEIGHT_LEAST * q->m->value[i])
            gsl_vector_set(weight, i, weight_of(q->m, i, value));
    }
}

/* ---- the fit ------------------------------------------------------------- */

/* No step that helps is left: the start was the solution. */
static enum status solve(gsl_multifit_nlinear_workspace *w,
                         gsl_multifit_nlinear_fdf *fdf, const gsl_vector *p,
                         const gsl_vector *weight)
{
    int info = 0;

    if (gsl_multifit_nlinear_winit(p, weight, fdf, w) != GSL_SUCCESS)
        return STATUS_NO_CONVERGENCE;
    const int s =
        gsl_multifit_nlinear_driver(FIT_ITERATIONS, FIT_TOLERANCE,
                                    FIT_TOLERANCE, 0.0, NULL, NULL, &info, w);
    return s == GSL_SUCCESS || info == GSL_ENOPROG ? STATUS_OK
                                                   : STATUS_NO_CONVERGENCE;
}

static enum status solve_all(gsl_multifit_nlinear_workspace *w,
                             struct problem *q, gsl_vector *weight,
                             struct least *fit)
{
    gsl_multifit_nlinear_fdf fdf = { .f = residuals,
                                     .df = jacobian,
                                     .n = q->m->count,
                                     .p = q->parameters,
                                     .params = q };
    const int passes = q->m->error ? 1 : FIT_PASSES;
    enum status s = STATUS_OK;

    for (int pass = 0; pass < passes && s == STATUS_OK; pass++) {
        const gsl_vector_view p =
            gsl_vector_view_array(fit->p, fit->parameters);
        if (pass > 0)
            weigh_again(q, &p.vector, weight);
        s = solve(w, &fdf, &p.vector, weight);
        for (size_t k = 0; k < fit->parameters; k++)
            fit->p[k] = gsl_vector_get(w->x, k);
    }
    return s;
}

/* Covariance, scatter and what an interval takes. */
static enum status judge(gsl_multifit_nlinear_workspace *w,
                         const struct measured *m, struct least *fit)
{
    double entries[LEAST_MAX * LEAST_MAX];
    const size_t n = fit->parameters;
    gsl_matrix_view c = gsl_matrix_view_array(entries, n, n);
    const gsl_vector *f = gsl_multifit_nlinear_residual(w);

    gsl_multifit_nlinear_covar(gsl_multifit_nlinear_jac(w), 0.0, &c.matrix);
    fit->chi2 = 0.0;
    for (size_t i = 0; i < m->count; i++)
        fit->chi2 += gsl_vector_get(f, i) * gsl_vector_get(f, i);
    fit->freedom = m->count - n;
    const double freedom = (double) fit->freedom;
    const double variance = m->error ? 1.0 : fit->chi2 / freedom;
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++)
            fit->covariance[i][k] = variance * entries[i * n + k];
    fit->scatter = m->error ? (double) NAN : sqrt(variance);
    fit->quantile = m->error ? gsl_cdf_ugaussian_Qinv(FIT_TAIL)
                             : gsl_cdf_tdist_Qinv(FIT_TAIL, freedom);
    fit->chance = !m->error          ? (double) NAN
                  : fit->freedom > 0 ? gsl_cdf_chisq_Q(fit->chi2, freedom)
                                     : 1.0;
    return isfinite(fit->chi2) && isfinite(fit->covariance[0][0])
               ? STATUS_OK
               : STATUS_NO_CONVERGENCE;
}

enum status least_fit(least_model *model, const void *ctx,
                      const struct measured *m, struct least *fit)
{
    const gsl_multifit_nlinear_parameters how =
        gsl_multifit_nlinear_default_parameters();
    struct problem q = { model, ctx, m, fit->parameters };
    enum status s = STATUS_NO_MEMORY;

    if (m->count < fit->parameters + (m->error ? 0 : 1))
        return STATUS_BAD_ARGUMENT;
    gsl_vector *weight = gsl_vector_alloc(m->count);
    gsl_multifit_nlinear_workspace *w = gsl_multifit_nlinear_alloc(
        gsl_multifit_nlinear_trust, &how, m->count, fit->parameters);
    if (weight == NULL || w == NULL)
        goto out;
    for (size_t i = 0; i < m->count; i++)
        gsl_vector_set(weight, i, weight_of(m, i, m->value[i]));
    s = solve_all(w, &q, weight, fit);
    if (s == STATUS_OK)
        s = judge(w, m, fit);
out:
    gsl_multifit_nlinear_free(w);
    gsl_vector_free(weight);
    return s;
}

/* ---- where to start ------------------------------------------------------ */

enum status least_line(const struct measured *m, struct least_line *line)
{
    double *weight = malloc(m->count * sizeof *weight), unused;

    if (weight == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < m->count; i++)
        weight[i] = weight_of(m, i, m->value[i]);
    gsl_fit_wlinear(m->x, 1, weight, 1, m->value, 1, m->count, &line->at_zero,
                    &line->slope, &unused, &unused, &unused, &unused);
    free(weight);
    return STATUS_OK;
}

bool least_has_places(const struct measured *m, size_t places)
{
    double seen[LEAST_MAX + 1];
    size_t count = 0;

    for (size_t i = 0; i < m->count && count < places; i++) {
        size_t k = 0;
        while (k < count && seen[k] != m->x[i])
            k++;
        if (k == count)
            seen[count++] = m->x[i];
    }
    return count == places;
}
