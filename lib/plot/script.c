#include "script.h"

#include <math.h>

#include "label.h"
#include "layer.h"
#include "palette.h"
#include "pen.h"
#include "ticks.h"

static void put_terminal(FILE *out, const struct layout *p,
                         const struct script_names *names)
{
    const struct device *d = p->device;
    fprintf(out,
            "reset session\nset encoding utf8\nset terminal %s "
            "size %.6g%s,%.6g%s font 'sans-serif,%.4g' %s enhanced rounded "
            "background rgb 'white'\nset output ",
            d->terminal, p->width * d->per_pixel, d->unit,
            p->height * d->per_pixel, d->unit, LAYOUT_FONT * d->font,
            d->options);
    label_write_path(out, names->figure);
    fprintf(out, "\ndata = ");
    label_write_path(out, names->data);
    fprintf(out, "\ndot = %.4g # point size of a mark 1 px wide\n", d->point);
}

/* A text at a place of the page, as it is: no markup. */
static void put_text(FILE *out, const struct layout *p, const char *text,
                     double x, double y, const char *how, double size,
                     double room)
{
    if (!text)
        return;
    fprintf(out, "set label ");
    label_write(out, text, room / size);
    fprintf(out, " at screen %.6f,%.6f %s noenhanced font ',%.4g'\n",
            x / p->width, y / p->height, how, size * p->device->font);
}

static void put_texts(FILE *out, const struct figure *f, const struct layout *p)
{
    const double top = p->bottom + p->y.pixels;
    put_text(out, p, f->title, p->left, top + 20, "left", p->title_size,
             p->width - p->left - 8);
    put_text(out, p, f->x.label, p->left + p->x.pixels / 2, 15, "center",
             LAYOUT_LABEL, p->width - p->left);
    put_text(out, p, f->y.label, 16, p->bottom + p->y.pixels / 2,
             "center rotate", LAYOUT_LABEL, p->height);
}

/* Labels side by side need room for their texts. */
static double side_by_side(const struct scale *s)
{
    const double text = ticks_width(s, LAYOUT_SPACING_X) * LAYOUT_FONT;
    return fmax(LAYOUT_SPACING_X, text + 12);
}

static void put_axis(FILE *out, const char *name, const struct scale *s,
                     double spacing)
{
    if (s->is_log)
        fprintf(out, "set logscale %s 10\n", name);
    fprintf(out, "set %srange [%.17g:%.17g]\n", name, s->lo, s->hi);
    fprintf(out, "set %stics out nomirror enhanced scale 0.7,0.35 ", name);
    ticks_write(out, s, spacing);
    fputc('\n', out);
}

static void put_box(FILE *out, const struct layout *p)
{
    fprintf(out,
            "set lmargin at screen %.6f\nset rmargin at screen %.6f\n"
            "set bmargin at screen %.6f\nset tmargin at screen %.6f\n",
            p->left / p->width, (p->left + p->x.pixels) / p->width,
            p->bottom / p->height, (p->bottom + p->y.pixels) / p->height);
    fprintf(out, "set border 15 front lw 1.2 lc rgb '#202020'\n"
                 "set clip two\nset tics front textcolor rgb '#202020'\n");
    put_axis(out, "x", &p->x, side_by_side(&p->x));
    put_axis(out, "y", &p->y, LAYOUT_SPACING_Y);
}

static void put_shades(FILE *out, const struct figure_raster *r)
{
    fprintf(out, "set palette maxcolors %zu defined (", r->shade_count);
    for (size_t k = 0; k < r->shade_count; k++) {
        const struct figure_style style = { .role = r->role[k] };
        fprintf(out, "%s%zu '%s'", k ? ", " : "", k, paint_of(style).colour);
    }
    if (r->shade_count == 1)
        fprintf(out, ", 1 'white'");
    fprintf(out, ")\nset cbrange [-0.5:%zu.5]\nunset colorbox\n",
            r->shade_count - 1);
}

/* The bar under the legend that explains a map. */
static void put_bar(FILE *out, const struct layout *p,
                    const struct figure_axis *axis)
{
    const double room = p->width - p->legend_left - 24;
    const struct scale s = scale_of(axis, room);
    fprintf(out, "set palette defined %s\n", palette_map);
    fprintf(out,
            "set colorbox horizontal front user origin screen %.6f,%.6f "
            "size screen %.6f,%.6f\n",
            p->legend_left / p->width, (p->bottom + 14) / p->height,
            room / p->width, 12 / p->height);
    put_axis(out, "cb", &s, side_by_side(&s));
    put_text(out, p, axis->label, p->legend_left, p->bottom + 40, "left",
             LAYOUT_FONT, p->width - p->legend_left - 4);
}

static void put_raster(FILE *out, const struct layout *p,
                       const struct figure_raster *r)
{
    if (!r)
        return;
    fprintf(out, "set x2range [-0.5:%zu.5]\nset y2range [-0.5:%zu.5]\n",
            pen_cells(r->nx) - 1, pen_cells(r->ny) - 1);
    if (r->shade_count > 0)
        put_shades(out, r);
    else
        put_bar(out, p, &r->scale);
}

enum status script_write(const struct figure *f, const struct device *d,
                         const struct script_names *names, FILE *script,
                         FILE *data)
{
    const struct legend legend = legend_of(f);
    const struct layout page = layout_of(f, &legend, d);
    struct pen pen = { .script = script, .data = data, .page = &page };
    put_terminal(script, &page, names);
    put_texts(script, f, &page);
    put_box(script, &page);
    put_raster(script, &page, f->raster);
    const enum status s = pen_draw(&pen, f, &legend);
    fprintf(script, "\nunset output\n");
    return s;
}
