/* stress_row.h -- one case as reported, and how it describes itself. */
#pragma once

#include <stdint.h>

#include "record.h"
#include "status.h"

struct stress_row {
    const char *name, *law, *settings; /* borrowed from the case */
    int8_t kind, form;                 /* enum stress_kind, friction_form */
    int8_t outcome;                    /* enum stress_outcome */
    int8_t agree;                      /* enum stress_agreement or -1 */
    double digits;  /* least -log10 of a relative true error; NaN: no number */
    double allowed; /* least that conditioning allows of a number */
    double missing; /* most that a number lacks of what conditioning allows */
    double bar;     /* largest |true error| over reported error */
    int64_t steps;  /* of the branches or the orbit; labels of a grid */
    double seconds; /* the program's */
    double oracle_seconds;
    int64_t oracle_evaluations;
    const char *worst;  /* static: the number that lacks most digits, or lies */
    const char *reason; /* static, or `fault`'s; NULL: exact */
    struct fault fault; /* of a case that failed */
};
extern const struct record_type record_stress;

/* Notes an outcome if it is worse than what was noted before, with why and of
 * which number (NULL: none); both are static, or the row's. */
void stress_row_say(struct stress_row *row, int outcome, const char *reason,
                    const char *worst);
