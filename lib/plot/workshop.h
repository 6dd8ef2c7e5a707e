/* workshop.h -- a temporary folder beside the target, in which a figure is
 * made before it is moved into place. */
#pragma once

#include <stdio.h>

#include "status.h"

enum workshop_file {
    WORKSHOP_SCRIPT,
    WORKSHOP_DATA,
    WORKSHOP_FIGURE,
    WORKSHOP_FILES
};

struct workshop {
    char *folder;               /* owned: the temporary folder */
    char *name[WORKSHOP_FILES]; /* owned: names in it */
    char *made[WORKSHOP_FILES]; /* owned: paths in it */
    char *goal[WORKSHOP_FILES]; /* owned: where they belong */
};

#define WORKSHOP_EMPTY ((struct workshop){ .folder = NULL })

/* For path = DIR/NAME.ext: makes the folder; the files are NAME.gp, NAME.dat,
 * NAME.ext.  STATUS_IO where it cannot be made, STATUS_BAD_ARGUMENT for a name
 * with control characters. */
MUST_CHECK enum status workshop_open(const char *path, struct workshop *w,
                                     struct fault *fault);

/* Moves a file to its goal. */
MUST_CHECK enum status workshop_deliver(const struct workshop *w,
                                        enum workshop_file which,
                                        struct fault *fault);

/* Removes the folder with what is still in it; leaves WORKSHOP_EMPTY. */
void workshop_close(struct workshop *w);
