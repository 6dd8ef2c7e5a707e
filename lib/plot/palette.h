/* palette.h -- roles to paint. */
#ifndef PLOT_PALETTE_H
#define PLOT_PALETTE_H

#include "figure.h"

struct paint {
    const char *colour; /* "#rrggbb" */
    double width;       /* px */
    double dash, gap;   /* in line widths; 0: solid */
};

/* The role's look with the overrides of the style. */
struct paint paint_of(struct figure_style style);

/* Tints of a map from lo to hi, as a gnuplot palette definition. */
extern const char palette_map[];

#endif
