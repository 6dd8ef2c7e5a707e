/*
 * figure.h -- a picture built in memory: two axes, layers drawn in the order
 * they were added, a legend.  draw.h turns it into a file.
 *
 * Numbers are in the unit of their axis (v, not ln v).  A point with a
 * coordinate that is not finite breaks a line and hides a mark, as does one
 * that is not positive on a log axis, to which a line goes as far as the axis
 * does.  Everything outside the axes' box is cut off exactly at
 * the frame.  All arrays and texts are *copied*; nothing given to a function
 * below needs to outlive the call.  Texts are UTF-8 and shown as they are;
 * only labels and entries may hold the marks of mark.h.
 *
 * Lengths are in px, of which a letter's size has 13: a figure of larger type
 * has thicker lines.
 *
 * A figure remembers its first failure, after which nothing is added, and
 * figures_write returns it: what builds one need not ask.
 */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "status.h"

/* Where the legend stands: right of the plot, in its emptiest corner, under it,
 * nowhere. */
enum figure_legend {
    FIGURE_LEGEND_OUTSIDE,
    FIGURE_LEGEND_INSIDE,
    FIGURE_LEGEND_BELOW,
    FIGURE_LEGEND_NONE
};

/* Tints of a map (palette.c). */
enum figure_colours {
    FIGURE_VIRIDIS,
    FIGURE_CIVIDIS,
    FIGURE_GREYS,
    FIGURE_COLOURS
};

/* The paper.  All panels on the same kind of page have plots of one size,
 * whatever their legends hold; where there is a height, what stands below the
 * plot and lines of the title beyond the first take from it. */
struct figure_page {
    double width, height; /* mm, exact; height 0: what a plot 0.68 times as high
                             as it is wide needs, and what is around it */
    double type;          /* size of letters, pt */
    double dpi;           /* of a PNG */
    const char *font;     /* borrowed until it is drawn; NULL: sans-serif */
    bool untitled;
    enum figure_legend legend;
    enum figure_colours colours;
};

/* 900 x 600 px of 1/96 inch, two dots for each. */
extern const struct figure_page figure_screen;

/* What a thing is; decides colour, width and dash.  The colours are those of
 * Okabe & Ito (2008), which colour-blind readers tell apart; widths and dashes
 * differ as well, so that a grey print can be read. */
enum figure_role {
    FIGURE_TRAJECTORY,
    FIGURE_HIGHLIGHT,   /* the one trajectory the text talks about */
    FIGURE_STABLE,      /* stable manifold */
    FIGURE_UNSTABLE,    /* unstable manifold */
    FIGURE_NULLCLINE_X, /* where dx/dt = 0: dashed */
    FIGURE_NULLCLINE_Y, /* where dy/dt = 0: solid */
    FIGURE_FIELD,
    FIGURE_CONTOUR, /* of a map */
    FIGURE_EQUILIBRIUM,
    FIGURE_SERIES_1, /* curves that are just numbered */
    FIGURE_SERIES_2,
    FIGURE_SERIES_3,
    FIGURE_SERIES_4,
    FIGURE_SERIES_5,
    FIGURE_SERIES_6,
    FIGURE_SHADE_1, /* light tints for regions: blue-grey, sand, ... */
    FIGURE_SHADE_2,
    FIGURE_SHADE_3,
    FIGURE_SHADE_4,
    FIGURE_SHADE_5,
    FIGURE_SHADE_6,
    FIGURE_ABSENT, /* the ground of cells without a value: hatched */
    FIGURE_ROLES
};

enum figure_dash {
    FIGURE_DASH_OF_ROLE,
    FIGURE_SOLID,
    FIGURE_DASHED,
    FIGURE_DOTTED,
    FIGURE_DASH_DOT,
    FIGURE_LONG_DASH,
    FIGURE_DASH_DOT_DOT,
    FIGURE_DASHES
};

/* { .role = r } alone is the role's own look. */
struct figure_style {
    enum figure_role role;
    enum figure_dash dash;
    double width; /* px; 0: the role's */
};

enum figure_mark {
    FIGURE_DISC,   /* filled: nodes */
    FIGURE_CIRCLE, /* white inside: saddles */
    FIGURE_SQUARE, /* filled */
    FIGURE_PLUS,
    FIGURE_CROSS,
    FIGURE_BOX,      /* the others' outlines */
    FIGURE_TRIANGLE, /* filled, point up */
    FIGURE_DELTA,
    FIGURE_DIAMOND, /* filled */
    FIGURE_LOZENGE,
    FIGURE_STAR
};

struct figure_axis {
    const char *label; /* NULL: none */
    double lo, hi;     /* finite, lo < hi; 0 < lo if is_log */
    bool is_log;
};

enum figure_kind {
    FIGURE_CURVE,
    FIGURE_POINTS,
    FIGURE_ARROWS, /* a direction field: arrows of one length, centred on
                      (x, y), along (dx, dy) per unit of x or y, per unit of
                      ln x or ln y on a log axis; a zero or undefined direction
                      draws nothing */
    FIGURE_REGION  /* a filled polygon without a border; it may reach beyond the
                      box */
};

struct figure_layer {
    enum figure_kind kind;
    struct figure_style style; /* of regions the role alone */
    const char *entry; /* the line in the legend, shared by layers with the
                          same; NULL: none */
    const double *x, *y;
    size_t count;
    const double *heads; /* curves: arrowheads along them, as fractions in
                            [0, 1] of the visible length */
    size_t head_count;
    enum figure_mark mark; /* points */
    double size; /* px; points: diameter, 0: 10; arrows: length, 0: 14 */
    const double *dx, *dy; /* arrows */
};

/* Which label of a raster gets which tint; labels not listed stay white, or are
 * hatched. */
struct figure_shade {
    int8_t label;
    enum figure_role role;
    const char *entry;
};
enum { FIGURE_SHADES_MAX = 16 };

/* A raster fills the axes' box with nx x ny >= 1 equal cells (equal in ln x
 * where x is a log axis); row j, counted upward, starts at [j * nx].  A figure
 * has at most one raster, which lies under everything else. */
struct figure_labels {
    const int8_t *label;
    size_t nx, ny;
    const struct figure_shade *shades;
    size_t shade_count;  /* 1 .. FIGURE_SHADES_MAX */
    const char *missing; /* the legend's entry of cells without one, which are
                            hatched; NULL: none */
};

/* Numbers as a tint, explained by a bar beside the legend; cells that are not
 * finite are hatched where they have an entry, else white. */
struct figure_map {
    const double *value;
    size_t nx, ny;
    struct figure_axis scale; /* lo = hi: the range of the values */
    bool contours; /* lines at the values that the bar labels, which say them */
    const char *missing; /* the legend's entry of cells that are not finite;
                            NULL: none */
};

struct figure_raster; /* layer.h */

struct figure {
    struct figure_page page;     /* figure_screen, may be changed at will */
    char *title;                 /* owned */
    struct figure_axis x, y;     /* labels owned */
    struct figure_layer *layers; /* owned, with all they hold */
    size_t layer_count, layer_room;
    struct figure_raster *raster; /* owned; NULL if none */
    enum status status; /* STATUS_NO_MEMORY, or what the caller noted */
};

#define FIGURE_EMPTY ((struct figure){ .title = NULL })

/* Title may be NULL.  The ranges are checked when the figure is drawn. */
void figure_init(struct figure *f, const char *title,
                 const struct figure_axis *x, const struct figure_axis *y);

void figure_add(struct figure *f, const struct figure_layer *layer);

/* A second raster replaces the first. */
void figure_add_labels(struct figure *f, const struct figure_labels *l);
void figure_add_map(struct figure *f, const struct figure_map *m);

/* Leaves FIGURE_EMPTY, so a second call is harmless. */
void figure_free(struct figure *f);
