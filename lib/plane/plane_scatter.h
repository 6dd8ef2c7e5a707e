/*
 * plane_scatter.h -- what the scatter of parameters, "a: X +- S", makes of
 * numbers that take a whole study with its basins: to first order, as
 * plane_sensitivity.h has it of equilibria,
 *
 *     spread^2 = sum over these parameters a of (dq/da)^2 S^2,
 *
 * the derivatives being central differences of studies to TOL_RTOL_DEFAULT,
 * good to about two digits.
 */
#pragma once

#include "plane_study.h"

/* The numbers of a study; those that it has not are none. */
typedef enum status plane_scatter_numbers(void *ctx,
                                          const struct plane_study *s,
                                          struct quantity q[]);

/* Fills `spread` of those of q[count] that exist, numbers of s: infinite where
 * neighbours do not tell.  STATUS_NO_MEMORY, STATUS_STOPPED. */
MUST_CHECK enum status plane_scatter_find(const struct plane_study *s,
                                          plane_scatter_numbers *numbers,
                                          void *ctx, size_t count,
                                          const struct monitor *monitor,
                                          struct quantity *const q[]);

/* The same of s->basin.share and elsewhere. */
MUST_CHECK enum status plane_scatter_shares(struct plane_study *s,
                                            const struct monitor *monitor);
