/* The stages of a study, each reading what earlier ones left and filling its
 * own members. */
#include "study.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clock.h"
#include "conditioning.h"
#include "scatter.h"
#include "scene_figure.h"
#include "scene_slope.h"
#include "study_manifold.h"
#include "study_results.h"
#include "study_tolerance.h"

/* What runs a stage: enum status name(s, monitor, why). */
#define UNUSED __attribute__((unused))
#define STAGE(name)                                                            \
    static enum status name(UNUSED struct study *s,                            \
                            UNUSED const struct monitor *monitor,              \
                            UNUSED struct fault *why)

/* ---- steady states --------------------------------------------------- */

STAGE(run_steady)
{
    const struct scene *c = s->scene;

    (s->saddle_alone ? slider_init_saddle : slider_init)(
        &s->slider, &c->law, &c->material, c->tan_alpha);
    const int saddle = slider_saddle(&s->slider);
    s->saddle_numbers =
        numbers_saddle(saddle >= 0 ? &s->slider.steady[saddle] : NULL);
    s->cost[STAGE_STEADY].field_evaluations = s->slider.plane.equilibria + 1;
    return slider_check(&s->slider, why);
}

STAGE(run_folds)
{
    s->folds = numbers_folds(&s->slider.block.law, &s->slider.block.material);
    return STATUS_OK;
}

/* The scene's window as drawn. */
static struct window study_frame(const struct study *s)
{
    return (struct window){ .box = scene_box(s->scene),
                            .exponential = {
                                s->scene->window.axes == AXES_LINEAR,
                                s->scene->window.axes == AXES_LINEAR &&
                                    s->slider.plane.system.axis[1].is_log } };
}

/* ---- numbers ------------------------------------------------------------ */

STAGE(run_critical)
{
    if (slider_has_manifolds(&s->slider))
        s->slider.critical = numbers_critical(
            &s->slider.block, phase_plane_saddle(&s->slider.plane),
            &s->stable[SIDE_UPPER], &s->stable[SIDE_LOWER]);
    return STATUS_OK;
}

STAGE(run_knees)
{
    if (slider_has_manifolds(&s->slider))
        numbers_knees(&s->slider.block, &s->slider.plane.system,
                      &s->stable[SIDE_UPPER], &s->stable[SIDE_LOWER],
                      &s->slider.critical);
    return STATUS_OK;
}

STAGE(run_taylor)
{
    return taylor_series_find(s, &s->taylor);
}

STAGE(run_estimates)
{
    s->estimates = numbers_estimates(&s->slider.block, s->scene->xi,
                                     s->scene->xi_count, &s->slider.critical);
    return STATUS_OK;
}

STAGE(run_sensitivities)
{
    size_t *evaluations = &s->cost[STAGE_SENSITIVITIES].field_evaluations;
    enum status status = STATUS_OK;

    const char *none = slider_no_manifolds(&s->slider);
    s->sensitivities = sensitivity_none(none ? none : "nobody asked");
    if (slider_has_manifolds(&s->slider))
        status = sensitivity_find(&s->slider.block,
                                  phase_plane_saddle(&s->slider.plane),
                                  &s->slider.critical, s->scene->rtol,
                                  &s->sensitivities, evaluations);
    return status
               ? status
               : conditioning_find(s, monitor, &s->sensitivities, evaluations);
}

STAGE(run_spread)
{
    return scatter_find(s, monitor, &s->cost[STAGE_SPREAD].field_evaluations);
}

/* ---- portrait -------------------------------------------------------- */

STAGE(run_nullclines)
{
    const enum status status = portrait_find_nullclines(
        &s->portrait, scene_figure_chord(&s->scene->paper));
    s->cost[STAGE_NULLCLINES].field_evaluations =
        s->portrait.nullcline[NULLCLINE_X].evaluations +
        s->portrait.nullcline[NULLCLINE_Y].evaluations;
    return status;
}

STAGE(run_arrows)
{
    const enum status status =
        portrait_find_arrows(&s->portrait, PORTRAIT_ARROWS, PORTRAIT_ARROWS);
    s->cost[STAGE_ARROWS].field_evaluations = s->portrait.arrows.evaluations;
    return status;
}

static size_t attractors(const struct study *s, struct vec2 target[])
{
    size_t n = 0;

    for (size_t i = 0; i < s->slider.plane.equilibria; i++)
        if (s->slider.plane.equilibrium[i].type == EQUILIBRIUM_STABLE_NODE)
            target[n++] = phase_plane_offset(&s->slider.plane, i);
    return n;
}

static enum status run_starts(struct study *s,
                              const struct trajectory_options *o,
                              struct fault *why)
{
    const struct scene *c = s->scene;
    struct vec2 *start = calloc(c->starts + 1, sizeof *start);

    if (start == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < c->starts; i++)
        start[i] = (struct vec2){ log(c->start[i].v),
                                  s->slider.plane.system.axis[1].is_log
                                      ? log(c->start[i].psi)
                                      : c->start[i].psi };
    const enum status status =
        trajectory_run(&s->slider.plane.system, &s->portrait.window, start,
                       c->starts, o, &s->chosen);
    if (status == STATUS_BAD_ARGUMENT)
        strcpy(why->text, "a trajectory starts outside [1e-300, 1e300]");
    free(start);
    return status;
}

/* What the portrait shows besides: manifolds and the chosen orbits. */
static enum status spread_orbits(struct study *s, struct trajectory_options *o)
{
    const size_t chosen = s->chosen.count;
    struct trajectory_drawn *drawn = calloc(2 * SIDES + chosen, sizeof *drawn);

    if (drawn == NULL)
        return STATUS_NO_MEMORY;
    for (int i = 0; i < SIDES; i++) {
        drawn[2 * i].curve = &s->stable[i].curve;
        drawn[2 * i + 1].curve = &s->unstable[i].curve;
    }
    for (size_t i = 0; i < chosen; i++)
        drawn[2 * SIDES + i].curve = &s->chosen.at[i].curve;
    for (size_t i = 0; i < 2 * SIDES + chosen; i++)
        drawn[i].origin = s->slider.plane.system.origin;
    o->drawn = drawn;
    o->drawn_count = 2 * SIDES + chosen;
    const enum status status =
        portrait_spread_trajectories(&s->portrait, s->scene->spread, o);
    free(drawn);
    return status;
}

STAGE(run_trajectories)
{
    const struct scene *c = s->scene;
    struct trajectory_options o = trajectory_defaults(
        &s->slider.plane.system, s->slider.plane.fastest_rate);
    struct vec2 target[EQUILIBRIA_MAX];

    o.orbit.target = target;
    o.orbit.targets = attractors(s, target);
    o.orbit.arrival = TOL_ARREST;
    o.orbit.observables = BLOCK_EXCESS; /* slip and work: enough for (27) */
    o.orbit.rtol = fmax(c->rtol, TOL_ORBIT_RTOL);
    o.seed = c->seed;
    o.monitor = monitor;
    if (c->until_time > 0.0)
        o.orbit.reach[0] = c->until_time;
    if (c->until_slip > 0.0)
        o.orbit.reach[1 + BLOCK_SLIP] = c->until_slip;
    enum status status = STATUS_OK;
    if (c->starts > 0)
        status = run_starts(s, &o, why);
    o.orbit.rtol = fmax(c->rtol, TOL_DRAWN);
    if (status == STATUS_OK && c->spread > 0)
        status = spread_orbits(s, &o);
    s->cost[STAGE_TRAJECTORIES].field_evaluations =
        s->chosen.evaluations + s->portrait.trajectories.evaluations;
    return status;
}

STAGE(run_basins)
{
    enum status status =
        basin_map_init(&s->basins, &s->slider, s->scene, monitor);

    if (status == STATUS_NOT_HYPERBOLIC)
        snprintf(why->text, sizeof why->text, "the basins of the slope: %s",
                 s->slider.critical.v_plus.reason);
    if (status == STATUS_OK && s->scene->audit > 0 && !s->scene->exact)
        status = basin_map_audit(&s->basins, s->scene->audit, s->scene->seed,
                                 monitor);
    return status;
}

STAGE(run_fields)
{
    return fields_prepare(&s->fields, &s->basins, monitor, why);
}

STAGE(run_proof)
{
    return study_prove(s);
}

STAGE(run_sides)
{
    return basin_prove(s);
}

/* ---- running ---------------------------------------------------------- */

typedef enum status stage_function(struct study *s,
                                   const struct monitor *monitor,
                                   struct fault *why);

static stage_function *const stage_run[STAGES] = {
    [STAGE_STEADY] = run_steady,
    [STAGE_FOLDS] = run_folds,
    [STAGE_UNSTABLE] = study_unstable,
    [STAGE_CRITICAL] = run_critical,
    [STAGE_KNEES] = run_knees,
    [STAGE_TAYLOR] = run_taylor,
    [STAGE_ESTIMATES] = run_estimates,
    [STAGE_SENSITIVITIES] = run_sensitivities,
    [STAGE_SPREAD] = run_spread,
    [STAGE_NULLCLINES] = run_nullclines,
    [STAGE_ARROWS] = run_arrows,
    [STAGE_TRAJECTORIES] = run_trajectories,
    [STAGE_BASINS] = run_basins,
    [STAGE_FIELDS] = run_fields,
    [STAGE_FRICTION_LAW] = diagram_friction_law,
    [STAGE_SPRING_BLOCK] = diagram_spring_block,
    [STAGE_BIFURCATION] = diagram_bifurcation,
    [STAGE_FOLD_CURVES] = diagram_fold_curves,
    [STAGE_CHI] = diagram_chi,
    [STAGE_PROOF] = run_proof,
    [STAGE_SIDES] = run_sides,
};

static enum status run_alone(struct study *s, enum stage stage,
                             const struct monitor *monitor, struct fault *why)
{
    enum status status = stage_run[stage](s, monitor, why);

    if (status == STATUS_OK && stage == STAGE_STEADY) {
        const struct window window = study_frame(s);
        status = portrait_init(&s->portrait, &s->slider.plane.system, &window);
        if (status == STATUS_BAD_ARGUMENT)
            strcpy(why->text, "the window reaches beyond [1e-300, 1e300]");
    }
    return status;
}

/* Of all jobs without a failure. */
static void run_stage(struct study_job job[], size_t n, enum stage stage,
                      const struct monitor *monitor)
{
    const double start = clock_seconds();

    if (monitor_tell(monitor, stage_table[stage].name, 0, 0))
        for (size_t i = 0; i < n; i++)
            job[i].status = STATUS_STOPPED;
    if (stage == STAGE_STABLE)
        study_stable(job, n, monitor);
    for (size_t i = 0; i < n; i++) {
        struct stage_cost *cost = &job[i].study->cost[stage];
        if (job[i].status == STATUS_OK && stage != STAGE_STABLE)
            job[i].status =
                run_alone(job[i].study, stage, monitor, &job[i].why);
        cost->ran = true;
        cost->seconds = (clock_seconds() - start) / (double) n;
    }
}

static bool goes_on(const struct study_job job[], size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (job[i].status == STATUS_OK)
            return true;
    return false;
}

/* All but the block, which is large and made by block_init. */
static void clear(struct study *s, bool saddle_alone)
{
    const size_t block = offsetof(struct study, slider.block);
    const size_t rest = block + sizeof s->slider.block;
    const size_t end =
        saddle_alone ? offsetof(struct study, chosen) : sizeof *s;

    memset(s, 0, block);
    memset((char *) s + rest, 0, end - rest);
}

static void begin(struct study_job *job, unsigned stages)
{
    const struct scene *scene = job->scene;

    job->why.text[0] = '\0';
    clear(job->study, stages & PLAN_SADDLE);
    job->study->scene = scene;
    job->study->stages = stages & ~(PLAN_SADDLE | PLAN_NO_DEFICIT);
    job->study->saddle_alone = stages & PLAN_SADDLE;
    job->study->no_deficit = stages & PLAN_NO_DEFICIT;
    job->status = scene_slope_demand(scene, scene->products, &job->why);
    if (!plan_has(stages, STAGE_STEADY)) /* which begins with that */
        block_init(&job->study->slider.block, &scene->law, &scene->material,
                   scene->tan_alpha);
}

static void end(struct study_job *job)
{
    if (job->status == STATUS_OK)
        job->status = study_keep(job->study, ~(uint64_t) 0);
    if (job->status == STATUS_OK)
        return;
    if (job->why.text[0] == '\0')
        snprintf(job->why.text, sizeof job->why.text, "%s",
                 status_text(job->status));
    study_free(job->study);
}

void study_run_jobs(struct study_job job[], size_t n, unsigned stages,
                    const struct monitor *monitor)
{
    for (size_t i = 0; i < n; i++)
        begin(&job[i], stages);
    for (int k = 0; k < STAGES; k++)
        if (plan_has(stages, (enum stage) k) && goes_on(job, n))
            run_stage(job, n, (enum stage) k, monitor);
    for (size_t i = 0; i < n; i++)
        end(&job[i]);
}

enum status study_run(struct study *s, const struct scene *scene,
                      const struct monitor *monitor, struct fault *why)
{
    struct study_job job = { .study = s, .scene = scene };

    study_run_jobs(&job, 1, plan_scene(scene), monitor);
    *why = job.why;
    return job.status;
}

void study_free(struct study *s)
{
    for (int i = 0; i < SIDES; i++) {
        branch_free(&s->stable[i]);
        orbit_free(&s->unstable[i]);
    }
    result_keep_free(&s->kept);
    portrait_free(&s->portrait);
    if (s->saddle_alone) /* which has no more */
        return;
    study_proof_free(&s->proof);
    basin_proof_free(&s->label_proof);
    basin_map_free(&s->basins);
    fields_free(&s->fields);
    diagrams_free(&s->diagrams);
    trajectory_free(&s->chosen);
}

struct stage_cost study_cost(const struct study *s)
{
    struct stage_cost total = { .ran = true };

    for (int i = 0; i < STAGES; i++) {
        total.field_evaluations += s->cost[i].field_evaluations;
        total.seconds += s->cost[i].seconds;
    }
    return total;
}
