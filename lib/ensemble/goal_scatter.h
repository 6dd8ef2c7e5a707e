/*
 * goal_scatter.h -- what the scatter of parameters, "a: X +- S", makes of the
 * answers to states of a system, to first order (plane_scatter.h), and with it
 * how likely a state goes where it goes.
 *
 * With k how far another fate is along an axis, in its chart, and s the spread
 * of k, the parameters being normal and k linear in them, the state is on its
 * own side of that boundary with probability Phi(|k|/s).  Of both axes the less
 * likely counts, for near one boundary they are the same.  As push_scatter.h it
 * knows nothing of how k bends, nor of boundaries that are not the nearest.
 */
#pragma once

#include "plane_answer.h"

/* Fills `spread` of the kicks that exist in answer[count], those of the states
 * in the study s, and stays.  STATUS_NO_MEMORY, STATUS_STOPPED. */
MUST_CHECK enum status goal_scatter_find(const struct plane_study *s,
                                         const double state[][2], size_t count,
                                         const struct monitor *monitor,
                                         struct plane_answer answer[]);
