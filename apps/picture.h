/* picture.h -- a study as a figure. */
#ifndef APPS_PICTURE_H
#define APPS_PICTURE_H

#include "study.h"

/* Draws into path (.svg, .pdf, .png) the diagram that the study holds
 * (picture_diagram.h), or else the portrait: over the basins, or one over each
 * field of the cells that the study asks for, which are computed here: files
 * named after picture_panel.  Errors as figure_write; STATUS_STOPPED. */
MUST_CHECK enum status picture_draw(const struct study *s, const char *path,
                                    bool keep_script,
                                    const struct monitor *monitor,
                                    struct fault *why);

/* What the name of file i of the picture has more than path (panel.h): "" of
 * the first; NULL past the last. */
const char *picture_panel(const struct study *s, size_t i);

#endif
