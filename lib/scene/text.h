/* text.h -- copies of texts, and texts made fit for one line of a message. */
#pragma once

#include <stddef.h>

/* `size` bytes and a zero after them; owned by the caller, NULL without
 * memory. */
char *text_copy(const char *bytes, size_t size);

/* Writes text as one printable line of UTF-8 into out: control characters,
 * line and direction marks, and bytes that are not UTF-8 become \xNN.  What
 * does not fit into `size` bytes (5 or more) is cut between two characters,
 * with "..." where it was. */
void text_show(const char *text, char *out, size_t size);

/* The same, but the end of a long text stays and its beginning goes. */
void text_show_end(const char *text, char *out, size_t size);

/* A user's word as it stands in messages: text_shown(word).text. */
struct text_shown {
    char text[64];
};
struct text_shown text_shown(const char *text);

/* Which of a NULL-ended list it is; -1: none. */
int text_index(const char *text, const char *const *words);

/* "a, b or c" of a NULL-ended list, cut at size - 1. */
void text_list(const char *const *words, char *out, size_t size);
