/*
 * store.h -- one HDF5 file of results, whole or not at all.
 *
 * The layout is what the netCDF-4 format asks of HDF5, so that h5py, xarray,
 * ncdump and every HDF5 tool read the file: creation order tracked, every axis
 * a dimension scale of its own group, `units`, `long_name` and `_FillValue` on
 * every column, codes as int8 with CF `flag_values` and `flag_meanings`.  No
 * times, paths or names of machines: the same calls give the same bytes.
 *
 * A group is named by its absolute path ("/manifold/stable_upper"); it and
 * those above are made where missing.
 *
 * What is put must be new: a data set or attribute cannot be put twice.  The
 * first failure sticks: every later put returns it and writes nothing, and
 * store_commit says why in one line.  So a caller may stop at the first
 * failure or go on, and must call store_free either way.
 *
 *     s = store_create(path, title, &out, fault);
 *     if (s == STATUS_OK && put_my_results(out) == STATUS_OK) ...
 *     if (s == STATUS_OK)
 *         s = store_commit(out, fault);
 *     store_free(&out);
 */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "status.h"

struct store; /* opaque: owns an open HDF5 file */

/* HDF5 prints nothing from now on.  For programs, before their first store;
 * it starts HDF5, so those without a store should not call it. */
void store_silence(void);

/* "1.10.8": the version of HDF5 linked. */
const char *store_library_version(void);

/* A file to be: it grows in memory until store_commit, because HDF5 crashes
 * when a disk fills under it; a killed run leaves nothing behind.  The root
 * gets `Conventions` and `title`.  Fails early, before anything is computed,
 * where commit would: STATUS_IO and *fault for a missing or read-only folder
 * or a target that is not a regular file; STATUS_NO_MEMORY.  *store is NULL
 * on failure; free it with store_free. */
MUST_CHECK enum status store_create(const char *path, const char *title,
                                    struct store **store, struct fault *fault);

/* The same for a file that may be larger than memory: it grows on disk, in a
 * temporary file of the folder that takes its place at store_commit. */
MUST_CHECK enum status store_create_on_disk(const char *path, const char *title,
                                            struct store **store,
                                            struct fault *fault);

/* An existing file, to be read with store_read.h.  STATUS_IO and *fault when
 * it is missing, damaged or not HDF5; *store is then NULL. */
MUST_CHECK enum status store_open(const char *path, struct store **store,
                                  struct fault *fault);

/* Attributes of a group: UTF-8 text of any length, float64, int64. */
MUST_CHECK enum status store_put_text(struct store *store, const char *group,
                                      const char *key, const char *text);
MUST_CHECK enum status store_put_real(struct store *store, const char *group,
                                      const char *key, double value);
MUST_CHECK enum status store_put_count(struct store *store, const char *group,
                                       const char *key, int64_t value);

/* Writes all that was put to the path given to store_create (see replace.h),
 * or, after a failed put, nothing.  STATUS_IO or STATUS_NO_MEMORY and *fault;
 * the old file, if any, is then untouched.  Afterwards only store_free may be
 * called. */
MUST_CHECK enum status store_commit(struct store *store, struct fault *fault);

/* Closes; what was not committed is gone.  Leaves *store NULL, so a second
 * call is harmless. */
void store_free(struct store **store);
