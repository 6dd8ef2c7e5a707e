/* layer.h -- how a figure keeps a raster; for lib/plot only. */
#pragma once

#include "figure.h"

/* Labels are kept as the index of their shade, NaN where they have none. */
struct figure_raster {
    double *value; /* owned */
    size_t nx, ny;
    size_t shade_count; /* 0: a map */
    enum figure_role role[FIGURE_SHADES_MAX];
    char *entry[FIGURE_SHADES_MAX]; /* owned, NULL: none */
    char *missing;                  /* owned: that of cells without a value */
    bool contours;
    struct figure_axis scale; /* label owned */
};

/* Whether cells lack a value and have an entry that says so. */
bool figure_raster_hatched(const struct figure_raster *r);
