/* spell.h -- the nearest known word to a misspelt one. */
#pragma once

#include <stddef.h>

/* Fewest insertions, deletions, changes and swaps of neighbours that turn a
 * into b (Damerau 1964, no letter touched twice), A and a being the same;
 * words are cut at 40 letters. */
size_t spell_distance(const char *a, const char *b);

/* Of a NULL-ended list the word that may have been meant, the nearest one, the
 * first among equals; NULL if none is near: one slip for every three letters
 * of the longer word, cut as above. */
const char *spell_nearest(const char *word, const char *const *known);
