/* sweep_file.h -- a sweep as an HDF5 file. */
#pragma once

#include "result.h"
#include "sweep.h"

/* What /sweep holds beside its axes and columns, for the reference pages. */
extern const struct result *const sweep_tables[];

/* Writes /sweep: the keys as axes named by their last word, and what else
 * numbers are given along (sweep_dim.h); over them, for every number of a point
 * NAME, NAME_error (and NAME_conditioning) and the int8 NAME_exists, whose
 * flag_meanings say why a number is missing; every code; every layer, one point
 * after another out of the side file.  Then /provenance.  STATUS_IO or
 * STATUS_NO_MEMORY with the path in *why; an old file is then untouched. */
MUST_CHECK enum status sweep_file_write(const struct sweep *s, const char *path,
                                        struct fault *why);
