#include "polyline.h"

#include <stdlib.h>

static enum status grow(struct polyline *p)
{
    const size_t room = p->room ? 2 * p->room : 64;
    struct vec2 *at = realloc(p->at, room * sizeof *at);

    if (at == NULL)
        return STATUS_NO_MEMORY;
    p->at = at;
    p->room = room;
    return STATUS_OK;
}

enum status polyline_push(struct polyline *p, struct vec2 z)
{
    if (p->count == p->room) {
        const enum status s = grow(p);
        if (s != STATUS_OK)
            return s;
    }
    p->at[p->count++] = z;
    return STATUS_OK;
}

void polyline_reverse(struct polyline *p)
{
    for (size_t i = 0; i < p->count / 2; i++) {
        const struct vec2 z = p->at[i];
        p->at[i] = p->at[p->count - 1 - i];
        p->at[p->count - 1 - i] = z;
    }
}

void polyline_free(struct polyline *p)
{
    free(p->at);
    *p = POLYLINE_EMPTY;
}
