/*
 * separatrix.h -- the curves that divide a plane into basins, cut into strands
 * along which one coordinate only grows: a row of a grid (or a column) meets
 * each strand at most once, and where is the root of a polynomial.
 *
 * A stable manifold is taken as one chain, from the end of one branch through
 * the saddle to the end of the other; an end with a limit goes on along its
 * asymptote to infinity.
 */
#pragma once

#include <stdbool.h>

#include "branch.h"

/* A measure of the plane: each coordinate, or exp of it, counts evenly. */
struct measure {
    bool exponential[2];
    double log_unit[2]; /* exp is counted in units of e^log_unit, lest it
                           overflow: the top of what is measured */
};

/* From lo to hi, to rounding of the result. */
double measure_between(const struct measure *m, int axis, double lo, double hi);

/* What a coordinate's change counts at c: 1, or e^c in units. */
double measure_weight(const struct measure *m, int axis, double c);

enum { SEPARATRIX_X, SEPARATRIX_Y };

/* Part of one piece of a curve, from theta `from` to theta `to`, or, with
 * curve NULL, a ray parallel to the axis. */
struct strand_piece {
    const struct curve *curve; /* borrowed */
    size_t piece;
    double from, to;
    double lo, hi;    /* of the growing coordinate, as offsets, lo <= hi */
    double at, error; /* of the other one, on a ray */
};

struct strand {
    struct strand_piece *piece; /* owned; ascending */
    size_t count, room;
    double lo, hi; /* its whole range, absolute; may be infinite */
    int way;       /* of the chain along it: +1 from lo to hi */
    bool ends[2]; /* whether the chain ends at lo, at hi: else it turns there */
};

/* A stretch along which the growing coordinate stays exactly: a row that ends
 * there, or runs along it. */
struct flat {
    double w, from, to; /* absolute; from <= to */
    double error;       /* of w */
    size_t chain;       /* the how manieth separatrix_add */
};

struct separatrix {
    int along; /* SEPARATRIX_Y: strands grow in y and cross rows */
    struct vec2 origin;
    double slack; /* how far all of it may be off, as its saddle is; 0 */
    struct strand *strand; /* owned */
    size_t count, room;
    struct flat *flat; /* owned */
    size_t flats, flat_room;
    size_t chains; /* calls of separatrix_add */
};

/* No strands yet. */
struct separatrix separatrix_empty(int along, struct vec2 origin);

/* Adds a saddle's stable manifold.  Either branch may be NULL; both must
 * outlive the separatrix, whose origin is theirs.  STATUS_NO_MEMORY: some of
 * the strands may be there. */
MUST_CHECK enum status separatrix_add(struct separatrix *s,
                                      const struct branch *one,
                                      const struct branch *other);

struct crossing {
    double at;    /* the other coordinate, absolute */
    double error; /* bound: the curve's own there, rounding and the slack;
                     infinite where it is flat */
    size_t strand;
};

/* Where strand number i has its growing coordinate equal to w (absolute),
 * strand.lo <= w < strand.hi; to a few units of rounding. */
struct crossing separatrix_cross(const struct separatrix *s, size_t i,
                                 double w);

/* The stretch of the row w (absolute) on which strand i may be, anywhere within
 * its bar in both directions; infinite where it may run along the row to an end
 * of the chain.  False: the row is further than that from the strand. */
bool separatrix_near(const struct separatrix *s, size_t i, double w, double *lo,
                     double *hi);

/* All crossings at w, ascending; their number.  out has room for s->count. */
size_t separatrix_row(const struct separatrix *s, double w,
                      struct crossing out[]);

/* The area between lo and strand i, taken no further than lo .. hi, over the
 * rows from .. to (all absolute, finite, inside the strand's range): the
 * integral of clamp(at, lo, hi) - lo by w in this measure.  *error bounds
 * quadrature, curve and rounding. */
double separatrix_area(const struct separatrix *s, size_t i, double from,
                       double to, double lo, double hi, struct measure m,
                       double *error);

/* A second call is harmless. */
void separatrix_free(struct separatrix *s);
