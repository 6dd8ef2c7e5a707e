/* sweep_summary.h -- a layer of a sweep at one point in a few numbers. */
#pragma once

#include "sweep.h"

enum { SUMMARY_WORDS = 8 };

struct sweep_summary {
    size_t cells, present;        /* all of them; those that have a value */
    double least, greatest;       /* of numbers; NaN without any */
    size_t counts[SUMMARY_WORDS]; /* of codes, by code */
};

/* Of layer number k.  STATUS_IO with one line in *why, STATUS_NO_MEMORY. */
MUST_CHECK enum status sweep_summary_find(const struct sweep *s, size_t k,
                                          size_t point,
                                          struct sweep_summary *out,
                                          struct fault *why);
