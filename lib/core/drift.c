/* The error e of a collocation polynomial p with the defect d = p' - g(p) obeys
 * e' = Dg(p) e + d.  Collocation with one stage more (Radau IIA, six stages,
 * order 11) sees of d, which vanishes at the stages of the step and is
 * orthogonal to low powers, all but two orders less; stiff components it
 * follows like the method itself.  It is made on each half of a step, for much
 * of d cancels on long ones, and, to tell how well, on all of it. */
#include "drift.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "tolerance.h"

enum { STAGES = DRIFT_CALLS / 3, UNKNOWNS = 2 * STAGES, SIDES = 3 };

static const double node[STAGES] = {
    0.0398098570514687423, 0.198013417873608173, 0.437974810247386144,
    0.695464273353636095,  0.901464914201173574, 1.0
};

/* Row i: weights of the integral from 0 to node i. */
static const double weight[STAGES][STAGES] = {
    { 0.0509500109946406093, -0.0189073065542921391, 0.0136860714330882288,
      -0.0103700387660460458, 0.00736065639663980394, -0.00290953645256171473 },
    { 0.10822165891905866, 0.106975519937332604, -0.0275390233553924203,
      0.0174967471412281615, -0.0116537218911955868, 0.00451223712257675395 },
    { 0.0977796700926453547, 0.223172250636895836, 0.136314679273051887,
      -0.0296469659881962164, 0.0163585788434371597, -0.00600340261044787621 },
    { 0.102122375612933841, 0.202975957373091079, 0.276399136380747833,
      0.13100602313604298, -0.0248763031998222865, 0.00783708405064264749 },
    { 0.100331001384960802, 0.210247308553338462, 0.256085372050337616,
      0.253365934704565651, 0.0924305343356995968, -0.0109952368277285537 },
    { 0.10079419262674042, 0.208450667155953869, 0.260463391594787491,
      0.242693594234484958, 0.159820376610255483, 0.0277777777777777778 }
};

void drift_start(struct drift *d, double rounding, double rate)
{
    *d = (struct drift){ .rounded = rounding, .rate = rate };
    d->noise[0][0] = d->noise[1][1] = rounding * rounding;
}

/* ---- one piece ----------------------------------------------------------- */

/* h times the gradients of the rates and the defect, at each node. */
struct piece {
    size_t dim;
    double nearest; /* to the origin */
    struct vec2 slope[STAGES][CURVE_DIM_MAX];
    double defect[STAGES][CURVE_DIM_MAX];
};

/* The part of the last piece between these thetas. */
static void look_at(const struct rescaled *clock, const struct curve *c,
                    double h, double from, double to, struct piece *p)
{
    const size_t last = c->count - 1;
    const double part = to - from;
    double u[CURVE_DIM_MAX], du[CURVE_DIM_MAX];
    struct cascade_linear l;

    p->dim = c->dim;
    p->nearest = HUGE_VAL;
    for (int j = 0; j < STAGES; j++) {
        const double theta = from + part * node[j];
        curve_at(c, last, theta, u);
        curve_slope_at(c, last, theta, du);
        p->nearest = fmin(p->nearest, hypot(u[0], u[1]));
        rescaled_linear(clock, (struct vec2){ u[0], u[1] }, &l);
        for (size_t i = 0; i < c->dim; i++) {
            p->slope[j][i] = vec2_scale(part * h, l.slope[i]);
            p->defect[j][i] = part * (du[i] - h * l.du[i]);
        }
    }
}

/* Gauss's elimination: the solutions in place of the right sides. */
static void eliminate(double A[UNKNOWNS][UNKNOWNS + SIDES])
{
    const size_t all = UNKNOWNS + SIDES;

    for (size_t k = 0; k < UNKNOWNS; k++) {
        size_t best = k;
        for (size_t i = k + 1; i < UNKNOWNS; i++)
            best = fabs(A[i][k]) > fabs(A[best][k]) ? i : best;
        for (size_t j = k; j < all; j++) {
            const double swap = A[k][j];
            A[k][j] = A[best][j];
            A[best][j] = swap;
        }
        for (size_t i = k + 1; i < UNKNOWNS; i++) {
            const double part = A[i][k] / A[k][k];
            for (size_t j = k + 1; j < all && part != 0.0; j++)
                A[i][j] -= part * A[k][j];
        }
    }
    for (size_t k = UNKNOWNS; k-- > 0;)
        for (size_t j = UNKNOWNS; j < all; j++) {
            for (size_t i = k + 1; i < UNKNOWNS; i++)
                A[k][j] -= A[k][i] * A[i][j];
            A[k][j] /= A[k][k];
        }
}

/* A component that settles at once does so at any larger rate, too: rows that
 * would drown the other one's digits are scaled. */
static void scale_rows(struct piece *p)
{
    double most[2] = { 1.0, 1.0 };

    for (int j = 0; j < STAGES; j++)
        for (int i = 0; i < 2; i++)
            most[i] = fmax(
                most[i], fmax(fabs(p->slope[j][i].x), fabs(p->slope[j][i].y)));
    for (int i = 0; i < 2; i++) {
        const double part = TOL_DRIFT_STIFF * most[1 - i] / most[i];
        for (int j = 0; j < STAGES && part < 1.0; j++) {
            p->slope[j][i] = vec2_scale(part, p->slope[j][i]);
            p->defect[j][i] *= part;
        }
    }
}

/* E at the nodes: of the defect from no error, and of a unit of x and of y. */
static void solve(const struct piece *p, double E[UNKNOWNS][SIDES])
{
    double A[UNKNOWNS][UNKNOWNS + SIDES];

    memset(A, 0, sizeof A);
    for (size_t i = 0; i < UNKNOWNS; i++) {
        const double *w = weight[i / 2];
        A[i][i] = A[i][UNKNOWNS + 1 + i % 2] = 1.0;
        for (size_t j = 0; j < STAGES; j++) {
            const struct vec2 g = p->slope[j][i % 2];
            A[i][2 * j] -= w[j] * g.x;
            A[i][2 * j + 1] -= w[j] * g.y;
            A[i][UNKNOWNS] += w[j] * p->defect[j][i % 2];
        }
    }
    eliminate(A);
    for (size_t i = 0; i < UNKNOWNS; i++)
        memcpy(E[i], &A[i][UNKNOWNS], sizeof E[i]);
}

/* What a piece makes of errors: e -> gain e + e + more. */
struct transport {
    double more[CURVE_DIM_MAX];
    double gain[CURVE_DIM_MAX][2];
    double nearest;                   /* to the origin on the way */
    struct vec2 slope[CURVE_DIM_MAX]; /* at the end, over the whole piece */
    double defect[CURVE_DIM_MAX];
};

/* Over the part of the last piece between these thetas; false: not finite. */
static bool find_transport(const struct rescaled *clock, const struct curve *c,
                           double h, double from, double to,
                           struct transport *t)
{
    double E[UNKNOWNS][SIDES];
    bool is_finite = true;
    struct piece p;

    look_at(clock, c, h, from, to, &p);
    scale_rows(&p);
    solve(&p, E);
    t->nearest = p.nearest;
    for (size_t i = 0; i < p.dim; i++) {
        t->slope[i] = vec2_scale(1.0 / (to - from), p.slope[STAGES - 1][i]);
        t->defect[i] = p.defect[STAGES - 1][i] / (to - from);
        double sum[SIDES] = { 0.0 };
        for (size_t j = 0; j < STAGES; j++) {
            const struct vec2 g = p.slope[j][i];
            const double w = weight[STAGES - 1][j];
            sum[0] += w * p.defect[j][i];
            for (int k = 0; k < SIDES; k++)
                sum[k] += w * (g.x * E[2 * j][k] + g.y * E[2 * j + 1][k]);
        }
        t->more[i] = sum[0];
        t->gain[i][0] = sum[1];
        t->gain[i][1] = sum[2];
        is_finite = is_finite && isfinite(sum[0] + sum[1] + sum[2]);
    }
    return is_finite;
}

/* Of what `next` makes of what t makes. */
static void append(struct transport *t, const struct transport *next,
                   size_t dim)
{
    const struct transport first = *t;
    const double *m = first.more;
    const double(*g)[2] = first.gain;

    for (size_t i = 0; i < dim; i++) {
        const double *n = next->gain[i];
        t->more[i] += next->more[i] + n[0] * m[0] + n[1] * m[1];
        for (int k = 0; k < 2; k++)
            t->gain[i][k] += n[k] + n[0] * g[0][k] + n[1] * g[1][k];
    }
    t->nearest = fmin(t->nearest, next->nearest);
    memcpy(t->slope, next->slope, sizeof t->slope);
    memcpy(t->defect, next->defect, sizeof t->defect);
}

/* M C M^T with M = 1 + gain. */
static void spread(const struct transport *t, size_t dim,
                   double C[CURVE_DIM_MAX][CURVE_DIM_MAX])
{
    double half[CURVE_DIM_MAX][CURVE_DIM_MAX];

    for (size_t i = 0; i < dim; i++)
        for (size_t k = 0; k < dim; k++)
            half[i][k] =
                C[i][k] + t->gain[i][0] * C[0][k] + t->gain[i][1] * C[1][k];
    for (size_t i = 0; i < dim; i++)
        for (size_t k = 0; k < dim; k++)
            C[i][k] = half[i][k] + t->gain[k][0] * half[i][0] +
                      t->gain[k][1] * half[i][1];
}

/* e -> e - (row e) du: what is off where the function with the gradient row,
 * row du = 1, has its value. */
static void project(struct drift *d, const double row[], size_t n, size_t dim)
{
    const double *du = d->du;
    double by[CURVE_DIM_MAX] = { 0.0 }, late = 0.0, lost = 0.0, square = 0.0;

    for (size_t k = 0; k < n; k++) {
        late += row[k] * d->e[k];
        lost += row[k] * d->lost[k];
        for (size_t i = 0; i < dim; i++)
            by[i] += row[k] * d->noise[i][k];
    }
    for (size_t k = 0; k < n; k++)
        square += row[k] * by[k];
    for (size_t i = 0; i < dim; i++) {
        d->e[i] -= late * du[i];
        d->lost[i] -= lost * du[i];
        for (size_t k = 0; k < dim; k++)
            d->noise[i][k] +=
                square * du[i] * du[k] - by[i] * du[k] - du[i] * by[k];
    }
}

static double bound(double off, double noise)
{
    return TOL_BAR_FIRST_ORDER * off + TOL_DRIFT_NOISE * sqrt(fmax(noise, 0.0));
}

/* Of e_i - late du_i, where late = row e, to first order.  Variances that all
 * but cancel leave what rounding makes of them, unless they are the same. */
static double first_order(const struct drift *d, double rate,
                          const double row[], size_t n, size_t i)
{
    double off = d->e[i], lost = d->lost[i], cross = 0.0, square = 0.0;

    for (size_t k = 0; k < n; k++) {
        off -= rate * row[k] * d->e[k];
        lost -= rate * row[k] * d->lost[k];
        cross += row[k] * d->noise[i][k];
        for (size_t l = 0; l < n; l++)
            square += row[k] * row[l] * d->noise[k][l];
    }
    const double own = d->noise[i][i], late = rate * rate * square;
    const double noise = own + late - 2.0 * rate * cross;
    const double least = TOL_ROUNDINGS_FEW * DBL_EPSILON * fmax(own, late);
    return bound(fabs(off) + fabs(lost),
                 noise != 0.0 ? fmax(noise, least) : 0.0);
}

/* Of time, where the orbit crosses a line across its way. */
static double lateness(const struct drift *d)
{
    const double *du = d->du;
    const double square = du[0] * du[0] + du[1] * du[1];
    const double row[2] = { du[0] / square, du[1] / square };

    return square > 0.0 ? first_order(d, du[2], row, 2, 2) : 0.0;
}

/* How far the end u of the last piece was rounded from what it gained: steps
 * short of a last digit are rounded to one side, all of them. */
static void add_rounding(struct drift *d, const struct curve *c,
                         const double u[])
{
    const struct curve_piece *p = &c->piece[c->count - 1];

    for (size_t i = 0; i < c->dim; i++) {
        const double *coef = curve_component(c, c->count - 1, i);
        double gain = 0.0;
        for (size_t j = p->degree; j > 0; j--)
            gain += coef[j];
        const double lost = (u[i] - coef[0]) - gain;
        d->lost[i] += lost;
        d->rounded += i < 2 ? fabs(lost) : 0.0;
    }
}

/* Those of the true orbit, beside the end of the piece: a polynomial's, less
 * what its error grows by, where there is a transport and to first order this
 * tells.  Only their ratios count: the larger of the first two is about 1. */
static void find_rates(struct drift *d, const struct curve *c,
                       const struct transport *t)
{
    const bool tells = t && hypot(d->e[0], d->e[1]) < 1.0;

    curve_slope_at(c, c->count - 1, 1.0, d->du);
    for (size_t i = 0; tells && i < c->dim; i++)
        d->du[i] -=
            t->defect[i] + t->slope[i].x * d->e[0] + t->slope[i].y * d->e[1];
    const double most = fmax(fabs(d->du[0]), fabs(d->du[1]));
    for (size_t i = 0; most > 0.0 && i < c->dim; i++)
        d->du[i] = ldexp(d->du[i], -ilogb(most));
}

/* What is off along the orbit leaves it where it is, but late: as much further
 * on, and in no need of being carried.  It would be a rate's times as much of a
 * sum whose rate grows, and cancel.  (But where that is later than the step is
 * long, for the orbit may turn: the fast coordinate settles.) */
static void turn_across(struct drift *d, size_t dim)
{
    const double *du = d->du;
    const double square = du[0] * du[0] + du[1] * du[1];
    const double row[2] = { du[0] / square, du[1] / square };

    if (fabs(row[0] * d->e[0] + row[1] * d->e[1]) < 1.0)
        project(d, row, 2, dim);
}

void drift_carry(struct drift *d, const struct rescaled *clock,
                 const struct curve *c, double h, const double missed[])
{
    const struct vec2 e = { d->e[0], d->e[1] };
    const struct vec2 lost = { d->lost[0], d->lost[1] };
    struct transport whole, t, half;
    double u[CURVE_DIM_MAX];

    if (!find_transport(clock, c, h, 0.0, 1.0, &whole) ||
        !find_transport(clock, c, h, 0.0, 0.5, &t) ||
        !find_transport(clock, c, h, 0.5, 1.0, &half)) {
        for (size_t i = 0; i < c->dim; i++)
            d->e[i] += copysign(missed[i], d->e[i]);
        find_rates(d, c, NULL);
        return;
    }
    append(&t, &half, c->dim);
    for (size_t i = 0; i < c->dim; i++) {
        const double *g = t.gain[i];
        d->e[i] += t.more[i] + g[0] * e.x + g[1] * e.y;
        d->lost[i] += g[0] * lost.x + g[1] * lost.y;
    }
    spread(&t, c->dim, d->noise);
    curve_at(c, c->count - 1, 1.0, u);
    add_rounding(d, c, u);
    for (size_t i = 0; i < c->dim; i++) {
        const double cruder = t.more[i] - whole.more[i];
        const double unsure = TOL_DRIFT_UNSURE * t.more[i];
        const double digit = 0.5 * DBL_EPSILON * u[i];
        d->noise[i][i] += cruder * cruder + unsure * unsure + digit * digit;
    }
    find_rates(d, c, &t);
    if (d->rate > 0.0 && t.nearest < TOL_DRIFT_NEAR)
        d->late = fmax(d->late, d->rate * lateness(d));
    turn_across(d, c->dim);
}

double drift_gained(struct drift *d, size_t i)
{
    const double gained = d->e[i];

    d->e[i] = 0.0;
    return gained;
}

/* ---- the end ------------------------------------------------------------- */

/* F, of the header. */
static double stretch(double r)
{
    return r > 0.0 ? r < 1.0 ? -log1p(-r) / r : HUGE_VAL : 1.0;
}

/* An error that is none stays none. */
static double stretched(const struct drift *d, double bar)
{
    return bar > 0.0 ? stretch(d->late) * bar : bar;
}

double drift_bar(const struct drift *d, struct vec2 gradient, size_t i)
{
    const double *du = d->du;
    const double speed = gradient.x * du[0] + gradient.y * du[1];
    const double row[2] = { gradient.x / speed, gradient.y / speed };

    return stretched(d, first_order(d, du[i], row, 2, i));
}

double drift_bar_at(const struct drift *d, size_t which, size_t i)
{
    double row[CURVE_DIM_MAX] = { 0.0 };

    row[which] = 1.0 / d->du[which];
    return stretched(d, first_order(d, d->du[i], row, which + 1, i));
}

double drift_across(const struct drift *d)
{
    const double *du = d->du;
    const double size = hypot(du[0], du[1]);
    const double x = size > 0.0 ? -du[1] / size : 1.0;
    const double y = size > 0.0 ? du[0] / size : 1.0;
    const double(*n)[CURVE_DIM_MAX] = d->noise;

    return stretched(
        d, bound(fabs(x * d->e[0] + y * d->e[1]) +
                     fabs(x * d->lost[0] + y * d->lost[1]),
                 x * x * n[0][0] + 2.0 * x * y * n[0][1] + y * y * n[1][1]));
}
