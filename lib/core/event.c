/* Sampling on equal parts of a piece, then newton_find on theta.  The sign at
 * the end of a piece is carried over to the next one: rounding between the
 * two polynomials cannot swallow a crossing at their joint. */
#include "event.h"

#include <math.h>
#include <stdlib.h>

#include "newton.h"
#include "room.h"
#include "tolerance.h"

/* One event on one piece, as a function of theta. */
struct along {
    const struct event *event;
    const struct curve *curve;
    double s0, h;
};

static double value_along(const void *ctx, double theta)
{
    const struct along *a = ctx;
    double u[CURVE_DIM_MAX];

    curve_at(a->curve, a->curve->count - 1, theta, u);
    return a->event->value(a->event->ctx, a->s0 + theta * a->h, u) -
           a->event->level;
}

static bool crosses(const struct event *e, double from, double to)
{
    const bool rising = from < 0.0 && to >= 0.0;
    const bool falling = from > 0.0 && to <= 0.0;

    return (rising && e->direction >= 0) || (falling && e->direction <= 0);
}

/* value[i] of event i < count at u, above its level. */
static void values_at(const struct event *e, size_t count, double s,
                      const double u[], double value[])
{
    double own = 0.0;

    for (size_t i = 0; i < count; i++) {
        if (i == 0 || e[i].value != e[i - 1].value || e[i].ctx != e[i - 1].ctx)
            own = e[i].value(e[i].ctx, s, u);
        value[i] = own - e[i].level;
    }
}

/* Where on [lo, hi] the sign changes; lo where it had changed already. */
static double locate(const struct along *a, double lo, double hi)
{
    struct newton_root root;
    const enum status s = newton_find(value_along, a, lo, hi, 0.0, &root);

    return s == STATUS_OK ? root.x : lo;
}

/* Inserts in ascending theta among the hits from `first` on. */
static enum status insert(struct event_log *log, size_t first, size_t which,
                          bool rising, double theta, const struct along *a)
{
    const enum status s = ROOM_FOR(log->hit, log->room, log->count + 1);
    if (s != STATUS_OK)
        return s;

    size_t i = log->count++;
    for (; i > first && log->hit[i - 1].theta > theta; i--)
        log->hit[i] = log->hit[i - 1];
    log->hit[i] = (struct event_hit){ .which = which,
                                      .rising = rising,
                                      .piece = a->curve->count - 1,
                                      .theta = theta,
                                      .s = a->s0 + theta * a->h };
    curve_at(a->curve, a->curve->count - 1, theta, log->hit[i].u);
    return STATUS_OK;
}

/* All events between two samples. */
static enum status scan_part(struct event_log *log, const struct event *e,
                             size_t count, struct along *a, double lo,
                             double hi)
{
    const size_t first = log->count;
    enum status s = STATUS_OK;
    double u[CURVE_DIM_MAX], to[EVENT_COUNT_MAX];

    curve_at(a->curve, a->curve->count - 1, hi, u);
    values_at(e, count, a->s0 + hi * a->h, u, to);
    for (size_t i = 0; i < count && s == STATUS_OK; i++) {
        a->event = &e[i];
        if (crosses(&e[i], log->last[i], to[i]))
            s = insert(log, first, i, log->last[i] < 0.0, locate(a, lo, hi), a);
        log->last[i] = to[i];
    }
    return s;
}

void event_begin(struct event_log *log, const struct event *e, size_t count,
                 double s, const double u[])
{
    values_at(e, count, s, u, log->last);
}

enum status event_scan(struct event_log *log, const struct event *e,
                       size_t count, const struct curve *c, double s0, double h,
                       double *end, size_t *stop)
{
    struct along a = { .curve = c, .s0 = s0, .h = h };
    const double part = *end / TOL_EVENT_SAMPLES;
    size_t next = log->count;

    *stop = count;
    for (int j = 0; j < TOL_EVENT_SAMPLES && count > 0; j++) {
        const double hi = j + 1 < TOL_EVENT_SAMPLES ? (j + 1) * part : *end;
        const enum status s = scan_part(log, e, count, &a, j * part, hi);
        if (s != STATUS_OK)
            return s;
        for (; next < log->count; next++) {
            if (e[log->hit[next].which].stop) {
                *end = log->hit[next].theta;
                *stop = log->hit[next].which;
                log->count = next + 1;
                return STATUS_OK;
            }
        }
    }
    return STATUS_OK;
}

void event_trim(struct event_log *log, struct curve *c, double end)
{
    const size_t piece = c->count - 1;
    const struct curve_piece *p = &c->piece[piece];

    for (size_t i = 0; i < c->dim; i++) {
        double *u = c->coef + p->first + i * (p->degree + 1);
        double power = 1.0;
        for (size_t j = 0; j <= p->degree; j++, power *= end)
            u[j] *= power;
    }
    for (size_t i = log->count; i-- > 0 && log->hit[i].piece == piece;)
        log->hit[i].theta = fmin(log->hit[i].theta / end, 1.0);
}

void event_drop(struct event_log *log, struct curve *c)
{
    c->coefs = c->piece[--c->count].first;
    while (log->count > 0 && log->hit[log->count - 1].piece == c->count)
        log->count--;
}

void event_free(struct event_log *log)
{
    free(log->hit);
    *log = EVENT_LOG_EMPTY;
}
