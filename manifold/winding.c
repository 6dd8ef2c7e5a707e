#include "winding.h"

#include <math.h>
#include <string.h>

#include "tolerance.h"

/* ---- returns ------------------------------------------------------------- */

/* A piece of a curve, and how far it has been looked at. */
struct passage {
    const struct planar *sys;
    const struct arrival_scale *s;
    const struct curve *c;
    size_t piece;
    double theta;
};

static struct vec2 point_at(const struct passage *p, double theta)
{
    return curve_point(p->c, p->piece, theta);
}

static bool rises(const struct passage *p, double theta)
{
    struct planar_field f;

    p->sys->field(p->sys->ctx, point_at(p, theta), &f);
    return f.direction.y > 0.0;
}

/* Where the piece goes from up to down: seen from any side, in either
 * direction of time; w->up: what the field said where it began, then where it
 * ends. */
static bool is_highest(struct winding *w, struct passage *p)
{
    double lo = 0.0, hi = 1.0, along[CURVE_DIM_MAX];
    const bool first = w->up;

    w->up = rises(p, hi);
    curve_slope_at(p->c, p->piece, lo, along);
    if (w->up == first || !(along[1] > 0.0))
        return false;
    for (int i = 0; i < 52; i++) {
        const double middle = 0.5 * (lo + hi);
        *(rises(p, middle) == first ? &lo : &hi) = middle;
    }
    p->theta = hi;
    return true;
}

/* An absolute angle, in periods; 0 where it is none. */
static double rounds_of(const struct winding *w, const struct arrival_scale *s,
                        struct vec2 z)
{
    const bool x = w->section == WINDING_ROUND_X;
    const double period = x ? s->period.x : s->period.y;

    return period > 0.0 ? (x ? z.x : z.y) / period : 0.0;
}

static double rounds_at(const struct winding *w, const struct passage *p,
                        double theta)
{
    return rounds_of(w, p->s, vec2_add(p->sys->origin, point_at(p, theta)));
}

/* Where the piece next comes into a period that the curve was not in since the
 * last one new, the first such place aside.  One that goes through more than
 * are kept is of no orbit that closes. */
static bool is_round(struct winding *w, struct passage *p)
{
    const double end = floor(rounds_at(w, p, 1.0));

    if (!(fabs(end - w->period) <= WINDING_KEPT)) {
        w->period = end;
        w->mark = NAN;
        return false;
    }
    while (w->period != end) {
        const double way = end > w->period ? 1.0 : -1.0,
                     level = w->period + (way > 0.0 ? 1.0 : 0.0),
                     before = w->mark;
        double lo = p->theta, hi = 1.0;
        w->period += way;
        if (level == before)
            continue;
        w->mark = level;
        if (isnan(before))
            continue;
        for (int i = 0; i < 52; i++) {
            const double middle = 0.5 * (lo + hi);
            *(way * (rounds_at(w, p, middle) - level) < 0.0 ? &lo : &hi) =
                middle;
        }
        p->theta = hi;
        return true;
    }
    return false;
}

/* ---- closed orbits ------------------------------------------------------- */

static double between(const struct winding *w, const struct arrival_scale *s,
                      size_t i, size_t j)
{
    return vec2_length(arrival_from(s, w->at[i], w->at[j]));
}

/* Whether rounds of so many returns close. */
static bool closes(struct winding *w, const struct arrival_scale *s,
                   size_t turns, const struct vec2 equilibrium[], size_t n)
{
    if (w->count <= turns)
        return false;
    const double gap = between(w, s, 0, turns);
    if (w->count < 3 * turns + 1)
        return false;
    const double before = between(w, s, turns, 2 * turns);
    const bool rounded = gap <= fmax(TOL_ROUNDED, w->noise);
    const bool shrinks = gap <= TOL_WINDING_SHRINK * before || rounded;
    const double left = rounded ? gap : gap / (1.0 - gap / before);
    if (!(gap <= TOL_WITHIN && shrinks && w->away >= TOL_BESIDE &&
          w->round > TOL_SAME + 10.0 * left))
        return false;
    for (size_t i = 0; i < n; i++)
        if (vec2_length(arrival_from(s, w->at[0], equilibrium[i])) <=
            TOL_SAME + 10.0 * left)
            return false;
    w->turns = turns;
    w->gap = gap;
    return true;
}

static void begin(struct winding *w, const struct passage *p)
{
    w->start = vec2_add(p->sys->origin, point_at(p, 0.0));
    w->near = HUGE_VAL;
    w->up = rises(p, 0.0);
    w->period = floor(rounds_of(w, p->s, w->start));
}

/* What the piece tells before it is asked for returns. */
static void pass(struct winding *w, const struct passage *p)
{
    double theta;
    const struct vec2 u = point_at(p, 1.0), z = vec2_add(p->sys->origin, u);

    if (w->pieces++ == 0)
        begin(w, p);
    else
        w->near =
            fmin(w->near, arrival_nearest(p->s, p->c, p->piece, p->sys->origin,
                                          w->start, TOL_BESIDE, &theta));
    w->more += w->noise * (1.0 + hypot(u.x / p->s->side.x, u.y / p->s->side.y));
    if (w->count > 0)
        w->extent =
            fmax(w->extent, vec2_length(arrival_from(p->s, z, w->at[0])));
}

static void come_back(struct winding *w, const struct passage *p)
{
    w->round = w->extent;
    w->extent = 0.0;
    w->off = w->more;
    w->more = 0.0;
    w->away = w->near;
    w->near = HUGE_VAL;
    memmove(w->at + 1, w->at, (WINDING_KEPT - 1) * sizeof *w->at);
    memmove(w->theta + 1, w->theta, (WINDING_KEPT - 1) * sizeof *w->theta);
    memmove(w->piece + 1, w->piece, (WINDING_KEPT - 1) * sizeof *w->piece);
    w->at[0] = vec2_add(p->sys->origin, point_at(p, p->theta));
    w->piece[0] = w->pieces;
    w->theta[0] = p->theta;
    w->count++;
}

bool winding_add(struct winding *w, const struct planar *sys,
                 const struct arrival_scale *s, const struct curve *c,
                 size_t piece, const struct vec2 equilibrium[], size_t n)
{
    struct passage p = { sys, s, c, piece, 0.0 };

    pass(w, &p);
    while (w->section == WINDING_HIGHEST ? is_highest(w, &p)
                                         : is_round(w, &p)) {
        come_back(w, &p);
        for (size_t turns = 1; turns <= WINDING_MOST; turns++)
            if (closes(w, s, turns, equilibrium, n))
                return true;
    }
    return false;
}

struct winding winding_from(const struct winding *w,
                            const struct arrival_scale *s)
{
    return (struct winding){ .section = w->section,
                             .mark = round(rounds_of(w, s, w->at[0])) };
}

/* ---- returns of every kind ----------------------------------------------- */

struct windings windings_begin(double noise)
{
    struct windings w;

    for (int i = 0; i < WINDING_SECTIONS; i++)
        w.of[i] = (struct winding){ .section = (enum winding_section) i,
                                    .noise = noise,
                                    .mark = NAN };
    return w;
}

/* Whether rounds of so many of its returns have some of a kind before. */
static bool is_outranked(const struct windings *w, const struct winding *of,
                         size_t turns)
{
    for (const struct winding *h = w->of; h < of; h++)
        if (h->piece[0] > of->piece[turns] ||
            (h->piece[0] == of->piece[turns] && h->theta[0] > of->theta[turns]))
            return true;
    return false;
}

const struct winding *windings_add(struct windings *w, const struct planar *sys,
                                   const struct arrival_scale *s,
                                   const struct curve *c, size_t piece,
                                   const struct vec2 equilibrium[], size_t n)
{
    const bool has[] = { true, s->period.x > 0.0, s->period.y > 0.0 };
    const struct winding *closed = NULL;

    for (int i = 0; i < WINDING_SECTIONS; i++)
        if (has[i] &&
            winding_add(&w->of[i], sys, s, c, piece, equilibrium, n) &&
            closed == NULL && !is_outranked(w, &w->of[i], w->of[i].turns))
            closed = &w->of[i];
    return closed;
}

const struct winding *windings_closed(const struct windings *w,
                                      const struct arrival_scale *s)
{
    for (const struct winding *o = w->of; o < w->of + WINDING_SECTIONS; o++)
        if (o->count > 2 && between(o, s, 0, 1) <= o->off &&
            between(o, s, 1, 2) <= o->off && o->away < TOL_BESIDE &&
            !is_outranked(w, o, 2))
            return o;
    return NULL;
}
