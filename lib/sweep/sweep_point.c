#include "sweep_point.h"

#include <math.h>
#include <stdlib.h>

#include "plane_proof.h"
#include "scene_parameter.h"
#include "scene_sweep.h"

#define BIT(p) (1u << PRODUCT_##p)

/* ---- what is asked for --------------------------------------------------- */

unsigned sweep_point_products(const struct scene *scene, bool maps)
{
    const unsigned fields =
        BIT(MARGIN) | BIT(SLIP) | BIT(TIME) | BIT(FRICTION) | BIT(PEAK);
    unsigned products = scene->products & ~BIT(TRAJECTORIES);

    if (scene->system)
        return scene->products;
    if (scene->products & BIT(TRAJECTORIES))
        products |= BIT(KNEES);
    if (scene_sweep_releases(scene))
        products |= BIT(KNEES) | BIT(ESTIMATES);
    if (!maps && products & fields)
        products |= BIT(BASINS);
    return maps ? products : products & ~(fields | BIT(FIELD_ARROWS));
}

/* ---- steady states ------------------------------------------------------- */

static struct quantity logarithm(const struct quantity *q)
{
    return quantity_exists(q)
               ? quantity_of(log(q->value), q->error / fabs(q->value))
               : *q;
}

static struct kind_numbers no_kind(const char *reason)
{
    const struct quantity none = quantity_none(reason);

    return (struct kind_numbers){ none, none, none, none, none, none };
}

static struct kind_numbers kind_of(const struct steady_number *n, bool psi_log)
{
    return (struct kind_numbers){ logarithm(&n->v),
                                  psi_log ? n->psi : logarithm(&n->psi),
                                  n->v,
                                  n->psi,
                                  n->lambda_minus,
                                  n->lambda_plus };
}

static enum steady_kind what_is(const struct study *s, size_t i)
{
    if ((int) i == slider_saddle(&s->slider))
        return STEADY_SADDLE;
    return fate_of_node(&s->slider, &s->slider.plane.equilibrium[i]) ==
                   FATE_CREEP
               ? STEADY_CREEP
               : STEADY_SLIDING;
}

/* Those that are not there get a reason. */
static void complete_steady(struct sweep_point *p)
{
    static const char *const missing[STEADY_KINDS] = {
        "there is no creep node at this slope",
        "there is no saddle at this slope",
        "there is no sliding node at this slope"
    };
    struct study *s = &p->study;
    const char *no_series = slider_no_manifolds(&s->slider);

    for (int k = 0; k < STEADY_KINDS; k++)
        p->kind[k] = no_kind(missing[k]);
    for (size_t i = 0; i < s->slider.plane.equilibria; i++)
        p->kind[what_is(s, i)] =
            kind_of(&s->slider.steady[i], law_psi_is_log(&p->scene.law));
    for (size_t i = s->taylor.terms; i < JET_SIZE; i++)
        s->taylor.term[i].coefficient =
            quantity_none(no_series ? no_series : missing[STEADY_SADDLE]);
}

/* ---- the whole ----------------------------------------------------------- */

static enum status run_starts(struct sweep_point *p,
                              const struct monitor *monitor)
{
    const size_t starts = p->scene.starts;
    enum status status = STATUS_OK;

    p->start = calloc(starts + 1, sizeof *p->start);
    if (p->start == NULL)
        return STATUS_NO_MEMORY;
    for (; p->starts < starts && status == STATUS_OK; p->starts++)
        status = start_numbers_find(&p->study, p->scene.start[p->starts],
                                    monitor, &p->start[p->starts]);
    return status;
}

/* What a study does not know. */
static enum status complete(struct sweep_point *p, bool starts,
                            const struct monitor *monitor)
{
    study_proof_withdraw(&p->study.proof);
    complete_steady(p);
    if (scene_sweep_releases(&p->scene))
        p->release = release_at(&p->study);
    return starts ? run_starts(p, monitor) : STATUS_OK;
}

enum status sweep_point_begin(struct sweep_point *p, const struct scene *scene)
{
    p->start = NULL; /* what is large is not cleared twice */
    p->starts = 0;
    p->failed = NULL;
    p->system = NULL;
    p->plane = (struct plane_study){ .scene = NULL };
    p->scene = *scene;
    if (scene->system == NULL)
        return STATUS_OK;
    p->scene.system = p->system = malloc(sizeof *p->system);
    if (p->system == NULL)
        return STATUS_NO_MEMORY;
    *p->system = *scene->system;
    return STATUS_OK;
}

/* What failed is a reason; others are errors. */
static enum status note_failure(struct sweep_point *p, enum status status)
{
    sweep_point_free(p);
    if (status == STATUS_NO_MEMORY || status == STATUS_STOPPED)
        return status;
    p->failed = status_text(status);
    return STATUS_OK;
}

static enum status run_system(struct sweep_point *p,
                              const struct monitor *monitor)
{
    struct fault why;
    const enum status status =
        plane_study_run(&p->plane, &p->scene, monitor, &why);

    if (status == STATUS_OK)
        plane_proof_withdraw(&p->plane.proof);
    return status;
}

/* The first of n, which go by the same stages; of how many. */
static size_t run_some(struct sweep_point p[], size_t n, bool starts,
                       const struct monitor *monitor, enum status status[])
{
    const unsigned stages = plan_scene(&p[0].scene);
    struct study_job job[STUDY_JOBS];
    size_t some = 0;

    for (; some < n && plan_scene(&p[some].scene) == stages; some++)
        job[some] = (struct study_job){ .study = &p[some].study,
                                        .scene = &p[some].scene };
    study_run_jobs(job, some, stages, monitor);
    for (size_t k = 0; k < some; k++) {
        status[k] = job[k].status;
        if (status[k] == STATUS_OK)
            status[k] = complete(&p[k], starts, monitor);
    }
    return some;
}

/* Those begun, alike but for what a sweep changes; systems alone. */
static void run(struct sweep_point p[], size_t n, unsigned products,
                const struct monitor *monitor, enum status status[])
{
    const bool starts = p[0].scene.products & BIT(TRAJECTORIES);

    for (size_t k = 0; k < n; k++)
        p[k].scene.products = products;
    if (p[0].system)
        status[0] = run_system(&p[0], monitor);
    else
        for (size_t k = 0; k < n;)
            k += run_some(p + k, n - k, starts, monitor, status + k);
    for (size_t k = 0; k < n; k++)
        if (status[k] != STATUS_OK)
            status[k] = note_failure(&p[k], status[k]);
}

enum status sweep_point_run(struct sweep_point *p, unsigned products,
                            const struct monitor *monitor)
{
    enum status status;

    run(p, 1, products, monitor, &status);
    return status;
}

static enum status begin_at(struct sweep_point *p, const struct scene *scene,
                            const double x[])
{
    struct scene at;

    scene_at(scene, x, &at);
    enum status status = sweep_point_begin(p, &at);
    if (status != STATUS_OK)
        return status;
    for (size_t i = 0; p->system && i < scene->sweep.axes && !status; i++)
        status = scene_parameter_set(p->system, scene->sweep.axis[i].key, x[i]);
    return status ? note_failure(p, status) : STATUS_OK;
}

void sweep_points_at(struct sweep_point p[], const struct scene *scene,
                     const double *const x[], size_t n, unsigned products,
                     const struct monitor *monitor, enum status status[])
{
    const size_t most = scene->system ? 1 : n;

    for (size_t k = 0; k < n; k++)
        status[k] = begin_at(&p[k], scene, x[k]);
    for (size_t k = 0, some; k < n; k += some) {
        for (some = 0; some < most && k + some < n; some++)
            if (status[k + some] != STATUS_OK || p[k + some].failed)
                break;
        if (some > 0)
            run(p + k, some, products, monitor, status + k);
        else
            some = 1;
    }
}

enum status sweep_point_at(struct sweep_point *p, const struct scene *scene,
                           const double x[], unsigned products,
                           const struct monitor *monitor)
{
    enum status status;

    sweep_points_at(p, scene, &x, 1, products, monitor, &status);
    return status;
}

void sweep_points_study(struct sweep_point p[], const struct scene scene[],
                        size_t n, unsigned stages, enum status status[])
{
    struct study_job job[STUDY_JOBS];

    for (size_t k = 0; k < n; k++)
        job[k] = (struct study_job){ .study = &p[k].study, .scene = &scene[k] };
    study_run_jobs(job, n, stages, NULL);
    for (size_t k = 0; k < n; k++)
        status[k] = job[k].status;
}

void sweep_point_free(struct sweep_point *p)
{
    free(p->start);
    p->start = NULL;
    p->starts = 0;
    if (p->scene.system == NULL)
        study_free(&p->study);
    plane_study_free(&p->plane);
    free(p->system);
    p->system = NULL;
}
