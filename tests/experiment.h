/* experiment.h -- synthetic measurements with normal noise. */
#pragma once

#include <math.h>

#include "check.h"
#include "least.h"

/* Box & Muller, Ann. Math. Stat. 29, 1958. */
static inline double check_normal(uint64_t *rng)
{
    const double r = sqrt(-2.0 * log(1.0 - check_uniform(rng, 0.0, 1.0)));

    return r * cos(2.0 * 3.14159265358979324 * check_uniform(rng, 0.0, 1.0));
}

enum { EXPERIMENT_MAX = 64 };

struct experiment {
    double x[EXPERIMENT_MAX], value[EXPERIMENT_MAX], error[EXPERIMENT_MAX];
    size_t count;
};

/* `count` points, evenly from lo to hi, of curve(x) with this relative noise,
 * of which error[] tells. */
static inline struct experiment experiment_make(double curve(double x),
                                                double lo, double hi,
                                                size_t count, double noise,
                                                uint64_t *rng)
{
    struct experiment e = { .count = count };

    for (size_t i = 0; i < count; i++) {
        e.x[i] = lo + (hi - lo) * (double) i / (double) (count - 1);
        e.error[i] = noise * curve(e.x[i]);
        e.value[i] = curve(e.x[i]) + e.error[i] * check_normal(rng);
    }
    return e;
}

static inline struct measured experiment_blind(const struct experiment *e)
{
    return (struct measured){ e->x, e->value, NULL, e->count };
}

static inline struct measured experiment_known(const struct experiment *e)
{
    return (struct measured){ e->x, e->value, e->error, e->count };
}
