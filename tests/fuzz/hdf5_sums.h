/* hdf5_sums.h -- the checksums of an HDF5 file put right, without which no
 * change of its metadata would get past HDF5's first look. */
#pragma once

#include <stddef.h>
#include <stdint.h>

/* Of the superblock, the object headers and their continuations, the heads of
 * fractal heaps and of B-trees (HDF5 File Format Specification 3.0), wherever
 * they stand in bytes[0 .. size-1]; the rest stays. */
void hdf5_sums_mend(uint8_t *bytes, size_t size);
