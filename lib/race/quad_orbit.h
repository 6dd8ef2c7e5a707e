/*
 * quad_orbit.h -- what becomes of a state, in 113 bits: its own orbit forward,
 * by the steps of quad_radau.h with offsets from the saddle, to arrest as
 * cells.h has it.  What bars of slip, time and friction are held to.
 */
#pragma once

#include "cells.h"
#include "quad_block.h"
#include "quad_radau.h"
#include "study.h"

/* A slope: its anchor (the saddle where there is one) and its nodes. */
struct quad_slope {
    const struct study *study; /* borrowed */
    struct quad_method method;
    struct quad_anchor at;
    quad node[EQUILIBRIA_MAX][2]; /* offsets from the anchor */
    enum fate fate[EQUILIBRIA_MAX];
    size_t nodes;
};

/* Of a study whose steady states are known; borrows it. */
void quad_slope_init(struct quad_slope *q, const struct study *s);

/* As struct cell; `error` is NaN where there is no such number, or none was
 * found, and infinite where the slip of a block that only fades is unknown. */
struct quad_orbit {
    enum fate fate; /* FATE_UNDECIDED: also what could not be followed */
    quad value[CELL_FIELDS];
    double error[CELL_FIELDS];
    double defect; /* of (27), over its largest term */
    size_t steps;
};

/* Of the absolute chart point (x, y).  tol: size of the last coefficients of a
 * step's polynomials, relative to the offset from the saddle or 1 and to time,
 * slip and work so far; errors are far smaller, about its square where the
 * system is not stiff.  1e-8 does for every bar of a double. */
void quad_orbit_find(const struct quad_slope *q, quad x, quad y, double tol,
                     struct quad_orbit *out);

/* Where that orbit is at `time` > 0, an absolute chart point; false, with z
 * undefined, where it is not followed to there. */
bool quad_orbit_at(const struct quad_slope *q, quad x, quad y, quad time,
                   double tol, quad z[2]);
