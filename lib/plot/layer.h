/* layer.h -- how a figure keeps what was added to it; for lib/plot only. */
#ifndef PLOT_LAYER_H
#define PLOT_LAYER_H

#include "figure.h"

enum layer_kind { LAYER_CURVE, LAYER_POINTS, LAYER_ARROWS, LAYER_REGION };

struct figure_layer {
    enum layer_kind kind;
    struct figure_style style;
    enum figure_mark mark; /* points */
    double size;           /* diameter of points, length of arrows; px */
    char *entry;           /* owned, NULL: none */
    double *numbers;       /* owned: the four below and the heads */
    size_t count;
    const double *x, *y, *dx, *dy; /* into numbers; dx, dy: arrows */
    const double *heads;           /* into numbers */
    size_t head_count;
};

/* Labels are kept as the index of their shade, NaN where they have none. */
struct figure_raster {
    double *value; /* owned */
    size_t nx, ny;
    size_t shade_count; /* 0: a map */
    enum figure_role role[FIGURE_SHADES_MAX];
    char *entry[FIGURE_SHADES_MAX]; /* owned, NULL: none */
    struct figure_axis scale;       /* label owned */
};

#endif
