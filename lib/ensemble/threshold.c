/* Least squares by Householder's QR (GSL): of powers, whose normal equations
 * would square their condition. */
#include "threshold.h"

#include <gsl/gsl_linalg.h>
#include <math.h>

#include "tolerance.h"

/* ---- the polynomial ------------------------------------------------------ */

/* Of as many whole degrees as there is room for: a term of the next degree is
 * one of the last times a variable that is not before its own last. */
static void set_terms(struct threshold *t, size_t most)
{
    size_t from = 0, n = 1;

    while (from < n) {
        const size_t to = n;
        for (size_t i = from; i < to; i++)
            for (size_t v = t->by[i]; v < t->scores; v++, n++) {
                if (n >= most)
                    return;
                t->of[n] = (uint16_t) i;
                t->by[n] = (uint16_t) v;
            }
        t->terms = n;
        from = to;
    }
}

/* Of m in its scale, and the scores but the pivot. */
static void terms_at(const struct threshold *t, double m, const double z[],
                     double out[])
{
    double x[SCENE_SPREADS] = { m };

    for (size_t k = 0, n = 1; k < t->scores; k++)
        if (k != t->pivot)
            x[n++] = z[k];
    out[0] = 1.0;
    for (size_t i = 1; i < t->terms; i++)
        out[i] = out[t->of[i]] * x[t->by[i]];
}

double threshold_at(const struct threshold *t, const double z[])
{
    double term[THRESHOLD_TERMS], sum = 0.0;

    terms_at(t, 0.0, z, term);
    for (size_t i = 0; i < t->terms; i++)
        sum += t->coefficient[i] * term[i];
    return sum;
}

/* ---- the fit ------------------------------------------------------------- */

/* The score of the largest correlation with m. */
static size_t find_pivot(const double row[], size_t count, size_t scores)
{
    size_t best = 0;
    double most = -1.0, mean = 0.0;

    for (size_t i = 0; i < count; i++)
        mean += row[i * (1 + scores)] / (double) count;
    for (size_t k = 0; k < scores; k++) {
        double both = 0.0, own = 0.0;
        for (size_t i = 0; i < count; i++) {
            const double *r = row + i * (1 + scores);
            both += (r[0] - mean) * r[1 + k];
            own += r[1 + k] * r[1 + k];
        }
        if (both * both / own > most) {
            most = both * both / own;
            best = k;
        }
    }
    return best;
}

static void solve(struct threshold *t, const double row[], gsl_matrix *a,
                  gsl_vector *right, gsl_vector *left, gsl_vector *tau)
{
    const size_t count = a->size1;
    gsl_vector_view out = gsl_vector_view_array(t->coefficient, t->terms);
    double squares = 0.0;

    for (size_t i = 0; i < count; i++)
        squares += pow(row[i * (1 + t->scores)], 2) / (double) count;
    for (size_t i = 0; i < count; i++) {
        const double *r = row + i * (1 + t->scores);
        const double m = r[0] / sqrt(squares), weight = 1.0 / (1.0 + m * m);
        gsl_vector_view terms = gsl_matrix_row(a, i);
        terms_at(t, m, r + 1, terms.vector.data);
        gsl_vector_scale(&terms.vector, weight);
        gsl_vector_set(right, i, r[1 + t->pivot] * weight);
    }
    gsl_linalg_QR_decomp(a, tau);
    gsl_linalg_QR_lssolve(a, tau, right, &out.vector, left);
    for (size_t k = 0; k < t->terms; k++)
        t->there &= isfinite(t->coefficient[k]);
}

enum status threshold_fit(struct threshold *t, const double row[], size_t count,
                          size_t scores)
{
    const size_t most = count / THRESHOLD_ROWS;

    *t = (struct threshold){ .scores = scores };
    set_terms(t, most < THRESHOLD_TERMS ? most : THRESHOLD_TERMS);
    if (t->terms <= 1)
        return STATUS_OK;
    gsl_matrix *a = gsl_matrix_alloc(count, t->terms);
    gsl_vector *right = gsl_vector_alloc(count),
               *left = gsl_vector_alloc(count);
    gsl_vector *tau = gsl_vector_alloc(t->terms);
    t->there = a && right && left && tau;
    const bool good = t->there;
    t->pivot = find_pivot(row, count, scores);
    if (good)
        solve(t, row, a, right, left, tau);
    gsl_matrix_free(a);
    gsl_vector_free(right);
    gsl_vector_free(left);
    gsl_vector_free(tau);
    return good ? STATUS_OK : STATUS_NO_MEMORY;
}
