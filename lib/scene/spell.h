/* spell.h -- the nearest known word to a misspelt one. */
#ifndef SCENE_SPELL_H
#define SCENE_SPELL_H

#include <stddef.h>

/* Fewest insertions, deletions, changes and swaps of neighbours that turn a
 * into b (Damerau 1964); words are cut at 40 letters. */
size_t spell_distance(const char *a, const char *b);

/* Whether b is near enough to a to be what was meant. */
int spell_is_near(const char *a, const char *b);

#endif
