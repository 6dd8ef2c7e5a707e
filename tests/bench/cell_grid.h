/*
 * cell_grid.h -- slip and time to arrest over a whole grid of states, from few
 * of them (patchwork.h): what a cell costs and how wrong it is.
 */
#pragma once

#include <stddef.h>

/* Prints one line: a law at alpha = 0.34, side x side cells, relative accuracy
 * rtol; errors against whole orbits at 1e-8 from random cells. */
void cell_grid_report(const char *law, size_t side, double rtol);
