/*
 * fixtures.h -- planar systems whose answers are known in closed form.
 *
 * A base system with exact manifolds, in base coordinates u = (X, Y),
 *
 *     parabola   X' = a X           Y' = -b Y + X^2    Y = X^2/(2a + b), X = 0
 *     duffing    X' = Y             Y' = X - X^3       Y^2 = X^2 - X^4/2
 *     pendulum   X' = Y             Y' = sin X         Y = +-2 sin(X/2)
 *     pitchfork  X' = a (X - X^3)   Y' = -b Y          Y = 0, X = 0
 *
 * then moved by a chain of polynomial shears, z = S_n(... S_1(u)), and run
 * exp(log_rate) times as fast.  The result is polynomial (but for the sine),
 * curved at will, and everything about it is still exact.
 */
#pragma once

#include <stdint.h>

#include "planar.h"
#include "shear.h"

enum fixture_base {
    FIXTURE_PARABOLA,
    FIXTURE_DUFFING,   /* homoclinic loops around two centres */
    FIXTURE_PENDULUM,  /* heteroclinic between X = 0 and X = 2 pi */
    FIXTURE_PITCHFORK, /* nodes at X = +-1; X = 0 divides their basins */
    FIXTURE_BASES
};

enum fixture_type { FIXTURE_SADDLE, FIXTURE_NODE, FIXTURE_CENTRE };

struct fixture_equilibrium {
    enum fixture_type type;
    struct vec2 base;     /* u */
    struct vec2 z;        /* absolute coordinates */
    struct eigen2 lambda; /* per unit of the system's time */
};

enum { FIXTURE_SHEARS_MAX = 3, FIXTURE_EQUILIBRIA_MAX = 3 };

/* The base field about the centre, d an offset from it:
 * X' = p(d.x) + y d.y,  Y' = q(d.x) + s sin d.x + c cos d.x - b d.y. */
struct fixture_local {
    double p[4], q[4], y, b, s, c;
};

struct fixture {
    enum fixture_base base;
    double a, b; /* > 0; duffing and pendulum ignore them */
    struct shear shear[FIXTURE_SHEARS_MAX];
    size_t shears;
    double log_rate;
    struct vec2 tilt; /* log_scale(z) = log_rate + tilt . z at an offset z */

    /* Set by fixture_center. */
    struct vec2 centre; /* u of the origin */
    struct vec2 origin; /* its absolute coordinates */
    struct fixture_local local;
    struct shear about[FIXTURE_SHEARS_MAX]; /* the chain for offsets */
    struct fixture_equilibrium equilibrium[FIXTURE_EQUILIBRIA_MAX];
    size_t equilibria;
    struct planar_steady steady;
};

/* Observables: the base coordinates' displacement, whose rates vanish at every
 * equilibrium, and exp(log_rate) times the time. */
enum { FIXTURE_X_MOVED, FIXTURE_Y_MOVED, FIXTURE_CLOCK, FIXTURE_OBSERVABLES };

/* No shears, a = b = 1, rate 1, origin at the saddle u = 0. */
void fixture_plain(struct fixture *f, enum fixture_base base);

/* Random a, b in [1/2, 2), 2 or 3 shears of degree 2 to 4, rate and tilt;
 * origin at the saddle u = 0. */
void fixture_random(struct fixture *f, enum fixture_base base, uint64_t *rng);

/* All plain ones to rtol 1e-12 and 1e-6, then so many random ones to 1e-12. */
void fixture_each(int sheared,
                  void (*check)(const struct fixture *f, double rtol));

/* Puts the origin at a base point, e.g. f->equilibrium[1].base, where the
 * field then vanishes exactly.  Also to be called after changing a, b, the
 * shears or the rate by hand. */
void fixture_center(struct fixture *f, struct vec2 u);

/* The planar system; borrows f, which must not move.  Jets and observables
 * are there; the steady curve only where no shear is horizontal. */
struct planar fixture_planar(const struct fixture *f);

/* From a base point to the offset z, and back. */
struct vec2 fixture_offset(const struct fixture *f, struct vec2 u);
struct vec2 fixture_base_point(const struct fixture *f, struct vec2 z);

/* The manifolds of equilibrium[0], the saddle at u = 0. */
enum fixture_manifold { FIXTURE_STABLE, FIXTURE_UNSTABLE };

/* A point on one as an offset z; s = 0 is the saddle, the sign of s says which
 * branch, |s| < fixture_reach (X on the curved ones, Y on X = 0). */
struct vec2 fixture_manifold_at(const struct fixture *f,
                                enum fixture_manifold kind, double s);
double fixture_reach(const struct fixture *f, enum fixture_manifold kind);

/* Zero exactly on the manifold, of either sign beside it (duffing: on both
 * manifolds, which are one).  Pitchfork, stable: positive where orbits go to
 * the node X = 1, negative where they go to X = -1. */
double fixture_implicit(const struct fixture *f, enum fixture_manifold kind,
                        struct vec2 z);
