/* Hairer & Wanner, Solving ODEs II (1996): the method, sec. IV.5; simplified
 * Newton iteration on the eigenvectors of A^-1, its stopping and the error
 * estimate, sec. IV.8.  Changed: J has two columns only, so the iteration is
 * about the plane and the integrals are a quadrature of the stages, which the
 * last iteration corrects like the stages; the gradients are from the middle of
 * the step, which saves a fifth of the iterations. */
#include "radau.h"

#include <float.h>
#include <math.h>

#include "tolerance.h"

enum { STAGES = RADAU_STAGES, PAIRS = STAGES / 2, COEFS = RADAU_DEGREE + 1 };

/* The method: zeros of the right Radau polynomial.  All other tables follow
 * from them; test_radau.c holds every one to that. */
static const double node[STAGES] = { 0.0571041961145176822,
                                     0.276843013638123828, 0.58359043236891682,
                                     0.860240135656219448, 1.0 };

/* Row j: coefficient j of the polynomials that are 1 at one node and 0 at the
 * others. */
static const double monomial[STAGES][STAGES] = {
    { 1.58640790018632825, -1.00811788149837299, 0.730974866159787461,
      -0.509264884847742722, 0.2 },
    { -11.8792635605935689, 21.5614685394101116, -17.0218239328255678,
      12.1396189540090252, -4.8 },
    { 29.9333277270479011, -73.3343061696381205, 80.4788156061384224,
      -62.277837163548203, 25.2 },
    { -31.0548810957230558, 87.9463449562041943, -117.938298751790827,
      105.846834891309689, -44.8 },
    { 11.4144090290823954, -35.1653894444778123, 53.7503322123181851,
      -55.1993517969227681, 25.2 }
};

struct complex {
    double re, im;
};

/* Eigenvalues of A^-1: one real, and one of each pair. */
static const double real_value = 6.28670475172927665;

static const struct complex pair_value[PAIRS] = {
    { 5.70095329867178942, 3.21026560030854989 },
    { 3.65569432546357226, 6.54373689936007729 },
};

/* To its eigenvectors, real and imaginary parts of a pair in two rows; and
 * back, the conjugates included. */
static const double part[STAGES][STAGES] = {
    { 27.6976937756840884, 12.783337911304406, 3.20848938671342986,
      -0.951490412248916221, 0.741550496025989603 },
    { -16.5209401067595, -8.68847673953178351, -0.0860645316270027806,
      -0.0495848889912713213, 0.265614057919153334 },
    { -4.30572198993764599, 4.84999570476440412, 0.957364319848437142,
      1.20934600304247001, -0.523731743967668709 },
    { 2.6720932189174558, 2.2968077838795805, -1.51818016172971215,
      0.525330095115729432, -0.136389305932148135 },
    { 1.87402990371990243, -1.99248286817194233, -0.522207820804009396,
      0.592049284068974244, -0.224958885078390184 }
};

static const double whole[STAGES][STAGES] = {
    { 0.0135768673449479432, -0.0229570305104590294, -0.0280397177857508206,
      -0.0204840956358176541, 0.0953477545805914477 },
    { 1.61790040171908748e-3, -0.0153376614983603258, 0.0494171568530370536,
      0.100345729034742116, -0.188663638363222874 },
    { 0.0791578533474472076, 0.0387969279976579018, 0.163600707407502342,
      -0.461079068086835893, 0.2054060907602518 },
    { 0.412256082680461452, 0.815202342560398133, 0.399364855773605052,
      0.755787804497722499, 0.933488260664988719 },
    { 1.0, 2.0, 0.0, 2.0, 0.0 }
};

/* Where the polynomial through the start and the stages is furthest from a
 * smooth curve through them. */
#define PROBE 0.734

void radau_start(struct radau *w, const double du[], double h)
{
    for (size_t i = 0; i < STAGES; i++)
        w->z[i] = vec2_scale(node[i] * h, (struct vec2){ du[0], du[1] });
}

/* What a polynomial, rising from theta = 1, has gained at 1 + t. */
static double gain(const double p[COEFS], double t)
{
    const double theta = 1.0 + t;
    double value = 0.0, end = 0.0;

    for (size_t j = COEFS; j-- > 1;) {
        value = value * theta + p[j];
        end += p[j];
    }
    return value * theta - end;
}

void radau_extend(struct radau *w, const double coef[], double ratio)
{
    for (size_t i = 0; i < STAGES; i++) {
        const double t = ratio * node[i];
        w->z[i] = (struct vec2){ gain(coef, t), gain(coef + COEFS, t) };
    }
}

/* out = matrix in */
static void transform(const double matrix[STAGES][STAGES],
                      const struct vec2 in[STAGES], struct vec2 out[STAGES])
{
    for (size_t k = 0; k < STAGES; k++) {
        struct vec2 v = { 0.0, 0.0 };
        for (size_t i = 0; i < STAGES; i++) {
            v.x += matrix[k][i] * in[i].x;
            v.y += matrix[k][i] * in[i].y;
        }
        out[k] = v;
    }
}

static struct complex product(struct complex a, struct complex b)
{
    return (struct complex){ a.re * b.re - a.im * b.im,
                             a.re * b.im + a.im * b.re };
}

static struct complex sum(struct complex a, struct complex b)
{
    return (struct complex){ a.re + b.re, a.im + b.im };
}

static struct complex scaled(double s, struct complex a)
{
    return (struct complex){ s * a.re, s * a.im };
}

/* 1/a, where its square would over- or underflow, too */
static struct complex reciprocal(struct complex a)
{
    const double most = fmax(fabs(a.re), fabs(a.im));
    const double re = a.re / most, im = a.im / most;

    return scaled(1.0 / (most * (re * re + im * im)),
                  (struct complex){ re, -im });
}

/* A complex 2x2 matrix. */
struct matrix {
    struct complex xx, xy, yx, yy;
};

/* The inverse of lambda/h - J, whose parts may be far apart: by their common
 * scale. */
static struct matrix inverse(struct complex lambda, const struct vec2 J[2],
                             double h)
{
    const double size = fabs(J[0].x) + fabs(J[0].y) + fabs(J[1].x) +
                        fabs(J[1].y) + fabs(lambda.re / h);
    const double per = 1.0 / size, xy = per * J[0].y, yx = per * J[1].x;
    const struct complex shift = scaled(per / h, lambda);
    const struct complex p = { shift.re - per * J[0].x, shift.im };
    const struct complex q = { shift.re - per * J[1].y, shift.im };
    struct complex det = product(p, q);
    det.re -= xy * yx;
    const struct complex f = scaled(per, reciprocal(det));

    return (struct matrix){ product(q, f), scaled(xy, f), scaled(yx, f),
                            product(p, f) };
}

/* The iteration about one step, in the eigenvectors' coordinates. */
struct iteration {
    double per_h;
    struct mat2 real;
    struct matrix pair[PAIRS];
    struct vec2 w[STAGES]; /* the stages */
};

/* The inverse for the real eigenvalue. */
static struct mat2 real_inverse(const struct vec2 J[2], double h)
{
    const struct matrix m = inverse((struct complex){ real_value, 0.0 }, J, h);
    return (struct mat2){ m.xx.re, m.xy.re, m.yx.re, m.yy.re };
}

static void prepare(struct iteration *q, const struct vec2 J[2], double h,
                    const struct vec2 z[STAGES])
{
    q->per_h = 1.0 / h;
    q->real = real_inverse(J, h);
    for (size_t k = 0; k < PAIRS; k++)
        q->pair[k] = inverse(pair_value[k], J, h);
    transform(part, z, q->w);
}

/* A pair's g, of the right-hand side, becomes the change of its w: solves
 * (lambda/h - J) dw = g - (lambda/h) w. */
static void solve_pair(const struct iteration *q, size_t k, struct vec2 g[2])
{
    const struct matrix *m = &q->pair[k];
    const struct vec2 *w = &q->w[2 * k + 1];
    const struct complex minus = scaled(-q->per_h, pair_value[k]);
    const struct complex wx = { w[0].x, w[1].x }, wy = { w[0].y, w[1].y };
    const struct complex x =
        sum((struct complex){ g[0].x, g[1].x }, product(minus, wx));
    const struct complex y =
        sum((struct complex){ g[0].y, g[1].y }, product(minus, wy));
    const struct complex dx = sum(product(m->xx, x), product(m->xy, y));
    const struct complex dy = sum(product(m->yx, x), product(m->yy, y));

    g[0] = (struct vec2){ dx.re, dy.re };
    g[1] = (struct vec2){ dx.im, dy.im };
}

static struct vec2 times(struct mat2 m, struct vec2 v)
{
    return (struct vec2){ m.xx * v.x + m.xy * v.y, m.yx * v.x + m.yy * v.y };
}

/* One iteration from the right-hand side at the stages: their change. */
static void iterate(struct iteration *q, const struct vec2 f[STAGES],
                    struct vec2 change[STAGES])
{
    struct vec2 g[STAGES];

    transform(part, f, g);
    const double lambda = real_value * q->per_h;
    g[0] = times(q->real, vec2_sub(g[0], vec2_scale(lambda, q->w[0])));
    for (size_t k = 0; k < PAIRS; k++)
        solve_pair(q, k, &g[2 * k + 1]);
    for (size_t k = 0; k < STAGES; k++)
        q->w[k] = vec2_add(q->w[k], g[k]);
    transform(whole, g, change);
}

/* The largest component; NaN if any is not finite. */
static double largest(const struct vec2 v[STAGES])
{
    double most = 0.0, total = 0.0;

    for (size_t i = 0; i < STAGES; i++) {
        const double x = fabs(v[i].x), y = fabs(v[i].y);
        const double both = x > y ? x : y;
        most = both > most ? both : most;
        total += x + y;
    }
    return isfinite(total) ? most : (double) NAN;
}

static struct vec2 point(const double u[], struct vec2 z)
{
    return (struct vec2){ u[0] + z.x, u[1] + z.y };
}

/* The last iteration: moves the stages, and the rates with them. */
static void complete(struct radau *w, const struct cascade *system,
                     const struct cascade_linear *at, const double u[],
                     const struct vec2 change[STAGES])
{
    for (size_t k = 0; k < STAGES; k++) {
        system->integrals(system->ctx, point(u, w->z[k]), w->du[k]);
        for (size_t i = 0; i < system->dim; i++)
            w->du[k][i] +=
                at->slope[i].x * change[k].x + at->slope[i].y * change[k].y;
        w->z[k] = vec2_add(w->z[k], change[k]);
    }
}

/* The right-hand side at the stages. */
static void evaluate(struct radau *w, const struct cascade *system,
                     const double u[], struct vec2 f[STAGES])
{
    for (size_t k = 0; k < STAGES; k++) {
        system->plane(system->ctx, point(u, w->z[k]), w->du[k]);
        f[k] = (struct vec2){ w->du[k][0], w->du[k][1] };
    }
    w->iterations++;
}

/* What to make of an iteration's change. */
enum verdict { GO_ON, DONE, HOPELESS };

/* `before`: the change of the iteration before, 0 at the first one, which must
 * do with the last step's rate. */
static enum verdict judge(struct radau *w, double change, double before,
                          double tol, double rounding)
{
    const double left = TOL_RADAU_ITERATIONS - (double) w->iterations;

    if (!isfinite(change))
        return HOPELESS;
    if (before > 0.0)
        w->rate = change / before;
    else
        w->rate *= TOL_RADAU_DISTRUST;
    if (change <= rounding || w->rate < TOL_RADAU_LEAST)
        w->rate = TOL_RADAU_LEAST;
    if (change <= rounding)
        return DONE;
    if (w->rate < 1.0 && w->rate / (1.0 - w->rate) * change <= tol)
        return DONE;
    if (before == 0.0)
        return GO_ON;
    return left > 0.0 && w->rate < 1.0 && pow(w->rate, left) * change <= tol
               ? GO_ON
               : HOPELESS;
}

bool radau_solve(struct radau *w, const struct cascade *system,
                 const struct cascade_linear *at, const double u[], double h,
                 double tol)
{
    const double size = fabs(u[0]) + fabs(u[1]) + largest(w->z);
    const double rounding =
        fmax(TOL_RADAU_LEAST * tol, 2.0 * TOL_ROUNDINGS * DBL_EPSILON * size);
    enum verdict verdict = GO_ON;
    double before = 0.0;
    struct iteration q;

    w->iterations = 0;
    prepare(&q, at->slope, h, w->z);
    while (verdict == GO_ON) {
        struct vec2 f[STAGES], change[STAGES];
        evaluate(w, system, u, f);
        iterate(&q, f, change);
        const double most = largest(change);
        verdict = judge(w, most, before, tol, rounding);
        if (verdict == DONE)
            complete(w, system, at, u, change);
        for (size_t k = 0; k < STAGES && verdict == GO_ON; k++)
            w->z[k] = vec2_add(w->z[k], change[k]);
        before = most;
    }
    if (verdict == HOPELESS)
        w->rate = 1.0;
    return verdict == DONE;
}

/* The polynomial through the values at the nodes; straight lines to the last
 * digit. */
static void interpolate(const double value[STAGES], double coef[STAGES])
{
    for (size_t j = 0; j < STAGES; j++) {
        coef[j] = j == 0 ? value[STAGES - 1] : 0.0;
        for (size_t k = 0; k + 1 < STAGES; k++)
            coef[j] += monomial[j][k] * (value[k] - value[STAGES - 1]);
    }
}

/* Component i on the step, but for its start: z from z/theta, an integral from
 * its derivative. */
static void polynomial(const struct radau *w, size_t i, double h, double p[])
{
    double value[STAGES];

    for (size_t k = 0; k < STAGES; k++)
        value[k] = i == 0   ? w->z[k].x / node[k]
                   : i == 1 ? w->z[k].y / node[k]
                            : h * w->du[k][i];
    interpolate(value, p + 1);
    for (size_t j = 2; i >= 2 && j < COEFS; j++)
        p[j] /= (double) j;
}

/* The value of a polynomial and its derivative. */
static double horner(const double p[COEFS], double theta, double *slope)
{
    double value = 0.0;

    *slope = 0.0;
    for (size_t j = COEFS; j-- > 0;) {
        *slope = *slope * theta + value;
        value = value * theta + p[j];
    }
    return value;
}

/* By how much rhs differs from the polynomials' slope at PROBE. */
static struct vec2 probe(const struct cascade *system, const double coef[],
                         double per_h)
{
    double slope[2], du[CURVE_DIM_MAX];
    const struct vec2 z = { horner(coef, PROBE, &slope[0]),
                            horner(coef + COEFS, PROBE, &slope[1]) };

    system->plane(system->ctx, z, du);
    return (struct vec2){ du[0] - per_h * slope[0], du[1] - per_h * slope[1] };
}

/* The error of z: the defect at the start is that of the embedded method; it
 * says nothing about what decays fast, for which the one at PROBE is the error
 * of the polynomial.  Either filtered, and the larger of the two. */
static struct vec2 error_of(struct mat2 m, struct vec2 start, struct vec2 later)
{
    const struct vec2 a = times(m, start), b = times(m, later);

    return (struct vec2){ fabs(a.x) > fabs(b.x) ? a.x : b.x,
                          fabs(a.y) > fabs(b.y) ? a.y : b.y };
}

void radau_finish(const struct radau *w, const struct cascade *system,
                  const struct cascade_linear *at, const double u[], double h,
                  double coef[], double error[])
{
    const struct mat2 m = real_inverse(at->slope, h);
    const double per_h = 1.0 / h;
    double defect[CURVE_DIM_MAX]; /* at the start */

    for (size_t i = 0; i < system->dim; i++) {
        double *p = coef + i * COEFS;
        p[0] = u[i];
        polynomial(w, i, h, p);
        defect[i] = at->du[i] - per_h * p[1];
    }
    const struct vec2 start = { defect[0], defect[1] };
    const struct vec2 e = error_of(m, start, probe(system, coef, per_h));
    error[0] = e.x;
    error[1] = e.y;
    for (size_t i = 2; i < system->dim; i++) {
        const struct vec2 g = at->slope[i];
        error[i] = h * (defect[i] + g.x * e.x + g.y * e.y) / real_value;
    }
}
