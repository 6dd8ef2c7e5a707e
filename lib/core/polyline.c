#include "polyline.h"

#include <stdlib.h>

#include "room.h"

enum status polyline_push(struct polyline *p, struct vec2 z)
{
    const enum status s = ROOM_FOR(p->at, p->room, p->count + 1);

    if (s == STATUS_OK)
        p->at[p->count++] = z;
    return s;
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
