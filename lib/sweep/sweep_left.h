/*
 * sweep_left.h -- the points of a sweep that earlier runs, or runs of other
 * shares of it, have left in side files.
 */
#pragma once

#include "sweep.h"

/* Opens the side file of o, if there is one, and appends the rows in it and in
 * those of others to *left, sorted.  The columns and layers of *s are known.
 * STATUS_BAD_SCENE: a side file is of another sweep; STATUS_IO: it cannot be
 * read or written, or a run is writing it; STATUS_NO_MEMORY.  Then *why is one
 * line, or empty. */
MUST_CHECK enum status sweep_left_open(struct sweep *s,
                                       const struct sweep_options *o,
                                       struct sweep_rows *left,
                                       struct fault *why);
