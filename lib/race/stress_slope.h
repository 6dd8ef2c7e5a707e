/* stress_slope.h -- the critical numbers of a case, twice by the program and
 * once by the oracle. */
#ifndef RACE_STRESS_SLOPE_H
#define RACE_STRESS_SLOPE_H

#include "stress_case.h"
#include "stress_oracle.h"
#include "stress_row.h"

/* Fills the row.  Only STATUS_NO_MEMORY is an error. */
MUST_CHECK enum status stress_slope_run(const struct stress_case *c,
                                        struct stress_oracle *oracle,
                                        struct stress_row *row);

#endif
