/* batch_keys.h -- inside batch.c: what is varied. */
#pragma once

#include "batch.h"

/* Takes the keys into *b, which has a scene; every draw then has a slope where
 * one is needed.  Errors as batch_init; what was taken stays in *b. */
MUST_CHECK enum status batch_keys_take(struct batch *b, const char *const key[],
                                       size_t keys, struct fault *why);

/* "NAME: WHAT", STATUS_BAD_ARGUMENT. */
enum status batch_keys_blame(struct fault *why, const char *name,
                             const char *what);
