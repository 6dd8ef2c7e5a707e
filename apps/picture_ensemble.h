/* picture_ensemble.h -- an ensemble as figures. */
#pragma once

#include "ensemble.h"
#include "figure.h"
#include "output.h"

/* The panels of its figure (panel_path), NULL-ended: the distribution of v_plus
 * (or of the first number) with its quantiles, "_arrest" with pushes, "_matrix"
 * with parameters.  Without numbers the first is that of arrest. */
enum { PICTURE_ENSEMBLE_PANELS = 4 };
void picture_ensemble_panels(const struct scene *s,
                             const char *panel[PICTURE_ENSEMBLE_PANELS]);

/* Begins those panels.  STATUS_IO, STATUS_NO_MEMORY. */
MUST_CHECK enum status picture_ensemble(const struct ensemble *e,
                                        struct panels *p, struct fault *why);
