/* line.h -- points on their way to a layer of a figure, as many as come. */
#pragma once

#include "figure.h"

/* Owned; LINE_EMPTY to begin with. */
struct line {
    double *x, *y;
    size_t count, room;
    bool failed; /* memory was out; no further points */
};

#define LINE_EMPTY ((struct line){ .x = NULL })

void line_add(struct line *l, double x, double y);
/* Leaves LINE_EMPTY, so a second call is harmless. */
void line_free(struct line *l);

/* The last point first. */
void line_reverse(struct line *l);

/* Adds the layer `look` with these points, if there are any, two of a curve or
 * a region, and frees them. */
void figure_add_line(struct figure *f, const struct figure_layer *look,
                     struct line *l);

/* The same of a curve, of one with an arrowhead in its middle, and of arrows,
 * as long as `along` says, which is freed, too. */
void figure_add_curve(struct figure *f, struct figure_style style,
                      const char *entry, struct line *l);
void figure_add_way(struct figure *f, struct figure_style style,
                    const char *entry, struct line *l);
void figure_add_arrows(struct figure *f, struct line *at, struct line *along);

/* One point; the mark's size in px, 0: 10. */
void figure_add_point(struct figure *f, double x, double y,
                      enum figure_role role, enum figure_mark mark, double size,
                      const char *entry);

/* The ground between two corners. */
void figure_add_block(struct figure *f, const double x[2], const double y[2],
                      enum figure_role role, const char *entry);

/* Grows [range[0], range[1]] to hold the finite ones of these. */
void range_grow(double range[2], const double *value, size_t count);
#define RANGE_EMPTY                                                            \
    {                                                                          \
        HUGE_VAL, -HUGE_VAL                                                    \
    }
