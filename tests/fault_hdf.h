/*
 * fault_hdf.h -- makes one HDF5 call of lib/store fail, as fault_alloc.h does
 * for allocations.
 *
 * Give a test the dependency `fault_hdf` (tests/meson.build).  The failing call
 * does nothing; those that close or free do their work and say that they
 * failed.
 */
#pragma once

#include <stdbool.h>

#define FAULT_HDF_NEVER (-1L)

/* Of the calls from now on, number k (from 0) fails, once. */
void fault_hdf_at(long k);

/* Calls since then, the failed one included. */
long fault_hdf_count(void);

/* The function that failed; NULL: none yet. */
const char *fault_hdf_failed(void);

/* Whether a function is among those that can be made to fail. */
bool fault_hdf_knows(const char *name);
