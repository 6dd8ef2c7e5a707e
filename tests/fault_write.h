/*
 * fault_write.h -- makes one system call that writes files fail, as
 * fault_alloc.h does for allocations.
 *
 * Give a test the dependency `fault_write` (tests/meson.build).  Calls of our
 * own code only, not those inside libraries such as stdio.  A failing close
 * closes all the same.
 */
#pragma once

#include <stddef.h>

#define FAULT_WRITE_NEVER (-1L)

/* Of the calls from now on, number k (from 0) fails, once, with this errno. */
void fault_write_at(long k, int error);

/* The function that failed; NULL: none yet. */
const char *fault_write_failed(void);

/* From now on a write takes at most so many bytes; 0: as many as it likes. */
void fault_write_most(size_t bytes);
