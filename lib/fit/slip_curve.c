/* Penalised splines: more cubic B-splines than the data can fix, and the third
 * derivative, constant on each piece, kept small (after Eilers & Marx, Stat.
 * Sci. 11, 1996, 89-121, whose differences we replace by the derivative, for
 * then the smoothest curves are parabolas, as (33) is; and measure it by the
 * height of the curve, which falls by decades).  Smoothing by cross-validation,
 * errors by the Bayesian covariance, which on average holds the bias
 * (Wahba, J. R. Stat. Soc. B 45, 1983, 133-150). */
#include "slip_curve.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_bspline.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>

#include "tolerance.h"

const struct record_type record_slip_point =
    RECORD(slip_point, "slip", "friction against slip, (25)",
           FIELD(slip_point, REAL, mu, "1", "friction coefficient = tan alpha"),
           FIELD(slip_point, REAL, release, "m", "l_k tan alpha, smoothed"),
           FIELD(slip_point, REAL, release_error, "m",
                 "95 % bound on the error of release"),
           FIELD(slip_point, REAL, gradient, "m",
                 "-d(l_k tan alpha)/d(tan alpha) = s_k/K"),
           FIELD(slip_point, REAL, gradient_error, "m",
                 "95 % bound on the error of gradient"),
           FIELD(slip_point, QUANTITY, s_k, "m",
                 "slip (25) at which friction is mu (95 %)"));

enum { ORDER = 4, PIECES = 16, COEFFICIENTS = PIECES + ORDER - 1 };

/* ---- the spline ---------------------------------------------------------- */

struct smoother {
    const struct measured *m;
    double lo, hi;                /* of tan alpha */
    double total;                 /* sum of the weights */
    gsl_bspline_workspace *basis; /* owned */
    gsl_matrix *derivatives;      /* owned; of each B-spline at one point */
    gsl_matrix *gram, *rough;     /* owned; of data and third derivatives */
    gsl_matrix *inverse;          /* owned; of gram + smoothing rough */
    gsl_vector *moment;           /* owned; right-hand side */
    gsl_vector *c;                /* owned; coefficients */
};

static void smoother_free(struct smoother *s)
{
    gsl_bspline_free(s->basis);
    gsl_matrix_free(s->derivatives);
    gsl_matrix_free(s->gram);
    gsl_matrix_free(s->rough);
    gsl_matrix_free(s->inverse);
    gsl_vector_free(s->moment);
    gsl_vector_free(s->c);
}

/* The B-splines' derivatives of this order at u; valid until the next call. */
static gsl_vector_view derivatives_at(struct smoother *s, double u,
                                      size_t order)
{
    gsl_bspline_deriv_eval(u, order, s->derivatives, s->basis);
    return gsl_matrix_column(s->derivatives, order);
}

static enum status smoother_init(struct smoother *s, const struct measured *m)
{
    const size_t n = COEFFICIENTS;

    *s = (struct smoother){ .m = m, .lo = m->x[0], .hi = m->x[0] };
    for (size_t i = 1; i < m->count; i++) {
        s->lo = fmin(s->lo, m->x[i]);
        s->hi = fmax(s->hi, m->x[i]);
    }
    s->basis = gsl_bspline_alloc(ORDER, PIECES + 1);
    s->derivatives = gsl_matrix_alloc(n, ORDER);
    s->gram = gsl_matrix_alloc(n, n);
    s->rough = gsl_matrix_alloc(n, n);
    s->inverse = gsl_matrix_alloc(n, n);
    s->moment = gsl_vector_alloc(n);
    s->c = gsl_vector_alloc(n);
    if (!s->basis || !s->derivatives || !s->gram || !s->rough || !s->inverse ||
        !s->moment || !s->c)
        return STATUS_NO_MEMORY;
    gsl_bspline_knots_uniform(0.0, 1.0, s->basis);
    return STATUS_OK;
}

static double unit_of(const struct smoother *s, double tan_alpha)
{
    return fmin(1.0, (tan_alpha - s->lo) / (s->hi - s->lo));
}

/* The curve (order 0) or its derivatives by u. */
static double spline_at(struct smoother *s, double u, size_t order)
{
    const gsl_vector_view b = derivatives_at(s, u, order);
    double y;

    gsl_blas_ddot(&b.vector, s->c, &y);
    return y;
}

/* Its standard deviation where that of a datum of weight one is one. */
static double deviation_at(struct smoother *s, double u, size_t order)
{
    const gsl_vector_view b = derivatives_at(s, u, order);
    double variance = 0.0;

    for (size_t i = 0; i < COEFFICIENTS; i++)
        for (size_t k = 0; k < COEFFICIENTS; k++)
            variance += gsl_vector_get(&b.vector, i) *
                        gsl_matrix_get(s->inverse, i, k) *
                        gsl_vector_get(&b.vector, k);
    return sqrt(variance / s->total);
}

/* Third derivatives are constant on each piece.  With `again` they count in
 * units of the curve so far, for it may bend as much as it is high. */
static void fill_rough(struct smoother *s, bool again)
{
    double weight[PIECES], total = 0.0, top = 0.0;

    for (int i = 0; i < PIECES; i++) {
        weight[i] = again ? spline_at(s, (i + 0.5) / PIECES, 0) : 1.0;
        top = fmax(top, weight[i]);
    }
    for (int i = 0; i < PIECES; i++) {
        const double y = fmax(weight[i], FIT_FLAT * top);
        weight[i] = 1.0 / (y * y);
        total += weight[i];
    }
    gsl_matrix_set_zero(s->rough);
    for (int i = 0; i < PIECES; i++) {
        const gsl_vector_view third = derivatives_at(s, (i + 0.5) / PIECES, 3);
        gsl_blas_dsyr(CblasLower, weight[i] / total, &third.vector, s->rough);
    }
}

/* ---- smoothing ----------------------------------------------------------- */

static double weight_of(const struct measured *m, size_t i, double y)
{
    const double error = m->error ? m->error[i] * m->x[i] : y;

    return 1.0 / (error * error);
}

/* Gram matrix and moments; with `again` weights come from the curve so far. */
static void fill_gram(struct smoother *s, bool again)
{
    const struct measured *m = s->m;
    double total = 0.0;

    gsl_matrix_set_zero(s->gram);
    gsl_vector_set_zero(s->moment);
    for (size_t i = 0; i < m->count; i++) {
        const double u = unit_of(s, m->x[i]), y = m->value[i] * m->x[i];
        const double now = again ? spline_at(s, u, 0) : y;
        const double weight =
            weight_of(m, i, now > FIT_WEIGHT_LEAST * y ? now : y);
        const gsl_vector_view b = derivatives_at(s, u, 0);
        gsl_blas_dsyr(CblasLower, weight, &b.vector, s->gram);
        gsl_blas_daxpy(weight * y, &b.vector, s->moment);
        total += weight;
    }
    s->total = total;
    gsl_matrix_scale(s->gram, 1.0 / total);
    gsl_vector_scale(s->moment, 1.0 / total);
}

/* What a smoothing costs and leaves. */
struct balance {
    double freedom; /* trace of the matrix that maps data to the curve */
    double left;    /* weighted sum of squares */
};

static double trace_of_product(const gsl_matrix *full, const gsl_matrix *lower)
{
    double sum = 0.0;

    for (size_t i = 0; i < COEFFICIENTS; i++)
        for (size_t k = 0; k <= i; k++)
            sum += (i == k ? 1.0 : 2.0) * gsl_matrix_get(full, i, k) *
                   gsl_matrix_get(lower, i, k);
    return sum;
}

static double left_over(struct smoother *s)
{
    double sum = 0.0;

    for (size_t i = 0; i < s->m->count; i++) {
        const double y = s->m->value[i] * s->m->x[i];
        const double now = spline_at(s, unit_of(s, s->m->x[i]), 0);
        const double weight = weight_of(s->m, i, y);
        sum += weight * (y - now) * (y - now);
    }
    return sum;
}

static enum status smooth(struct smoother *s, double smoothing,
                          struct balance *b)
{
    gsl_matrix *a = s->inverse;

    gsl_matrix_memcpy(a, s->rough);
    gsl_matrix_scale(a, smoothing);
    gsl_matrix_add(a, s->gram);
    if (gsl_linalg_cholesky_decomp1(a) != GSL_SUCCESS)
        return STATUS_NO_CONVERGENCE;
    gsl_linalg_cholesky_solve(a, s->moment, s->c);
    gsl_linalg_cholesky_invert(a);
    b->freedom = trace_of_product(a, s->gram);
    b->left = left_over(s);
    return STATUS_OK;
}

/* The score of cross-validation; infinite where nothing would be left. */
static double score_of(const struct balance *b, size_t count)
{
    const double rest = (double) count - b->freedom;

    return rest > 0.0 ? b->left / (rest * rest) : (double) INFINITY;
}

/* From smooth to rough; the smoothest of the best. */
static enum status choose(struct smoother *s, double *smoothing)
{
    double best = (double) INFINITY;
    enum status status = STATUS_OK;

    *smoothing = FIT_SMOOTHEST;
    for (double x = FIT_SMOOTHEST; x >= FIT_ROUGHEST && status == STATUS_OK;
         x /= FIT_SMOOTHER) {
        struct balance b;
        status = smooth(s, x, &b);
        if (status == STATUS_OK && score_of(&b, s->m->count) < best) {
            best = score_of(&b, s->m->count);
            *smoothing = x;
        }
    }
    return status;
}

static enum status smooth_all(struct smoother *s, double smoothing,
                              struct slip_curve *out, struct balance *b)
{
    enum status status = STATUS_OK;

    for (int pass = 0; pass < 2 && status == STATUS_OK; pass++) {
        fill_rough(s, pass > 0);
        fill_gram(s, pass > 0);
        out->smoothing = smoothing;
        if (smoothing == 0.0)
            status = choose(s, &out->smoothing);
        if (status == STATUS_OK)
            status = smooth(s, out->smoothing, b);
    }
    return status;
}

/* How far the 95 % interval of a unit variance reaches. */
static double reach_of(const struct measured *m, const struct balance *b)
{
    const double rest = (double) m->count - b->freedom;

    return m->error ? gsl_cdf_ugaussian_Qinv(FIT_TAIL)
                    : gsl_cdf_tdist_Qinv(FIT_TAIL, rest) * sqrt(b->left / rest);
}

/* ---- the curve ----------------------------------------------------------- */

static void sample(struct smoother *s, double K, double reach,
                   struct slip_curve *out)
{
    const double range = s->hi - s->lo;

    for (size_t i = 0; i < out->count; i++) {
        const double u = (double) i / (double) (out->count - 1);
        struct slip_point *p = &out->at[i];
        p->mu = s->lo + u * range;
        p->release = spline_at(s, u, 0);
        p->release_error = reach * deviation_at(s, u, 0);
        p->gradient = -spline_at(s, u, 1) / range;
        p->gradient_error = reach * deviation_at(s, u, 1) / range;
        p->s_k = K > 0.0 ? quantity_of(K * p->gradient, K * p->gradient_error)
                         : quantity_none("K of (22) is not known: masses and "
                                         "restitution are not given");
    }
}

enum status slip_curve_fit(const struct measured *m, double K, double smoothing,
                           struct slip_curve *out)
{
    struct smoother s;
    struct balance b;

    *out = (struct slip_curve){ .at = NULL };
    if (!least_has_places(m, LEAST_MAX + 1)) {
        out->smoothing = out->freedom = (double) NAN;
        out->reason = "too few slopes: a curve needs four different ones";
        return STATUS_OK;
    }
    enum status status = smoother_init(&s, m);
    if (status == STATUS_OK)
        status = smooth_all(&s, smoothing, out, &b);
    if (status == STATUS_OK &&
        (out->at = calloc(FIT_SLIP_POINTS, sizeof *out->at)) == NULL)
        status = STATUS_NO_MEMORY;
    if (status == STATUS_OK) {
        out->count = FIT_SLIP_POINTS;
        out->freedom = b.freedom;
        sample(&s, K, reach_of(m, &b), out);
    }
    smoother_free(&s);
    if (status != STATUS_OK)
        slip_curve_free(out);
    return status;
}

void slip_curve_free(struct slip_curve *c)
{
    free(c->at);
    *c = (struct slip_curve){ .at = NULL };
}
