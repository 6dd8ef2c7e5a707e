/*
 * basin_map.h -- the fate of every cell of the scene's (v, psi) grid, the
 * share of each basin, and how far a cell is from another fate.
 *
 * By default rows are cut by the stable manifold, whose sides have the labels
 * (labels.h); `exact` labels every cell by its own forward orbit (trap.h).  The
 * audit plays one against the other.
 */
#pragma once

#include "basin.h"
#include "labels.h"
#include "margin.h"
#include "scene.h"
#include "trap.h"

/* Of the window, by area in the chart (log) and in v and psi (linear; psi as
 * it is where it is a logarithm). */
struct basin_fraction {
    struct quantity log, linear;
};

struct basin_audit {
    size_t cells, disagreements;
    size_t *wrong; /* owned: row * columns + column of each disagreement */
};

struct basin_map {
    const struct slider *slider; /* borrowed */
    const struct scene *scene;   /* borrowed: window, grid, accuracy */
    size_t columns, rows;        /* v, psi */
    double *v, *psi;             /* owned: cell centres as stored */
    double *x, *y;               /* owned: the same in the chart */
    double *dx, *dy;             /* owned: and as offsets from the saddle */
    bool exact;
    struct labels labels;
    struct basin basin;
    struct trap trap;
    int8_t *followed; /* owned; exact: the label of each cell by its orbit */
    struct basin_fraction fraction[FATES];
    struct basin_audit audit;
};

enum basin_axis { BASIN_V, BASIN_PSI };

/* The centres of n cells along an axis of the scene's window, in the chart and
 * as stored. */
void basin_map_axis(const struct scene *c, enum basin_axis axis, size_t n,
                    double chart[], double stored[]);

/* Prepares the map of s, whose steady states are known; grid, window and
 * `exact` are its scene's.  An exact map is followed here, which fills
 * m->audit: its shares are those of its cells, with bars that reach to those of
 * the separatrix.  STATUS_NO_MEMORY, STATUS_STOPPED, or as labels_init; *m is
 * then empty.  m must not move. */
MUST_CHECK enum status basin_map_init(struct basin_map *m,
                                      const struct slider *s,
                                      const struct scene *c,
                                      const struct monitor *monitor);

/* Labels (enum fate) of rows first .. first + count - 1 into
 * out[count * columns]; in parallel, the same at any number of threads. */
MUST_CHECK enum status basin_map_rows(const struct basin_map *m, size_t first,
                                      size_t count, int8_t out[]);

/* Labels by the separatrix of another grid over the same window, such as a
 * picture's.  STATUS_NO_MEMORY. */
MUST_CHECK enum status basin_map_raster(const struct basin_map *m,
                                        size_t columns, size_t rows,
                                        int8_t out[]);

/* The margins below of such a grid. */
MUST_CHECK enum status basin_map_raster_margins(const struct basin_map *m,
                                                size_t columns, size_t rows,
                                                double v[], double psi[]);

/* ln of the factor on v, and the shift of ln psi (of psi where it is a
 * logarithm), to the nearest other fate along the cell's row and column, for
 * rows first .. first + count - 1; infinite where there is none.
 * STATUS_NO_MEMORY. */
MUST_CHECK enum status basin_map_margins(const struct basin_map *m,
                                         size_t first, size_t count, double v[],
                                         double psi[]);

/* Follows the orbits of `cells` cells, drawn with `seed`: an eighth of them
 * beside a boundary, the others anywhere.  Fills m->audit.  STATUS_NO_MEMORY,
 * STATUS_STOPPED. */
MUST_CHECK enum status basin_map_audit(struct basin_map *m, size_t cells,
                                       uint64_t seed,
                                       const struct monitor *monitor);

/* A second call is harmless. */
void basin_map_free(struct basin_map *m);
