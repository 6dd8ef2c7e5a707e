/* progress.h -- the monitor of long work: a bar with rate and time left on a
 * terminal, JSON lines for programs, and Ctrl-C.  Ten lines a second at most,
 * but the first and the last of every stage. */
#pragma once

#include "monitor.h"
#include "options.h"

/* Prints as `how` says (to stderr) and stops the work after Ctrl-C, SIGTERM.
 * Work that does not hear of them for 0.7 s is ended where it stands, without
 * leaving anything (litter.h).  One a process. */
const struct monitor *progress_monitor(const struct options *o);

/* What is said there instead of "interrupted", until it is NULL. */
void progress_leaves(const char *text);

/* The work has heard, and what is left to do takes no time. */
void progress_heard(void);

/* Wipes the line on the terminal. */
void progress_end(void);
