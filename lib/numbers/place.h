/*
 * place.h -- how well the place of a saddle is known, and what that makes of
 * the numbers at it: numbers N(x) of a saddle at x = ln v whose x is off by d
 * are off by |N'(x)| d, d the bar of the block, with N' along the place at one
 * slope.
 */
#pragma once

#include "numbers.h"

/* In the chart: d, and what follows for psi_ss or its logarithm. */
struct vec2 place_bars(const struct block *b);

/* Whether N' must be known, lest d be below the roundings of a number. */
bool place_is_felt(const struct block *b);

/* Adds |N'| d to the bars of *out, the numbers at b's anchor; knees are left
 * out. */
void place_spread(const struct block *b, struct critical_numbers *out);
