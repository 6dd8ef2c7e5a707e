#include "basin.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- bands --------------------------------------------------------------- */

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *) a, y = *(const double *) b;
    return (x > y) - (x < y);
}

/* Ends of strands inside the window, and its own two. */
static enum status find_bands(struct basin *b)
{
    const struct separatrix *s = b->separatrix;
    const struct box w = b->grid.window;
    double *end = malloc((2 * s->count + 2) * sizeof *end);
    size_t n = 0;

    b->band = calloc(2 * s->count + 1, sizeof *b->band);
    if (end == NULL || b->band == NULL) {
        free(end);
        return STATUS_NO_MEMORY;
    }
    end[n++] = -HUGE_VAL;
    for (size_t i = 0; i < s->count; i++) {
        const double e[2] = { s->strand[i].lo, s->strand[i].hi };
        for (int k = 0; k < 2; k++)
            if (e[k] > w.lo.y && e[k] < w.hi.y)
                end[n++] = e[k];
    }
    qsort(end + 1, n - 1, sizeof *end, ascending);
    for (size_t i = 0; i < n; i++) {
        const double hi = i + 1 < n ? end[i + 1] : HUGE_VAL;
        if (hi > end[i])
            b->band[b->bands++] = (struct basin_band){ .lo = end[i], .hi = hi };
    }
    free(end);
    return STATUS_OK;
}

/* A row well inside the band and the window. */
static double middle(const struct basin *b, const struct basin_band *band)
{
    const struct box w = b->grid.window;
    return 0.5 * (fmax(band->lo, w.lo.y) + fmin(band->hi, w.hi.y));
}

static void count_regions(struct basin *b)
{
    const struct separatrix *s = b->separatrix;

    for (size_t i = 0; i < b->bands; i++) {
        struct basin_band *band = &b->band[i];
        const double y = middle(b, band);
        for (size_t k = 0; k < s->count; k++)
            band->strands += y >= s->strand[k].lo && y < s->strand[k].hi;
        band->first = b->regions;
        b->regions += band->strands + 1;
        b->cuts = band->strands > b->cuts ? band->strands : b->cuts;
    }
}

static const struct basin_band *band_of(const struct basin *b, size_t row)
{
    size_t i = 0;

    while (!(b->grid.y[row] < b->band[i].hi))
        i++;
    return &b->band[i];
}

/* ---- rows ---------------------------------------------------------------- */

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

static size_t *cuts_of(const struct basin *b, size_t row)
{
    return b->cut + row * b->cuts;
}

static void cut_row(const struct basin *b, size_t row, struct crossing c[])
{
    const size_t n = separatrix_row(b->separatrix, b->grid.y[row], c);

    for (size_t k = 0; k < n && k < b->cuts; k++)
        cuts_of(b, row)[k] = column_from(&b->grid, c[k].at);
}

static enum status cut_rows(struct basin *b)
{
    const size_t room = b->separatrix->count + 1;
    bool failed = false;

#pragma omp parallel if (b->grid.rows > 256)
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

/* Columns from .. to - 1 of region number k in a row of n strands. */
struct run {
    size_t from, to;
};

static struct run run_of(const struct basin *b, size_t row, size_t k, size_t n)
{
    const size_t *cut = cuts_of(b, row);
    return (struct run){ k == 0 ? 0 : cut[k - 1],
                         k == n ? b->grid.columns : cut[k] };
}

/* Where no cell has its centre in a region, the window still may. */
static void seed_between_cells(struct basin *b, const struct basin_band *band,
                               struct crossing c[])
{
    const struct box w = b->grid.window;
    const double y = middle(b, band);
    const size_t n = separatrix_row(b->separatrix, y, c);

    for (size_t k = 0; k <= n; k++) {
        struct basin_region *r = &b->region[band->first + k];
        const double left = k == 0 ? w.lo.x : fmax(c[k - 1].at, w.lo.x);
        const double right = k == n ? w.hi.x : fmin(c[k].at, w.hi.x);
        if (r->used || !(left < right))
            continue;
        r->used = true;
        r->seed = (struct vec2){ 0.5 * (left + right), y };
    }
}

static enum status find_seeds(struct basin *b)
{
    const struct basin_grid *g = &b->grid;
    struct crossing *c = malloc((b->separatrix->count + 1) * sizeof *c);

    if (c == NULL)
        return STATUS_NO_MEMORY;
    for (size_t j = 0; j < g->rows; j++) {
        const struct basin_band *band = band_of(b, j);
        for (size_t k = 0; k <= band->strands; k++) {
            struct basin_region *r = &b->region[band->first + k];
            const struct run run = run_of(b, j, k, band->strands);
            if (run.to <= run.from || run.to - run.from <= r->cells)
                continue;
            r->used = true;
            r->cells = run.to - run.from;
            r->seed = (struct vec2){ g->x[run.from + r->cells / 2], g->y[j] };
        }
    }
    for (size_t i = 0; i < b->bands; i++)
        seed_between_cells(b, &b->band[i], c);
    free(c);
    return STATUS_OK;
}

enum status basin_init(struct basin *b, const struct separatrix *separatrix,
                       const struct basin_grid *grid)
{
    *b = (struct basin){ .separatrix = separatrix, .grid = *grid };
    if (grid->rows == 0 || grid->columns == 0 ||
        separatrix->along != SEPARATRIX_Y)
        return STATUS_BAD_ARGUMENT;
    enum status s = find_bands(b);
    if (s == STATUS_OK) {
        count_regions(b);
        b->region = calloc(b->regions, sizeof *b->region);
        b->cut = calloc(grid->rows * b->cuts + 1, sizeof *b->cut);
        s = b->region && b->cut ? cut_rows(b) : STATUS_NO_MEMORY;
    }
    if (s == STATUS_OK)
        s = find_seeds(b);
    if (s != STATUS_OK)
        basin_free(b);
    return s;
}

/* ---- labels -------------------------------------------------------------- */

enum status basin_label(struct basin *b, basin_fate *fate, const void *ctx)
{
    enum status s = STATUS_OK;

    for (size_t i = 0; i < b->regions && s == STATUS_OK; i++)
        if (b->region[i].used)
            s = fate(ctx, b->region[i].seed, &b->region[i].label);
    return s;
}

const struct basin_region *basin_at(const struct basin *b, size_t row,
                                    size_t column)
{
    const struct basin_band *band = band_of(b, row);
    size_t k = 0;

    while (k < band->strands && column >= cuts_of(b, row)[k])
        k++;
    return &b->region[band->first + k];
}

void basin_fill(const struct basin *b, size_t first, size_t count, int8_t out[])
{
    const size_t columns = b->grid.columns;

#pragma omp parallel for schedule(static) if (count * columns > 1 << 20)
    for (size_t j = 0; j < count; j++) {
        const struct basin_band *band = band_of(b, first + j);
        for (size_t k = 0; k <= band->strands; k++) {
            const struct run run = run_of(b, first + j, k, band->strands);
            if (run.to > run.from)
                memset(out + j * columns + run.from,
                       b->region[band->first + k].label, run.to - run.from);
        }
    }
}

void basin_free(struct basin *b)
{
    free(b->band);
    free(b->region);
    free(b->cut);
    *b = (struct basin){ .separatrix = NULL };
}
