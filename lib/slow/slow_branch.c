/* Each branch is run by orbit.h in steps so short that a polynomial of degree
 * 5 through both ends, their slopes and curvatures is as good as the ends. */
#include "slow_branch.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "crest.h"
#include "rest_form.h"
#include "room.h"
#include "slider.h"
#include "slow_bars.h"
#include "slow_face.h"
#include "slow_fit.h"
#include "slow_tolerance.h"

/* ---- knots --------------------------------------------------------------- */

/* The last step of an orbit. */
struct last_step {
    const struct slider *slider;
    const struct curve *curve;
};

static double mu_on(const void *ctx, double theta)
{
    const struct last_step *l = ctx;

    return block_mu(&l->slider->block,
                    curve_point(l->curve, l->curve->count - 1, theta));
}

/* The largest friction on the way to a knot, v being largest at an end. */
static double mu_until(const struct slider *s, const struct orbit *o)
{
    const struct last_step l = { s, &o->curve };
    const struct vec2 z = { o->u[0], o->u[1] };

    return o->curve.count > 0 ? crest_of(mu_on, &l, NULL)
                              : block_mu(&s->block, z);
}

static struct slow_knot *push(struct slow_branch *b)
{
    return ROOM_FOR(b->knot, b->room, b->count + 1) ? NULL
                                                    : &b->knot[b->count++];
}

/* ---- a branch ------------------------------------------------------------ */

/* Steps no longer than what the polynomials bear. */
static void hold_back(struct orbit *o, const struct slow_branch *b)
{
    const struct slow_knot *k = &b->knot[b->count - 1];
    const double change = slow_knot_change(b->count > 1 ? k - 1 : k, k);
    const double most = fmin(TOL_SLOW_STEP / change, TOL_NEARBY);
    const double speed = fabs(o->du[1]);

    if (speed * o->h > most)
        o->h = most / speed;
}

/* dx/dy at the end of the orbit, which may be a step cut short. */
static double slope_of(const struct orbit *o)
{
    double du[CURVE_DIM_MAX];

    if (o->end == ORBIT_RUNNING)
        return o->du[0] / o->du[1];
    curve_slope_at(&o->curve, o->curve.count - 1, 1.0, du);
    return du[0] / du[1];
}

/* Whether a knot may be landed on: the rates are apart and so many e-folds of
 * their difference have passed that any orbit would be on the curve. */
static void tell(struct slow_knot *k, double dt, double *folds)
{
    *folds = k->gap < 1.0 ? *folds + k->fast * (1.0 - k->gap) * dt : 0.0;
    if (!(*folds >= TOL_SETTLED && k->gap < TOL_FAR_BELOW))
        k->gap = HUGE_VAL;
}

/* A point that y does not go on from, or stands still at, is no knot: its way
 * is the next one's. */
static void make_monotone(struct slow_branch *b)
{
    struct slow_knot *const k = b->knot;
    const double way = k[b->count - 1].y - k[0].y;
    size_t kept = 0;

    for (size_t i = 0; i < b->count; i++) {
        struct slow_knot next = k[i];
        for (; kept > 0; kept--) {
            const struct slow_knot *last = &k[kept - 1];
            if ((next.y - last->y) * way > 0.0 && isfinite(last->time[1]))
                break;
            next.time[0] += last->time[0];
            next.slip[0] += last->slip[0];
            next.time_bar += last->time_bar;
            next.slip_bar += last->slip_bar;
            next.mu = fmax(next.mu, last->mu);
        }
        k[kept++] = next;
    }
    b->count = kept;
}

/* What a branch leads to: a node, v that fades for ever, or neither. */
enum ahead { AHEAD_NEITHER, AHEAD_FADING, AHEAD_NODE };

/* Runs the orbit to its end; without a node ahead, until the rates are too far
 * apart, or alike, but where v fades they part again. */
static enum status follow(const struct slider *s, struct orbit *o,
                          enum ahead ahead, const struct monitor *monitor,
                          struct slow_branch *b)
{
    const double far =
        b->start == SLOW_RUNAWAY ? TOL_SERIES_RADIUS_MAX : HUGE_VAL;
    double folds = b->start == SLOW_BESIDE ? 0.0 : HUGE_VAL;
    struct slow_off was = { 0.0, 0.0 };
    enum status status = STATUS_OK;

    for (bool goes_on = true; goes_on && status == STATUS_OK;) {
        struct slow_knot *const k = push(b);
        if (k == NULL)
            return STATUS_NO_MEMORY;
        slow_knot_at(s, o->u, slope_of(o), k);
        slow_bars_note(o, k, &was);
        k->mu = mu_until(s, o);
        k->time[0] = -slow_knot_gained(o, 2);
        k->slip[0] = -slow_knot_gained(o, 3 + BLOCK_SLIP);
        tell(k, -k->time[0], &folds);
        goes_on = o->end == ORBIT_RUNNING && o->steps < TOL_BRANCH_STEPS &&
                  (ahead == AHEAD_NODE ||
                   ((isfinite(k->gap) || ahead == AHEAD_FADING) &&
                    !slow_knot_is_noisy(k))) &&
                  fabs(k->y) < far;
        if (!goes_on)
            break;
        if (isfinite(k->gap))
            hold_back(o, b);
        status = orbit_step(o);
        if (status == STATUS_OK && o->steps % TOL_MONITOR_STEPS == 0 &&
            monitor_tell(monitor, "slow curve", o->steps, 0))
            status = STATUS_STOPPED;
    }
    make_monotone(b);
    return status == STATUS_NO_CONVERGENCE || status == STATUS_TOO_MANY_STEPS
               ? STATUS_OK
               : status;
}

static bool rests(enum fate fate)
{
    return fate == FATE_REST_FINITE || fate == FATE_REST_ASYMPTOTIC;
}

/* What is still to come at the last knot at rest is that of the orbit from
 * there, if it rests; nothing of what never ends. */
static enum status finish_rest(const struct slider *s, struct slow_branch *b)
{
    const struct quantity none = quantity_of(0.0, 0.0);
    const struct slow_knot *last = &b->knot[b->count - 1];
    const struct vec2 z = { last->x + s->plane.system.origin.x,
                            last->y + s->plane.system.origin.y };
    struct fate_result fine, coarse;

    if (!box_holds(s->plane.system.domain, z))
        return STATUS_OK;
    enum status status = fate_find(s, z, TOL_REST_WRONG, true, NULL, &fine);
    if (status == STATUS_OK)
        status =
            fate_find(s, z, TOL_REST_WRONG / TOL_FINER, true, NULL, &coarse);
    if (status != STATUS_OK || !rests(fine.fate) || coarse.fate != fine.fate)
        return status;
    const struct quantity time = fine.fate == FATE_REST_FINITE
                                     ? fate_compare(&coarse.time, &fine.time)
                                     : none;
    const struct quantity slip = rest_form_at(&s->block).has_slip
                                     ? fate_compare(&coarse.slip, &fine.slip)
                                     : none;
    if (!(time.error <= TOL_COARSEST * time.value) ||
        !(slip.error <= TOL_COARSEST * slip.value))
        return status;
    b->fate = (int8_t) fine.fate;
    b->x_end = -HUGE_VAL;
    for (size_t i = 0; i < b->count; i++) {
        b->knot[i].time[0] += time.value;
        b->knot[i].slip[0] += slip.value;
        b->knot[i].time_bar += time.error;
        b->knot[i].slip_bar += slip.error;
    }
    return status;
}

/* Inside a box all is counted from its face, the first knot. */
static void count_from_face(struct slow_branch *b)
{
    const struct slow_knot first = b->knot[0];

    for (size_t i = 0; i < b->count; i++) {
        struct slow_knot *k = &b->knot[i];
        k->time[0] -= first.time[0];
        k->slip[0] -= first.slip[0];
    }
}

/* How far off its end an orbit is, having come by the last knot a unit off
 * along its fibre: at the face of a box it is later, or earlier. */
static struct vec2 find_end_aside(const struct orbit *o,
                                  const struct slow_branch *b)
{
    const struct slow_knot *k = &b->knot[b->count - 1];

    if (o->end != ORBIT_ARRIVED)
        return k->fibre;
    const struct vec2 n = fate_face((struct vec2){ o->u[0], o->u[1] },
                                    o->options.target[o->end_index]);
    const double late =
        (n.x * k->fibre.x + n.y * k->fibre.y) / (n.x * k->x_slope + n.y);
    return (struct vec2){ k->fibre.x - k->x_slope * late, k->fibre.y - late };
}

/* Of x where the orbit meets the face of a box of arrest. */
static double x_error_at_face(const struct slider *s, const struct orbit *o,
                              const struct slow_branch *b)
{
    const struct vec2 z = { o->u[0], o->u[1] };
    const struct vec2 face = fate_face(z, o->options.target[o->end_index]);
    const double most = face.x != 0.0 ? 0.0 : TOL_ARREST;
    const double off = fabs(slow_bars_beside(o, &b->knot[b->count - 1], face));

    return fmin(TOL_BAR_FIRST_ORDER * off, most) + slider_rounding(s, z);
}

/* What is left until the face of a box, the knot k. */
static void add_face(const struct slider *s, const struct slow_knot *k,
                     struct slow_branch *b)
{
    const double off =
        slow_face_error(s, (struct vec2){ k->x, k->y }, k->x_slope);
    const double time = fabs(k->time[1]) * off;
    const double slip = fabs(k->slip[1]) * off;

    for (size_t i = 0; i < b->count; i++) {
        b->knot[i].time_bar += time;
        b->knot[i].slip_bar += slip;
    }
}

static enum status finish(const struct slider *s, const struct orbit *o,
                          int8_t node_fate, struct slow_branch *b)
{
    b->fate = FATE_UNDECIDED;
    if (b->start == SLOW_RUNAWAY)
        b->fate = FATE_RUNAWAY;
    if (o->end == ORBIT_ARRIVED) {
        b->fate = node_fate;
        b->x_end = b->knot[b->count - 1].x;
        b->x_end_error = x_error_at_face(s, o, b);
        add_face(s, &b->knot[b->count - 1], b);
    } else if (b->start == SLOW_SADDLE) {
        return finish_rest(s, b);
    }
    if (b->start == SLOW_FACE) {
        count_from_face(b);
        add_face(s, &b->knot[0], b);
    }
    return STATUS_OK;
}

/* From each step's to all to come. */
static void look_back(struct slow_branch *b)
{
    double time = 0.0, slip = 0.0;

    for (size_t i = b->count; i-- > 0;) {
        struct slow_knot *k = &b->knot[i];
        const double dt = -k->time[0], dx = -k->slip[0];
        k->time[0] = time;
        k->slip[0] = slip;
        k->time_bar += TOL_ROUNDINGS_MANY * DBL_EPSILON * time;
        k->slip_bar += TOL_ROUNDINGS_MANY * DBL_EPSILON * slip;
        time += dt;
        slip += dx;
    }
}

/* ---- looking up ---------------------------------------------------------- */

/* Where y lies between the ends, in even parts. */
static double part_of(const struct slow_branch *b, double y)
{
    const double first = b->knot[0].y, last = b->knot[b->count - 1].y;

    return (double) b->count * ((y - first) / (last - first));
}

static enum status fill_bins(struct slow_branch *b)
{
    const size_t bins = b->count;
    size_t k = 0;

    b->bin = malloc((bins + 2) * sizeof *b->bin);
    if (b->bin == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < bins + 2; i++) {
        while (k + 1 < b->count && part_of(b, b->knot[k + 1].y) <= (double) i)
            k++;
        b->bin[i] = (uint32_t) k;
    }
    return STATUS_OK;
}

size_t slow_branch_interval(const struct slow_branch *b, double y)
{
    const struct slow_knot *k = b->knot;
    const bool rises = k[b->count - 1].y > k[0].y;
    const double part = part_of(b, y);

    if (!(part >= 0.0 && part <= (double) b->count))
        return 0;
    const uint32_t *bin = b->bin + (size_t) part;
    size_t lo = bin[0], hi = bin[1] + 1 < b->count ? bin[1] + 1 : b->count - 1;
    while (hi - lo > 1) {
        const size_t mid = (lo + hi) / 2;
        if (rises ? k[mid].y <= y : k[mid].y >= y)
            lo = mid;
        else
            hi = mid;
    }
    return hi;
}

/* ---- a whole one --------------------------------------------------------- */

/* Elsewhere an orbit would go on for ever. */
static enum status comes_to_rest(const struct slider *s, struct vec2 z,
                                 bool *is, enum ahead *ahead)
{
    const struct vec2 at = { z.x + s->plane.system.origin.x,
                             z.y + s->plane.system.origin.y };
    struct fate_result r;
    const enum status status = fate_find(s, at, TOL_COARSEST, false, NULL, &r);

    *is = status == STATUS_OK && rests(r.fate);
    if (*is && r.fate == FATE_REST_ASYMPTOTIC)
        *ahead = AHEAD_FADING;
    return status;
}

/* The nodes, and what becomes of who arrives there. */
struct goals {
    struct vec2 at[EQUILIBRIA_MAX];
    int8_t fate[EQUILIBRIA_MAX];
    size_t count;
};

/* Whether a branch from z meets one of them. */
static bool find_goals(const struct slider *s, struct vec2 z,
                       enum slow_start start, struct goals *g)
{
    bool ahead = start == SLOW_BESIDE || start == SLOW_FACE;

    *g = (struct goals){ .fate = { FATE_UNDECIDED } };
    for (size_t i = 0; i < s->plane.equilibria; i++) {
        if ((int) i == slider_saddle(s))
            continue;
        const struct vec2 at = phase_plane_offset(&s->plane, i);
        ahead = ahead || at.y * z.y > 0.0;
        g->fate[g->count] = (int8_t) fate_of_node(s, &s->plane.equilibrium[i]);
        g->at[g->count++] = at;
    }
    return ahead;
}

/* Runs the branch, whose start is set. */
static enum status run(const struct slider *s, struct vec2 z,
                       const struct goals *goals, enum ahead ahead,
                       const struct monitor *monitor, struct slow_branch *b)
{
    struct orbit_options options =
        orbit_defaults(&s->plane.system, s->plane.fastest_rate);
    struct drift drift;
    struct orbit o;

    drift_start(&drift, slider_rounding(s, z), 0.0);
    options.drift = &drift;
    options.rtol = TOL_REST_WRONG;
    options.observables = 1;
    options.target = goals->at;
    options.targets = goals->count;
    if (b->start == SLOW_FACE)
        options.arrival = TOL_ARREST * TOL_SEEN;
    enum status status = orbit_init(&o, &s->plane.system, z, &options);
    if (status != STATUS_OK)
        return STATUS_OK;
    if (o.end == ORBIT_RUNNING)
        status = follow(s, &o, ahead, monitor, b);
    if (status == STATUS_OK && b->count > 2) {
        slow_fit_smooth(b);
        slow_fit_fibres(b);
        slow_fit_places(s, b);
        b->end_aside = find_end_aside(&o, b);
        slow_fit_frictions(s, b);
        slow_bars_add(&o, b);
        look_back(b);
        slow_fit_digits(b);
        slow_fit_judge(s, b);
        status = finish(s, &o, goals->fate[o.end_index], b);
    }
    if (status == STATUS_OK && b->count > 2)
        status = fill_bins(b);
    orbit_free(&o);
    return status;
}

enum status slow_branch_run(const struct slider *s, struct vec2 z,
                            enum slow_start start,
                            const struct saddle_series *near,
                            const struct monitor *monitor,
                            struct slow_branch *b)
{
    struct goals goals;
    enum status status = STATUS_OK;

    *b = (struct slow_branch){ .start = start,
                               .fate = FATE_UNDECIDED,
                               .near = near };
    if (near)
        b->first = saddle_series_on(near, z.y);
    enum ahead ahead =
        find_goals(s, z, start, &goals) ? AHEAD_NODE : AHEAD_NEITHER;
    bool ends = ahead == AHEAD_NODE || start == SLOW_RUNAWAY;
    if (!ends)
        status = comes_to_rest(s, z, &ends, &ahead);
    if (status == STATUS_OK && ends)
        status = run(s, z, &goals, ahead, monitor, b);
    return status;
}

bool slow_branch_may_start(const struct slider *s, int fast, struct vec2 z)
{
    const double u[] = { z.x, z.y };
    struct slow_knot k;

    slow_knot_at(s, u, 0.0, &k);
    return k.gap < TOL_CLEARLY && !slow_knot_is_noisy(&k) &&
           slow_knot_is_fast_y(&k) == (fast == 1);
}

void slow_branch_free(struct slow_branch *b)
{
    free(b->knot);
    free(b->bin);
    *b = (struct slow_branch){ .fate = FATE_UNDECIDED };
}
