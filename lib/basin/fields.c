#include "fields.h"

#include <stdio.h>
#include <stdlib.h>

#include "slow_tolerance.h"

/* ---- the source of patches ----------------------------------------------- */

static enum status find(const void *ctx, const struct vec2 z[], size_t n,
                        double rtol, unsigned which, struct cell out[])
{
    return fast_cells_find(ctx, z, n, rtol, which, NULL, out, NULL);
}

static enum status sample(const void *ctx, struct patch_sample s[], size_t n,
                          double rtol, unsigned which)
{
    return fast_cells_sample(ctx, s, n, rtol, which);
}

static bool tell(const void *ctx, struct vec2 z, const struct base_point *base,
                 unsigned which, struct cell *out)
{
    return fast_cells_tell(ctx, z, base, which, out);
}

static void friction(const void *ctx, struct vec2 z, double left,
                     double left_error, struct cell *c)
{
    fast_cells_friction(ctx, z, left, left_error, c);
}

static bool passes(const void *ctx, double one, double other)
{
    const struct fast_cells *f = ctx;
    return base_point_passes(&f->curve, one, other);
}

/* Those in which something that is asked for exists, as bits. */
static unsigned fates_of(const struct fields *f)
{
    unsigned fates = 0;

    for (unsigned k = 0; k < FATES; k++)
        if (f->which & fast_cells_fields(f->map->slider, (enum fate) k))
            fates |= 1u << k;
    return fates;
}

static enum status plan(const struct fields *f,
                        const struct patchwork_grid *grid, double rtol,
                        const struct monitor *monitor, struct patchwork *w)
{
    const struct patchwork_source source = { find,
                                             sample,
                                             { tell, friction, passes,
                                               &f->fast },
                                             fates_of(f),
                                             &f->fast };
    return patchwork_plan(w, grid, &source, rtol, f->which, monitor);
}

/* ---- the grid ------------------------------------------------------------ */

/* Some rows at a time. */
static enum status find_spans(const struct fields *f,
                              struct patchwork_span span[])
{
    const struct basin_map *m = f->map;
    int8_t *label = malloc(m->columns * PATCHWORK_TILE);
    enum status status = label ? STATUS_OK : STATUS_NO_MEMORY;

    for (size_t j = 0; j < m->rows && status == STATUS_OK; j++) {
        const size_t k = j % PATCHWORK_TILE, left = m->rows - j;
        if (k == 0)
            status = basin_map_rows(
                m, j, left < PATCHWORK_TILE ? left : PATCHWORK_TILE, label);
        if (status == STATUS_OK)
            span[j] = patchwork_span_of(label + k * m->columns, m->columns,
                                        fates_of(f));
    }
    free(label);
    return status;
}

static enum status plan_map(struct fields *f, const struct monitor *monitor)
{
    const struct basin_map *m = f->map;
    struct patchwork_span *span = malloc(m->rows * sizeof *span);
    const struct patchwork_grid grid = { m->x, m->y, m->columns, m->rows,
                                         span };
    enum status status = span ? find_spans(f, span) : STATUS_NO_MEMORY;

    if (status == STATUS_OK)
        status = plan(f, &grid, f->rtol, monitor, &f->patches);
    free(span);
    return status;
}

enum status fields_prepare(struct fields *f, const struct basin_map *m,
                           const struct monitor *monitor, struct fault *why)
{
    static const struct {
        enum product product;
        unsigned which;
    } asks[] = {
        { PRODUCT_SLIP, 1u << CELL_SLIP },
        { PRODUCT_TIME, 1u << CELL_TIME },
        { PRODUCT_FRICTION, 1u << CELL_MU_MEAN },
        { PRODUCT_PEAK, 1u << CELL_V_PEAK | 1u << CELL_MU_PEAK },
    };

    *f = (struct fields){ .map = m, .rtol = m->scene->cell_rtol };
    for (size_t i = 0; i < sizeof asks / sizeof *asks; i++)
        if (m->scene->products & 1u << asks[i].product)
            f->which |= asks[i].which;
    if (f->which == 0)
        return STATUS_OK;
    enum status status = fast_cells_init(&f->fast, m->slider, monitor);
    if (status == STATUS_OK)
        status = plan_map(f, monitor);
    return status != STATUS_OK
               ? fault_set(why, status, "the fields of the cells: %s",
                           status_text(status))
               : status;
}

void fields_free(struct fields *f)
{
    patchwork_free(&f->patches);
    fast_cells_free(&f->fast);
}

/* No cell tells of another fate than its label: an orbit beside the separatrix
 * may go to the other side. */
static void heed(const int8_t label[], size_t n, struct cell out[])
{
    for (size_t i = 0; i < n; i++)
        if (out[i].exit_reason != label[i])
            out[i] = cell_unknown;
}

/* Some rows at a time, so that the monitor hears often. */
enum status fields_find(const struct fields *f, size_t first, size_t rows,
                        const struct monitor *monitor, struct cell out[])
{
    const struct basin_map *m = f->map;
    const size_t n = m->columns, end = first + rows;
    int8_t *label = malloc(n * PATCHWORK_TILE);
    enum status status = label ? STATUS_OK : STATUS_NO_MEMORY;

    for (size_t j = first; j < end && status == STATUS_OK;
         j += PATCHWORK_TILE) {
        const size_t some = end - j < PATCHWORK_TILE ? end - j : PATCHWORK_TILE;
        status = basin_map_rows(m, j, some, label);
        if (status == STATUS_OK)
            status = patchwork_rows(&f->patches, j, some, label,
                                    out + (j - first) * n, NULL);
        if (status == STATUS_OK)
            heed(label, some * n, out + (j - first) * n);
        if (status == STATUS_OK &&
            monitor_tell(monitor, "cells", (j + some) * n, m->rows * n))
            status = STATUS_STOPPED;
    }
    free(label);
    return status;
}

/* ---- pictures ------------------------------------------------------------ */

static enum status fill_raster(const struct fields *f,
                               const struct patchwork_grid *grid,
                               const struct monitor *monitor, int8_t label[],
                               struct patchwork_span span[], struct cell out[])
{
    struct patchwork w;
    enum status status =
        basin_map_raster(f->map, grid->columns, grid->rows, label);

    if (status != STATUS_OK)
        return status;
    for (size_t j = 0; j < grid->rows; j++)
        span[j] = patchwork_span_of(label + j * grid->columns, grid->columns,
                                    fates_of(f));
    status = plan(f, grid, TOL_SEEN, monitor, &w);
    if (status == STATUS_OK)
        status = patchwork_rows(&w, 0, grid->rows, label, out, NULL);
    if (status == STATUS_OK)
        heed(label, grid->columns * grid->rows, out);
    patchwork_free(&w);
    return status;
}

enum status fields_raster(const struct fields *f, size_t columns, size_t rows,
                          const struct monitor *monitor, struct cell out[])
{
    const size_t longest = columns > rows ? columns : rows;
    double *x = malloc(columns * sizeof *x), *y = malloc(rows * sizeof *y);
    double *stored = malloc(longest * sizeof *stored);
    int8_t *label = malloc(columns * rows);
    struct patchwork_span *span = malloc(rows * sizeof *span);
    enum status status = STATUS_NO_MEMORY;

    if (x && y && stored && label && span) {
        const struct patchwork_grid grid = { x, y, columns, rows, span };
        basin_map_axis(f->map->scene, BASIN_V, columns, x, stored);
        basin_map_axis(f->map->scene, BASIN_PSI, rows, y, stored);
        status = fill_raster(f, &grid, monitor, label, span, out);
    }
    free(x);
    free(y);
    free(stored);
    free(label);
    free(span);
    return status;
}

enum status fields_states(const struct fields *f, const struct vec2 z[],
                          const int8_t label[], size_t n,
                          const struct monitor *monitor, struct cell out[])
{
    const enum status status =
        fast_cells_find(&f->fast, z, n, TOL_SEEN, f->which, monitor, out, NULL);

    if (status == STATUS_OK)
        heed(label, n, out);
    return status;
}
