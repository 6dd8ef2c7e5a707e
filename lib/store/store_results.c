#include "store_results.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "store_grid.h"
#include "store_records.h"
#include "tolerance.h"

/* ---- attributes ---------------------------------------------------------- */

static enum status put_number(struct store *st, const char *group,
                              const char *key, const struct quantity *q)
{
    char error[RESULT_NAME + 8], spread[RESULT_NAME + 8];

    if (!quantity_exists(q))
        return STATUS_OK;
    snprintf(error, sizeof error, "%s_error", key);
    snprintf(spread, sizeof spread, "%s_spread", key);
    enum status status = store_put_real(st, group, key, q->value);
    if (status == STATUS_OK)
        status = store_put_real(st, group, error, q->error);
    return status || isnan(q->spread)
               ? status
               : store_put_real(st, group, spread, q->spread);
}

static enum status put_attribute(struct store *st, const char *group,
                                 const char *key, const struct record_field *f,
                                 const void *member)
{
    switch (f->kind) {
        case RECORD_REAL:
            return isnan(*(const double *) member)
                       ? STATUS_OK
                       : store_put_real(st, group, key,
                                        *(const double *) member);
        case RECORD_COUNT:
            return store_put_count(st, group, key, *(const int64_t *) member);
        case RECORD_QUANTITY:
            return put_number(st, group, key, member);
        case RECORD_CODE:
        case RECORD_TEXT:
            break;
    }
    const char *text = record_word(f, member);
    return text ? store_put_text(st, group, key, text) : STATUS_OK;
}

static enum status put_attributes(struct store *st, const char *group,
                                  const struct result *r, size_t k,
                                  const struct record_array *a)
{
    enum status status = STATUS_OK;
    char key[RESULT_NAME];

    for (size_t i = 0; i < r->type->count && status == STATUS_OK; i++) {
        const struct record_field *f = &r->type->fields[i];
        result_member(r, k, f, key);
        status = put_attribute(st, group, key, f, record_member(a, 0, f));
    }
    return status;
}

/* ---- one result ---------------------------------------------------------- */

static enum status put_view(struct store *st, const struct result *r, size_t k,
                            size_t n, const struct result_view *v)
{
    const struct record_array *a = &v->records;
    char group[RESULT_NAME];

    if (!v->here)
        return STATUS_OK;
    result_path(r, k, n, group);
    if (r->shape == RESULT_ATTRIBUTES)
        return put_attributes(st, group, r, k, a);
    return r->shape == RESULT_SCALARS
               ? store_put_scalars(st, group, a->type, a->at)
               : store_put_records(st, group, a, r->axis);
}

/* All instances. */
static enum status put_result(struct store *st, const struct result *r,
                              const struct results *all)
{
    const size_t n = result_count(r, all->run);
    enum status status = STATUS_OK;

    for (size_t k = 0; k < n && status == STATUS_OK; k++) {
        struct result_view view;
        status = result_open(all, r, k, &view);
        if (status == STATUS_OK)
            status = put_view(st, r, k, n, &view);
        result_close(&view);
    }
    return status;
}

/* ---- layers -------------------------------------------------------------- */

enum { LAYERS_MAX = 16 };

/* The layers of one group, and room for a block of rows of them. */
struct grid {
    struct store *st;
    const struct results *all;
    const struct monitor *monitor;
    const struct result *of[LAYERS_MAX];
    size_t results;
    char axis[2][32];
    size_t rows, columns;
    void *records, *values; /* owned */
};

/* "psi, v" */
static void read_axes(struct grid *g)
{
    const char *comma = strchr(g->of[0]->axis, ',');

    snprintf(g->axis[0], sizeof g->axis[0], "%.*s",
             (int) (comma - g->of[0]->axis), g->of[0]->axis);
    snprintf(g->axis[1], sizeof g->axis[1], "%s", comma + 2);
}

static enum status create_layers(struct grid *g)
{
    const char *path = g->of[0]->path;
    enum status status = store_axis_length(g->st, path, g->axis[0], &g->rows);

    if (status == STATUS_OK)
        status = store_axis_length(g->st, path, g->axis[1], &g->columns);
    for (size_t i = 0; i < g->results; i++)
        for (size_t k = 0; k < g->of[i]->type->count && !status; k++)
            status =
                store_put_cube(g->st, path, &g->of[i]->type->fields[k], 2,
                               (const char *const[]){ g->axis[0], g->axis[1] });
    return status;
}

/* One member of n records, one after another. */
static void store_results_gather(const struct record_type *type,
                                 const struct record_field *f,
                                 const void *records, size_t n, char *out)
{
    const size_t size =
        f->kind == RECORD_CODE ? sizeof(int8_t) : sizeof(double);

    for (size_t i = 0; i < n; i++)
        memcpy(out + i * size,
               (const char *) records + i * type->size + f->offset, size);
}

static enum status put_members(const struct grid *g, const struct result *r,
                               size_t first, size_t count)
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < r->type->count && status == STATUS_OK; i++) {
        const struct record_field *f = &r->type->fields[i];
        store_results_gather(r->type, f, g->records, count * g->columns,
                             g->values);
        status = store_put_rows(g->st, r->path, f, first, count, g->values);
    }
    return status;
}

static enum status put_block(const struct grid *g, size_t first, size_t count)
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < g->results && status == STATUS_OK; i++) {
        const struct result *r = g->of[i];
        if (i == 0 || r->rows != g->of[i - 1]->rows)
            status = r->rows(g->all->run, first, count, g->monitor, g->records);
        if (status == STATUS_OK)
            status = put_members(g, r, first, count);
    }
    return status;
}

/* Whole chunks, each compressed once. */
static enum status put_blocks(struct grid *g)
{
    const size_t block = g->rows < STORE_CHUNK ? g->rows : STORE_CHUNK;
    size_t size = 0;
    enum status status = STATUS_OK;

    for (size_t i = 0; i < g->results; i++)
        if (g->of[i]->type->size > size)
            size = g->of[i]->type->size;
    g->records = malloc(block * g->columns * size + 1);
    g->values = malloc(
        block * g->columns * (size == 1 ? sizeof(int8_t) : sizeof(double)) + 1);
    if (g->records == NULL || g->values == NULL)
        status = STATUS_NO_MEMORY;
    for (size_t j = 0; j < g->rows && status == STATUS_OK; j += block)
        status = put_block(g, j, g->rows - j < block ? g->rows - j : block);
    free(g->records);
    free(g->values);
    return status;
}

/* From r on, all layers of its group. */
static enum status put_layers(struct store *st, const struct result *r,
                              const struct results *all,
                              const struct monitor *monitor)
{
    struct grid g = { .st = st, .all = all, .monitor = monitor };

    for (const struct result *of = r; of->type && of->shape == RESULT_LAYERS &&
                                      strcmp(of->path, r->path) == 0;
         of++)
        if (result_asked(of, all) && g.results < LAYERS_MAX)
            g.of[g.results++] = of;
    if (g.results == 0)
        return STATUS_OK;
    read_axes(&g);
    const enum status status = create_layers(&g);
    return status ? status : put_blocks(&g);
}

/* ---- all ----------------------------------------------------------------- */

enum status store_put_results(struct store *st, const struct results *told,
                              const struct monitor *monitor)
{
    const struct results own = { .table = told->table,
                                 .run = told->run,
                                 .kept = told->kept,
                                 .asked = told->asked };
    const struct results *all = &own;
    enum status status = STATUS_OK;

    for (size_t t = 0; all->table[t]; t++) {
        const char *grid = NULL; /* whose layers have been put */
        for (const struct result *r = all->table[t]; r->type && !status; r++) {
            if (r->shape == RESULT_LAYERS &&
                (!grid || strcmp(r->path, grid) != 0))
                status = put_layers(st, r, all, monitor);
            else if (r->shape != RESULT_LAYERS && r->path &&
                     result_asked(r, all))
                status = put_result(st, r, all);
            grid = r->shape == RESULT_LAYERS ? r->path : NULL;
        }
    }
    return status;
}
