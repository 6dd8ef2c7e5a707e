/*
 * timeline.h -- what happened along an orbit, from the hits of its events:
 * turns that are only rounding are dropped, and each event gets a bar from a
 * second orbit at another tolerance.
 */
#pragma once

#include "transient.h"

/* The events of `fine` that `coarse` sees too, in the order of time; both were
 * watched by w.  *event is owned by the caller, and has room for one more.
 * STATUS_NO_MEMORY: *event and *count untouched. */
MUST_CHECK enum status timeline_find(const struct slider *s,
                                     const struct moment_watches *w,
                                     const struct orbit *coarse,
                                     const struct orbit *fine,
                                     struct transient_event **event,
                                     size_t *count);
