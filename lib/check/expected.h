/*
 * expected.h -- what a table states: which column is an input, a number, a
 * tolerance or a label, and what each cell says.
 *
 * A row states a number of a study under the name that it has in a sweep
 * (result_number.h): a decimal number, `none` or an infinity (there is none), a
 * word, or nothing (empty).
 */
#pragma once

#include "plane_study.h"
#include "slope_row.h"
#include "study_results.h"

enum expected_kind {
    EXPECTED_NOTHING,
    EXPECTED_NONE,
    EXPECTED_NUMBER,
    EXPECTED_CODE
};

struct expected_value {
    enum expected_kind kind;
    double number;
    double printed; /* half a unit of the number's last digit */
    int8_t code;
    const struct table_cell *cell; /* borrowed */
};

struct expected_column {
    const struct result_number *number; /* borrowed */
    size_t at;                          /* column of the table */
    size_t tolerance; /* column of its tolerance; EXPECTED_NO_COLUMN: none */
};

#define EXPECTED_NO_COLUMN ((size_t) -1)

/* What numbers of a table may come from. */
#define EXPECTED_STAGES (STUDY_NUMBERS | ASKED_BY(SENSITIVITIES))

struct expected {
    const struct table *table;      /* borrowed */
    bool of_systems;                /* plane_row.h */
    struct scene scene;             /* owned; of the first of these */
    struct plane_study frame;       /* owned; plane_numbers.h */
    struct result_numbers numbers;  /* owned; all that may be stated */
    struct expected_column *column; /* owned; those that state something */
    size_t columns;
};

/* Resolves the header and reads every cell once, so that nothing is left to
 * complain of.  STATUS_BAD_SCENE with one line FILE:LINE:COL: in *why for a
 * column that is not known and a cell that cannot be read; STATUS_NO_MEMORY.
 * On failure *s is empty. */
MUST_CHECK enum status expected_read(struct expected *s, const struct table *t,
                                     struct fault *why);

/* A second call is harmless. */
void expected_free(struct expected *s);

/* What row says in column number i of s->column. */
struct expected_value expected_at(const struct expected *s, size_t row,
                                  size_t i);

/* The row's own tolerance for that value: absolute, from NAME_tol, or
 * relative, from `tolerance`.  False where the row has none. */
bool expected_tolerance(const struct expected *s, size_t row, size_t i,
                        double value, double *tolerance);

/* 10^(d - 15) from the row's digits_lost d; 0 without one. */
double expected_lost(const struct expected *s, size_t row);

/* What a row needs for all that it states: bits of enum product. */
unsigned expected_products(const struct expected *s, size_t row);
