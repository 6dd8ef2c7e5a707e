/* number.h -- numbers as users write them: decimal, with a point, whatever
 * the locale. */
#ifndef SCENE_NUMBER_H
#define SCENE_NUMBER_H

#include <stdbool.h>
#include <stdint.h>

/* A decimal number such as -1.5e-3, rounded to the nearest double, or "inf"
 * (".inf" in YAML).  False, *value untouched, for anything else: hexadecimals,
 * NaN, numbers beyond a double, blanks or letters before or after. */
bool number_read(const char *text, double *value);

/* Digits only, below 2^64.  False, *value untouched, for anything else. */
bool number_read_whole(const char *text, uint64_t *value);

enum { NUMBER_DECIMAL = 40 };

/* The fewest digits that read back as the same double, with a point. */
void number_decimal(double value, char text[NUMBER_DECIMAL]);

#endif
