/* sheet.h -- what the diagrams of picture_diagram.h are drawn with: lines of
 * points, axes around them, marks at extrema. */
#ifndef APPS_SHEET_H
#define APPS_SHEET_H

#include "figure.h"
#include "study.h"

/* A figure in the making; all borrowed. */
struct sheet {
    const struct study *s;
    struct figure *figure;
    double unit; /* of slip rates on axes: V_star in SI units, else 1 */
};

/* Points of one curve; owned. */
struct line {
    double *x, *y;
    size_t count;
};

/* Room for so many points.  STATUS_NO_MEMORY; line_free either way. */
MUST_CHECK enum status line_init(struct line *l, size_t room);
void line_add(struct line *l, double x, double y);
/* A second call is harmless. */
void line_free(struct line *l);

/* Grows [range[0], range[1]] to hold the finite ones of these. */
void sheet_span(double range[2], const double *value, size_t count);

/* A linear axis with a rim around a range, 0 .. 1 around an empty one; and a
 * log axis of slip rates v[0] .. v[1] in the scene's units, `what` they are. */
struct figure_axis sheet_linear(const char *label, const double range[2]);
struct figure_axis sheet_rates(const struct sheet *p, const char *what,
                               const double v[2], char label[64]);

/* In all of these: STATUS_NO_MEMORY.  The title is the scene's and its law. */
MUST_CHECK enum status sheet_start(const struct sheet *p,
                                   const struct figure_axis *x,
                                   const struct figure_axis *y);
/* Of a line with two points or more. */
MUST_CHECK enum status sheet_line(const struct sheet *p, const struct line *l,
                                  struct figure_style style, const char *entry);
MUST_CHECK enum status sheet_mark(const struct sheet *p, double x, double y,
                                  enum figure_mark mark, const char *entry);

/* A disc for a maximum, a circle for a minimum. */
enum figure_mark sheet_mark_of(const struct extremum *e);

/* "V_M = 2.493e-08 m/s" of a maximum, "v_m = 405.1" of a minimum in units of
 * V*. */
void sheet_name(const struct sheet *p, const struct extremum *e, char text[64]);

#endif
