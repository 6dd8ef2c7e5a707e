/* picture.h -- a study as a figure. */
#ifndef APPS_PICTURE_H
#define APPS_PICTURE_H

#include "study.h"

/* Draws the portrait into path (.svg, .pdf, .png); errors as figure_write. */
MUST_CHECK enum status picture_draw(const struct study *s, const char *path,
                                    bool keep_script, struct fault *why);

#endif
