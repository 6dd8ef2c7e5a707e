/*
 * real_tape.h -- a tape in doubles: its constants, made in long double or
 * more and rounded, and what it computes at offsets from the anchor.
 */
#pragma once

#include "tape.h"

#ifndef NUMBER_TERMS
#define NUMBER_TERMS 1024
#endif

#define TAPE_SCALAR   double
#define TAPE_CONSTANT long double
#define TAPE_KIND(f)  real_##f
#include "number_tape.h"
#undef TAPE_SCALAR
#undef TAPE_CONSTANT
#undef TAPE_KIND
