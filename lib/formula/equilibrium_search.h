/* equilibrium_search.h -- the parts of equilibria.c: boxes, and what is in
 * them. */
#pragma once

#include "equations.h"
#include "equilibria.h"
#include "interval.h"

struct search_box {
    struct interval_double side[2];
};

struct search_boxes {
    struct search_box *at; /* owned */
    size_t count, room;
};

struct equilibrium_search {
    struct equations e;
    struct interval_plan equation, rate; /* over the chart */
    struct system_window window;
    double period[2];     /* of angles, else 0 */
    formula_real turn[2]; /* the same in 113 bits */
    bool is_log[2];       /* the chart is a logarithm */
    double least[2];      /* sides of boxes that are not parted any more */
    struct search_boxes boxes, left; /* to be looked at, and undecided */
    struct system_equilibria *out;   /* borrowed */
};

/* Looks at all boxes, from those of the window on, in turn: those that are
 * open are parted, until they are too small or the work is done. */
MUST_CHECK enum status search_boxes(struct equilibrium_search *s);

/* A box in which the equations vanish once, and `place`, which holds where:
 * adds the equilibrium, unless it is outside the window or known.  False: it
 * could not be settled, or there is no room. */
bool search_settle(struct equilibrium_search *s,
                   const struct interval_double unique[2],
                   const struct interval_double place[2]);
