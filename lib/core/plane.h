/* plane.h -- vectors, matrices and boxes of the plane, by value; no failure. */
#pragma once

#include <math.h>
#include <stdbool.h>

struct vec2 {
    double x, y;
};

/* Row-major: for a Jacobian, xy = d f_x / d y. */
struct mat2 {
    double xx, xy, yx, yy;
};

/* Closed: lo <= z <= hi in both coordinates. */
struct box {
    struct vec2 lo, hi;
};

/* Coordinate 0 or 1. */
static inline double vec2_part(struct vec2 z, int axis)
{
    return axis == 0 ? z.x : z.y;
}

static inline struct vec2 vec2_add(struct vec2 u, struct vec2 v)
{
    return (struct vec2){ u.x + v.x, u.y + v.y };
}

static inline struct vec2 vec2_sub(struct vec2 u, struct vec2 v)
{
    return (struct vec2){ u.x - v.x, u.y - v.y };
}

static inline struct vec2 vec2_scale(double s, struct vec2 v)
{
    return (struct vec2){ s * v.x, s * v.y };
}

/* Around nothing; around a box and a point. */
#define BOX_NOTHING                                                            \
    ((struct box){ { HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL } })
static inline struct box box_around(struct box b, struct vec2 z)
{
    return (struct box){ { fmin(b.lo.x, z.x), fmin(b.lo.y, z.y) },
                         { fmax(b.hi.x, z.x), fmax(b.hi.y, z.y) } };
}

static inline bool box_meets(struct box a, struct box b)
{
    return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y &&
           b.lo.y <= a.hi.y;
}

static inline bool box_holds(struct box b, struct vec2 z)
{
    return z.x >= b.lo.x && z.x <= b.hi.x && z.y >= b.lo.y && z.y <= b.hi.y;
}

/* The box as offsets from z. */
static inline struct box box_from(struct box b, struct vec2 z)
{
    return (struct box){ vec2_sub(b.lo, z), vec2_sub(b.hi, z) };
}

/* The box with `part` of its width added on every side. */
static inline struct box box_grow(struct box b, double part)
{
    const struct vec2 more = vec2_scale(part, vec2_sub(b.hi, b.lo));
    return (struct box){ vec2_sub(b.lo, more), vec2_add(b.hi, more) };
}

/* Between lo and hi, and not in the middle, where zeros and symmetric things
 * like to be. */
static inline double off_middle(double lo, double hi)
{
    return lo + 0.4871 * (hi - lo);
}

/* Point t = 0, 1, ... of the sequence from (shift, shift) on that fills the
 * unit square most evenly (Roberts 2018). */
struct vec2 vec2_spread(double shift, double t);

/* Euclidean length, without overflow. */
double vec2_length(struct vec2 v);

/* > 0 where v is to the left of u. */
double vec2_cross(struct vec2 u, struct vec2 v);

/* det(A), with relative error at most 2 units of roundoff barring
 * under/overflow: Kahan's algorithm, bound from Jeannerod, Louvet, Muller,
 * Math. Comp. 82 (2013) 2245-2264. */
double mat2_det(struct mat2 A);

/* Eigenvalues of a 2x2 matrix.  Real: re[0] <= re[1], im = 0, the root far
 * from zero first, then Vieta, so that neither suffers cancellation beyond
 * that of det(A).  Complex: re[0] = re[1], im > 0. */
struct eigen2 {
    double re[2];
    double im;
};
struct eigen2 mat2_eigenvalues(struct mat2 A);

/* A unit eigenvector of A to the real eigenvalue lambda, with x > 0, or x = 0
 * and y > 0.  Taken from the row of A - lambda with the larger diagonal, which
 * is the one that does not cancel. */
struct vec2 mat2_eigenvector(struct mat2 A, double lambda);
