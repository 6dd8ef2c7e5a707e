/* room.h -- arrays that grow while they are filled. */
#pragma once

#include <stddef.h>

#include "status.h"

/* Room for at least `need` items in an array with room for `room`, both
 * variables; as it grows by halves and more, n items are moved O(n) times.
 *
 *     s = ROOM_FOR(list->at, list->room, list->count + 1);
 *     if (s == STATUS_OK)
 *         list->at[list->count++] = item;
 *
 * STATUS_NO_MEMORY leaves both as they were. */
#define ROOM_FOR(at, room, need) room_for(&(at), &(room), need, sizeof *(at))

/* The same of items of `size` bytes; at: the address of a pointer to them. */
MUST_CHECK enum status room_for(void *at, size_t *room, size_t need,
                                size_t size);
