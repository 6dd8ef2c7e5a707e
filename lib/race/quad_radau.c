/* Collocation at the zeros of the right Radau polynomial, Hairer & Wanner,
 * Solving ODEs II (1996), sec. IV.5, all of it in shifted Legendre polynomials
 * P_k: a rate is the sum of c_k P_k with c_k = (2k + 1) sum b_j f_j P_k(x_j),
 * since the nodes x_j with the weights b_j integrate what has degree 2s - 2.
 * The equations of a step are solved in double precision with the gradients at
 * every stage; what is left of them in 113 bits is then put right with the same
 * matrix. */
#include "quad_radau.h"

#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdint.h>

enum { S = QUAD_STAGES, N = 2 * S };
enum { SCAN = 2000, COARSE_MAX = 15, FINE_MAX = 8 };

/* What is enough of the first, and at least where doubles do not allow it; what
 * the second has to gain each time. */
static const double coarse_enough = 1e-9, coarse_least = 1e-4, fine_gain = 0.1;
/* Changes of doubles that are rounding, relative to the step's start. */
static const double rounding = 1e-14;
/* Changes that no longer shrink are rounding up to so many tolerances. */
static const double noise = 1e6;

/* ---- the method ---------------------------------------------------------- */

/* P_0 .. P_n at x in [-1, 1]. */
static void legendre(int n, quad x, quad p[])
{
    p[0] = 1;
    p[1] = x;
    for (int k = 1; k < n; k++)
        p[k + 1] = ((2 * k + 1) * x * p[k] - k * p[k - 1]) / (k + 1);
}

/* The integrals of P_0 .. P_(S - 1) over 0 .. theta. */
static void integrals_to(quad theta, quad out[S])
{
    quad p[S + 1];

    legendre(S, 2 * theta - 1, p);
    out[0] = theta;
    for (int k = 1; k < S; k++)
        out[k] = (p[k + 1] - p[k - 1]) / (2 * (2 * k + 1));
}

static quad radau_polynomial(quad x)
{
    quad p[S + 1];

    legendre(S, x, p);
    return p[S] - p[S - 1];
}

/* The zeros but x = 1, by signs. */
static void find_nodes(struct quad_method *m)
{
    int found = 0;

    for (int i = 0; i < SCAN && found < S - 1; i++) {
        quad lo = 2 * (quad) i / SCAN - 1, hi = lo + (quad) 2 / SCAN;
        const bool rises = radau_polynomial(lo) < 0;
        if ((radau_polynomial(hi) < 0) == rises)
            continue;
        for (quad mid = (lo + hi) / 2; lo < mid && mid < hi;
             mid = (lo + hi) / 2)
            if ((radau_polynomial(mid) < 0) == rises)
                lo = mid;
            else
                hi = mid;
        m->node[found++] = (1 + lo) / 2;
    }
    m->node[S - 1] = 1;
}

void quad_method_init(struct quad_method *m)
{
    find_nodes(m);
    for (int j = 0; j < S; j++) {
        quad p[S + 1];
        const quad x = 2 * m->node[j] - 1;
        legendre(S, x, p);
        const quad weight = (1 + x) / (2 * S * S * p[S - 1] * p[S - 1]);
        for (int k = 0; k < S; k++)
            m->moment[k][j] = (2 * k + 1) * weight * p[k];
    }
    for (int i = 0; i < S; i++) {
        quad to[S];
        integrals_to(m->node[i], to);
        for (int j = 0; j < S; j++) {
            m->a[i][j] = 0;
            for (int k = 0; k < S; k++)
                m->a[i][j] += m->moment[k][j] * to[k];
        }
    }
}

/* ---- linear equations ---------------------------------------------------- */

struct factors {
    double m[N * N];
    size_t row[N];
};

/* With pivots; false where there is none. */
static bool factor(struct factors *f)
{
    gsl_matrix_view m = gsl_matrix_view_array(f->m, N, N);
    int sign;
    bool regular = true;

    gsl_linalg_LU_decomp(&m.matrix, &(gsl_permutation){ N, f->row }, &sign);
    for (int k = 0; k < N; k++)
        regular = regular && fabs(f->m[k * N + k]) > 0.0;
    return regular;
}

static void solve(const struct factors *f, double v[N])
{
    const gsl_matrix_const_view m = gsl_matrix_const_view_array(f->m, N, N);
    const gsl_permutation row = { N, (size_t *) (uintptr_t) f->row };
    gsl_vector_view x = gsl_vector_view_array(v, N);

    gsl_linalg_LU_svx(&m.matrix, &row, &x.vector);
}

/* ---- a step -------------------------------------------------------------- */

/* h a F - z, row by row. */
static void residual(const struct quad_method *m, const struct quad_radau *w,
                     double left[N])
{
    for (int i = 0; i < S; i++)
        for (int c = 0; c < 2; c++) {
            quad sum = 0;
            for (int j = 0; j < S; j++)
                sum += m->a[i][j] * w->du[j][c];
            left[2 * i + c] = (double) (w->h * sum - w->z[i][c]);
        }
}

static void place(const struct quad_radau *w, int stage, const quad u[],
                  quad z[2])
{
    z[0] = u[0] + w->z[stage][0];
    z[1] = u[1] + w->z[stage][1];
}

/* Adds the change; its largest part, NaN if any is not finite. */
static double move(struct quad_radau *w, const double change[N])
{
    double most = 0.0, sum = 0.0;

    for (int i = 0; i < N; i++) {
        w->z[i / 2][i % 2] += (quad) change[i];
        most = fmax(most, fabs(change[i]));
        sum += change[i];
    }
    return isfinite(sum) ? most : (double) NAN;
}

static double largest(const struct quad_radau *w)
{
    double most = 0.0;

    for (int i = 0; i < N; i++)
        most = fmax(most, fabs((double) w->z[i / 2][i % 2]));
    return most;
}

/* The factor of the clock at each stage. */
static void find_factors(const struct quad_radau *w,
                         const struct quad_method *m, quad factor[S])
{
    for (int j = 0; j < S; j++)
        factor[j] = w->bend == 0 ? 1 : expq(w->bend * w->h * m->node[j]);
}

/* One iteration in double precision, with the matrix of where it starts. */
static double improve(struct quad_radau *w, const struct quad_system *system,
                      const quad u[], const quad clock[S], struct factors *f)
{
    double left[N];

    for (int j = 0; j < S; j++) {
        double du[2];
        struct vec2 slope[2];
        quad z[2];
        const quad e = clock[j];
        place(w, j, u, z);
        system->linear(system->ctx, z, du, slope);
        for (int c = 0; c < 2; c++)
            w->du[j][c] = e * (quad) du[c];
        for (int i = 0; i < S; i++) {
            const double ha = (double) (w->h * e * system->method->a[i][j]);
            for (int c = 0; c < 2; c++) {
                double *m = &f->m[(2 * i + c) * N + 2 * j];
                m[0] = -ha * slope[c].x;
                m[1] = -ha * slope[c].y;
                m[c] += i == j ? 1.0 : 0.0;
            }
        }
    }
    if (!factor(f))
        return (double) NAN;
    residual(system->method, w, left);
    solve(f, left);
    return move(w, left);
}

static bool solve_coarsely(struct quad_radau *w,
                           const struct quad_system *system, const quad u[],
                           const quad clock[S], struct factors *f)
{
    const double start = fmax(fabs((double) u[0]), fabs((double) u[1]));
    double before = HUGE_VAL;

    for (int k = 0; k < COARSE_MAX; k++) {
        const double change = improve(w, system, u, clock, f);
        const double size = largest(w);
        if (!isfinite(change) || (k > 3 && change > before))
            return change <= coarse_least * size || change <= rounding * start;
        if (change <= coarse_enough * size)
            return true;
        before = change;
    }
    return false;
}

static bool solve_finely(struct quad_radau *w, const struct quad_system *system,
                         const quad u[], const quad clock[S], double tol,
                         const struct factors *f)
{
    double before = HUGE_VAL, left[N];

    for (int k = 0; k < FINE_MAX; k++) {
        for (int j = 0; j < S; j++) {
            quad z[2];
            place(w, j, u, z);
            system->plane(system->ctx, z, w->du[j]);
            for (int i = 0; i < 3; i++)
                w->du[j][i] *= clock[j];
        }
        residual(system->method, w, left);
        solve(f, left);
        const double change = move(w, left);
        if (change <= tol)
            return true;
        if (!(change <= fine_gain * before))
            return change <= noise * tol;
        before = change;
    }
    return false;
}

static quad coefficient(const struct quad_method *m, const struct quad_radau *w,
                        int component, int k)
{
    quad sum = 0;

    for (int j = 0; j < S; j++)
        sum += m->moment[k][j] * w->du[j][component];
    return sum;
}

bool quad_radau_solve(struct quad_radau *w, const struct quad_system *system,
                      const quad u[], double tol)
{
    struct factors f;
    quad clock[S];

    find_factors(w, system->method, clock);
    if (!solve_coarsely(w, system, u, clock, &f) ||
        !solve_finely(w, system, u, clock, tol, &f))
        return false;
    for (int j = 0; j < S; j++) {
        quad z[2];
        place(w, j, u, z);
        system->integrals(system->ctx, z, w->du[j]);
    }
    for (int k = 0; k < QUAD_MOST; k++)
        for (int i = 0; i < S; i++)
            w->rate[k][i] = coefficient(system->method, w, k, i);
    return true;
}

/* ---- its polynomials ----------------------------------------------------- */

quad quad_radau_gain(const struct quad_radau *w, int k, quad theta)
{
    quad to[S], sum = 0;

    integrals_to(theta, to);
    for (int i = 0; i < S; i++)
        sum += w->rate[k][i] * to[i];
    return w->h * sum;
}

quad quad_radau_tail(const struct quad_radau *w, int k)
{
    const quad last = w->rate[k][S - 1], other = w->rate[k][S - 2] / 4;

    return fabsq(w->h) * (fabsq(last) + fabsq(other));
}
