/* On a part of a piece p is within jet_spread_at of its value at the middle.
 * Parts that this cannot tell are halved, the first first. */
#include "plane_defined.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "jet.h"
#include "plane_tolerance.h"

/* ---- boxes --------------------------------------------------------------- */

/* Of the chart; infinite states are where no number is, and a positive one that
 * no double is small enough for is below the least. */
static enum interval_domain domain_of(struct interval_plan *p,
                                      const struct plane_study *s,
                                      const struct interval_double chart[2])
{
    struct interval_double box[2];
    struct interval_slope_double out[INTERVAL_RESULTS];

    for (int i = 0; i < 2; i++) {
        box[i] = (struct interval_double){ plane_state(s, i, chart[i].lo),
                                           plane_state(s, i, chart[i].hi) };
        if (s->system[0].axis[i].is_log)
            box[i].hi = fmax(box[i].hi, DBL_TRUE_MIN);
    }
    return interval_over_double(p, box, out);
}

static bool is_whole(struct interval_plan *p, const struct plane_study *s,
                     const struct interval_double chart[2])
{
    return domain_of(p, s, chart) == INTERVAL_WHOLE;
}

enum status plane_defined_plan(struct plane_study *s, struct fault *why)
{
    const struct formula_system *f = s->scene->system;
    const struct interval_double any = { -HUGE_VAL, HUGE_VAL },
                                 all[] = { any, any };
    const struct box w = s->window.box;
    const struct interval_double in_window[] = { { w.lo.x, w.hi.x },
                                                 { w.lo.y, w.hi.y } };
    struct formula *graph = &s->lowered->way[0][0].f;
    formula_real *value = calloc(FORMULA_NODES, sizeof *value);
    int state[2], rate[4], rest;

    s->plan = malloc(sizeof *s->plan);
    if (value == NULL || s->plan == NULL) {
        free(value);
        return STATUS_NO_MEMORY;
    }
    for (int i = 0; i < f->parameters; i++)
        value[f->parameter[i].node] = f->parameter[i].value;
    for (int k = 0; k < 2; k++) {
        state[k] = f->state[k].node;
        rate[2 + k] = f->rate[k];
        rate[k] = f->state[k].chart == CHART_POSITIVE &&
                          formula_take_out(graph, f->rate[k], state[k], &rest)
                      ? rest
                      : f->rate[k];
    }
    const enum status status =
        interval_plan(s->plan, graph, state, rate, 4, value, why);
    free(value);
    if (status != STATUS_OK)
        return STATUS_BAD_SCENE;
    s->entire = is_whole(s->plan, s, all);
    s->broken = !s->entire && !is_whole(s->plan, s, in_window);
    return STATUS_OK;
}

struct interval_plan *plane_defined_copy(const struct plane_study *s)
{
    struct interval_plan *out = malloc(sizeof *out);

    if (out)
        memcpy(out, s->plan, sizeof *out);
    return out;
}

enum interval_domain plane_defined_domain(struct interval_plan *plan,
                                          const struct plane_study *s,
                                          struct box b)
{
    const struct interval_double box[] = { { b.lo.x, b.hi.x },
                                           { b.lo.y, b.hi.y } };

    return s->entire ? INTERVAL_WHOLE : domain_of(plan, s, box);
}

bool plane_defined_in(struct interval_plan *plan, const struct plane_study *s,
                      struct box b)
{
    return plane_defined_domain(plan, s, b) == INTERVAL_WHOLE;
}

bool plane_defined_near(struct interval_plan *plan, const struct plane_study *s,
                        struct vec2 z, double part)
{
    const struct vec2 room = vec2_scale(part, s->scale.side);

    return plane_defined_in(
        plan, s, (struct box){ vec2_sub(z, room), vec2_add(z, room) });
}

/* Whether a box holds no equilibrium but one that is known. */
static bool is_known(const struct plane_study *s, struct vec2 lo,
                     struct vec2 hi)
{
    size_t i = 0;

    while (i < s->rests && !(box_holds(s->rest[i].alone, lo) &&
                             box_holds(s->rest[i].alone, hi)))
        i++;
    return i < s->rests;
}

/* Whether formulas have values, and no equilibrium that is not known is there;
 * nothing is asked where curves are not followed. */
static bool is_moving(struct interval_plan *p, const struct plane_study *s,
                      const struct interval_double chart[2])
{
    const struct box w = plane_study_box(s);
    const struct vec2 lo = { chart[0].lo, chart[1].lo },
                      hi = { chart[0].hi, chart[1].hi };
    const struct box far = s->system[0].domain;
    bool moves = (box_holds(w, lo) && box_holds(w, hi)) || is_known(s, lo, hi);

    if ((moves && s->entire) || hi.x < far.lo.x || hi.y < far.lo.y ||
        lo.x > far.hi.x || lo.y > far.hi.y)
        return true;
    if (!is_whole(p, s, chart))
        return false;
    for (int i = 0; i < 2; i++) {
        const struct interval_double rate = p->of_double[p->result[i]].value;
        moves = moves || rate.lo > 0.0 || rate.hi < 0.0;
    }
    return moves;
}

/* ---- the way out --------------------------------------------------------- */

/* The signs of a rate all over a box of the chart: 1 or -1, or 0 where it may
 * be either, or formulas may have no values. */
static int sign_over(struct interval_plan *p, const struct plane_study *s,
                     const struct interval_double chart[2], int axis)
{
    if (!is_whole(p, s, chart))
        return 0;
    const struct interval_double rate = p->of_double[p->result[axis]].value;
    return rate.lo > 0.0 ? 1 : rate.hi < 0.0 ? -1 : 0;
}

/* Whether orbits come in, or run along, where box[axis] ends at `to`: way 1
 * from above. */
static bool closes(struct interval_plan *p, const struct plane_study *s,
                   const struct interval_double box[2], int axis, double to,
                   int way)
{
    struct interval_double face[] = { box[0], box[1] };

    face[axis] = (struct interval_double){ to, to };
    return isinf(to) || sign_over(p, s, face, axis) == way;
}

/* An orbit that is at z, outside of the window on one side of it. */
struct leaving {
    struct interval_plan *plan;
    const struct plane_study *s;
    struct vec2 z;
    int axis, way, time; /* way, time: 1 or -1 */
};

/* From there outward, beside `other`. */
static void box_beyond(const struct leaving *l, struct interval_double other,
                       struct interval_double box[2])
{
    const double at = vec2_part(l->z, l->axis);

    box[l->axis] = l->way > 0 ? (struct interval_double){ at, HUGE_VAL }
                              : (struct interval_double){ -HUGE_VAL, at };
    box[1 - l->axis] = other;
}

/* Whether all that is there only goes further out, and stays beside it. */
static bool only_goes_out(const struct leaving *l, struct interval_double other)
{
    struct interval_double box[2];
    const int i = l->axis;

    box_beyond(l, other, box);
    return sign_over(l->plan, l->s, box, i) == l->way * l->time &&
           closes(l->plan, l->s, box, 1 - i, other.lo, l->time) &&
           closes(l->plan, l->s, box, 1 - i, other.hi, -l->time);
}

/* The rate of the chart all over a box of it where formulas have values. */
static struct interval_double rate_over(const struct leaving *l,
                                        const struct interval_double chart[2],
                                        int axis)
{
    const struct interval_plan *p = l->plan;
    const int node = p->result[axis];
    const struct interval_double rate = p->of_double[node].value;
    const double lo = plane_state(l->s, axis, chart[axis].lo),
                 hi = plane_state(l->s, axis, chart[axis].hi);

    if (!l->s->system[0].axis[axis].is_log || node != p->result[2 + axis])
        return rate;
    return (struct interval_double){ rate.lo / (rate.lo < 0.0 ? lo : hi),
                                     rate.hi / (rate.hi < 0.0 ? hi : lo) };
}

/* Whether a positive state x only falls, and the other coordinate w is in a
 * strip of such room meanwhile: over boxes of ln x, to where doubles end, w
 * moves by no more than the sum of |w'/(ln x)'| times their sides, and then by
 * less than that, however far orbits are followed, as it does in the last box.
 * They begin no lower than so far above that end. */
static bool falls_beside(const struct leaving *l, struct interval_double other,
                         double room)
{
    const double step = 2.5, above = 40.0, end = log(DBL_MIN);
    const int i = l->axis;
    struct interval_double box[2];
    double way = 0.0, last = 0.0;

    if (l->way > 0 || !l->s->system[0].axis[i].is_log)
        return false;
    box_beyond(l, other, box);
    for (double x = fmax(box[i].hi, end + above); x > end && way < room;
         x -= step) {
        box[i] = (struct interval_double){ x - step, x };
        if (!is_whole(l->plan, l->s, box))
            return false;
        const struct interval_double x_rate = rate_over(l, box, i),
                                     w_rate = rate_over(l, box, 1 - i);
        const double fall = l->time > 0 ? -x_rate.hi : x_rate.lo;
        if (!(fall > 0.0))
            return false;
        last = fmax(fabs(w_rate.lo), fabs(w_rate.hi)) / fall;
        way += last * step;
    }
    return way + last * TOL_PLANE_INFINITY * vec2_part(l->s->scale.side, i) <
           room;
}

/* Anywhere, above or below where it is, or in strips about it: of positive
 * states narrower ones, too, others being followed further. */
static bool leaves(const struct leaving *l)
{
    const bool log = l->s->system[0].axis[l->axis].is_log;
    const struct vec2 side = l->s->scale.side;
    const double other = vec2_part(l->z, 1 - l->axis);
    const struct interval_double any = { -HUGE_VAL, HUGE_VAL },
                                 above = { other, HUGE_VAL },
                                 below = { -HUGE_VAL, other };
    bool out = only_goes_out(l, any) || only_goes_out(l, above) ||
               only_goes_out(l, below);

    for (double part = 1.0; !out && part > (log ? TOL_SAME : TOL_SEEN);
         part *= log ? 0.1 : TOL_SEEN) {
        const double room = part * vec2_part(side, 1 - l->axis);
        const struct interval_double strip = { other - room, other + room };
        out = only_goes_out(l, strip) || falls_beside(l, strip, room);
    }
    return out;
}

bool plane_defined_escapes(struct interval_plan *plan,
                           const struct plane_study *s, struct vec2 z,
                           bool backward)
{
    bool out = false;

    for (int i = 0; i < 2 && !out; i++) {
        const double at = vec2_part(z, i);
        const int way = at > vec2_part(s->window.box.hi, i)   ? 1
                        : at < vec2_part(s->window.box.lo, i) ? -1
                                                              : 0;
        const struct leaving l = { plan, s, z, i, way, backward ? -1 : 1 };
        out = way != 0 && leaves(&l);
    }
    return out;
}

/* ---- pieces -------------------------------------------------------------- */

/* What a coordinate may be from lo to hi, inside of 0 to 1, rounded outward:
 * the spread and the value are no further off than by twice the spread's bound.
 */
static struct interval_double range_of(const double *coef, size_t degree,
                                       double lo, double hi)
{
    const double m = 0.5 * (lo + hi), at = jet_at(degree, coef, m);
    double size = 0.0;

    for (size_t k = 0; k <= degree; k++)
        size += fabs(coef[k]);
    const double off = jet_spread_at(degree, coef, m, 0.5 * (hi - lo)) +
                       (double) (4 * (degree + 1)) * DBL_EPSILON * size;
    return (struct interval_double){ at - off, at + off };
}

enum plane_defined plane_defined_along(struct interval_plan *plan,
                                       const struct plane_study *s,
                                       const struct curve *c, size_t piece,
                                       struct vec2 origin, double *theta)
{
    enum { WORK = 1000, DEPTH = 40 };
    const size_t degree = c->piece[piece].degree;
    double lo = 0.0, width = 1.0;

    for (int work = 0; lo < 1.0; work++) {
        struct interval_double box[2];
        for (int i = 0; i < 2; i++) {
            const double from = vec2_part(origin, i);
            box[i] = interval_add_double(
                (struct interval_double){ from, from },
                range_of(curve_component(c, piece, (size_t) i), degree, lo,
                         lo + width));
        }
        *theta = lo;
        if (is_moving(plan, s, box)) {
            lo += width;
            while (lo < 1.0 && fmod(lo, 2.0 * width) <= 0.0)
                width *= 2.0;
        } else if (width < ldexp(1.0, -DEPTH)) {
            return is_whole(plan, s, box) ? PLANE_DEFINED_RESTS
                                          : PLANE_DEFINED_BREAKS;
        } else if (work > WORK) {
            return PLANE_DEFINED_UNKNOWN;
        } else {
            width *= 0.5;
        }
    }
    return PLANE_DEFINED;
}
