/*
 * planar.h -- the contract between the physics and the geometry:
 * an autonomous, analytic vector field on a box of the plane,
 *
 *     z' = f(z) = direction(z) * exp(log_scale(z)),     z = (x, y).
 *
 * The field comes in two factors so that nothing overflows where f itself
 * would.  manifold/ and portrait/ see the physics only through this struct.
 *
 * Every function of `struct planar` takes z as an *offset* from `origin`; only
 * a planar_steady is in absolute coordinates.  `direction` is no unit vector;
 * names and what is pointed to are the filler's.  Whoever fills
 * the struct puts the origin where digits matter (on an equilibrium) and
 * evaluates differences from there without cancellation; offset zero means
 * exactly the origin.  All functions are total on the domain and never fail;
 * `ctx` is passed back unchanged.
 */
#pragma once

#include <stddef.h>

#include "jet.h"
#include "plane.h"

struct planar_axis {
    const char *name;      /* what is drawn and stored, e.g. "v" */
    const char *unit;      /* of unit.h or UDUNITS; "1" if none */
    const char *long_name; /* one plain phrase */
    bool is_log;           /* the coordinate is the ln of what is stored */
};

/* A quantity whose time integral rides along every curve. */
struct planar_observable {
    const char *name;
    const char *unit; /* of the integral */
    const char *long_name;
};

struct planar_field {
    struct vec2 direction;
    double log_scale;
};

struct planar_jacobian {
    struct planar_field field; /* f at the same point */
    struct mat2 matrix;        /* Df(z) = matrix * exp(field.log_scale) */
};

/* A curve x -> (x, steady y(x)) that carries every equilibrium: they are the
 * zeros of `balance`, which is monotone between consecutive `turning` points
 * (ascending).  x and y absolute; long double, because near a fold every digit
 * counts. */
struct planar_steady {
    long double (*balance)(const void *ctx, long double x);
    long double (*y)(const void *ctx, long double x);
    long double turning[4];
    size_t turnings;
    long double lo, hi; /* range of x to search */
};

enum { PLANAR_OBSERVABLES_MAX = 6 };

/* At a point: the field and its matrix, exp(-log_scale), an observable's rate
 * and its gradient. */
struct planar_look {
    struct planar_jacobian J;
    double unit;
    double rate;
    struct vec2 gradient;
};

/* The jets of JET_MANY planes along a curve each, ctx[lane] their contexts: for
 * files whose pairs have so many lanes; and what they are at points. */
struct planar_many {
    int width; /* of the registers they are made for */
    bool (*alike)(const void *ctx, const void *other); /* may they be so */
    void (*jet)(const void *const ctx[], struct jet_work *w, size_t k,
                const jet_pair x[], const jet_pair y[], jet_pair fx[],
                jet_pair fy[]);
    void (*rate_jet)(const void *const ctx[], size_t which, struct jet_work *w,
                     size_t k, const jet_pair x[], const jet_pair y[],
                     jet_pair rate[]);
    /* At z[i] of plane ctx[i], i < n <= JET_MANY, all alike: the bits of
     * jacobian or, without slopes, of field, and of rate_gradient of an
     * observable (which < 0: of none). */
    void (*look)(const void *const ctx[], size_t n, const struct vec2 z[],
                 int which, bool slopes, struct planar_look out[]);
};

struct planar {
    const char *name;
    struct planar_axis axis[2];
    struct box domain; /* of absolute coordinates origin + z */
    struct vec2 origin;

    /* All get the ctx below; z is an offset from the origin. */
    void (*field)(const void *ctx, struct vec2 z, struct planar_field *f);
    void (*jacobian)(const void *ctx, struct vec2 z, struct planar_jacobian *J);

    /* Coefficient k of the Taylor series of f * exp(-w->log_scale) along two
     * curves whose coefficients 0..k are x[], y[]: writes fx[k] and fy[k].
     * Called for k = 0, 1, 2, ... with the same arrays and workspace; the
     * call with k = 0 fixes w->log_scale for the whole series.  A second call
     * with the same k replaces the first.  All of *w but `linear`, which is
     * the caller's, is the system's: it sets w->used before it takes slots.
     * NULL: the system has no jets, local_at answers STATUS_BAD_ARGUMENT. */
    void (*jet)(const void *ctx, struct jet_work *w, size_t k,
                const jet_pair x[], const jet_pair y[], jet_pair fx[],
                jet_pair fy[]);

    /* Observables: their rates per unit of time at z with the gradient in z
     * (which may be NULL where only the rate is wanted),
     * and (after `jet` with the same k) coefficient k of the series of
     * rate * exp(-w->log_scale).  NULL where there are none. */
    const struct planar_observable *observables;
    size_t observable_count;
    void (*rate_gradient)(const void *ctx, size_t which, struct vec2 z,
                          double *rate, struct vec2 *gradient);
    void (*rate_jet)(const void *ctx, size_t which, struct jet_work *w,
                     size_t k, const jet_pair x[], const jet_pair y[],
                     jet_pair rate[]);
    const struct planar_many *many; /* of jet and rate_jet; NULL: none */

    const struct planar_steady *steady; /* borrowed; NULL if none is known */
    const void *ctx;                    /* borrowed: outlives the system */
};
