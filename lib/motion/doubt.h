/*
 * doubt.h -- how far an event along an orbit may be from where it was found:
 * the stretch of the orbit on which its function is no larger than what the
 * errors of the state make of it.  Where the function goes through zero at a
 * rate that is the error over the rate; a flat turn has a long one.
 */
#pragma once

#include "event.h"

struct slider;

/* The largest changes over the stretch. */
struct doubt {
    double time, slip, x, y; /* components of the orbit */
    double mu;
};

/* Of a hit of e on the curve c of an orbit in s (x, y, time, slip, ...), whose
 * x and y there are off by as much as `off` each, and e's function by as much
 * as `level` of its own. */
struct doubt doubt_find(const struct slider *s, const struct event *e,
                        const struct event_hit *hit, const struct curve *c,
                        double off, double level);
