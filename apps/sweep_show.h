/* sweep_show.h -- the tables of curves that sweep.show chooses among. */
#pragma once

#include "figure.h"
#include "scene.h"
#include "tolerance.h"

/* A column of a sweep (sweep_column.h) as drawn over one key. */
struct sweep_curve {
    char column[64];
    char entry[64]; /* in the legend */
    struct figure_style style;
    bool marks; /* no line */
    enum figure_mark mark;
};

struct show_frame {
    const char *label[2]; /* of the axis upward: as it is, in the SI */
    double range[2];      /* of that axis; both 0: what the values need */
    const char *map, *map_label[2]; /* the column shown over a grid */
};
extern const struct show_frame show_frames[SHOWS];

/* The curves of the scene's table in the order they are drawn: estimates, one
 * for each xi in its own colour, then exact numbers; how many.  Entries of
 * columns that the scene's products do not have are among them. */
enum { SWEEP_CURVES_MAX = 2 * SCENE_XI + 5 };
size_t sweep_show_curves(const struct scene *s,
                         struct sweep_curve curve[SWEEP_CURVES_MAX]);
