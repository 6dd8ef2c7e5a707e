/* layout.h -- the page: which formats there are, where the plot, the legend and
 * the texts go, in pixels from the lower left corner. */
#pragma once

#include "label.h"
#include "legend.h"
#include "scale.h"

/* What differs between gnuplot's terminals, so that all three files look the
 * same: found by measuring their output. */
struct device {
    enum device_kind { DEVICE_SVG, DEVICE_PDF, DEVICE_PNG } kind;
    const char *extension;
    const char *terminal;
    const char *options; /* of the terminal */
    double font;         /* font size of 1 px, with lw as font scale */
    double lw;           /* line width of 1 px */
    double dash;         /* what gnuplot calls a dash of one line width */
    double point;        /* point size that makes a disc of 1 px */
    const char *last;    /* stands near the end of a whole file only */
};

/* By the ending of the path; NULL if it is none of .svg, .pdf, .png. */
const struct device *device_find(const char *path);

enum { LAYOUT_FONT = 13, LAYOUT_LABEL = 14, LAYOUT_LINE = 18 }; /* px */
enum { LAYOUT_SPACING_X = 60, LAYOUT_SPACING_Y = 40 }; /* px between labels */
enum { LAYOUT_TITLE_LINES = 3, LAYOUT_LABEL_LINES = 2 };

struct layout {
    double width, height; /* of the page */
    struct vec2 canvas;   /* what gnuplot draws: the page, up to whole dots
                             right of it and below */
    double unit;          /* pt in a px */
    double dots;          /* of the device in a px */
    double slack;         /* px; what lines may be off curves */
    double script;        /* of labels (label.h): none is below 6 pt, and all
                             are so large */
    double left, bottom;
    struct scale x, y; /* the plot: x.pixels wide, y.pixels high */
    struct label_part title[LAYOUT_TITLE_LINES];
    struct label_part x_label[LAYOUT_LABEL_LINES], y_label[LAYOUT_LABEL_LINES];
    size_t titles, x_labels, y_labels;
    struct vec2 legend;                  /* its upper left corner */
    double bar_left, bar_top, bar_width; /* of a map */
    struct scale bar;
    const struct device *device;    /* borrowed */
    const struct figure_page *page; /* borrowed */
};

/* The axes must be valid.  Arranges the legend; STATUS_BAD_ARGUMENT where the
 * page has no room for a plot. */
MUST_CHECK enum status layout_find(const struct figure *f, struct legend *l,
                                   const struct device *d, struct layout *p);

/* px between labels that stand side by side. */
double layout_side_by_side(const struct scale *s);

/* As fractions of what gnuplot draws. */
double layout_across(const struct layout *p, double x);
double layout_up(const struct layout *p, double y);
