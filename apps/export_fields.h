/* export_fields.h -- slip, time, friction and peaks of the grid's cells into
 * the group /basin. */
#ifndef APPS_EXPORT_FIELDS_H
#define APPS_EXPORT_FIELDS_H

#include "store.h"
#include "study.h"

/* Nothing where the study asks for no field.  The axes psi and v must be in the
 * group already. */
MUST_CHECK enum status export_field_layers(const struct study *s,
                                           struct store *out);

/* Rows first .. first + count - 1, computed here: also STATUS_STOPPED and
 * STATUS_NO_MEMORY. */
MUST_CHECK enum status export_field_rows(const struct study *s,
                                         struct store *out, size_t first,
                                         size_t count,
                                         const struct monitor *monitor);

#endif
