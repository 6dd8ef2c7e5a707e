/* sheet.h -- what the figures have in common: titles, labels and segments. */
#pragma once

#include "line.h"
#include "study.h"
#include "unit.h"

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

/* Adds a curve of two points. */
void sheet_segment(struct figure *f, struct figure_style style,
                   const char *entry, struct vec2 a, struct vec2 b);
