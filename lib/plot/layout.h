/* layout.h -- the page: which formats there are, where the box, the legend and
 * the texts go, in pixels from the lower left corner. */
#ifndef PLOT_LAYOUT_H
#define PLOT_LAYOUT_H

#include "legend.h"
#include "scale.h"

/* What differs between gnuplot's terminals, so that all three files look the
 * same: found by measuring their output. */
struct device {
    const char *extension;
    const char *terminal;
    const char *unit;    /* of the page's size */
    const char *options; /* of the terminal */
    double per_pixel;    /* page units per pixel */
    double font;         /* font size per pixel */
    double dash;         /* what gnuplot calls a dash of one line width */
    double spacing;      /* of the legend's lines: 18 px */
    double point;        /* point size that makes a disc of 1 px */
    const char *last;    /* stands near the end of a whole file only */
};

/* By the ending of the path; NULL if it is none of .svg, .pdf, .png. */
const struct device *device_find(const char *path);

struct layout {
    double width, height;
    double left, bottom;
    struct scale x, y; /* the box: x.pixels wide, y.pixels high */
    double title_size;
    double legend_left, legend_room; /* room: width of a text, font sizes */
    const struct device *device;     /* borrowed */
};

enum { LAYOUT_FONT = 13, LAYOUT_LABEL = 14 };          /* px */
enum { LAYOUT_SPACING_X = 60, LAYOUT_SPACING_Y = 40 }; /* px between labels */

/* The axes must be valid. */
struct layout layout_of(const struct figure *f, const struct legend *l,
                        const struct device *d);

#endif
