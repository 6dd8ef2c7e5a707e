/*
 * study.h -- give it a scene, and it returns the steady states, the saddle's
 * manifolds, the portrait and the critical numbers the scene asks for.
 *
 *     struct study s;
 *     study_run(&s, &scene, NULL, &fault);
 *     ... read s ...
 *     study_free(&s);
 *
 * Only the stages in plan_stages(scene->products) run; what belongs to the
 * others stays empty.  Coordinates as in block.h; curves are offsets from
 * system.origin.
 */
#pragma once

#include "basin_map.h"
#include "basin_proof.h"
#include "diagram.h"
#include "estimate_numbers.h"
#include "fields.h"
#include "grow.h"
#include "numbers.h"
#include "orbit.h"
#include "plan.h"
#include "portrait.h"
#include "records.h"
#include "result.h"
#include "sensitivity.h"
#include "slider.h"
#include "study_proof.h"
#include "taylor_series.h"

/* The branches of a manifold: v > v_sp, v < v_sp. */
enum side { SIDE_UPPER, SIDE_LOWER, SIDES };

/* What a stage took. */
struct stage_cost {
    bool ran;
    size_t field_evaluations; /* a jet counts as one a coefficient */
    double seconds;
};

/* Everything that was found: what the stages that ran have filled. */
struct study {
    const struct scene *scene; /* borrowed */
    unsigned stages;           /* bits of enum stage */
    bool saddle_alone;         /* PLAN_SADDLE */
    bool no_deficit;           /* PLAN_NO_DEFICIT */

    struct slider slider; /* a study must not move */
    struct saddle_numbers saddle_numbers;
    struct fold_numbers folds;

    struct branch stable[SIDES];  /* owned */
    struct orbit unstable[SIDES]; /* owned; start at the series' end */
    struct portrait portrait;     /* owned; trajectories: the spread ones */
    struct result_keep kept;      /* owned; what tables say how to make */
    struct stage_cost cost[STAGES];

    /* Of a saddle alone nobody reads or clears what follows. */
    struct trajectories chosen; /* owned; from the scene's own starts */
    struct taylor_series taylor;
    struct estimate_numbers estimates;
    struct sensitivities sensitivities;
    struct basin_map basins;
    struct fields fields;
    struct diagrams diagrams;       /* owned */
    struct study_proof proof;       /* owned */
    struct basin_proof label_proof; /* owned; of basins */
};

/* STATUS_OK also where something does not exist: the reason is in the number.
 * Without a slope, which some products do not take, there are no steady states
 * either.  STATUS_BAD_SCENE: no slope, and a product takes one.  On error *s is
 * empty and *why says what failed. */
MUST_CHECK enum status study_run(struct study *s, const struct scene *scene,
                                 const struct monitor *monitor,
                                 struct fault *why);

/* One of several studies. */
enum { STUDY_JOBS = GROW_JOBS };
struct study_job {
    struct study *study;       /* borrowed */
    const struct scene *scene; /* borrowed */
    enum status status;        /* as of study_run, when it is done */
    struct fault why;
};

/* n <= STUDY_JOBS studies side by side, each with the bits that it has alone:
 * these stages (bits, closed under what they need, PLAN_SADDLE: plan.h) in
 * place of those that a scene's products ask for. */
void study_run_jobs(struct study_job job[], size_t n, unsigned stages,
                    const struct monitor *monitor);

/* A second call is harmless. */
void study_free(struct study *s);

/* Sum over the stages. */
struct stage_cost study_cost(const struct study *s);
