/* stroke.h -- lines in pixels of the axes' box [0, w] x [0, h], clipped,
 * thinned and given arrowheads, so that gnuplot only has to connect points. */
#pragma once

#include "plane.h"
#include "scale.h"
#include "status.h"

/* Points in drawing order; a point with x = NaN separates two pieces. */
struct stroke {
    struct vec2 *at; /* owned */
    size_t count, room;
};

#define STROKE_EMPTY ((struct stroke){ .at = NULL })

/* One more point. */
MUST_CHECK enum status stroke_push(struct stroke *s, struct vec2 p);

/* The part of the polyline inside the box.  Where it crosses the frame it ends
 * exactly on the frame.  *out is emptied first, also on STATUS_NO_MEMORY. */
MUST_CHECK enum status stroke_clip(const struct scale *sx,
                                   const struct scale *sy, const double x[],
                                   const double y[], size_t count,
                                   struct stroke *out);

/* The part of the polygon inside the box (Sutherland & Hodgman, CACM 17 (1974)
 * 32-42), one piece; points that cannot be drawn are left out. */
MUST_CHECK enum status stroke_clip_region(const struct scale *sx,
                                          const struct scale *sy,
                                          const double x[], const double y[],
                                          size_t count, struct stroke *out);

/* Drops points in place; each dropped point is within `tolerance` pixels of
 * the line that replaces it, and the ends of pieces stay. */
void stroke_thin(struct stroke *s, double tolerance);

/* Sum over the pieces, in pixels. */
double stroke_length(const struct stroke *s);

/* An arrowhead (base, tip, base) of the given length, centred at a fraction of
 * the stroke's length, or where the piece is straight next to it, and pointing
 * on along it; false where the piece there is too short to carry one. */
bool stroke_head(const struct stroke *s, double fraction, double length,
                 struct vec2 head[3]);

/* An arrowhead on the segment from tail to tip. */
void stroke_barb(struct vec2 tail, struct vec2 tip, struct vec2 head[3]);

/* Leaves STROKE_EMPTY. */
void stroke_free(struct stroke *s);
