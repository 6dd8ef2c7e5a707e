/* pen.h -- the layers: a block of data and a line of the plot command for each.
 */
#pragma once

#include <stdio.h>

#include "layout.h"

struct pen {
    FILE *script, *data;       /* borrowed */
    const struct layout *page; /* borrowed */
    size_t blocks;             /* of data, so far */
    bool cased;                /* lines stand out from what is below them */
};

/* Cells along a side of the image of a raster with so many, which repeats each
 * where there are few; at least 1 cell. */
size_t pen_cells(size_t cells);

/* Writes the whole plot command, without the line's end. */
MUST_CHECK enum status pen_draw(struct pen *pen, const struct figure *f);
