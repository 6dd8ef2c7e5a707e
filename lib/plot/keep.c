#include "keep.h"

#include <math.h>
#include <stdlib.h>

/* px of a cell's side. */
static const double side = 2.0;

enum status keep_init(struct keep *k, struct vec2 box)
{
    *k = (struct keep){ .nx = (size_t) (box.x / side),
                        .ny = (size_t) (box.y / side) };
    k->taken = calloc(k->nx * k->ny + 1, 1);
    if (k->taken == NULL)
        *k = (struct keep){ .taken = NULL };
    return k->taken ? STATUS_OK : STATUS_NO_MEMORY;
}

/* Cells [lo, hi) of n from a to b px; those outside are left out. */
static void cells_of(double a, double b, size_t n, size_t *lo, size_t *hi)
{
    const double most = (double) n;

    *lo = (size_t) fmin(fmax(floor(a / side), 0.0), most);
    *hi = (size_t) fmin(fmax(floor(b / side) + 1.0, 0.0), most);
}

static void take(struct keep *k, struct vec2 at, struct vec2 half, uint8_t by)
{
    size_t x[2], y[2];

    cells_of(at.x - half.x, at.x + half.x, k->nx, &x[0], &x[1]);
    cells_of(at.y - half.y, at.y + half.y, k->ny, &y[0], &y[1]);
    for (size_t j = y[0]; j < y[1]; j++)
        for (size_t i = x[0]; i < x[1]; i++)
            k->taken[j * k->nx + i] = by;
}

/* At least one point in each cell. */
void keep_stroke(struct keep *k, const struct stroke *s, uint8_t by)
{
    for (size_t i = 0; i + 1 < s->count; i++) {
        const struct vec2 way = vec2_sub(s->at[i + 1], s->at[i]);
        const double far = vec2_length(way);
        if (!isfinite(far))
            continue;
        for (double at = 0.0; at <= far; at += side / 2.0)
            take(k,
                 vec2_add(s->at[i], vec2_scale(far > 0.0 ? at / far : 0, way)),
                 (struct vec2){ 0, 0 }, by);
    }
}

void keep_box(struct keep *k, struct vec2 at, struct vec2 half)
{
    take(k, at, half, KEEP_ALL);
}

void keep_gaps(struct keep *k, const struct figure_raster *r)
{
    for (size_t j = 0; j < k->ny; j++)
        for (size_t i = 0; i < k->nx; i++) {
            const size_t x = (2 * i + 1) * r->nx / (2 * k->nx);
            const size_t y = (2 * j + 1) * r->ny / (2 * k->ny);
            if (!isfinite(r->value[y * r->nx + x]))
                k->taken[j * k->nx + i] = KEEP_ALL;
        }
}

bool keep_is_free(const struct keep *k, struct vec2 at, struct vec2 half,
                  uint8_t by)
{
    const struct vec2 lo = vec2_sub(at, half), hi = vec2_add(at, half);
    size_t x[2], y[2];

    if (!(lo.x >= 0.0 && lo.y >= 0.0 && hi.x <= side * (double) k->nx &&
          hi.y <= side * (double) k->ny))
        return false;
    cells_of(lo.x, hi.x, k->nx, &x[0], &x[1]);
    cells_of(lo.y, hi.y, k->ny, &y[0], &y[1]);
    for (size_t j = y[0]; j < y[1]; j++)
        for (size_t i = x[0]; i < x[1]; i++)
            if (k->taken[j * k->nx + i] != 0 && k->taken[j * k->nx + i] != by)
                return false;
    return true;
}

void keep_free(struct keep *k)
{
    free(k->taken);
    k->taken = NULL;
}
