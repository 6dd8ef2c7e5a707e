/* Given starts are independent: each thread fills the slots it is given. */
#include "trajectory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "polyline.h"
#include "spread.h"
#include "tolerance.h"
#include "winding.h"
#include "window.h"

/* ---- streamline ---------------------------------------------------------- */

/* Arc length in the drawing instead of time, so that fast and slow motion cost
 * the same; Bogacki & Shampine, Appl. Math. Lett. 2 (1989) 321-325, 3(2).
 * Backward in time an orbit leaves what attracts it: nothing is stiff. */

struct walk {
    const struct planar *system; /* borrowed */
    const struct window *window; /* borrowed */
    size_t evaluations;
};

/* Against the field, of length 1; 0 where it has no direction. */
static struct vec2 walk_way(struct walk *w, struct vec2 unit)
{
    const struct box d = w->system->domain;
    struct vec2 z = window_at(w->window, unit);
    struct planar_field f;

    z.x = fmin(fmax(z.x, d.lo.x), d.hi.x);
    z.y = fmin(fmax(z.y, d.lo.y), d.hi.y);
    w->evaluations++;
    w->system->field(w->system->ctx, vec2_sub(z, w->system->origin), &f);
    const struct vec2 v = window_push(w->window, z, f.direction);
    const double r = vec2_length(v);
    return r > 0.0 && isfinite(r) ? vec2_scale(-1.0 / r, v)
                                  : (struct vec2){ 0.0, 0.0 };
}

static struct vec2 ahead(struct vec2 at, double h, struct vec2 way)
{
    return vec2_add(at, vec2_scale(h, way));
}

/* One step of length h from `at`, where the way is *way, which becomes that at
 * the end; returns by how much it may be off. */
static double walk_step(struct walk *w, struct vec2 at, double h,
                        struct vec2 *way, struct vec2 *to)
{
    const struct vec2 a = *way, b = walk_way(w, ahead(at, h / 2.0, a));
    const struct vec2 c = walk_way(w, ahead(at, 0.75 * h, b));

    *to =
        ahead(ahead(ahead(at, 2.0 / 9.0 * h, a), h / 3.0, b), 4.0 / 9.0 * h, c);
    const struct vec2 d = walk_way(w, *to);
    const struct vec2 off = {
        -5.0 / 72.0 * a.x + b.x / 12.0 + c.x / 9.0 - d.x / 8.0,
        -5.0 / 72.0 * a.y + b.y / 12.0 + c.y / 9.0 - d.y / 8.0
    };
    *way = d;
    return h * vec2_length(off);
}

static bool inside(struct vec2 u)
{
    return u.x >= 0.0 && u.x <= 1.0 && u.y >= 0.0 && u.y <= 1.0;
}

/* Where a straight line from a, inside, to b, outside, meets the frame. */
static struct vec2 at_frame(struct vec2 a, struct vec2 b)
{
    const double from[] = { a.x, a.y }, to[] = { b.x, b.y };
    double part = 1.0, side = 0.0;
    int axis = 0;

    for (int k = 0; k < 2; k++) {
        const double edge = to[k] < 0.0 ? 0.0 : 1.0;
        const double here = (edge - from[k]) / (to[k] - from[k]);
        if ((to[k] < 0.0 || to[k] > 1.0) && here < part) {
            part = here;
            side = edge;
            axis = k;
        }
    }
    struct vec2 u = ahead(a, part, vec2_sub(b, a));
    *(axis ? &u.y : &u.x) = side;
    return u;
}

/* The next step's length, after one of length h that was off by so much. */
static double next_length(double h, double off)
{
    const double wish = 0.9 * cbrt(TOL_DRAWN / fmax(off, 1e-300));

    return fmin(h * fmin(2.0, wish), TOL_STREAMLINE_STEP);
}

/* The orbit through z, inside the window, backward in time: appends its points,
 * unit coordinates of window.h, from z on to the window's edge, exactly, where
 * it came in; or to where it can be followed no further, as beside an
 * equilibrium, or has gone TOL_STREAMLINE_LENGTH sides.  As accurate as a
 * drawing needs, TOL_DRAWN a step; *evaluations of the field are added.
 * STATUS_NO_MEMORY: the points so far are valid. */
static enum status streamline_back(const struct planar *system,
                                   const struct window *window, struct vec2 z,
                                   struct polyline *way, size_t *evaluations)
{
    struct walk w = { system, window, 0 };
    struct vec2 at = window_unit(window, z), along = walk_way(&w, at);
    double h = TOL_STREAMLINE_STEP, gone = 0.0;
    enum status s = polyline_push(way, at);

    while (s == STATUS_OK && inside(at) && gone < TOL_STREAMLINE_LENGTH &&
           h > TOL_DRAWN) {
        struct vec2 then = along, to;
        const double off = walk_step(&w, at, h, &then, &to);
        if (off <= TOL_DRAWN) {
            s = polyline_push(way, inside(to) ? to : at_frame(at, to));
            gone += h;
            at = to;
            along = then;
        }
        h = next_length(h, off);
    }
    *evaluations += w.evaluations;
    return s;
}

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

/* To its end, or until it is a closed orbit as far as numbers tell. */
static enum status run_orbit(struct orbit *o, const struct planar *system,
                             const struct arrival_scale *closes)
{
    struct windings w = windings_begin(o->options.rtol);
    enum status s = STATUS_OK;

    if (closes == NULL)
        return orbit_run(o, NULL);
    while (s == STATUS_OK && o->end == ORBIT_RUNNING &&
           windings_closed(&w, closes) == NULL) {
        s = orbit_step(o);
        if (s == STATUS_OK)
            (void) windings_add(&w, system, closes, &o->curve,
                                o->curve.count - 1, NULL, 0);
    }
    return s;
}

/* Fills everything but t->start. */
static void run_one(const struct planar *system,
                    const struct orbit_options *options,
                    const struct arrival_scale *closes, struct trajectory *t)
{
    struct orbit o;

    t->status =
        orbit_init(&o, system, vec2_sub(t->start, system->origin), options);
    if (t->status == STATUS_OK)
        t->status = run_orbit(&o, system, closes);
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
        run_one(p->system, &p->orbit, p->options->closes, &out->at[i]);
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
