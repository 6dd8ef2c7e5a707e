/* study_tolerance.h -- the tunable numbers of what a scene asks for. */
#pragma once

#include "slow_tolerance.h"

/* The largest distance between two stored rows of a branch, in ln v or ln psi;
 * a reader's Hermite interpolation is within TOL_SAME of the curve. */
#define TOL_ROW_SPACING 0.5

/* Curves run on beyond the window by this much of its width. */
#define TOL_WINDOW_MARGIN 0.1

/* Conditioning (conditioning.c), of numbers to TOL_RTOL_DEFAULT: the first
 * change of an input, relative, a fold further than ten times that away;
 * smaller by TOL_RETRY at a time, down to that accuracy. */
#define TOL_CONDITION_NUDGE 1e-7
