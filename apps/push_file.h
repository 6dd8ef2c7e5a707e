/* push_file.h -- states and their answers as a file: CSV in the scene's units,
 * or the group /push of an HDF5 file. */
#pragma once

#include "ensemble.h"
#include "options.h"
#include "push.h"
#include "result.h"

/* Their results; of struct push_answers. */
extern const struct result *const push_tables[];

struct push_answers {
    const struct push_answer *at;
    size_t count;
    bool scattered; /* they have arrest */
};

/* By the ending of the path, .csv or .h5; "-": CSV to standard output.  drawn:
 * with the draws beside them, in .h5; NULL: none.  Errors as replace_file. */
MUST_CHECK enum status push_file_write(const struct scene *scene,
                                       const struct push_answers *answers,
                                       const struct ensemble *drawn,
                                       const char *path, struct fault *why);

/* That what -o names can be written (output_path_check), and has one of the
 * endings; STATUS_BAD_ARGUMENT. */
MUST_CHECK enum status push_file_check(const struct options *o,
                                       struct fault *why);
