/* Radau IIA with a step control that continues trends: Gustafsson, ACM Trans.
 * Math. Softw. 20 (1994) 496-517, as in Hairer & Wanner, Solving ODEs II, sec.
 * IV.8, but also where they lengthen the step, since times and rates change by
 * powers of e from step to step.  What is ours: the clock, observables weighed
 * against their largest value so far, and stops found on the dense output
 * without jumping over any. */
#include "orbit.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "orbit_stop.h"
#include "tolerance.h"

/* ORDER: the error estimate goes as h^ORDER. */
enum { COEFS = RADAU_DEGREE + 1, ORDER = RADAU_STAGES + 1 };

struct orbit_options orbit_defaults(const struct planar *system, double kappa)
{
    struct orbit_options o = {
        .kappa = kappa,
        .rtol = TOL_ORBIT_RTOL,
        .observables = system->observable_count,
        .arrival = TOL_ARREST,
        .max_steps = TOL_ORBIT_STEPS,
    };

    for (size_t i = 0; i <= PLANAR_OBSERVABLES_MAX; i++)
        o.reach[i] = INFINITY;
    return o;
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
                box_holds(box_from(system->domain, system->origin), z);

    for (size_t i = 0; i <= o->observables; i++)
        good = good && (o->reach[i] < 0.0 || o->reach[i] > 0.0) &&
               o->least[i] >= 0.0 && isfinite(o->least[i]);
    return good;
}

static struct vec2 place(const struct orbit *o)
{
    return (struct vec2){ o->u[0], o->u[1] };
}

/* A step on which nothing changes by more than a small part of itself: neither
 * the direction nor any rate. */
static double first_step(const struct orbit *o, const struct cascade_linear *l)
{
    const double *du = l->du;
    const double least =
        2.0 * TOL_ORBIT_STALL * fmax(fabs(o->u[0]), fabs(o->u[1]));
    double fastest = 1.0;

    for (size_t i = 0; i < o->curve.dim; i++) {
        const struct vec2 g = l->slope[i];
        const double size = i < 2 ? 1.0 : fabs(du[i]);
        const double rate = fabs(g.x * du[0] + g.y * du[1]) / size;
        fastest = isfinite(rate) ? fmax(fastest, rate) : fastest;
    }
    return fmax(pow(o->options.rtol, 1.0 / ORDER) / fastest, least);
}

static void set_mark(struct orbit *o)
{
    o->mark.x = o->u[0];
    o->mark.y = o->u[1];
    o->mark.t = o->u[2];
    o->mark.steps = o->steps;
    o->mark.way = 0.0;
}

/* The rates at the start and what the first step needs. */
static void begin(struct orbit *o)
{
    struct cascade_linear l;

    rescaled_linear(&o->clock, place(o), &l);
    o->jacobian_calls++;
    memcpy(o->du, l.du, sizeof o->du);
    o->h = first_step(o, &l);
    o->rate = 1.0;
    set_mark(o);
}

enum status orbit_init(struct orbit *o, const struct planar *system,
                       struct vec2 z, const struct orbit_options *options)
{
    memset(o, 0, sizeof *o);
    if (!is_good(system, z, options))
        return STATUS_BAD_ARGUMENT;
    o->options = *options;
    if (!(fabs(options->reach[0]) <= TOL_RANGE))
        o->options.reach[0] = options->backward ? -TOL_RANGE : TOL_RANGE;
    o->clock =
        (struct rescaled){ system, options->kappa, options->observables };
    o->curve = CURVE_EMPTY(3 + options->observables);
    o->u[0] = z.x;
    o->u[1] = z.y;
    begin(o);
    event_begin(&o->log, options->event, options->events, 0.0, o->u);
    orbit_stop_at(o, z);
    return STATUS_OK;
}

/* A step as tried. */
struct attempt {
    double h; /* signed */
    struct radau radau;
    double u1[CURVE_DIM_MAX], error[CURVE_DIM_MAX];
    double coef[CURVE_DIM_MAX * COEFS];
    double fastest; /* rate of the field on the way, per unit of time */
    struct vec2 slope[CURVE_DIM_MAX]; /* gradients there, per tau */
};

/* What errors are relative to. */
static double size_of(const struct orbit *o, size_t i, double u)
{
    if (i < 2)
        return o->options.far ? fmax(fabs(u), 1.0) : 1.0;
    return fmax(fmax(o->peak[i], fabs(u)), o->options.least[i - 2]);
}

/* What rounding does to integral i on the step: a rate that is the first
 * integral's times a difference of numbers of order 1 has no digits below that,
 * not one where it is smaller itself, and where a step was refused twice for no
 * less, that of the coordinates is to be borne, up to all of the integral:
 * shorter steps have no less of it. */
static double noise_of(const struct orbit *o, const struct attempt *a, size_t i)
{
    const double digit = DBL_EPSILON * fmax(fabs(o->u[0]), fabs(o->u[1]));
    const struct vec2 g = a->slope[i];
    const double noise = digit * (fabs(g.x) + fabs(g.y)) * fabs(a->h);
    const double rate = i > 3 ? DBL_EPSILON * fabs(a->u1[3] - o->u[3]) : 0.0;

    if (i < 2)
        return 0.0;
    return o->refused < 2 || isnan(noise)
               ? rate
               : rate + fmin(noise, fabs(a->u1[i] - o->u[i]));
}

/* The largest estimated error over what is allowed; NaN if anything is. */
static double error_ratio(const struct orbit *o, const struct attempt *a)
{
    double worst = 0.0;

    for (size_t i = 0; i < o->curve.dim; i++) {
        const double allowed = o->options.rtol * size_of(o, i, a->u1[i]) +
                               DBL_MIN + noise_of(o, a, i);
        const double ratio = fabs(a->error[i]) / allowed;
        if (!isfinite(ratio) || !isfinite(a->u1[i]))
            return (double) NAN;
        worst = fmax(worst, ratio);
    }
    return worst;
}

/* Adds the step's errors to those so far, and hands them to its hits. */
static void add_errors(struct orbit *o, const double error[])
{
    const size_t piece = o->curve.count - 1;

    for (size_t i = 0; i < o->curve.dim; i++)
        o->error[i] += fabs(error[i]);
    o->curve.piece[piece].error = fmax(o->error[0], o->error[1]);
    for (size_t k = o->log.count; k-- > 0 && o->log.hit[k].piece == piece;)
        memcpy(o->log.hit[k].error, o->error, sizeof o->error);
}

/* How far beside the true orbit the last piece is: what is carried to its start
 * or to its end, for stiff orbits close in on the way, no more than what steps
 * estimate, to first order, and are rounded by one by one; and what it misses
 * between its ends. */
static void carry(struct orbit *o, struct drift *d, double h,
                  const double error[])
{
    struct curve_piece *p = &o->curve.piece[o->curve.count - 1];
    const double start = drift_across(d);

    drift_carry(d, &o->clock, &o->curve, h, error);
    o->jacobian_calls += DRIFT_CALLS;
    p->across = fmin(fmax(start, drift_across(d)),
                     TOL_BAR_FIRST_ORDER * hypot(o->error[0], o->error[1]) +
                         d->rounded) +
                TOL_BAR_FIRST_ORDER * hypot(error[0], error[1]);
}

/* Moves to where the last piece ends. */
static void advance(struct orbit *o, double end, double h, const double u1[],
                    const double error[])
{
    o->steps++;
    o->tau += end * h;
    o->mark.way += hypot(u1[0] - o->u[0], u1[1] - o->u[1]);
    memcpy(o->u, u1, o->curve.dim * sizeof *u1);
    if (o->end != ORBIT_RUNNING) {
        event_trim(&o->log, &o->curve, end);
        curve_at(&o->curve, o->curve.count - 1, 1.0, o->u);
    }
    for (size_t i = 0; i < o->curve.dim; i++)
        o->peak[i] = fmax(o->peak[i], fabs(o->u[i]));
    add_errors(o, error);
    if (o->options.drift)
        carry(o, o->options.drift, end * h, error);
}

/* The stages as the last step suggests, where it reaches so far. */
static void guess(const struct orbit *o, struct attempt *a)
{
    const double ratio = o->last.h != 0.0 ? a->h / o->last.h : INFINITY;

    a->radau.rate = o->rate;
    if (ratio <= TOL_ORBIT_EXTEND)
        radau_extend(&a->radau,
                     curve_component(&o->curve, o->curve.count - 1, 0), ratio);
    else
        radau_start(&a->radau, o->du, a->h);
}

/* The step itself; false where its equations were not solved. */
static bool solve(struct orbit *o, struct attempt *a)
{
    const struct cascade system = rescaled_cascade(&o->clock);
    const double tol = TOL_PART * o->options.rtol;
    struct cascade_linear at;

    guess(o, a);
    rescaled_linear(&o->clock, vec2_add(place(o), a->radau.z[RADAU_MIDDLE]),
                    &at);
    o->jacobian_calls++;
    a->fastest = rescaled_rate(&at);
    memcpy(a->slope, at.slope, sizeof a->slope);
    memcpy(at.du, o->du, sizeof at.du);
    const bool solved = radau_solve(&a->radau, &system, &at, o->u, a->h, tol);
    o->rate = a->radau.rate;
    o->field_calls += RADAU_STAGES * a->radau.iterations;
    if (!solved)
        return false;
    radau_finish(&a->radau, &system, &at, o->u, a->h, a->coef, a->error);
    o->field_calls++;
    for (size_t i = 0; i < o->curve.dim; i++) {
        a->u1[i] = 0.0;
        for (size_t j = COEFS; j-- > 0;)
            a->u1[i] += a->coef[i * COEFS + j];
    }
    return true;
}

/* What to multiply a refused step by; NaN is a huge error. */
static double shorter(double ratio)
{
    const double f = TOL_STEP_SAFETY * pow(ratio, -1.0 / ORDER);
    return fmin(fmax(f, TOL_STEP_SHRINK), 1.0);
}

/* What to multiply an accepted step by: as if error and step went on changing
 * as they did, and not so far that the next one is hard to solve. */
static double longer(const struct orbit *o, const struct attempt *a,
                     double ratio)
{
    const double error = fmax(ratio, TOL_STEP_ERROR_FLOOR);
    const double most = o->refused ? 1.0 : TOL_STEP_GROWTH;
    double f = TOL_STEP_SAFETY * pow(error, -1.0 / ORDER);

    if (o->last.h != 0.0) {
        const double trend =
            a->h / o->last.h * pow(o->last.ratio / error, 1.0 / ORDER);
        f *= fmin(trend, TOL_ORBIT_EXTEND);
    }
    if (a->radau.iterations > 1)
        f = fmin(f,
                 fmax(sqrt(TOL_FAR_BELOW / a->radau.rate), TOL_ORBIT_RETREAT));
    return fmin(fmax(f, TOL_STEP_SHRINK), most);
}

/* The kappa for a field that changes at this rate; what there is where that is
 * no number.  kappa t is one, some steps further on, too. */
static double pace_at(const struct orbit *o, double fastest)
{
    const double most = 0x1p-8 * DBL_MAX / fmax(0x1p8, fabs(o->u[2]));

    return isnan(fastest)
               ? o->clock.kappa
               : fmin(fmax(o->options.kappa, TOL_ORBIT_PACE * fastest), most);
}

static bool is_pace(const struct orbit *o, double kappa)
{
    const double ratio = kappa / o->clock.kappa;

    return TOL_FAR_BELOW * ratio <= 1.0 && ratio >= TOL_FAR_BELOW;
}

/* Where the field changes far faster than kappa, rounding alone moves an orbit
 * that creeps along a slow curve at more than kappa, and it would stand still
 * on its clock: the clock follows the field, in steps that rarely come.  On the
 * way the rate was that of guesses, whose own distance from a slow curve may
 * be all of it; the step's last rates are as good as its equations: both are
 * looked up where the orbit is. */
static void keep_pace(struct orbit *o, double fastest)
{
    struct cascade_linear l;

    if (is_pace(o, pace_at(o, fastest)))
        return;
    rescaled_linear(&o->clock, place(o), &l);
    o->jacobian_calls++;
    const double kappa = pace_at(o, rescaled_rate(&l));
    if (is_pace(o, kappa) || !(l.du[2] > 0.0))
        return;
    const double pace = hypot(kappa * l.du[2], hypot(l.du[0], l.du[1]));
    for (size_t i = 0; i < o->curve.dim; i++)
        o->du[i] = l.du[i] / pace;
    o->clock.kappa = kappa;
    o->h *= pace;
    o->last.h *= pace;
}

/* The shortest step. */
static double least_step(const struct orbit *o)
{
    return fmax(TOL_STEP_MIN,
                TOL_ORBIT_STALL * fmax(fabs(o->u[0]), fabs(o->u[1])));
}

/* The part of a step by which what stopped it may be misplaced, by the step's
 * own estimates and rounding. */
static double unsure_of(const struct orbit *o, const struct attempt *a)
{
    const double *e = a->error, *u = a->u1;
    const size_t i = 2 + o->end_index;

    if (o->end == ORBIT_REACHED)
        return (fabs(e[i]) + TOL_ORBIT_STALL * fabs(u[i])) /
               fabs(u[i] - o->u[i]);
    return (hypot(e[0], e[1]) +
            TOL_ORBIT_STALL * fmax(fabs(u[0]), fabs(u[1]))) /
           hypot(u[0] - o->u[0], u[1] - o->u[1]);
}

/* Within a step the polynomial is off by some orders of h more than at its
 * end, by what may vanish just where it is cut while its next order does not:
 * an orbit that is asked how far it is off takes its last step again to just
 * there, and further by what it is unsure of, lest it end before.  (Events are
 * where the polynomial has them.)  The part of h to take; 1: what there is will
 * do. */
static double part_again(const struct orbit *o, const struct attempt *a,
                         double end)
{
    const bool may = o->options.drift && !o->cut && o->end != ORBIT_RUNNING &&
                     o->end != ORBIT_EVENT;
    const double part = may ? end + unsure_of(o, a) : 1.0;

    return part < 1.0 && part * fabs(a->h) > least_step(o) ? part : 1.0;
}

/* Drops the last piece and what was found on it. */
static void take_back(struct orbit *o)
{
    const struct orbit_options *p = &o->options;

    event_drop(&o->log, &o->curve);
    event_begin(&o->log, p->event, p->events, o->tau, o->u);
    o->end = ORBIT_RUNNING;
    o->cut = true;
}

/* Appends an accepted step, unless it is to be taken again. */
static enum status accept(struct orbit *o, const struct attempt *a,
                          double ratio, bool *accepted)
{
    double *coef, end = 1.0;
    enum status s = curve_push(&o->curve, RADAU_DEGREE, &coef);

    if (s != STATUS_OK)
        return s;
    memcpy(coef, a->coef, o->curve.dim * COEFS * sizeof *coef);
    s = orbit_stop_find(o, a->h, &end);
    const double part = part_again(o, a, end);
    if (part < 1.0) {
        take_back(o);
        o->h = part * fabs(a->h);
        *accepted = false;
        return s;
    }
    memcpy(o->du, a->radau.du[RADAU_STAGES - 1], sizeof o->du);
    o->h = fabs(a->h) * longer(o, a, ratio);
    o->last.h = a->h;
    o->last.ratio = fmax(ratio, TOL_STEP_ERROR_FLOOR);
    o->refused = 0;
    advance(o, end, a->h, a->u1, a->error);
    keep_pace(o, a->fastest);
    return s;
}

/* One attempt at a step of signed size h. */
static enum status attempt(struct orbit *o, double h, bool *accepted)
{
    struct attempt a = { .h = h };
    const bool solved = solve(o, &a);
    const double ratio = solved ? error_ratio(o, &a) : INFINITY;

    *accepted = ratio <= 1.0;
    if (*accepted)
        return accept(o, &a, ratio, accepted);
    o->cut = false;
    o->h = fabs(h) * (solved ? shorter(ratio) : TOL_ORBIT_RETREAT);
    o->refused++;
    o->rejected++;
    return STATUS_OK;
}

/* Whether an integral is hardly a number. */
static bool is_beyond(const struct orbit *o)
{
    double most = 0.0;

    for (size_t i = 3; i < o->curve.dim; i++)
        most = fmax(most, fabs(o->u[i]));
    return most > TOL_RANGE;
}

/* Whether in so many steps it has gone no further than a walk at random, in no
 * time: what moves gets on in one of the two. */
static bool stands_still(struct orbit *o)
{
    const double x = o->u[0] - o->mark.x, y = o->u[1] - o->mark.y;
    const double late = fabs(o->u[2]) - fabs(o->mark.t);
    const bool is_due = o->steps >= o->mark.steps + TOL_EXPLICIT_STEPS;
    const bool is_still =
        is_due && hypot(x, y) * sqrt(TOL_EXPLICIT_STEPS) < o->mark.way &&
        late <= DBL_EPSILON * fabs(o->u[2]);

    if (is_due)
        set_mark(o);
    return is_still;
}

enum status orbit_step(struct orbit *o)
{
    const double least = least_step(o);
    bool accepted = o->end != ORBIT_RUNNING;

    while (!accepted) {
        if (!(o->h > least) || is_beyond(o) || stands_still(o))
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
