/*
 * stress_judge.h -- what a case came to: the program's numbers beside those
 * of the 113-bit oracle.
 */
#pragma once

#include "stress_row.h"
#include "stress_truth.h"
#include "study.h"

enum stress_outcome {
    STRESS_EXACT,    /* every number within its bar by the oracle, and its
                        digits within STRESS_MISSING of what conditioning
                        allows */
    STRESS_DEGRADED, /* no lie, but digits or the oracle's word are missing: the
                        reason says which */
    STRESS_NONE,     /* what was asked for does not exist; so says the oracle */
    STRESS_FAILED,   /* the program said that it could not */
    STRESS_LIE, /* further off than the bar, or a wrong existence or fate */
    STRESS_OUTCOMES
};
extern const char *const stress_outcome_names[];

/* Of a state and of labels; -1: of a slope there is one route. */
enum stress_agreement { STRESS_DISAGREE, STRESS_AGREE };

/* What the program says of a slope. */
struct stress_answer {
    bool has_saddle;
    struct saddle_numbers saddle;
    struct critical_numbers critical; /* with conditioning */
};
struct stress_answer stress_answer_of(const struct study *s);

/* As it is called in sweeps and tables; and as the program has it. */
const char *stress_number_name(enum stress_number which);
const struct quantity *stress_answer_number(const struct stress_answer *a,
                                            enum stress_number which);

/* Of a slope: outcome and reason, digits, allowed, missing, bar and worst of
 * the row. */
void stress_judge(const struct stress_truth *t, const struct stress_answer *a,
                  struct stress_row *row);
