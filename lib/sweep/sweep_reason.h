/* sweep_reason.h -- why numbers are missing, as small codes with words. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "status.h"

/* 0 "absent": for a reason beyond the list's room; 1 "present"; from 2 on one
 * code for each sentence met. */
enum { REASON_ABSENT, REASON_PRESENT, REASON_FIRST, REASONS_MAX = 126 };

struct sweep_reasons {
    char *text[REASONS_MAX]; /* owned; sentences by code, from REASON_FIRST */
    char *word[REASONS_MAX + 1]; /* owned; as CF flag_meanings: the sentence
                                    with underscores; NULL-ended */
    size_t count;                /* of codes */
};

/* With the two first codes.  STATUS_NO_MEMORY leaves *r empty. */
MUST_CHECK enum status sweep_reasons_init(struct sweep_reasons *r);

/* The code of a sentence, added if it is new.  STATUS_NO_MEMORY: *r as it
 * was. */
MUST_CHECK enum status sweep_reasons_code(struct sweep_reasons *r,
                                          const char *text, int8_t *code);

/* The words, NULL-ended, by code. */
static inline const char *const *sweep_reasons_words(
    const struct sweep_reasons *r)
{
    return (const char *const *) r->word;
}

/* A second call is harmless. */
void sweep_reasons_free(struct sweep_reasons *r);
