/* Radau IIA with ten stages (order 19, L-stable; Hairer & Wanner, Solving ODEs
 * II, 1996, IV.5), its coefficients from Legendre polynomials, its equations by
 * Newton's method with every stage's own Jacobian.  A step is kept when the
 * last Legendre coefficient of the rates over it is below tol: the end is far
 * more exact. */
#include "workprec_orbit.h"

#include <math.h>
#include <string.h>

#include "workprec_tolerance.h"

enum { STAGES = 10, SIZE = 2 * STAGES, STEPS_MOST = 4000, ITERATIONS = 14 };
enum { LANDINGS = 30 };

struct tableau {
    quad c[STAGES], b[STAGES], A[STAGES][STAGES];
    quad last[STAGES]; /* rates -> their last Legendre coefficient */
};

struct orbit {
    const struct law *law;
    const struct quad_anchor *at;
    struct tableau t;
};

/* ---- coefficients ---------------------------------------------------- */

/* P_0 .. P_n at x in [-1, 1]. */
static void legendre(quad x, int n, quad P[])
{
    P[0] = 1;
    P[1] = x;
    for (int k = 1; k < n; k++)
        P[k + 1] = ((2 * k + 1) * x * P[k] - k * P[k - 1]) / (k + 1);
}

/* The root of P_s - P_(s-1) near x. */
static quad radau_node(quad x)
{
    quad P[STAGES + 1];

    for (int i = 0; i < 40; i++) {
        legendre(x, STAGES, P);
        const quad slope =
            STAGES * (x * P[STAGES] - P[STAGES - 1]) / (x * x - 1);
        const quad before =
            (STAGES - 1) * (x * P[STAGES - 1] - P[STAGES - 2]) / (x * x - 1);
        x -= (P[STAGES] - P[STAGES - 1]) / (slope - before);
    }
    return x;
}

/* A[i][j]: the integral to c[i] of the j-th Lagrange polynomial, through its
 * Legendre series. */
static void integrate(struct tableau *t)
{
    quad at[STAGES][STAGES + 1];

    for (int i = 0; i < STAGES; i++)
        legendre(2 * t->c[i] - 1, STAGES, at[i]);
    for (int i = 0; i < STAGES; i++)
        for (int j = 0; j < STAGES; j++) {
            quad sum = t->c[i];
            for (int k = 1; k < STAGES; k++)
                sum += at[j][k] * (at[i][k + 1] - at[i][k - 1]) / 2;
            t->A[i][j] = t->b[j] * sum;
        }
    for (int j = 0; j < STAGES; j++)
        t->last[j] = (2 * STAGES - 1) * t->b[j] * at[j][STAGES - 1];
}

static void set_tableau(struct tableau *t)
{
    quad P[STAGES + 1];

    for (int i = 0; i < STAGES; i++) {
        const double angle = 2.0 * M_PI * (STAGES - 1 - i) / (2 * STAGES - 1);
        const quad x = i == STAGES - 1 ? 1 : radau_node((quad) cos(angle));
        legendre(x, STAGES, P);
        t->c[i] = (1 + x) / 2;
        t->b[i] =
            (1 + x) / (2 * STAGES * STAGES * P[STAGES - 1] * P[STAGES - 1]);
    }
    integrate(t);
}

/* ---- the field ------------------------------------------------------- */

static void rates(const struct orbit *o, const quad z[2], quad dz[2])
{
    struct quad_field f;

    quad_block_field(o->law, o->at, z[0], z[1], &f);
    const quad size = expq(f.log_scale);
    dz[0] = f.direction[0] * size;
    dz[1] = f.direction[1] * size;
}

/* J[i][j] = d dz[i]/d z[j], by differences, which is all Newton needs. */
static void jacobian(const struct orbit *o, const quad z[2], const quad dz[2],
                     quad J[2][2])
{
    for (int j = 0; j < 2; j++) {
        quad near[2] = { z[0], z[1] }, there[2];
        near[j] += (quad) WORKPREC_ORBIT_PROBE;
        rates(o, near, there);
        for (int i = 0; i < 2; i++)
            J[i][j] = (there[i] - dz[i]) / (near[j] - z[j]);
    }
}

/* ---- a step ---------------------------------------------------------- */

/* M x = b by Gauss with row pivots; x in b. */
static void solve(double M[SIZE][SIZE], double b[SIZE])
{
    for (int k = 0; k < SIZE; k++) {
        int p = k;
        for (int i = k + 1; i < SIZE; i++)
            if (fabs(M[i][k]) > fabs(M[p][k]))
                p = i;
        for (int j = k; j < SIZE; j++) {
            const double swap = M[k][j];
            M[k][j] = M[p][j];
            M[p][j] = swap;
        }
        const double swap = b[k];
        b[k] = b[p];
        b[p] = swap;
        for (int i = k + 1; i < SIZE; i++) {
            const double factor = M[i][k] / M[k][k];
            for (int j = k + 1; j < SIZE; j++)
                M[i][j] -= factor * M[k][j];
            b[i] -= factor * b[k];
        }
    }
    for (int k = SIZE - 1; k >= 0; k--) {
        for (int j = k + 1; j < SIZE; j++)
            b[k] -= M[k][j] * b[j];
        b[k] /= M[k][k];
    }
}

/* Newton's correction of the stages Z, less the start z, whose rates are dz;
 * in doubles, so that each is good to 1e-13 of itself.  Returns its size. */
static double correct(const struct orbit *o, quad h, quad J[STAGES][2][2],
                      quad Z[STAGES][2], quad dz[STAGES][2])
{
    double M[SIZE][SIZE], r[SIZE], change = 0.0;

    for (int i = 0; i < SIZE; i++) {
        quad off = -Z[i / 2][i % 2];
        for (int j = 0; j < SIZE; j++) {
            const quad weight = h * o->t.A[i / 2][j / 2];
            M[i][j] = (i == j) - (double) (weight * J[j / 2][i % 2][j % 2]);
            if (j % 2 == 0)
                off += weight * dz[j / 2][i % 2];
        }
        r[i] = (double) off;
    }
    solve(M, r);
    for (int i = 0; i < SIZE; i++) {
        Z[i / 2][i % 2] += r[i];
        change += fabs(r[i]);
    }
    return change;
}

/* The stages; false where they are not found. */
static bool find_stages(const struct orbit *o, const quad z[2], quad h,
                        quad Z[STAGES][2], quad dz[STAGES][2])
{
    quad J[STAGES][2][2];
    double change = HUGE_VAL;

    for (int i = 0; i < ITERATIONS && change > WORKPREC_ORBIT_SOLVED; i++) {
        for (int j = 0; j < STAGES; j++) {
            const quad at[2] = { z[0] + Z[j][0], z[1] + Z[j][1] };
            rates(o, at, dz[j]);
            if (change > WORKPREC_ORBIT_SETTLED)
                jacobian(o, at, dz[j], J[j]);
        }
        change = correct(o, h, J, Z, dz);
    }
    return change <= WORKPREC_ORBIT_SOLVED;
}

/* What the step left out, over tol; not finite where it has no solution. */
static double step_error(const struct orbit *o, quad h, quad dz[STAGES][2],
                         const quad v[STAGES], double slip, double tol)
{
    quad last[3] = { 0, 0, 0 };

    for (int i = 0; i < STAGES; i++) {
        last[0] += o->t.last[i] * dz[i][0];
        last[1] += o->t.last[i] * dz[i][1];
        last[2] += o->t.last[i] * v[i];
    }
    const double plane = (double) (h * (fabsq(last[0]) + fabsq(last[1])));
    return (plane + (double) (h * fabsq(last[2])) / slip) / tol;
}

/* A step of size h from `from`; its error over tol. */
static double step(const struct orbit *o, const struct workprec_state *from,
                   quad h, double tol, struct workprec_state *to)
{
    quad Z[STAGES][2], dz[STAGES][2], v[STAGES], slip = 0;

    memset(Z, 0, sizeof Z);
    if (!find_stages(o, from->z, h, Z, dz))
        return HUGE_VAL;
    for (int i = 0; i < STAGES; i++) {
        v[i] = o->at->v0 * expq(from->z[0] + Z[i][0]);
        slip += h * o->t.b[i] * v[i];
    }
    *to = *from;
    to->z[0] += Z[STAGES - 1][0];
    to->z[1] += Z[STAGES - 1][1];
    to->time += h;
    to->slip += slip;
    to->steps++;
    return step_error(o, h, dz, v, (double) to->slip, tol);
}

/* ---- the orbit ------------------------------------------------------- */

/* How far outside the nearest box around a target, negative inside. */
static quad distance(const struct workprec_goal *goal, const quad z[2])
{
    quad least = (quad) HUGE_VAL;

    for (size_t i = 0; i < goal->targets; i++) {
        const quad x = fabsq(z[0] - goal->target[i][0]);
        const quad y = fabsq(z[1] - goal->target[i][1]);
        const quad off = (x > y ? x : y) - (quad) goal->arrival;
        if (off < least)
            least = off;
    }
    return least;
}

/* The part of the step from `from` to *to, which ends inside a box, that ends
 * on its edge: Illinois' regula falsi. */
static bool land(const struct orbit *o, const struct workprec_state *from,
                 const struct workprec_goal *goal, struct workprec_state *to)
{
    quad lo = 0, hi = to->time - from->time;
    quad f_lo = distance(goal, from->z), f_hi = distance(goal, to->z);

    for (int i = 0; i < LANDINGS; i++) {
        const quad h = (lo * f_hi - hi * f_lo) / (f_hi - f_lo);
        if (!(step(o, from, h, 1.0, to) < HUGE_VAL))
            return false;
        const quad f = distance(goal, to->z);
        if (fabsq(f) < (quad) WORKPREC_ORBIT_LANDED)
            return true;
        if ((f > 0) != (f_hi > 0)) {
            lo = hi;
            f_lo = f_hi;
        } else {
            f_lo /= 2;
        }
        hi = h;
        f_hi = f;
    }
    return false;
}

static quad first_step(const struct orbit *o, const quad z[2])
{
    quad dz[2], J[2][2], fastest;

    rates(o, z, dz);
    jacobian(o, z, dz, J);
    fastest = fabsq(dz[0]) + fabsq(dz[1]);
    for (int i = 0; i < 4; i++)
        fastest += fabsq(J[i / 2][i % 2]);
    return (quad) WORKPREC_ORBIT_FIRST / fastest;
}

/* Whether the step from *here to `next` ends it; moves *here on. */
static bool arrive(const struct orbit *o, const struct workprec_goal *goal,
                   struct workprec_state *next, struct workprec_state *here,
                   bool *good)
{
    const bool timed = goal->time > 0;
    const bool over =
        timed ? next->time == goal->time : distance(goal, next->z) <= 0;

    if (over && !timed)
        *good = land(o, here, goal, next);
    *here = *next;
    return over;
}

bool workprec_orbit_run(const struct law *law, const struct quad_anchor *at,
                        const quad z[2], const struct workprec_goal *goal,
                        double tol, struct workprec_state *out)
{
    struct orbit o = { .law = law, .at = at };
    struct workprec_state here = { .z = { z[0], z[1] } }, next;
    bool good = true;

    set_tableau(&o.t);
    quad h = first_step(&o, z);
    for (int i = 0; i < STEPS_MOST && good; i++) {
        const bool last = goal->time > 0 && h >= goal->time - here.time;
        if (last)
            h = goal->time - here.time;
        const double error = step(&o, &here, h, tol, &next);
        if (last)
            next.time = goal->time;
        if (error <= 1.0 && arrive(&o, goal, &next, &here, &good)) {
            *out = here;
            return good;
        }
        const double factor =
            error < HUGE_VAL ? 0.9 * pow(error + 1e-30, -1.0 / STAGES) : 0.25;
        h *= fmin(fmax(factor, 0.25), 3.0);
    }
    return false;
}
