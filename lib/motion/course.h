/*
 * course.h -- what the orbits of a run (transient.h) share, and one of them:
 * until it leaves a window, comes to rest, or its side matters.
 */
#pragma once

#include "rest_left.h"
#include "transient.h"

/* Must not move. */
struct course {
    const struct slider *slider;
    double v;          /* at the start */
    struct vec2 start; /* offset */
    enum fate fate;
    struct moment_watches watches;
    struct box start_window; /* absolute: beyond it v runs away or fades */
    struct box window;       /* the same of the last orbit at its end */
    int depth;               /* powers of TOL_TRANSIENT_SLOW to fade by */
    bool rest;               /* looked out for */
    bool near; /* followed only as far as its side does not matter */
    struct orbit_options options;
};

/* Whether the scene ends the run before its fate does. */
bool course_is_limited(const struct transient_options *o);

/* The rest of *c, from its first four members and depth; `rest`: look out for
 * one. */
void course_set(struct course *c, const struct transient_options *o, bool rest);

/* Whether it comes to rest before any limit is reached, and what is left. */
bool course_rests(const struct course *c, const struct orbit *o,
                  struct rest_left *left);

/* Whether v and psi stay as they are to all digits, for ever: only time and
 * slip go on, and no limit of the scene's is to come. */
bool course_waits(const struct orbit *o);

/* An orbit that gets stuck is kept as far as it goes. */
MUST_CHECK enum status course_follow(struct course *c, double rtol,
                                     const struct monitor *monitor,
                                     struct drift *drift, struct orbit *out);
