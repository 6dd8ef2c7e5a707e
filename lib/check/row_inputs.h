/*
 * row_inputs.h -- what a row's numbers owe to its inputs: a table's inputs are
 * decimals, those of a computation their nearest doubles.
 */
#ifndef CHECK_ROW_INPUTS_H
#define CHECK_ROW_INPUTS_H

#include "row_numbers.h"

/* *cost: in the place of each quantity's value the most it changes when every
 * input of the row is rounded to a double,
 *
 *     CHECK_MARGIN sum_p |dq/dp| |p| 2^-53,
 *
 * in its own unit, by central differences; infinite where no neighbour has the
 * quantity that n has.  STATUS_NO_MEMORY, with *cost undefined. */
MUST_CHECK enum status row_inputs_cost(const struct slope_row *s, size_t law,
                                       double rtol, unsigned products,
                                       const struct row_numbers *n,
                                       struct row_numbers *cost);

/* Adds the two derivatives by alpha to *n, with bars (Ridders).
 * STATUS_NO_MEMORY, *n as it was. */
MUST_CHECK enum status row_inputs_derive(const struct slope_row *s, size_t law,
                                         double rtol, struct row_numbers *n);

#endif
