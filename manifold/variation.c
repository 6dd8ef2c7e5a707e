/*
 * Collocation at Gauss points on the pieces of the branch, of order twice
 * their number (Hairer, Lubich & Wanner, Geometric Numerical Integration
 * (2006), II.1.2).  The pieces are Taylor steps, so the curve's singularities
 * are several of their lengths away and few points will do; where those of the
 * equation are nearer the last Legendre coefficients tell, and the piece is
 * halved.  What we changed: the first piece starts on the saddle, where the
 * equation is 0/0; the points do not touch it, and the start value is known.
 */
#include "variation.h"

#include <math.h>

#include "tolerance.h"

enum { NODES = VARIATION_NODES_MAX };

struct collocation {
    size_t n;
    double node[NODES];           /* in [0, 1] */
    double weight[NODES];         /* integral to 1 */
    double partial[NODES][NODES]; /* to node i: sum_j partial[i][j] f_j */
    double last[2][NODES]; /* coefficients of P_n-2, P_n-1: sum last[][j] f_j */
};

/* Legendre's P_0..P_n at x. */
static void legendre(size_t n, double x, double P[])
{
    P[0] = 1.0;
    P[1] = x;
    for (size_t k = 1; k < n; k++)
        P[k + 1] = ((double) (2 * k + 1) * x * P[k] - (double) k * P[k - 1]) /
                   (double) (k + 1);
}

/* Node i of n on [-1, 1], by Newton's method, and its weight. */
static double gauss_node(size_t n, size_t i, double P[], double *weight)
{
    double x = -cos(M_PI * ((double) i + 0.75) / ((double) n + 0.5));
    double slope = 1.0;

    for (int k = 0; k < 8; k++) {
        legendre(n, x, P);
        slope = (double) n * (P[n - 1] - x * P[n]) / (1.0 - x * x);
        x -= P[n] / slope;
    }
    legendre(n, x, P);
    *weight = 2.0 / ((1.0 - x * x) * slope * slope);
    return x;
}

/* The integral of the interpolant: with f_j at the nodes its Legendre
 * coefficients are (k + 1/2) sum_j weight_j P_k(node_j) f_j, and
 * P_k integrates to (P_k+1 - P_k-1)/(2k + 1). */
static void collocation_init(struct collocation *c, size_t n)
{
    double P[NODES][NODES + 2], weight[NODES];

    c->n = n;
    for (size_t i = 0; i < n; i++) {
        const double x = gauss_node(n, i, P[i], &weight[i]);
        c->node[i] = 0.5 * (1.0 + x);
        c->weight[i] = 0.5 * weight[i];
    }
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            double sum = P[i][1] + 1.0;
            for (size_t k = 1; k < n; k++)
                sum += P[j][k] * (P[i][k + 1] - P[i][k - 1]);
            c->partial[i][j] = 0.25 * weight[j] * sum;
        }
    for (size_t j = 0; j < n; j++)
        for (size_t k = 0; k < 2; k++)
            c->last[k][j] =
                ((double) (n - 2 + k) + 0.5) * weight[j] * P[j][n - 2 + k];
}

/* Everything on the way along one branch. */
struct walk {
    const struct planar *sys;
    const struct branch *b;
    const struct variation *v;
    struct collocation rule;
    int ind; /* independent coordinate of the piece */
    double eta[VARIATION_MAX];
};

/* d eta/d ind = grow eta + push[] at the offset z. */
static void equation_at(const struct walk *w, struct vec2 z, double *grow,
                        double push[])
{
    struct planar_jacobian J;
    struct vec2 g[VARIATION_MAX];

    w->sys->jacobian(w->sys->ctx, z, &J);
    w->v->gradient(w->v->ctx, z, &J.field, g);
    const bool over_x = w->ind == 0;
    const struct vec2 f = J.field.direction;
    const double ind = over_x ? f.x : f.y, slope = (over_x ? f.y : f.x) / ind;
    const double ind_d = over_x ? J.matrix.xy : J.matrix.yx;
    const double dep_d = over_x ? J.matrix.yy : J.matrix.xx;
    *grow = (dep_d - slope * ind_d) / ind;
    for (size_t i = 0; i < w->v->count; i++)
        push[i] = over_x ? (g[i].y - slope * g[i].x) / ind
                         : (g[i].x - slope * g[i].y) / ind;
}

/* Gaussian elimination with row pivots; the right sides become solutions. */
static void solve(size_t n, double A[NODES][NODES],
                  double right[NODES][VARIATION_MAX], size_t count)
{
    for (size_t k = 0; k < n; k++) {
        size_t best = k;
        for (size_t i = k + 1; i < n; i++)
            best = fabs(A[i][k]) > fabs(A[best][k]) ? i : best;
        for (size_t j = 0; j < n; j++) {
            const double swap = A[k][j];
            A[k][j] = A[best][j];
            A[best][j] = swap;
        }
        for (size_t j = 0; j < count; j++) {
            const double swap = right[k][j];
            right[k][j] = right[best][j];
            right[best][j] = swap;
        }
        for (size_t i = 0; i < n; i++) {
            const double part = i == k ? 0.0 : A[i][k] / A[k][k];
            for (size_t j = k; j < n; j++)
                A[i][j] -= part * A[k][j];
            for (size_t j = 0; j < count; j++)
                right[i][j] -= part * right[k][j];
        }
    }
    for (size_t k = 0; k < n; k++)
        for (size_t j = 0; j < count; j++)
            right[k][j] /= A[k][k];
}

/* d eta/d theta at the nodes of [from, from + width] of a piece. */
static void find_rates(const struct walk *w, size_t piece, double from,
                       double width, double rate[NODES][VARIATION_MAX])
{
    const struct collocation *c = &w->rule;
    const double *ind = curve_component(&w->b->curve, piece, (size_t) w->ind);
    const double unit = width * ind[1];
    double A[NODES][NODES];

    for (size_t i = 0; i < c->n; i++) {
        const double theta = from + width * c->node[i];
        double grow;
        equation_at(w, curve_point(&w->b->curve, piece, theta), &grow, rate[i]);
        for (size_t j = 0; j < c->n; j++)
            A[i][j] = (i == j) - unit * grow * c->partial[i][j];
        for (size_t p = 0; p < w->v->count; p++)
            rate[i][p] = unit * (grow * w->eta[p] + rate[i][p]);
    }
    solve(c->n, A, rate, w->v->count);
}

/* The end is good to about the square of what the last coefficients are. */
static bool is_resolved(const struct walk *w, double rate[NODES][VARIATION_MAX])
{
    const struct collocation *c = &w->rule;

    for (size_t p = 0; p < w->v->count; p++) {
        double size = fabs(w->eta[p]), last[2] = { 0.0, 0.0 };
        for (size_t i = 0; i < c->n; i++) {
            size = fmax(size, fabs(rate[i][p]));
            last[0] += c->last[0][i] * rate[i][p];
            last[1] += c->last[1][i] * rate[i][p];
        }
        const double left = fmax(fabs(last[0]), fabs(last[1]));
        if (left > sqrt(w->v->tol) * size)
            return false;
    }
    return true;
}

/* From theta = 0 to 1, halving as needed. */
static void cross_piece(struct walk *w, size_t piece)
{
    const struct collocation *c = &w->rule;
    double rate[NODES][VARIATION_MAX], from = 0.0, width = 1.0;

    while (from < 1.0) {
        find_rates(w, piece, from, width, rate);
        if (!is_resolved(w, rate) && width > TOL_PIECE_SHORTEST) {
            width *= 0.5;
            continue;
        }
        for (size_t p = 0; p < w->v->count; p++)
            for (size_t i = 0; i < c->n; i++)
                w->eta[p] += c->weight[i] * rate[i][p];
        from += width;
        if (fmod(from, 2.0 * width) == 0.0 && width < 1.0)
            width *= 2.0;
    }
}

/* The solution of A dz = -g by rows of size one: the two components of a field
 * may differ by a factor of 1e240. */
static struct vec2 motion_of(struct mat2 A, struct vec2 g)
{
    const double x = fmax(fabs(A.xx), fabs(A.xy));
    const double y = fmax(fabs(A.yx), fabs(A.yy));
    const struct mat2 m = { A.xx / x, A.xy / x, A.yx / y, A.yy / y };
    const struct vec2 h = { g.x / x, g.y / y };
    const double det = mat2_det(m);

    return (struct vec2){ (m.xy * h.y - m.yy * h.x) / det,
                          (m.yx * h.x - m.xx * h.y) / det };
}

/* eta at the saddle, from the saddle's own motion. */
static void start(struct walk *w)
{
    const struct vec2 origin = { 0.0, 0.0 };
    const double *x = curve_component(&w->b->curve, 0, 0);
    const double *y = curve_component(&w->b->curve, 0, 1);
    struct planar_jacobian J;
    struct vec2 g[VARIATION_MAX];

    w->sys->jacobian(w->sys->ctx, origin, &J);
    w->v->gradient(w->v->ctx, origin, &J.field, g);
    w->ind = branch_graph(w->b, 0);
    for (size_t i = 0; i < w->v->count; i++) {
        const struct vec2 d = motion_of(J.matrix, g[i]);
        w->eta[i] =
            w->ind == 0 ? d.y - y[1] / x[1] * d.x : d.x - x[1] / y[1] * d.y;
    }
}

/* The same motion of the curve, seen along the other axis. */
static void change_graph(struct walk *w, int ind, struct vec2 z)
{
    const double slope = local_slope(w->sys, ind, z);

    w->ind = ind;
    for (size_t i = 0; i < w->v->count; i++)
        w->eta[i] *= -slope;
}

void variation_along(const struct planar *sys, const struct branch *b,
                     const struct variation *v, double end[], double rest[])
{
    struct walk w = { .sys = sys, .b = b, .v = v };
    double grow, push[VARIATION_MAX];

    collocation_init(&w.rule, v->nodes);
    start(&w);
    for (size_t piece = 0; piece < b->curve.count; piece++) {
        const int ind = branch_graph(b, piece);
        if (ind != w.ind)
            change_graph(&w, ind, curve_point(&b->curve, piece, 0.0));
        cross_piece(&w, piece);
    }
    equation_at(&w, curve_point(&b->curve, b->curve.count - 1, 1.0), &grow,
                push);
    for (size_t i = 0; i < v->count; i++) {
        end[i] = w.eta[i];
        rest[i] = fabs(grow * w.eta[i] + push[i]);
    }
}
