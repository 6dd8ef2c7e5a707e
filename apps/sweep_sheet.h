/* sweep_sheet.h -- what the figures of a sweep have in common: axes along keys,
 * their labels, titles. */
#pragma once

#include "sheet.h"
#include "sweep.h"

/* Whether numbers are told in the SI. */
bool sweep_is_si(const struct sweep *s);

/* Where a value of the key is along its axis. */
double sweep_place(const struct sweep_axis *a, double x);

/* From lo to hi, and a rim on both sides, of the logarithm on a log axis; of
 * one value, around it. */
struct figure_axis sweep_around(const char *label, double lo, double hi,
                                bool is_log, double rim);

/* Words, letter and unit of key k; the name of a system's parameter. */
struct sheet_label sweep_label(const struct sweep *s, size_t k);

/* The slope is in it where no key is a slope's. */
struct sheet_text sweep_title(const struct sweep *s);

/* Slip rates in a text as the axes have them: V for v in the SI. */
void sweep_letters(const struct sweep *s, char *text);
