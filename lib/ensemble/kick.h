/* kick.h -- the state that a push leads to. */
#pragma once

#include "scene.h"
#include "slider.h"

/* v in units of V_star and psi as the law's, of a block with this material:
 * where it is told from creep, the creep state with p->v added to its slip
 * rate.  False, and why (static), where there is none. */
bool kick_state(const struct slider *s, const struct scene_push *p,
                struct scene_start *out, const char **reason);
