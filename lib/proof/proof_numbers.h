/*
 * proof_numbers.h -- what a proof says of the numbers of a slope (numbers.h):
 * an enclosure, or why there is none.
 */
#pragma once

#include "proof.h"

struct proof_number {
    struct interval_double value;
    const char *not_proved; /* NULL: value holds it */
    bool absent;            /* that there is none is proved */
};

enum { PROOF_NAMED = 14, PROOF_NUMBERS = PROOF_NAMED + 4 * KNEES_MAX };

/* By name, or all in this order; the knees of the upper and the lower branch,
 * those with a name as the records of numbers.h. */
struct proof_numbers {
    union {
        struct {
            struct proof_number v, psi, lambda_minus, lambda_plus;
            struct proof_number v_plus, ln_v_plus, v_minus, ln_v_minus;
            struct proof_number psi_at_v0, x_excess, x_deficit;
            struct proof_number mu_s_num, mu_s_mean, fracture_energy;
            struct {
                struct proof_number v, psi;
            } knee[2][KNEES_MAX];
        };
        struct proof_number at[PROOF_NUMBERS];
    };
};

extern const char *const proof_number_names[PROOF_NAMED];

/* Of which branch it is: 0 upper, 1 lower, -1 of the saddle. */
int proof_number_side(size_t which);

/* Borrows reasons from p. */
struct proof_numbers proof_numbers_of(const struct proof *p);
