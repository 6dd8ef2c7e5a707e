/*
 * stated.h -- what a table states: which column is an input, a number, a
 * tolerance or a label, and what each cell says.
 *
 * A row states a number of a study under the name that it has in a sweep
 * (result_number.h): a decimal number, `none` or an infinity (there is none), a
 * word, or nothing (empty).
 */
#ifndef CHECK_STATED_H
#define CHECK_STATED_H

#include "slope_row.h"
#include "study_results.h"

enum said { SAID_NOTHING, SAID_NONE, SAID_NUMBER, SAID_CODE };

struct stated_value {
    enum said said;
    double number;
    double printed; /* half a unit of the number's last digit */
    int8_t code;
    const struct table_cell *cell; /* borrowed */
};

struct stated_column {
    const struct result_number *number; /* borrowed */
    size_t at;                          /* column of the table */
    size_t tolerance; /* column of its tolerance; STATED_NO_COLUMN: none */
};

#define STATED_NO_COLUMN ((size_t) -1)

/* What numbers of a table may come from. */
#define STATED_STAGES (STUDY_NUMBERS | ASKED_BY(SENSITIVITIES))

struct stated {
    const struct table *table;     /* borrowed */
    struct result_numbers numbers; /* owned; all that may be stated */
    struct stated_column *column;  /* owned; those that state something */
    size_t columns;
};

/* Resolves the header and reads every cell once, so that nothing is left to
 * complain of.  STATUS_BAD_SCENE with one line FILE:LINE:COL: in *why for a
 * column that is not known and a cell that cannot be read; STATUS_NO_MEMORY.
 * On failure *s is empty. */
MUST_CHECK enum status stated_read(struct stated *s, const struct table *t,
                                   struct fault *why);

/* A second call is harmless. */
void stated_free(struct stated *s);

/* What row says in column number i of s->column. */
struct stated_value stated_at(const struct stated *s, size_t row, size_t i);

/* The row's own tolerance for that value: absolute, from NAME_tol, or
 * relative, from `tolerance`.  False where the row has none. */
bool stated_tolerance(const struct stated *s, size_t row, size_t i,
                      double value, double *tolerance);

/* 10^(d - 15) from the row's digits_lost d; 0 without one. */
double stated_lost(const struct stated *s, size_t row);

/* What a row needs for all that it states: bits of enum product. */
unsigned stated_products(const struct stated *s, size_t row);

#endif
