/* rerun.h -- slipway info --rerun: does the scene in a file still make it? */
#pragma once

#include "command.h"

/* Runs the scene and overrides stored in o->file[0], of a folder of its own,
 * and prints "same bytes" (EXIT_DONE) or a line for each thing that differs
 * (EXIT_CHECK); with --json {"same_bytes": ..., "differences": [...]}.  Files
 * of stress and workprec hold no scene of their own: EXIT_USAGE. */
enum exit_code rerun(const struct options *o);
