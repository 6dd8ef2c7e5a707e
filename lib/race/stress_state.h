/* stress_state.h -- the fates of states and of the cells of a grid, by regions
 * and by orbits, beside the side on which the oracle's branches leave them. */
#ifndef RACE_STRESS_STATE_H
#define RACE_STRESS_STATE_H

#include "stress_case.h"
#include "stress_oracle.h"
#include "stress_row.h"

/* The first start of the case; fills the row.  Only STATUS_NO_MEMORY is an
 * error. */
MUST_CHECK enum status stress_start_run(const struct stress_case *c,
                                        struct stress_oracle *oracle,
                                        struct stress_row *row);

/* The labels of the case's grid. */
MUST_CHECK enum status stress_window_run(const struct stress_case *c,
                                         struct stress_oracle *oracle,
                                         struct stress_row *row);

#endif
