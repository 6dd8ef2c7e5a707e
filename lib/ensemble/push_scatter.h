/*
 * push_scatter.h -- what the scatter of the inputs, "a: X +- S", makes of the
 * answers to pushes, to first order as scatter.h has it of a study's numbers,
 * and with it how likely a push stops.
 *
 * With k = ln v_kick, which the separatrix is off in ln v, and s its spread,
 * the inputs being normal and k linear in them, the state is on its own side
 * with probability Phi(|k|/s).  Where just one of the two sides stops (creeps
 * or rests) that is the probability of arrest, or of none.  It knows nothing of
 * how k bends, of folds beyond which there is no saddle, and of boundaries that
 * are not the nearest: an ensemble does.
 */
#pragma once

#include "push.h"

/* Whose states they are: those of a neighbour, whose material may turn the same
 * push into another state.  False: it has none. */
struct push_source {
    bool (*states)(void *ctx, const struct scene *scene,
                   const struct slider *slider, struct push_state out[]);
    void *ctx;
};

/* push_find_all, and where inputs scatter `spread` of the numbers that exist,
 * and arrest; infinite and NaN where no neighbour tells.  STATUS_NO_MEMORY,
 * STATUS_STOPPED. */
MUST_CHECK enum status push_scatter_find(const struct push *p,
                                         const struct push_source *from,
                                         const struct push_state at[],
                                         size_t count,
                                         const struct monitor *monitor,
                                         struct push_answer answer[]);
