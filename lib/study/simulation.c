#include "simulation.h"

#include <stdio.h>
#include <stdlib.h>

static enum status run_all(struct simulation *s, const struct monitor *monitor)
{
    const struct transient_options o = transient_defaults(&s->scene);
    enum status failed = STATUS_OK;

    if (monitor_tell(monitor, "transients", 0, s->runs))
        return STATUS_STOPPED;
#pragma omp parallel for schedule(dynamic)
    for (size_t i = 0; i < s->runs; i++) {
        const enum status status =
            transient_find(&s->study, s->scene.start[i], &o, NULL, &s->run[i]);
        if (status != STATUS_OK) {
#pragma omp atomic write
            failed = status;
        }
    }
    return failed;
}

static enum status blame(enum status status, struct fault *why)
{
    const bool outside = status == STATUS_BAD_ARGUMENT;

    snprintf(why->text, sizeof why->text, "%s",
             outside ? "a trajectory starts outside [1e-300, 1e300]"
                     : status_text(status));
    return outside ? STATUS_BAD_SCENE : status;
}

enum status simulation_run(struct simulation *s, const struct scene *scene,
                           const struct monitor *monitor, struct fault *why)
{
    *s = (struct simulation){ .scene = *scene };
    if (scene->starts == 0) {
        snprintf(why->text, sizeof why->text,
                 "no start, expected trajectories.starts (or --v and --psi)");
        return STATUS_BAD_SCENE;
    }
    s->scene.products = 1u << PRODUCT_KNEES | 1u << PRODUCT_EQUILIBRIA;
    enum status status = study_run(&s->study, &s->scene, monitor, why);
    if (status != STATUS_OK)
        return status;
    s->run = calloc(scene->starts, sizeof *s->run);
    s->runs = s->run ? scene->starts : 0;
    status = s->run ? run_all(s, monitor) : STATUS_NO_MEMORY;
    if (status == STATUS_OK)
        return STATUS_OK;
    simulation_free(s);
    return blame(status, why);
}

void simulation_free(struct simulation *s)
{
    for (size_t i = 0; i < s->runs; i++)
        transient_free(&s->run[i]);
    free(s->run);
    s->run = NULL;
    s->runs = 0;
    study_free(&s->study);
}
