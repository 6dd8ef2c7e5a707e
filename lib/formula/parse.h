/*
 * parse.h -- reads a formula as people type it:
 *
 *     sum      product { (+ | -) product }
 *     product  sign { (* | /) sign }
 *     sign     [-] power                     -x^2 is -(x^2)
 *     power    atom [ ^ sign ]               x^y^z is x^(y^z)
 *     atom     number | name | function(sum) | (sum)
 *
 * Numbers are decimals, kept in 113 bits whatever the locale; names are the
 * leaves and named nodes of the graph; `pi` is one unless there is a leaf.
 * Functions are those of function.h, log10 and abs2, which is the square.
 */
#pragma once

#include <stddef.h>

#include "formula.h"
#include "status.h"

enum { PARSE_LETTERS = 10000, PARSE_DEPTH = 200 };

/* Where a formula or a name begins in what the user wrote. */
struct formula_place {
    const char *name;    /* borrowed: file or option; NULL: neither */
    size_t line, column; /* from 1; 0: none is meant */
};

/* The formula's node in *out.  STATUS_BAD_SCENE with one line that begins with
 * "line L, column C: ", counted from 1 in `text`; *out is then untouched. */
MUST_CHECK enum status formula_parse(struct formula *f, const char *text,
                                     int *out, struct fault *why);

/* As formula_parse, of a formula that begins there: the line begins with
 * "FILE:LINE: column C of the formula: ". */
MUST_CHECK enum status formula_parse_at(struct formula *f, const char *text,
                                        struct formula_place at, int *out,
                                        struct fault *why);

/* A decimal, perhaps with a sign, in 113 bits; else as formula_parse_at. */
MUST_CHECK enum status formula_parse_decimal(const char *text,
                                             struct formula_place at,
                                             formula_real *out,
                                             struct fault *why);

/* Whether formulas call a function by this name. */
bool formula_is_function(const char *name);

/* In 113 bits. */
formula_real formula_pi(void);

/* Writes "FILE:LINE:COLUMN: text"; STATUS_BAD_SCENE. */
enum status formula_blame(struct formula_place at, struct fault *why,
                          const char *format, ...)
    __attribute__((format(printf, 3, 4)));
