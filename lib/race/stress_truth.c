/*
 * A saddle is a falling zero of mu_ss - tan(alpha), bracketed by turning points
 * of mu_ss.  These come from long double, which is enough: friction is
 * stationary there, so that its 113-bit value is off by the square of their
 * error.
 */
#include "stress_truth.h"

#include <float.h>
#include <math.h>

#include "numbers.h"
#include "steady.h"
#include "stress_tolerance.h"
#include "tolerance.h"

struct finder {
    const struct law *law;
    const struct material *m;
    quad tan_alpha;
    struct stress_truth *out;
};

static void put(struct stress_truth *t, enum stress_number which, quad value,
                quad error)
{
    t->number[which] = (struct stress_true){ true, value, fabsq(error) };
}

/* ---- the saddle ---------------------------------------------------------- */

/* Turning points of mu_ss between the edges of the plane, edges included. */
static size_t find_pieces(const struct finder *f, long double edge[6])
{
    const long double top = steady_x_max(f->law);
    const long double far = (long double) LN_RANGE;
    long double turning[4];
    size_t n = 0;

    edge[n++] = -far;
    for (size_t i = 0, k = steady_extrema(f->law, f->m, turning); i < k; i++)
        if (turning[i] > -far && turning[i] < far && turning[i] < top)
            edge[n++] = turning[i];
    /* where psi leaves its domain mu_ss falls without bound */
    edge[n++] = top < far ? top - LDBL_MIN : far;
    return n;
}

static bool is_above(const struct finder *f, long double x)
{
    return quad_block_mu_ss(f->law, f->m, (quad) x) > f->tan_alpha;
}

/* Whether there is a saddle, and its bracket. */
static bool bracket_saddle(const struct finder *f, long double *lo,
                           long double *hi)
{
    long double edge[6];
    const size_t n = find_pieces(f, edge);
    struct stress_truth *out = f->out;

    out->saddle = out->below = out->above = false;
    for (size_t i = 0; i + 1 < n; i++) {
        const bool left = is_above(f, edge[i]),
                   right = is_above(f, edge[i + 1]);
        if (left && !right) {
            out->saddle = true;
            out->above = false;
            *lo = edge[i];
            *hi = edge[i + 1];
        } else if (right && !left) {
            out->below = out->below || !out->saddle;
            out->above = out->saddle;
        }
    }
    return out->saddle;
}

/* ---- eigenvalues --------------------------------------------------------- */

/* Column j of the Jacobian in the chart, per t*. */
static void differences(const struct finder *f, int j, quad column[2])
{
    const quad psi = law_psi_is_log(f->law) ? 0 : fabsq(f->out->at.psi0);
    const quad h = STRESS_ORACLE_NEAR / (1 + psi);
    struct quad_field to, from;

    quad_block_field(&f->out->at, j == 0 ? h : 0, j == 1 ? h : 0, &to);
    quad_block_field(&f->out->at, j == 0 ? -h : 0, j == 1 ? -h : 0, &from);
    for (int i = 0; i < 2; i++)
        column[i] = (to.direction[i] * expq(to.log_scale) -
                     from.direction[i] * expq(from.log_scale)) /
                    (2 * h);
}

static void find_eigenvalues(struct finder *f)
{
    quad x[2], y[2];

    differences(f, 0, x);
    differences(f, 1, y);
    const quad half = (x[0] + y[1]) / 2;
    const quad det = x[0] * y[1] - x[1] * y[0];
    const quad far = half + copysignq(sqrtq(half * half - det), half);
    const quad near = det / far;
    const quad lost =
        (quad) 1e-30 * (fabsq(x[0] * y[1]) + fabsq(x[1] * y[0])) / fabsq(far);
    put(f->out, STRESS_LAMBDA_MINUS, far < near ? far : near, lost);
    put(f->out, STRESS_LAMBDA_PLUS, far < near ? near : far, lost);
}

/* ---- branches ------------------------------------------------------------ */

struct stress_knee stress_truth_knee(const struct stress_truth *t,
                                     const struct quad_knee *k)
{
    const quad v = t->at.v0 * expq(k->z[0]), y = t->at.y0 + k->z[1];
    const bool is_log = law_psi_is_log(&t->law);
    const quad psi = is_log ? y : expq(y);

    return (struct stress_knee){
        .v = { true, v, v * k->error },
        .psi = { true, psi, is_log ? k->error : psi * k->error },
    };
}

static int8_t end_of(const struct quad_branch *b)
{
    static const int8_t code[] = {
        [QUAD_PSI_INF] = END_PSI_INF, [QUAD_OPEN] = END_OPEN,
        [QUAD_PSI_0] = END_PSI_0,     [QUAD_V_0] = END_V_0,
        [QUAD_TRUNCATED] = -1,
    };
    return code[b->end];
}

static void put_upper(struct finder *f)
{
    struct stress_truth *t = f->out;
    const struct quad_branch *b = &t->upper;
    const quad v0 = t->at.v0, v = v0 * expq(b->x), off = fabsq(b->x) * b->error;
    const quad excess = b->excess, tangent = f->tan_alpha;
    const quad eps2 =
        (quad) f->m->V_star * f->m->V_star / ((quad) f->m->g * (quad) f->m->L);
    const quad half = eps2 * sqrtq(1 + tangent * tangent) / 2;
    const quad energy = half * v0 * v0 * expm1q(2 * b->x);
    const quad mean = half * v0 * v0 * expm1q(b->x) * expm1q(b->x);
    const quad part = b->excess_error + 4 * b->error * (1 + fabsq(b->x));

    put(t, STRESS_V_PLUS, v, v * off);
    put(t, STRESS_LN_V_PLUS, t->at.x0 + b->x, off);
    put(t, STRESS_X_EXCESS, excess, excess * b->excess_error);
    put(t, STRESS_FRACTURE_ENERGY, energy, energy * part);
    put(t, STRESS_MU_S_NUM, tangent + energy / excess, energy / excess * part);
    put(t, STRESS_MU_S_MEAN, tangent + mean / excess, mean / excess * part);
}

static void put_lower(struct finder *f)
{
    struct stress_truth *t = f->out;
    const struct quad_branch *b = &t->lower;
    const quad x = t->at.x0 + b->x, y = t->at.y0 + b->y;
    const quad psi = law_psi_is_log(f->law) ? y : expq(y);
    const quad off = b->error * fabsq(b->end == QUAD_V_0 ? b->y : b->x);

    if (b->end == QUAD_PSI_0) {
        put(t, STRESS_V_MINUS, expq(x), expq(x) * off);
        put(t, STRESS_LN_V_MINUS, x, off);
    } else if (b->end == QUAD_V_0) {
        put(t, STRESS_PSI_AT_V0, psi, law_psi_is_log(f->law) ? off : psi * off);
    }
    if (b->end == QUAD_PSI_0 || b->end == QUAD_V_0)
        put(t, STRESS_X_DEFICIT, -b->excess, b->excess * b->excess_error);
}

static void put_knee(struct finder *f, const struct quad_branch *b,
                     enum stress_number v, enum stress_number psi)
{
    for (size_t i = b->knees.count; i-- > 0;)
        if (i < QUAD_KNEES && b->knees.at[i].rising) {
            const struct stress_knee k =
                stress_truth_knee(f->out, &b->knees.at[i]);
            f->out->number[v] = k.v;
            f->out->number[psi] = k.psi;
        }
}

static void find_branches(struct finder *f)
{
    struct stress_truth *t = f->out;

    if (!quad_branch_grow(f->law, &t->at, 1, STRESS_ORACLE_TOL, &t->upper) ||
        !quad_branch_grow(f->law, &t->at, -1, STRESS_ORACLE_TOL, &t->lower))
        return;
    t->evaluations = t->upper.evaluations + t->lower.evaluations;
    t->upper_end = end_of(&t->upper);
    t->lower_end = end_of(&t->lower);
    if (t->upper.end == QUAD_PSI_INF)
        put_upper(f);
    put_lower(f);
    put_knee(f, &t->upper, STRESS_KNEE_UPPER_V, STRESS_KNEE_UPPER_PSI);
    put_knee(f, &t->lower, STRESS_KNEE_LOWER_V, STRESS_KNEE_LOWER_PSI);
}

void stress_truth_find(const struct law *law, const struct material *m,
                       long double tan_alpha, struct stress_truth *out)
{
    struct finder f = { law, m, (quad) tan_alpha, out };
    long double lo = 0.0L, hi = 0.0L;

    *out =
        (struct stress_truth){ .law = *law, .upper_end = -1, .lower_end = -1 };
    if (!bracket_saddle(&f, &lo, &hi))
        return;
    const quad x =
        quad_block_equilibrium(law, m, f.tan_alpha, (quad) lo, (quad) hi);
    quad_block_anchor(law, m, f.tan_alpha, x, true, &out->at);
    const quad psi = law_psi_is_log(law) ? out->at.y0 : out->at.psi0;
    put(out, STRESS_V_SP, out->at.v0, 0);
    put(out, STRESS_PSI_SP, psi, 0);
    find_eigenvalues(&f);
    find_branches(&f);
}

/* ---- sides --------------------------------------------------------------- */

/* A branch rises in both coordinates outside the quadrants that cannot be left
 * (trap.h), so that each of its points tells the sides of two quadrants. */
static enum stress_side path_side(const struct quad_branch *b, quad x, quad y)
{
    for (size_t i = 0; i < b->points; i++) {
        if (x > b->path[i][0] && y < b->path[i][1])
            return STRESS_SLIDES;
        if (x < b->path[i][0] && y > b->path[i][1])
            return STRESS_STOPS;
    }
    return STRESS_UNTOLD;
}

/* Above and right of the saddle: where the upper branch is all but straight. */
static enum stress_side upper_side(const struct quad_branch *b, quad x, quad y)
{
    if (b->end != QUAD_PSI_INF)
        return STRESS_UNTOLD;
    if (x > b->x)
        return STRESS_SLIDES;
    return y >= b->y ? STRESS_STOPS : STRESS_UNTOLD;
}

/* Below and left of it. */
static enum stress_side lower_side(const struct quad_branch *b, quad x, quad y)
{
    if (b->end == QUAD_PSI_0) {
        if (x < b->x)
            return STRESS_STOPS;
        return y <= b->y ? STRESS_SLIDES : STRESS_UNTOLD;
    }
    if (b->end == QUAD_V_0) {
        if (y < b->y)
            return STRESS_SLIDES;
        return x <= b->x ? STRESS_STOPS : STRESS_UNTOLD;
    }
    return STRESS_UNTOLD;
}

enum stress_side stress_truth_side(const struct stress_truth *t, quad x, quad y)
{
    if (!t->saddle)
        return STRESS_UNTOLD;
    x -= t->at.x0;
    y -= t->at.y0;
    if (x <= 0 && y >= 0)
        return x < 0 || y > 0 ? STRESS_STOPS : STRESS_UNTOLD;
    if (x >= 0 && y <= 0)
        return STRESS_SLIDES;
    const struct quad_branch *b = x > 0 ? &t->upper : &t->lower;
    const enum stress_side side = path_side(b, x, y);
    if (side != STRESS_UNTOLD)
        return side;
    return x > 0 ? upper_side(b, x, y) : lower_side(b, x, y);
}

/* Whether 1/T settles as v -> 0: its values far apart are the same. */
static bool is_steady(const struct law *law, const struct material *m)
{
    return fabsl(steady_log_rate(law, m, -2000.0L) -
                 steady_log_rate(law, m, -4000.0L)) < 1.0L;
}

/* Without a creep node in the plane.  psi_ss bounded, there is one beyond it.
 * Rests take a finite time where psi, that holds friction at tan(alpha) or lets
 * it grow, reaches infinity in one: under psi_ss ~ 1/v, where it grows like
 * e^(1/v), (5), or like 1/v itself, and under psi_ss = -ln v like a power of
 * 1/v. */
static unsigned rests(const struct law *law, const struct material *m)
{
    const unsigned finite = 1u << FATE_REST_FINITE;
    const unsigned asymptotic = 1u << FATE_REST_ASYMPTOTIC;
    const bool is_sinh = law->kinetics == KINETICS_SINH;
    const bool is_log = law->psi_ss == PSI_SS_MINUS_LOG;

    if (law->psi_ss == PSI_SS_SPINODAL_UNIT ||
        (law->psi_ss == PSI_SS_SPINODAL && isfinite(m->R)) ||
        (is_log && law->theta != THETA_PSI))
        return 1u << FATE_CREEP;
    if (is_log)
        return is_sinh && is_steady(law, m) ? finite : asymptotic;
    if (law_freezes(law))
        return asymptotic;
    return is_sinh || is_steady(law, m) ? finite : asymptotic;
}

unsigned stress_truth_fates(const struct stress_truth *t, const struct law *law,
                            const struct material *m, enum stress_side side)
{
    switch (side) {
        case STRESS_STOPS:
            return t->below ? 1u << FATE_CREEP : rests(law, m);
        case STRESS_SLIDES:
            return t->above ? 1u << FATE_SLIDING : 1u << FATE_RUNAWAY;
        case STRESS_UNTOLD:
            break;
    }
    return (1u << FATES) - 1u;
}
