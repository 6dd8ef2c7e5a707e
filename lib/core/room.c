#include "room.h"

#include <stdlib.h>
#include <string.h>

enum { FIRST_ROOM = 64 };

enum status room_for(void *at, size_t *room, size_t need, size_t size)
{
    const size_t more = need < FIRST_ROOM ? FIRST_ROOM : need + need / 2;
    void *items;

    if (need <= *room)
        return STATUS_OK;
    memcpy(&items, at, sizeof items);
    items = realloc(items, more * size);
    if (items == NULL)
        return STATUS_NO_MEMORY;
    memcpy(at, &items, sizeof items);
    *room = more;
    return STATUS_OK;
}
