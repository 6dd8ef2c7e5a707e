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
 */
#ifndef FORMULA_PARSE_H
#define FORMULA_PARSE_H

#include "formula.h"
#include "status.h"

enum { PARSE_LETTERS = 10000, PARSE_DEPTH = 200 };

/* The formula's node in *out.  STATUS_BAD_SCENE with one line that begins with
 * "line L, column C: ", counted from 1 in `text`; *out is then untouched. */
MUST_CHECK enum status formula_parse(struct formula *f, const char *text,
                                     int *out, struct fault *why);

#endif
