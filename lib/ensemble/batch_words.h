/* batch_words.h -- inside batch.c: texts that outlive the draws that had them.
 * As many as there are: which of them have a code (sweep_reason.h) is decided
 * in the order of the draws, not in that in which threads met them. */
#pragma once

#include <stddef.h>

struct batch_words {
    char **text; /* owned, and each text */
    size_t count, room;
};

/* The same text, that stays, the same for all threads; NULL: no memory. */
const char *batch_words_keep(struct batch_words *w, const char *text);

/* A second call is harmless. */
void batch_words_free(struct batch_words *w);
