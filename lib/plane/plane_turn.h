/*
 * plane_turn.h -- a trap as large as an orbit that turns about a focus allows.
 *
 * An orbit that starts on the row of a focus, goes round and comes back to the
 * row nearer to it bounds, with the part of the row between, a region that no
 * orbit leaves: along that part all orbits come in.  Where the divergence of
 * the field, or of the field over coordinates, is nowhere > 0 there and not 0
 * everywhere, there is no closed orbit in it (Bendixson, Acta Math. 24 (1901)
 * 1; Dulac, C. R. 204 (1937) 1703), and if it holds no other equilibrium all
 * its orbits go to the focus (Poincare and Bendixson).
 */
#pragma once

#include "plane_study.h"

/* Fills r->turn, s->rest[..] being all that is known and r one of these: the
 * largest turn, up to a factor of TOL_TURN_FACTOR, none if there is none.
 * STATUS_NO_MEMORY. */
MUST_CHECK enum status plane_turn_find(const struct plane_study *s,
                                       struct plane_rest *r);

/* Whether an absolute point is inside that of this direction of time. */
bool plane_turn_holds(const struct plane_study *s, const struct plane_rest *r,
                      bool backward, struct vec2 z);

/* Whether a box of the chart is proved to have no closed orbit in it.
 * STATUS_NO_MEMORY. */
MUST_CHECK enum status plane_turn_forbids(const struct plane_study *s,
                                          struct box b, bool *out);

/* A second call is harmless. */
void plane_turn_free(struct plane_turn *t);
