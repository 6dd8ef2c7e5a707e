#include "sweep_layer.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "room.h"
#include "study_results.h"
#include "sweep_results.h"

/* ---- which --------------------------------------------------------------- */

/* "/basin" and "label" are basin_label. */
static enum status add(struct sweep_layers *l, const struct sweep_dims *d,
                       const struct result *r, const struct record_field *f)
{
    enum sweep_dim dim[SWEEP_RANK] = { SWEEP_DIMS, SWEEP_DIMS };

    if (ROOM_FOR(l->at, l->room, l->count + 1) != STATUS_OK)
        return STATUS_NO_MEMORY;
    struct sweep_layer *layer = &l->at[l->count++];
    (void) sweep_dims_of(r->axis, r->path, dim);
    *layer = (struct sweep_layer){ .unit = f->unit,
                                   .codes = f->codes,
                                   .of = r,
                                   .dim = { dim[0], dim[1] },
                                   .member = f->offset,
                                   .offset = l->size,
                                   .rows = d->of[dim[0]].count,
                                   .columns = d->of[dim[1]].count };
    snprintf(layer->name, sizeof layer->name, "%s_%s", r->path + 1, f->name);
    snprintf(layer->text, sizeof layer->text, "%s", f->text);
    l->size += (sweep_layer_size(layer) + 7) / 8 * 8;
    return STATUS_OK;
}

static enum status add_tables(struct sweep_layers *l,
                              const struct sweep_dims *d,
                              const struct results *all)
{
    enum status status = STATUS_OK;

    for (size_t t = 0; all->table[t]; t++)
        for (const struct result *r = all->table[t]; r->type && !status; r++)
            for (size_t i = 0; i < r->type->count && !status; i++)
                if (r->shape == RESULT_LAYERS && result_asked(r, all))
                    status = add(l, d, r, &r->type->fields[i]);
    return status;
}

enum status sweep_layers_init(struct sweep_layers *l, const struct scene *scene,
                              const struct sweep_dims *d)
{
    const uint64_t asked = sweep_asked(scene);

    *l = (struct sweep_layers){ .at = NULL };
    if (scene->system)
        return STATUS_OK;
    enum status status = add_tables(
        l, d, &(struct results){ .table = study_tables, .asked = asked });
    l->of_study = l->count;
    if (status == STATUS_OK)
        status = add_tables(
            l, d, &(struct results){ .table = point_tables, .asked = asked });
    if (status != STATUS_OK)
        sweep_layers_free(l);
    return status;
}

void sweep_layers_free(struct sweep_layers *l)
{
    free(l->at);
    *l = (struct sweep_layers){ .at = NULL };
}

/* Of one value. */
static size_t width(const struct sweep_layer *layer)
{
    return layer->codes ? sizeof(int8_t) : sizeof(double);
}

size_t sweep_layer_size(const struct sweep_layer *layer)
{
    return layer->rows * layer->columns * width(layer);
}

/* ---- what is there ------------------------------------------------------- */

/* One member of n records, one after another. */
static void gather(const struct sweep_layer *layer, const void *from, size_t n,
                   char *to)
{
    const char *member = (const char *) from + layer->member;

    for (size_t i = 0; i < n; i++)
        memcpy(to + i * width(layer), member + i * layer->of->type->size,
               width(layer));
}

/* `count` layers of the same records, rows first .. first + rows - 1. */
static enum status fill_band(const struct sweep_layer layer[], size_t count,
                             const void *run, size_t first, size_t rows,
                             const struct monitor *monitor, void *records,
                             char *block)
{
    const enum status status =
        layer->of->rows(run, first, rows, monitor, records);

    for (size_t i = 0; i < count && status == STATUS_OK; i++)
        gather(&layer[i], records, rows * layer[i].columns,
               block + layer[i].offset +
                   first * layer[i].columns * width(&layer[i]));
    return status;
}

/* In bands, so that few records are in memory. */
static enum status fill(const struct sweep_layer layer[], size_t count,
                        const void *run, const struct monitor *monitor,
                        char *block)
{
    const size_t rows = layer->rows;
    enum status status = STATUS_OK;
    void *records =
        malloc(PATCHWORK_TILE * layer->columns * layer->of->type->size + 1);

    if (records == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < rows && status == STATUS_OK; i += PATCHWORK_TILE)
        status =
            fill_band(layer, count, run, i,
                      rows - i < PATCHWORK_TILE ? rows - i : PATCHWORK_TILE,
                      monitor, records, block);
    free(records);
    return status;
}

/* Nothing, but not a byte undefined. */
static void clear(const struct sweep_layers *l, char *block)
{
    const double nan = (double) NAN;

    memset(block, 0, l->size);
    for (size_t k = 0; k < l->count; k++) {
        const struct sweep_layer *layer = &l->at[k];
        char *to = block + layer->offset;
        if (layer->codes)
            memset(to, -1, sweep_layer_size(layer));
        for (size_t i = 0; !layer->codes && i < layer->rows * layer->columns;
             i++)
            memcpy(to + i * sizeof nan, &nan, sizeof nan);
    }
}

enum status sweep_layers_fill(const struct sweep_layers *l,
                              const struct sweep_point *p,
                              const struct monitor *monitor, char *block)
{
    enum status status = STATUS_OK;
    size_t n;

    clear(l, block);
    if (p->failed)
        return STATUS_OK;
    for (size_t k = 0; k < l->count && status == STATUS_OK; k += n) {
        const struct sweep_layer *layer = &l->at[k];
        for (n = 1; k + n < l->count && layer[n].of->rows == layer->of->rows;)
            n++;
        status =
            fill(layer, n,
                 k < l->of_study ? (const void *) &p->study : (const void *) p,
                 monitor, block);
    }
    return status;
}
