/*
 * workprec.h -- error against run time, in the manner of Hairer, Norsett &
 * Wanner (Solving ODEs I, 1993, II.10): every method, ours and others', on
 * every quantity of a task, over a ladder of tolerances.
 *
 *     struct workprec w;
 *     workprec_run(&w, &scene, quick, monitor, &fault);
 *     ... w.run[0 .. w.runs - 1], w.fastest[0 .. w.ranks - 1] ...
 *     workprec_free(&w);
 */
#pragma once

#include "workprec_plane.h"
#include "workprec_rank.h"
#include "workprec_task.h"

#include "result.h"

/* Where times were measured. */
enum { WORKPREC_TEXT = 160 };

struct workprec_environment {
    const char *cpu, *system; /* into the texts below: must not move */
    const char *compiler, *flags;
    const char *gsl, *sundials;
    double clock_overhead; /* s */
    char cpu_text[WORKPREC_TEXT], system_text[WORKPREC_TEXT];
};

struct workprec {
    struct scene scene;          /* borrowed members */
    struct study study;          /* owned: the steady states */
    struct workprec_plane plane; /* owned: of a system of formulas instead */
    struct workprec_task task;
    struct workprec_run *run; /* owned; by quantity, method, tolerance */
    size_t runs;
    struct workprec_fastest *fastest; /* owned; by quantity, accuracy */
    size_t ranks;
    struct workprec_environment environment;
};

/* `quick`: four tolerances, few repeats, in some seconds.  Times are of one
 * thread; the caller sees to it that OpenMP has one.  A quantity that does not
 * exist has no runs: see task.reason.  w must not move, and the scene must
 * outlive it.  Errors as study_run; *w is then empty. */
MUST_CHECK enum status workprec_run(struct workprec *w,
                                    const struct scene *scene, bool quick,
                                    const struct monitor *monitor,
                                    struct fault *why);

/* What a race says.  In results.run a struct workprec. */
extern const struct result *const workprec_tables[];

/* A second call is harmless. */
void workprec_free(struct workprec *w);
