#include "legend.h"

#include <math.h>
#include <string.h>

#include "layout.h"
#include "stroke.h"

/* A layer of a text that is there already adds its mark, or its line. */
static bool legend_join(struct legend *l, const struct legend_line *line)
{
    for (size_t k = 0; k < l->count; k++) {
        struct legend_line *old = &l->line[k];
        if (strcmp(old->text, line->text) != 0)
            continue;
        old->curve = old->curve ? old->curve : line->curve;
        old->mark = old->mark ? old->mark : line->mark;
        return true;
    }
    return false;
}

static void legend_add(struct legend *l, struct legend_line line)
{
    if (!line.text || legend_join(l, &line))
        return;
    if (l->count == LEGEND_MAX)
        l->left_out++;
    else
        l->line[l->count++] = line;
}

static void add_shade(struct legend *l, const char *text, enum figure_role role)
{
    legend_add(l, (struct legend_line){ .text = text, .role = role });
}

/* ---- only what is drawn -------------------------------------------------- */

/* Whether any of it lies in the axes' box. */
static bool is_drawn(const struct figure *f, const struct figure_layer *l,
                     struct stroke *s)
{
    const struct scale x = scale_of(&f->x, 1000), y = scale_of(&f->y, 1000);

    if (l->kind == FIGURE_CURVE)
        return stroke_clip(&x, &y, l->x, l->y, l->count, s) != STATUS_OK ||
               s->count > 0;
    if (l->kind == FIGURE_REGION)
        return stroke_clip_region(&x, &y, l->x, l->y, l->count, s) !=
                   STATUS_OK ||
               s->count > 0;
    for (size_t i = 0; i < l->count; i++)
        if (l->x[i] >= f->x.lo && l->x[i] <= f->x.hi && l->y[i] >= f->y.lo &&
            l->y[i] <= f->y.hi)
            return true;
    return false;
}

static bool has_shade(const struct figure_raster *r, size_t shade)
{
    for (size_t i = 0; i < r->nx * r->ny; i++)
        if (r->value[i] == (double) shade)
            return true;
    return false;
}

/* A curve of a text that has one already adds nothing. */
static bool has_curve(const struct legend *l, const struct figure_layer *layer)
{
    for (size_t k = 0; k < l->count && layer->kind == FIGURE_CURVE; k++)
        if (l->line[k].curve && strcmp(l->line[k].text, layer->entry) == 0)
            return true;
    return false;
}

static void add_layers(struct legend *l, const struct figure *f, bool regions)
{
    struct stroke s = STROKE_EMPTY;

    for (size_t k = 0; k < f->layer_count; k++) {
        const struct figure_layer *layer = &f->layers[k];
        const bool points = layer->kind == FIGURE_POINTS;
        if ((layer->kind == FIGURE_REGION) != regions || !layer->entry ||
            has_curve(l, layer) || !is_drawn(f, layer, &s))
            continue;
        if (regions)
            add_shade(l, layer->entry, layer->style.role);
        else
            legend_add(l,
                       (struct legend_line){ .text = layer->entry,
                                             .curve = points ? NULL : layer,
                                             .mark = points ? layer : NULL });
    }
    stroke_free(&s);
}

struct legend legend_of(const struct figure *f)
{
    struct legend l = { .count = 0 };

    add_layers(&l, f, false);
    if (f->raster && figure_raster_hatched(f->raster))
        add_shade(&l, f->raster->missing, FIGURE_ABSENT);
    for (size_t k = 0; f->raster && k < f->raster->shade_count; k++)
        if (has_shade(f->raster, k))
            add_shade(&l, f->raster->entry[k], f->raster->role[k]);
    add_layers(&l, f, true);
    return l;
}

/* Row by row in so many columns; no text is cut that can be broken. */
static bool legend_flow(struct legend *l, double width, size_t columns)
{
    const double column = width / (double) columns;
    double y = 0;

    l->text_room = column - LEGEND_SAMPLE - 2 * LEGEND_SKIP;
    const double room = l->text_room / LAYOUT_FONT;
    bool fits = true;
    for (size_t k = 0; k < l->count;) {
        size_t parts = 1;
        for (size_t i = 0; i < columns && k < l->count; i++, k++) {
            struct legend_line *line = &l->line[k];
            line->at = (struct vec2){ (double) i * column, y };
            line->parts =
                label_break(line->text, room, line->part, LEGEND_PARTS);
            for (size_t j = 0; j < line->parts; j++)
                fits &= label_part_width(line->part[j]) <= room;
            parts = line->parts > parts ? line->parts : parts;
        }
        y += (double) parts * LEGEND_LINE;
    }
    l->size = (struct vec2){ width, y + (l->left_out ? LEGEND_LINE : 0) };
    return fits;
}

void legend_arrange(struct legend *l, double width, size_t most)
{
    size_t best = 1;
    double height = INFINITY;

    for (size_t n = 1; n <= most; n++)
        if (legend_flow(l, width, n) && l->size.y < height) {
            height = l->size.y;
            best = n;
        }
    (void) legend_flow(l, width, best);
}

double legend_width(const struct legend *l)
{
    double width = 0;

    for (size_t k = 0; k < l->count; k++)
        width = fmax(width, label_width(l->line[k].text));
    return width * LAYOUT_FONT + LEGEND_SAMPLE + 2 * LEGEND_SKIP + 1;
}

/* ---- inside -------------------------------------------------------------- */

/* Points of curves in the box; a mark counts as many. */
static double legend_clutter(const struct figure *f, const struct scale *x,
                             const struct scale *y, struct box b)
{
    enum { MARK = 1000 };
    double sum = 0;

    for (size_t k = 0; k < f->layer_count; k++) {
        const struct figure_layer *l = &f->layers[k];
        const double each = l->kind == FIGURE_POINTS ? MARK : 1;
        for (size_t i = 0; i < l->count && l->kind != FIGURE_REGION; i++)
            if (box_holds(b, (struct vec2){ scale_pixel(x, l->x[i]),
                                            scale_pixel(y, l->y[i]) }))
                sum += each;
    }
    return sum;
}

struct vec2 legend_corner(const struct figure *f, const struct scale *x,
                          const struct scale *y, struct vec2 size)
{
    struct vec2 best = { 0, 0 };
    double least = INFINITY;

    for (int k = 0; k < 4; k++) {
        const double left =
            k % 2 ? LEGEND_SKIP : x->pixels - size.x - LEGEND_SKIP;
        const double top =
            k < 2 ? y->pixels - LEGEND_SKIP : size.y + LEGEND_SKIP;
        const struct box b = { { left, top - size.y }, { left + size.x, top } };
        const double here = legend_clutter(f, x, y, b);
        if (here < least) {
            least = here;
            best = (struct vec2){ left, top };
        }
    }
    return best;
}
