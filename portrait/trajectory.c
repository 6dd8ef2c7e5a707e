/* Given starts are independent: each thread fills the slots it is given. */
#include "trajectory.h"

#include <stdlib.h>
#include <string.h>

#include "spread.h"
#include "streamline.h"
#include "tolerance.h"

struct trajectory_options trajectory_defaults(const struct planar *system,
                                              double kappa)
{
    struct trajectory_options o = {
        .orbit = orbit_defaults(system, kappa),
        .margin = TOL_MARGIN,
    };

    o.orbit.max_steps = TOL_CURVE_STEPS;
    return o;
}

/* Fills everything but t->start. */
static void run_one(const struct planar *system,
                    const struct orbit_options *options, struct trajectory *t)
{
    struct orbit o;

    t->status =
        orbit_init(&o, system, vec2_sub(t->start, system->origin), options);
    if (t->status == STATUS_OK)
        t->status = orbit_run(&o, NULL);
    t->curve = o.curve; /* now ours */
    o.curve = CURVE_EMPTY(o.curve.dim);
    t->end = o.end;
    t->end_index = o.end_index;
    memcpy(t->error, o.error, sizeof t->error);
    t->evaluations = o.field_calls + o.jacobian_calls;
    orbit_free(&o);
}

static bool is_fatal(enum status s)
{
    return s != STATUS_OK && s != STATUS_TOO_MANY_STEPS &&
           s != STATUS_NO_CONVERGENCE;
}

struct plan {
    const struct planar *system;
    const struct trajectory_options *options;
    struct box window; /* enlarged */
    struct orbit_options orbit;
};

/* Orbits out->at[from .. to-1], whose starts are set. */
static enum status run_batch(const struct plan *p, struct trajectories *out,
                             size_t from, size_t to)
{
    if (monitor_tell(p->options->monitor, "trajectories", from, out->count))
        return STATUS_STOPPED;
#pragma omp parallel for schedule(dynamic, 1) if (to - from > 1)
    for (size_t i = from; i < to; i++)
        run_one(p->system, &p->orbit, &out->at[i]);
    for (size_t i = from; i < to; i++) {
        out->evaluations += out->at[i].evaluations;
        if (is_fatal(out->at[i].status))
            return out->at[i].status;
    }
    return STATUS_OK;
}

/* Checks, and makes room for `count`; p must not move afterwards. */
static enum status prepare(struct plan *p, const struct planar *system,
                           const struct window *window, size_t count,
                           const struct trajectory_options *options,
                           struct trajectories *out)
{
    *out = TRAJECTORIES_EMPTY;
    if (window_check(window, system) != STATUS_OK || !(options->margin >= 0.0))
        return STATUS_BAD_ARGUMENT;
    p->system = system;
    p->options = options;
    p->window = window_enlarged(window, system, options->margin);
    p->orbit = options->orbit;
    p->orbit.window = &p->window;
    out->at = calloc(count + 1, sizeof *out->at);
    if (out->at == NULL)
        return STATUS_NO_MEMORY;
    out->count = count;
    return STATUS_OK;
}

/* Hands the result over, or what there is of it back. */
static enum status finish(enum status s, struct trajectories *found,
                          struct trajectories *out)
{
    if (s == STATUS_OK)
        *out = *found;
    else
        trajectory_free(found);
    return s;
}

enum status trajectory_run(const struct planar *system,
                           const struct window *window,
                           const struct vec2 start[], size_t count,
                           const struct trajectory_options *options,
                           struct trajectories *out)
{
    struct trajectories found;
    struct plan p;
    enum status s = prepare(&p, system, window, count, options, &found);

    for (size_t i = 0; s == STATUS_OK && i < count; i++)
        found.at[i].start = start[i];
    for (size_t i = 0; s == STATUS_OK && i < count; i += TOL_MONITOR_STEPS) {
        const size_t left = count - i;
        s = run_batch(
            &p, &found, i,
            i + (left < TOL_MONITOR_STEPS ? left : TOL_MONITOR_STEPS));
    }
    return finish(s, &found, out);
}

/* An orbit through z, from there or from where it comes in; the next ones keep
 * away from all of it. */
static enum status fill_one(const struct plan *p, const struct window *window,
                            struct spread *spread, struct vec2 z,
                            struct trajectories *out, size_t i)
{
    struct trajectory *t = &out->at[i];
    struct polyline way = POLYLINE_EMPTY;
    enum status s =
        streamline_back(p->system, window, z, &way, &out->evaluations);

    if (s == STATUS_OK) {
        t->start =
            p->options->halfway ? z : window_at(window, way.at[way.count - 1]);
        spread_avoid_way(spread, &way);
        s = run_batch(p, out, i, i + 1);
        spread_avoid(spread, &t->curve, p->system->origin);
    }
    polyline_free(&way);
    return s;
}

/* One after another: each keeps away from all before it. */
static enum status fill(const struct plan *p, const struct window *window,
                        struct spread *spread, struct trajectories *out)
{
    const struct trajectory_options *o = p->options;
    enum status s = STATUS_OK;

    for (size_t k = 0; k < o->drawn_count; k++)
        spread_avoid(spread, o->drawn[k].curve, o->drawn[k].origin);
    for (size_t i = 0; s == STATUS_OK && i < out->count; i++) {
        struct vec2 z = { 0.0, 0.0 };
        (void) spread_take(spread, &z); /* never runs out */
        s = fill_one(p, window, spread, z, out, i);
    }
    return s;
}

enum status trajectory_spread(const struct planar *system,
                              const struct window *window, size_t count,
                              const struct trajectory_options *options,
                              struct trajectories *out)
{
    struct trajectories found;
    struct spread spread;
    struct plan p;
    enum status s = prepare(&p, system, window, count, options, &found);

    if (s == STATUS_OK)
        s = spread_init(&spread, window, TOL_PORTRAIT_CANDIDATES * count,
                        options->seed);
    if (s == STATUS_OK) {
        s = fill(&p, window, &spread, &found);
        spread_free(&spread);
    }
    return finish(s, &found, out);
}

void trajectory_free(struct trajectories *t)
{
    for (size_t i = 0; i < t->count; i++)
        curve_free(&t->at[i].curve);
    free(t->at);
    *t = TRAJECTORIES_EMPTY;
}
