/*
 * store_records.h -- records (record.h) as columns of an HDF5 group.
 *
 * Each field becomes one data set named like it:
 *   RECORD_REAL      float64, missing = NaN
 *   RECORD_COUNT     int64
 *   RECORD_CODE      int8, missing = -1, `flag_values`, `flag_meanings`; the
 *                    words must hold no blanks (CF conventions, sec. 3.5)
 *   RECORD_TEXT      UTF-8 strings, empty for NULL
 *   RECORD_QUANTITY  float64 NAME and NAME_error, int8 NAME_exists (absent,
 *                    present), and NAME_conditioning and NAME_spread where
 *                    anybody asked (NaN: it cannot be told), likewise int8
 *                    NAME_proved (not_proved, enclosed, absent), float64
 *                    NAME_lo and NAME_hi, and why nothing is proved as
 *                    `comment` of NAME_proved or in NAME_not_proved; why
 *                    a value is absent stands in the attribute `comment` of
 *                    NAME for a single record, else in the text column
 *                    NAME_reason, empty where the value exists.
 */
#pragma once

#include "record.h"
#include "store.h"

/* One column of a->count (may be 0) values for each field.  `axis` names the
 * RECORD_REAL or RECORD_COUNT field that is the coordinate of all the others;
 * with NULL a coordinate `n` = 0, 1, 2, ... is added.  Sticks on failure, as
 * store.h says: STATUS_IO (a name put twice), STATUS_NO_MEMORY. */
MUST_CHECK enum status store_put_records(struct store *store, const char *group,
                                         const struct record_array *a,
                                         const char *axis);

/* The same for one record of `type`, as scalar data sets. */
MUST_CHECK enum status store_put_scalars(struct store *store, const char *group,
                                         const struct record_type *type,
                                         const void *record);
