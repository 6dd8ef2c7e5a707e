/*
 * patch_side.h -- one side of a rectangle of cells: the points at which
 * functions of its coordinate are sampled, and the polynomials through them.
 */
#pragma once

#include <stdbool.h>
#include <stddef.h>

enum { PATCH_SIDE = 10 };

/* Chebyshev points of the first kind between the outermost cells or, where
 * there are no more cells than points, the cells themselves: functions are then
 * a value for each cell, and exact. */
struct patch_side {
    const double *at; /* borrowed: centres, ascending */
    size_t cells;
    int nodes; /* <= PATCH_SIDE */
    bool is_exact;
};

struct patch_side patch_side_of(const double at[], size_t cells);

double patch_side_node(const struct patch_side *s, int i);

/* Values f[0], f[stride], ... at the nodes to coefficients. */
void patch_side_transform(const struct patch_side *s, double f[],
                          size_t stride);

/* What to multiply coefficients by at a point; false: the side is exact and the
 * point is none of its cells. */
bool patch_side_basis(const struct patch_side *s, double at,
                      double basis[PATCH_SIDE]);

/* Such a point: the basis; the size |l_i| of what the value at each node is
 * multiplied by; |T_n|, the next of the basis, 0 on an exact side. */
struct patch_point {
    double basis[PATCH_SIDE], weight[PATCH_SIDE], left_out;
};
struct patch_point patch_side_point(const struct patch_side *s, double at);

/* What sum |l_i| is at most. */
double patch_side_weight(const struct patch_side *s);

/* The first cell of part i, if it is cut into even parts. */
size_t patch_side_cut(const struct patch_side *s, size_t parts, size_t i);
