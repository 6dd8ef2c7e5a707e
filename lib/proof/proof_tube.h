/*
 * proof_tube.h -- the tube in which the stable manifold of a saddle is proved
 * to run, in offsets (X, Y) of the chart from the exact saddle:
 *
 *   cone   on the first piece, 0 < theta <= cone.reach:
 *              |dep - p(theta)| <= cone.slope theta;
 *   tube   on every cell (from <= theta <= to of a piece):
 *              |dep - p(theta)| <= radius.
 *
 * where p = sum coef[k] theta^k is the dependent offset, the independent one is
 * start + step theta, start and step doubles taken exactly.  Errors, rates and
 * integrals of cells and the cone are doubles, rounded outward, and it is these
 * that are added up: what a certificate tells.
 */
#pragma once

#include <stddef.h>

#include "interval.h"
#include "jet.h"

/* A polynomial of the curve that is proved to be near. */
struct proof_piece {
    int ind;            /* 0: y(x); 1: x(y) */
    double start, step; /* ind offset = start + step theta */
    size_t degree;
    double coef[JET_SIZE]; /* dep offset = sum coef[k] theta^k */
    size_t first, cells;   /* its cells, in order and without gaps; the first
                              piece's begin at the end of the cone */
};

/* What Gronwall's inequality needs and gives on a part of a piece:
 *     |D| <= defect,  d(step G)/d dep <= rate,  G = f_dep/f_ind,
 *     |dep - p| <= before at `from`, <= after at `to`, <= radius between. */
struct proof_cell {
    double from, to; /* theta */
    double defect, rate;
    double before, after, radius;
    struct interval excess; /* integral of v - v_sp over time on it, inward */
};

struct proof_cone {
    double reach, slope; /* theta; |dep - p| <= slope theta */
    struct interval excess;
};

/* Where dy/dx = 1: offsets. */
struct proof_crossing {
    struct interval X, Y;
};

enum { PROOF_KNEES_MAX = 8 };

/* Of a block, place: the offset that settles - X where psi runs to its end, Y
 * where v does; strip: where it is from the last cell on. */
struct proof_branch {
    int side; /* 1: upper, v > v_sp; -1: lower */
    struct proof_cone cone;
    struct proof_piece *piece; /* owned */
    size_t pieces;
    struct proof_cell *cell; /* owned */
    size_t cells;
    double until; /* independent offset where the last piece with cells ends;
                     infinite: at theta = 1 */
    int end;      /* enum end_code of numbers.h; -1: not_proved says why */
    struct interval place, strip;
    struct interval excess; /* integral of |v - v_sp| dt, where `end` is not
                               open */
    const char *not_proved; /* static; NULL: all of it is */
    int beyond; /* sign of dy/dx - 1 beyond the last cell; 0: not known */
    struct proof_crossing knee[PROOF_KNEES_MAX]; /* the first (proof_knee.h) */
    size_t knees;
    const char *no_more; /* static: why others are not proved; NULL: these are
                            all */
};

/* As far as a branch has been proved: at the current theta |dep - p| <= error,
 * and the integral of v - v_sp over time from there to the saddle. */
struct proof_front {
    double error;
    struct interval excess;
    double length; /* of theta: what the next cell is tried with; 0: all */
};
