/*
 * proof_polish.h -- a piece of a curve made as good as its doubles allow,
 * before it is verified: whatever comes out is a candidate, like any other.
 */
#pragma once

#include "interval_tape.h"
#include "proof_tube.h"

/* The piece begins where the last one ends, at theta, and its defect D = step G
 * - p' about its middle, whose integral is what p lacks but for terms of second
 * order, is added to it.  Neither is changed where D is not finite. */
void proof_polish(struct interval_tape *t, const struct proof_piece *last,
                  struct interval theta, struct proof_piece *p);
