/* One orbit by orbit.h until it arrives, leaves the domain, outlives the
 * doubles or comes to rest; what its end means follows from the rates there.
 * Rest in finite time: ln v falls and psi rises so fast that what is left of
 * both is nothing beside the time so far.  (A state far from the slow curve
 * moves as fast in one of them only, one that rests like a power of time takes
 * as long again.)  It must be seen long before v = 1e-300, since psi and
 * psi_ss then agree to all digits that ln v and ln psi have. */
#include "fate.h"

#include <math.h>

#include "study.h"
#include "tolerance.h"

const char *const fate_names[] = { "creep",       "sliding",
                                   "rest_finite", "rest_asymptotic",
                                   "runaway",     "undecided",
                                   NULL };

enum fate fate_of_node(const struct study *s, const struct equilibrium *e)
{
    const struct planar_steady *curve = s->system.steady;
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

static struct goals goals_of(const struct study *s)
{
    struct goals g = { .count = 0 };

    for (size_t i = 0; i < s->equilibria; i++) {
        if ((int) i == s->saddle)
            continue;
        g.at[g.count] = vec2_sub(s->equilibrium[i].z, s->system.origin);
        g.fate[g.count++] = fate_of_node(s, &s->equilibrium[i]);
    }
    return g;
}

/* d/dt of both coordinates at the end of the orbit; may be infinite. */
static struct vec2 rates(const struct study *s, const struct orbit *o)
{
    struct planar_field f;

    s->system.field(s->system.ctx, (struct vec2){ o->u[0], o->u[1] }, &f);
    return vec2_scale(exp(f.log_scale), f.direction);
}

static bool rests(const struct study *s, const struct orbit *o)
{
    const struct vec2 rate = rates(s, o);
    const double soon = TOL_REST_SOON * o->u[2];

    return -rate.x * soon > 1.0 && rate.y * soon > 1.0;
}

/* In the quadrant v > v_sp, psi < psi_sp, which cannot be left (trap.h), and
 * without a node in it: nothing bounds v. */
static bool runs_away(const struct study *s, const struct orbit *o)
{
    if (s->saddle < 0 || !(o->u[0] > 0.0 && o->u[1] < 0.0))
        return false;
    return (size_t) s->saddle + 1 == s->equilibria;
}

/* An orbit that has left every scale: v -> inf or v -> 0 like a power of
 * time. */
static enum fate fate_beyond(const struct study *s, const struct orbit *o)
{
    const double rate = rates(s, o).x;

    return rate > 0.0   ? FATE_RUNAWAY
           : rate < 0.0 ? FATE_REST_ASYMPTOTIC
                        : FATE_UNDECIDED;
}

static enum fate fate_at_end(const struct study *s, const struct goals *g,
                             const struct orbit *o, const char **reason)
{
    enum fate fate = FATE_UNDECIDED;

    *reason = NULL;
    if (o->end == ORBIT_ARRIVED)
        fate = g->fate[o->end_index];
    else if (o->end == ORBIT_LEFT_DOMAIN || o->end == ORBIT_REACHED)
        fate = fate_beyond(s, o);
    else if (runs_away(s, o))
        fate = FATE_RUNAWAY;
    else if (rests(s, o))
        fate = FATE_REST_FINITE;
    if (fate == FATE_UNDECIDED)
        *reason = "the orbit could not be followed to an end";
    return fate;
}

/* What is still to come of the slip at the end of an orbit that rests:
 * v ~ t^-p leaves v t/(p - 1).  Infinite where p <= 1. */
static double slip_left(const struct study *s, const struct orbit *o)
{
    const double v = s->block.at.v0 * exp(o->u[0]), t = o->u[2];
    const double p = -rates(s, o).x * t;

    return p > 1.0 ? v * t / (p - 1.0) : HUGE_VAL;
}

static void observe_end(const struct study *s, const struct orbit *o,
                        struct fate_result *out)
{
    const double slip = o->u[3 + BLOCK_SLIP], work = o->u[3 + BLOCK_WORK];
    const double slip_error = o->error[3 + BLOCK_SLIP];
    const double left =
        out->fate == FATE_REST_ASYMPTOTIC ? slip_left(s, o) : 0.0;
    static const char runs_away[] = "the block runs away";
    static const char undecided[] = "the fate is undecided";
    static const char never[] = "the block never quite stops";
    static const char unbounded[] = "the slip grows without bound";

    if (out->fate == FATE_RUNAWAY || out->fate == FATE_UNDECIDED) {
        const char *why = out->fate == FATE_RUNAWAY ? runs_away : undecided;
        out->slip = out->time = out->mu_mean = quantity_none(why);
        return;
    }
    out->time = out->fate == FATE_REST_ASYMPTOTIC
                    ? quantity_none(never)
                    : quantity_of(o->u[2], o->error[2]);
    out->slip = left < HUGE_VAL ? quantity_of(slip, slip_error + left)
                                : quantity_none(unbounded);
    out->mu_mean =
        slip > 0.0
            ? quantity_of(work / slip, (o->error[3 + BLOCK_WORK] +
                                        work / slip * (slip_error + left)) /
                                           slip)
            : quantity_none("no slip before arrest");
    if (left == HUGE_VAL)
        out->mu_mean = quantity_none(unbounded);
}

/* orbit_run, which also ends where the block rests or runs away. */
static enum status run(const struct study *s, struct orbit *o,
                       const struct monitor *monitor)
{
    enum status status = STATUS_OK;

    while (status == STATUS_OK && o->end == ORBIT_RUNNING && !rests(s, o) &&
           !runs_away(s, o)) {
        status = orbit_step(o);
        if (o->steps % 1024 == 0 && monitor_tell(monitor, "orbit", o->steps, 0))
            status = STATUS_STOPPED;
    }
    return status;
}

enum status fate_find(const struct study *s, struct vec2 z, double rtol,
                      bool observe, const struct monitor *monitor,
                      struct fate_result *out)
{
    const struct goals goals = goals_of(s);
    struct orbit_options options = orbit_defaults(&s->system, s->stable_rate);
    struct orbit o;

    options.rtol = rtol;
    options.observables = observe ? BLOCK_EXCESS : 0;
    options.target = goals.at;
    options.targets = goals.count;
    options.arrival = TOL_ARREST;
    options.max_steps = TOL_FATE_STEPS;
    *out = (struct fate_result){ .fate = FATE_UNDECIDED };
    enum status status =
        orbit_init(&o, &s->system, vec2_sub(z, s->system.origin), &options);
    if (status != STATUS_OK)
        return status;
    status = run(s, &o, monitor);
    if (status == STATUS_OK || status == STATUS_NO_CONVERGENCE ||
        status == STATUS_TOO_MANY_STEPS) {
        out->fate = fate_at_end(s, &goals, &o, &out->reason);
        out->steps = o.steps;
        out->field_evaluations = o.field_calls + o.jacobian_calls;
        if (observe)
            observe_end(s, &o, out);
        status = STATUS_OK;
    }
    orbit_free(&o);
    return status;
}

enum status fate_label(const void *study, struct vec2 z, int8_t *label)
{
    struct fate_result r;
    const enum status s = fate_find(study, z, TOL_TRAP_RTOL, false, NULL, &r);

    *label = (int8_t) r.fate;
    return s;
}
