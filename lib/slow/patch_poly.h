/*
 * patch_poly.h -- a polynomial through numbers sampled over a rectangle, and
 * how wrong it is where.
 */
#pragma once

#include "patch_side.h"
#include "plane.h"

enum {
    PATCH_NODES = PATCH_SIDE * PATCH_SIDE,
    PATCH_TESTS = 32, /* at most */
    PATCH_STATES = PATCH_NODES + PATCH_TESTS
};

/* Those of the nodes, row by row, and then of points it is tested at, those on
 * an exact side's cells alone. */
struct patch_numbers {
    size_t count, nodes;
    struct vec2 z[PATCH_STATES];
    double value[PATCH_STATES], error[PATCH_STATES];
};

/* It errs by at most x |T_n(x)| + y |T_n(y)| + noise(x, y), and nowhere by
 * more than bar. */
struct patch_poly {
    double coef[PATCH_SIDE][PATCH_SIDE]; /* [y][x] */
    double x, y, bar;
    double noise[PATCH_SIDE]; /* of rows of nodes */
};

void patch_poly_fit(struct patch_poly *p, const struct patch_side *x,
                    const struct patch_side *y, const struct patch_numbers *n);

/* What a point of y's side makes of polynomials. */
struct patch_level {
    double basis[PATCH_SIDE], square[PATCH_SIDE], left_out;
};
struct patch_level patch_level_at(const struct patch_side *y, double at);

/* A polynomial of x alone, which errs by at most bar + x |T_n(x)| + noise times
 * the spread (patch_side.h). */
struct patch_line {
    double coef[PATCH_SIDE], bar, x, noise;
};
struct patch_line patch_poly_line(const struct patch_poly *p,
                                  const struct patch_side *x,
                                  const struct patch_side *y,
                                  const struct patch_level *level);

/* Its value where x's side has this basis. */
double patch_line_at(const struct patch_line *l, const struct patch_side *x,
                     const double basis[PATCH_SIDE]);
