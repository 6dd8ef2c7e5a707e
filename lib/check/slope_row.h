/*
 * slope_row.h -- one slope as a row of a table spells it: law, form, material,
 * slope angle.
 *
 * Columns: law (a preset; A|B: the row holds for both; empty or `composed`:
 * theta, psi_ss, timescale, kinetics say it), form (asinh), mu_star a b L
 * V_star g c R V_c, eps2 (gives g where g is not given), alpha (rad).  What a
 * row leaves out is that of Table 2; V_c has no default.
 */
#pragma once

#include "scene.h"
#include "table.h"

enum { SLOPE_LAWS_MAX = 4 };

struct slope_row {
    struct law_typed *typed; /* owned: of a law of formulas; else NULL */
    struct law law[SLOPE_LAWS_MAX];
    size_t laws;
    struct material material;
    double alpha; /* NaN: not given */
};

/* Names of the columns that slope_row_read reads; NULL-ended. */
extern const char *const slope_row_columns[];

/* STATUS_BAD_SCENE with one line FILE:LINE:COL: in *why; *s is to be freed even
 * so. */
MUST_CHECK enum status slope_row_read(const struct table *t, size_t row,
                                      struct slope_row *s, struct fault *why);

/* A scene of the row's law number k, with default window; owns nothing and
 * needs no scene_free. */
struct scene slope_row_scene(const struct slope_row *s, size_t k, double rtol,
                             unsigned products);

/* The inputs of a scene as a row, which borrows its law's formulas and is not
 * to be freed. */
struct slope_row slope_row_of(const struct scene *scene);

/* After slope_row_read; a second call is harmless. */
void slope_row_free(struct slope_row *s);
