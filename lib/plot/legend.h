/* legend.h -- the lines of a figure's legend, each text once. */
#ifndef PLOT_LEGEND_H
#define PLOT_LEGEND_H

#include "layer.h"

enum { LEGEND_MAX = 24, LEGEND_GAP = 18, LEGEND_SAMPLE = 42 }; /* lines; px */

struct legend_line {
    const char *text;                 /* borrowed */
    const struct figure_layer *layer; /* borrowed; NULL: a shade */
    enum figure_role role;
};

struct legend {
    struct legend_line line[LEGEND_MAX];
    size_t count;
    size_t left_out; /* more than LEGEND_MAX */
    double width;    /* of the widest text, in font sizes */
};

/* Curves and marks first, shades last. */
struct legend legend_of(const struct figure *f);

#endif
