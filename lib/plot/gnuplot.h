/* gnuplot.h -- runs gnuplot as a program, without a shell. */
#pragma once

#include "status.h"

/* Runs `gnuplot -d ./SCRIPT` in the folder and waits for it; the user's own
 * start-up files are not read, its input is empty and what it says is kept.
 * STATUS_NO_GNUPLOT when it cannot be started or ends with an error; the fault
 * then holds what it complained about first. */
MUST_CHECK enum status gnuplot_run(const char *folder, const char *script,
                                   struct fault *fault);
