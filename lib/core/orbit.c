/* Rodas5P with PI step control.  What is ours: the clock, observables weighed
 * against their largest value so far, and stops found on the dense output
 * without jumping over any. */
#include "orbit.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "passage.h"
#include "tolerance.h"

enum { COEFS = ROSENBROCK_DEGREE + 1 };

struct orbit_options orbit_defaults(const struct planar *system, double kappa)
{
    struct orbit_options o = {
        .kappa = kappa,
        .rtol = TOL_ORBIT_RTOL,
        .observables = system->observable_count,
        .arrival = TOL_ARREST,
        .max_steps = TOL_MAX_STEPS,
    };

    for (size_t i = 0; i <= PLANAR_OBSERVABLES_MAX; i++)
        o.reach[i] = INFINITY;
    return o;
}

/* From absolute coordinates to offsets. */
static struct box offsets(struct box b, struct vec2 origin)
{
    return (struct box){ vec2_sub(b.lo, origin), vec2_sub(b.hi, origin) };
}

static struct box around(struct vec2 z, double r)
{
    return (struct box){ { z.x - r, z.y - r }, { z.x + r, z.y + r } };
}

static bool is_good(const struct planar *system, struct vec2 z,
                    const struct orbit_options *o)
{
    bool good = o->kappa > 0.0 && isfinite(o->kappa) && o->rtol > 0.0 &&
                (o->targets == 0 || o->arrival > 0.0) &&
                o->observables <= system->observable_count &&
                o->observables <= PLANAR_OBSERVABLES_MAX &&
                o->events <= EVENT_COUNT_MAX && isfinite(z.x) &&
                isfinite(z.y) &&
                box_holds(offsets(system->domain, system->origin), z);

    for (size_t i = 0; i <= o->observables; i++)
        good = good && (o->reach[i] < 0.0 || o->reach[i] > 0.0);
    return good;
}

/* Stops that hold at the start. */
static void judge_start(struct orbit *o, struct vec2 z)
{
    const struct orbit_options *p = &o->options;
    const struct vec2 origin = o->clock.system->origin;

    if (p->window && !box_holds(offsets(*p->window, origin), z))
        o->end = ORBIT_LEFT_WINDOW;
    for (size_t i = p->targets; i-- > 0;) {
        if (box_holds(around(p->target[i], p->arrival), z)) {
            o->end = ORBIT_ARRIVED;
            o->end_index = i;
        }
    }
}

static void linearise(struct orbit *o)
{
    rescaled_linear(&o->clock, (struct vec2){ o->u[0], o->u[1] }, &o->linear);
    o->jacobian_calls++;
}

/* Where the second derivative alone would make an error of the order asked
 * for. */
static double first_step(const struct orbit *o)
{
    const double *du = o->linear.du;
    const struct vec2 *J = o->linear.slope;
    const double bend =
        hypot(J[0].x * du[0] + J[0].y * du[1], J[1].x * du[0] + J[1].y * du[1]);

    const double least =
        2.0 * TOL_ORBIT_STALL * fmax(fabs(o->u[0]), fabs(o->u[1]));
    const double h =
        pow(TOL_STEP_FIRST * o->options.rtol, 1.0 / o->control.order) /
        fmax(1.0, bend);
    return fmax(h, least);
}

enum status orbit_init(struct orbit *o, const struct planar *system,
                       struct vec2 z, const struct orbit_options *options)
{
    memset(o, 0, sizeof *o);
    if (!is_good(system, z, options))
        return STATUS_BAD_ARGUMENT;
    o->options = *options;
    if (!(fabs(options->reach[0]) <= TOL_TIME_MAX))
        o->options.reach[0] = options->backward ? -TOL_TIME_MAX : TOL_TIME_MAX;
    o->clock =
        (struct rescaled){ system, options->kappa, options->observables };
    o->curve = CURVE_EMPTY(3 + options->observables);
    o->u[0] = z.x;
    o->u[1] = z.y;
    o->control = CONTROL_INIT(5.0);
    linearise(o);
    o->h = first_step(o);
    event_begin(&o->log, options->event, options->events, 0.0, o->u);
    judge_start(o, z);
    return STATUS_OK;
}

/* The largest estimated error over what is allowed; NaN if anything is. */
static double error_ratio(const struct orbit *o, const double u1[],
                          const double error[])
{
    double worst = 0.0;

    for (size_t i = 0; i < o->curve.dim; i++) {
        const double size = i < 2 ? 1.0 : fmax(o->peak[i], fabs(u1[i]));
        const double ratio =
            fabs(error[i]) / (o->options.rtol * size + DBL_MIN);
        if (!isfinite(ratio) || !isfinite(u1[i]))
            return (double) NAN;
        worst = fmax(worst, ratio);
    }
    return worst;
}

/* Keeps the earlier of two stops. */
static void stop_at(struct orbit *o, double *end, double theta,
                    enum orbit_end why, size_t index)
{
    if (theta > 1.0 || (o->end != ORBIT_RUNNING && theta >= *end))
        return;
    *end = fmax(theta, DBL_EPSILON);
    o->end = why;
    o->end_index = index;
}

/* The first of the built-in stops on the last piece. */
static void find_stop(struct orbit *o, double *end)
{
    const struct orbit_options *p = &o->options;
    const struct planar *sys = o->clock.system;
    const struct curve *c = &o->curve;

    for (size_t i = 0; i < p->targets; i++)
        stop_at(o, end, passage_into(c, around(p->target[i], p->arrival)),
                ORBIT_ARRIVED, i);
    for (size_t i = 0; i <= p->observables; i++)
        if (isfinite(p->reach[i]))
            stop_at(o, end, passage_beyond(c, 2 + i, p->reach[i]),
                    ORBIT_REACHED, i);
    if (p->window)
        stop_at(o, end, passage_out_of(c, offsets(*p->window, sys->origin)),
                ORBIT_LEFT_WINDOW, 0);
    stop_at(o, end, passage_out_of(c, offsets(sys->domain, sys->origin)),
            ORBIT_LEFT_DOMAIN, 0);
}

/* Stops and events on the piece just pushed; moves to its end. */
static enum status advance(struct orbit *o, double h, const double u1[],
                           const double error[])
{
    const struct orbit_options *p = &o->options;
    double end = 1.0;
    size_t stop;

    find_stop(o, &end);
    const enum status s = event_scan(&o->log, p->event, p->events, &o->curve,
                                     o->tau, h, &end, &stop);
    if (stop < p->events) {
        o->end = ORBIT_EVENT;
        o->end_index = stop;
    }
    o->steps++;
    o->tau += end * h;
    memcpy(o->u, u1, o->curve.dim * sizeof *u1);
    if (o->end != ORBIT_RUNNING) {
        event_trim(&o->log, &o->curve, end);
        curve_at(&o->curve, o->curve.count - 1, 1.0, o->u);
    }
    for (size_t i = 0; i < o->curve.dim; i++) {
        o->error[i] += fabs(error[i]);
        o->peak[i] = fmax(o->peak[i], fabs(o->u[i]));
    }
    if (o->end == ORBIT_RUNNING)
        linearise(o);
    return s;
}

/* One attempt at a step of signed size h. */
static enum status attempt(struct orbit *o, double h, bool *accepted)
{
    const size_t dim = o->curve.dim;
    const struct cascade system = rescaled_cascade(&o->clock);
    struct rosenbrock work;
    double u1[CURVE_DIM_MAX], *coef, factor;
    const double *error = work.k[ROSENBROCK_STAGES - 1];

    rosenbrock_try(&work, &system, &o->linear, o->u, h, u1);
    o->field_calls += ROSENBROCK_CALLS;
    *accepted = control_judge(&o->control, error_ratio(o, u1, error), &factor);
    o->h = fabs(h) * factor;
    if (!*accepted) {
        o->rejected++;
        return STATUS_OK;
    }
    const enum status s = curve_push(&o->curve, ROSENBROCK_DEGREE, &coef);
    if (s != STATUS_OK)
        return s;
    rosenbrock_dense(&work, dim, o->u, u1, coef);
    return advance(o, h, u1, error);
}

enum status orbit_step(struct orbit *o)
{
    const double size = fmax(fabs(o->u[0]), fabs(o->u[1]));
    const double least = fmax(TOL_STEP_MIN, TOL_ORBIT_STALL * size);
    bool accepted = o->end != ORBIT_RUNNING;

    while (!accepted) {
        if (!(o->h > least))
            return STATUS_NO_CONVERGENCE;
        if (o->steps + o->rejected >= o->options.max_steps)
            return STATUS_TOO_MANY_STEPS;
        const enum status s =
            attempt(o, o->options.backward ? -o->h : o->h, &accepted);
        if (s != STATUS_OK)
            return s;
    }
    return STATUS_OK;
}

enum status orbit_run(struct orbit *o, const struct monitor *monitor)
{
    enum status s = STATUS_OK;

    while (s == STATUS_OK && o->end == ORBIT_RUNNING) {
        if (o->steps % TOL_MONITOR_STEPS == 0 &&
            monitor_tell(monitor, "orbit", o->steps, 0))
            return STATUS_STOPPED;
        s = orbit_step(o);
    }
    return s;
}

void orbit_free(struct orbit *o)
{
    curve_free(&o->curve);
    event_free(&o->log);
}
