/*
 * Line colours: Okabe & Ito, Color Universal Design (2008).  The red of the
 * highlight is darker than theirs, to stand apart from the vermilion also in
 * grey.  Tints: grey values 0.80, 0.95, 0.88, 0.85, ..., so that neighbours
 * differ on paper.
 */
#include "palette.h"

const char palette_map[] = "(0 '#fbf6e6', 1 '#cfe0e6', 2 '#8fb6d0', "
                           "3 '#4a7fb0')";

static const struct {
    const char *colour;
    double width;
    enum figure_dash dash;
} looks[FIGURE_ROLES] = {
    [FIGURE_TRAJECTORY] = { "#4d4d4d", 1.0, FIGURE_SOLID },
    [FIGURE_HIGHLIGHT] = { "#b2001d", 2.2, FIGURE_SOLID },
    [FIGURE_STABLE] = { "#0072b2", 3.0, FIGURE_SOLID },
    [FIGURE_UNSTABLE] = { "#d55e00", 3.0, FIGURE_SOLID },
    [FIGURE_NULLCLINE_X] = { "#000000", 2.2, FIGURE_DASHED },
    [FIGURE_NULLCLINE_Y] = { "#2b2b2b", 2.2, FIGURE_SOLID },
    [FIGURE_FIELD] = { "#8c8c8c", 0.9, FIGURE_SOLID },
    [FIGURE_EQUILIBRIUM] = { "#000000", 2.0, FIGURE_SOLID },
    [FIGURE_SERIES_1] = { "#0072b2", 2.2, FIGURE_SOLID },
    [FIGURE_SERIES_2] = { "#d55e00", 2.2, FIGURE_DASHED },
    [FIGURE_SERIES_3] = { "#009e73", 2.2, FIGURE_DOTTED },
    [FIGURE_SERIES_4] = { "#cc79a7", 2.2, FIGURE_SOLID },
    [FIGURE_SERIES_5] = { "#e69f00", 2.2, FIGURE_DASHED },
    [FIGURE_SERIES_6] = { "#56b4e9", 2.2, FIGURE_DOTTED },
    [FIGURE_SHADE_1] = { "#bccfe0", 1.0, FIGURE_SOLID },
    [FIGURE_SHADE_2] = { "#fbf1da", 1.0, FIGURE_SOLID },
    [FIGURE_SHADE_3] = { "#d3e6d2", 1.0, FIGURE_SOLID },
    [FIGURE_SHADE_4] = { "#efcfd6", 1.0, FIGURE_SOLID },
    [FIGURE_SHADE_5] = { "#dcd3ea", 1.0, FIGURE_SOLID },
    [FIGURE_SHADE_6] = { "#c4c4c4", 1.0, FIGURE_SOLID },
};

/* Dash and gap. */
static const double dashes[][2] = {
    [FIGURE_DASH_OF_ROLE] = { 0, 0 },
    [FIGURE_SOLID] = { 0, 0 },
    [FIGURE_DASHED] = { 4, 2.8 },
    [FIGURE_DOTTED] = { 1, 2.4 },
};

struct paint paint_of(struct figure_style style)
{
    const enum figure_dash dash =
        style.dash ? style.dash : looks[style.role].dash;
    const double width =
        style.width > 0 ? style.width : looks[style.role].width;
    return (struct paint){ looks[style.role].colour, width, dashes[dash][0],
                           dashes[dash][1] };
}
