/* fields_of.h -- planar systems with known orbits, for test_rescaled.c and
 * test_orbit.c. */
#pragma once

#include <math.h>

#include "planar.h"

/* Each fixture gives direction, log scale and matrix at a point; its one
 * observable is the integral of x. */
struct fixture {
    void (*at)(const double p[], struct vec2 z, struct planar_jacobian *J);
    double p[4];
};

static inline void fields_field(const void *ctx, struct vec2 z,
                                struct planar_field *f)
{
    const struct fixture *x = ctx;
    struct planar_jacobian J;

    x->at(x->p, z, &J);
    *f = J.field;
}

static inline void fields_jacobian(const void *ctx, struct vec2 z,
                                   struct planar_jacobian *J)
{
    const struct fixture *x = ctx;
    x->at(x->p, z, J);
}

static inline void fields_rate(const void *ctx, size_t which, struct vec2 z,
                               double *r, struct vec2 *gradient)
{
    (void) ctx;
    (void) which;
    *r = z.x;
    if (gradient)
        *gradient = (struct vec2){ 1.0, 0.0 };
}

static inline struct planar planar_of(const struct fixture *x,
                                      double half_width)
{
    static const struct planar_observable integral_of_x = { "x", "1", "x" };

    return (struct planar){
        .name = "fixture",
        .domain = { { -half_width, -half_width }, { half_width, half_width } },
        .field = fields_field,
        .jacobian = fields_jacobian,
        .observables = &integral_of_x,
        .observable_count = 1,
        .rate_gradient = fields_rate,
        .ctx = x,
    };
}

/* x' = p0 x, y' = p1 y */
static inline void linear(const double p[], struct vec2 z,
                          struct planar_jacobian *J)
{
    J->field = (struct planar_field){ { p[0] * z.x, p[1] * z.y }, 0.0 };
    J->matrix = (struct mat2){ p[0], 0.0, 0.0, p[1] };
}

/* x' = y, y' = x - x^3 */
static inline void duffing(const double p[], struct vec2 z,
                           struct planar_jacobian *J)
{
    (void) p;
    J->field = (struct planar_field){ { z.y, z.x - z.x * z.x * z.x }, 0.0 };
    J->matrix = (struct mat2){ 0.0, 1.0, 1.0 - 3.0 * z.x * z.x, 0.0 };
}

/* x' = 1, y' = -p0 (y - sin x) + cos x */
static inline void prothero(const double p[], struct vec2 z,
                            struct planar_jacobian *J)
{
    J->field =
        (struct planar_field){ { 1.0, -p[0] * (z.y - sin(z.x)) + cos(z.x) },
                               0.0 };
    J->matrix = (struct mat2){ 0.0, 0.0, p[0] * cos(z.x) - sin(z.x), -p[0] };
}

/* x' = -x, y' = -p0 (y - cos x) */
static inline void relax(const double p[], struct vec2 z,
                         struct planar_jacobian *J)
{
    J->field = (struct planar_field){ { -z.x, -p[0] * (z.y - cos(z.x)) }, 0.0 };
    J->matrix = (struct mat2){ -1.0, 0.0, -p[0] * sin(z.x), -p[0] };
}

/* Van der Pol in Lienard's plane: x' = (y - x^3/3 + x)/p0, y' = -x */
static inline void pol(const double p[], struct vec2 z,
                       struct planar_jacobian *J)
{
    const double x2 = z.x * z.x;

    J->field =
        (struct planar_field){ { (z.y - z.x * (x2 / 3.0 - 1.0)) / p[0], -z.x },
                               0.0 };
    J->matrix = (struct mat2){ (1.0 - x2) / p[0], 1.0 / p[0], -1.0, 0.0 };
}

/* (p0, p1) exp(p2 + p3 x) */
static inline void stream(const double p[], struct vec2 z,
                          struct planar_jacobian *J)
{
    J->field = (struct planar_field){ { p[0], p[1] }, p[2] + p[3] * z.x };
    J->matrix = (struct mat2){ p[0] * p[3], 0.0, p[1] * p[3], 0.0 };
}

/* The stream with p2 = p3 = 0, undefined for x > 1. */
static inline void hole(const double p[], struct vec2 z,
                        struct planar_jacobian *J)
{
    stream(p, z, J);
    if (z.x > 1.0)
        J->field.direction.y = J->matrix.yx = (double) NAN;
}
