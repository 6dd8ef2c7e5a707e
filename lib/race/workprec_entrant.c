#include "workprec_entrant.h"

/* A way of our own is one more row, and what it does in workprec_own.c. */
enum {
    ALL = (1u << WORKPREC_QUANTITIES) - 1u,
    SLIP = 1u << WORKPREC_SLIP,
    MOTION = 1u << WORKPREC_TRANSIENT | SLIP
};
static const struct workprec_entrant own[] = {
    { "slipway", false, ALL, WORKPREC_SLIPWAY, NULL },
    { "eigen", false, ALL & ~MOTION, WORKPREC_EIGEN, NULL },
    { "radau", false, MOTION, WORKPREC_RADAU, NULL },
    { "slow_curve", false, SLIP, WORKPREC_SLOW, NULL },
};
enum { OWN = sizeof own / sizeof *own };

bool workprec_entrant_at(size_t i, struct workprec_entrant *e)
{
    const struct method *m = i < OWN ? NULL : method_at(i - OWN);

    if (i < OWN)
        *e = own[i];
    else if (m)
        *e = (struct workprec_entrant){
            .name = m->name, .foreign = m->foreign, .can = ALL, .stepper = m
        };
    return i < OWN || m;
}
