/*
 * trace.h -- follows one zero set of a field from a point on it to the edge of
 * the window or back to the start: predictor along the tangent, corrector by
 * root finding across it.
 */
#pragma once

#include "polyline.h"
#include "window.h"
#include "zero.h"

/* A point known to lie on the zero set. */
struct seed {
    struct vec2 at;    /* u coordinates of zero.h */
    struct vec2 along; /* unit vector across which signs differ; inward on
                          the window's edge */
    bool on_edge;
    bool passed; /* some traced curve goes through it */
};

enum trace_end {
    TRACE_EDGE,   /* the last point is exactly on the window's edge */
    TRACE_CLOSED, /* the last point equals the first */
    TRACE_LOOSE,  /* cannot be followed further: a cusp, or the component
                     loses its sign to underflow */
};

struct trace {
    struct zero *zero;           /* borrowed */
    const struct window *window; /* borrowed; its box is the zero's */
    double chord;      /* deviation allowed, fraction of the drawing */
    struct seed *seed; /* borrowed; marked where passed */
    size_t seeds;
};

/* From the last point of `line`, which is on the zero set, with unit tangent
 * `tangent` there; appends points in u coordinates, inside [0, 1] x [0, 1].
 * TRACE_CLOSED can only happen when the line has one point.
 * STATUS_NO_MEMORY: the points so far are valid. */
MUST_CHECK enum status trace_run(const struct trace *t, struct vec2 tangent,
                                 struct polyline *line, enum trace_end *end);
