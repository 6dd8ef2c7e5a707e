/* hdf.h -- inside lib/store: HDF5 calls that remember the first failure.
 *
 * Every HDF5 answer (handle or code, negative on failure) goes through
 * hdf_took.  After a failure the handles are negative, each further call
 * refuses them, and hdf_close skips them; so sequences of calls stand in
 * plain order, without a branch after each. */
#ifndef STORE_HDF_H
#define STORE_HDF_H

#include <hdf5.h>

#include "status.h"

struct store {
    hid_t file;         /* owned; negative once closed */
    char *path;         /* owned; as the caller gave it */
    enum status status; /* of the first failure */
    char reason[256];   /* of the first failure; one line */
};

/* Returns the answer; a negative one is noted, with HDF5's own reason. */
int64_t hdf_took(struct store *st, int64_t answer);

/* Notes a failure of our own, e.g. STATUS_NO_MEMORY. */
void hdf_fail(struct store *st, enum status s, const char *reason);

/* st->status, with "PATH: reason" in *fault unless it is STATUS_OK. */
enum status hdf_blame(const struct store *st, struct fault *fault);

/* count * size bytes (at least one), zeroed; NULL is noted. */
void *hdf_memory(struct store *st, size_t count, size_t size);

/* Any kind of handle; a negative one is skipped. */
void hdf_close(hid_t id);

/* Property list of the given class with times off and creation order tracked
 * and indexed for attributes. */
hid_t hdf_properties(struct store *st, hid_t class);

/* The group at an absolute path; it and those above are made where missing. */
hid_t hdf_group(struct store *st, const char *path);

/* UTF-8 text of `size` bytes, padded with zeros, or H5T_VARIABLE. */
hid_t hdf_text_type(struct store *st, size_t size);

/* New attributes of an open object. */
void hdf_put_text(struct store *st, hid_t object, const char *key,
                  const char *text);
/* `count` numbers; memory holds them as `native`, the file as `type`. */
void hdf_put_numbers(struct store *st, hid_t object, const char *key,
                     hid_t type, hid_t native, size_t count,
                     const void *values);

#endif
