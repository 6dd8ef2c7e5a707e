#include "figure.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "layer.h"

/* NULL stays NULL; false when memory is out. */
static bool text_copy(const char *text, char **copy)
{
    *copy = NULL;
    if (!text)
        return true;
    const size_t size = strlen(text) + 1;
    *copy = malloc(size);
    if (*copy)
        memcpy(*copy, text, size);
    return *copy != NULL;
}

static bool axis_copy(const struct figure_axis *axis, struct figure_axis *copy)
{
    char *label;
    const bool ok = text_copy(axis->label, &label);
    *copy = *axis;
    copy->label = label;
    return ok;
}

static void axis_free(struct figure_axis *axis)
{
    free((char *) (uintptr_t) axis->label);
    axis->label = NULL;
}

enum status figure_init(struct figure *f, const char *title,
                        const struct figure_axis *x,
                        const struct figure_axis *y)
{
    *f = FIGURE_EMPTY;
    f->width = 900;
    f->height = 600;
    if (text_copy(title, &f->title) && axis_copy(x, &f->x) &&
        axis_copy(y, &f->y))
        return STATUS_OK;
    figure_free(f);
    return STATUS_NO_MEMORY;
}

static void layer_free(struct figure_layer *layer)
{
    free(layer->entry);
    free(layer->numbers);
}

/* Copies column k of a layer's numbers. */
static const double *column(struct figure_layer *layer, size_t k,
                            const double *from, size_t count)
{
    double *to = layer->numbers + k * layer->count;
    if (count > 0)
        memcpy(to, from, count * sizeof *to);
    return to;
}

/* Room for `columns` columns and the heads, a copy of the entry, and a place
 * at the end of the list, which the caller takes by counting it. */
static enum status layer_begin(struct figure *f, const char *entry,
                               size_t columns, struct figure_layer *layer)
{
    if (f->layer_count == f->layer_room) {
        const size_t room = f->layer_room ? 2 * f->layer_room : 16;
        void *grown = realloc(f->layers, room * sizeof *f->layers);
        if (!grown)
            return STATUS_NO_MEMORY;
        f->layers = grown;
        f->layer_room = room;
    }
    const size_t numbers = columns * layer->count + layer->head_count;
    layer->numbers = calloc(numbers + 1, sizeof *layer->numbers);
    if (layer->numbers && text_copy(entry, &layer->entry))
        return STATUS_OK;
    layer_free(layer);
    return STATUS_NO_MEMORY;
}

static void layer_end(struct figure *f, const struct figure_layer *layer)
{
    f->layers[f->layer_count++] = *layer;
}

enum status figure_add_curve(struct figure *f, const struct figure_curve *c)
{
    struct figure_layer layer = { .kind = LAYER_CURVE,
                                  .style = c->style,
                                  .count = c->count,
                                  .head_count = c->head_count };
    const enum status s = layer_begin(f, c->entry, 2, &layer);
    if (s != STATUS_OK)
        return s;
    layer.x = column(&layer, 0, c->x, c->count);
    layer.y = column(&layer, 1, c->y, c->count);
    layer.heads = column(&layer, 2, c->heads, c->head_count);
    layer_end(f, &layer);
    return STATUS_OK;
}

enum status figure_add_points(struct figure *f, const struct figure_points *p)
{
    struct figure_layer layer = { .kind = LAYER_POINTS,
                                  .style = p->style,
                                  .mark = p->mark,
                                  .size = p->size > 0 ? p->size : 10,
                                  .count = p->count };
    const enum status s = layer_begin(f, p->entry, 2, &layer);
    if (s != STATUS_OK)
        return s;
    layer.x = column(&layer, 0, p->x, p->count);
    layer.y = column(&layer, 1, p->y, p->count);
    layer_end(f, &layer);
    return STATUS_OK;
}

enum status figure_add_arrows(struct figure *f, const struct figure_arrows *a)
{
    struct figure_layer layer = { .kind = LAYER_ARROWS,
                                  .style = a->style,
                                  .size = a->length > 0 ? a->length : 14,
                                  .count = a->count };
    const enum status s = layer_begin(f, a->entry, 4, &layer);
    if (s != STATUS_OK)
        return s;
    layer.x = column(&layer, 0, a->x, a->count);
    layer.y = column(&layer, 1, a->y, a->count);
    layer.dx = column(&layer, 2, a->dx, a->count);
    layer.dy = column(&layer, 3, a->dy, a->count);
    layer_end(f, &layer);
    return STATUS_OK;
}

enum status figure_add_region(struct figure *f, const struct figure_region *r)
{
    struct figure_layer layer = { .kind = LAYER_REGION,
                                  .style.role = r->role,
                                  .count = r->count };
    const enum status s = layer_begin(f, r->entry, 2, &layer);
    if (s != STATUS_OK)
        return s;
    layer.x = column(&layer, 0, r->x, r->count);
    layer.y = column(&layer, 1, r->y, r->count);
    layer_end(f, &layer);
    return STATUS_OK;
}

static void raster_free(struct figure_raster *r)
{
    if (!r)
        return;
    for (size_t k = 0; k < FIGURE_SHADES_MAX; k++)
        free(r->entry[k]);
    axis_free(&r->scale);
    free(r->value);
    free(r);
}

static struct figure_raster *raster_new(size_t nx, size_t ny)
{
    assert(nx > 0 && ny > 0);
    struct figure_raster *r = calloc(1, sizeof *r);
    if (!r)
        return NULL;
    r->nx = nx;
    r->ny = ny;
    r->value = calloc(nx * ny + 1, sizeof *r->value);
    if (r->value)
        return r;
    raster_free(r);
    return NULL;
}

static void raster_replace(struct figure *f, struct figure_raster *r)
{
    raster_free(f->raster);
    f->raster = r;
}

static bool shades_copy(const struct figure_labels *l, struct figure_raster *r,
                        double index[256])
{
    const size_t n =
        l->shade_count < FIGURE_SHADES_MAX ? l->shade_count : FIGURE_SHADES_MAX;
    for (size_t k = 0; k < 256; k++)
        index[k] = NAN;
    for (size_t k = 0; k < n; k++) {
        index[(uint8_t) l->shades[k].label] = (double) k;
        r->role[k] = l->shades[k].role;
        if (!text_copy(l->shades[k].entry, &r->entry[k]))
            return false;
    }
    r->shade_count = n;
    return true;
}

enum status figure_add_labels(struct figure *f, const struct figure_labels *l)
{
    double index[256];
    struct figure_raster *r = raster_new(l->nx, l->ny);
    if (!r || !shades_copy(l, r, index)) {
        raster_free(r);
        return STATUS_NO_MEMORY;
    }
    for (size_t k = 0; k < l->nx * l->ny; k++)
        r->value[k] = index[(uint8_t) l->label[k]];
    raster_replace(f, r);
    return STATUS_OK;
}

/* The range of what can be drawn, never empty. */
static void range_find(const struct figure_raster *r, struct figure_axis *a)
{
    double lo = INFINITY, hi = -INFINITY;
    for (size_t k = 0; k < r->nx * r->ny; k++) {
        const double v = r->value[k];
        if (!isfinite(v) || (a->is_log && !(v > 0)))
            continue;
        lo = fmin(lo, v);
        hi = fmax(hi, v);
    }
    if (!(lo <= hi))
        lo = hi = 1;
    const double pad = lo == hi ? fmax(fabs(lo), 1e-300) / 2 : 0;
    a->lo = lo - pad;
    a->hi = hi + pad;
}

enum status figure_add_map(struct figure *f, const struct figure_map *m)
{
    struct figure_raster *r = raster_new(m->nx, m->ny);
    if (!r || !axis_copy(&m->scale, &r->scale)) {
        raster_free(r);
        return STATUS_NO_MEMORY;
    }
    if (m->nx * m->ny > 0)
        memcpy(r->value, m->value, m->nx * m->ny * sizeof *r->value);
    if (r->scale.lo == r->scale.hi)
        range_find(r, &r->scale);
    raster_replace(f, r);
    return STATUS_OK;
}

void figure_free(struct figure *f)
{
    for (size_t k = 0; k < f->layer_count; k++)
        layer_free(&f->layers[k]);
    free(f->layers);
    raster_free(f->raster);
    axis_free(&f->x);
    axis_free(&f->y);
    free(f->title);
    *f = FIGURE_EMPTY;
}
