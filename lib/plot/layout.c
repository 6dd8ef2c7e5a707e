#include "layout.h"

#include <math.h>
#include <string.h>
#include <strings.h>

#include "ticks.h"
#include "tolerance.h"

static const struct device devices[] = {
    { DEVICE_SVG, ".svg", "svg", "name 'figure'", 1, 1, 1.4, 0.092, "</svg>" },
    { DEVICE_PDF, ".pdf", "pdfcairo", "", 0.75, 2, 2.5, 0.13, "%%EOF" },
    { DEVICE_PNG, ".png", "pngcairo", "", 0.75, 1, 2.5, 0.13, "IEND" },
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

/* Around the plot, px. */
enum {
    RIM = 8,         /* of the page */
    COLUMN_GAP = 16, /* between the plot and what stands right of it */
    TICKS = 42,      /* of an upward axis, unless its labels are wider */
    BAR = 74,        /* a map's bar, its ticks and its label */
    LABEL_OVER = 48, /* how much longer than the plot a label may be */
    LEAST = 80,      /* of a plot */
};
static const double outside = 0.27; /* of the page's width: the legend */
static const double ratio = 0.68;   /* of a plot, where no height is given */
#define LEAST_TYPE 6.05             /* pt */

static bool has_bar(const struct figure *f)
{
    return f->raster && f->raster->shade_count == 0;
}

/* ---- what stands around -------------------------------------------------- */

static double mm_px(double mm, double unit)
{
    return mm * 72 / 25.4 / unit;
}

static double right_of(const struct layout *p)
{
    return p->page->legend == FIGURE_LEGEND_OUTSIDE ? outside * p->width : 24;
}

static double top_of(const struct layout *p)
{
    return p->titles ? 26.0 + (double) p->titles * LAYOUT_LINE : 18;
}

/* Under the plot: ticks and label. */
static double axis_below(const struct layout *p, const struct figure *f)
{
    return f->x.label ? 44.0 + (double) p->x_labels * LAYOUT_LINE : 38;
}

/* And what the axis does not need: legend, bar. */
static double also_below(const struct layout *p, const struct figure *f,
                         const struct legend *l)
{
    const bool beside = p->page->legend == FIGURE_LEGEND_OUTSIDE;
    const bool below = p->page->legend == FIGURE_LEGEND_BELOW;

    return (below && l->count ? l->size.y + RIM : 0) +
           (has_bar(f) && !beside ? BAR : 0);
}

static double left_of(const struct layout *p, const struct figure *f,
                      double height)
{
    const struct scale y = scale_of(&f->y, height);
    const double ticks = ticks_width(&y, LAYOUT_SPACING_Y) * LAYOUT_FONT;

    return ceil((f->y.label ? 12.0 + (double) p->y_labels * LAYOUT_LINE : 8) +
                fmax(ticks, TICKS) + 14);
}

/* ---- the whole ----------------------------------------------------------- */

/* Broken anew as soon as their room is known. */
static void break_labels(const struct figure *f, struct layout *p, double wide,
                         double high)
{
    const double size = LAYOUT_LABEL;

    p->x_labels = f->x.label ? label_break(f->x.label, wide / size, p->x_label,
                                           LAYOUT_LABEL_LINES)
                             : 0;
    p->y_labels = f->y.label ? label_break(f->y.label, high / size, p->y_label,
                                           LAYOUT_LABEL_LINES)
                             : 0;
}

/* Right of the plot a column; under it as many as are of use; in it one, no
 * wider than its texts. */
static void layout_arrange(const struct layout *p, struct legend *l,
                           double plot)
{
    switch (p->page->legend) {
        case FIGURE_LEGEND_OUTSIDE:
            legend_arrange(l, right_of(p) - COLUMN_GAP, 1);
            break;
        case FIGURE_LEGEND_INSIDE:
            legend_arrange(l, fmin(legend_width(l), 0.6 * plot), 1);
            break;
        default:
            legend_arrange(l, p->width - 2 * RIM, 4);
    }
}

/* The plot's size; the upward labels' width takes from it, and their number is
 * known with its height only. */
static void find_plot(const struct figure *f, struct legend *l,
                      struct layout *p, double *wide, double *high)
{
    *wide = *high = ratio * p->width;
    for (int i = 0; i < 3; i++) {
        break_labels(f, p, *wide, *high + LABEL_OVER);
        p->left = left_of(p, f, fmax(*high, LEAST));
        *wide = p->width - p->left - right_of(p);
        p->titles =
            f->title && !p->page->untitled
                ? label_break(f->title, (p->width - p->left - RIM) / 15.0,
                              p->title, LAYOUT_TITLE_LINES)
                : 0;
        layout_arrange(p, l, *wide);
        const double around =
            top_of(p) + axis_below(p, f) + also_below(p, f, l);
        if (p->page->height > 0)
            *high = mm_px(p->page->height, p->unit) - around;
        else
            *high = floor(ratio * *wide);
        p->height = *high + around;
    }
}

/* Up to whole dots; of a PNG, which holds them only, the nearest. */
static double layout_whole(const struct layout *p, double px)
{
    const double dots = px * p->dots;

    return (p->device->kind == DEVICE_PNG ? round(dots) : ceil(dots - 1e-6)) /
           p->dots;
}

static double dots_in_px(const struct layout *p)
{
    switch (p->device->kind) {
        case DEVICE_PDF:
            return p->unit;
        case DEVICE_PNG:
            return p->page->dpi / 72 * p->unit;
        default:
            return 1;
    }
}

static void place_legend(const struct figure *f, const struct legend *l,
                         struct layout *p)
{
    const bool beside = p->page->legend == FIGURE_LEGEND_OUTSIDE;
    const double top = p->bottom + p->y.pixels;
    struct vec2 corner = { RIM, p->bottom - axis_below(p, f) };

    if (beside)
        corner = (struct vec2){ p->left + p->x.pixels + COLUMN_GAP, top };
    if (p->page->legend == FIGURE_LEGEND_INSIDE)
        corner = vec2_add((struct vec2){ p->left, p->bottom },
                          legend_corner(f, &p->x, &p->y, l->size));
    p->legend = corner;
    p->bar_left = beside ? corner.x : p->left;
    p->bar_width = beside ? right_of(p) - COLUMN_GAP - 24 : p->x.pixels;
    if (has_bar(f))
        p->bar = scale_of(&f->raster->scale, p->bar_width);
    p->bar_top = beside ? p->bottom + BAR - 20 : BAR;
}

enum status layout_find(const struct figure *f, struct legend *l,
                        const struct device *d, struct layout *p)
{
    const struct figure_page *page = &f->page;
    double wide, high;

    *p = (struct layout){ .device = d, .page = page };
    p->unit = page->type / LAYOUT_FONT;
    p->dots = dots_in_px(p);
    p->slack = TOL_FIGURE_DOT * 72 / fmax(page->dpi, TOL_FIGURE_DPI) / p->unit;
    p->script = fmax(1, LEAST_TYPE / (LABEL_SCRIPT * page->type));
    p->width = mm_px(page->width, p->unit);
    if (page->legend == FIGURE_LEGEND_NONE)
        l->count = l->left_out = 0;
    find_plot(f, l, p, &wide, &high);
    if (!(wide >= LEAST && high >= LEAST))
        return STATUS_BAD_ARGUMENT;
    p->x = scale_of(&f->x, wide);
    p->y = scale_of(&f->y, high);
    p->bottom = p->height - top_of(p) - high;
    p->canvas =
        (struct vec2){ layout_whole(p, p->width), layout_whole(p, p->height) };
    place_legend(f, l, p);
    return STATUS_OK;
}

double layout_side_by_side(const struct scale *s)
{
    const double text = ticks_width(s, LAYOUT_SPACING_X) * LAYOUT_FONT;

    return fmax(LAYOUT_SPACING_X, text + 12);
}

double layout_across(const struct layout *p, double x)
{
    return x / p->canvas.x;
}

double layout_up(const struct layout *p, double y)
{
    return (p->canvas.y - p->height + y) / p->canvas.y;
}
