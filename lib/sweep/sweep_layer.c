#include "sweep_layer.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- which --------------------------------------------------------------- */

#define REAL(name_, type, member, text_)                                       \
    {                                                                          \
        .name = name_, .unit = "1", .text = text_,                             \
        .offset = offsetof(struct type, member), .kind = RECORD_REAL           \
    }

static const struct record_field label_field = {
    .name = "label",
    .unit = "1",
    .text = "fate of the state",
    .kind = RECORD_CODE,
    .codes = fate_names,
};
static const struct record_field margin_field = {
    .name = "margin",
    .unit = "1",
    .text = "ln of the factor on v to the nearest other fate",
    .kind = RECORD_REAL,
};
static const struct record_field margin_psi_field = {
    .name = "margin_psi",
    .unit = "1",
    .text = "shift of ln psi (of psi where it is a logarithm) to the nearest "
            "other fate",
    .kind = RECORD_REAL,
};
static const struct record_field arrow_fields[] = {
    REAL("direction_v", arrow, direction.x, "unit direction as drawn, along v"),
    REAL("direction_psi", arrow, direction.y,
         "unit direction as drawn, along psi"),
    REAL("log10_speed", arrow, log10_speed,
         "log10 of the speed in (ln v, ln psi) per L/V_star"),
};
static const struct record_field chi_field = { .name = "ln_chi",
                                               .unit = "1",
                                               .text = "ln chi(v), (34)" };
static const struct record_field chi_error_field = {
    .name = "ln_chi_error",
    .unit = "1",
    .text = "bound on the error of ln_chi",
};

/* What precedes a layer's name, and its axes. */
static const struct {
    const char *prefix;
    enum sweep_dim dim[2];
} grids[LAYER_SOURCES] = {
    [LAYER_LABEL] = { "basin_", { DIM_PSI, DIM_V } },
    [LAYER_MARGIN] = { "basin_", { DIM_PSI, DIM_V } },
    [LAYER_MARGIN_PSI] = { "basin_", { DIM_PSI, DIM_V } },
    [LAYER_CELL] = { "basin_", { DIM_PSI, DIM_V } },
    [LAYER_ARROW] = { "arrow_", { DIM_ARROW_PSI, DIM_ARROW_V } },
    [LAYER_CHI] = { "chi_", { DIM_CHI_ALPHA, DIM_CHI_V } },
    [LAYER_CHI_ERROR] = { "chi_", { DIM_CHI_ALPHA, DIM_CHI_V } },
};

static struct sweep_layer *room_for_one(struct sweep_layers *l)
{
    if (l->count == l->room) {
        const size_t room = 2 * l->room + 16;
        struct sweep_layer *at = realloc(l->at, room * sizeof *at);
        if (at == NULL)
            return NULL;
        l->at = at;
        l->room = room;
    }
    return &l->at[l->count++];
}

static enum status add(struct sweep_layers *l, const struct sweep_dims *d,
                       enum layer_source source, const struct record_field *f)
{
    const enum sweep_dim row = grids[source].dim[0];
    const enum sweep_dim column = grids[source].dim[1];
    struct sweep_layer *layer = room_for_one(l);

    if (layer == NULL)
        return STATUS_NO_MEMORY;
    *layer = (struct sweep_layer){ .unit = f->unit,
                                   .codes = f->codes,
                                   .source = source,
                                   .dim = { row, column },
                                   .member = f->offset,
                                   .offset = l->size,
                                   .rows = d->of[row].count,
                                   .columns = d->of[column].count };
    snprintf(layer->name, sizeof layer->name, "%s%s", grids[source].prefix,
             f->name);
    snprintf(layer->text, sizeof layer->text, "%s", f->text);
    l->size += (sweep_layer_size(layer) + 7) / 8 * 8;
    return STATUS_OK;
}

/* Number i of record_cell; exit_reason is there beside any other. */
static bool is_asked(const struct scene *scene, size_t i)
{
    static const unsigned product[CELL_FIELDS] = {
        [CELL_SLIP] = 1u << PRODUCT_SLIP,
        [CELL_TIME] = 1u << PRODUCT_TIME,
        [CELL_MU_MEAN] = 1u << PRODUCT_FRICTION,
        [CELL_V_PEAK] = 1u << PRODUCT_PEAK,
        [CELL_MU_PEAK] = 1u << PRODUCT_PEAK,
    };
    unsigned any = 0;

    for (int k = 0; k < CELL_FIELDS; k++)
        any |= product[k];
    return scene->products & (i == 0 ? any : product[(i - 1) / 2]);
}

static enum status add_map(struct sweep_layers *l, const struct scene *scene,
                           const struct sweep_dims *d)
{
    const bool margins = scene->products & 1u << PRODUCT_MARGIN;
    enum status status = add(l, d, LAYER_LABEL, &label_field);

    if (status == STATUS_OK && margins)
        status = add(l, d, LAYER_MARGIN, &margin_field);
    if (status == STATUS_OK && margins)
        status = add(l, d, LAYER_MARGIN_PSI, &margin_psi_field);
    for (size_t i = 0; i < record_cell.count && status == STATUS_OK; i++)
        if (is_asked(scene, i))
            status = add(l, d, LAYER_CELL, &record_cell.fields[i]);
    return status;
}

static enum status add_arrows(struct sweep_layers *l,
                              const struct sweep_dims *d)
{
    const size_t fields = sizeof arrow_fields / sizeof *arrow_fields;
    enum status status = STATUS_OK;

    for (size_t i = 0; i < fields && status == STATUS_OK; i++)
        status = add(l, d, LAYER_ARROW, &arrow_fields[i]);
    return status;
}

static enum status add_chi(struct sweep_layers *l, const struct sweep_dims *d)
{
    const enum status status = add(l, d, LAYER_CHI, &chi_field);

    return status ? status : add(l, d, LAYER_CHI_ERROR, &chi_error_field);
}

enum status sweep_layers_init(struct sweep_layers *l, const struct scene *scene,
                              const struct sweep_dims *d)
{
    const unsigned stages = plan_stages(scene->products);
    enum status status = STATUS_OK;

    *l = (struct sweep_layers){ .at = NULL };
    if (plan_has(stages, STAGE_BASINS))
        status = add_map(l, scene, d);
    if (status == STATUS_OK && plan_has(stages, STAGE_ARROWS))
        status = add_arrows(l, d);
    if (status == STATUS_OK && plan_has(stages, STAGE_CHI))
        status = add_chi(l, d);
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

/* One member of n records of `size` bytes each. */
static void gather(const struct sweep_layer *layer, const void *from,
                   size_t size, size_t n, char *to)
{
    const char *member = (const char *) from + layer->member;

    for (size_t i = 0; i < n; i++)
        memcpy(to + i * width(layer), member + i * size, width(layer));
}

/* Some rows of the basin map, on their way into a block. */
struct swath {
    const struct study *study;
    size_t first, rows;
    struct cell *cell; /* owned; NULL: no fields */
    char *block;
};

static void *place_of(const struct swath *b, const struct sweep_layer *layer)
{
    return b->block + layer->offset + b->first * layer->columns * width(layer);
}

/* Both margins are found together, with the first of them. */
static enum status fill_layer(const struct swath *b,
                              const struct sweep_layer *layer)
{
    const struct basin_map *m = &b->study->basins;

    switch (layer->source) {
        case LAYER_LABEL:
            return basin_map_rows(m, b->first, b->rows, place_of(b, layer));
        case LAYER_MARGIN:
            return basin_map_margins(m, b->first, b->rows, place_of(b, layer),
                                     place_of(b, layer + 1));
        case LAYER_CELL:
            gather(layer, b->cell, sizeof *b->cell, b->rows * m->columns,
                   place_of(b, layer));
            break;
        default:
            break;
    }
    return STATUS_OK;
}

/* In bands, so that few cells are in memory. */
static enum status fill_map(const struct sweep_layers *l, const struct study *s,
                            const struct monitor *monitor, char *block)
{
    const struct basin_map *m = &s->basins;
    const bool fields = s->fields.which != 0;
    struct swath b = { .study = s, .block = block };
    enum status status = STATUS_OK;

    if (fields)
        b.cell = malloc(PATCHWORK_TILE * m->columns * sizeof *b.cell);
    if (fields && b.cell == NULL)
        return STATUS_NO_MEMORY;
    for (; b.first < m->rows && status == STATUS_OK; b.first += b.rows) {
        const size_t left = m->rows - b.first;
        b.rows = left < PATCHWORK_TILE ? left : PATCHWORK_TILE;
        if (fields)
            status = fields_find(&s->fields, b.first, b.rows, monitor, b.cell);
        for (size_t k = 0; k < l->count && status == STATUS_OK; k++)
            status = fill_layer(&b, &l->at[k]);
    }
    free(b.cell);
    return status;
}

static void fill_others(const struct sweep_layers *l, const struct study *s,
                        char *block)
{
    const struct arrows *a = &s->portrait.arrows;
    const struct chi_curves *c = &s->diagrams.chi;

    for (size_t k = 0; k < l->count; k++) {
        const struct sweep_layer *layer = &l->at[k];
        char *to = block + layer->offset;
        if (layer->source == LAYER_ARROW)
            gather(layer, a->at, sizeof *a->at, a->columns * a->rows, to);
        if (layer->source == LAYER_CHI)
            memcpy(to, c->ln_chi, sweep_layer_size(layer));
        if (layer->source == LAYER_CHI_ERROR)
            memcpy(to, c->error, sweep_layer_size(layer));
    }
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
    clear(l, block);
    if (p->failed)
        return STATUS_OK;
    fill_others(l, &p->study, block);
    return plan_has(p->study.stages, STAGE_BASINS)
               ? fill_map(l, &p->study, monitor, block)
               : STATUS_OK;
}
