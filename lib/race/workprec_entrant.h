/* workprec_entrant.h -- who takes part in a race: our own ways, then the
 * integrators of method.h. */
#ifndef RACE_WORKPREC_ENTRANT_H
#define RACE_WORKPREC_ENTRANT_H

#include "method.h"
#include "workprec_own.h"

struct workprec_entrant {
    const char *name;
    bool foreign;
    unsigned can;                 /* bits 1 << enum workprec_quantity */
    enum workprec_own own;        /* where stepper is NULL */
    const struct method *stepper; /* borrowed */
};

/* Number i; false beyond the last. */
bool workprec_entrant_at(size_t i, struct workprec_entrant *e);

#endif
