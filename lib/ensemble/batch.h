/*
 * batch.h -- a few numbers of very many scenes that differ in some keys.
 *
 *     struct batch b;
 *     batch_init(&b, &scene, key, keys, name, names, &fault);
 *     batch_run(&b, draws, column, 0, NULL, out);
 *     batch_free(&b);
 *
 * Each draw is a study, as `knees --set KEY=VALUE ...` makes it, with the same
 * bits at any number of threads and in any company: those of `knees`, but that
 * branches of which the ends alone are asked lean (grow.h), and tell them
 * within their bars.  What does not change from draw to draw is set up once:
 * keys and numbers are found, and of the stages only those run that the numbers
 * named need.  Numbers of systems of formulas, and
 * of what else a sweep has by name, such as basin_fraction_log_creep, are those
 * of its points (batch_points.h).
 */
#pragma once

#include "monitor.h"
#include "result_number.h"
#include "scene_vary.h"

struct batch_points;
struct batch_words;
struct sweep_column;

struct batch {
    const struct scene *scene; /* borrowed */
    struct scene_vary *key;    /* owned */
    char **beyond;             /* owned: why a key's value is not allowed */
    size_t keys;
    struct result_number *number; /* owned */
    size_t numbers;
    struct batch_points *points; /* owned; NULL: a study's first stages do */
    const struct sweep_column **column; /* owned; with points by number: whose
                                           it is; NULL: of a study */
    const struct scene_push *push;      /* borrowed */
    size_t pushes;
    struct batch_words *words; /* owned; with pushes of a system */
    unsigned stages;           /* bits of enum stage */
};

/* One number of all draws: any array may be NULL. */
struct batch_column {
    double *value;       /* NaN where there is none */
    double *error;       /* absolute; NaN where there is none */
    const char **reason; /* static, or owned by the batch; NULL: it exists */
};

/* The fates of one state in all draws; of a system whereto it goes: then fate
 * is 0, and the reason the name of the attractor, and no array may be NULL. */
struct batch_fates {
    int8_t *fate;        /* enum fate; -1: the draw has none */
    const char **reason; /* why a fate is undecided or is none; else NULL */
    double *margin;      /* labels_margin of the state, infinite without one */
};

/* Numbers of that scene, by name (result_number.h, sweep_column.h), over those
 * keys, such as "material.a"; name NULL: all that the scene's products give,
 * and without products those of the saddle's stable manifold; of a system those
 * that its own study has.  Both the arrays and the scene's own values of the
 * keys may go afterwards; the scene and the keys' texts must stay.
 * STATUS_BAD_ARGUMENT: *why names the key or the number that does not exist, is
 * twice there or excludes another; STATUS_BAD_SCENE: no slope where one is
 * needed, or no numbers; STATUS_NO_MEMORY.  On error *b is empty. */
MUST_CHECK enum status batch_init(struct batch *b, const struct scene *scene,
                                  const char *const key[], size_t keys,
                                  const char *const name[], size_t names,
                                  struct fault *why);

/* From now on the fates of these states, too, in the units of each draw's own
 * material; they must stay.  STATUS_NO_MEMORY. */
MUST_CHECK enum status batch_push(struct batch *b,
                                  const struct scene_push push[],
                                  size_t pushes);

/* `count` draws, column[k][i] being the value of key k at draw i, into
 * out[numbers] and fates[pushes] (NULL: without pushes).  A draw whose values
 * are not allowed, or whose computation fails, has that as the reason of all
 * its numbers.  threads: 0 for those of OpenMP.  STATUS_STOPPED,
 * STATUS_NO_MEMORY; the outputs are undefined then. */
MUST_CHECK enum status batch_run(const struct batch *b, size_t count,
                                 const double *const column[], int threads,
                                 const struct monitor *monitor,
                                 const struct batch_column out[],
                                 const struct batch_fates fates[]);

/* Whether a number of a law is drawn where none is named: once at a point, read
 * off the folds, the manifold, estimates, power series or shares of basins. */
bool batch_draws(const struct sweep_column *c);

/* A second call is harmless. */
void batch_free(struct batch *b);
