#include "course.h"

#include <math.h>

#include "motion_tolerance.h"
#include "near_cut.h"
#include "rest_form.h"

bool course_is_limited(const struct transient_options *o)
{
    return o->until_time > 0.0 || o->until_slip > 0.0;
}

/* Without limits of the scene's, where the fate itself never ends: some powers
 * of ten from start and saddle. */
static struct box window_of(const struct course *c, bool limited)
{
    const double saddle = c->slider->plane.system.origin.x;
    const double start = saddle + c->start.x;
    struct box w = c->slider->plane.system.domain;

    if (!limited && c->fate == FATE_RUNAWAY)
        w.hi.x = fmin(w.hi.x, fmax(start, saddle) + log(TOL_TRANSIENT_FAST));
    if (!limited && c->fate == FATE_REST_ASYMPTOTIC)
        w.lo.x = fmax(w.lo.x,
                      fmin(start, saddle) + c->depth * log(TOL_TRANSIENT_SLOW));
    return w;
}

void course_set(struct course *c, const struct transient_options *o, bool rest)
{
    const struct block *b = &c->slider->block;
    const bool goes_on = course_is_limited(o);

    c->rest = rest && rest_form_at(b).fate == FATE_REST_FINITE;
    moment_watch_all(&c->watches, c->slider, o->level, o->levels, !goes_on);
    c->start_window = window_of(c, goes_on);
    c->options =
        orbit_defaults(&c->slider->plane.system, c->slider->plane.fastest_rate);
    c->options.observables = BLOCK_EXCESS; /* slip and work */
    c->options.window = &c->window;
    c->options.event = c->watches.event;
    c->options.events = c->watches.count;
    if (o->until_time > 0.0)
        c->options.reach[0] = o->until_time;
    if (o->until_slip > 0.0)
        c->options.reach[1 + BLOCK_SLIP] = o->until_slip;
}

/* d ln v/dt at the end, by the last step: in the field there may be nothing
 * left of it but rounding. */
static double end_rate(const struct orbit *o)
{
    double du[CURVE_DIM_MAX];

    curve_slope_at(&o->curve, o->curve.count - 1, 1.0, du);
    return fabs(du[0] / du[2]);
}

/* Whether a part of what an orbit may be off by makes all of its rates. */
static bool is_loose(const struct orbit *o)
{
    struct cascade_linear l;
    double most = 0.0;

    rescaled_linear(&o->clock, (struct vec2){ o->u[0], o->u[1] }, &l);
    for (int i = 0; i < 2; i++)
        most = fmax(most, fabs(l.slope[i].x) + fabs(l.slope[i].y));
    return !(TOL_FAR_BELOW * o->options.rtol * most < hypot(l.du[0], l.du[1]));
}

/* Whether hardly anything is left of v or of the time, or what is cannot be
 * seen: psi itself, where only inertia slows the block, is too large for its
 * digits, or it is where it may be with any rate, not of first order. */
static bool is_deep(const struct course *c, const struct orbit *o)
{
    const struct block *b = &c->slider->block;

    return c->slider->plane.system.origin.x + o->u[0] < TOL_TRANSIENT_DEEP ||
           (o->curve.count > 0 && end_rate(o) * TOL_NOTHING * o->u[2] > 1.0) ||
           (law_psi_is_log(&b->law) && rest_form_at(b).inertial) ||
           (b->waits && is_loose(o));
}

bool course_rests(const struct course *c, const struct orbit *o,
                  struct rest_left *left)
{
    const double *reach = o->options.reach;

    return c->rest && o->end == ORBIT_RUNNING && is_deep(c, o) &&
           rest_left_find(c->slider, (struct vec2){ o->u[0], o->u[1] }, o->u[2],
                          left) &&
           o->u[2] + left->time < reach[0] &&
           o->u[3 + BLOCK_SLIP] + left->slip < reach[1 + BLOCK_SLIP];
}

bool course_waits(const struct orbit *o)
{
    const double *reach = o->options.reach;

    return !(reach[0] < TOL_RANGE) && isinf(reach[1 + BLOCK_SLIP]) &&
           o->steps > 0 && o->du[0] == 0.0 && o->du[1] == 0.0;
}

/* A block that has risen from far below fades where others do. */
static void set_floor(struct course *c, const struct orbit *o)
{
    const double floor = c->depth * log(TOL_TRANSIENT_SLOW);
    const bool is_endless =
        isinf(c->options.reach[0]) && isinf(c->options.reach[1 + BLOCK_SLIP]);

    if (c->fate == FATE_REST_ASYMPTOTIC && is_endless && o->u[0] > floor)
        c->window.lo.x =
            fmax(c->window.lo.x, c->slider->plane.system.origin.x + floor);
}

/* orbit_run, which also ends where it rests, or before its side matters. */
static enum status run_orbit(struct course *c, struct orbit *o,
                             const struct monitor *monitor)
{
    enum status s = STATUS_OK;
    struct rest_left left;

    while (s == STATUS_OK && o->end == ORBIT_RUNNING && !course_waits(o) &&
           !course_rests(c, o, &left)) {
        s = orbit_step(o);
        set_floor(c, o);
        if (o->steps % TOL_MONITOR_STEPS == 0 &&
            monitor_tell(monitor, "orbit", o->steps, 0))
            s = STATUS_STOPPED;
        if (c->near && near_cut_is_due(o)) {
            near_cut_back(o);
            break;
        }
    }
    return s;
}

enum status course_follow(struct course *c, double rtol,
                          const struct monitor *monitor, struct drift *drift,
                          struct orbit *out)
{
    const struct phase_plane *plane = &c->slider->plane;
    struct orbit_options options = c->options;

    drift_start(drift, slider_rounding(c->slider, c->start),
                phase_plane_leaving_rate(plane));
    options.drift = drift;
    c->window = c->start_window;
    options.rtol = rtol;
    enum status s = orbit_init(out, &plane->system, c->start, &options);
    if (s == STATUS_OK)
        s = run_orbit(c, out, monitor);
    return s == STATUS_NO_CONVERGENCE || s == STATUS_TOO_MANY_STEPS ? STATUS_OK
                                                                    : s;
}
