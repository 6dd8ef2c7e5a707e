/* axis.h -- inside lib/store: dimension scales, the axes of data sets.
 *
 * HDF5 keeps the tie between a data set and its axes twice: each data set
 * names its axes in DIMENSION_LIST, each axis its data sets in REFERENCE_LIST
 * (The HDF Group, HDF5 Dimension Scale Specification, 2005).  Theirs rewrites
 * the second list at every tie; here it is kept in memory and written once. */
#pragma once

#include <hdf5.h>

struct store;

enum { AXES_MAX = 4 }; /* of a data set */

struct axis {
    struct axis *next; /* owned */
    hid_t set;         /* owned */
    hobj_ref_t at;     /* of the set */
    hsize_t extent;
    struct axis_user *users; /* owned */
    size_t count, room;
};

/* Makes the one-dimensional data set `name` an axis and takes it over.
 * Borrowed; NULL (noted) when out of memory. */
struct axis *axis_new(struct store *st, hid_t set, const char *name,
                      hsize_t extent);

/* The axis `name` of a group.  Borrowed; NULL (noted) when there is none. */
struct axis *axis_find(struct store *st, hid_t group, const char *name);

/* Ties a data set to its axes, which are not NULL. */
void axis_tie(struct store *st, hid_t set, int rank, struct axis *const axis[]);

/* Writes the lists of data sets: once, when all have been put. */
void axis_finish(struct store *st);

/* Of all axes. */
void axis_free(struct store *st);
