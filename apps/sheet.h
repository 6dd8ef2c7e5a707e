/* sheet.h -- what the figures have in common: titles, axes around values, marks
 * at extrema. */
#pragma once

#include "line.h"
#include "study.h"
#include "unit.h"

/* A figure in the making; all borrowed. */
struct sheet {
    const struct study *s;
    struct figure *figure;
    double unit; /* of slip rates on axes: V_star in SI units, else 1 */
};

/* A linear axis with a rim around a range, 0 .. 1 around an empty one; and a
 * log axis of slip rates v[0] .. v[1] in the scene's units, `what` they are. */
struct figure_axis sheet_linear(const char *label, const double range[2]);
struct figure_axis sheet_rates(const struct sheet *p, const char *what,
                               const double v[2], char label[64]);

/* "slip x/L" of "slip" and the unit "L" (unit.h), "slip x (m)" as the SI has
 * it; what has no such unit keeps its name. */
struct sheet_label {
    char text[192];
};
struct sheet_label sheet_label(const struct unit_system *u, const char *what,
                               const char *unit);

/* "TITLE, alpha = 0.34 rad" of a scene, or its law in words, as the slope was
 * given; without a slope, the former. */
struct sheet_text {
    char text[512];
};
struct sheet_text sheet_title(const struct scene *c, bool slope);

/* Begins the figure, titled as the scene and its law. */
void sheet_start(const struct sheet *p, const struct figure_axis *x,
                 const struct figure_axis *y);
/* Adds a line with two points or more, and frees it. */
void sheet_mark(const struct sheet *p, double x, double y,
                enum figure_mark mark, const char *entry);

/* A disc for a maximum, a circle for a minimum. */
enum figure_mark sheet_mark_of(const struct extremum *e);

/* "V_M = 2.493e-08 m/s" of a maximum, "v_m = 405.1" of a minimum in units of
 * V*. */
void sheet_name(const struct sheet *p, const struct extremum *e, char text[64]);

/* Adds a curve of two points. */
void sheet_segment(struct figure *f, struct figure_style style,
                   const char *entry, struct vec2 a, struct vec2 b);
