#include "fields.h"

#include <stdlib.h>

#include "study.h"
#include "study_tolerance.h"

/* Cells between two looks at the monitor. */
enum { LOOK = 256 };

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
    (void) monitor, (void) why;
    s->fields = (struct fields){ s, 0, s->scene->cell_rtol };
    for (size_t i = 0; i < sizeof asks / sizeof *asks; i++)
        if (s->scene->products & 1u << asks[i].product)
            s->fields.which |= asks[i].which;
    return STATUS_OK;
}

/* Cell centres in the chart. */
struct centres {
    const double *x, *y;
    size_t columns, rows;
};

/* Cells first .. first + count - 1 of the centres. */
static enum status find(const struct fields *f, const struct centres *at,
                        size_t first, size_t count,
                        const struct monitor *monitor, struct cell out[])
{
    const size_t end = first + count, total = at->columns * at->rows;
    struct vec2 z[LOOK];
    enum status status = STATUS_OK;

    for (size_t i = first; i < end && status == STATUS_OK; i += LOOK) {
        const size_t n = end - i < LOOK ? end - i : LOOK;
        for (size_t k = 0; k < n; k++)
            z[k] = (struct vec2){ at->x[(i + k) % at->columns],
                                  at->y[(i + k) / at->columns] };
        status = cells_find(f->study, z, n, f->rtol, f->which, NULL,
                            out + (i - first));
        if (status == STATUS_OK && monitor_tell(monitor, "cells", i + n, total))
            status = STATUS_STOPPED;
    }
    return status;
}

enum status fields_find(const struct fields *f, size_t first, size_t count,
                        const struct monitor *monitor, struct cell out[])
{
    const struct basin_map *m = &f->study->basins;
    const struct centres at = { m->x, m->y, m->columns, m->rows };

    return find(f, &at, first, count, monitor, out);
}

static double value_of(const struct cell *c, enum cell_field field)
{
    const double value[CELL_FIELDS] = { [CELL_SLIP] = c->slip,
                                        [CELL_TIME] = c->time,
                                        [CELL_MU_MEAN] = c->mu_mean,
                                        [CELL_V_PEAK] = c->v_peak,
                                        [CELL_MU_PEAK] = c->mu_peak };
    return value[field];
}

enum status fields_raster(const struct fields *f, enum cell_field field,
                          size_t columns, size_t rows,
                          const struct monitor *monitor, double out[])
{
    const struct fields rough = { f->study, 1u << field, TOL_FIELDS_PICTURE };
    const size_t longest = columns > rows ? columns : rows;
    double *x = malloc(columns * sizeof *x), *y = malloc(rows * sizeof *y);
    double *stored = malloc(longest * sizeof *stored);
    struct cell *cell = malloc(columns * rows * sizeof *cell);
    enum status status = STATUS_NO_MEMORY;

    if (x && y && stored && cell) {
        const struct centres at = { x, y, columns, rows };
        basin_map_axis(f->study, BASIN_V, columns, x, stored);
        basin_map_axis(f->study, BASIN_PSI, rows, y, stored);
        status = find(&rough, &at, 0, columns * rows, monitor, cell);
    }
    for (size_t i = 0; i < columns * rows && status == STATUS_OK; i++)
        out[i] = value_of(&cell[i], field);
    free(x);
    free(y);
    free(stored);
    free(cell);
    return status;
}
