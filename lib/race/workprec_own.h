/*
 * workprec_own.h -- the quantities of a task by Slipway's own ways, with the
 * error bars they come with.
 */
#pragma once

#include "workprec_answer.h"

enum workprec_own {
    WORKPREC_SLIPWAY, /* what a study does by default: Taylor series in the
                         chart (grow.h); two orbits of tolerances ten apart;
                         whole orbits with bars (cells.h) */
    WORKPREC_RADAU,   /* one orbit (orbit.h, fate.h) */
    WORKPREC_SLOW,    /* slow_curve.h; its table, made once a slope, is given */
};

/* What is made once a slope, and not part of any run; owned. */
struct workprec_shared {
    struct fast_cells *slow; /* NULL: not made */
};
MUST_CHECK enum status workprec_shared_init(struct workprec_shared *k,
                                            const struct workprec_task *c);
void workprec_shared_free(struct workprec_shared *k);

/* *out as of the same run, with the calls that cells.h and fast_cells.h do not
 * count themselves, as far as they ask one state at a time; steps stay
 * uncounted. */
MUST_CHECK enum status workprec_own_count(const struct workprec_task *c,
                                          enum workprec_own how, double tol,
                                          struct workprec_answer *out);

void workprec_own_run(const struct workprec_task *c,
                      const struct workprec_shared *shared,
                      enum workprec_own how, enum workprec_quantity q,
                      double tol, struct workprec_answer *out);
