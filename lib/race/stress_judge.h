/*
 * stress_judge.h -- what a case came to: the program's numbers beside those
 * of the 113-bit oracle.
 */
#ifndef RACE_STRESS_JUDGE_H
#define RACE_STRESS_JUDGE_H

#include "stress_truth.h"
#include "study.h"

enum stress_outcome {
    STRESS_EXACT,    /* every number within its bar by the oracle, and its
                        digits within STRESS_MISSING of what conditioning
                        allows */
    STRESS_DEGRADED, /* no lie, but digits, the oracle's word or the second
                        route's are missing: the reason says which */
    STRESS_NONE,     /* what was asked for does not exist; so says the oracle */
    STRESS_FAILED,   /* the program said that it could not */
    STRESS_LIE, /* further off than the bar, or a wrong existence or fate */
    STRESS_OUTCOMES
};
extern const char *const stress_outcome_names[];

enum stress_agreement { STRESS_DISAGREE, STRESS_AGREE }; /* -1: neither */

/* What the program says of a slope. */
struct stress_answer {
    bool saddle;
    int8_t upper_end, lower_end;
    struct {
        struct knee_number at[KNEES_MAX];
        size_t count, crossings;
    } knees[SIDES];                         /* all of them */
    struct quantity number[STRESS_NUMBERS]; /* with conditioning */
};
struct stress_answer stress_answer_of(const struct study *s);

struct stress_verdict {
    int8_t outcome; /* enum stress_outcome */
    double digits;  /* least -log10 of a relative true error; NaN: no number */
    double allowed; /* least that conditioning allows of a number */
    double missing; /* most that a number lacks of what conditioning allows */
    double bar;     /* largest |true error| over reported error */
    const char *worst;  /* the number of `missing`; NULL: none */
    const char *reason; /* static; NULL: exact */
};

/* Of a slope; agreement: enum stress_agreement. */
struct stress_verdict stress_judge(const struct stress_truth *t,
                                   const struct stress_answer *a,
                                   int8_t agreement);

/* Digits of an estimate of `truth`, of conditioning k: 0...STRESS_DIGITS. */
double stress_digits(double value, quad truth);
double stress_digits_allowed(double conditioning);

#endif
