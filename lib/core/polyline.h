/* polyline.h -- a growable list of points of the plane. */
#pragma once

#include <stddef.h>

#include "plane.h"
#include "status.h"

struct polyline {
    struct vec2 *at; /* owned; at[0 .. count-1] */
    size_t count, room;
};

#define POLYLINE_EMPTY ((struct polyline){ NULL, 0, 0 })

/* On STATUS_NO_MEMORY the list is unchanged. */
MUST_CHECK enum status polyline_push(struct polyline *p, struct vec2 z);

/* The last point first. */
void polyline_reverse(struct polyline *p);

/* Leaves *p equal to POLYLINE_EMPTY, so a second call is harmless. */
void polyline_free(struct polyline *p);
