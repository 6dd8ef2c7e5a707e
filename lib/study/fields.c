#include "fields.h"

#include <stdio.h>
#include <stdlib.h>

#include "study.h"
#include "study_tolerance.h"

/* Cells between two looks at the monitor. */
enum { LOOK = 1024 };

enum status fields_prepare(struct study *s, const struct monitor *monitor,
                           struct fault *why)
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
    s->fields = (struct fields){ s, 0, s->scene->cell_rtol, .fast = { 0 } };
    for (size_t i = 0; i < sizeof asks / sizeof *asks; i++)
        if (s->scene->products & 1u << asks[i].product)
            s->fields.which |= asks[i].which;
    if (s->fields.which == 0)
        return STATUS_OK;
    const enum status status = fast_cells_init(&s->fields.fast, s, monitor);
    if (status != STATUS_OK)
        snprintf(why->text, sizeof why->text, "the fields of the cells: %s",
                 status_text(status));
    return status;
}

void fields_free(struct fields *f)
{
    fast_cells_free(&f->fast);
}

/* What finds states of the grid, and tells how far it is. */
struct finder {
    const struct fast_cells *fast;
    const struct monitor *monitor;
    size_t before, total; /* cells, for the monitor */
};

static enum status find(void *ctx, const struct vec2 z[], size_t n, double rtol,
                        unsigned which, struct cell out[])
{
    const struct finder *f = ctx;
    enum status status = STATUS_OK;

    for (size_t i = 0; i < n && status == STATUS_OK; i += LOOK) {
        const size_t some = n - i < LOOK ? n - i : LOOK;
        status = fast_cells_find(f->fast, z + i, some, rtol, which, NULL,
                                 out + i, NULL);
        if (status == STATUS_OK &&
            monitor_tell(f->monitor, "cells", f->before, f->total))
            status = STATUS_STOPPED;
    }
    return status;
}

static enum status fill(const struct fields *f, struct finder *finder,
                        const struct patchwork_grid *grid, struct cell out[])
{
    const struct patchwork_source source = { find, finder };
    enum status status =
        patchwork_fill(grid, &source, f->rtol, f->which, out, NULL);

    finder->before += grid->columns * grid->rows;
    if (status == STATUS_OK &&
        monitor_tell(finder->monitor, "cells", finder->before, finder->total))
        status = STATUS_STOPPED;
    return status;
}

/* In bands of one row of squares, so that the monitor hears often. */
enum status fields_find(const struct fields *f, size_t first, size_t rows,
                        const struct monitor *monitor, struct cell out[])
{
    const struct basin_map *m = &f->study->basins;
    const size_t n = m->columns, end = first + rows;
    struct finder finder = { &f->fast, monitor, first * n, n * m->rows };
    int8_t *label = malloc(n * PATCHWORK_TILE);
    enum status status = label ? STATUS_OK : STATUS_NO_MEMORY;

    if (first % PATCHWORK_TILE != 0)
        status = STATUS_BAD_ARGUMENT;
    for (size_t j = first; j < end && status == STATUS_OK;
         j += PATCHWORK_TILE) {
        const size_t some = end - j < PATCHWORK_TILE ? end - j : PATCHWORK_TILE;
        const struct patchwork_grid grid = { m->x, m->y + j, label, n, some };
        status = basin_map_rows(m, j, some, label);
        if (status == STATUS_OK)
            status = fill(f, &finder, &grid, out + (j - first) * n);
    }
    free(label);
    return status;
}

enum status fields_raster(const struct fields *f, size_t columns, size_t rows,
                          const struct monitor *monitor, struct cell out[])
{
    const struct fields rough = { .study = f->study,
                                  .which = f->which,
                                  .rtol = TOL_FIELDS_PICTURE };
    const size_t longest = columns > rows ? columns : rows;
    struct finder finder = { &f->fast, monitor, 0, columns * rows };
    double *x = malloc(columns * sizeof *x), *y = malloc(rows * sizeof *y);
    double *stored = malloc(longest * sizeof *stored);
    int8_t *label = malloc(columns * rows);
    enum status status = STATUS_NO_MEMORY;

    if (x && y && stored && label) {
        const struct patchwork_grid grid = { x, y, label, columns, rows };
        basin_map_axis(f->study, BASIN_V, columns, x, stored);
        basin_map_axis(f->study, BASIN_PSI, rows, y, stored);
        status = basin_map_raster(&f->study->basins, columns, rows, label);
        if (status == STATUS_OK)
            status = fill(&rough, &finder, &grid, out);
    }
    free(x);
    free(y);
    free(stored);
    free(label);
    return status;
}
