/*
 * disk.h -- inside lib/store: a file that HDF5 writes on disk, of which it
 * never hears that a write failed.
 *
 * HDF5 1.10 crashes on closing a file that could not be flushed.  So a driver
 * of our own (H5FDregister) notes the first failure, says that all went well,
 * and the file is dropped at the end.
 */
#pragma once

#include <hdf5.h>

#include "status.h"

struct store;
struct disk;

/* A temporary file that will be `path` (replace.h).  STATUS_IO,
 * STATUS_NO_MEMORY; *disk is then NULL. */
MUST_CHECK enum status disk_open(const char *path, struct disk **disk,
                                 struct fault *fault);

/* Files made with this access list go there. */
void disk_choose(struct store *st, hid_t access);

/* Once HDF5 has closed it: it takes its place, or, where a write had failed, is
 * gone and *fault says why.  STATUS_IO. */
MUST_CHECK enum status disk_keep(struct disk **disk, const char *path,
                                 struct fault *fault);

/* It is gone.  A second call is harmless. */
void disk_drop(struct disk **disk);
