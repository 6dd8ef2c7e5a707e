#include "region.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- bands --------------------------------------------------------------- */

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *) a, y = *(const double *) b;
    return (x > y) - (x < y);
}

static size_t collect_ends(const struct separatrix *s, double end[])
{
    size_t n = 0;

    end[n++] = -HUGE_VAL;
    for (size_t i = 0; i < s->count; i++) {
        if (isfinite(s->strand[i].lo))
            end[n++] = s->strand[i].lo;
        if (isfinite(s->strand[i].hi))
            end[n++] = s->strand[i].hi;
    }
    for (size_t i = 0; i < s->flats; i++)
        end[n++] = s->flat[i].w;
    qsort(end, n, sizeof *end, ascending);
    return n;
}

static size_t strands_in(const struct separatrix *s, const struct band *band)
{
    size_t n = 0;

    for (size_t i = 0; i < s->count; i++)
        n += s->strand[i].lo <= band->lo && s->strand[i].hi >= band->hi;
    return n;
}

static enum status find_bands(struct regions *r)
{
    const struct separatrix *s = r->separatrix;
    const size_t most = 2 * s->count + s->flats + 1;
    double *end = malloc(most * sizeof *end);

    r->band = calloc(most, sizeof *r->band);
    if (end == NULL || r->band == NULL) {
        free(end);
        return STATUS_NO_MEMORY;
    }
    const size_t n = collect_ends(s, end);
    for (size_t i = 0; i < n; i++) {
        struct band band = { end[i], i + 1 < n ? end[i + 1] : HUGE_VAL, 0, 0 };
        if (!(band.lo < band.hi))
            continue;
        band.strands = strands_in(s, &band);
        band.first = r->count;
        r->count += band.strands + 1;
        r->most = band.strands > r->most ? band.strands : r->most;
        r->band[r->bands++] = band;
    }
    free(end);
    return STATUS_OK;
}

enum status regions_init(struct regions *r, const struct separatrix *separatrix)
{
    *r = (struct regions){ .separatrix = separatrix };
    if (separatrix->along != SEPARATRIX_Y)
        return STATUS_BAD_ARGUMENT;
    enum status s = find_bands(r);
    if (s == STATUS_OK) {
        r->region = calloc(r->count, sizeof *r->region);
        s = r->region ? STATUS_OK : STATUS_NO_MEMORY;
    }
    for (size_t i = 0; s == STATUS_OK && i < r->count; i++)
        r->region[i].label = REGION_UNLABELLED;
    if (s != STATUS_OK)
        regions_free(r);
    return s;
}

const struct band *regions_band(const struct regions *r, double y)
{
    size_t i = 0;

    while (i + 1 < r->bands && !(y < r->band[i].hi))
        i++;
    return &r->band[i];
}

size_t regions_at(const struct regions *r, struct vec2 z, struct crossing c[])
{
    const struct band *band = regions_band(r, z.y);
    const size_t n = separatrix_row(r->separatrix, z.y, c);
    size_t k = 0;

    while (k < n && z.x >= c[k].at)
        k++;
    return band->first + k;
}

/* ---- areas --------------------------------------------------------------- */

/* The area left of strand number k of a band, from the box's left edge; k = 0
 * is that edge itself, k > strands the right one. */
static struct area left_of(const struct regions *r, const struct band *band,
                           size_t k, struct box part, struct measure m,
                           const struct crossing c[])
{
    const double rows = measure_between(&m, 1, part.lo.y, part.hi.y);
    struct area a = { 0.0, 0.0 };

    if (k > band->strands)
        a.value = rows * measure_between(&m, 0, part.lo.x, part.hi.x);
    else if (k > 0)
        a.value = separatrix_area(r->separatrix, c[k - 1].strand, part.lo.y,
                                  part.hi.y, part.lo.x, part.hi.x, m, &a.error);
    return a;
}

/* Each strand is integrated once, for the regions on both its sides. */
void regions_areas(const struct regions *r, struct box w, struct measure m,
                   struct crossing c[], struct area out[])
{
    memset(out, 0, r->count * sizeof *out);
    for (size_t i = 0; i < r->bands; i++) {
        const struct band *band = &r->band[i];
        struct box part = w;
        part.lo.y = fmax(w.lo.y, band->lo);
        part.hi.y = fmin(w.hi.y, band->hi);
        if (!(part.lo.y < part.hi.y))
            continue;
        const double middle = 0.5 * (part.lo.y + part.hi.y);
        if (separatrix_row(r->separatrix, middle, c) != band->strands)
            continue; /* as thin as rounding: no row lies in it */
        struct area left = { 0.0, 0.0 };
        for (size_t k = 0; k <= band->strands; k++) {
            const struct area next = left_of(r, band, k + 1, part, m, c);
            out[band->first + k] = (struct area){ next.value - left.value,
                                                  next.error + left.error };
            left = next;
        }
    }
}

void regions_free(struct regions *r)
{
    free(r->band);
    free(r->region);
    *r = (struct regions){ .separatrix = NULL };
}
