#include "study_manifold.h"

#include <math.h>
#include <stdio.h>

#include "study_tolerance.h"

/* Everything that rides along when branches are stored, or only what the
 * critical numbers need. */
static struct carry carry_for(unsigned stages)
{
    if (plan_has(stages, STAGE_UNSTABLE))
        return (struct carry){
            { BLOCK_EXCESS, BLOCK_SLIP, CARRY_TIME, BLOCK_WORK }, 4
        };
    return (struct carry){ { BLOCK_EXCESS }, 1 };
}

static int side_sign(const struct local_series *u, enum side side)
{
    const int up = u->ind == 0 || u->c[1] > 0.0 ? 1 : -1; /* towards v > v_sp */
    return side == SIDE_UPPER ? up : -up;
}

static enum status local_series(struct study *s, enum manifold_kind kind,
                                const struct carry *carry,
                                struct local_series *u)
{
    const double tol = TOL_TAYLOR_STEP * s->scene->rtol;
    return local_at(&s->slider.plane.system,
                    phase_plane_saddle(&s->slider.plane), kind, carry,
                    grow_order(s->scene->rtol), tol, u);
}

/* What the stable branches of a study grow from. */
struct stable {
    struct grow_options options;
    struct box window;
    struct local_series series;
    struct branch branch[SIDES];
};

static void begin_stable(struct study *s, const struct monitor *monitor,
                         struct stable *t, struct local_job *local,
                         struct grow_job *job)
{
    struct grow_options *o = &t->options;
    const struct equilibrium *saddle = phase_plane_saddle(&s->slider.plane);

    *o = grow_defaults(s->scene->rtol);
    t->window = scene_box(s->scene);
    o->carry = carry_for(s->stages);
    o->bare = s->saddle_alone && !plan_has(s->stages, STAGE_KNEES);
    o->monitor = monitor;
    o->reach =
        plan_has(s->stages, STAGE_UNSTABLE) || plan_has(s->stages, STAGE_BASINS)
            ? &t->window
            : NULL;
    *local = (struct local_job){ .sys = &s->slider.plane.system,
                                 .e = saddle,
                                 .kind = MANIFOLD_STABLE,
                                 .ind = local_flatter(saddle, MANIFOLD_STABLE),
                                 .carry = &o->carry,
                                 .order = o->order,
                                 .tol = TOL_TAYLOR_STEP * o->rtol,
                                 .out = &t->series };
    *job = (struct grow_job){
        .sys = local->sys, .start = &t->series, .options = o, .out = t->branch
    };
}

static void end_stable(struct study *s, const struct stable *t)
{
    for (int i = 0; i < SIDES; i++) {
        s->stable[i] =
            t->branch[side_sign(&t->series, (enum side) i) > 0 ? 0 : 1];
        s->cost[STAGE_STABLE].field_evaluations +=
            s->stable[i].evaluations * t->options.order;
    }
}

void study_stable(struct study_job job[], size_t n,
                  const struct monitor *monitor)
{
    struct stable t[STUDY_JOBS];
    struct local_job local[STUDY_JOBS];
    struct grow_job grow[STUDY_JOBS];
    struct study_job *of[STUDY_JOBS];
    const struct stable *from[STUDY_JOBS];
    size_t count = 0, good = 0;

    for (size_t i = 0; i < n; i++) {
        struct study *s = job[i].study;
        if (job[i].status != STATUS_OK || !slider_has_manifolds(&s->slider))
            continue;
        of[count] = &job[i];
        begin_stable(s, monitor, &t[count], &local[count], &grow[count]);
        count++;
    }
    local_jobs(local, count);
    for (size_t i = 0; i < count; i++) {
        of[i]->status = local[i].status;
        if (local[i].status == STATUS_OK) {
            of[good] = of[i];
            from[good] = &t[i];
            grow[good] = grow[i];
            if (of[i]->study->no_deficit)
                grow[good].carries = side_sign(&t[i].series, SIDE_UPPER);
            good++;
        }
    }
    grow_jobs(grow, good);
    for (size_t i = 0; i < good; i++) {
        of[i]->status = grow[i].status;
        if (grow[i].status == STATUS_OK)
            end_stable(of[i]->study, from[i]);
    }
    for (size_t i = 0; i < n; i++)
        if (job[i].status != STATUS_OK && job[i].why.text[0] == '\0')
            snprintf(job[i].why.text, sizeof job[i].why.text,
                     "the stable manifold of the saddle at v = %.6g: %s",
                     job[i].study->slider.block.at.v0,
                     status_text(job[i].status));
}

enum status study_unstable(struct study *s, const struct monitor *monitor,
                           struct fault *why)
{
    const struct carry none = { .count = 0 };
    struct vec2 target[EQUILIBRIA_MAX];
    struct local_series u;

    if (!slider_has_manifolds(&s->slider))
        return STATUS_OK;
    enum status status = local_series(s, MANIFOLD_UNSTABLE, &none, &u);
    const size_t n = phase_plane_goals(&s->slider.plane, target);
    const struct box window = box_grow(scene_box(s->scene), TOL_WINDOW_MARGIN);
    for (int i = 0; i < SIDES && status == STATUS_OK; i++) {
        struct orbit_options o = orbit_defaults(&s->slider.plane.system,
                                                s->slider.plane.fastest_rate);
        const double t =
            side_sign(&u, (enum side) i) * fmin(u.radius, TOL_SEEN / u.unit);
        o.max_steps = TOL_CURVE_STEPS;
        o.window = &window;
        o.target = target;
        o.targets = n;
        status = orbit_init(&s->unstable[i], &s->slider.plane.system,
                            local_series_at(&u, t), &o);
        if (status == STATUS_OK)
            status = orbit_run(&s->unstable[i], monitor);
        if (status == STATUS_TOO_MANY_STEPS || status == STATUS_NO_CONVERGENCE)
            status = STATUS_OK; /* as far as it got; study_remarks says so */
        s->unstable[i].options.window = NULL; /* they were borrowed from here */
        s->unstable[i].options.target = NULL;
        s->cost[STAGE_UNSTABLE].field_evaluations +=
            s->unstable[i].field_calls + s->unstable[i].jacobian_calls;
    }
    return status != STATUS_OK
               ? fault_set(
                     why, status,
                     "the unstable manifold of the saddle at v = %.6g: %s",
                     s->slider.block.at.v0, status_text(status))
               : status;
}
