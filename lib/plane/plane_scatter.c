/*
 * A parameter is moved by -h and +h, h^3 being what studies are known to, where
 * rounding and bending of a central difference are alike; where that is too far
 * by h^2.
 */
#include "plane_scatter.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "difference.h"
#include "plane_numbers.h"
#include "scene_parameter.h"
#include "tolerance.h"

enum { HERE, UP, DOWN, AROUND };

struct job {
    const struct plane_study *s;
    plane_scatter_numbers *numbers;
    void *ctx;
    size_t count;
    struct quantity *at[AROUND]; /* owned, of all numbers */
    struct rate {
        double value;
        bool settled;
    } * rate; /* owned */
};

/* ---- neighbours ---------------------------------------------------------- */

static void set_none(struct job *j, int which)
{
    for (size_t i = 0; i < j->count; i++)
        j->at[which][i] = quantity_none("");
}

/* By a study of that scene; only STATUS_NO_MEMORY is an error. */
static enum status study(struct job *j, const struct scene *c, int which)
{
    struct plane_study *n = malloc(sizeof *n);
    struct fault why;

    if (n == NULL)
        return STATUS_NO_MEMORY;
    enum status status = plane_study_run(n, c, NULL, &why);
    if (status == STATUS_OK) {
        status = j->numbers(j->ctx, n, j->at[which]);
        plane_study_free(n);
    }
    free(n);
    return status == STATUS_NO_MEMORY ? status : STATUS_OK;
}

/* All numbers with a parameter at x (key NULL: as they are). */
static enum status look(struct job *j, int which, const char *key, double x)
{
    struct scene c = *j->s->scene; /* borrows */
    struct formula_system *f = malloc(sizeof *f);
    enum status status = STATUS_OK;

    set_none(j, which);
    if (f == NULL)
        return STATUS_NO_MEMORY;
    *f = *c.system;
    c.system = f;
    c.rtol = fmin(c.rtol, TOL_RTOL_DEFAULT);
    c.products = 1u << PRODUCT_BASINS;
    c.ensemble.scattered = 0;
    c.audit = 0;
    c.proved = false;
    if (key == NULL || scene_parameter_set(f, key, x) == STATUS_OK)
        status = study(j, &c, which);
    free(f);
    return status;
}

/* ---- rates --------------------------------------------------------------- */

/* False if some would rather have a smaller h. */
static bool set_rates(struct job *j, double h)
{
    bool all = true;

    for (size_t i = 0; i < j->count; i++) {
        struct rate *r = &j->rate[i];
        const struct quantity q[] = { j->at[HERE][i], j->at[UP][i],
                                      j->at[DOWN][i] };
        if (!r->settled)
            r->settled = difference_rate(q, h, &r->value);
        all = all && r->settled;
    }
    return all;
}

/* Squares are added up in the numbers themselves. */
static enum status add_input(struct job *j, const struct scene_spread *p,
                             struct quantity *const q[])
{
    const double nudge[] = { cbrt(TOL_RTOL_DEFAULT), sqrt(TOL_RTOL_DEFAULT) };
    const double x = p->of[0], size = x != 0.0 ? fabs(x) : p->of[1];
    enum status status = STATUS_OK;
    bool all = false;

    for (size_t i = 0; i < j->count; i++)
        j->rate[i] = (struct rate){ HUGE_VAL, false };
    for (int k = 0; k < 2 && !all && status == STATUS_OK; k++) {
        status = look(j, UP, p->key, x + nudge[k] * size);
        if (status == STATUS_OK)
            status = look(j, DOWN, p->key, x - nudge[k] * size);
        all = set_rates(j, nudge[k] * size);
    }
    for (size_t i = 0; i < j->count; i++)
        if (quantity_exists(q[i]))
            q[i]->spread = q[i]->spread_si =
                hypot(q[i]->spread, p->of[1] * j->rate[i].value);
    return status;
}

static enum status run(struct job *j, const struct monitor *monitor,
                       struct quantity *const q[])
{
    const struct scene_ensemble *e = &j->s->scene->ensemble;
    enum status status = look(j, HERE, NULL, 0.0);

    for (size_t i = 0; i < j->count; i++)
        if (quantity_exists(q[i]))
            q[i]->spread = q[i]->spread_si = 0.0;
    for (size_t k = 0; k < e->scattered && status == STATUS_OK; k++) {
        status = add_input(j, &e->parameter[k], q);
        if (status == STATUS_OK &&
            monitor_tell(monitor, "spread", k, e->scattered))
            status = STATUS_STOPPED;
    }
    return status;
}

enum status plane_scatter_find(const struct plane_study *s,
                               plane_scatter_numbers *numbers, void *ctx,
                               size_t count, const struct monitor *monitor,
                               struct quantity *const q[])
{
    struct job j = { .s = s, .numbers = numbers, .ctx = ctx, .count = count };
    bool good;

    j.rate = calloc(count + 1, sizeof *j.rate);
    good = j.rate != NULL;
    for (int n = 0; n < AROUND; n++) {
        j.at[n] = calloc(count + 1, sizeof *j.at[n]);
        good = good && j.at[n];
    }
    const enum status status = good ? run(&j, monitor, q) : STATUS_NO_MEMORY;
    for (int n = 0; n < AROUND; n++)
        free(j.at[n]);
    free(j.rate);
    return status;
}

/* ---- shares -------------------------------------------------------------- */

enum { ELSEWHERE = 5 };

static struct quantity *elsewhere_at(struct plane_elsewhere *e, int k)
{
    struct quantity *const all[ELSEWHERE] = { &e->infinity, &e->outside,
                                              &e->singularity, &e->cycles,
                                              &e->undecided };
    return all[k];
}

/* By the names that the shares of ctx, a study, have; and elsewhere. */
static enum status shares_of(void *ctx, const struct plane_study *s,
                             struct quantity q[])
{
    const struct plane_basin *own = &((const struct plane_study *) ctx)->basin;
    const struct plane_basin *b = &s->basin;
    struct plane_elsewhere e = b->elsewhere;

    for (int k = 0; k < ELSEWHERE && !plane_numbers_lack(s); k++)
        q[own->shares + (size_t) k] = *elsewhere_at(&e, k);
    for (size_t i = 0; i < own->shares && !plane_numbers_lack(s); i++)
        for (size_t k = 0; k < b->shares; k++)
            if (strcmp(own->share[i].attractor, b->share[k].attractor) == 0)
                q[i] = b->share[k].fraction;
    return STATUS_OK;
}

enum status plane_scatter_shares(struct plane_study *s,
                                 const struct monitor *monitor)
{
    const size_t n = s->basin.shares;
    struct quantity **q = calloc(n + ELSEWHERE, sizeof *q);

    if (q == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < n; i++)
        q[i] = &s->basin.share[i].fraction;
    for (int k = 0; k < ELSEWHERE; k++)
        q[n + (size_t) k] = elsewhere_at(&s->basin.elsewhere, k);
    const enum status status =
        plane_scatter_find(s, shares_of, s, n + ELSEWHERE, monitor, q);
    free(q);
    return status;
}
