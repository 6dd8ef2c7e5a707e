/*
 * layout.h -- what result files hold, group by group: which record tables make
 * their columns, over which axes, and which attributes stand beside them.
 *
 * The files are written by export*.c; this table says the same for readers of
 * `slipway help --as hdf5`.  tests/cli_layout.py opens what all scenes make and
 * demands that neither knows more than the other.
 */
#ifndef APPS_LAYOUT_H
#define APPS_LAYOUT_H

#include "record.h"

enum layout_shape {
    LAYOUT_SCALARS,   /* one value each */
    LAYOUT_COLUMNS,   /* over one axis, a field of the type or n = 0, 1, ... */
    LAYOUT_AXES,      /* each over itself */
    LAYOUT_LAYERS,    /* over two axes of the group */
    LAYOUT_ATTRIBUTES /* of the group itself */
};

/* A group comes as one part or as several, one after another. */
struct layout_part {
    const char *group; /* K: 0, 1, ...; {a,b}: a, and b */
    const char *text;  /* what it is, and when it is there; NULL: as before */
    enum layout_shape shape;
    const char *along; /* "arc"; "psi, v"; NULL: no axis */
    const struct record_type *type;
};

/* Ends with group NULL. */
extern const struct layout_part layout_table[];

#endif
