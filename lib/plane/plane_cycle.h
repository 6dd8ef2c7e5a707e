/* plane_cycle.h -- the list of closed orbits that curves of a plane wind on to.
 */
#pragma once

#include "plane_study.h"

/* The number of the cycle with these returns, s->cycles where it is none of
 * them; and the same, a new one being added where it attracts
 * orbits beside it (backward in time, if it is not stable).  STATUS_NO_MEMORY.
 */
size_t plane_cycle_find(const struct plane_study *s, const struct winding *w,
                        bool stable);
MUST_CHECK enum status plane_cycle_add(struct plane_study *s,
                                       const struct winding *w, bool stable,
                                       size_t *index);

/* Adds the integrals of the divergence and of its size over time, on a piece up
 * to theta. */
void plane_cycle_divergence(const struct planar *sys, const struct curve *c,
                            size_t piece, double theta, double sum[2]);
