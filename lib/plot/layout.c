#include "layout.h"

#include <math.h>
#include <string.h>
#include <strings.h>

#include "label.h"
#include "layer.h"
#include "ticks.h"

static const struct device devices[] = {
    { ".svg", "svg", "", "name 'figure'", 1, 1, 1.4, 0.93, 0.092, "</svg>" },
    /* 1 px = 1/72 inch */
    { ".pdf", "pdfcairo", "in", "fontscale 1 linewidth 2", 1.0 / 72, 0.75, 2.5,
      1.2, 0.13, "%%EOF" },
    /* two dots per px: sharp on today's screens */
    { ".png", "pngcairo", "", "fontscale 2 linewidth 2 pointscale 2", 2, 0.75,
      2.5, 1.2, 0.13, "IEND" },
};

const struct device *device_find(const char *path)
{
    const char *dot = strrchr(path, '.');
    const size_t n = sizeof devices / sizeof devices[0];
    for (size_t k = 0; dot && k < n; k++)
        if (strcasecmp(dot, devices[k].extension) == 0)
            return &devices[k];
    return NULL;
}

/* Width of the column right of the box, 0 if it stays empty. */
static double column_width(const struct figure *f, const struct legend *l)
{
    const bool has_bar = f->raster && f->raster->shade_count == 0;
    double text = l->width * LAYOUT_FONT;
    if (l->count == 0 && !has_bar)
        return 0;
    if (has_bar)
        text = fmax(text, 120);
    return fmin(LEGEND_GAP + LEGEND_SAMPLE + text + 10, 0.42 * f->width);
}

struct layout layout_of(const struct figure *f, const struct legend *l,
                        const struct device *d)
{
    const double column = column_width(f, l);
    struct layout p = { .width = f->width, .height = f->height, .device = d };
    const double top = f->title ? 44 : 18;
    p.bottom = f->x.label ? 62 : 38;
    p.y = scale_of(&f->y, p.height - p.bottom - top);
    const double ticks = ticks_width(&p.y, LAYOUT_SPACING_Y) * LAYOUT_FONT;
    p.left = ceil((f->y.label ? 30 : 8) + ticks + 14);
    p.x = scale_of(&f->x, p.width - p.left - fmax(column, 30));
    p.legend_left = p.left + p.x.pixels + LEGEND_GAP;
    p.legend_room = (column - LEGEND_GAP - LEGEND_SAMPLE) / LAYOUT_FONT;
    const double room = p.width - p.left - 8;
    const double title = label_width(f->title ? f->title : "");
    p.title_size = fmax(11, fmin(16, room / fmax(title, 1)));
    return p;
}
