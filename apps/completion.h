/* completion.h -- what a shell offers after Tab, out of the tables of commands
 * and options, the laws and the keys of scenes. */
#pragma once

#include <stdio.h>

/* A script for "bash", "zsh" or "fish", which asks `help --as complete`;
 * nothing for others. */
void completion_print(FILE *out, const char *shell);

/* What may stand where the cursor is, in the last of the words after the
 * program's name: lines of a word, a tab and what it means; ":file" and
 * ":folder" with a pattern for files. */
void completion_offer(FILE *out, const char *const word[], size_t count);
