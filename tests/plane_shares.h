/* plane_shares.h -- the shares of a system's basins, held to what is known. */
#pragma once

#include <math.h>

#include "formulas.h"
#include "own_folder.h"

static inline const struct plane_share *share_of(const struct plane_study *s,
                                                 const char *name)
{
    for (size_t i = 0; i < s->basin.shares; i++)
        if (strcmp(s->basin.share[i].attractor, name) == 0)
            return &s->basin.share[i];
    CHECK(false, "no attractor %s", name);
    return NULL;
}

/* Within its bar, which is small. */
static inline void has_share(const struct plane_study *s, const char *name,
                             double value, double most)
{
    const struct quantity *q = &share_of(s, name)->fraction;

    CHECK(fabs(q->value - value) <= q->error && q->error <= most,
          "%s: %.17g +- %g, expected %.17g +- %g", name, q->value, q->error,
          value, most);
    assert_int_equal(s->basin.disagreements, 0);
}

/* Of what is divided by no curve that is known: not more than is true, and
 * nearly that. */
static inline void is_nearly(const struct plane_study *s, const char *name,
                             double value)
{
    const struct quantity *q = &share_of(s, name)->fraction;

    CHECK(q->value <= value + q->error && q->value >= value - 0.02,
          "%s: %.17g +- %g, expected %.17g or a little less", name, q->value,
          q->error, value);
    assert_int_equal(s->basin.disagreements, 0);
}
