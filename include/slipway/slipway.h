/*
 * slipway.h -- a block on a slope under rate-and-state friction: its steady
 * states, the saddle's manifolds, the basins they divide and the critical
 * numbers they imply.  For C and C++.
 *
 *     slipway_scene *scene = NULL;
 *     slipway_study *study = NULL;
 *     slipway_number v;
 *     slipway_fault why;
 *     if (slipway_scene_new(&scene) ||
 *         slipway_scene_set(scene, "law.preset", "dieterich_gen") ||
 *         slipway_scene_set_number(scene, "slope.alpha", 0.34) ||
 *         slipway_study_run(scene, NULL, &study, &why))
 *         ... why.text is one line ...
 *     slipway_study_number(study, "v_plus", &v);
 *     slipway_study_free(study);
 *     slipway_scene_free(scene);
 *
 * Units: v in V_star, psi as the law's, time in L/V_star, slip in L, angles in
 * radians, rates per L/V_star (Putelat & Dawes 2015, (17)).
 * Every function that can fail returns a slipway_status; on failure its outputs
 * are untouched, but for the fault.  A fault may be NULL.  What a function
 * hands out in a pointer is the caller's, to be given to the `free` of its
 * name, which takes NULL.  There are no globals: any number of threads may
 * work, each with handles of its own; a study, a push and a sweep may be read
 * by many at once. A system of one's own: slipway_planar.h.
 */
#ifndef SLIPWAY_SLIPWAY_H
#define SLIPWAY_SLIPWAY_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum slipway_status {
    SLIPWAY_OK,
    SLIPWAY_NO_MEMORY,
    SLIPWAY_BAD_ARGUMENT, /* outside its documented range, or an unknown name */
    SLIPWAY_BAD_SCENE,    /* the fault names file, line, key and value */
    SLIPWAY_NUMERICAL,    /* an iteration stopped before its tolerance */
    SLIPWAY_STOPPED,      /* by the monitor */
    SLIPWAY_IO            /* a file cannot be read */
} slipway_status;

/* One line for a person. */
typedef struct slipway_fault {
    char text[512];
} slipway_fault;

/* A computed number: reason is NULL and |truth - value| <= error, in the
 * number's own unit; or it does not exist, both are NaN, and the reason is a
 * plain sentence, valid as long as the handle it came from.  spread: of a study
 * or push with inputs "X +- S" the standard deviation that they make of it, to
 * first order; infinite where it cannot be told; else NaN. */
typedef struct slipway_number {
    double value, error;
    const char *reason;
    double spread;
} slipway_number;

/* What a number or a key is called, its unit ("rad", "1"), of what it is a
 * multiple ("V_star", "L"; NULL: of nothing) and its meaning; valid as long as
 * the handle it came from.  All NULL: there is none. */
typedef struct slipway_label {
    const char *name, *unit, *scale, *text;
} slipway_label;

/* Told now and then during long work; `total` is 0 where nobody knows.  A
 * non-zero answer ends it with SLIPWAY_STOPPED.  May be NULL. */
typedef struct slipway_monitor {
    int (*tell)(void *ctx, const char *stage, uint64_t done, uint64_t total);
    void *ctx;
} slipway_monitor;

/* "0.1.0"; static. */
const char *slipway_version(void);

/* What a status means; static. */
const char *slipway_status_text(slipway_status status);

/* ---- scenes: what is asked for ------------------------------------------- */

typedef struct slipway_scene slipway_scene;

/* An empty scene: the default material, no law, no slope, no products (then
 * those of `slipway knees`). */
slipway_status slipway_scene_new(slipway_scene **out);

/* A scene file (YAML; `slipway help --as scene` lists its keys). */
slipway_status slipway_scene_read(const char *path, slipway_scene **out,
                                  slipway_fault *why);

/* Sets a key, such as "material.a", "law.preset", "products" ("[knees]"), as
 * `--set KEY=VALUE` does; later ones win.  Keys and values are checked when the
 * scene is run. */
slipway_status slipway_scene_set(slipway_scene *scene, const char *key,
                                 const char *value);
slipway_status slipway_scene_set_number(slipway_scene *scene, const char *key,
                                        double value);

void slipway_scene_free(slipway_scene *scene);

/* ---- studies: what came of it -------------------------------------------- */

typedef struct slipway_study slipway_study;

/* Computes what the scene's products ask for, and nothing else.  The scene may
 * be changed or freed afterwards. */
slipway_status slipway_study_run(const slipway_scene *scene,
                                 const slipway_monitor *monitor,
                                 slipway_study **out, slipway_fault *why);

void slipway_study_free(slipway_study *study);

/* A number by its name in JSON, with underscores for dots: "v_plus",
 * "saddle_v", "folds_alpha_cM", "equilibria_0_lambda_plus", ... ; with the key
 * "accuracy.proved" set to "true" "v_plus_lo" and "v_plus_hi", "saddle_v_lo",
 * ..., between which the number is proved to lie, exact or with the reason why
 * there are none.  BAD_ARGUMENT: the products give none of that name. */
slipway_status slipway_study_number(const slipway_study *study,
                                    const char *name, slipway_number *out);

/* Of number k, k = 0, 1, ...; none behind the last. */
slipway_label slipway_study_label(const slipway_study *study, size_t k);

typedef enum slipway_type {
    SLIPWAY_SADDLE,
    SLIPWAY_STABLE_NODE,
    SLIPWAY_SADDLE_NODE, /* exactly at a fold */
    SLIPWAY_UNSTABLE_NODE,
    SLIPWAY_FOCUS
} slipway_type;

typedef struct slipway_equilibrium {
    slipway_type type;
    slipway_number v, psi, mu, lambda_minus, lambda_plus;
} slipway_equilibrium;

/* Their number, ascending in v; the first `room` of them into out[]. */
size_t slipway_study_equilibria(const slipway_study *study,
                                slipway_equilibrium out[], size_t room);

/* A state and what the window shows of it; on a logarithmic axis where the
 * chart has its logarithm. */
typedef struct slipway_axis {
    const char *name;
    int is_log;
    double range[2];
} slipway_axis;

/* Of v (0) and psi (1), as long as the study. */
slipway_axis slipway_study_axis(const slipway_study *study, int axis);

/* Product "manifolds". */
typedef enum slipway_branch {
    SLIPWAY_STABLE_UPPER, /* v > v_sp */
    SLIPWAY_STABLE_LOWER,
    SLIPWAY_UNSTABLE_UPPER,
    SLIPWAY_UNSTABLE_LOWER
} slipway_branch;

/* In the chart (ln v, ln psi), or (ln v, psi) where psi is a logarithm: `arc`,
 * the length from the saddle; `slope` of the curve, NaN where it is vertical,
 * with which cubic Hermite interpolation is as good as the points; `error`, a
 * bound on the distance to the exact curve.  Along it, from the first point
 * on: slip, time, frictional work per unit normal force; `excess`, of slip
 * over v_sp, from the saddle. */
typedef struct slipway_point {
    double arc, v, psi, slope, slip, time, work, excess, error;
} slipway_point;

/* The points of a branch from the saddle outward, lent for as long as the
 * study is there; NULL and 0: it was not asked for or does not exist. */
const slipway_point *slipway_study_branch(const slipway_study *study,
                                          slipway_branch which, size_t *count);

/* ---- basins: products "basins", "margin", "slip", "time", ... -------------
 */

/* What becomes of a state. */
typedef enum slipway_fate {
    SLIPWAY_CREEP,           /* to the creep node */
    SLIPWAY_SLIDING,         /* to the sliding node */
    SLIPWAY_REST_FINITE,     /* v = 0 at a finite time */
    SLIPWAY_REST_ASYMPTOTIC, /* v -> 0 as t -> inf */
    SLIPWAY_RUNAWAY,         /* v -> inf */
    SLIPWAY_UNDECIDED        /* nearer to a boundary than its error */
} slipway_fate;

/* Columns (v) and rows (psi) of the grid; 0, 0 without the product. */
void slipway_basin_size(const slipway_study *study, size_t *columns,
                        size_t *rows);

/* Cell centres v[columns], psi[rows]. */
slipway_status slipway_basin_axes(const slipway_study *study, double v[],
                                  double psi[]);

/* Fates (slipway_fate) of rows first .. first + rows - 1 into
 * label[rows * columns], row by row; and the factors on v, and on psi (a shift
 * where psi is a logarithm), to the nearest other fate, as their logarithms;
 * infinite where there is none. */
slipway_status slipway_basin_labels(const slipway_study *study, size_t first,
                                    size_t rows, int8_t label[]);
slipway_status slipway_basin_margins(const slipway_study *study, size_t first,
                                     size_t rows, double v[], double psi[]);

/* Slip, time and mean friction to arrest, from every state of the rows. `which`
 * is the field's name as in the file: "slip", "time", "mu_mean", "v_peak",
 * "mu_peak"; NaN where there is none.  BAD_ARGUMENT: not among the products. */
slipway_status slipway_basin_field(const slipway_study *study,
                                   const char *which, size_t first, size_t rows,
                                   double value[], double error[]);

/* ---- pushes: single states ----------------------------------------------- */

typedef struct slipway_push slipway_push;

typedef struct slipway_state {
    double v, psi;
} slipway_state;

/* Kicks: the factors on v, and on psi (a shift where psi is a logarithm), that
 * lead just to the nearest boundary of another fate. */
typedef struct slipway_answer {
    slipway_fate fate;
    slipway_number slip, time, mu_mean, v_kick, psi_kick;
} slipway_answer;

/* The plane of the scene's law, material and slope, ready for any states. */
slipway_status slipway_push_open(const slipway_scene *scene,
                                 const slipway_monitor *monitor,
                                 slipway_push **out, slipway_fault *why);

/* answer[i] of state[i].  BAD_ARGUMENT: a state outside 1e-300 .. 1e300 (its
 * number is in the fault). */
slipway_status slipway_push_find(const slipway_push *push,
                                 const slipway_state state[], size_t count,
                                 const slipway_monitor *monitor,
                                 slipway_answer answer[], slipway_fault *why);

void slipway_push_free(slipway_push *push);

/* ---- sweeps: the same over one key, or a grid of two ----------------------
 */

typedef struct slipway_sweep slipway_sweep;

/* Runs the scene's `sweep` section with all threads of OpenMP; without products
 * those of `slipway knees`. */
slipway_status slipway_sweep_run(const slipway_scene *scene,
                                 const slipway_monitor *monitor,
                                 slipway_sweep **out, slipway_fault *why);

/* The values of key `axis` (0 or 1), lent; *count: how many; NULL and 0: no
 * such axis.  *key (may be NULL): its label, "slope.alpha". */
const double *slipway_sweep_axis(const slipway_sweep *sweep, size_t axis,
                                 size_t *count, slipway_label *key);

/* Of number k, as of a study. */
slipway_label slipway_sweep_label(const slipway_sweep *sweep, size_t k);

/* A number at all points: out[i] at value i of the key, of two keys
 * out[i * n + j] at i of the first and j of the n of the second.  BAD_ARGUMENT:
 * no such number, or points other than `count`. */
slipway_status slipway_sweep_numbers(const slipway_sweep *sweep,
                                     const char *name, slipway_number out[],
                                     size_t count);

void slipway_sweep_free(slipway_sweep *sweep);

/* ---- batches: a few numbers of very many materials and slopes -------------
 */

typedef struct slipway_batch slipway_batch;

/* What varies, and what is asked for: keys such as "material.a" or
 * "slope.alpha", numbers named as by slipway_study_number, such as "v_plus".
 * Everything else is the scene's, which need not have the keys.  BAD_ARGUMENT:
 * the fault names the key or number that does not exist or is twice there. */
slipway_status slipway_batch_open(const slipway_scene *scene,
                                  const char *const key[], size_t keys,
                                  const char *const name[], size_t names,
                                  slipway_batch **out, slipway_fault *why);

/* One number of all draws, arrays as long as there are draws; any may be NULL.
 * reason: 0 where it exists, else slipway_batch_reason tells it; value and
 * error are NaN there. */
typedef struct slipway_column {
    double *value, *error;
    uint8_t *reason;
} slipway_column;

/* `count` draws: column[k][i] is the value of key k at draw i, in the scene's
 * units; out[n] is number n of `name`.  Values that are not allowed, such as a
 * negative a, are a reason, not an error.  threads: 0 for as many as OpenMP
 * has; the numbers, and the reasons of a first run, are the same at any.
 * BAD_ARGUMENT: threads below 0.  STOPPED by the monitor, NO_MEMORY: the
 * outputs are undefined. */
slipway_status slipway_batch_run(slipway_batch *batch, size_t count,
                                 const double *const column[], int threads,
                                 const slipway_monitor *monitor,
                                 const slipway_column out[],
                                 slipway_fault *why);

/* The sentence behind a reason that some run of the batch gave, valid as long
 * as it; NULL for 0 and for others. */
const char *slipway_batch_reason(const slipway_batch *batch, uint8_t reason);

void slipway_batch_free(slipway_batch *batch);

#ifdef __cplusplus
}
#endif

#endif
