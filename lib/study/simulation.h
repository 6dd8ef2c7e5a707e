/*
 * simulation.h -- the runs (transient.h) from all starts of a scene.
 *
 *     struct simulation s;
 *     simulation_run(&s, &scene, NULL, &fault);
 *     ... read s.run[0 .. s.runs - 1] ...
 *     simulation_free(&s);
 */
#pragma once

#include "result.h"
#include "study.h"
#include "transient.h"

/* Points of a table where the scene does not say. */
enum { SIMULATION_SAMPLES = 201 };

struct simulation {
    struct scene scene;   /* borrowed members; asks for critical numbers only */
    struct study study;   /* owned */
    struct labels labels; /* owned */
    struct transient *run; /* owned; one for each start of the scene */
    size_t runs;
};

/* In parallel; the same at any number of threads.  The scene must outlive s,
 * which must not move.  On error *s is empty and *why says what failed; errors
 * as study_run, and STATUS_BAD_SCENE where there is no start or one lies
 * outside the domain. */
MUST_CHECK enum status simulation_run(struct simulation *s,
                                      const struct scene *scene,
                                      const struct monitor *monitor,
                                      struct fault *why);

/* What a simulation computed: of each run its curve (a few points a step), the
 * tables that the scene asks for (both where it asks for neither), its numbers,
 * events and phases.  In results.run a struct simulation. */
extern const struct result *const simulation_tables[];

/* A second call is harmless. */
void simulation_free(struct simulation *s);
