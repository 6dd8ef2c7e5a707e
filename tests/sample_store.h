/* sample_store.h -- an HDF5 file with one of everything that lib/store puts:
 * /provenance (texts), /equilibria (two records of every kind of field),
 * /none (no records), /manifold/stable_{upper,lower} (12 columns along arc),
 * /critical and /absent (one record as scalars), /basin (two layers). */
#pragma once

#include "record.h"
#include "store.h"

enum {
    SAMPLE_POINTS = 40,
    SAMPLE_ROWS = 300,
    SAMPLE_COLUMNS = 20,
    SAMPLE_AXES = 6,  /* two n, two arc, psi, v */
    SAMPLE_TIES = 46, /* of a data set to an axis */
};

extern const struct record_array sample_states; /* those of /equilibria */

/* Cell of /basin/margin; the last row is never written. */
double sample_margin(size_t row, size_t column);

/* All groups into an open store. */
MUST_CHECK enum status sample_put(struct store *st);

/* A whole file; asserts that no HDF5 handle stays open, come what may. */
MUST_CHECK enum status sample_write(const char *path, struct fault *fault);
void sample_must_write(const char *path);

void sample_no_handles(void);
