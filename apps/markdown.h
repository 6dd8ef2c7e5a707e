/* markdown.h -- texts as they must stand in a table of Markdown. */
#pragma once

#include <stdio.h>

/* A bar would end the cell: it is written with a backslash. */
void markdown_text(FILE *out, const char *text);

/* `word` `word` ...; the list is NULL-ended. */
void markdown_words(FILE *out, const char *const *words);
