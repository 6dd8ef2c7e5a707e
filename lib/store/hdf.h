/* hdf.h -- inside lib/store: HDF5 calls that remember the first failure.
 *
 * Every HDF5 answer (handle or code, negative on failure) goes through
 * hdf_took.  After a failure the handles are negative, each further call
 * refuses them, and hdf_close skips them; so sequences of calls stand in
 * plain order, without a branch after each. */
#pragma once

#include "handles.h"
#include "status.h"

struct store {
    struct disk *disk;      /* owned; NULL: the file grows in memory */
    hid_t file;             /* owned; negative once closed */
    char *path;             /* owned; as the caller gave it */
    struct handles handles; /* owned */
    hid_t group;            /* owned; the one put to last, or negative */
    char *group_path;       /* owned; its path, or NULL */
    struct axis *axes;      /* owned; all put so far, the last first */
    enum status status;     /* of the first failure */
    char reason[256];       /* of the first failure; one line */
};

/* Returns the answer; a negative one is noted, with HDF5's own reason. */
int64_t hdf_took(struct store *st, int64_t answer);

/* Notes a failure of our own, e.g. STATUS_NO_MEMORY. */
void hdf_fail(struct store *st, enum status s, const char *reason);

/* st->status, with "PATH: reason" in *fault unless it is STATUS_OK. */
enum status hdf_blame(const struct store *st, struct fault *fault);

/* count * size bytes (at least one), zeroed; NULL is noted. */
void *hdf_memory(struct store *st, size_t count, size_t size);

/* Bytes of a type; zero is noted. */
size_t hdf_size(struct store *st, hid_t type);

/* Any kind of handle; a negative one is skipped. */
void hdf_close(hid_t id);

/* st->handles.space in a shape; rank 0: a scalar.  Negative on failure: in its
 * old shape it would make HDF5 read beyond what is written. */
hid_t hdf_space(struct store *st, int rank, const hsize_t extent[]);

/* The group at an absolute path; it and those above are made where missing.
 * Borrowed, until the next call. */
hid_t hdf_group(struct store *st, const char *path);

/* A new attribute of an open object, of `rank` 0 or 1; memory holds the values
 * as `native`, the file as `type`. */
void hdf_put(struct store *st, hid_t object, const char *key, int rank,
             size_t count, hid_t type, hid_t native, const void *values);

/* A text of any length; an empty one is a single zero. */
void hdf_put_text(struct store *st, hid_t object, const char *key,
                  const char *text);
