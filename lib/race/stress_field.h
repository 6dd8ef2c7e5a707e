/* stress_field.h -- fate, slip, time, friction and peaks of a cell, beside an
 * orbit in 113 bits. */
#pragma once

#include "cells.h"
#include "quad_orbit.h"
#include "stress_row.h"

/* What the program says of the cell: its label in the map, its numbers where
 * they were asked for (bits of enum cell_field); `o` is the truth. */
struct stress_cell {
    int8_t label; /* enum fate */
    struct cell cell;
    unsigned which;
};
void stress_field_judge(const struct stress_cell *c, const struct quad_orbit *o,
                        struct stress_row *row);
