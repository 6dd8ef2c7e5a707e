/* proof_short.h -- short names of interval arithmetic, for formulas. */
#pragma once

#include "interval_math.h"

static inline struct interval point(long double x)
{
    return interval_point(x);
}

static inline struct interval times(struct interval u, struct interval w)
{
    return interval_times(u, w);
}

static inline struct interval add(struct interval u, struct interval w)
{
    return interval_add(u, w);
}
