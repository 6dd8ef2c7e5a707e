/* picture_workprec.h -- work-precision diagrams as figures: true error against
 * run time, one file for each quantity. */
#pragma once

#include "output.h"
#include "workprec.h"

/* "_v_plus", ...: what each file is named after; ended by NULL. */
extern const char *const picture_workprec_panel[];

/* Adds one of each quantity that has runs. */
void picture_workprec(const struct workprec *w, struct panels *p);
