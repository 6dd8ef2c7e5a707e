/*
 * parts.h -- the side files of a computation that several share: beside
 * FILE.h5.part, that of one run alone, FILE.h5.part.K-of-N of share K.
 */
#pragma once

#include <stddef.h>

#include "status.h"

/* Share `share` of `shares`, from 1. */
struct part {
    size_t share, shares;
};

/* "3/8"; STATUS_BAD_ARGUMENT with a line. */
MUST_CHECK enum status part_parse(const char *text, struct part *out,
                                  struct fault *why);

/* PATH.K-of-N, owned by the caller; NULL without memory. */
char *part_path(const char *path, struct part part);

struct parts {
    struct part *part; /* owned; of those that exist, by N, then K */
    char **path;       /* owned; of each */
    size_t count, room;
};

/* Those of a side file; PATH may hold any characters.  STATUS_NO_MEMORY. */
MUST_CHECK enum status parts_find(const char *path, struct parts *out);

/* Whether all shares of each N are there, and there is one; if not,
 * STATUS_BAD_SCENE with a line that names the first that is not. */
MUST_CHECK enum status parts_check(const struct parts *p, const char *path,
                                   struct fault *why);

/* Removes the files. */
void parts_forget(const struct parts *p);

/* A second call is harmless. */
void parts_free(struct parts *p);
