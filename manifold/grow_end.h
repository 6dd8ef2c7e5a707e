/* grow_end.h -- where a growing branch may stop: at its limit, by quadrature,
 * or where it goes on for ever. */
#pragma once

#include "grower.h"

/* Adds what is left of the branch, if that has a limit and little is left. */
bool grow_end_close(struct grower *g);

/* Whether what is left has no limit, though it hardly changes, and the less
 * the further it moves. */
bool grow_end_is_open(struct grower *g);
