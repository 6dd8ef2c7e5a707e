/*
 * sweep_layer.h -- what a sweep keeps of each point as an array over the window
 * (or over chi's own axes): fates, margins and fields of the cells of the basin
 * map, the direction field, chi(v).  Too large for memory, they are in the side
 * file of the sweep until they are read.
 *
 * Names are those of /basin, /field_arrows and /chi after basin_, arrow_ and
 * chi_: basin_label, basin_slip, basin_slip_error, arrow_direction_v,
 * chi_ln_chi.  A cell's number that does not exist is NaN; basin_exit_reason,
 * the fate of the cell's own orbit, says why (cells.h).  At points that failed
 * all are NaN or -1.
 */
#pragma once

#include "result.h"
#include "sweep_dim.h"
#include "sweep_point.h"

struct sweep_layer {
    char name[64];
    char text[160]; /* long_name */
    const char *unit;
    const char *const *codes; /* words of a code; NULL: a real number */
    const struct result *of;
    enum sweep_dim dim[2]; /* rows, columns */
    size_t member;         /* offset in a record */
    size_t offset;         /* in the block of a point, in bytes */
    size_t rows, columns;
};

struct sweep_layers {
    struct sweep_layer *at; /* owned */
    size_t count, room;
    size_t of_study; /* so many, the others are of sweep_results.h */
    size_t size;     /* bytes of a point's block; a multiple of 8 */
};

/* Those of the scene's products, none of a system; d: their dimensions.
 * STATUS_NO_MEMORY leaves *l empty. */
MUST_CHECK enum status sweep_layers_init(struct sweep_layers *l,
                                         const struct scene *scene,
                                         const struct sweep_dims *d);

/* A second call is harmless. */
void sweep_layers_free(struct sweep_layers *l);

/* The bytes of a layer in a block. */
size_t sweep_layer_size(const struct sweep_layer *layer);

/* The block of a point: doubles and int8_t as in the file, row by row.
 * STATUS_NO_MEMORY, STATUS_STOPPED; the block is then undefined. */
MUST_CHECK enum status sweep_layers_fill(const struct sweep_layers *l,
                                         const struct sweep_point *p,
                                         const struct monitor *monitor,
                                         char *block);
