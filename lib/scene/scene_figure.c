#include "scene_figure.h"

#include <math.h>
#include <string.h>

#include "tolerance.h"

/* Height 0: as the plot needs.  The last is of any other width. */
static const struct {
    const char *word;
    double width, height, type, dpi;
} kinds[] = {
    { "screen", 900 * 25.4 / 96, 600 * 25.4 / 96, 9.75, 192 },
    { "one_column", 89, 0, 8, 300 },
    { "two_columns", 183, 0, 8, 300 },
    { "slide", 254, 142.875, 14, 192 },
    { "", 0, 0, 8, 300 },
};
enum { KINDS = sizeof kinds / sizeof *kinds - 1 };

/* A legend beside the plot leaves it room where a line of letters of the page's
 * width has so many times their size. */
static const double wide = 45;

void scene_figure_begin(struct scene_figure *f)
{
    *f = (struct scene_figure){ .width = kinds[0].width,
                                .height = NAN,
                                .type = NAN,
                                .dpi = NAN,
                                .title = true };
}

bool scene_figure_preset(const char *word, struct scene_figure *f)
{
    for (int k = 0; k < KINDS; k++)
        if (strcmp(word, kinds[k].word) == 0) {
            f->width = kinds[k].width;
            return true;
        }
    return false;
}

static double figure_settled(double given, double standard)
{
    return isnan(given) ? standard : given;
}

void scene_figure_settle(struct scene_figure *f)
{
    int k = 0;

    while (k < KINDS && kinds[k].width != f->width)
        k++;
    f->height = figure_settled(f->height, kinds[k].height);
    f->type = figure_settled(f->type, kinds[k].type);
    f->dpi = figure_settled(f->dpi, kinds[k].dpi);
    if (f->legend == LEGEND_AUTO)
        f->legend = f->width / 25.4 * 72 / f->type >= wide ? LEGEND_OUTSIDE
                                                           : LEGEND_BELOW;
}

double scene_figure_chord(const struct scene_figure *f)
{
    return TOL_FIGURE_DOT / (f->width / 25.4 * fmax(f->dpi, TOL_FIGURE_DPI));
}
