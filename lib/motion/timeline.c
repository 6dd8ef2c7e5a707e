/* Turns of v, psi and mu are told from rounding, of which rates consist along
 * slow curves and near nodes, by the values there: one that moves back by more
 * than the orbit's tolerance has turned where it was largest or least. */
#include "timeline.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "event.h"
#include "moment.h"
#include "motion_tolerance.h"
#include "slider.h"

/* ---- doubt --------------------------------------------------------------- */

/* What the state's error does to the function is looked up in the corners of
 * its box, which takes rounding with it.  The ends of the stretch are found by
 * doubling: each is at most twice as far as it is. */

struct slider;

/* The largest changes over the stretch. */
struct doubt {
    double time, slip, x, y; /* components of the orbit */
    double mu;
};

/* A curve, by piece + theta, and what is watched along it. */
struct watched {
    const struct slider *slider;
    const struct event *event;
    const struct curve *curve;
    double s;
};

static double value_at(const struct watched *w, const double u[])
{
    return w->event->value(w->event->ctx, w->s, u) - w->event->level;
}

static void state_at(const struct watched *w, double at, double u[])
{
    const double last = (double) w->curve->count - 1.0;
    const double piece = fmin(floor(at), last);

    curve_at(w->curve, (size_t) piece, at - piece, u);
}

/* The largest change of the function in the box of half width `off`. */
static double change_within(const struct watched *w,
                            const struct event_hit *hit, double off)
{
    const double here = value_at(w, hit->u);
    double u[CURVE_DIM_MAX], most = 0.0;

    for (size_t i = 0; i < w->curve->dim; i++)
        u[i] = hit->u[i];
    for (int corner = 0; corner < 4; corner++) {
        u[0] = hit->u[0] + (corner & 1 ? off : -off);
        u[1] = hit->u[1] + (corner & 2 ? off : -off);
        most = fmax(most, fabs(value_at(w, u) - here));
    }
    return most;
}

/* The nearest state to one side, at distances that double, where the function
 * is larger than `allowed`; the end of the curve where it is not. */
static void leave(const struct watched *w, double at, int side, double allowed,
                  double u[])
{
    const double end = side > 0 ? (double) w->curve->count : 0.0;
    double far = TOL_ROUNDINGS_FEW * DBL_EPSILON;

    do {
        const double next = at + side * far;
        const bool ended = side > 0 ? next >= end : next <= end;
        state_at(w, ended ? end : next, u);
        if (ended)
            return;
        far *= 2.0;
    } while (!(fabs(value_at(w, u)) > allowed));
}

static void widen(struct doubt *d, const struct slider *s, const double here[],
                  const double there[])
{
    const struct vec2 z = { here[0], here[1] }, to = { there[0], there[1] };

    d->x = fmax(d->x, fabs(there[0] - here[0]));
    d->y = fmax(d->y, fabs(there[1] - here[1]));
    d->time = fmax(d->time, fabs(there[2] - here[2]));
    d->slip = fmax(d->slip, fabs(there[3] - here[3]));
    d->mu = fmax(d->mu, fabs(moment_excess_friction(s, to) -
                             moment_excess_friction(s, z)));
}

/* Of a hit of e on the curve c of an orbit in s (x, y, time, slip, ...), whose
 * x and y there are off by as much as `off` each, and e's function by as much
 * as `level` of its own. */
static struct doubt doubt_find(const struct slider *s, const struct event *e,
                               const struct event_hit *hit,
                               const struct curve *c, double off, double level)
{
    const struct watched w = { s, e, c, hit->s };
    const double at = (double) hit->piece + hit->theta;
    const double allowed = change_within(&w, hit, off) + level;
    struct doubt d = { 0.0, 0.0, 0.0, 0.0, 0.0 };
    double u[CURVE_DIM_MAX];

    for (int side = -1; side <= 1; side += 2) {
        leave(&w, at, side, allowed, u);
        widen(&d, s, hit->u, u);
    }
    return d;
}

/* One hit of an orbit. */
struct mark {
    const struct event_hit *hit; /* borrowed */
    enum moment what;
    bool kept;
};

struct marks {
    struct mark *at; /* owned, in the order of time */
    size_t count;
    const struct orbit *orbit;             /* borrowed */
    size_t from[EVENT_COUNT_MAX][MOMENTS]; /* of a kind: nearest, the last */
};

/* ---- turns --------------------------------------------------------------- */

static bool is_turn(enum moment what)
{
    return what == MOMENT_PSI_MIN || what == MOMENT_MU_MIN ||
           what == MOMENT_V_MIN;
}

static double turning(const struct slider *s, enum moment what,
                      const double u[])
{
    if (what == MOMENT_MU_MIN)
        return moment_excess_friction(s, (struct vec2){ u[0], u[1] });
    return what == MOMENT_PSI_MIN ? u[1] : u[0];
}

/* The largest and the least value since the last turn, and their marks: NULL
 * where that is an end of the orbit. */
struct swing {
    double least, hi, lo; /* least: the move back that counts */
    struct mark *at_hi, *at_lo;
    int direction; /* > 0 rising, < 0 falling, 0: not known yet */
};

static void keep(struct mark *m, enum moment what)
{
    if (m) {
        m->kept = true;
        m->what = what;
    }
}

/* The next value, at mark m; `what` is the minimum, the maximum follows it. */
static void swing_on(struct swing *w, double value, struct mark *m,
                     enum moment what)
{
    if (value > w->hi) {
        w->hi = value;
        w->at_hi = m;
    }
    if (value < w->lo) {
        w->lo = value;
        w->at_lo = m;
    }
    if (w->direction >= 0 && value < w->hi - w->least) {
        keep(w->at_hi, what + 1);
        w->direction = -1;
        w->lo = value;
        w->at_lo = m;
    } else if (w->direction <= 0 && value > w->lo + w->least) {
        keep(w->at_lo, what);
        w->direction = 1;
        w->hi = value;
        w->at_hi = m;
    }
}

/* Keeps the marks of one watch where something turns. */
static void keep_turns(const struct slider *s, struct marks *m, size_t which,
                       enum moment what)
{
    const struct curve *c = &m->orbit->curve;
    double u[CURVE_DIM_MAX];

    curve_at(c, 0, 0.0, u);
    const double start = turning(s, what, u);
    struct swing w = { .least = m->orbit->options.rtol,
                       .hi = start,
                       .lo = start };
    for (size_t i = 0; i < m->count; i++)
        if (m->at[i].hit->which == which)
            swing_on(&w, turning(s, what, m->at[i].hit->u), &m->at[i], what);
    curve_at(c, c->count - 1, 1.0, u);
    swing_on(&w, turning(s, what, u), NULL, what);
}

static void drop_rest(struct marks *m)
{
    size_t n = 0;

    for (size_t i = 0; i < m->count; i++)
        if (m->at[i].kept)
            m->at[n++] = m->at[i];
    m->count = n;
}

static enum status collect(const struct slider *s,
                           const struct moment_watches *w,
                           const struct orbit *o, struct marks *m)
{
    m->orbit = o;
    m->at = calloc(o->log.count + 1, sizeof *m->at);
    if (m->at == NULL)
        return STATUS_NO_MEMORY;
    for (m->count = 0; m->count < o->log.count; m->count++) {
        const struct event_hit *hit = &o->log.hit[m->count];
        const enum moment what = moment_of(w, hit);
        m->at[m->count] = (struct mark){ hit, what, !is_turn(what) };
    }
    for (size_t i = 0; i < w->count && o->curve.count > 0; i++)
        if (is_turn(w->watch[i].what))
            keep_turns(s, m, i, w->watch[i].what);
    drop_rest(m);
    return STATUS_OK;
}

/* ---- events -------------------------------------------------------------- */

/* The mark of m nearest in time to `to` among those of its kind, asked for one
 * `to` of a kind after the other, in the order of time: what is before the last
 * answer is further. */
static const struct mark *nearest(struct marks *m, const struct mark *to)
{
    size_t *from = &m->from[to->hit->which][to->what];
    const struct mark *best = NULL;
    double least = HUGE_VAL;

    for (size_t i = *from; i < m->count; i++) {
        const struct mark *k = &m->at[i];
        const double off = fabs(k->hit->u[2] - to->hit->u[2]);
        if (k->what != to->what || k->hit->which != to->hit->which)
            continue;
        if (best && off > least)
            break;
        if (best && !(off < least))
            continue;
        best = k;
        least = off;
        *from = i;
    }
    if (best == NULL)
        *from = m->count;
    return best;
}

/* What rounding does to a number along an orbit, relative. */
static double rounding_along(const struct orbit *o)
{
    return DBL_EPSILON *
           (TOL_TIMELINE_ROUNDING + TOL_TIMELINE_STEP * (double) o->steps);
}

/* The finer of two values, found on orbits as long as o; the bar holds the
 * other, and rounding. */
static struct quantity compare(const struct orbit *o, double coarse,
                               double fine)
{
    return quantity_of(fine, TOL_BAR_CHANCE * fabs(fine - coarse) +
                                 rounding_along(o) * fabs(fine));
}

/* A critical velocity has a bar of its own. */
static double level_error(const struct slider *s, enum moment what)
{
    const struct critical_numbers *c = &s->critical;

    return what == MOMENT_V_MINUS  ? c->ln_v_minus.error
           : what == MOMENT_V_PLUS ? c->ln_v_plus.error
                                   : 0.0;
}

/* What the steps up to there allow for, which two orbits may share: in the
 * state, and in when it is reached. */
static void add_step_errors(const struct slider *s,
                            const struct moment_watches *w,
                            const struct orbit *o, const struct event_hit *hit,
                            struct transient_event *e)
{
    const struct vec2 m = s->block.steep;
    const double size = o->peak[0] + o->peak[1];
    const double off =
        fmax(hit->error[0], hit->error[1]) + rounding_along(o) * size;
    const struct doubt d =
        doubt_find(s, &w->event[hit->which], hit, &o->curve, off,
                   level_error(s, (enum moment) e->what));

    e->time.error += d.time + hit->error[2];
    e->slip.error += d.slip + hit->error[3 + BLOCK_SLIP];
    e->v.error += e->v.value * expm1(d.x + off);
    e->psi.error += s->plane.system.axis[1].is_log
                        ? e->psi.value * expm1(d.y + off)
                        : d.y + off;
    e->mu.error += d.mu + (m.x + m.y) * off;
}

static struct transient_event event_at(const struct slider *s,
                                       const struct moment_watches *w,
                                       const struct orbit *o,
                                       const struct event_hit *coarse,
                                       const struct event_hit *fine,
                                       enum moment what)
{
    const double *c = coarse->u, *f = fine->u;
    const struct block *b = &s->block;
    const struct vec2 zc = { c[0], c[1] }, zf = { f[0], f[1] };
    struct transient_event e = {
        .what = (int8_t) what,
        .level = w->watch[fine->which].level,
        .time = compare(o, c[2], f[2]),
        .slip = compare(o, c[3 + BLOCK_SLIP], f[3 + BLOCK_SLIP]),
        .v = compare(o, block_v(b, c[0]), block_v(b, f[0])),
        .psi = compare(o, block_psi(b, c[1]), block_psi(b, f[1])),
        .mu = compare(o, block_mu(b, zc), block_mu(b, zf)),
    };

    add_step_errors(s, w, o, fine, &e);
    return e;
}

static size_t match(const struct slider *s, const struct moment_watches *w,
                    struct marks *coarse, struct marks *fine,
                    struct transient_event event[])
{
    size_t n = 0;

    for (size_t i = 0; i < fine->count; i++) {
        const struct mark *f = &fine->at[i], *c = nearest(coarse, f);
        if (c == NULL || nearest(fine, c) != f)
            continue;
        event[n++] = event_at(s, w, fine->orbit, c->hit, f->hit, f->what);
    }
    return n;
}

enum status timeline_find(const struct slider *s,
                          const struct moment_watches *w,
                          const struct orbit *coarse, const struct orbit *fine,
                          struct transient_event **event, size_t *count)
{
    struct marks c = { .at = NULL }, f = { .at = NULL };
    struct transient_event *found = NULL;
    enum status status = collect(s, w, coarse, &c);

    if (status == STATUS_OK)
        status = collect(s, w, fine, &f);
    if (status == STATUS_OK) {
        found = calloc(f.count + 1, sizeof *found); /* and rest */
        status = found ? STATUS_OK : STATUS_NO_MEMORY;
    }
    if (status == STATUS_OK) {
        *count = match(s, w, &c, &f, found);
        *event = found;
    }
    free(c.at);
    free(f.at);
    return status;
}
