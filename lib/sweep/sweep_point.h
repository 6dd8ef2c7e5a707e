/*
 * sweep_point.h -- all that is computed at a point of a sweep: the study of its
 * scene, and what else the products ask for.
 */
#pragma once

#include "plane_study.h"
#include "release.h"
#include "start_numbers.h"
#include "study.h"

/* A steady state by what it is, wherever it is among them. */
struct kind_numbers {
    struct quantity ln_v, ln_psi; /* psi itself where it is a logarithm */
    struct quantity v, psi, lambda_minus, lambda_plus;
};

enum steady_kind { STEADY_CREEP, STEADY_SADDLE, STEADY_SLIDING, STEADY_KINDS };

struct sweep_point {
    struct scene scene;            /* borrowed members */
    struct study study;            /* owned; of a law */
    struct formula_system *system; /* owned; and of a system of formulas */
    struct plane_study plane;      /* owned */
    struct kind_numbers kind[STEADY_KINDS];
    struct release_row release;  /* where the scene has an experiment */
    struct start_numbers *start; /* owned; one for each start of the scene */
    size_t starts;
    const char *failed; /* static: why there is nothing; NULL */
};

/* The products (bits) of a study at a point of the sweep; `maps`: with those
 * that are arrays over the window. */
unsigned sweep_point_products(const struct scene *scene, bool maps);

/* p->scene is the scene, to be moved, and p->system a copy of its system.
 * STATUS_NO_MEMORY leaves *p empty. */
MUST_CHECK enum status sweep_point_begin(struct sweep_point *p,
                                         const struct scene *scene);

/* Runs p->scene with those products.  A computation that fails is a reason in
 * *p; STATUS_NO_MEMORY, and STATUS_STOPPED by the monitor, are errors and leave
 * *p empty.  *p must not move. */
MUST_CHECK enum status sweep_point_run(struct sweep_point *p, unsigned products,
                                       const struct monitor *monitor);

/* Both, of the scene at x[0 .. axes - 1] of its sweep. */
MUST_CHECK enum status sweep_point_at(struct sweep_point *p,
                                      const struct scene *scene,
                                      const double x[], unsigned products,
                                      const struct monitor *monitor);

/* The same of n <= STUDY_JOBS side by side, at x[k]. */
void sweep_points_at(struct sweep_point p[], const struct scene *scene,
                     const double *const x[], size_t n, unsigned products,
                     const struct monitor *monitor, enum status status[]);

/* p[k].study of scene[k], k < n <= STUDY_JOBS, by these stages and no more, as
 * study_run_jobs; it is empty where status[k] is not STATUS_OK. */
void sweep_points_study(struct sweep_point p[], const struct scene scene[],
                        size_t n, unsigned stages, enum status status[]);

/* A second call is harmless. */
void sweep_point_free(struct sweep_point *p);
