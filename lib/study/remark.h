/* remark.h -- what is missing from a study's results, in plain words. */
#ifndef STUDY_REMARK_H
#define STUDY_REMARK_H

#include "study.h"

/* What is missing and why, one plain sentence each; the number of sentences
 * written to text[] (static strings). */
size_t study_remarks(const struct study *s, const char *text[], size_t room);

#endif
