/*
 * sweep_refine.h -- where a sweep over one key needs more points.
 *
 * Each span between two points is halved (on the axis' own scale).  Where ln
 * v_plus or ln v_minus in the middle is further than the tolerance, and its
 * error bars, from the chord, or where one of the three points lacks it, the
 * halves are halved again.  A span with one end of a curve inside, a fold, is
 * halved until what is left of the curve is below the tolerance too: next to a
 * fold at x_f it goes like sqrt|x - x_f| (Kuznetsov, Elements of Applied
 * Bifurcation Theory, 2004, sec. 3.3), so that
 *
 *     |f(fold) - f(x1)| <= |f(x1) - f(x0)| sqrt(w)/(sqrt(w + h) - sqrt(w)),
 *
 * x1 the last point of the curve, x0 the one before, h = |x1 - x0|, w the
 * width of the span; and until w is below the tolerance times the length of
 * the axis, so that a curve that happens to be flat there ends in the right
 * place.  Spans where no curve is are left alone.
 */
#pragma once

#include <stdbool.h>

#include "sweep_rows.h"

enum { REFINE_CURVES = 2 };

/* Halvings of a span at most: next to a fold 2^-48 of it is as near as the
 * rounding of the key lets one come. */
enum { REFINE_DEPTH = 48 };

struct refine_span {
    double lo, hi;
};

struct sweep_refine {
    int curve[REFINE_CURVES]; /* columns; -1: none */
    double tol;
    bool is_log;              /* halved in ln x */
    double length;            /* of the axis, on its scale */
    struct refine_span *span; /* owned; those whose middle is asked for */
    size_t spans;
    int depth; /* halvings so far */
};

/* All spans of sorted rows that need a middle, curve[], tol and is_log set
 * before.  STATUS_NO_MEMORY. */
MUST_CHECK enum status sweep_refine_init(struct sweep_refine *f,
                                         const struct sweep_rows *rows);

/* The middle of a span. */
double sweep_refine_middle(const struct sweep_refine *f, size_t span);

/* The rows, sorted, have all middles now: those halves which need a middle in
 * turn.  STATUS_NO_MEMORY leaves *f as it was. */
MUST_CHECK enum status sweep_refine_next(struct sweep_refine *f,
                                         const struct sweep_rows *rows);

/* A second call is harmless. */
void sweep_refine_free(struct sweep_refine *f);
