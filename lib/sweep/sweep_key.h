/* sweep_key.h -- what the keys of a scene are, for axes of files and figures.
 */
#pragma once

#include "scene.h"

struct sweep_key {
    const char *path; /* "slope.alpha" */
    const char *unit; /* UDUNITS; "1" if none */
    const char *text; /* one plain phrase */
};

/* Static; of a key that has no line in the table, what the schema says. */
struct sweep_key sweep_key_of(const char *path);

/* A checksum (sweep_journal.h) of all that a scene says but where its results
 * go, and of the program's version (NULL: none). */
uint64_t sweep_key_sum(const struct scene *c, const char *version);
