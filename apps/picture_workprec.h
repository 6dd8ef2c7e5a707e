/* picture_workprec.h -- work-precision diagrams as figures: true error against
 * run time, one file for each quantity. */
#ifndef APPS_PICTURE_WORKPREC_H
#define APPS_PICTURE_WORKPREC_H

#include "workprec.h"

enum { PICTURE_WORKPREC_PATH = 4096 };

/* "a.svg" -> "a_v_plus.svg"; false where that is too long. */
bool picture_workprec_path(const char *path, enum workprec_quantity q,
                           char out[PICTURE_WORKPREC_PATH]);

/* Draws all quantities that have runs; errors as figure_write. */
MUST_CHECK enum status picture_workprec(const struct workprec *w,
                                        const char *path, bool keep_script,
                                        struct fault *why);

#endif
