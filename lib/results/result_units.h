/* result_units.h -- records told in other units (unit.h). */
#pragma once

#include "result.h"

/* Where any is told otherwise puts a copy in place of the view's records, their
 * type told as well: units and names by what they are called there.
 * STATUS_NO_MEMORY leaves a view that is closed. */
MUST_CHECK enum status result_tell(const struct unit_system *u,
                                   struct result_view *v);

/* unit_value of an input that was read in these units: the shortest decimal, of
 * 15 digits at most, that is read as x; where there is none as it is. */
double result_input(const struct unit_system *u, const struct unit *unit,
                    double x);

/* What a member of such records is called there: phi for psi, tan_alpha for
 * alpha, unless the type has a member of that name. */
void result_told_name(const struct unit_system *u,
                      const struct record_type *type,
                      const struct record_field *f, char name[RESULT_NAME]);

/* The unit in which a member with this unit is told otherwise than it is; NULL
 * where it is not: of no such unit, or of an angle beside its tangent. */
const struct unit *result_told_unit(const struct unit_system *u,
                                    const struct record_type *type,
                                    const struct record_field *f,
                                    const char *own);

/* The name of the unit that a member of record i is in, "1": none. */
const char *result_unit(const struct record_array *a, size_t i,
                        const struct record_field *f);
