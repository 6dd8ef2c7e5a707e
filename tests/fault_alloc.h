/*
 * fault_alloc.h -- makes one allocation of the program under test fail.
 *
 * Give a test the dependency `fault_alloc` (tests/meson.build): the linker
 * then sends every malloc, calloc and realloc of our own code through here
 * (not those made inside shared libraries).  To make each fail once:
 *
 *     for (long k = 0; s != STATUS_OK; k++) {
 *         fault_alloc_at(k);
 *         s = work();    STATUS_NO_MEMORY while the k-th allocation exists
 *     }
 *     fault_alloc_at(FAULT_ALLOC_NEVER);
 */
#pragma once

#define FAULT_ALLOC_NEVER (-1L)

/* Of the allocations from now on, number k (from 0) fails, once. */
void fault_alloc_at(long k);

/* Allocations asked for since then, the failed one included. */
long fault_alloc_count(void);
