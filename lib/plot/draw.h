/* draw.h -- figures into files. */
#pragma once

#include "figure.h"

/*
 * Draws f[i] into path[i], whose ending chooses the format: .svg, .pdf or .png,
 * each as large as the page says; all are made before any is moved.  With
 * keep_script, NAME.gp and NAME.dat stay beside NAME.svg, so that `gnuplot -d
 * NAME.gp` in that folder draws it again, but for its size on paper; NAME.dat
 * holds the clipped curves, thinned where no eye could tell.
 *
 * Everything is made in a temporary folder beside the target and moved into
 * place at the end, the figure first: a failure leaves no partial file, and
 * before the first move none at all.  The same figure gives the same bytes with
 * the same gnuplot and fonts (PDF: and the same time zone); the creation date
 * of a PDF, which gnuplot cannot leave out, is set to 1970.
 *
 * STATUS_BAD_ARGUMENT: unknown ending, an axis without a range, a page without
 * room for a plot.
 * STATUS_IO: the folder cannot be written.
 * STATUS_NO_GNUPLOT: gnuplot is missing or failed.
 * STATUS_NO_MEMORY, or what else the figure remembers.
 */
enum { FIGURES_MAX = 8 };
MUST_CHECK enum status figures_write(const struct figure f[],
                                     const char *const path[], size_t count,
                                     bool keep_script, struct fault *fault);
