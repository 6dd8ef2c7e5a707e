#include "sweep_rows.h"

#include <stdlib.h>
#include <string.h>

#include "room.h"

struct sweep_rows sweep_rows_of(size_t entries, bool conditioning)
{
    const size_t reals = conditioning ? 3 : 2;
    const size_t codes = (entries + sizeof(double) - 1) / sizeof(double);

    return (struct sweep_rows){ .entries = entries,
                                .reals = reals,
                                .width = 3 + reals * entries + codes };
}

enum status sweep_rows_add(struct sweep_rows *r, size_t count)
{
    const size_t size = r->width * sizeof *r->at;

    if (room_for(&r->at, &r->room, r->count + count, size))
        return STATUS_NO_MEMORY;
    memset(r->at + r->count * r->width, 0, count * size);
    r->count += count;
    return STATUS_OK;
}

static int compare(const void *a, const void *b)
{
    const double *x = a, *y = b;
    const int k = x[0] == y[0];

    return (x[k] > y[k]) - (x[k] < y[k]);
}

void sweep_rows_sort(struct sweep_rows *r)
{
    if (r->count > 1)
        qsort(r->at, r->count, r->width * sizeof *r->at, compare);
}

size_t sweep_rows_find(const struct sweep_rows *r, const double x[2])
{
    const double *row = NULL;

    if (r->count > 0)
        row = bsearch(x, r->at, r->count, r->width * sizeof *r->at, compare);
    return row ? (size_t) (row - r->at) / r->width : r->count;
}

void sweep_rows_free(struct sweep_rows *r)
{
    free(r->at);
    r->at = NULL;
    r->count = r->room = 0;
}
