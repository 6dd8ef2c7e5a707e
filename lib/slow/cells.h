/*
 * cells.h -- many states of one slope: what becomes of each, how far and how
 * long the block slides before it stops, at what friction, and how fast at
 * most.
 *
 * Slip and time run from the state to arrest: within TOL_ARREST of the creep
 * or the sliding node in ln v and in ln psi, or v = 0; where v only fades, slip
 * has a limit and time none.  mu_mean is the work of friction over the slip,
 * (28); the peaks are the largest values on that way, ends included.
 */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "monitor.h"
#include "plane.h"
#include "record.h"
#include "status.h"

struct slider;

enum cell_field {
    CELL_SLIP,
    CELL_TIME,
    CELL_MU_MEAN,
    CELL_V_PEAK,
    CELL_MU_PEAK,
    CELL_FIELDS
};

/* Values in units of L, L/V_star, 1, V_star and 1; each error is absolute and
 * bounds the value's for the state as its doubles read.  Both are NaN where
 * nobody asked and where there is no such number: all five of a block that runs
 * away or is undecided; the time of one that rests only as t -> inf, its slip
 * and mean friction too where the slip grows without bound; the peak friction
 * of one that rests in finite time, for friction grows without bound as v
 * vanishes (like |ln v|); the mean friction over no slip, of a state that has
 * arrived already. */
struct cell {
    int8_t exit_reason; /* enum fate: by the state's own orbit */
    double slip, slip_error;
    double time, time_error;
    double mu_mean, mu_mean_error;
    double v_peak, v_peak_error;
    double mu_peak, mu_peak_error;
};

/* Of which nothing is known: undecided. */
extern const struct cell cell_unknown;

/* Field 0 is exit_reason; 1 + 2 k and 2 + 2 k are enum cell_field k and its
 * error. */
extern const struct record_field cell_fields[];
extern const struct record_type record_cell;

/* The states z[n], absolute chart points of s->plane.system, whose steady
 * states are known, into out[n]; `which`: bits 1u << enum cell_field, 0 for the
 * exit reasons alone.  Each error is at most rtol times its value, but near a
 * boundary of two fates, where doubles do not allow it and bars grow like the
 * inverse distance (a state too near to tell is undecided).
 *
 * In parallel; the same bits at any number of threads and whatever the other
 * states are.  The monitor (may be NULL) hears of "cells" done.
 * STATUS_BAD_ARGUMENT: rtol not in (0, 1) or a state outside the domain, out
 * untouched; STATUS_NO_MEMORY, STATUS_STOPPED: out partly filled. */
MUST_CHECK enum status cells_find(const struct slider *s, const struct vec2 z[],
                                  size_t n, double rtol, unsigned which,
                                  const struct monitor *m, struct cell out[]);
