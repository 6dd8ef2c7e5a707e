/* One orbit by orbit.h until it arrives, leaves the domain, outlives the
 * doubles or falls onto the curve along which a block comes to rest; what its
 * end means follows from where it is.  What is left of a rest is an integral
 * (rest_left.h): deep down an orbit would see the rounding of mu - tan(alpha)
 * only. */
#include "fate.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "moment.h"
#include "motion_tolerance.h"
#include "rest_form.h"
#include "rest_left.h"
#include "slider.h"

const char *const fate_names[] = { "creep",       "sliding",
                                   "rest_finite", "rest_asymptotic",
                                   "runaway",     "undecided",
                                   NULL };

const char fate_runs_away[] = "the block runs away";

enum fate fate_of_node(const struct slider *s, const struct equilibrium *e)
{
    const struct planar_steady *curve = s->plane.system.steady;
    const double x = e->z.x;

    if (curve->turnings == 0)
        return x <= 0.0 ? FATE_CREEP : FATE_SLIDING;
    return x <= (double) curve->turning[0] ? FATE_CREEP : FATE_SLIDING;
}

/* Where orbits arrive: every steady state but the saddle. */
struct goals {
    struct vec2 at[EQUILIBRIA_MAX];
    enum fate fate[EQUILIBRIA_MAX];
    size_t count;
};

static struct goals goals_of(const struct slider *s)
{
    struct goals g = { .count = 0 };

    for (size_t i = 0; i < s->plane.equilibria; i++) {
        if (s->plane.equilibrium[i].type == EQUILIBRIUM_SADDLE)
            continue;
        g.at[g.count] = phase_plane_offset(&s->plane, i);
        g.fate[g.count++] = fate_of_node(s, &s->plane.equilibrium[i]);
    }
    return g;
}

/* The slowest time scale of the steady states, 1 (t*), and the time in which a
 * friction of order 1 stops a block at the offset x. */
static double slow_time(const struct slider *s, double x)
{
    const double stop =
        material_eps2(&s->block.material) * s->block.at.v0 * exp(x);
    double slowest = fmax(stop, 1.0);

    for (size_t i = 0; i < s->plane.equilibria; i++)
        for (int k = 0; k < 2; k++)
            slowest =
                fmax(slowest, 1.0 / fabs(s->plane.equilibrium[i].lambda[k]));
    return fmin(slowest, TOL_RANGE / TOL_FATE_LATE);
}

/* Of a block that stops, or all but does: a law's matter. */
static enum fate fate_at_rest(const struct slider *s)
{
    const enum fate fate = rest_form_at(&s->block).fate;

    return fate == FATE_CREEP ? FATE_UNDECIDED : fate;
}

/* Whether it has left the domain, or every scale. */
static bool is_beyond(const struct orbit *o)
{
    return o->end == ORBIT_LEFT_DOMAIN || o->end == ORBIT_REACHED;
}

/* Of an orbit so far. */
struct past {
    struct drift drift; /* how far off it is */
    bool fell;          /* it has been where nothing holds v above 0 */
    bool rests;         /* and what is left of it is known: */
    struct rest_left left;
};

/* In the quadrant v > v_sp, psi < psi_sp, which cannot be left (trap.h), and
 * without a node in it: nothing bounds v. */
static bool runs_away(const struct slider *s, const struct orbit *o)
{
    if (!slider_traps(s) || !(o->u[0] > 0.0 && o->u[1] < 0.0))
        return false;
    return (size_t) slider_saddle(s) + 1 == s->plane.equilibria;
}

/* In the quadrant v < v_sp, psi > psi_sp, which cannot be left either, and
 * without a node in it: nothing holds v above 0. */
static bool falls(const struct slider *s, const struct orbit *o)
{
    return slider_traps(s) && slider_saddle(s) == 0 && o->u[0] < 0.0 &&
           o->u[1] > 0.0;
}

/* The power of time that v follows over the last part of the time: the rates
 * at the end of an orbit are mostly rounding.  NaN where it has no such past,
 * or no normal number for the time. */
static double power_of_time(const struct orbit *o)
{
    double u[CURVE_DIM_MAX];

    for (size_t i = o->curve.count; i-- > 0;) {
        curve_at(&o->curve, i, 0.0, u);
        if (u[2] <= TOL_LITTLE * o->u[2])
            return o->u[2] > DBL_MIN
                       ? (o->u[0] - u[0]) / log(o->u[2] / fmax(u[2], DBL_MIN))
                       : (double) NAN;
    }
    return (double) NAN;
}

/* An orbit that has left every scale: v -> inf or v -> 0 like a power of
 * time, or faster. */
static enum fate fate_beyond(const struct slider *s, const struct orbit *o)
{
    const double power = power_of_time(o);

    return power > TOL_FAR_BELOW    ? FATE_RUNAWAY
           : power < -TOL_FAR_BELOW ? fate_at_rest(s)
                                    : FATE_UNDECIDED;
}

/* What becomes of it does not hang on how far it was followed. */
static enum fate fate_at_end(const struct slider *s, const struct goals *g,
                             const struct orbit *o, const struct past *past)
{
    if (past->fell || past->rests)
        return fate_at_rest(s);
    if (o->end == ORBIT_ARRIVED)
        return g->fate[o->end_index];
    if (runs_away(s, o))
        return FATE_RUNAWAY;
    return is_beyond(o) ? fate_beyond(s, o) : FATE_UNDECIDED;
}

static const char *reason_of(const struct slider *s, const struct past *past,
                             enum fate fate)
{
    if (fate != FATE_UNDECIDED)
        return NULL;
    return past->fell ? rest_form_at(&s->block).reason
                      : "the orbit could not be followed to an end";
}

struct quantity fate_mean_friction(const struct slider *s, double v0, double v1,
                                   double v1_part, const struct quantity *slip)
{
    if (!quantity_exists(slip))
        return *slip;
    if (!(slip->value > 0.0))
        return quantity_none("no slip before arrest");
    if (!(slip->value > slip->error))
        return quantity_none("the slip is not known well enough");
    return slider_mean_friction(s, v0, v1, v1_part, slip);
}

/* What is left where psi has left the plane while v still falls: the friction
 * there, which hardly changes, stops the block by inertia alone; known to
 * within itself. */
static struct rest_left left_beyond(const struct slider *s,
                                    const struct orbit *o)
{
    const struct vec2 z = { o->u[0], o->u[1] };
    const double power = rest_form_at(&s->block).power;
    const double v = block_v(&s->block, z.x);
    const double time = power * exp(z.x - s->block.at.log_inertia) /
                        moment_excess_friction(s, z);
    const double slip = v * time / (1.0 + power);

    return (struct rest_left){
        .time = time, .slip = slip, .time_error = time, .slip_error = slip
    };
}

/* Why it has neither time nor slip; NULL: it may have. */
static const char *why_endless(const struct slider *s, const struct orbit *o,
                               const struct past *past, enum fate fate)
{
    if (fate == FATE_RUNAWAY)
        return fate_runs_away;
    if (fate == FATE_UNDECIDED)
        return "the fate is undecided";
    return o->end == ORBIT_ARRIVED || past->rests ||
                   (is_beyond(o) && fate == FATE_REST_FINITE &&
                    moment_excess_friction(
                        s, (struct vec2){ o->u[0], o->u[1] }) > 0.0)
               ? NULL
               : "the orbit could not be followed to its end";
}

/* Where an orbit ends: a face of a box of arrest, known to its rounding, or
 * somewhere along its way. */
struct ending {
    struct vec2 gradient;
    double level;
    const struct drift *drift;
};

static struct ending end_of(const struct slider *s, const struct orbit *o,
                            const struct past *past)
{
    const struct vec2 z = { o->u[0], o->u[1] };
    struct ending e = { .drift = &past->drift };

    if (o->curve.count == 0)
        return e;
    e.gradient = rest_left_section(s);
    if (o->end != ORBIT_ARRIVED)
        return e;
    e.gradient = fate_face(z, o->options.target[o->end_index]);
    e.level = slider_rounding(s, z);
    return e;
}

/* Bar of a component where the orbit ends. */
static double bar_at(const struct ending *e, size_t i)
{
    const double *du = e->drift->du;
    const double speed = e->gradient.x * du[0] + e->gradient.y * du[1];

    if (speed == 0.0) /* it did not move */
        return 0.0;
    return drift_bar(e->drift, e->gradient, i) + fabs(du[i] / speed) * e->level;
}

/* A sum along the orbit, with what is left. */
static struct quantity sum_of(const struct orbit *o, const struct ending *e,
                              size_t i, double left, double left_error)
{
    const double sum = o->u[i] + left;

    return quantity_of(sum, bar_at(e, i) + left_error +
                                TOL_ROUNDINGS * DBL_EPSILON * fabs(sum) +
                                TOL_VANISHING);
}

static void observe_end(const struct slider *s, double v0,
                        const struct orbit *o, const struct past *past,
                        struct fate_result *out)
{
    const char *why = why_endless(s, o, past, out->fate);
    const bool beyond = out->fate == FATE_REST_FINITE && !past->rests;
    const struct rest_left left = beyond ? left_beyond(s, o) : past->left;
    const bool arrived = o->end == ORBIT_ARRIVED;
    static const char never[] = "the block never quite stops";
    static const char unbounded[] = "the slip grows without bound";

    if (why) {
        out->slip = out->time = out->mu_mean = quantity_none(why);
        return;
    }
    const struct ending e = end_of(s, o, past);
    out->time = isinf(left.time) ? quantity_none(never)
                                 : sum_of(o, &e, 2, left.time, left.time_error);
    if (isinf(left.slip)) {
        out->slip = out->mu_mean = quantity_none(unbounded);
        return;
    }
    out->slip = sum_of(o, &e, 3 + BLOCK_SLIP, left.slip, left.slip_error);
    out->mu_mean =
        fate_mean_friction(s, v0, arrived ? block_v(&s->block, o->u[0]) : 0.0,
                           arrived ? bar_at(&e, 0) + e.level : 0.0, &out->slip);
}

static void note(const struct slider *s, const struct orbit *o,
                 struct past *past)
{
    past->fell = past->fell || falls(s, o);
    past->rests = rest_left_find(s, (struct vec2){ o->u[0], o->u[1] }, o->u[2],
                                 &past->left);
}

/* orbit_run, which also ends where the block runs away or what is left of its
 * rest is known; unless `observe`, as soon as its fate is; and where rounding
 * throws it out of a quadrant that cannot be left. */
static enum status run(const struct slider *s, struct orbit *o, bool observe,
                       const struct monitor *monitor, struct past *past)
{
    enum status status = STATUS_OK;

    note(s, o, past);
    while (status == STATUS_OK && o->end == ORBIT_RUNNING && !past->rests &&
           !runs_away(s, o) && (!past->fell || (observe && falls(s, o)))) {
        status = orbit_step(o);
        note(s, o, past);
        if (o->steps % TOL_MONITOR_STEPS == 0 &&
            monitor_tell(monitor, "orbit", o->steps, 0))
            status = STATUS_STOPPED;
    }
    return status;
}

void fate_least(const struct slider *s, struct vec2 z, double least[])
{
    const bool may_rest = (slider_saddle(s) == 0 || s->plane.equilibria == 0) &&
                          fate_at_rest(s) == FATE_REST_FINITE;
    const double v = block_v(&s->block, z.x);
    const double eps2 = material_eps2(&s->block.material);
    const double stop = may_rest ? TOL_LITTLE * eps2 * v : 0.0;

    least[0] = fmin(stop, DBL_MAX);
    least[1 + BLOCK_SLIP] = fmin(stop * v, DBL_MAX);
    least[1 + BLOCK_WORK] = least[1 + BLOCK_SLIP];
}

/* Follows the orbit from the offset z; *last: where it ended. */
static enum status follow(const struct slider *s, struct vec2 z, double rtol,
                          bool observe, const struct monitor *monitor,
                          struct fate_result *out, struct vec2 *last)
{
    const struct goals goals = goals_of(s);
    struct orbit_options options =
        orbit_defaults(&s->plane.system, s->plane.fastest_rate);
    struct orbit o;
    struct past past = { .fell = false };

    options.rtol = rtol;
    options.observables = observe ? BLOCK_EXCESS : 0;
    options.target = goals.at;
    options.targets = goals.count;
    options.arrival = TOL_ARREST;
    options.reach[0] = TOL_FATE_LATE * slow_time(s, z.x);
    options.drift = observe ? &past.drift : NULL;
    drift_start(&past.drift, slider_rounding(s, z),
                phase_plane_leaving_rate(&s->plane));
    fate_least(s, z, options.least);
    *out = (struct fate_result){ .fate = FATE_UNDECIDED };
    enum status status = orbit_init(&o, &s->plane.system, z, &options);
    if (status != STATUS_OK)
        return status;
    status = run(s, &o, observe, monitor, &past);
    if (status == STATUS_OK || status == STATUS_NO_CONVERGENCE ||
        status == STATUS_TOO_MANY_STEPS) {
        out->fate = fate_at_end(s, &goals, &o, &past);
        out->reason = reason_of(s, &past, out->fate);
        out->steps = o.steps;
        out->field_evaluations = o.field_calls + o.jacobian_calls;
        if (observe)
            observe_end(s, exp(s->plane.system.origin.x + z.x), &o, &past, out);
        *last = (struct vec2){ o.u[0], o.u[1] };
        status = STATUS_OK;
    }
    orbit_free(&o);
    return status;
}

enum fate fate_of_side(const struct slider *s, bool slow)
{
    const size_t saddle = (size_t) slider_saddle(s), other = saddle + 1;

    if (slow)
        return saddle == 0 ? fate_at_rest(s)
                           : fate_of_node(s, &s->plane.equilibrium[saddle - 1]);
    return other == s->plane.equilibria
               ? FATE_RUNAWAY
               : fate_of_node(s, &s->plane.equilibrium[other]);
}

/* (A saddle is beyond the plane where a block may rest and a node is the only
 * steady state in it.) */
enum fate fate_of_all(const struct slider *s)
{
    const enum fate rest = rest_form_at(&s->block).fate;

    if (slider_saddle(s) >= 0 || s->plane.equilibria > 1)
        return FATE_UNDECIDED;
    if (s->plane.equilibria == 0)
        return s->block.at.force0 > 0.0 ? FATE_RUNAWAY : fate_at_rest(s);
    const struct equilibrium *e = &s->plane.equilibrium[0];
    return e->type == EQUILIBRIUM_STABLE_NODE && rest == FATE_CREEP
               ? fate_of_node(s, e)
               : FATE_UNDECIDED;
}

/* What is known of an orbit that ended nowhere, at the offset `last`. */
static enum fate find_anyway(const struct slider *s, struct vec2 last)
{
    const bool slow = last.x < 0.0 && last.y > 0.0;
    const bool fast = last.x > 0.0 && last.y < 0.0;

    return !slider_traps(s) ? fate_of_all(s)
           : slow || fast   ? fate_of_side(s, slow)
                            : FATE_UNDECIDED;
}

enum status fate_find(const struct slider *s, struct vec2 z, double rtol,
                      bool observe, const struct monitor *monitor,
                      struct fate_result *out)
{
    const struct vec2 start = vec2_sub(z, s->plane.system.origin);
    struct vec2 last = start;
    const enum status status =
        follow(s, start, rtol, observe, monitor, out, &last);

    if (status != STATUS_OK || observe || out->fate != FATE_UNDECIDED)
        return status;
    out->fate = find_anyway(s, last);
    if (out->fate != FATE_UNDECIDED)
        out->reason = NULL;
    return STATUS_OK;
}

struct vec2 fate_face(struct vec2 z, struct vec2 node)
{
    const bool x = fabs(z.x - node.x) > fabs(z.y - node.y);

    return (struct vec2){ x, !x };
}

struct quantity fate_compare(const struct quantity *coarse,
                             const struct quantity *fine)
{
    if (!quantity_exists(coarse) || !quantity_exists(fine))
        return quantity_exists(fine) ? *coarse : *fine;
    const double change = fabs(fine->value - coarse->value);
    const double allowed = fine->error + coarse->error;

    return quantity_of(
        fine->value,
        fine->error * fmax(allowed > 0.0 ? change / allowed : 1.0, 1.0) +
            TOL_FATE_CHANGE * change);
}
