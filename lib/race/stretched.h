/* stretched.h -- a planar system in other units, offset = (unit.x X, unit.y Y),
 * its origin that of (X, Y), and observable i in those of unit rate[i]. */
#pragma once

#include "planar.h"

struct stretched {
    struct planar planar;                /* of (X, Y): must not move */
    const struct planar *of;             /* borrowed */
    struct vec2 unit;                    /* > 0 */
    double rate[PLANAR_OBSERVABLES_MAX]; /* > 0 */
};

/* Field, jacobian and rates of sys. */
void stretched_init(struct stretched *s, const struct planar *sys,
                    struct vec2 unit, const double rate[]);

/* An offset of it as one of the system. */
static inline struct vec2 stretched_offset(const struct stretched *s,
                                           const double u[])
{
    return (struct vec2){ s->unit.x * u[0], s->unit.y * u[1] };
}
