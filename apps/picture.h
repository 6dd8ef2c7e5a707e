/* picture.h -- a study as a figure. */
#pragma once

#include "output.h"
#include "study.h"

/* Adds to *p the diagram that the study holds (picture_diagram.h), or else the
 * portrait: over the basins, or one over each field of the cells that the study
 * asks for, which are computed here; the first is called "". */
void picture_study(const struct study *s, const struct monitor *monitor,
                   struct panels *p);
