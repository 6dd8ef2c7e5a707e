/*
 * simulation.h -- the runs (transient.h) from all starts of a scene.
 *
 *     struct simulation s;
 *     simulation_run(&s, &scene, NULL, &fault);
 *     ... read s.run[0 .. s.runs - 1] ...
 *     simulation_free(&s);
 */
#ifndef STUDY_SIMULATION_H
#define STUDY_SIMULATION_H

#include "transient.h"

struct simulation {
    struct scene scene; /* borrowed members; asks for critical numbers only */
    struct study study; /* owned */
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

/* A second call is harmless. */
void simulation_free(struct simulation *s);

#endif
