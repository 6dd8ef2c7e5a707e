/*
 * All pushes are found anew at X - h and X + h of each input, h^3 being what
 * orbits are known to, where rounding and bending of a central difference are
 * alike.  Numbers whose two differences are unlike, or which a neighbour lacks,
 * wait for a smaller h, as in neighbours.c.
 */
#include "push_scatter.h"

#include <math.h>
#include <stdlib.h>

#include "difference.h"
#include "neighbours.h"
#include "normal.h"
#include "scene_units.h"
#include "scene_vary.h"
#include "study_tolerance.h"

enum { HERE, UP, DOWN, AROUND };
enum { NUMBERS = 5 }; /* of an answer */

struct around {
    struct scene scene;         /* borrows */
    struct push_answer *answer; /* owned */
    struct unit_system units;   /* of the SI */
    bool found;
};

struct job {
    const struct push *p;
    const struct push_source *from;
    size_t count;
    struct around at[AROUND];
    struct push_state *state;    /* owned */
    struct neighbour_rate *rate; /* owned; [count * NUMBERS] */
};

/* Number k of an answer. */
static struct quantity *number_of(struct push_answer *a, int k)
{
    struct quantity *const q[NUMBERS] = { &a->slip, &a->time, &a->mu_mean,
                                          &a->v_kick, &a->psi_kick };
    return q[k];
}

static const struct unit *unit_of(int k)
{
    static const char *const unit[NUMBERS] = { "L", "L/V_star", "1", "1",
                                               "kick of psi" };
    return unit_find(unit[k]);
}

/* ---- neighbours ---------------------------------------------------------- */

static enum status answer(struct job *j, struct around *n, struct push *p)
{
    n->found = j->from->states(j->from->ctx, &n->scene, &p->slider, j->state);
    for (size_t i = 0; i < j->count && n->found; i++)
        n->found = push_holds(p, j->state[i]);
    enum status status = STATUS_OK;
    if (n->found && j->count > 1)
        status = push_tabulate(p, NULL);
    return status || !n->found
               ? status
               : push_find_all(p, j->state, j->count, NULL, n->answer);
}

/* All answers with an input moved, at an accuracy fit for differences (vary
 * NULL: as they are); only STATUS_NO_MEMORY is an error. */
static enum status recompute(struct job *j, int which,
                             const struct scene_vary *vary, double x)
{
    struct around *n = &j->at[which];
    struct push *p = malloc(sizeof *p);
    struct fault why;

    n->scene = *j->p->scene;
    n->scene.rtol = fmin(n->scene.rtol, TOL_RTOL_DEFAULT);
    n->found = false;
    if (p == NULL)
        return STATUS_NO_MEMORY;
    enum status status = STATUS_OK;
    if (vary == NULL || scene_vary_set(vary, x, &n->scene)) {
        status = push_init(p, &n->scene, NULL, &why);
        if (status == STATUS_OK) {
            status = answer(j, n, p);
            push_free(p);
        }
        n->units = scene_units(&n->scene);
        n->units.si = true;
    }
    free(p);
    return status == STATUS_NO_MEMORY ? status : STATUS_OK;
}

/* ---- rates --------------------------------------------------------------- */

static void set_rate(struct job *j, size_t i, int k, double nudge)
{
    struct neighbour_rate *rate = &j->rate[i * NUMBERS + (size_t) k];
    struct quantity own[AROUND], si[AROUND];

    for (int n = 0; n < AROUND; n++) {
        struct push_answer *a = &j->at[n].answer[i];
        own[n] = a->fate == j->at[HERE].answer[i].fate
                     ? *number_of(a, k)
                     : quantity_none("its fate is another");
        si[n] = unit_quantity(&j->at[n].units, unit_of(k), own[n]);
    }
    rate->settled = difference_rate(own, nudge, &rate->own);
    (void) difference_rate(si, nudge, &rate->si);
}

/* False if some would rather have a smaller nudge. */
static bool set_rates(struct job *j, double nudge)
{
    bool all = true;

    if (!j->at[UP].found || !j->at[DOWN].found)
        return false;
    for (size_t i = 0; i < j->count; i++)
        for (int k = 0; k < NUMBERS; k++) {
            struct neighbour_rate *r = &j->rate[i * NUMBERS + (size_t) k];
            if (!r->settled)
                set_rate(j, i, k, nudge);
            all = all && r->settled;
        }
    return all;
}

static enum status find_rates(struct job *j, const struct scene_spread *s,
                              double scale)
{
    const struct scene_vary vary = scene_vary_at(j->p->scene, s->key);
    double nudge = cbrt(TOL_ORBIT_RTOL);

    for (size_t i = 0; i < j->count * NUMBERS; i++)
        j->rate[i] = (struct neighbour_rate){ HUGE_VAL, HUGE_VAL, false };
    do {
        enum status status = recompute(j, UP, &vary, s->of[0] + nudge * scale);
        if (status == STATUS_OK)
            status = recompute(j, DOWN, &vary, s->of[0] - nudge * scale);
        if (status != STATUS_OK)
            return status;
    } while (!set_rates(j, nudge) &&
             (nudge *= 1.0 / TOL_RETRY) >= TOL_CONDITION_NUDGE);
    return STATUS_OK;
}

/* Squares are added up in the numbers themselves. */
static enum status add_input(struct job *j, const struct scene_spread *s,
                             struct push_answer answer[])
{
    const double x = fabs(s->of[0]), scale = x > 0.0 ? x : s->of[1];
    const enum status status = find_rates(j, s, scale);

    for (size_t i = 0; i < j->count && status == STATUS_OK; i++)
        for (int k = 0; k < NUMBERS; k++) {
            const struct neighbour_rate r = j->rate[i * NUMBERS + (size_t) k];
            struct quantity *q = number_of(&answer[i], k);
            if (!quantity_exists(q))
                continue;
            q->spread = hypot(q->spread, r.own * s->of[1] / scale);
            q->spread_si = hypot(q->spread_si, r.si * s->of[1] / scale);
        }
    return status;
}

/* ---- arrest -------------------------------------------------------------- */

/* The fate just beyond the separatrix. */
static enum fate fate_beyond(const struct push *p, const struct push_answer *a)
{
    struct vec2 z = block_offset(&p->slider.block, a->at.v, a->at.psi);
    const double by = log(a->v_kick.value);

    z.x += by * (1.0 + TOL_LITTLE) +
           copysign(2.0 * a->v_kick.error / a->v_kick.value, by);
    return labels_side(&p->labels, z);
}

static double arrest_of(const struct push *p, const struct push_answer *a)
{
    const struct quantity *q = &a->v_kick;

    if (!quantity_exists(q) || !(q->spread > 0.0) || isinf(q->spread))
        return (double) NAN;
    const enum fate beyond = fate_beyond(p, a);
    const bool stops = fate_stops(a->fate);
    if (a->fate == FATE_UNDECIDED || beyond == FATE_UNDECIDED ||
        stops == fate_stops(beyond))
        return (double) NAN;
    const double off = fabs(log(q->value)) * q->value / q->spread;
    return normal_below(stops ? off : -off);
}

/* ---- the whole ----------------------------------------------------------- */

static void begin(const struct job *j, struct push_answer answer[])
{
    for (size_t i = 0; i < j->count; i++)
        for (int k = 0; k < NUMBERS; k++) {
            struct quantity *q = number_of(&answer[i], k);
            if (quantity_exists(q))
                q->spread = q->spread_si = j->at[HERE].found ? 0.0 : HUGE_VAL;
        }
}

static enum status run(struct job *j, const struct monitor *monitor,
                       struct push_answer answer[])
{
    const struct scene_ensemble *e = &j->p->scene->ensemble;
    enum status status = recompute(j, HERE, NULL, 0.0);

    if (status == STATUS_OK)
        begin(j, answer);
    for (size_t k = 0; k < e->scattered && status == STATUS_OK; k++) {
        if (j->at[HERE].found)
            status = add_input(j, &e->parameter[k], answer);
        if (monitor_tell(monitor, "spread", k, e->scattered))
            status = STATUS_STOPPED;
    }
    for (size_t i = 0; i < j->count && status == STATUS_OK; i++)
        answer[i].arrest = arrest_of(j->p, &answer[i]);
    return status;
}

static enum status spread(const struct push *p, const struct push_source *from,
                          size_t count, const struct monitor *monitor,
                          struct push_answer answer[])
{
    struct job j = { .p = p, .from = from, .count = count };
    bool good;

    j.state = calloc(count + 1, sizeof *j.state);
    j.rate = calloc(count * NUMBERS + 1, sizeof *j.rate);
    good = j.state && j.rate;
    for (int n = 0; n < AROUND; n++) {
        j.at[n].answer = calloc(count + 1, sizeof *j.at[n].answer);
        good = good && j.at[n].answer;
    }
    const enum status status =
        good ? run(&j, monitor, answer) : STATUS_NO_MEMORY;
    for (int n = 0; n < AROUND; n++)
        free(j.at[n].answer);
    free(j.state);
    free(j.rate);
    return status;
}

enum status push_scatter_find(const struct push *p,
                              const struct push_source *from,
                              const struct push_state at[], size_t count,
                              const struct monitor *monitor,
                              struct push_answer answer[])
{
    const enum status s = push_find_all(p, at, count, monitor, answer);

    return s || p->scene->ensemble.scattered == 0
               ? s
               : spread(p, from, count, monitor, answer);
}
