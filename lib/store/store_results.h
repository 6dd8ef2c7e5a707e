/*
 * store_results.h -- the results of a run (result.h) into an HDF5 file: every
 * one that was asked for, has a path and is there, in the order of the tables.
 *
 * Scalars and columns as store_records.h has them; layers in blocks of rows,
 * so that a grid need not fit into memory; attributes NAME, and of a number
 * NAME_error, a word as text.  Numbers are as they are, whatever the units.
 */
#pragma once

#include "result.h"
#include "store.h"

/* Also STATUS_STOPPED by the monitor (may be NULL), which rows of layers are
 * told to, and what these return. */
MUST_CHECK enum status store_put_results(struct store *store,
                                         const struct results *told,
                                         const struct monitor *monitor);
