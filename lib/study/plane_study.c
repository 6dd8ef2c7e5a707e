#include "plane_study.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plane_basin.h"
#include "plane_branch.h"
#include "plane_numbers.h"
#include "plane_rest.h"
#include "plane_results.h"
#include "plane_sensitivity.h"
#include "study_tolerance.h"
#include "tolerance.h"

#define BIT(p) (1u << PRODUCT_##p)

double plane_state(const struct plane_study *s, int axis, double z)
{
    return scene_axis_is_log(s->scene, axis) ? exp(z) : z;
}

/* ---- the system ---------------------------------------------------------- */

static struct planar_axis axis_of(const struct plane_study *s, int i)
{
    const struct system_state *x = &s->scene->system->state[i];

    return (struct planar_axis){ x->name, "1", x->name,
                                 x->chart == CHART_POSITIVE };
}

static double period_of(const struct plane_study *s, int i)
{
    return (double) s->scene->system->state[i].period;
}

/* So far curves are followed; an angle any way round. */
static struct box domain_of(const struct plane_study *s)
{
    const struct box w = s->window.box;
    struct box far = box_grow(w, TOL_PLANE_FAR);

    if (s->scale.period.x > 0.0) {
        far.lo.x = w.lo.x - TOL_PLANE_ROUND * s->scale.period.x;
        far.hi.x = w.hi.x + TOL_PLANE_ROUND * s->scale.period.x;
    }
    if (s->scale.period.y > 0.0) {
        far.lo.y = w.lo.y - TOL_PLANE_ROUND * s->scale.period.y;
        far.hi.y = w.hi.y + TOL_PLANE_ROUND * s->scale.period.y;
    }
    return far;
}

static void set_system(struct plane_study *s)
{
    const struct box w = scene_box(s->scene);
    const struct vec2 middle = vec2_scale(0.5, vec2_add(w.lo, w.hi));
    const struct formula_system *f = s->scene->system;

    for (int i = 0; i < f->observables; i++)
        s->observable[i] = (struct planar_observable){
            f->observable[i].name,
            f->observable[i].unit[0] ? f->observable[i].unit : "1",
            f->observable[i].long_name[0] ? f->observable[i].long_name
                                          : f->observable[i].name
        };
    s->window = (struct window){ .box = w };
    for (int i = 0; i < 2; i++)
        s->window.exponential[i] = s->scene->window.axes == AXES_LINEAR &&
                                   scene_axis_is_log(s->scene, i);
    s->scale = (struct arrival_scale){ .side = vec2_sub(w.hi, w.lo),
                                       .period = { period_of(s, 0),
                                                   period_of(s, 1) } };
    for (int i = 0; i < 2; i++) {
        s->plane[i] =
            plain_around(&s->program, middle, false, i == 0 ? 1.0 : -1.0);
        s->system[i] = (struct planar){
            .name = "system",
            .axis = { axis_of(s, 0), axis_of(s, 1) },
            .domain = domain_of(s),
        };
        plain_planar(&s->plane[i], &s->system[i]);
        s->system[i].observables = s->observable;
        s->system[i].observable_count = (size_t) f->observables;
    }
}

/* The fastest rate at any equilibrium, or else in the middle of the window. */
static double fastest(const struct plane_study *s)
{
    double rate = 0.0;
    struct mat2 A;

    for (size_t i = 0; i < s->rests; i++)
        for (int k = 0; k < 2; k++)
            rate = fmax(rate, hypot(s->rest[i].lambda[k].re.value,
                                    s->rest[i].lambda[k].im.value));
    if (rate > 0.0)
        return rate;
    (void) plain_rates(&s->program, s->system[0].origin, &A);
    rate = hypot(hypot(A.xx, A.xy), hypot(A.yx, A.yy));
    return isfinite(rate) && rate > 0.0 ? rate : 1.0;
}

/* ---- portrait ------------------------------------------------------------ */

/* Where orbits in this direction of time may arrive. */
static size_t targets(const struct plane_study *s, bool backward,
                      struct vec2 *out)
{
    size_t n = 0;

    for (size_t i = 0; i < s->rests; i++)
        if (s->rest[i].trap[backward].size > 0.0)
            out[n++] = vec2_sub(s->rest[i].z, s->system[0].origin);
    return n;
}

static struct trajectory_options orbits(const struct plane_study *s,
                                        bool backward, struct vec2 *target,
                                        const struct monitor *monitor)
{
    const struct scene *c = s->scene;
    struct trajectory_options o = trajectory_defaults(&s->system[0], s->kappa);

    o.orbit.backward = backward;
    o.orbit.target = target;
    o.orbit.targets = targets(s, backward, target);
    o.orbit.arrival = TOL_PLANE_DRAWN * fmin(s->scale.side.x, s->scale.side.y);
    o.orbit.observables = s->system[0].observable_count;
    o.orbit.rtol = fmax(c->rtol, TOL_ORBIT_RTOL);
    o.orbit.max_steps = TOL_PLANE_STEPS;
    o.seed = c->seed;
    o.monitor = monitor;
    if (c->until_time > 0.0)
        o.orbit.reach[0] = backward ? -c->until_time : c->until_time;
    return o;
}

/* The scene's starts, then spread ones, all both ways. */
static enum status find_trajectories(struct plane_study *s,
                                     const struct monitor *monitor,
                                     struct fault *why)
{
    const struct scene *c = s->scene;
    struct trajectories chosen = TRAJECTORIES_EMPTY;
    struct trajectories *spread = &s->portrait.trajectories;
    struct vec2 *target = calloc(s->rests + 1, sizeof *target);
    struct vec2 *start = calloc(c->starts + c->spread + 1, sizeof *start);
    enum status status = target && start ? STATUS_OK : STATUS_NO_MEMORY;
    struct trajectory_options o = { .margin = 0.0 };

    if (status == STATUS_OK)
        o = orbits(s, false, target, monitor);
    if (status == STATUS_OK && c->spread > 0)
        status = portrait_spread_trajectories(&s->portrait, c->spread, &o);
    for (size_t i = 0; i < c->starts && start; i++)
        start[i] = (struct vec2){
            scene_axis_is_log(c, 0) ? log(c->start[i].v) : c->start[i].v,
            scene_axis_is_log(c, 1) ? log(c->start[i].psi) : c->start[i].psi
        };
    for (size_t i = 0; i < spread->count && status == STATUS_OK; i++)
        start[c->starts + i] = spread->at[i].start;
    for (int way = 0; way < 2 && status == STATUS_OK; way++) {
        o = orbits(s, way == 1, target, monitor);
        status = trajectory_run(&s->system[0], &s->window, start,
                                c->starts + spread->count, &o,
                                way ? &s->backward : &chosen);
    }
    if (status == STATUS_BAD_ARGUMENT)
        strcpy(why->text, "a trajectory starts too far from the window");
    if (status == STATUS_OK) {
        trajectory_free(spread);
        *spread = chosen;
    } else {
        trajectory_free(&chosen);
    }
    free(target);
    free(start);
    return status;
}

static enum status find_portrait(struct plane_study *s,
                                 const struct monitor *monitor,
                                 struct fault *why)
{
    enum status status = portrait_init(&s->portrait, &s->system[0], &s->window);

    if (status == STATUS_OK && s->products & BIT(NULLCLINES))
        status = portrait_find_nullclines(&s->portrait, TOL_NULLCLINE_CHORD);
    if (status == STATUS_OK && s->products & BIT(FIELD_ARROWS))
        status = portrait_find_arrows(&s->portrait, TOL_ARROWS, TOL_ARROWS);
    if (status == STATUS_OK && s->products & BIT(TRAJECTORIES))
        status = find_trajectories(s, monitor, why);
    return status;
}

/* ---- running ------------------------------------------------------------- */

static enum status run(struct plane_study *s, const struct monitor *monitor,
                       struct fault *why)
{
    enum status status = plain_program(&s->program, s->scene->system, why);

    if (status == STATUS_OK &&
        s->scene->system->observables > PLANAR_OBSERVABLES_MAX) {
        snprintf(why->text, sizeof why->text,
                 "system.observables: more than %d", PLANAR_OBSERVABLES_MAX);
        return STATUS_BAD_SCENE;
    }
    if (status != STATUS_OK)
        return status;
    set_system(s);
    status = plane_rest_find(s, why);
    s->kappa = fastest(s);
    if (status == STATUS_OK && s->products & (BIT(MANIFOLDS) | BIT(BASINS)))
        status = plane_branch_grow(s, monitor);
    if (status == STATUS_OK)
        status = find_portrait(s, monitor, why);
    if (status == STATUS_OK && s->products & BIT(BASINS))
        status = plane_basin_find(s, monitor);
    if (status != STATUS_OK)
        return status;
    if (s->products & BIT(SENSITIVITIES))
        status = plane_sensitivity_find(s);
    if (status != STATUS_OK)
        return status;
    plane_numbers_fill(s);
    return plane_results_make(s);
}

enum status plane_study_run(struct plane_study *s, const struct scene *scene,
                            const struct monitor *monitor, struct fault *why)
{
    *s = (struct plane_study){ .scene = scene,
                               .products = scene->products | BIT(EQUILIBRIA) };
    why->text[0] = '\0';
    const enum status status = run(s, monitor, why);
    if (status == STATUS_OK)
        return STATUS_OK;
    if (why->text[0] == '\0')
        snprintf(why->text, sizeof why->text, "%s", status_text(status));
    plane_study_free(s);
    return status;
}

void plane_study_free(struct plane_study *s)
{
    for (size_t i = 0; i < s->branches; i++)
        branch_free(&s->branch[i].curve);
    free(s->branch);
    free(s->rest);
    free(s->undecided);
    free(s->cycle);
    free(s->slope);
    portrait_free(&s->portrait);
    trajectory_free(&s->backward);
    plane_basin_free(&s->basin);
    plane_results_free(s->table);
    *s = (struct plane_study){ .scene = NULL };
}
