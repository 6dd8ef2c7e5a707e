/*
 * Line colours: Okabe & Ito, Color Universal Design (2008).  The red of the
 * highlight is darker than theirs, to stand apart from the vermilion also in
 * grey.  Tints: grey values 0.80, 0.95, 0.88, 0.85, ..., so that neighbours
 * differ on paper.
 */
#include "palette.h"

/*
 * Maps: viridis (N. Smith, S. van der Walt, 2015) and cividis (J.R. Nunez,
 * C.R. Anderton, R.S. Renslow, PLoS ONE 13 (2018) e0199239), both CC0, at every
 * sixteenth of their range; greys of even lightness L* from 20 to 95.
 */
const char palette_map[FIGURE_COLOURS][PALETTE_TINTS][8] = {
    [FIGURE_VIRIDIS] = {
        "#440154", "#48186a", "#472d7b", "#424086", "#3b528b", "#33638d",
        "#2c728e", "#26828e", "#21918c", "#1f9f88", "#27ad81", "#3dbc74",
        "#5cc863", "#81d34d", "#aadc32", "#d5e21a", "#fde725",
    },
    [FIGURE_CIVIDIS] = {
        "#00224e", "#002e6a", "#1a386f", "#32436d", "#434e6c", "#535a6d",
        "#61656f", "#6f7073", "#7d7c78", "#8b8778", "#9a9376", "#aaa073",
        "#bbad6d", "#ccba64", "#ddc858", "#efd748", "#fee838",
    },
    [FIGURE_GREYS] = {
        "#303030", "#3b3b3b", "#454545", "#505050", "#5b5b5b", "#676767",
        "#727272", "#7e7e7e", "#8a8a8a", "#969696", "#a3a3a3", "#afafaf",
        "#bcbcbc", "#c9c9c9", "#d6d6d6", "#e3e3e3", "#f1f1f1",
    },
};

static const struct {
    const char *colour;
    double width;
    enum figure_dash dash;
} looks[FIGURE_ROLES] = {
    [FIGURE_TRAJECTORY] = { "#4d4d4d", 1.0, FIGURE_SOLID },
    [FIGURE_HIGHLIGHT] = { "#b2001d", 2.2, FIGURE_DASH_DOT },
    [FIGURE_STABLE] = { "#0072b2", 3.0, FIGURE_SOLID },
    [FIGURE_UNSTABLE] = { "#d55e00", 3.0, FIGURE_LONG_DASH },
    [FIGURE_NULLCLINE_X] = { "#000000", 2.2, FIGURE_DASHED },
    [FIGURE_NULLCLINE_Y] = { "#2b2b2b", 1.8, FIGURE_SOLID },
    [FIGURE_FIELD] = { "#8c8c8c", 0.9, FIGURE_SOLID },
    [FIGURE_CONTOUR] = { "#000000", 0.9, FIGURE_SOLID },
    [FIGURE_EQUILIBRIUM] = { "#000000", 2.0, FIGURE_SOLID },
    [FIGURE_SERIES_1] = { "#0072b2", 2.2, FIGURE_SOLID },
    [FIGURE_SERIES_2] = { "#d55e00", 2.2, FIGURE_DASHED },
    [FIGURE_SERIES_3] = { "#009e73", 2.2, FIGURE_DOTTED },
    [FIGURE_SERIES_4] = { "#cc79a7", 2.2, FIGURE_DASH_DOT },
    [FIGURE_SERIES_5] = { "#e69f00", 2.2, FIGURE_LONG_DASH },
    [FIGURE_SERIES_6] = { "#56b4e9", 2.2, FIGURE_DASH_DOT_DOT },
    [FIGURE_SHADE_1] = { "#b9cde0", 1.0, FIGURE_SOLID },
    [FIGURE_SHADE_2] = { "#fdf5e2", 1.0, FIGURE_SOLID },
    [FIGURE_SHADE_3] = { "#cce4ca", 1.0, FIGURE_SOLID },
    [FIGURE_SHADE_4] = { "#f0c8d1", 1.0, FIGURE_SOLID },
    [FIGURE_SHADE_5] = { "#efe9f9", 1.0, FIGURE_SOLID },
    [FIGURE_SHADE_6] = { "#b8b8b8", 1.0, FIGURE_SOLID },
    [FIGURE_ABSENT] = { "#ececec", 1.0, FIGURE_SOLID },
};

static const double dashes[FIGURE_DASHES][PAINT_DASHES] = {
    [FIGURE_DASHED] = { 4, 2.8 },
    [FIGURE_DOTTED] = { 1, 2.4 },
    [FIGURE_DASH_DOT] = { 5, 2.4, 1, 2.4 },
    [FIGURE_LONG_DASH] = { 9, 3 },
    [FIGURE_DASH_DOT_DOT] = { 5, 2.4, 1, 2.4, 1, 2.4 },
};

struct paint paint_of(struct figure_style style)
{
    const enum figure_dash dash =
        style.dash ? style.dash : looks[style.role].dash;
    const double width =
        style.width > 0 ? style.width : looks[style.role].width;

    return (struct paint){ looks[style.role].colour, width, dashes[dash] };
}
