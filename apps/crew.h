/*
 * crew.h -- who computes beside this process: nobody (slipway), or the other
 * ranks of one run (slipway-mpi).  Only the first rank is heard: what the
 * others print goes nowhere.
 */
#pragma once

#include <stddef.h>

#include "monitor.h"
#include "status.h"

/* First and last in main(); the exit code of this process. */
void crew_begin(int *argc, char ***argv);
int crew_end(int code);

size_t crew_rank(void); /* 0 for the first */
size_t crew_ranks(void);

/* All ranks wait here for each other and leave with the worst status of any and
 * its line.  STATUS_STOPPED by the monitor of one ends the others, too. */
enum status crew_agree(enum status status, struct fault *why,
                       const struct monitor *monitor);

/* All leave with the first rank's number. */
size_t crew_told(size_t number);

/* Numbers 0, 1, ..., count - 1, each to one rank, which gets some in a row;
 * `count` when all are given out (sweep.h: struct sweep_share).  All ranks
 * begin again together with crew_share_begin. */
void crew_share_begin(void);
size_t crew_share_next(void *ctx, size_t count);
