/* arrows.h -- the direction of a field at the cell centres of a grid. */
#pragma once

#include "window.h"

struct arrow {
    struct vec2 z;         /* absolute */
    struct vec2 direction; /* as it looks in the drawing (unit coordinates of
                              window.h), of length 1; 0 where the field is 0,
                              NaN where it is NaN */
    double log10_speed;    /* of |z'| in chart coordinates per unit of time;
                              -inf where the field is 0 */
};

struct arrows {
    struct arrow *at; /* owned; [column + row * columns], row 0 lowest */
    size_t columns, rows;
    size_t evaluations; /* of the field */
};

#define ARROWS_EMPTY ((struct arrows){ .at = NULL })

/* Cells are even in the drawing.  STATUS_BAD_ARGUMENT: window outside the
 * domain, no columns or rows; STATUS_NO_MEMORY.  Then *out is untouched. */
MUST_CHECK enum status arrows_find(const struct planar *system,
                                   const struct window *window, size_t columns,
                                   size_t rows, struct arrows *out);

/* A second call is harmless. */
void arrows_free(struct arrows *a);
