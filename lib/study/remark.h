/* remark.h -- what is missing from a study's results, and how its orbits ended,
 * in plain words. */
#pragma once

#include "study.h"

/* What is missing and why, one plain sentence each; the number of sentences
 * written to text[] (static strings). */
size_t study_remarks(const struct study *s, const char *text[], size_t room);

/* Why a trajectory ended, in one word: "arrived", "left_window", ... */
const char *study_end_name(const struct trajectory *t);
