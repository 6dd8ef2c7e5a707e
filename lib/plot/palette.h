/* palette.h -- roles to paint. */
#pragma once

#include "figure.h"

enum { PAINT_DASHES = 6 };

struct paint {
    const char *colour; /* "#rrggbb" */
    double width;       /* px */
    const double *dash; /* PAINT_DASHES dashes and gaps in line widths, 0 ends
                           them; none: solid */
};

/* The role's look with the overrides of the style. */
struct paint paint_of(struct figure_style style);

/* Tints of a map from lo to hi, equally far apart. */
enum { PALETTE_TINTS = 17 };
extern const char palette_map[FIGURE_COLOURS][PALETTE_TINTS][8];
