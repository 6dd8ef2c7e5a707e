/*
 * orbit_stop.h -- where an orbit (orbit.h) is to stop, by its options: found on
 * the polynomials of its last piece, without jumping over any.
 */
#pragma once

#include "orbit.h"

/* Sets o->end and o->end_index if a stop holds at its start, the offset z. */
void orbit_stop_at(struct orbit *o, struct vec2 z);

/* The same for the first stop on the last piece, of length h on the clock;
 * *end: where, in (0, 1], else as it was.  Logs the events before it.
 * STATUS_NO_MEMORY: as event_scan. */
MUST_CHECK enum status orbit_stop_find(struct orbit *o, double h, double *end);
