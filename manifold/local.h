/*
 * local.h -- the invariant manifolds at a saddle as Taylor series.
 *
 * Near a saddle each invariant manifold is the graph of one coordinate, the
 * dependent one, over the other: dep = sum_k c[k] (ind/unit)^k (Poincare).  The
 * same series serves both branches (ind > 0 and ind < 0).  The unit is 1, or a
 * power of two about as small as the length over which the field changes: that
 * may be 1e-200.
 */
#pragma once

#include "equilibrium.h"

enum manifold_kind { MANIFOLD_STABLE, MANIFOLD_UNSTABLE };

enum { LOCAL_CARRY_MAX = 4 };

/* A quantity integrated along a branch: an observable's index, or time. */
enum { CARRY_TIME = -1 };
struct carry {
    int which[LOCAL_CARRY_MAX];
    size_t count;
};

struct local_series {
    int ind; /* 0: y(x); 1: x(y) */
    size_t order;
    double unit;
    double c[JET_SIZE];
    /* Integrals over time from the saddle, likewise; only those whose
     * rate vanishes at the saddle converge, the others are identically zero
     * here (and are counted from the end of the series). */
    double integral[LOCAL_CARRY_MAX][JET_SIZE];
    bool converges[LOCAL_CARRY_MAX];
    double radius; /* of ind/unit, where the last terms reach tol and the defect
                      is small */
};

/* The manifold of the saddle at sys->origin, order <= JET_SIZE - 1.
 * STATUS_NOT_HYPERBOLIC if `e` has no such manifold (the strong stable
 * manifold of a saddle-node exists) or is beyond doubles
 * (equilibrium_is_beyond), STATUS_BAD_ARGUMENT if the system has no jets,
 * STATUS_NO_CONVERGENCE if no radius is small enough; then *out is undefined.
 */
MUST_CHECK enum status local_at(const struct planar *sys,
                                const struct equilibrium *e,
                                enum manifold_kind kind,
                                const struct carry *carry, size_t order,
                                double tol, struct local_series *out);

/* The same over the coordinate `ind`, flatter or not. */
MUST_CHECK enum status local_over(const struct planar *sys,
                                  const struct equilibrium *e,
                                  enum manifold_kind kind, int ind,
                                  const struct carry *carry, size_t order,
                                  double tol, struct local_series *out);

/* The same of several systems at once; each has the bits that it has alone. */
enum { LOCAL_JOBS = JET_MANY };
struct local_job {
    const struct planar *sys;
    const struct equilibrium *e;
    enum manifold_kind kind;
    int ind;
    const struct carry *carry;
    size_t order;
    double tol;
    struct local_series *out;
    enum status status; /* when it is done */
};

/* n <= LOCAL_JOBS. */
void local_jobs(struct local_job job[], size_t n);

/* The coordinate over which local_at has the series. */
int local_flatter(const struct equilibrium *e, enum manifold_kind kind);

/* The point of the series at s = ind/unit. */
struct vec2 local_series_at(const struct local_series *u, double s);

/* dep's derivative by ind along a direction, and along the field at z. */
static inline double local_quotient(int ind, struct vec2 d)
{
    return ind == 0 ? d.y / d.x : d.x / d.y;
}
double local_slope(const struct planar *sys, int ind, struct vec2 z);

/* The point of the plane with the given coordinates. */
static inline struct vec2 local_point(int ind, double s, double dep)
{
    return ind == 0 ? (struct vec2){ s, dep } : (struct vec2){ dep, s };
}

/* The last coefficients of an integral's series, which step control goes by,
 * are at least what they may have lost to the end of the doubles: rates come in
 * units of the field (planar.h), and are divided by `along`, its direction. */
void local_integral_floor(size_t order, double along, double u[]);
