#include "plane_map.h"

#include <math.h>
#include <stdlib.h>

#include "basin.h"
#include "plane_mosaic.h"
#include "separatrix.h"

static bool is_on_flat(const struct separatrix *cuts, struct vec2 z)
{
    bool on = false;

    for (size_t i = 0; i < cuts->flats && !on; i++) {
        const struct flat *f = &cuts->flat[i];
        on = fabs(z.y - f->w) <= f->error && z.x >= f->from - f->error &&
             z.x <= f->to + f->error;
    }
    return on;
}

bool plane_map_is_near(const struct plane_study *s, struct vec2 z)
{
    const struct separatrix *cuts = &s->basin.cuts;
    bool near = is_on_flat(cuts, z);
    double lo, hi;

    for (size_t i = 0; i < cuts->count && !near; i++)
        near =
            separatrix_near(cuts, i, z.y, &lo, &hi) && z.x >= lo && z.x <= hi;
    return near;
}

enum status plane_map_at(const struct plane_study *s, struct vec2 z, bool cells,
                         int8_t *label)
{
    const struct regions *r = &s->basin.regions;
    struct crossing *c = calloc(r->most + 1, sizeof *c);

    if (c == NULL)
        return STATUS_NO_MEMORY;
    const size_t region = regions_at(r, z, c);
    *label = plane_map_is_near(s, z) ? -1
             : cells                 ? plane_mosaic_at(s, region, z, c)
                                     : r->region[region].label;
    free(c);
    return STATUS_OK;
}

double plane_map_cell(const struct plane_study *s, int axis, size_t i, size_t n,
                      bool chart)
{
    const double part = ((double) i + 0.5) / (double) n;
    const struct vec2 z = window_at(&s->window, (struct vec2){ part, part });
    const double at = axis == 0 ? z.x : z.y;

    return chart ? at : plane_state(s, axis, at);
}

/* The cells of a row whose region has no label, out of mosaics; c: room for all
 * crossings of a row. */
static void fill_from_mosaics(const struct plane_study *s,
                              const struct basin *b, size_t row,
                              struct crossing c[], int8_t out[])
{
    const double *x = b->grid.x, y = b->grid.y[row];
    const struct band *band = regions_band(&s->basin.regions, y);
    const size_t n = separatrix_row(&s->basin.cuts, y, c);
    size_t k = 0;

    for (size_t i = 0; i < b->grid.columns; i++) {
        const struct vec2 z = { x[i], y };
        while (k < n && z.x >= c[k].at)
            k++;
        if (out[i] < 0 && !basin_is_near(b, row, i) &&
            !is_on_flat(&s->basin.cuts, z))
            out[i] = plane_mosaic_at(s, band->first + k, z, c);
    }
}

/* Rows of a grid, into out; where there is no label, one above all. */
static void fill_rows(const struct plane_study *s, const struct basin *b,
                      struct crossing c[], int8_t out[])
{
    const size_t columns = b->grid.columns;

    basin_fill(b, 0, b->grid.rows, out);
    for (size_t j = 0; j < b->grid.rows && s->basin.mosaics > 0; j++)
        fill_from_mosaics(s, b, j, c, out + j * columns);
    for (size_t i = 0; i < columns * b->grid.rows; i++)
        if (out[i] < 0)
            out[i] = (int8_t) s->basin.labels;
}

enum status plane_map_fill(const struct plane_study *s, size_t columns,
                           size_t rows, size_t first, size_t count,
                           int8_t out[])
{
    double *x = malloc((columns + rows) * sizeof *x), *y = x + columns;
    struct crossing *c = calloc(s->basin.regions.most + 1, sizeof *c);
    struct basin b = { .regions = NULL };
    enum status status = x && c ? STATUS_OK : STATUS_NO_MEMORY;

    for (size_t i = 0; i < columns && x; i++)
        x[i] = plane_map_cell(s, 0, i, columns, true);
    for (size_t j = 0; j < count && x; j++)
        y[j] = plane_map_cell(s, 1, first + j, rows, true);
    if (status == STATUS_OK)
        status = basin_init(&b, &s->basin.regions,
                            &(struct basin_grid){ x, y, columns, count });
    if (status == STATUS_OK)
        fill_rows(s, &b, c, out);
    basin_free(&b);
    free(c);
    free(x);
    return status;
}
