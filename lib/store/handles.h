/* handles.h -- inside lib/store: the types, the space and the property lists
 * that every data set and attribute of a file needs, made once: making them
 * anew for each of a thousand attributes took half of all time. */
#pragma once

#include <hdf5.h>

#include "record.h"

struct store;

enum { HANDLE_KINDS = RECORD_TEXT + 1 };

/* All owned; negative where not made. */
struct handles {
    hid_t text;  /* UTF-8, padded with zeros; sized before each use */
    hid_t texts; /* UTF-8 of variable length, for columns */
    hid_t axes;  /* a row of references: DIMENSION_LIST */
    hid_t space; /* shaped before each use */
    hid_t group; /* property list of a group */
    hid_t set[HANDLE_KINDS]; /* of a data set with the fill value of its kind */
};

/* Nothing made; may be freed. */
struct handles handles_none(void);

/* Makes all of st->handles; a failure is noted. */
void handles_make(struct store *st);
void handles_free(struct handles *handles);

/* Gives `list` what every object of a file has: no times; creation order
 * tracked and indexed for attributes, and for links but in a data set. */
void handles_set_order(struct store *st, hid_t list, hid_t class);
