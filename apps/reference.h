/* reference.h -- the parts of the manual that are tables of the program:
 * Markdown for people, who have them under share/doc, and for tests, which
 * compare them with what scenes take and files hold. */
#pragma once

#include <stdio.h>

#include "status.h"

/* Every key of a scene, the laws, and the products with their stages. */
void reference_scene(FILE *out);

/* Every group, data set and attribute of result files.  STATUS_NO_MEMORY. */
MUST_CHECK enum status reference_hdf5(FILE *out);

/* Exit codes, and what the words of results mean. */
void reference_words(FILE *out);

/* Texts as they must stand in a table of Markdown: a bar would end the cell, it
 * is written with a backslash. */
void markdown_text(FILE *out, const char *text);

/* `word` `word` ...; the list is NULL-ended. */
void markdown_words(FILE *out, const char *const *words);
