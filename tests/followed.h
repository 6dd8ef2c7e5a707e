/* followed.h -- transient.h at a slope, for its tests. */
#pragma once

#include "slope.h"
#include "transient.h"

/* The run from a state, which must be found. */
static inline struct transient follow(const struct slope *s, double v,
                                      double psi,
                                      const struct transient_options *o)
{
    struct transient t;
    const struct scene_start start = { v, psi };
    const enum status status =
        transient_find(&s->study.slider, start, o, NULL, &t);

    CHECK(status == STATUS_OK, "%s", status_text(status));
    return t;
}
