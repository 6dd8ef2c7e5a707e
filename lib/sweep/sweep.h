/*
 * sweep.h -- the numbers of a scene over one key, or over a grid of two, and,
 * with a side file, its maps.
 *
 *     struct sweep s;
 *     sweep_run(&s, &scene, &(struct sweep_options){ 0 }, NULL, &fault);
 *     const int up = sweep_find(&s, "ln_v_plus");
 *     for (size_t i = 0; i < s.points; i++)
 *         ... s.axis[0].value[i], sweep_quantity(&s, up, i) ...
 *     sweep_free(&s);
 *
 * Every point is a study of its own, as `knees --set KEY=VALUE` makes it: the
 * same bits, at any number of threads.  Points of a grid are numbered with the
 * second key running fastest: point i * axis[1].count + j.
 *
 * What flows where:
 *
 *     scene, x -> sweep_point -+-> sweep_column -> rows   (memory, side file)
 *                              +-> sweep_layer  -> blocks (side file only)
 *
 * so that memory grows with the numbers of the points, but not with their maps.
 */
#pragma once

#include "monitor.h"
#include "scene.h"
#include "sweep_column.h"
#include "sweep_journal.h"
#include "sweep_key.h"
#include "sweep_layer.h"
#include "sweep_options.h"
#include "sweep_reason.h"
#include "sweep_rows.h"

struct sweep_axis {
    struct sweep_key key; /* "slope.alpha", "rad", "slope angle" */
    const char *name;     /* last word of its path: "alpha"; of two keys with
                             the same, the path */
    double *value;        /* owned; ascending */
    size_t count;
    bool is_log; /* points were asked for, and are drawn, on a log scale */
};

struct sweep {
    const struct scene *scene; /* borrowed */
    struct sweep_axis axis[SCENE_AXES];
    size_t axes;   /* 1 or 2 */
    size_t points; /* product of the counts */

    struct sweep_dims dims;       /* owned; along what, beside the keys */
    struct sweep_columns columns; /* owned; what there is at a point */
    struct sweep_reasons reasons; /* owned; why a number is missing */
    struct sweep_rows rows;       /* owned; read it by the functions below */
    struct sweep_layers layers;   /* owned; none without a side file */
    struct sweep_journal journal; /* owned; open while there are layers */

    size_t taken;   /* points that an earlier, interrupted run had left */
    size_t missing; /* points that are of other shares: then the rows are not
                       to be read, those that are ours are in the side file */
    size_t failed;  /* points at which the computation failed (reasons) */
    bool replaced;  /* a side file was left, not asked for, and replaced */
    bool unrefined; /* refinement met its bounds before its tolerance */
};

/* Runs scene->sweep, which must have an axis, with all threads of OpenMP.
 *
 * A point at which the computation fails has that as the reason of all its
 * numbers.  With a journal, each point is appended to it when computed, with
 * its layers, which without one are not computed; sweep_forget removes it, once
 * what it holds is written elsewhere.
 *
 * STATUS_STOPPED by the monitor: the journal stays.  STATUS_BAD_SCENE: the
 * journal to resume belongs to another scene or version.  STATUS_IO: it cannot
 * be written, or another run is using it.  STATUS_NO_MEMORY.  On error *s is
 * empty and *why is one line. */
MUST_CHECK enum status sweep_run(struct sweep *s, const struct scene *scene,
                                 const struct sweep_options *options,
                                 const struct monitor *monitor,
                                 struct fault *why);

/* A second call is harmless. */
void sweep_free(struct sweep *s);

/* Removes the side file of a finished sweep; a missing one is harmless. */
void sweep_forget(const char *journal);

/* The column of that name (sweep_column.h); -1 if there is none. */
int sweep_find(const struct sweep *s, const char *name);

/* A number of a point, the first of a column with more; missing ones carry
 * their reason (owned by s). */
struct quantity sweep_quantity(const struct sweep *s, int column, size_t point);

/* A code of a point, for columns with words, or that of the reason; -1: none.
 */
int sweep_code(const struct sweep *s, int column, size_t point);

/* The same of each entry of a column, whose last dimension runs fastest. */
struct quantity sweep_entry(const struct sweep *s, int column, size_t point,
                            size_t entry);
int sweep_entry_code(const struct sweep *s, int column, size_t point,
                     size_t entry);

/* All of layer number k at a point: doubles or int8_t, row by row.  STATUS_IO
 * with one line in *why where the side file cannot be read. */
MUST_CHECK enum status sweep_read(const struct sweep *s, size_t k, size_t point,
                                  void *out, struct fault *why);
