/*
 * slope_law.h -- a law of formulas as one cell of a table:
 * "theta = ln(psi); psi_ss = 1/v; T = 1/v; state = positive; v_0 = 50".
 */
#pragma once

#include <stdio.h>

#include "law_typed.h"

/* Whether the cell is one of those, not a preset's name. */
bool slope_law_is(const char *cell);

void slope_law_write(FILE *out, const struct law_typed *t,
                     const struct material *m);

/* STATUS_BAD_SCENE with the reason, STATUS_NO_MEMORY; *t is then undefined. */
MUST_CHECK enum status slope_law_read(const char *cell, enum friction_form form,
                                      struct law_typed *t, struct fault *why);
