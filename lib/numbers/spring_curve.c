#include "spring_curve.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "numbers_tolerance.h"
#include "steady.h"

const struct record_type record_spring =
    RECORD(spring_point, "spring_block", "stick-slip boundary, Fig 1(b)",
           FIELD(spring_point, REAL, v, "V_star",
                 "speed of pulling in units of V_star"),
           FIELD(spring_point, QUANTITY, k, "Pa/m",
                 "stiffness below which the block sticks and slips"),
           FIELD(spring_point, QUANTITY, k_quasistatic, "Pa/m",
                 "the same for a block without mass"));

static struct spring_point point_at(const struct spring_block *block,
                                    const struct law *law,
                                    const struct material *m, double v)
{
    const struct spring_limit at =
        spring_block_limit(block, law, m, logl((long double) v));
    const double k = (double) at.k, slow = (double) at.k_quasistatic;
    const double error = DBL_EPSILON + (double) at.relative_error;
    const struct quantity none = quantity_none(
        at.k > 0 ? "beyond the largest number"
                 : "mu_ss does not fall with the slip rate: stable at any "
                   "stiffness");

    if (!(at.k > 0) || !isfinite(k))
        return (struct spring_point){ v, none, none };
    return (struct spring_point){ v, quantity_of(k, k * error + DBL_MIN),
                                  quantity_of(slow, slow * error + DBL_MIN) };
}

enum status spring_curve_find(const struct spring_block *block,
                              const struct law *law, const struct material *m,
                              const double v[2], struct spring_curve *c)
{
    const long double lo = logl((long double) v[0]);
    const long double hi = logl((long double) v[1]);
    const int last = STUDY_SPRING_POINTS - 1;

    *c = (struct spring_curve){ .block = *block };
    c->at = malloc(STUDY_SPRING_POINTS * sizeof *c->at);
    if (c->at == NULL)
        return STATUS_NO_MEMORY;
    c->extrema = extremum_find(law, m, c->extremum);
    for (int i = 0; i <= last; i++) {
        const double at = (double) expl(lo + (hi - lo) * i / last);
        if (logl((long double) at) < steady_x_max(law))
            c->at[c->count++] = point_at(block, law, m, at);
    }
    return STATUS_OK;
}

void spring_curve_free(struct spring_curve *c)
{
    free(c->at);
    *c = (struct spring_curve){ .at = NULL };
}
