#include "rows.h"

#include <stdlib.h>
#include <string.h>

#include "room.h"

struct rows rows_of(const struct record_type *type)
{
    return (struct rows){ .type = type };
}

void rows_free(struct rows *r)
{
    free(r->at);
    *r = rows_of(r->type);
}

enum status rows_push(struct rows *r, const void *row)
{
    const size_t size = r->type->size;
    const enum status s = room_for(&r->at, &r->room, r->count + 1, size);

    if (s == STATUS_OK)
        memcpy((char *) r->at + r->count++ * size, row, size);
    return s;
}

enum status rows_lend(struct result_view *out, struct rows *r,
                      enum status sampled)
{
    if (sampled != STATUS_OK) {
        rows_free(r);
        return sampled;
    }
    out->owned = r->at;
    return result_lend(out, r->at, r->count);
}
