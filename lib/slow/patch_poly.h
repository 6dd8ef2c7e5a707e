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

/* With r the ratio in which coefficients c_k fall and E the largest of |c_8|,
 * |c_9|/r, r |c_7| and r^2 |c_6| at a place, left |T_n| E is left out there:
 * not all four vanish. */
enum { PATCH_LAST = 4 };
struct patch_tail {
    double left, falls; /* falls is r; 0: nothing, as along an exact side */
};

/* It errs by at most
 *
 *     left_x |T_n(x)| E_x(y) + left_y |T_n(y)| E_y(x)
 *         + sum |l_i(x) l_j(y)| noise_ij + rounding,
 *
 * E_x of its coefficients along x at y, and nowhere by more than bar, where the
 * first two terms are at most x and y. */
struct patch_poly {
    double coef[PATCH_SIDE][PATCH_SIDE], noise[PATCH_SIDE][PATCH_SIDE];
    struct patch_tail along_x, along_y; /* coef[y][x] */
    double x, y, rounding, bar;
};

void patch_poly_fit(struct patch_poly *p, const struct patch_side *x,
                    const struct patch_side *y, const struct patch_numbers *n);

/* At a point of y's side, a polynomial of x alone, which errs by at most
 * x |T_n(x)| + y above(x) + sum |l_i(x)| noise_i + rounding. */
struct patch_line {
    double coef[PATCH_SIDE], noise[PATCH_SIDE], x, y, rounding;
};
struct patch_line patch_poly_line(const struct patch_poly *p,
                                  const struct patch_side *x,
                                  const struct patch_side *y,
                                  const struct patch_point *level);

/* left_y E_y at a point of x's side. */
double patch_poly_above(const struct patch_poly *p, const struct patch_side *x,
                        const struct patch_point *at);

/* The line's value at a point of x's side, where it is `above`, and its bar. */
double patch_line_at(const struct patch_line *l, const struct patch_side *x,
                     const struct patch_point *at, double above, double *bar);
