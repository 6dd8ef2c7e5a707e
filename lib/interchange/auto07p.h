/* auto07p.h -- the system as input of AUTO-07p: equations in C, NAME.c, files
 * of constants, and a script.  Parameters have their names in AUTO's output,
 * too. */
#pragma once

#include "interchange.h"

/* NAME.c: the field per unit of time, and x->steady as a start. */
void auto07p_write_equations(FILE *out, const struct interchange *x);

/* c.NAME: steady states continued in alpha, over every fold. */
void auto07p_write_steady(FILE *out, const struct interchange *x);

/* c.NAME.folds: the first fold of the solutions saved in s.NAME, continued in
 * (alpha, c); where x->has_folds. */
void auto07p_write_folds(FILE *out, const struct interchange *x);

/* NAME.auto: runs both and saves what they find, for `auto-07p NAME.auto`. */
void auto07p_write_script(FILE *out, const struct interchange *x);
