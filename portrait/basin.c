#include "basin.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tolerance.h"

/* The first column at or right of x. */
static size_t column_from(const struct basin_grid *g, double x)
{
    size_t lo = 0, hi = g->columns;

    while (lo < hi) {
        const size_t middle = lo + (hi - lo) / 2;
        if (g->x[middle] < x)
            lo = middle + 1;
        else
            hi = middle;
    }
    return lo;
}

static void cut_row(struct basin *b, size_t row, struct crossing c[])
{
    const struct separatrix *s = b->regions->separatrix;
    const double y = b->grid.y[row];
    const size_t n = separatrix_row(s, y, c);
    size_t *cut = b->cut + row * b->regions->most;
    size_t *doubt = b->doubt + 2 * row * s->count;

    for (size_t k = 0; k < n && k < b->regions->most; k++)
        cut[k] = column_from(&b->grid, c[k].at);
    for (size_t i = 0; i < s->count; i++) {
        double lo, hi;
        const bool near = separatrix_near(s, i, y, &lo, &hi);
        doubt[2 * i] = near ? column_from(&b->grid, lo) : 0;
        doubt[2 * i + 1] =
            near ? column_from(&b->grid, nextafter(hi, HUGE_VAL)) : 0;
    }
}

static enum status cut_rows(struct basin *b)
{
    const size_t room = b->regions->separatrix->count + 1;
    bool failed = false;

#pragma omp parallel if (b->grid.rows >= BASIN_PARALLEL_ROWS)
    {
        struct crossing *c = malloc(room * sizeof *c);
        if (c == NULL) {
#pragma omp atomic write
            failed = true;
        }
#pragma omp for schedule(static)
        for (size_t j = 0; j < b->grid.rows; j++)
            if (c)
                cut_row(b, j, c);
        free(c);
    }
    return failed ? STATUS_NO_MEMORY : STATUS_OK;
}

enum status basin_init(struct basin *b, const struct regions *regions,
                       const struct basin_grid *grid)
{
    *b = (struct basin){ .regions = regions, .grid = *grid };
    if (grid->rows == 0 || grid->columns == 0)
        return STATUS_BAD_ARGUMENT;
    const size_t strands = regions->separatrix->count;
    b->cut = malloc((grid->rows * regions->most + 1) * sizeof *b->cut);
    b->doubt = malloc((grid->rows * strands * 2 + 1) * sizeof *b->doubt);
    const enum status s = b->cut && b->doubt ? cut_rows(b) : STATUS_NO_MEMORY;
    if (s != STATUS_OK)
        basin_free(b);
    return s;
}

static void fill_row(const struct basin *b, size_t row, int8_t out[])
{
    const struct regions *r = b->regions;
    const struct band *band = regions_band(r, b->grid.y[row]);
    const size_t *cut = b->cut + row * r->most;

    for (size_t k = 0; k <= band->strands; k++) {
        const size_t from = k == 0 ? 0 : cut[k - 1];
        const size_t to = k == band->strands ? b->grid.columns : cut[k];
        if (to > from)
            memset(out + from, r->region[band->first + k].label, to - from);
    }
    for (size_t i = 0; i < r->separatrix->count; i++) {
        const size_t *doubt = b->doubt + 2 * (row * r->separatrix->count + i);
        if (doubt[1] > doubt[0])
            memset(out + doubt[0], REGION_UNLABELLED, doubt[1] - doubt[0]);
    }
}

void basin_fill(const struct basin *b, size_t first, size_t count, int8_t out[])
{
    const size_t columns = b->grid.columns;

#pragma omp parallel for schedule(static) if (count >= BASIN_PARALLEL_ROWS)
    for (size_t j = 0; j < count; j++)
        fill_row(b, first + j, out + j * columns);
}

bool basin_is_near(const struct basin *b, size_t row, size_t column)
{
    const size_t strands = b->regions->separatrix->count;
    const size_t *doubt = b->doubt + 2 * row * strands;
    bool near = false;

    for (size_t i = 0; i < strands && !near; i++)
        near = column >= doubt[2 * i] && column < doubt[2 * i + 1];
    return near;
}

void basin_free(struct basin *b)
{
    free(b->cut);
    free(b->doubt);
    *b = (struct basin){ .regions = NULL };
}
