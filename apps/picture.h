/* picture.h -- a study as a figure. */
#ifndef APPS_PICTURE_H
#define APPS_PICTURE_H

#include "study.h"

/* Draws the portrait into path (.svg, .pdf, .png): over the basins, or over the
 * first field of the cells that the study asks for, which is computed here.
 * Errors as figure_write; STATUS_STOPPED. */
MUST_CHECK enum status picture_draw(const struct study *s, const char *path,
                                    bool keep_script,
                                    const struct monitor *monitor,
                                    struct fault *why);

#endif
