/*
 * near_cut.h -- how far the orbit of a state beside the separatrix is known.
 */
#pragma once

#include <stdbool.h>

#include "orbit.h"

/* Of an orbit with the saddle at the origin and the drift it carries: whether
 * on its last piece it leaves the saddle again, where its side decides, or is
 * further off the true one than TOL_ARREST times its distance from the saddle.
 */
bool near_cut_is_due(const struct orbit *o);

/* Takes the last piece back, with what happens on it. */
void near_cut_back(struct orbit *o);
