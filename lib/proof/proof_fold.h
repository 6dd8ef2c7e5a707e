/*
 * proof_fold.h -- that a law of named components has no saddle at a slope, and
 * what becomes of all states then: mu_ss falls on one interval of v at most
 * (docs/proofs.md, 14), and does not pass tan(alpha) there.
 */
#pragma once

#include "law.h"
#include "proof_input.h"

/* What is proved of a slope without a saddle. */
enum proof_alone {
    PROOF_ALONE_NOT,   /* nothing */
    PROOF_ALONE_FAST,  /* tan(alpha) is above that interval's mu_ss: all states
                          go where those of the fast side go (proof_side.h) */
    PROOF_ALONE_SLOW,  /* below it: those of the slow side */
    PROOF_ALONE_RISING /* mu_ss rises: at most one steady state */
};

/* window: x = ln v between which mu_ss is largest, or least, unless it rises.
 */
enum proof_alone proof_no_saddle(const struct law *law,
                                 const struct material *m,
                                 const struct proof_inputs *in,
                                 double window[2]);

/* Where mu_ss rises: whether it does from -infinity to infinity, so that all
 * states go to one node; else that is not proved. */
bool proof_rises_through(const struct law *law, const struct material *m);
