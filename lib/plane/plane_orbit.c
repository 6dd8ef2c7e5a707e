/* By Taylor series in time; where these are held back, by the implicit method
 * of orbit.h from there on. */
#include "plane_orbit.h"

#include <math.h>
#include <stdlib.h>

#include "escape.h"
#include "orbit.h"
#include "plane_beyond.h"
#include "plane_cycle.h"
#include "plane_defined.h"
#include "plane_rest.h"
#include "plane_tolerance.h"
#include "plane_weak.h"
#include "taylor_orbit.h"
#include "tolerance.h"

/* ---- where it ends ------------------------------------------------------- */

/* The equilibrium whose trap holds the end of the orbit. */
static bool is_trapped(const struct plane_study *s, struct vec2 z,
                       bool backward, size_t *index)
{
    for (*index = 0; *index < s->rests; ++*index)
        if (plane_rest_traps(s, &s->rest[*index], backward, z))
            return true;
    return false;
}

static double apart(const struct plane_study *s, struct vec2 a, struct vec2 b)
{
    return vec2_length(arrival_from(&s->scale, a, b));
}

/* The cycle that returns come nearer and nearer to, or are on; s->cycles: none
 * known. */
static size_t cycle_ahead(const struct plane_study *s,
                          const struct windings *all, bool stable)
{
    for (size_t k = 0; k < s->cycles; k++) {
        const struct plane_cycle *c = &s->cycle[k];
        const struct winding *w = &all->of[c->round.section];
        const double d[] = { apart(s, w->at[0], c->round.at[0]),
                             apart(s, w->at[1], c->round.at[0]) };
        if ((c->type == PLANE_CYCLE_STABLE) == stable && c->round.turns == 1 &&
            w->count > 1 && d[0] <= TOL_SEEN &&
            d[0] < TOL_WINDING_SHRINK * d[1])
            return k;
    }
    const struct winding *on = windings_closed(all, &s->scale);
    return on ? plane_cycle_find(s, on, stable) : s->cycles;
}

/* ---- steps --------------------------------------------------------------- */

struct walk {
    const struct plane_study *s;
    struct planar *system;
    double far; /* how many windows far it is followed */
    bool backward, stiff, stopped;
    bool broken; /* formulas may have no values on the last piece */
    bool lost;   /* it has come to where rounding decides: plane_weak.h */
    int held;    /* steps in turn in which it hardly moved, and its velocity
                    hardly changed */
    int blurs;   /* steps outside the window that rounding held back */
    double first, least; /* differences of returns: the first, the least */
    struct taylor_orbit series;
    struct orbit implicit; /* once it is stiff */
    struct windings windings;
    struct escape escape;
    const struct plane_guide *guide; /* borrowed; or NULL */
    size_t due;                      /* the step at which it is asked next */
    struct plane_rounds own;
    struct interval_plan *plan; /* owned */
};

static const struct curve *curve_of(const struct walk *w)
{
    return w->stiff ? &w->implicit.curve : &w->series.curve;
}

/* Absolute. */
static struct vec2 place_of(const struct walk *w)
{
    const struct vec2 z =
        w->stiff ? (struct vec2){ w->implicit.u[0], w->implicit.u[1] }
                 : w->series.z;

    return vec2_add(w->system->origin, z);
}

/* Whether where curves are followed is behind it, and no state is small: what
 * doubles are too large for may come back. */
static bool is_far(const struct walk *w)
{
    const struct vec2 z = place_of(w), lo = w->s->system[0].domain.lo;

    return w->far > TOL_PLANE_FAR &&
           !(w->system->axis[0].is_log && z.x < lo.x) &&
           !(w->system->axis[1].is_log && z.y < lo.y);
}

static enum status be_implicit(struct walk *w)
{
    struct orbit_options options = orbit_defaults(w->system, w->s->kappa);

    options.rtol = TOL_ORBIT_RTOL;
    options.observables = 0;
    options.max_steps = is_far(w) ? TOL_EXPLICIT_STEPS : TOL_CURVE_STEPS;
    options.far = w->far > TOL_PLANE_FAR;
    w->stiff = true;
    return orbit_init(&w->implicit, w->system, w->series.z, &options);
}

/* Whether rounding has held back so many steps outside the window that more of
 * them would bring it nowhere, as beside a pole. */
static bool is_blurred(const struct walk *w)
{
    return w->blurs > TOL_MONITOR_STEPS;
}

/* The piece on which it returned last. */
static size_t returned(const struct walk *w)
{
    size_t last = 0;

    for (int i = 0; i < WINDING_SECTIONS; i++)
        if (w->windings.of[i].piece[0] > last)
            last = w->windings.of[i].piece[0];
    return last;
}

/* One piece more; w->stopped where there is none. */
static enum status step(struct walk *w)
{
    const struct vec2 from = place_of(w);
    enum status status;

    if (w->implicit.end == ORBIT_LEFT_DOMAIN) { /* that is larger now */
        w->series.z = (struct vec2){ w->implicit.u[0], w->implicit.u[1] };
        orbit_free(&w->implicit);
        w->stopped = be_implicit(w) != STATUS_OK;
        if (w->stopped)
            return STATUS_OK;
    }
    const size_t before = curve_of(w)->count;
    if (w->stiff) {
        status = orbit_step(&w->implicit);
    } else {
        status = taylor_orbit_step(&w->series);
        const struct vec2 way = arrival_from(&w->s->scale, place_of(w), from);
        const bool held =
            w->series.bent < TOL_LITTLE && vec2_length(way) < TOL_LITTLE;
        w->held = held ? w->held + 1 : 0;
        if (box_holds(w->system->domain, place_of(w)) &&
            (status == STATUS_NO_CONVERGENCE || w->held > TOL_MONITOR_STEPS ||
             before > returned(w) + TOL_EXPLICIT_STEPS)) {
            w->stopped = !plane_defined_near(w->plan, w->s, place_of(w),
                                             TOL_PLANE_STILL) ||
                         be_implicit(w) != STATUS_OK;
            return STATUS_OK;
        }
    }
    if (status == STATUS_NO_MEMORY)
        return status;
    w->blurs += !w->stiff && w->series.blurred &&
                !box_holds(w->s->window.box, place_of(w));
    w->stopped = curve_of(w)->count == before ||
                 w->series.curve.count >= TOL_CURVE_STEPS || is_blurred(w);
    return STATUS_OK;
}

/* ---- rounds about the window --------------------------------------------- */

static bool knows(const struct plane_rounds *r, const struct escape *e)
{
    return r->count > 1 && r->sense == e->sense && e->at >= r->at[0] &&
           e->at <= r->at[r->count - 1];
}

/* It has left for good, and is on the ray. */
static void come_round(struct walk *w, struct plane_goal *out)
{
    struct plane_rounds *own = &w->own;

    own->sense = w->escape.sense;
    if (w->guide == NULL)
        out->kind = PLANE_GOAL_LEFT;
    else if (knows(w->guide->rounds, &w->escape))
        *out = w->guide->rounds->goal;
    else if (own->count < PLANE_ROUNDS)
        own->at[own->count++] = w->escape.at;
}

/* What its rounds tell of others.  An equilibrium has sides; of an orbit that
 * leaves all bounds going round, no coordinate has a limit. */
static void keep_rounds(struct walk *w, struct plane_goal *out)
{
    if (out->kind == PLANE_GOAL_NONE && w->escape.left)
        out->kind = PLANE_GOAL_LEFT;
    if (w->guide == NULL || w->guide->rounds->count > 1 || w->own.count < 3 ||
        (out->kind == PLANE_GOAL_BEYOND && out->beyond.rests))
        return;
    for (int i = 0; i < 2; i++)
        out->beyond.way[i] = PLANE_WAY_UNKNOWN;
    *w->guide->rounds = w->own;
    w->guide->rounds->goal = *out;
}

/* Whether returns have come so near to each other that rounding brings them
 * past a closed orbit, and part again. */
static bool has_slipped_past(struct walk *w)
{
    const struct winding *h = &w->windings.of[WINDING_HIGHEST];

    if (h->count < 2)
        return false;
    const double gap = apart(w->s, h->at[0], h->at[1]);
    if (h->count == 2)
        w->first = w->least = gap;
    w->least = fmin(w->least, gap);
    return w->least <= TOL_WITHIN && 2.0 * w->least < w->first &&
           2.0 * w->least < gap;
}

/* ---- rotations ----------------------------------------------------------- */

/* The divergence along the piece before number `after`, up to where it returned
 * to z. */
static void divergence_to(const struct walk *w, size_t after, struct vec2 z,
                          double sum[2])
{
    double theta;

    (void) arrival_nearest(&w->s->scale, curve_of(w), after - 1,
                           w->system->origin, z, HUGE_VAL, &theta);
    plane_cycle_divergence(w->system, curve_of(w), after - 1, theta, sum);
}

static bool is_periodic(const struct walk *w, struct vec2 z, struct vec2 period)
{
    struct planar_field f[2];

    for (int i = 0; i < 2; i++)
        w->system->field(w->system->ctx, i ? vec2_add(z, period) : z, &f[i]);
    const double off = hypot(f[1].direction.x - f[0].direction.x,
                             f[1].direction.y - f[0].direction.y);
    return f[0].log_scale == f[1].log_scale &&
           off <= TOL_SAME * hypot(f[0].direction.x, f[0].direction.y);
}

/* Whether each round brings it as far as the one before, by a period of the
 * field: modulo that it winds on to a closed orbit, as that attracts. */
static bool rotates(const struct walk *w, struct plane_goal *out)
{
    const struct winding *h = &w->windings.of[WINDING_HIGHEST];
    const struct vec2 *at = h->at, by = vec2_sub(at[0], at[1]);
    const double gap = apart(w->s, by, vec2_sub(at[1], at[2])),
                 far = apart(w->s, at[0], at[1]);
    double sum[2] = { 0.0, 0.0 }, start[2] = { 0.0, 0.0 };

    if (w->stiff || h->count < 3 || !(gap <= TOL_WITHIN && far > TOL_SEEN))
        return false;
    for (size_t i = h->piece[1] - 1; i + 1 < h->piece[0]; i++) {
        if (!is_periodic(w, curve_point(curve_of(w), i, 0.0), by))
            return false;
        plane_cycle_divergence(w->system, curve_of(w), i, 1.0, sum);
    }
    divergence_to(w, h->piece[0], at[0], sum);
    divergence_to(w, h->piece[1], at[1], start);
    const double log_factor = sum[0] - start[0];
    if (!(log_factor < -TOL_SAME * sum[1] &&
          far > 10.0 * fmax(gap, h->off) / -expm1(log_factor)))
        return false;
    *out = (struct plane_goal){ .kind = PLANE_GOAL_BEYOND };
    for (int i = 0; i < 2; i++) {
        const double d =
            i ? by.y / w->s->scale.side.y : by.x / w->s->scale.side.x;
        out->beyond.way[i] = d > TOL_SEEN    ? PLANE_WAY_UP
                             : d < -TOL_SEEN ? PLANE_WAY_DOWN
                                             : PLANE_WAY_UNKNOWN;
    }
    return true;
}

/* What the last piece tells. */
static void look(struct walk *w, const struct vec2 rests[],
                 struct plane_goal *out)
{
    const struct curve *c = curve_of(w);
    const struct plane_study *s = w->s;
    const struct winding *h = &w->windings.of[WINDING_HIGHEST];
    const size_t returns = h->count;
    const bool flat = !(s->scale.period.x > 0.0 || s->scale.period.y > 0.0);

    const struct winding *round = windings_add(
        &w->windings, w->system, &s->scale, c, c->count - 1, rests, s->rests);
    if (round != NULL) {
        *out = (struct plane_goal){ .kind = PLANE_GOAL_CYCLE, .round = *round };
        return;
    }
    if (h->count > returns) {
        w->lost = has_slipped_past(w);
        if (rotates(w, out))
            return;
    }
    const size_t ahead = cycle_ahead(s, &w->windings, !w->backward);
    if (ahead < s->cycles)
        *out = (struct plane_goal){ .kind = PLANE_GOAL_CYCLE,
                                    .round = s->cycle[ahead].round };
    else if (flat &&
             escape_add(&w->escape, w->system, s->window.box, c,
                        c->count - 1) &&
             w->escape.left)
        come_round(w, out);
}

/* ---- where it breaks off ------------------------------------------------- */

/* At a place where formulas have no values, or one too near to tell. */
static void break_off(struct plane_goal *out)
{
    *out = (struct plane_goal){ .kind = PLANE_GOAL_BEYOND,
                                .beyond = { .rests = true, .breaks = true } };
}

/* At an equilibrium outside the window, if it is at rest there. */
static void come_to_rest(struct walk *w, double theta, struct plane_goal *out)
{
    const struct curve *c = curve_of(w);
    const struct vec2 z =
        vec2_add(w->system->origin, curve_point(c, c->count - 1, theta));
    struct plane_beyond end;

    if (plane_beyond_at(w->s, z, w->backward, false, &end))
        *out = (struct plane_goal){ .kind = PLANE_GOAL_BEYOND, .beyond = end };
}

/* Whether orbits get on all along the last piece, and it passes nothing that
 * may stop it. */
static bool goes_on(struct walk *w, struct plane_goal *out)
{
    const struct curve *c = curve_of(w);
    double theta;
    const enum plane_defined d = plane_defined_along(
        w->plan, w->s, c, c->count - 1, w->system->origin, &theta);

    w->broken = d != PLANE_DEFINED;
    w->escape.left = w->escape.left && d == PLANE_DEFINED;
    if (d == PLANE_DEFINED_BREAKS)
        break_off(out);
    if (d == PLANE_DEFINED_RESTS)
        come_to_rest(w, theta, out);
    w->lost = plane_weak_along(w->s, c, c->count - 1, w->system->origin,
                               TOL_SEEN, &theta);
    return d == PLANE_DEFINED && !w->lost;
}

/* ---- an orbit ------------------------------------------------------------ */

/* Whether the coordinate that is larger, in windows, grows no slower than the
 * other one: else that is the larger one in time, and nothing is known. */
static bool is_settled(const struct walk *w)
{
    const struct vec2 side = w->s->scale.side;
    const struct vec2 z = vec2_sub(place_of(w), w->s->system[0].origin);
    struct planar_field f;

    w->system->field(w->system->ctx, vec2_sub(place_of(w), w->system->origin),
                     &f);
    const double x = f.direction.x * z.y, y = f.direction.y * z.x;
    const double more = fabs(z.x) / side.x > fabs(z.y) / side.y
                            ? y / (z.x * z.y) - x / (z.x * z.y)
                            : x / (z.x * z.y) - y / (z.x * z.y);
    return !(more > TOL_SAME * fabs(x / (z.x * z.y)));
}

/* Whether it is beyond where orbits are followed, and does not come back: as is
 * proved, or as it goes round and round, or as far as numbers tell: a stiff one
 * by some steps more. */
static bool has_left(struct walk *w)
{
    const struct box d = w->system->domain;

    if (w->stopped && w->stiff && is_far(w))
        return !box_holds(w->s->system[0].domain, place_of(w));
    if (w->implicit.end != ORBIT_LEFT_DOMAIN && box_holds(d, place_of(w)))
        return false;
    if (w->escape.left ||
        plane_defined_escapes(w->plan, w->s, place_of(w), w->backward))
        return true;
    w->far *= TOL_PLANE_FAR;
    if (!(w->far <= TOL_PLANE_INFINITY)) {
        w->lost = !is_settled(w);
        return !w->lost;
    }
    w->system->domain = box_grow(d, TOL_PLANE_FAR);
    return false;
}

static size_t steps_of(const struct walk *w)
{
    return w->series.curve.count + w->implicit.steps + w->implicit.rejected;
}

/* Whether the guide knows where it is now: asked so seldom that answers, which
 * cost no more than steps, make a long orbit an eighth longer at most. */
static bool is_known(struct walk *w, struct plane_goal *out)
{
    const struct plane_guide *g = w->guide;
    const size_t steps = steps_of(w);

    if (g == NULL || g->knows == NULL || steps < w->due)
        return false;
    w->due = steps + 1 + steps / 8;
    return g->knows(g->ctx, place_of(w), out);
}

/* Whether the orbit ends where it is now. */
static bool arrives(struct walk *w, struct plane_goal *out)
{
    const struct vec2 here = place_of(w);
    struct plane_beyond end;

    if (w->broken || w->lost || is_known(w, out))
        return true;
    if (is_trapped(w->s, here, w->backward, &out->index)) {
        out->kind = PLANE_GOAL_REST;
    } else if (plane_beyond_at(w->s, here, w->backward, has_left(w), &end)) {
        out->kind = PLANE_GOAL_BEYOND;
        out->beyond = end;
        for (int i = 0; i < 2 && w->escape.left && !end.rests; i++)
            out->beyond.way[i] = PLANE_WAY_UNKNOWN;
    } else {
        return w->stopped || windings_closed(&w->windings, &w->s->scale);
    }
    return true;
}

/* So far it is followed: as far as from the window, from where it starts. */
static struct box domain_about(const struct planar *system, struct box window,
                               struct vec2 z)
{
    const struct box d = system->domain,
                     far = box_grow(box_around(window, z), TOL_PLANE_FAR);

    return box_holds(window, z) ? d : box_around(box_around(d, far.lo), far.hi);
}

enum status plane_orbit(const struct plane_study *s, struct vec2 z,
                        bool backward, const struct plane_guide *guide,
                        struct plane_goal *out)
{
    struct planar system = s->system[backward];
    struct walk w = { .s = s,
                      .system = &system,
                      .far = TOL_PLANE_FAR,
                      .backward = backward,
                      .lost = plane_weak_at(s, z, TOL_SEEN),
                      .windings = windings_begin(TOL_ORBIT_RTOL),
                      .guide = guide,
                      .plan = plane_defined_copy(s) };
    struct vec2 *rests = calloc(s->rests + 1, sizeof *rests);
    enum status status = rests && w.plan ? STATUS_OK : STATUS_NO_MEMORY;

    *out = (struct plane_goal){ .kind = PLANE_GOAL_NONE };
    for (size_t i = 0; i < s->rests && rests; i++)
        rests[i] = s->rest[i].z;
    system.domain = domain_about(&system, s->window.box, z);
    w.series = taylor_orbit_at(&system, vec2_sub(z, system.origin),
                               s->scale.side, TOL_ORBIT_RTOL);
    while (status == STATUS_OK && out->kind == PLANE_GOAL_NONE &&
           !arrives(&w, out)) {
        const size_t before = curve_of(&w)->count;
        status = step(&w);
        if (status == STATUS_OK && curve_of(&w)->count > before &&
            goes_on(&w, out))
            look(&w, rests, out);
    }
    w.lost = w.lost || is_blurred(&w);
    if (out->kind == PLANE_GOAL_NONE && w.stopped &&
        !plane_defined_near(w.plan, s, place_of(&w),
                            is_blurred(&w) ? TOL_SAME : TOL_PLANE_STILL))
        break_off(out);
    keep_rounds(&w, out);
    out->why = w.broken || w.lost                        ? PLANE_UNKNOWN_LOST
               : windings_closed(&w.windings, &s->scale) ? PLANE_UNKNOWN_CLOSED
                                                         : PLANE_UNKNOWN_STEPS;
    out->steps = steps_of(&w);
    if (out->kind == PLANE_GOAL_NONE)
        out->round = w.windings.of[WINDING_HIGHEST];
    taylor_orbit_free(&w.series);
    orbit_free(&w.implicit);
    free(w.plan);
    free(rests);
    if (out->kind == PLANE_GOAL_CYCLE)
        out->index = plane_cycle_find(s, &out->round, !backward);
    return status;
}
