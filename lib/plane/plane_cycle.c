#include "plane_cycle.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "plane_turn.h"
#include "taylor_orbit.h"
#include "tolerance.h"

const char *const plane_cycle_types[] = { "stable", "unstable", NULL };

size_t plane_cycle_find(const struct plane_study *s, const struct winding *w,
                        bool stable)
{
    for (size_t k = 0; k < s->cycles; k++) {
        const struct plane_cycle *c = &s->cycle[k];
        for (size_t i = 0; i < c->round.turns; i++)
            if (c->round.section == w->section &&
                (c->type == PLANE_CYCLE_STABLE) == stable &&
                vec2_length(arrival_from(&s->scale, w->at[0],
                                         c->round.at[i])) <= TOL_DRAWN)
                return k;
    }
    return s->cycles;
}

/* ---- whether it attracts ------------------------------------------------- */

/* dt is the way over the velocity.  Five Gauss points. */
void plane_cycle_divergence(const struct planar *sys, const struct curve *c,
                            size_t piece, double theta, double sum[2])
{
    static const double node[] = { 0.0, 0.5384693101056831, -0.5384693101056831,
                                   0.9061798459386640, -0.9061798459386640 };
    static const double weight[] = { 0.5688888888888889, 0.4786286704993665,
                                     0.4786286704993665, 0.2369268850561891,
                                     0.2369268850561891 };
    double slope[CURVE_DIM_MAX];
    struct planar_jacobian J;

    for (int k = 0; k < 10; k++) {
        const double t = 0.25 * theta * (1.0 + 2.0 * (k / 5) + node[k % 5]);
        curve_slope_at(c, piece, t, slope);
        sys->jacobian(sys->ctx, curve_point(c, piece, t), &J);
        const struct vec2 f = J.field.direction;
        const double dt =
            (slope[0] * f.x + slope[1] * f.y) / (f.x * f.x + f.y * f.y);
        const double part = 0.25 * theta * weight[k % 5] * dt;
        sum[0] += part * (J.matrix.xx + J.matrix.yy);
        sum[1] += part * (fabs(J.matrix.xx) + fabs(J.matrix.yy));
    }
}

/* The same of a round from an absolute point; the box around the middles and
 * the ends of its pieces; how far it leads, a multiple of the period of an
 * angle; whole: false where series were held back before they came round. */
struct round {
    bool whole;
    double sum[2];
    struct box around;
    struct vec2 way;
};

static void go_round(const struct plane_study *s, const struct winding *w,
                     struct vec2 z, bool stable, struct round *r)
{
    const struct planar *sys = &s->system[!stable];
    struct taylor_orbit o = taylor_orbit_at(
        sys, vec2_sub(z, sys->origin), s->scale.side, 0.01 * TOL_RTOL_DEFAULT);
    struct winding round = winding_from(w, &s->scale);
    double theta = 1.0, at[CURVE_DIM_MAX];
    size_t turns = 0, before;

    *r = (struct round){ .whole = true, .around = { z, z } };
    while (turns < w->turns) {
        r->whole = o.curve.count < TOL_EXPLICIT_STEPS &&
                   taylor_orbit_step(&o) == STATUS_OK;
        if (!r->whole)
            break;
        const size_t piece = o.curve.count - 1;
        for (int k = 1; k <= 2; k++) {
            curve_at(&o.curve, piece, 0.5 * k, at);
            r->around =
                box_around(r->around, vec2_add(sys->origin,
                                               (struct vec2){ at[0], at[1] }));
        }
        before = round.count;
        (void) winding_add(&round, sys, &s->scale, &o.curve, piece, NULL, 0);
        if (piece > 0 || w->section != WINDING_HIGHEST) /* it begins there */
            turns += round.count - before;
        theta = turns < w->turns ? 1.0 : round.theta[0];
        curve_at(&o.curve, piece, theta, at);
        plane_cycle_divergence(sys, &o.curve, piece, theta, r->sum);
    }
    for (int i = 0; i < 2 && turns > 0; i++)
        r->sum[i] *= (double) w->turns / (double) turns;
    r->way = vec2_sub(vec2_add(sys->origin, (struct vec2){ at[0], at[1] }), z);
    taylor_orbit_free(&o);
}

/* Where returns go to whose differences shrink by a factor whose ln is given.
 */
static struct vec2 limit_of(const struct plane_study *s,
                            const struct winding *w, double ln_factor)
{
    const struct vec2 step = arrival_from(&s->scale, w->at[0], w->at[w->turns]);
    const double go = 1.0 / expm1(-ln_factor);

    return vec2_add(w->at[0], (struct vec2){ go * step.x * s->scale.side.x,
                                             go * step.y * s->scale.side.y });
}

/* Whether orbits beside it come nearer, in that direction of time: ln of its
 * multiplier is the integral of the divergence over a round, and is not told
 * from 0 where it is less than a small part of what it is the difference of.
 * At a distance d it is ln m + O(d); or, where returns differ by c d^p, p > 1,
 * -p c d^(p-1), which at the limit that a constant factor would give, d/p, is
 * at most half of that: m is 1.  What is left, gap/(1 - m), is half of a round
 * where that is of a spiral into an equilibrium.  True where series are held
 * back: what is so stiff attracts. */
static bool attracts(const struct plane_study *s, const struct winding *w,
                     bool stable, struct round *on)
{
    const double *sum = on->sum;

    go_round(s, w, w->at[0], stable, on);
    if (!on->whole)
        return true;
    const double ln_factor = sum[0];
    if (!(ln_factor < -TOL_SAME * sum[1] &&
          w->round > 10.0 * fmax(w->gap, w->off) / -expm1(ln_factor)))
        return false;
    go_round(s, w, limit_of(s, w, ln_factor), stable, on);
    return !on->whole ||
           (sum[0] < -TOL_SAME * sum[1] && sum[0] < 0.75 * ln_factor);
}

/* Whether signs show that there is no such closed orbit: one that goes round an
 * angle has no inside, and of part of one the box is not known. */
static enum status is_forbidden(const struct plane_study *s,
                                const struct round *r, bool *none)
{
    const struct vec2 period = s->scale.period;

    *none = false;
    if (!r->whole)
        return STATUS_OK;
    if (2.0 * fabs(r->way.x) > period.x && period.x > 0.0)
        return STATUS_OK;
    if (2.0 * fabs(r->way.y) > period.y && period.y > 0.0)
        return STATUS_OK;
    return plane_turn_forbids(s, r->around, none);
}

/* ---- the list ------------------------------------------------------------ */

enum status plane_cycle_add(struct plane_study *s, const struct winding *w,
                            bool stable, size_t *index)
{
    struct round on;
    bool none;

    *index = plane_cycle_find(s, w, stable);
    if (*index < s->cycles || !attracts(s, w, stable, &on))
        return STATUS_OK;
    const enum status status = is_forbidden(s, &on, &none);
    if (status != STATUS_OK || none)
        return status;
    struct plane_cycle *more =
        realloc(s->cycle, (s->cycles + 1) * sizeof *more);
    if (more == NULL)
        return STATUS_NO_MEMORY;
    s->cycle = more;
    struct plane_cycle *c = &s->cycle[s->cycles];
    *c = (struct plane_cycle){ .type = stable ? PLANE_CYCLE_STABLE
                                              : PLANE_CYCLE_UNSTABLE,
                               .round = *w };
    snprintf(c->word, sizeof c->word, "cycle_%zu", s->cycles++);
    for (size_t k = 0; k < s->cycles; k++) /* they may have moved */
        s->cycle[k].name = s->cycle[k].word;
    return STATUS_OK;
}
