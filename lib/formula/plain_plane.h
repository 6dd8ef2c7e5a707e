/*
 * plain_plane.h -- a planar system of formulas, evaluated as they stand:
 * numbers with their derivatives, and Taylor series.
 *
 * A function g of u is known by its value and by g' = h u', where h is again a
 * formula: of u, of g, or of both.  Positive states are logarithms in the
 * chart.
 */
#ifndef FORMULA_PLAIN_PLANE_H
#define FORMULA_PLAIN_PLANE_H

#include "planar.h"
#include "system.h"

enum { PLAIN_OPS = 200 };

struct plain_op {
    enum plain_kind {
        PLAIN_COORDINATE, /* a: 0 or 1 */
        PLAIN_NUMBER,
        PLAIN_SUM,
        PLAIN_TIMES,
        PLAIN_OVER,
        PLAIN_CALL /* of a; h = b */
    } kind;
    enum formula_function function;
    int a, b;
    double number; /* also the exponent of a power */
};

/* Each op needs those before it, but for h. */
struct plain_program {
    struct plain_op op[PLAIN_OPS];
    int ops, calls;
    int rate[2];                   /* of the chart */
    int value[SYSTEM_OBSERVABLES]; /* rates of the observables */
    bool full;
};

/* Of a system with its parameters' values.  STATUS_BAD_SCENE with one line in
 * *why: a function without a rule, or too many operations. */
MUST_CHECK enum status plain_program(struct plain_program *p,
                                     const struct formula_system *s,
                                     struct fault *why);

/* What all operations make of an absolute point: value[p->ops]. */
void plain_values(const struct plain_program *p, struct vec2 z, double value[]);

/* The rates of the chart at an absolute point, and their slope (may be NULL).
 */
struct vec2 plain_rates(const struct plain_program *p, struct vec2 z,
                        struct mat2 *slope);

/* Value i at an absolute point, with its gradient (may be NULL). */
double plain_value(const struct plain_program *p, int i, struct vec2 z,
                   struct vec2 *gradient);

/* About an origin; where that is an equilibrium (`still`), what rounding leaves
 * of the rates there is taken off everywhere.  sign -1: backward in time. */
struct plain_plane {
    const struct plain_program *program; /* borrowed */
    struct vec2 origin, left;
    double sign;
};

struct plain_plane plain_around(const struct plain_program *program,
                                struct vec2 origin, bool still, double sign);

/* Fills what evaluates, origin and ctx of *out; the plane is borrowed. */
void plain_planar(const struct plain_plane *p, struct planar *out);

#endif
