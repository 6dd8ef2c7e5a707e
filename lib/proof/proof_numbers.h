/*
 * proof_numbers.h -- what a proof says of the numbers of a slope (numbers.h):
 * an enclosure, or why there is none.
 */
#pragma once

#include "proof.h"

struct proof_number {
    struct interval value;
    const char *not_proved; /* NULL: value holds it */
    bool absent;            /* that there is none is proved */
};

struct proof_numbers {
    struct proof_number v, psi, lambda_minus, lambda_plus;
    struct proof_number v_plus, ln_v_plus, v_minus, ln_v_minus, psi_at_v0;
    struct proof_number x_excess, x_deficit;
    struct proof_number mu_s_num, mu_s_mean, fracture_energy;
};

/* Borrows reasons from p. */
struct proof_numbers proof_numbers_of(const struct proof *p);
