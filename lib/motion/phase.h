/*
 * phase.h -- the phases of sliding of Putelat & Dawes 2015, section 4.4:
 *   1  the fast smoothing of the interface, from the start until the state is
 *      on the v-nullcline, |mu - tan(alpha)| <= TOL_ARREST tan(alpha);
 *   2  along the v-nullcline, where the block slows while the interface
 *      roughens, until v falls below v_minus (or friction leaves tan(alpha)
 *      for good, where the block slides on);
 *   3  below v_minus, to the psi-nullcline, rest or creep.
 */
#pragma once

#include "record.h"

struct slider;
struct transient;

enum { PHASES = 3 };

/* In units of L/V_star and L; reasons where there is no such phase. */
struct phase {
    struct quantity start_time, end_time, start_slip, end_slip;
};
extern const struct record_type record_phase;

/* Of a run whose events, time and slip are known. */
void phase_find(const struct slider *s, const struct transient *t,
                struct phase out[PHASES]);
