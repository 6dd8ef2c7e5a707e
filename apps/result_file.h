/* result_file.h -- one HDF5 file of results, whole or not at all. */
#pragma once

#include "result.h"
#include "scene.h"
#include "store.h"

struct ensemble;

/* All that was asked for of a run's results, after its provenance (that
 * command's), under that title; then its ensemble (drawn.h), unless NULL.  Rows
 * of layers are computed on the way; `monitor` may be NULL. Errors of
 * store_results.h, with one line in *why. */
MUST_CHECK enum status result_file_write(
    const char *command, const struct results *all, const struct scene *scene,
    const struct ensemble *drawn, const char *untitled, const char *path,
    const struct monitor *monitor, struct fault *why);

/* Opens *out in path's place, titled as the scene is, or else `untitled`;
 * scene may be NULL; `large`: it may be larger than memory (store.h).  Nothing
 * to end where it fails. */
MUST_CHECK enum status result_file_begin(struct store **out, const char *path,
                                         const struct scene *scene,
                                         const char *untitled, bool large,
                                         struct fault *why);

/* Path is the file now, if all was put (`s` OK); else it is what it was, and
 * *why keeps what was said already, or tells path and the status.  *out is
 * released. */
MUST_CHECK enum status result_file_end(struct store **out, const char *path,
                                       enum status s, struct fault *why);
