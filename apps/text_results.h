/*
 * text_results.h -- the results of a run (result.h) for people: every one that
 * was asked for and has a title.
 *
 * A record is a line for each member; records of one or two numbers a line
 * each; longer ones a table, without bars.
 */
#pragma once

#include <stdio.h>

#include "result.h"

/* STATUS_NO_MEMORY, with a part printed. */
MUST_CHECK enum status text_results(FILE *out, const struct results *all);

/* Members of a record but the first by their own names, a line each. */
void text_rest(FILE *out, const struct record_array *a);
