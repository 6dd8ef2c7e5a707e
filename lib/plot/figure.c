#include "figure.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "layer.h"
#include "room.h"

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

const struct figure_page figure_screen = { .width = 900 * 25.4 / 96,
                                           .height = 600 * 25.4 / 96,
                                           .type = 9.75,
                                           .dpi = 192 };

/* A user's text: no marks. */
static void figure_unmark(char *text)
{
    for (; text && *text; text++)
        if ((unsigned char) *text < ' ')
            *text = ' ';
}

static bool axis_copy(const struct figure_axis *axis, struct figure_axis *copy)
{
    char *label;
    const bool ok = text_copy(axis->label, &label);
    *copy = *axis;
    copy->label = label;
    return ok;
}

/* What the caller thinks borrowed is ours. */
static void figure_release(const void *owned)
{
    free((void *) (uintptr_t) owned);
}

void figure_init(struct figure *f, const char *title,
                 const struct figure_axis *x, const struct figure_axis *y)
{
    *f = FIGURE_EMPTY;
    f->page = figure_screen;
    if (!text_copy(title, &f->title) || !axis_copy(x, &f->x) ||
        !axis_copy(y, &f->y))
        f->status = STATUS_NO_MEMORY;
    figure_unmark(f->title);
}

/* Moves *column into our numbers, from *to on. */
static void figure_keep(const double **column, size_t count, double **to)
{
    if (*column == NULL || count == 0)
        return;
    memcpy(*to, *column, count * sizeof **to);
    *column = *to;
    *to += count;
}

void figure_add(struct figure *f, const struct figure_layer *layer)
{
    struct figure_layer l = *layer;
    char *entry = NULL;

    if (f->status != STATUS_OK)
        return;
    double *numbers = calloc(4 * l.count + l.head_count + 1, sizeof *numbers);
    double *to = numbers;
    if (!numbers || ROOM_FOR(f->layers, f->layer_room, f->layer_count + 1) ||
        !text_copy(l.entry, &entry)) {
        free(numbers);
        f->status = STATUS_NO_MEMORY;
        return;
    }
    l.entry = entry;
    if (!(l.size > 0))
        l.size = l.kind == FIGURE_ARROWS ? 14 : 10;
    l.x = l.count > 0 ? l.x : numbers; /* all else is freed with it */
    figure_keep(&l.x, l.count, &to);
    figure_keep(&l.y, l.count, &to);
    figure_keep(&l.dx, l.count, &to);
    figure_keep(&l.dy, l.count, &to);
    figure_keep(&l.heads, l.head_count, &to);
    f->layers[f->layer_count++] = l;
}

static void raster_free(struct figure_raster *r)
{
    if (!r)
        return;
    for (size_t k = 0; k < FIGURE_SHADES_MAX; k++)
        free(r->entry[k]);
    free(r->missing);
    figure_release(r->scale.label);
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

/* Takes over r, or only notes that there is none. */
static void raster_replace(struct figure *f, struct figure_raster *r, bool good)
{
    struct figure_raster *old = f->raster;

    if (good && f->status == STATUS_OK) {
        f->raster = r;
        r = old;
    } else if (f->status == STATUS_OK) {
        f->status = STATUS_NO_MEMORY;
    }
    raster_free(r);
}

bool figure_raster_hatched(const struct figure_raster *r)
{
    bool gap = false;

    for (size_t i = 0; i < r->nx * r->ny && !gap; i++)
        gap = !isfinite(r->value[i]);
    return gap && r->missing != NULL;
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

void figure_add_labels(struct figure *f, const struct figure_labels *l)
{
    double index[256];
    struct figure_raster *r = raster_new(l->nx, l->ny);
    const bool good =
        r && shades_copy(l, r, index) && text_copy(l->missing, &r->missing);

    for (size_t k = 0; good && k < l->nx * l->ny; k++)
        r->value[k] = index[(uint8_t) l->label[k]];
    raster_replace(f, r, good);
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

void figure_add_map(struct figure *f, const struct figure_map *m)
{
    struct figure_raster *r = raster_new(m->nx, m->ny);
    const bool good = r && axis_copy(&m->scale, &r->scale) &&
                      text_copy(m->missing, &r->missing);

    if (r)
        r->contours = m->contours;
    if (good)
        memcpy(r->value, m->value, m->nx * m->ny * sizeof *r->value);
    if (good && r->scale.lo == r->scale.hi)
        range_find(r, &r->scale);
    raster_replace(f, r, good);
}

void figure_free(struct figure *f)
{
    for (size_t k = 0; k < f->layer_count; k++) {
        figure_release(f->layers[k].entry);
        figure_release(f->layers[k].x);
    }
    free(f->layers);
    raster_free(f->raster);
    figure_release(f->x.label);
    figure_release(f->y.label);
    free(f->title);
    *f = FIGURE_EMPTY;
}
