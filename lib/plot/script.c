#include "script.h"

#include <math.h>
#include <stdio.h>

#include "label.h"
#include "layer.h"
#include "layout.h"
#include "look.h"
#include "palette.h"
#include "pen.h"
#include "ticks.h"

/* ---- hatching ------------------------------------------------------------ */

static void hatch_line(FILE *out, const struct layout *p, struct vec2 a,
                       struct vec2 b, const char *layer)
{
    const struct paint paint =
        paint_of((struct figure_style){ .role = FIGURE_FIELD });

    fprintf(out,
            "set arrow from screen %.6f,%.6f to screen %.6f,%.6f nohead %s ",
            layout_across(p, a.x), layout_up(p, a.y), layout_across(p, b.x),
            layout_up(p, b.y), layer);
    look_line(out, p->device, &paint);
    fputc('\n', out);
}

/* Lines at 45 degrees through a box of the page, in gnuplot's words; `layer` is
 * that of its `set arrow`: "back", "front". */
/* Line c has x - y = c from the lower left corner. */
static void hatch_write(FILE *out, const struct layout *p, struct box b,
                        const char *layer)
{
    const double apart = 9; /* px along an axis */
    const struct vec2 size = vec2_sub(b.hi, b.lo);

    for (double c = apart / 2 - size.y; c < size.x; c += apart) {
        const struct vec2 from = { c < 0 ? 0 : c, c < 0 ? -c : 0 };
        const double length =
            fmin(size.x - from.x, size.y - from.y); /* along an axis */
        const struct vec2 way = { length, length };
        const struct vec2 start = vec2_add(b.lo, from);
        hatch_line(out, p, start, vec2_add(start, way), layer);
    }
}

/* ---- key ----------------------------------------------------------------- */

/* gnuplot's own key has a size of its own making; ours is known before
 * anything is drawn. */

enum { SWATCH = 12 }; /* px, the height of a shade */

static void put_at(FILE *out, const struct layout *p, double x, double y)
{
    fprintf(out, "screen %.6f,%.6f", layout_across(p, x), layout_up(p, y));
}

static void key_put_box(FILE *out, const struct layout *p, struct box b,
                        const char *look)
{
    fputs("set object rectangle from ", out);
    put_at(out, p, b.lo.x, b.lo.y);
    fputs(" to ", out);
    put_at(out, p, b.hi.x, b.hi.y);
    fprintf(out, " front fs solid %s\n", look);
}

/* White, so that what lies under a legend in the plot is hidden. */
static void key_put_ground(FILE *out, const struct layout *p, struct vec2 size)
{
    const double rim = 3;

    key_put_box(out, p,
                (struct box){ { p->legend.x - rim, p->legend.y - size.y - rim },
                              { p->legend.x + size.x, p->legend.y + rim } },
                "border lc rgb '#c0c0c0' fc rgb 'white' lw 0.8");
}

static void put_shade(FILE *out, const struct layout *p, struct vec2 at,
                      enum figure_role role)
{
    const struct paint paint = paint_of((struct figure_style){ .role = role });
    char look[80];

    snprintf(look, sizeof look, "border lc rgb '#808080' fc rgb '%s' lw 0.8",
             paint.colour);
    const struct box b = { { at.x, at.y - SWATCH / 2.0 },
                           { at.x + LEGEND_SAMPLE, at.y + SWATCH / 2.0 } };
    key_put_box(out, p, b, look);
    if (role == FIGURE_ABSENT)
        hatch_write(out, p, b, "front");
}

static void put_curve(FILE *out, const struct layout *p, struct vec2 at,
                      const struct figure_layer *curve)
{
    const struct paint paint = paint_of(curve->style);

    fputs("set arrow from ", out);
    put_at(out, p, at.x, at.y);
    fputs(" to ", out);
    put_at(out, p, at.x + LEGEND_SAMPLE, at.y);
    fputs(" nohead front ", out);
    look_line(out, p->device, &paint);
    fputc('\n', out);
}

static void put_mark(FILE *out, const struct layout *p, struct vec2 at,
                     const struct figure_layer *mark)
{
    fputs("set label '' at ", out);
    put_at(out, p, at.x + LEGEND_SAMPLE / 2.0, at.y);
    fputs(" point ", out);
    look_mark(out, p->device, mark);
    fputs(" front\n", out);
}

static void key_put_text(FILE *out, const struct layout *p, struct vec2 at,
                         struct label_part part, double room)
{
    fputs("set label ", out);
    label_write(out, part, room, p->script);
    fputs(" at ", out);
    put_at(out, p, at.x, at.y);
    fprintf(out, " left front font ',%.4g'\n", LAYOUT_FONT * p->device->font);
}

static void put_line(FILE *out, const struct layout *p, const struct legend *l,
                     const struct legend_line *line)
{
    struct vec2 at = { p->legend.x + line->at.x,
                       p->legend.y - line->at.y - LEGEND_LINE / 2.0 };

    if (!line->curve && !line->mark)
        put_shade(out, p, at, line->role);
    if (line->curve)
        put_curve(out, p, at, line->curve);
    if (line->mark)
        put_mark(out, p, at, line->mark);
    at.x += LEGEND_SAMPLE + LEGEND_SKIP;
    for (size_t k = 0; k < line->parts; k++, at.y -= LEGEND_LINE)
        key_put_text(out, p, at, line->part[k], l->text_room / LAYOUT_FONT);
}

/* Commands that stand before the plot command. */
static void key_write(FILE *out, const struct layout *p, const struct legend *l)
{
    char more[32];

    if (l->count > 0 && p->page->legend == FIGURE_LEGEND_INSIDE)
        key_put_ground(out, p, l->size);
    for (size_t k = 0; k < l->count; k++)
        put_line(out, p, l, &l->line[k]);
    if (l->left_out == 0)
        return;
    const int size = snprintf(more, sizeof more, "(and %zu more)", l->left_out);
    key_put_text(out, p,
                 (struct vec2){ p->legend.x,
                                p->legend.y - l->size.y + LEGEND_LINE / 2.0 },
                 (struct label_part){ more, (size_t) size }, INFINITY);
}

/* Of the terminal: its page, in whole dots, and how large letters and lines
 * are. */
static void put_size(FILE *out, const struct layout *p)
{
    const double wide = p->canvas.x * p->dots, high = p->canvas.y * p->dots;

    if (p->device->kind == DEVICE_PDF)
        fprintf(out, "%.9gin,%.9gin", wide / 72, high / 72);
    else
        fprintf(out, "%.0f,%.0f", wide, high);
    if (p->device->kind != DEVICE_SVG)
        fprintf(out, " fontscale %.6g linewidth %.6g pointscale %.6g", p->dots,
                p->dots * p->device->lw, p->dots);
}

static void put_terminal(FILE *out, const struct layout *p,
                         const struct script_names *names)
{
    const struct device *d = p->device;
    const char *font = p->page->font ? p->page->font : "sans-serif";

    fprintf(out, "reset session\nset encoding utf8\nset terminal %s size ",
            d->terminal);
    put_size(out, p);
    fprintf(out,
            " font '%s,%.4g' %s enhanced rounded background rgb 'white'\n"
            "set output ",
            font, LAYOUT_FONT * d->font, d->options);
    label_write_path(out, names->figure);
    fprintf(out, "\ndata = ");
    label_write_path(out, names->data);
    fprintf(out, "\n");
}

/* A text of one line or several, whose first begins at (x, y); `step` leads to
 * the next. */
static void put_text(FILE *out, const struct layout *p,
                     const struct label_part line[], size_t lines,
                     struct vec2 at, struct vec2 step, const char *how,
                     double size, double room)
{
    for (size_t k = 0; k < lines; k++, at = vec2_add(at, step)) {
        fprintf(out, "set label ");
        label_write(out, line[k], room / size, p->script);
        fprintf(out, " at screen %.6f,%.6f %s font ',%.4g'\n",
                layout_across(p, at.x), layout_up(p, at.y), how,
                size * p->device->font);
    }
}

/* As large as its room allows, from that of labels on. */
static double title_size(const struct layout *p, double room)
{
    const double most = 16;

    return p->titles == 1 ? fmax(LAYOUT_LABEL,
                                 fmin(most, room / label_width(p->title->text)))
                          : LAYOUT_LABEL;
}

static void put_texts(FILE *out, const struct layout *p)
{
    const double room = p->width - p->left - 8;
    const struct vec2 down = { 0, -LAYOUT_LINE };
    const struct vec2 middle = { p->left + p->x.pixels / 2,
                                 p->bottom + p->y.pixels / 2 };

    put_text(out, p, p->title, p->titles,
             (struct vec2){ p->left, p->height - 6 - LAYOUT_LINE / 2.0 }, down,
             "left", title_size(p, room), room);
    put_text(out, p, p->x_label, p->x_labels,
             (struct vec2){ middle.x, p->bottom - 47 }, down, "center",
             LAYOUT_LABEL, p->width);
    put_text(out, p, p->y_label, p->y_labels, (struct vec2){ 16, middle.y },
             (struct vec2){ LAYOUT_LINE, 0 }, "center rotate", LAYOUT_LABEL,
             p->height);
}

/* gnuplot takes a tick for an end of a log axis, whose logarithm it rounds, to
 * be beyond it: by a few parts in 10^16 of what is at most 10^3. */
static const double log_rim = 1e-12;

static void put_axis(FILE *out, const char *name, const struct layout *p,
                     const struct scale *s, double spacing)
{
    if (s->is_log)
        fprintf(out, "set logscale %s 10\n", name);
    const double rim = s->is_log ? log_rim : 0;
    fprintf(out, "set %srange [%.17g:%.17g]\n", name, s->lo * (1 - rim),
            s->hi * (1 + rim));
    fprintf(out, "set %stics out nomirror enhanced scale 0.7,0.35 ", name);
    ticks_write(out, s, spacing, p->script, NULL);
    fputc('\n', out);
}

static void put_box(FILE *out, const struct layout *p)
{
    fprintf(out,
            "set lmargin at screen %.6f\nset rmargin at screen %.6f\n"
            "set bmargin at screen %.6f\nset tmargin at screen %.6f\n",
            layout_across(p, p->left), layout_across(p, p->left + p->x.pixels),
            layout_up(p, p->bottom), layout_up(p, p->bottom + p->y.pixels));
    fprintf(out, "set border 15 front lw 1.2 lc rgb '#202020'\n"
                 "set clip two\nset tics front textcolor rgb '#202020'\n");
    put_axis(out, "x", p, &p->x, layout_side_by_side(&p->x));
    put_axis(out, "y", p, &p->y, LAYOUT_SPACING_Y);
}

static void put_shades(FILE *out, const struct figure_raster *r)
{
    fprintf(out, "set palette maxcolors %zu defined (", r->shade_count);
    for (size_t k = 0; k < r->shade_count; k++) {
        const struct figure_style style = { .role = r->role[k] };
        fprintf(out, "%s%zu '%s'", k ? ", " : "", k, paint_of(style).colour);
    }
    if (r->shade_count == 1) /* a palette has two ends */
        fprintf(out, ", 1 '%s'",
                paint_of((struct figure_style){ .role = r->role[0] }).colour);
    fprintf(out, ")\nset cbrange [-0.5:%zu.5]\nunset colorbox\n",
            r->shade_count - 1);
}

static void put_palette(FILE *out, enum figure_colours colours)
{
    fprintf(out, "set palette maxcolors 256 defined (");
    for (int k = 0; k < PALETTE_TINTS; k++)
        fprintf(out, "%s%d '%s'", k ? ", " : "", k, palette_map[colours][k]);
    fprintf(out, ")\n");
}

/* gnuplot keeps images in single precision: decades of a log bar. */
static void put_bar_axis(FILE *out, const struct layout *p)
{
    const struct scale *s = &p->bar;

    fprintf(out, "set cbrange [%.17g:%.17g]\n",
            s->is_log ? log10(s->lo) : s->lo, s->is_log ? log10(s->hi) : s->hi);
    fputs("set cbtics out nomirror enhanced scale 0.7,0.35 ", out);
    ticks_write(out, s, layout_side_by_side(s), p->script,
                s->is_log ? log10 : NULL);
    fputc('\n', out);
}

/* The bar that explains a map, its label over it. */
static void put_bar(FILE *out, const struct layout *p,
                    const struct figure_axis *axis)
{
    const double high = 12, label = p->bar_top - 11;
    struct label_part line[LAYOUT_LABEL_LINES];

    put_palette(out, p->page->colours);
    fprintf(out, "set style textbox opaque noborder fc rgb 'white' "
                 "margins 0.6,0.4\n");
    fprintf(out,
            "set colorbox horizontal front user origin screen %.6f,%.6f "
            "size screen %.6f,%.6f\n",
            layout_across(p, p->bar_left), layout_up(p, label - 12 - high),
            p->bar_width / p->canvas.x, high / p->canvas.y);
    put_bar_axis(out, p);
    if (axis->label)
        put_text(out, p, line,
                 label_break(axis->label, p->bar_width / LAYOUT_FONT, line, 1),
                 (struct vec2){ p->bar_left, label }, (struct vec2){ 0, 0 },
                 "left", LAYOUT_FONT, p->bar_width + 20);
}

/* Under cells without a tint. */
static void put_ground(FILE *out, const struct layout *p)
{
    const struct paint paint =
        paint_of((struct figure_style){ .role = FIGURE_ABSENT });
    const struct vec2 corner = { p->left, p->bottom };

    fprintf(out,
            "set object rectangle from graph 0,0 to graph 1,1 behind "
            "fs solid noborder fc rgb '%s'\n",
            paint.colour);
    hatch_write(
        out, p,
        (struct box){ corner, vec2_add(corner, (struct vec2){ p->x.pixels,
                                                              p->y.pixels }) },
        "back");
}

static void put_raster(FILE *out, const struct layout *p,
                       const struct figure_raster *r)
{
    if (!r)
        return;
    fprintf(out, "set x2range [-0.5:%zu.5]\nset y2range [-0.5:%zu.5]\n",
            pen_cells(r->nx) - 1, pen_cells(r->ny) - 1);
    if (figure_raster_hatched(r))
        put_ground(out, p);
    if (r->shade_count > 0)
        put_shades(out, r);
    else
        put_bar(out, p, &r->scale);
}

enum status script_write(const struct figure *f, const struct device *d,
                         const struct script_names *names, FILE *script,
                         FILE *data, struct script_size *size)
{
    struct legend legend = legend_of(f);
    struct layout page;
    enum status s = layout_find(f, &legend, d, &page);

    if (s != STATUS_OK)
        return s;
    struct pen pen = { .script = script, .data = data, .page = &page };
    put_terminal(script, &page, names);
    put_texts(script, &page);
    put_box(script, &page);
    put_raster(script, &page, f->raster);
    key_write(script, &page, &legend);
    s = pen_draw(&pen, f);
    fprintf(script, "\nunset output\n");
    *size =
        (struct script_size){ page.width * page.dots, page.height * page.dots,
                              page.height * page.unit * 25.4 / 72 };
    return s;
}
