/* export_basin.h -- a basin map into an open store, a block of rows at a
 * time, so that memory holds one block whatever the grid. */
#ifndef APPS_EXPORT_BASIN_H
#define APPS_EXPORT_BASIN_H

#include "store.h"
#include "study.h"

/* The layers of /basin but those of record_cell, and /basin/disagreement. */
extern const struct record_type record_basin, record_disagreement;

/* /basin: axes psi and v, label, the margins where the scene asks for them,
 * shares and the audit as attributes.  Computes the rows on the way.  Errors
 * of store.h, STATUS_NO_MEMORY, STATUS_STOPPED by the monitor. */
MUST_CHECK enum status export_basin(const struct study *s, struct store *out,
                                    const struct monitor *monitor);

#endif
