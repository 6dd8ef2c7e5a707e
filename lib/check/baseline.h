/*
 * baseline.h -- a table that regression.h holds to: what a scene gives today,
 * each number with its tolerance.
 *
 * A scene takes one row: name, law, parameters, alpha, and the numbers of a
 * slope (STUDY_NUMBERS), named as in a sweep; without a slope only those that
 * take none.  Numbers have 17 digits, inputs the fewest that read back as the
 * same double; inputs that the law does not use stay empty.  Behind each number
 * NAME stands NAME_tol, absolute: CHECK_RECORDED_BARS error bars and a
 * rounding.
 *
 * A system of formulas has a table of its own, of one row: name, scene and set
 * (plane_row.h), and the numbers that it has (plane_numbers.h).
 */
#pragma once

#include <stdio.h>

#include "scene.h"

struct baseline {
    FILE *out;   /* owned; writes into the text */
    char *text;  /* owned, zero-ended: CSV; NULL when empty */
    size_t size; /* of it */
    size_t rows;
    bool of_system; /* it is full */
};

/* Computes a scene's slope (at alpha and rtol the scene's) and adds its row,
 * the first time below a header.  `name` is a label.  Errors as
 * study_run; *b has then as many rows as before, or must be freed where memory
 * was out. */
MUST_CHECK enum status baseline_add(struct baseline *b, const char *name,
                                    const struct scene *scene,
                                    struct fault *why);

/* A second call is harmless. */
void baseline_free(struct baseline *b);
