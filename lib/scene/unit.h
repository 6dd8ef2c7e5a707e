/* unit.h -- numbers with a unit, "8e-3 m/s" or "8000 V_star": of each dimension
 * there are two, the SI's and the scene's own. */
#ifndef SCENE_UNIT_H
#define SCENE_UNIT_H

#include <stdbool.h>

#include "law.h"

enum dimension {
    DIMENSION_NONE,
    DIMENSION_RATE,
    DIMENSION_TIME,
    DIMENSION_LENGTH
};

enum unit { UNIT_BARE, UNIT_SI, UNIT_OWN };

/* "m/s" and "V_star", "s" and "L/V_star", "m" and "L"; "" for bare numbers and
 * without a dimension. */
const char *unit_name(enum dimension d, enum unit u);

/* The scene's own unit in the SI's. */
double unit_scale(enum dimension d, const struct material *m);

/* A number as number_read takes it, and perhaps a unit, with blanks between or
 * without.  False, nothing touched, for anything else. */
bool unit_read(enum dimension d, const char *text, double *value,
               enum unit *unit);

#endif
