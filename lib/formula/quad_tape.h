/*
 * quad_tape.h -- a tape in 113 bits: its constants as numbers, and what it
 * computes at offsets from the anchor.
 */
#pragma once

#include "constants.h"
#include "quad.h"
#include "real_tape.h"

#define TAPE_SCALAR   quad
#define TAPE_CONSTANT quad
#define TAPE_KIND(f)  quad_##f
#include "number_tape.h"
#undef TAPE_SCALAR
#undef TAPE_CONSTANT
#undef TAPE_KIND

/* Rates of the chart, rate[i] exp(scale); value 0 of the tape in *value. */
void quad_tape_field(const struct quad_tape *t, quad X, quad Y, quad rate[2],
                     quad *scale, quad *value);
