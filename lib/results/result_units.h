/* result_units.h -- records told in other units (unit.h). */
#ifndef RESULTS_RESULT_UNITS_H
#define RESULTS_RESULT_UNITS_H

#include "result.h"

/* Where any is told otherwise puts a copy in place of the view's records, their
 * type told as well: units by their names there, and phi for psi at the
 * beginning of names, or behind "ln_".  STATUS_NO_MEMORY leaves a view that is
 * closed. */
MUST_CHECK enum status result_tell(const struct unit_system *u,
                                   struct result_view *v);

/* The name of the unit that a member of record i is in, "1": none. */
const char *result_unit(const struct record_array *a, size_t i,
                        const struct record_field *f);

#endif
