#include "plane_study.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plane_basin.h"
#include "plane_branch.h"
#include "plane_defined.h"
#include "plane_numbers.h"
#include "plane_proof.h"
#include "plane_rest.h"
#include "plane_results.h"
#include "plane_scatter.h"
#include "plane_sensitivity.h"
#include "plane_tolerance.h"
#include "plane_turn.h"
#include "scene_figure.h"
#include "tolerance.h"

#define BIT(p) (1u << PRODUCT_##p)

double plane_state(const struct plane_study *s, int axis, double z)
{
    return scene_axis_is_log(s->scene, axis) ? exp(z) : z;
}

double plane_chart(const struct plane_study *s, int axis, double state)
{
    return scene_axis_is_log(s->scene, axis) ? log(state) : state;
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

/* So far curves are followed; an angle any way round; a positive state as far
 * as doubles go, and what is some times as large. */
static struct box domain_of(const struct plane_study *s)
{
    const double most = log(DBL_MAX * DBL_EPSILON);
    const struct box w = s->window.box;
    struct box far = box_grow(w, TOL_PLANE_FAR);

    if (scene_axis_is_log(s->scene, 0)) {
        far.lo.x = fmin(w.lo.x, fmax(far.lo.x, log(DBL_MIN)));
        far.hi.x = fmax(w.hi.x, fmin(far.hi.x, most));
    }
    if (scene_axis_is_log(s->scene, 1)) {
        far.lo.y = fmin(w.lo.y, fmax(far.lo.y, log(DBL_MIN)));
        far.hi.y = fmax(w.hi.y, fmin(far.hi.y, most));
    }
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

static void set_window(struct plane_study *s)
{
    const struct box w = scene_box(s->scene);
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
}

enum { PLACES = 20 };

/* Where a fault was met: at all of them. */
static void tell_place(const struct plane_study *s, struct fault *why)
{
    const struct box w = s->window.box;
    const struct vec2 z = vec2_scale(0.5, vec2_add(w.lo, w.hi));
    const struct fault what = *why;

    snprintf(why->text, sizeof why->text,
             "%.300s at %s = %g, %s = %g, nor at %d other places of the window",
             what.text, s->scene->system->state[0].name, plane_state(s, 0, z.x),
             s->scene->system->state[1].name, plane_state(s, 1, z.y),
             PLACES - 1);
}

/* About the middle of the window, or about another place where all formulas
 * have values. */
static enum status set_anchor(struct plane_study *s, struct fault *why)
{
    const struct box w = s->window.box;
    enum status status = STATUS_BAD_SCENE;

    for (int i = 0; i < PLACES && status == STATUS_BAD_SCENE; i++) {
        const struct vec2 part = vec2_spread(0.5, i);
        const formula_real at[] = { w.lo.x + part.x * (w.hi.x - w.lo.x),
                                    w.lo.y + part.y * (w.hi.y - w.lo.y) };
        status = plane_study_about(s, false, at, s->plane, s->system, why);
    }
    if (status == STATUS_BAD_SCENE)
        tell_place(s, why);
    return status;
}

enum status plane_study_about(const struct plane_study *s, bool equilibrium,
                              const formula_real at[2],
                              struct tape_plane plane[2],
                              struct planar system[2], struct fault *why)
{
    enum status status = STATUS_OK;

    for (int i = 0; i < 2 && status == STATUS_OK; i++) {
        status =
            system_plane_at(s->lowered, equilibrium, i, at, &plane[i], why);
        system[i] = tape_planar(&plane[i]);
        system[i].name = "system";
        system[i].axis[0] = axis_of(s, 0);
        system[i].axis[1] = axis_of(s, 1);
        system[i].domain = domain_of(s);
        system[i].observables = s->observable;
    }
    return status;
}

/* The fastest rate at any equilibrium, or else in the middle of the window. */
static double fastest(const struct plane_study *s)
{
    double rate = 0.0;
    struct planar_jacobian J;

    for (size_t i = 0; i < s->rests; i++)
        for (int k = 0; k < 2; k++)
            rate = fmax(rate, hypot(s->rest[i].lambda[k].re.value,
                                    s->rest[i].lambda[k].im.value));
    if (rate > 0.0)
        return rate;
    s->system[0].jacobian(s->system[0].ctx, (struct vec2){ 0.0, 0.0 }, &J);
    rate = hypot(hypot(J.matrix.xx, J.matrix.xy),
                 hypot(J.matrix.yx, J.matrix.yy)) *
           exp(J.field.log_scale);
    return isfinite(rate) && rate > 0.0 ? rate : 1.0;
}

double plane_study_speed(const struct plane_study *s, struct vec2 z)
{
    const struct planar *system = &s->system[0];
    const struct vec2 side = s->scale.side;
    struct planar_field f;

    system->field(system->ctx, vec2_sub(z, system->origin), &f);
    return hypot(f.direction.x / side.x, f.direction.y / side.y) *
           exp(f.log_scale);
}

struct box plane_study_box(const struct plane_study *s)
{
    struct box w = s->window.box;

    if (s->scale.period.x > 0.0) {
        w.lo.x = -HUGE_VAL;
        w.hi.x = HUGE_VAL;
    }
    if (s->scale.period.y > 0.0) {
        w.lo.y = -HUGE_VAL;
        w.hi.y = HUGE_VAL;
    }
    return w;
}

/* ---- portrait ------------------------------------------------------------ */

/* Where orbits in this direction of time may arrive. */
static size_t targets(const struct plane_study *s, bool backward,
                      struct vec2 *out)
{
    size_t n = 0;

    for (size_t i = 0; i < s->rests; i++)
        if (plane_rest_attracts(&s->rest[i], backward))
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
    o.orbit.arrival = TOL_SEEN * fmin(s->scale.side.x, s->scale.side.y);
    o.orbit.observables = s->system[0].observable_count;
    o.orbit.rtol = fmax(c->rtol, TOL_ORBIT_RTOL);
    o.orbit.max_steps = TOL_CURVE_STEPS;
    o.seed = c->seed;
    o.monitor = monitor;
    if (c->until_time > 0.0)
        o.orbit.reach[0] = backward ? -c->until_time : c->until_time;
    else
        o.closes = &s->scale;
    return o;
}

/* Starts of orbits that fill the window between the manifolds. */
static enum status spread_starts(struct plane_study *s,
                                 struct trajectory_options *o)
{
    struct trajectory_drawn *drawn = calloc(s->branches + 1, sizeof *drawn);

    if (drawn == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < s->branches; i++)
        drawn[i] = (struct trajectory_drawn){ &s->branch[i].curve.curve,
                                              s->rest[s->branch[i].rest].z };
    o->halfway = true;
    o->drawn = drawn;
    o->drawn_count = s->branches;
    const enum status status =
        portrait_spread_trajectories(&s->portrait, s->scene->spread, o);
    free(drawn);
    return status;
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
        status = spread_starts(s, &o);
    for (size_t i = 0; i < c->starts && start; i++)
        start[i] = (struct vec2){ plane_chart(s, 0, c->start[i].v),
                                  plane_chart(s, 1, c->start[i].psi) };
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
        status = portrait_find_nullclines(&s->portrait,
                                          scene_figure_chord(&s->scene->paper));
    if (status == STATUS_OK && s->products & BIT(FIELD_ARROWS))
        status = portrait_find_arrows(&s->portrait, PORTRAIT_ARROWS,
                                      PORTRAIT_ARROWS);
    if (status == STATUS_OK && s->products & BIT(TRAJECTORIES))
        status = find_trajectories(s, monitor, why);
    return status;
}

/* ---- running ------------------------------------------------------------- */

static enum status run(struct plane_study *s, const struct monitor *monitor,
                       struct fault *why)
{
    enum status status = STATUS_OK;

    if (s->scene->system->observables > PLANAR_OBSERVABLES_MAX)
        return fault_set(why, STATUS_BAD_SCENE,
                         "system.observables: more than %d",
                         PLANAR_OBSERVABLES_MAX);
    s->lowered = malloc(sizeof *s->lowered);
    s->plane = calloc(2, sizeof *s->plane);
    if (s->lowered == NULL || s->plane == NULL)
        return STATUS_NO_MEMORY;
    set_window(s);
    status = system_plane_lower(s->lowered, s->scene->system, why);
    if (status == STATUS_OK)
        status = set_anchor(s, why);
    if (status == STATUS_OK)
        status = plane_defined_plan(s, why);
    if (status != STATUS_OK)
        return status;
    if (monitor_tell(monitor, "equilibria", 0, 0))
        return STATUS_STOPPED;
    status = plane_rest_find(s, why);
    s->kappa = fastest(s);
    if (status == STATUS_OK && s->products & (BIT(MANIFOLDS) | BIT(BASINS)))
        status = plane_branch_grow(s, monitor);
    if (status == STATUS_OK)
        status = find_portrait(s, monitor, why);
    if (status == STATUS_OK && s->products & BIT(BASINS))
        status = plane_basin_find(s, monitor);
    if (status == STATUS_BAD_SCENE && why->text[0] == '\0')
        snprintf(why->text, sizeof why->text,
                 "basins: more than %d attractors: take a smaller window",
                 INT8_MAX);
    if (status != STATUS_OK)
        return status;
    if (s->basin.share)
        plane_numbers_add(s);
    if (s->products & BIT(SENSITIVITIES) || s->scene->ensemble.scattered > 0)
        status = plane_sensitivity_find(s, monitor);
    if (status == STATUS_OK && s->products & BIT(BASINS) &&
        s->scene->ensemble.scattered > 0)
        status = plane_scatter_shares(s, monitor);
    if (status != STATUS_OK)
        return status;
    plane_numbers_fill(s);
    if (s->scene->proved)
        status = plane_proof_find(s);
    return status == STATUS_OK ? plane_results_make(s) : status;
}

enum status plane_study_run(struct plane_study *s, const struct scene *scene,
                            const struct monitor *monitor, struct fault *why)
{
    *s = (struct plane_study){ .scene = scene,
                               .products = scene->products | BIT(EQUILIBRIA) };
    if (s->products & BIT(MARGIN))
        s->products |= BIT(BASINS);
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
    for (size_t i = 0; i < s->rests; i++) {
        plane_turn_free(&s->rest[i].turn[0]);
        plane_turn_free(&s->rest[i].turn[1]);
        free(s->rest[i].plane);
    }
    free(s->rest);
    free(s->lowered);
    free(s->plan);
    free(s->plane);
    free(s->undecided);
    free(s->cycle);
    free(s->slope);
    plane_proof_free(&s->proof);
    free(s->beyond);
    portrait_free(&s->portrait);
    trajectory_free(&s->backward);
    plane_basin_free(&s->basin);
    plane_results_free(s->table);
    *s = (struct plane_study){ .scene = NULL };
}
