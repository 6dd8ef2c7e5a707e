#include "pen.h"

#include <math.h>

#include "label.h"
#include "layer.h"
#include "palette.h"
#include "stroke.h"
#include "tolerance.h"

/* Opens a block of data and the line of the plot command that draws it. */
static void block_begin(struct pen *pen, const char *what, const char *entry)
{
    fprintf(pen->data, "# block %zu: %s ", pen->blocks, what);
    label_write(pen->data, entry ? entry : "", INFINITY);
    fputc('\n', pen->data);
    fprintf(pen->script, ", \\\n  data index %zu ", pen->blocks++);
}

static void block_end(struct pen *pen)
{
    fprintf(pen->data, "\n\n");
}

static void put_point(struct pen *pen, struct vec2 p)
{
    if (isnan(p.x))
        fputc('\n', pen->data);
    else
        fprintf(pen->data, "%.12g %.12g\n", scale_value(&pen->page->x, p.x),
                scale_value(&pen->page->y, p.y));
}

static void put_stroke(struct pen *pen, const struct stroke *s)
{
    for (size_t k = 0; k < s->count; k++)
        put_point(pen, s->at[k]);
}

static void put_head(struct pen *pen, const struct vec2 head[3])
{
    for (size_t k = 0; k < 3; k++)
        put_point(pen, head[k]);
    fputc('\n', pen->data);
}

static void put_fill(FILE *out, const char *colour)
{
    fprintf(out, "with filledcurves closed fs solid noborder fc rgb '%s'",
            colour);
}

static void put_line(const struct pen *pen, const struct paint *p)
{
    const double unit = pen->page->device->dash;
    fprintf(pen->script, "with lines lw %.4g lc rgb '%s'", p->width, p->colour);
    if (p->dash > 0)
        fprintf(pen->script, " dt (%.4g,%.4g)", p->dash * unit, p->gap * unit);
}

/* Consecutive curves of one look are drawn as one: gnuplot takes a moment for
 * each line of its plot command. */
struct run {
    const struct figure_layer *layer; /* borrowed */
    size_t count;
};

static enum status pen_clip(const struct pen *pen,
                            const struct figure_layer *layer, struct stroke *s)
{
    return stroke_clip(&pen->page->x, &pen->page->y, layer->x, layer->y,
                       layer->count, s);
}

static enum status draw_lines(struct pen *pen, struct run run, struct stroke *s)
{
    const struct paint paint = paint_of(run.layer->style);
    bool any = false;
    for (size_t k = 0; k < run.count; k++) {
        const enum status status = pen_clip(pen, &run.layer[k], s);
        if (status != STATUS_OK)
            return status;
        if (s->count == 0)
            continue;
        if (!any) {
            block_begin(pen, "curves", run.layer->entry);
            put_line(pen, &paint);
        }
        any = true;
        stroke_thin(s, TOL_FIGURE_PX);
        put_stroke(pen, s);
        fputc('\n', pen->data);
    }
    if (any)
        block_end(pen);
    return STATUS_OK;
}

static enum status draw_heads(struct pen *pen, struct run run, struct stroke *s)
{
    const struct paint paint = paint_of(run.layer->style);
    bool any = false;
    for (size_t k = 0; k < run.count; k++) {
        const struct figure_layer *layer = &run.layer[k];
        const enum status status = pen_clip(pen, layer, s);
        if (status != STATUS_OK)
            return status;
        for (size_t i = 0; i < layer->head_count; i++) {
            struct vec2 head[3];
            if (!stroke_head(s, layer->heads[i], 7 + 2 * paint.width, head))
                continue;
            if (!any) {
                block_begin(pen, "arrowheads", run.layer->entry);
                put_fill(pen->script, paint.colour);
            }
            any = true;
            put_head(pen, head);
        }
    }
    if (any)
        block_end(pen);
    return STATUS_OK;
}

static bool same_style(struct figure_style a, struct figure_style b)
{
    return a.role == b.role && a.dash == b.dash && a.width == b.width;
}

/* The run that starts at layer k. */
static struct run run_at(const struct figure *f, size_t k)
{
    struct run run = { &f->layers[k], 1 };
    for (k++; k < f->layer_count && f->layers[k].kind == FIGURE_CURVE; k++) {
        if (!same_style(f->layers[k].style, run.layer->style))
            break;
        run.count++;
    }
    return run;
}

static enum status draw_region(struct pen *pen,
                               const struct figure_layer *layer,
                               struct stroke *s)
{
    const enum status status = stroke_clip_region(
        &pen->page->x, &pen->page->y, layer->x, layer->y, layer->count, s);
    if (status != STATUS_OK || s->count < 3)
        return status;
    stroke_thin(s, TOL_FIGURE_PX);
    block_begin(pen, "region", layer->entry);
    put_fill(pen->script, paint_of(layer->style).colour);
    put_stroke(pen, s);
    block_end(pen);
    return STATUS_OK;
}

static bool is_visible(const struct layout *page, double x, double y)
{
    return x >= page->x.lo && x <= page->x.hi && y >= page->y.lo &&
           y <= page->y.hi;
}

/* gnuplot's point types. */
static const int mark_types[] = {
    [FIGURE_DISC] = 7, [FIGURE_CIRCLE] = 6, [FIGURE_SQUARE] = 5,
    [FIGURE_PLUS] = 1, [FIGURE_CROSS] = 2,
};

static void put_mark(FILE *out, const struct figure_layer *layer)
{
    const struct paint paint = paint_of(layer->style);
    fprintf(out, "with points pt %d ps %.4g*dot lw %.4g lc rgb '%s'",
            mark_types[layer->mark], layer->size, paint.width, paint.colour);
}

/* One more line of the plot command for the points of a block. */
static void put_again(struct pen *pen, size_t block, int type, double size,
                      const char *colour)
{
    fprintf(pen->script,
            "with points pt %d ps %.4g*dot lc rgb '%s', \\\n"
            "  data index %zu ",
            type, size, colour, block);
}

/* A white rim first, which sets the mark off from the lines below.  A circle
 * is a disc with a white one in it: terminals disagree about line widths. */
static void put_marks(struct pen *pen, const struct figure_layer *layer,
                      size_t block)
{
    const struct paint paint = paint_of(layer->style);
    const int disc = mark_types[FIGURE_DISC];
    const double ring = layer->size + 1.5;
    switch (layer->mark) {
        case FIGURE_CIRCLE:
            put_again(pen, block, disc, ring + 2.5, "white");
            put_again(pen, block, disc, ring, paint.colour);
            fprintf(pen->script, "with points pt %d ps %.4g*dot lc rgb 'white'",
                    disc, fmax(1, ring - 2 * paint.width));
            break;
        case FIGURE_DISC:
        case FIGURE_SQUARE:
            put_again(pen, block, mark_types[layer->mark], layer->size + 2.5,
                      "white");
            put_mark(pen->script, layer);
            break;
        case FIGURE_PLUS:
        case FIGURE_CROSS:
            put_mark(pen->script, layer);
            break;
    }
}

static void draw_points(struct pen *pen, const struct figure_layer *layer)
{
    const size_t block = pen->blocks;
    size_t visible = 0;
    for (size_t k = 0; k < layer->count; k++) {
        if (!is_visible(pen->page, layer->x[k], layer->y[k]))
            continue;
        if (visible++ == 0)
            block_begin(pen, "points", layer->entry);
        fprintf(pen->data, "%.12g %.12g\n", layer->x[k], layer->y[k]);
    }
    if (visible == 0)
        return;
    block_end(pen);
    put_marks(pen, layer, block);
}

/* Tail and tip of arrow k; false if it cannot be drawn. */
static bool arrow_at(const struct layout *page,
                     const struct figure_layer *layer, size_t k,
                     struct vec2 *tail, struct vec2 *tip)
{
    const struct vec2 way = { layer->dx[k] * scale_rate(&page->x),
                              layer->dy[k] * scale_rate(&page->y) };
    const double r = vec2_length(way);
    if (!is_visible(page, layer->x[k], layer->y[k]) || !isfinite(r) || !(r > 0))
        return false;
    const struct vec2 centre = { scale_pixel(&page->x, layer->x[k]),
                                 scale_pixel(&page->y, layer->y[k]) };
    const struct vec2 half = vec2_scale(layer->size / 2 / r, way);
    *tail = vec2_sub(centre, half);
    *tip = vec2_add(centre, half);
    return true;
}

/* Shafts, then heads. */
static void draw_arrows(struct pen *pen, const struct figure_layer *layer)
{
    const struct paint paint = paint_of(layer->style);
    struct vec2 tail, tip, head[3];
    block_begin(pen, "arrow shafts", layer->entry);
    put_line(pen, &paint);
    for (size_t k = 0; k < layer->count; k++) {
        if (!arrow_at(pen->page, layer, k, &tail, &tip))
            continue;
        put_point(pen, tail);
        put_point(pen, tip);
        fputc('\n', pen->data);
    }
    fprintf(pen->data, "NaN NaN\n");
    block_end(pen);
    block_begin(pen, "arrow tips", layer->entry);
    put_fill(pen->script, paint.colour);
    for (size_t k = 0; k < layer->count; k++) {
        if (!arrow_at(pen->page, layer, k, &tail, &tip))
            continue;
        const struct vec2 base =
            vec2_add(vec2_scale(0.55, tip), vec2_scale(0.45, tail));
        stroke_barb(base, tip, head);
        put_head(pen, head);
    }
    fprintf(pen->data, "NaN NaN\n");
    block_end(pen);
}

/* Viewers of SVG blur the cells of a coarse image, so each becomes a block of
 * equal ones. */
static size_t pen_copies(size_t cells)
{
    return cells < TOL_FIGURE_CELLS ? (TOL_FIGURE_CELLS + cells - 1) / cells
                                    : 1;
}

size_t pen_cells(size_t cells)
{
    return cells * pen_copies(cells);
}

static void draw_raster(struct pen *pen, const struct figure_raster *r)
{
    const size_t nx = pen_cells(r->nx), ny = pen_cells(r->ny);
    block_begin(pen, "raster", r->scale.label);
    fprintf(pen->script, "matrix axes x2y2 with image");
    for (size_t j = 0; j < ny; j++) {
        const double *row = r->value + j / pen_copies(r->ny) * r->nx;
        for (size_t i = 0; i < nx; i++) {
            const double v = row[i / pen_copies(r->nx)];
            if (isfinite(v))
                fprintf(pen->data, "%.5g ", v);
            else
                fprintf(pen->data, "NaN ");
        }
        fputc('\n', pen->data);
    }
    block_end(pen);
}

/* Draws layer k and what forms one run with it; *next is the layer after. */
static enum status draw_layer(struct pen *pen, const struct figure *f, size_t k,
                              struct stroke *stroke, size_t *next)
{
    const struct figure_layer *layer = &f->layers[k];
    enum status s = STATUS_OK;
    struct run run = { layer, 1 };
    switch (layer->kind) {
        case FIGURE_CURVE:
            run = run_at(f, k);
            s = draw_lines(pen, run, stroke);
            if (s == STATUS_OK)
                s = draw_heads(pen, run, stroke);
            break;
        case FIGURE_REGION:
            s = draw_region(pen, layer, stroke);
            break;
        case FIGURE_POINTS:
            draw_points(pen, layer);
            break;
        case FIGURE_ARROWS:
            draw_arrows(pen, layer);
            break;
    }
    *next = k + run.count;
    return s;
}

static void put_sample(const struct pen *pen, const struct legend_line *line)
{
    FILE *out = pen->script;
    const struct paint paint =
        paint_of(line->layer ? line->layer->style
                             : (struct figure_style){ .role = line->role });
    if (!line->layer)
        fprintf(out,
                "with boxes fs solid border lc rgb '#808080' "
                "fc rgb '%s'",
                paint.colour);
    else if (line->layer->kind == FIGURE_POINTS)
        put_mark(out, line->layer);
    else
        put_line(pen, &paint);
}

static void draw_legend(struct pen *pen, const struct legend *l)
{
    for (size_t k = 0; k < l->count; k++) {
        fprintf(pen->script, ", \\\n  keyentry ");
        put_sample(pen, &l->line[k]);
        fprintf(pen->script, " title ");
        label_write(pen->script, l->line[k].text, pen->page->legend_room);
    }
    if (l->left_out > 0)
        fprintf(pen->script,
                ", \\\n  keyentry with lines lc rgb 'white' "
                "title '(and %zu more)'",
                l->left_out);
}

static enum status draw_layers(struct pen *pen, const struct figure *f)
{
    struct stroke stroke = STROKE_EMPTY;
    enum status s = STATUS_OK;
    for (size_t k = 0; k < f->layer_count && s == STATUS_OK;)
        s = draw_layer(pen, f, k, &stroke, &k);
    stroke_free(&stroke);
    return s;
}

static void put_key(FILE *out, const struct layout *p)
{
    fprintf(out,
            "set key at screen %.6f,%.6f left top Left reverse vertical "
            "noenhanced samplen 2.4 spacing %.4g maxcols 1 noautotitle\n",
            p->legend_left / p->width,
            (p->bottom + p->y.pixels + 4) / p->height, p->device->spacing);
}

enum status pen_draw(struct pen *pen, const struct figure *f,
                     const struct legend *l)
{
    put_key(pen->script, pen->page);
    fprintf(pen->script, "plot NaN notitle");
    if (f->raster)
        draw_raster(pen, f->raster);
    const enum status s = draw_layers(pen, f);
    draw_legend(pen, l);
    return s;
}
