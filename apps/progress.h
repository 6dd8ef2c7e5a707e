/* progress.h -- the monitor of long work: a bar with rate and time left on a
 * terminal, JSON lines for programs, and Ctrl-C.  Ten lines a second at most,
 * but the first and the last of every stage. */
#ifndef APPS_PROGRESS_H
#define APPS_PROGRESS_H

#include "monitor.h"
#include "options.h"

/* Prints as `how` says (to stderr) and stops the work after Ctrl-C, SIGTERM.
 * One a process. */
const struct monitor *progress_monitor(const struct options *o);

/* Wipes the line on the terminal. */
void progress_end(void);

#endif
