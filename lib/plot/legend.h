/* legend.h -- the lines of a figure's legend, each text once, and where they
 * stand. */
#pragma once

#include "label.h"
#include "layer.h"
#include "plane.h"
#include "scale.h"

enum { LEGEND_MAX = 24, LEGEND_PARTS = 3 };
enum { LEGEND_SAMPLE = 30, LEGEND_SKIP = 8, LEGEND_LINE = 18 }; /* px */

struct legend_line {
    const char *text;                        /* borrowed */
    const struct figure_layer *curve, *mark; /* borrowed; both NULL: a shade */
    enum figure_role role;
    struct label_part part[LEGEND_PARTS];
    size_t parts;
    struct vec2 at; /* px, its upper left corner, from that of the legend */
};

struct legend {
    struct legend_line line[LEGEND_MAX];
    size_t count;
    size_t left_out;  /* more than LEGEND_MAX */
    double text_room; /* px, of a text */
    struct vec2 size; /* px, of all */
};

/* Curves and marks first, shades last. */
struct legend legend_of(const struct figure *f);

/* In one column, px. */
double legend_width(const struct legend *l);

/* Breaks the texts and puts the lines in up to `most` columns that are `width`
 * px wide together, as few as make it lowest. */
void legend_arrange(struct legend *l, double width, size_t most);

/* Where a legend of this size hides least of what is drawn: its upper left
 * corner, in px from the lower left one of the plot. */
struct vec2 legend_corner(const struct figure *f, const struct scale *x,
                          const struct scale *y, struct vec2 size);
