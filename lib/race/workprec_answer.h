/* workprec_answer.h -- what a method answers, and how far that is from the
 * truth. */
#pragma once

#include "workprec_task.h"

enum { WORKPREC_VALUES = 2 * WORKPREC_ROWS_MOST };

/* Of the quantity asked for:
 *   v_plus, v_minus, x_excess  value[0]
 *   curve       point[side][0 .. points[side] - 1], offsets, outward
 *   transient   value[0], value[1]: the end, offset
 *   basin_rows  value[side * WORKPREC_ROWS_MOST + k]: x at row k, offset
 *   slip        value[k] of cell k */
struct workprec_answer {
    bool success; /* says the method */
    double value[WORKPREC_VALUES];
    struct vec2 point[WORKPREC_SIDES][WORKPREC_POINTS_MOST];
    size_t points[WORKPREC_SIDES];
    double reported;     /* bound on the error, in the measure of
                            workprec_error; NaN: the method has none */
    size_t calls, steps; /* 0: not counted */
};

/* The largest error of an answer, as workprec_quantity_texts says; not finite
 * where there is no answer. */
double workprec_error(const struct workprec_task *c, enum workprec_quantity q,
                      const struct workprec_answer *a);
