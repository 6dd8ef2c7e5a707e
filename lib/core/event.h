/*
 * event.h -- where functions along a curve pass levels: found between samples
 * of a polynomial piece, located on it by root finding.
 */
#pragma once

#include <stdbool.h>

#include "curve.h"

enum { EVENT_COUNT_MAX = 24 };

/* Happens where value(s, u) passes the level along a curve u(s).  Arriving at
 * it counts, leaving it does not: a start on the section is no event.  Events
 * of one function that follow each other share its values. */
struct event {
    double (*value)(const void *ctx, double s, const double u[]);
    const void *ctx; /* borrowed */
    double level;
    int direction; /* > 0: rising only; < 0: falling only; 0: both */
    bool stop;     /* the curve ends here; otherwise only recorded */
};

struct event_hit {
    size_t which; /* index of the event */
    bool rising;  /* through the level */
    size_t piece; /* of the curve */
    double theta; /* on that piece */
    double s;     /* independent variable */
    double u[CURVE_DIM_MAX];
    double error[CURVE_DIM_MAX]; /* of u at the end of the piece, as far as the
                                    curve's maker knows; else 0 */
};

/* Hits in the order of the curve, and by how much its last piece ended
 * above each level. */
struct event_log {
    struct event_hit *hit; /* owned */
    size_t count, room;
    double last[EVENT_COUNT_MAX];
};

#define EVENT_LOG_EMPTY ((struct event_log){ .count = 0 })

/* Before the first piece: the events' values at the start. */
void event_begin(struct event_log *log, const struct event *e, size_t count,
                 double s, const double u[]);

/* Appends the hits on the last piece of c for 0 < theta <= *end, where
 * s = s0 + theta h.  A stop event sets *end to its theta and *stop to its
 * index; later hits are dropped.  Without one *stop = count.  There
 * and back between neighbouring samples (TOL_EVENT_SAMPLES a piece) is
 * missed.  STATUS_NO_MEMORY: hits so far are kept. */
MUST_CHECK enum status event_scan(struct event_log *log, const struct event *e,
                                  size_t count, const struct curve *c,
                                  double s0, double h, double *end,
                                  size_t *stop);

/* Cuts the last piece of c at theta = end in (0, 1], which becomes theta = 1,
 * also in the hits on that piece. */
void event_trim(struct event_log *log, struct curve *c, double end);

/* Drops the last piece of c and the hits on it. */
void event_drop(struct event_log *log, struct curve *c);

/* Leaves *log empty, so a second call is harmless. */
void event_free(struct event_log *log);
