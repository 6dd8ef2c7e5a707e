#include "pen.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contour.h"
#include "label.h"
#include "layer.h"
#include "look.h"
#include "palette.h"
#include "stroke.h"
#include "ticks.h"
#include "tolerance.h"

/* Opens a block of data and the line of the plot command that draws it. */
static void block_begin(struct pen *pen, const char *what, const char *entry)
{
    fprintf(pen->data, "# block %zu: %s ", pen->blocks, what);
    label_comment(pen->data, entry ? entry : "");
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
    fprintf(pen->script, "with lines ");
    look_line(pen->script, pen->page->device, p);
}

/* White under a line, which sets it off from a map. */
static void put_casing(const struct pen *pen, const struct paint *p,
                       size_t block)
{
    fprintf(pen->script,
            "with lines lw %.4g lc rgb 'white', \\\n  data index %zu ",
            p->width + 2, block);
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
            const size_t block = pen->blocks;
            block_begin(pen, "curves", run.layer->entry);
            if (pen->cased)
                put_casing(pen, &paint, block);
            put_line(pen, &paint);
        }
        any = true;
        stroke_thin(s, pen->page->slack);
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
    stroke_thin(s, pen->page->slack);
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

static void put_mark(const struct pen *pen, const struct figure_layer *layer)
{
    fprintf(pen->script, "with points ");
    look_mark(pen->script, pen->page->device, layer);
}

/* Discs, squares, ... of a size of their own in that colour. */
static void put_disc(const struct pen *pen, enum figure_mark mark, double size,
                     const char *colour)
{
    fprintf(pen->script, "with points pt %d ps %.4g lc rgb '%s'",
            look_type(mark), size * pen->page->device->point, colour);
}

/* One more line of the plot command for the points of a block. */
static void put_again(const struct pen *pen, size_t block)
{
    fprintf(pen->script, ", \\\n  data index %zu ", block);
}

static bool is_filled(enum figure_mark mark)
{
    return mark == FIGURE_DISC || mark == FIGURE_SQUARE ||
           mark == FIGURE_TRIANGLE || mark == FIGURE_DIAMOND;
}

/* A white rim first, which sets the mark off from the lines below.  A circle
 * is a disc with a white one in it: terminals disagree about line widths. */
static void put_marks(struct pen *pen, const struct figure_layer *layer,
                      size_t block)
{
    const struct paint paint = paint_of(layer->style);
    const double ring = layer->size + 1.5;

    if (layer->mark == FIGURE_CIRCLE) {
        put_disc(pen, FIGURE_DISC, ring + 2.5, "white");
        put_again(pen, block);
        put_disc(pen, FIGURE_DISC, ring, paint.colour);
        put_again(pen, block);
        put_disc(pen, FIGURE_DISC, fmax(1, ring - 2 * paint.width), "white");
        return;
    }
    if (is_filled(layer->mark)) {
        put_disc(pen, layer->mark, layer->size + 2.5, "white");
        put_again(pen, block);
    }
    put_mark(pen, layer);
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

/* A cell of an image, `copies` times; returns where it ends. */
static char *put_cell(char *at, double v, size_t copies)
{
    const char *const form = isfinite(v) ? "%.5g " : "NaN ";
    const size_t size = (size_t) sprintf(at, form, v);

    for (size_t k = 1; k < copies; k++)
        memcpy(at + k * size, at, size);
    return at + copies * size;
}

/* A row of cells, of 13 letters at most, is written out once, and copied. */
static enum status draw_raster(struct pen *pen, const struct figure_raster *r)
{
    const bool is_log = r->shade_count == 0 && r->scale.is_log;
    char *row = malloc(pen_cells(r->nx) * 13 + 1);

    if (row == NULL)
        return STATUS_NO_MEMORY;
    block_begin(pen, "raster", r->scale.label);
    fprintf(pen->script, "matrix axes x2y2 with image");
    for (size_t j = 0; j < r->ny; j++) {
        const double *cell = r->value + j * r->nx;
        char *at = row;
        for (size_t i = 0; i < r->nx; i++)
            at = put_cell(at, is_log ? log10(cell[i]) : cell[i],
                          pen_copies(r->nx));
        *at++ = '\n';
        for (size_t k = 0; k < pen_copies(r->ny); k++)
            fwrite(row, 1, (size_t) (at - row), pen->data);
    }
    block_end(pen);
    free(row);
    return STATUS_OK;
}

/* ---- contours of a map --------------------------------------------------- */

enum {
    CONTOUR_TEXT = LAYOUT_FONT
}; /* px: its powers are no smaller than 6 pt */

/* White behind it. */
static void put_label(struct pen *pen, struct vec2 at, const char *text)
{
    const struct layout *p = pen->page;

    fprintf(pen->data, "# block %zu: label of a contour\n", pen->blocks);
    fprintf(pen->script,
            ", \\\n  data index %zu using 1:2:3 with labels center boxed "
            "enhanced font ',%.4g'",
            pen->blocks++, CONTOUR_TEXT * p->device->font);
    fprintf(pen->data, "%.12g %.12g \"", scale_value(&p->x, at.x),
            scale_value(&p->y, at.y));
    ticks_put(pen->data, text, p->script);
    fprintf(pen->data, "\"\n");
    block_end(pen);
}

/* The line of one level. */
static enum status draw_contour(struct pen *pen, const struct figure_raster *r,
                                double level, struct stroke *s)
{
    const struct paint paint =
        paint_of((struct figure_style){ .role = FIGURE_CONTOUR });
    const struct vec2 box = { pen->page->x.pixels, pen->page->y.pixels };
    const enum status status = contour_trace(r, level, box, s);

    if (status != STATUS_OK || s->count == 0)
        return status;
    block_begin(pen, "contour", NULL);
    put_line(pen, &paint);
    put_stroke(pen, s);
    block_end(pen);
    return STATUS_OK;
}

/* Takes the figure's curves and marks, and what has no value. */
static enum status keep_figure(const struct pen *pen, const struct figure *f,
                               struct stroke *s, struct keep *keep)
{
    enum status status = STATUS_OK;

    keep_gaps(keep, f->raster);
    for (size_t k = 0; k < f->layer_count && status == STATUS_OK; k++) {
        const struct figure_layer *l = &f->layers[k];
        const double half = l->size / 2.0 + 2.0;
        if (l->kind == FIGURE_CURVE)
            status = pen_clip(pen, l, s);
        if (l->kind == FIGURE_CURVE && status == STATUS_OK)
            keep_stroke(keep, s, KEEP_ALL);
        for (size_t i = 0; l->kind == FIGURE_POINTS && i < l->count; i++)
            keep_box(keep,
                     (struct vec2){ scale_pixel(&pen->page->x, l->x[i]),
                                    scale_pixel(&pen->page->y, l->y[i]) },
                     (struct vec2){ half, half });
    }
    return status;
}

/* A label on the line of each level, if there is room for it. */
static enum status label_contours(struct pen *pen, const struct figure *f,
                                  const struct tick_label label[], size_t count,
                                  struct stroke *s, struct keep *keep)
{
    const struct vec2 box = { pen->page->x.pixels, pen->page->y.pixels };

    for (size_t k = 0; k < count; k++) {
        const struct vec2 size = { label_width(label[k].text) * CONTOUR_TEXT,
                                   CONTOUR_TEXT };
        const enum status status =
            contour_trace(f->raster, label[k].at, box, s);
        struct vec2 at;
        if (status != STATUS_OK)
            return status;
        if (!contour_place(s, size, keep, (uint8_t) (KEEP_OWN + k), &at))
            continue;
        keep_box(keep, at, vec2_scale(1.5, size));
        put_label(pen, at, label[k].text);
    }
    return STATUS_OK;
}

/* At the values that the bar labels. */
static enum status draw_contours(struct pen *pen, const struct figure *f,
                                 struct stroke *s)
{
    const struct vec2 box = { pen->page->x.pixels, pen->page->y.pixels };
    struct tick_label label[TICKS_LABELS];
    struct keep keep;
    const size_t count = ticks_labels(
        &pen->page->bar, layout_side_by_side(&pen->page->bar), label);
    enum status status = keep_init(&keep, box);

    for (size_t k = 0; k < count && status == STATUS_OK; k++) {
        status = draw_contour(pen, f->raster, label[k].at, s);
        keep_stroke(&keep, s, (uint8_t) (KEEP_OWN + k));
    }
    if (status == STATUS_OK)
        status = keep_figure(pen, f, s, &keep);
    if (status == STATUS_OK)
        status = label_contours(pen, f, label, count, s, &keep);
    keep_free(&keep);
    return status;
}

/* Lines first, heads on all of them, marks on top. */
enum turn { TURN_LINES, TURN_HEADS, TURN_MARKS, TURNS };

/* Draws layer k and what forms one run with it; *next is the layer after. */
static enum status draw_layer(struct pen *pen, const struct figure *f, size_t k,
                              enum turn turn, struct stroke *stroke,
                              size_t *next)
{
    const struct figure_layer *layer = &f->layers[k];
    const struct run run =
        layer->kind == FIGURE_CURVE ? run_at(f, k) : (struct run){ layer, 1 };
    enum status s = STATUS_OK;

    if (turn == TURN_LINES && layer->kind == FIGURE_CURVE)
        s = draw_lines(pen, run, stroke);
    else if (turn == TURN_HEADS && layer->kind == FIGURE_CURVE)
        s = draw_heads(pen, run, stroke);
    else if (turn == TURN_LINES && layer->kind == FIGURE_REGION)
        s = draw_region(pen, layer, stroke);
    else if (turn == TURN_LINES && layer->kind == FIGURE_ARROWS)
        draw_arrows(pen, layer);
    else if (turn == TURN_MARKS && layer->kind == FIGURE_POINTS)
        draw_points(pen, layer);
    *next = k + run.count;
    return s;
}

static enum status draw_layers(struct pen *pen, const struct figure *f)
{
    struct stroke stroke = STROKE_EMPTY;
    enum status s = STATUS_OK;
    if (f->raster && f->raster->contours)
        s = draw_contours(pen, f, &stroke);
    for (int turn = 0; turn < TURNS; turn++)
        for (size_t k = 0; k < f->layer_count && s == STATUS_OK;)
            s = draw_layer(pen, f, k, (enum turn) turn, &stroke, &k);
    stroke_free(&stroke);
    return s;
}

enum status pen_draw(struct pen *pen, const struct figure *f)
{
    fprintf(pen->script, "unset key\nplot NaN notitle");
    pen->cased = f->raster && f->raster->shade_count == 0;
    const enum status status =
        f->raster ? draw_raster(pen, f->raster) : STATUS_OK;
    return status ? status : draw_layers(pen, f);
}
