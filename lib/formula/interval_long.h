/*
 * interval_long.h -- sums, differences, products and quotients (over what is
 * not 0) of intervals of 64 bits, inline: most of what a proof does.
 */
#pragma once

#include <float.h>
#include <math.h>

#include "interval.h"

#define LINK    static inline
#define REAL    long double
#define FN(f)   f##l
#define NAME(x) x
#define OWN(x)  x##_64
#define UNIT    0x1p-63L
#define LEAST   0x1p-16445L
#define MOST    LDBL_MAX
#include "interval_sums.h"

#include "interval_done.h"
#undef LINK

static inline struct interval interval_divide(struct interval u,
                                              struct interval w)
{
    return interval_times(u, inverse_64(w));
}
