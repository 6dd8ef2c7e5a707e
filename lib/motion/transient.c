/* Two orbits by orbit.h, the second ten times finer, which is what is kept.
 * Measured on the runs of Figs 14, 15: at 1e-11 times of events are good to
 * 1e-12, |mu - tan(alpha)| being 1e-7 to 3e-10; below 3e-13 to rounding. */
#include "transient.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "course.h"
#include "motion_tolerance.h"
#include "rest_form.h"
#include "rest_left.h"
#include "timeline.h"

static const struct moment_level near_tan[] = {
    { MOMENT_MU_NEARS, 1e-1 }, { MOMENT_MU_NEARS, 1e-2 },
    { MOMENT_MU_NEARS, 1e-3 }, { MOMENT_MU_NEARS, 1e-4 },
    { MOMENT_MU_NEARS, 1e-5 }, { MOMENT_MU_NEARS, 1e-6 },
    { MOMENT_MU_NEARS, 1e-7 },
};

struct transient_options transient_defaults(const struct scene *c)
{
    return (struct transient_options){
        .until_time = c->until_time,
        .until_slip = c->until_slip,
        .rtol = c->rtol,
        .level = near_tan,
        .levels = sizeof near_tan / sizeof *near_tan,
    };
}

static double finest(double rtol)
{
    return fmin(fmax(rtol / TOL_FINER, TOL_TRANSIENT_FINEST), TOL_COARSEST);
}

/* Whether the fate is a rest, for all that is known: between the points of a
 * long step another run may seem to rest. */
static bool may_rest(enum fate fate)
{
    return fate == FATE_REST_FINITE || fate == FATE_REST_ASYMPTOTIC ||
           fate == FATE_UNDECIDED;
}

/* ---- what came of it ----------------------------------------------------- */

static enum transient_end end_of(const struct course *c, const struct orbit *o)
{
    struct rest_left left;

    if (o->end == ORBIT_EVENT)
        return TRANSIENT_ARREST;
    if (course_rests(c, o, &left))
        return TRANSIENT_REST;
    if (o->end == ORBIT_REACHED && fabs(o->u[2]) < TOL_RANGE)
        return o->end_index == 0 ? TRANSIENT_UNTIL_TIME : TRANSIENT_UNTIL_SLIP;
    if (o->end == ORBIT_LEFT_WINDOW && c->fate == FATE_RUNAWAY)
        return TRANSIENT_RUNAWAY;
    if (o->end == ORBIT_LEFT_WINDOW && c->fate == FATE_REST_ASYMPTOTIC)
        return TRANSIENT_FADED;
    return TRANSIENT_LOST;
}

static enum fate fate_at(const struct course *c, const struct orbit *o,
                         enum transient_end end)
{
    const struct equilibrium *node =
        moment_node_at(c->slider, (struct vec2){ o->u[0], o->u[1] },
                       TOL_TRANSIENT_REACH * TOL_ARREST);

    if (end == TRANSIENT_REST && c->fate != FATE_REST_ASYMPTOTIC)
        return FATE_REST_FINITE;
    return end == TRANSIENT_ARREST && node ? fate_of_node(c->slider, node)
                                           : c->fate;
}

/* Bar of component i of an orbit where it ended: at a face of a box of arrest,
 * at a limit, or on its way. */
static double bar_of(const struct course *c, const struct orbit *o,
                     enum transient_end end, size_t i)
{
    const struct drift *d = o->options.drift;
    const struct vec2 z = { o->u[0], o->u[1] };
    const struct equilibrium *node =
        moment_node_at(c->slider, z, TOL_TRANSIENT_REACH * TOL_ARREST);
    const double *du = d->du;

    if (o->curve.count == 0)
        return 0.0;
    if (end == TRANSIENT_UNTIL_TIME)
        return drift_bar_at(d, 2, i);
    if (end == TRANSIENT_UNTIL_SLIP)
        return drift_bar_at(d, 3 + BLOCK_SLIP, i);
    if (end != TRANSIENT_ARREST || node == NULL)
        return drift_bar(d, rest_left_section(c->slider), i);
    const struct vec2 at = vec2_sub(node->z, c->slider->plane.system.origin);
    const struct vec2 face = fate_face(z, at);
    const double closing = face.x * du[0] + face.y * du[1];
    return drift_bar(d, face, i) +
           fabs(du[i] / closing) * slider_rounding(c->slider, z);
}

/* Of the run to the end of an orbit, with what is left of a rest. */
struct totals {
    struct quantity time, slip, mean;
};

static struct quantity total_of(const struct course *c, const struct orbit *o,
                                enum transient_end end, size_t i, double left,
                                double left_error)
{
    const double sum = o->u[i] + left;

    return quantity_of(sum, bar_of(c, o, end, i) + left_error +
                                TOL_ROUNDINGS * DBL_EPSILON * fabs(sum));
}

static const char limit_unknown[] =
    "the orbit could not be followed to its end";

/* A run that fades to a limit: of its slip, and of nothing else. */
static struct totals limits_of(const struct course *c, const struct orbit *o)
{
    static const char never[] = "the block never quite stops";
    static const char unbounded[] = "the slip grows without bound";
    const struct vec2 z = { o->u[0], o->u[1] };
    struct totals all = { .time = quantity_none(never) };
    struct rest_left left;

    if (!rest_form_at(&c->slider->block).has_slip)
        all.slip = quantity_none(unbounded);
    else if (!rest_left_find(c->slider, z, o->u[2], &left))
        all.slip = quantity_none(limit_unknown);
    else
        all.slip = total_of(c, o, TRANSIENT_REST, 3 + BLOCK_SLIP, left.slip,
                            left.slip_error);
    all.mean = fate_mean_friction(c->slider, c->v, 0.0, 0.0, &all.slip);
    return all;
}

static struct totals totals_of(const struct course *c, const struct orbit *o)
{
    const struct block *b = &c->slider->block;
    const enum transient_end end = end_of(c, o);
    struct rest_left left = { .time = 0.0 };
    const bool rest = course_rests(c, o, &left);
    const double v1 = rest ? 0.0 : block_v(b, o->u[0]);
    struct totals all;

    if (end == TRANSIENT_FADED)
        return limits_of(c, o);
    if (end == TRANSIENT_RUNAWAY)
        return (struct totals){ .time = quantity_none(fate_runs_away),
                                .slip = quantity_none(fate_runs_away),
                                .mean = quantity_none(fate_runs_away) };
    all.time = total_of(c, o, end, 2, left.time, left.time_error);
    all.slip = total_of(c, o, end, 3 + BLOCK_SLIP, left.slip, left.slip_error);
    all.mean = fate_mean_friction(c->slider, c->v, v1, bar_of(c, o, end, 0),
                                  &all.slip);
    return all;
}

/* Of the whole run. */
static void sum_up(const struct course *c, const struct orbit *coarse,
                   const struct orbit *fine, struct transient_summary *sum)
{
    const struct totals b = totals_of(c, coarse), a = totals_of(c, fine);

    sum->time = fate_compare(&b.time, &a.time);
    sum->slip = fate_compare(&b.slip, &a.slip);
    sum->mu_mean = fate_compare(&b.mean, &a.mean);
    sum->energy_defect = fine->curve.count > 0
                             ? slider_energy_defect(c->slider, &fine->curve)
                             : 0.0;
}

/* A run that arrest ends is as long as it takes until then. */
static void hold_end(struct transient *t)
{
    const struct transient_summary *sum = &t->sum;

    for (size_t i = t->events; sum->end == TRANSIENT_ARREST && i-- > 0;)
        if (t->event[i].what == MOMENT_ARREST) {
            t->event[i].time = sum->time;
            t->event[i].slip = sum->slip;
            return;
        }
}

/* The last event: v = 0 itself. */
static void add_rest(struct transient *t)
{
    const struct quantity none =
        quantity_none("grows without bound as v falls to 0");

    if (t->sum.end == TRANSIENT_REST)
        t->event[t->events++] =
            (struct transient_event){ .what = MOMENT_REST,
                                      .level = (double) NAN,
                                      .time = t->sum.time,
                                      .slip = t->sum.slip,
                                      .v = quantity_of(0.0, 0.0),
                                      .psi = none,
                                      .mu = none };
}

static void refuse(struct transient *t, const char *reason)
{
    t->reason = reason;
    t->sum.time = t->sum.slip = t->sum.mu_mean = quantity_none(reason);
}

/* Whether it has not got away from the saddle: it never will. */
static bool is_stuck(const struct course *c, const struct orbit *o)
{
    return slider_saddle(c->slider) >= 0 && fabs(o->u[0]) < TOL_ARREST &&
           fabs(o->u[1]) < TOL_ARREST;
}

/* Why an orbit is lost; whether another one would be, too, however exact. */
static const char *why_lost(const struct orbit *o, bool *surely)
{
    const bool is_late = o->end == ORBIT_REACHED || course_waits(o);
    const bool is_far = fmax(fabs(o->u[3 + BLOCK_SLIP]),
                             fabs(o->u[3 + BLOCK_WORK])) > TOL_RANGE;

    *surely = o->end != ORBIT_RUNNING || is_late || is_far;
    return o->end == ORBIT_LEFT_WINDOW || o->end == ORBIT_LEFT_DOMAIN
               ? "the orbit leaves the plane"
           : is_late ? "it takes longer than any number holds"
           : is_far  ? "it slips further than any number holds"
                     : "the orbit cannot be followed further";
}

/* Whether it is settled: both orbits end in the same way, on the side of the
 * separatrix that they started on. */
static bool judge(const struct course *c, const struct orbit *coarse,
                  const struct orbit *fine, struct transient *t)
{
    static const char unclear[] =
        "orbits of two tolerances end in different ways";
    static const char near[] =
        "the state is too near the boundary for its orbit to be followed";
    struct transient_summary *sum = &t->sum;
    const enum transient_end end = end_of(c, fine);
    const enum fate shown = fate_at(c, fine, end);
    const bool known = c->fate != FATE_UNDECIDED;
    const bool is_lost = end == TRANSIENT_LOST;
    bool surely;
    const char *lost = why_lost(fine, &surely);
    const bool is_near =
        (known && shown != c->fate) || (is_lost && is_stuck(c, fine));
    const bool agree =
        end_of(c, coarse) == end && fate_at(c, coarse, end) == shown;

    sum->end = (int8_t) (is_near ? TRANSIENT_NEAR : end);
    sum->fate = (int8_t) (known ? c->fate : agree ? shown : FATE_UNDECIDED);
    sum->steps = (int64_t) fine->steps;
    sum->field_evaluations =
        (int64_t) (coarse->field_calls + coarse->jacobian_calls +
                   fine->field_calls + fine->jacobian_calls);
    sum_up(c, coarse, fine, sum);
    hold_end(t);
    add_rest(t);
    if (sum->fate != FATE_UNDECIDED || is_lost)
        t->reason = is_lost ? lost : NULL;
    if (!agree || is_near)
        refuse(t, is_near ? near : unclear);
    return agree && !is_near && (!is_lost || surely);
}

/* Both orbits, to what they say. */
static enum status run_at(struct course *c, double rtol,
                          const struct monitor *monitor, struct transient *out,
                          bool *settled)
{
    struct orbit coarse = { .steps = 0 }, fine = { .steps = 0 };
    struct drift drift[2];
    enum status s =
        course_follow(c, rtol / TOL_FINER, monitor, &drift[0], &coarse);

    if (s == STATUS_OK)
        s = course_follow(c, rtol, monitor, &drift[1], &fine);
    if (s == STATUS_OK)
        s = timeline_find(c->slider, &c->watches, &coarse, &fine, &out->event,
                          &out->events);
    if (s == STATUS_OK) {
        *settled = judge(c, &coarse, &fine, out);
        record_settle(&record_transient, &out->sum, 1);
        record_settle(&record_transient_event, out->event, out->events);
        out->curve = fine.curve; /* now theirs */
        fine.curve = CURVE_EMPTY(fine.curve.dim);
    }
    orbit_free(&coarse);
    orbit_free(&fine);
    return s;
}

/* The next tolerance to try after rtol: looser ones, for where the field is
 * rounding, as deep on slow curves, they go further; then finer ones to a rest,
 * for a loose one may leave a slow curve on which rates change over less than
 * that.  0: there is no other. */
static double next_rtol(enum fate fate, double first, double rtol)
{
    if (rtol >= first && rtol < TOL_COARSEST)
        return fmin(TOL_RETRY * rtol, TOL_COARSEST);
    const double finer = fmin(rtol, first) / TOL_RETRY;
    return fate == FATE_REST_FINITE && finer >= TOL_TRANSIENT_FINEST ? finer
                                                                     : 0.0;
}

static enum status run(struct course *c, const struct transient_options *o,
                       const struct monitor *monitor, struct transient *out)
{
    const struct transient empty = *out;
    const double first = finest(o->rtol);
    double rtol = first;
    bool settled = false;

    course_set(c, o, may_rest(c->fate));
    enum status s = run_at(c, rtol, monitor, out, &settled);
    while (s == STATUS_OK && !settled && out->sum.end != TRANSIENT_NEAR &&
           (rtol = next_rtol(c->fate, first, rtol)) > 0.0) {
        transient_free(out);
        *out = empty;
        course_set(c, o, true); /* the fate may have been wrong */
        s = run_at(c, rtol, monitor, out, &settled);
    }
    return s;
}

/* Where the limit of a run that fades is not known yet, it is followed down to
 * where it is: v falls by twice as many powers of ten each time, along an orbit
 * that is finer each time, for a loose one may leave its slow curve. */
static enum status deepen(struct course *c, const struct transient_options *o,
                          const struct monitor *monitor, struct transient *out)
{
    const struct transient_summary start = { .v = out->sum.v,
                                             .psi = out->sum.psi };
    enum status s = STATUS_OK;
    double rtol = finest(o->rtol);

    while (s == STATUS_OK && out->sum.end == TRANSIENT_FADED &&
           out->sum.slip.reason == limit_unknown &&
           c->window.lo.x > c->slider->plane.system.domain.lo.x) {
        struct transient deeper = { .sum = start };
        bool settled = false;
        c->depth *= 2;
        course_set(c, o, false);
        rtol = fmax(rtol / TOL_RETRY, TOL_TRANSIENT_FINEST);
        s = run_at(c, rtol, monitor, &deeper, &settled);
        if (s == STATUS_OK && settled && quantity_exists(&deeper.sum.slip)) {
            transient_free(out);
            *out = deeper;
        } else {
            transient_free(&deeper);
        }
    }
    return s;
}

/* Nothing to follow: the start is where blocks are arrested. */
static bool is_there(const struct course *c, const struct transient_options *o,
                     struct transient_summary *sum)
{
    const struct equilibrium *node =
        moment_node_at(c->slider, c->start, TOL_ARREST);

    if (node == NULL || course_is_limited(o) ||
        fate_of_node(c->slider, node) != c->fate)
        return false;
    sum->end = TRANSIENT_ARREST;
    sum->time = sum->slip = quantity_of(0.0, 0.0);
    sum->mu_mean = quantity_none("no slip in this run");
    return true;
}

void transient_free(struct transient *t)
{
    free(t->event);
    curve_free(&t->curve);
    *t = (struct transient){ .event = NULL };
}

/* As far as both sides of the separatrix share it; the run has no numbers. */
static enum status run_near(struct course *c, const struct transient_options *o,
                            const struct fate_told *told, const char *reason,
                            const struct monitor *monitor,
                            struct transient *out)
{
    struct transient empty = { .sum = { .v = c->v, .psi = out->sum.psi } };
    bool settled;

    transient_free(out);
    *out = empty;
    c->near = true;
    course_set(c, o, false);
    const enum status s = run_at(c, finest(o->rtol), monitor, out, &settled);
    out->sum.fate = told->fate;
    out->sum.end = TRANSIENT_NEAR;
    refuse(out, reason);
    return s;
}

static enum status find(struct course *c, const struct transient_options *o,
                        const struct fate_told *told,
                        const struct monitor *monitor, struct transient *out)
{
    const bool is_near = told->is_near && !course_is_limited(o);
    enum status s = STATUS_OK;

    c->fate = (enum fate) told->fate;
    out->sum.fate = told->fate;
    out->reason = told->reason;
    if (!is_near && !is_there(c, o, &out->sum))
        s = run(c, o, monitor, out);
    if (s == STATUS_OK)
        s = deepen(c, o, monitor, out);
    if (s == STATUS_OK && (is_near || out->sum.end == TRANSIENT_NEAR))
        s = run_near(c, o, told, out->reason, monitor, out);
    if (s == STATUS_OK)
        phase_find(c->slider, out, out->phase);
    return s;
}

enum status transient_find(const struct slider *s, struct scene_start start,
                           const struct transient_options *options,
                           const struct monitor *monitor, struct transient *out)
{
    const struct vec2 z = { log(start.v), s->plane.system.axis[1].is_log
                                              ? log(start.psi)
                                              : start.psi };
    const struct vec2 near = block_offset(&s->block, start.v, start.psi);
    struct course c = { .slider = s,
                        .depth = 1,
                        .v = start.v,
                        .start = vec2_sub(z, s->plane.system.origin) };
    struct fate_told told;

    *out = (struct transient){ .sum = { .v = start.v, .psi = start.psi } };
    if (!box_holds(s->plane.system.domain, z))
        return STATUS_BAD_ARGUMENT;
    if (vec2_length(near) < 1.0) /* to more digits */
        c.start = near;
    enum status status =
        options->labels
            ? labels_find(options->labels, near, monitor, &told)
            : labels_find_one(s, near, options->rtol, monitor, &told);
    if (status == STATUS_OK)
        status = find(&c, options, &told, monitor, out);
    if (status != STATUS_OK)
        transient_free(out);
    return status;
}
