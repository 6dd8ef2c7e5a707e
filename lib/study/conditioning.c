/*
 * One input at a time is multiplied by 1 - h and 1 + h.  Near a fold that may
 * be too far: numbers whose two differences are unlike, or which a neighbour
 * lacks, wait for a smaller h.  L, V_star and g enter through
 * eps^2 = V_star^2/(g L) alone: moving g speaks for all three.
 */
#include "conditioning.h"

#include <math.h>
#include <stdlib.h>

#include "scene_slope.h"
#include "study_results.h"
#include "study_tolerance.h"

enum {
    INPUT_ALPHA = MATERIAL_KEYS,
    INPUT_OWN, /* names of the law's own */
    INPUTS = INPUT_OWN + LAW_OWNS,
    NUMBERS_MAX = 512
};

/* The numbers of a study, in a fixed order. */
struct numbers {
    struct quantity *at[NUMBERS_MAX]; /* borrowed */
    size_t count;
};

static void add(struct numbers *n, const void *q)
{
    if (n->count < NUMBERS_MAX)
        n->at[n->count++] = (struct quantity *) (uintptr_t) q;
}

static void add_records(struct numbers *n, const struct record_array *a)
{
    for (size_t i = 0; i < a->count; i++)
        for (size_t k = 0; k < a->type->count; k++)
            if (a->type->fields[k].kind == RECORD_QUANTITY)
                add(n, record_member(a, i, &a->type->fields[k]));
}

/* Records that the study holds, rather than makes for whoever looks. */
static enum status add_result(struct numbers *n, const struct results *all,
                              const struct result *r)
{
    const size_t count = result_count(r, all->run);
    enum status status = STATUS_OK;

    for (size_t k = 0; k < count && status == STATUS_OK; k++) {
        struct result_view v;
        status = result_open(all, r, k, &v);
        if (v.here && !v.owned)
            add_records(n, &v.records);
        result_close(&v);
    }
    return status;
}

/* Of the results that need nothing but STUDY_NUMBERS, and that one with these
 * stages was asked for. */
static enum status numbers_of(struct study *s, unsigned stages,
                              struct numbers *n)
{
    const struct results all = study_results(s);
    enum status status = study_keep(s, STUDY_NUMBERS);

    n->count = 0;
    for (size_t t = 0; all.table[t]; t++)
        for (const struct result *r = all.table[t]; r->type && !status; r++)
            if (r->name && result_asked(r, &all) && (r->needs & stages) &&
                !(r->needs & ~STUDY_NUMBERS))
                status = add_result(n, &all, r);
    return status;
}

/* ---- neighbours --------------------------------------------------------- */

struct neighbour {
    struct study study;
    struct scene scene;
    struct numbers numbers; /* of the study */
    bool found;
};

struct search {
    struct study *s;
    struct numbers numbers; /* of s */
    struct neighbour *here, *up, *down;
    struct sensitivities *exact;
    size_t evaluations;
};

/* The study with one input multiplied by `factor`, at an accuracy fit for
 * differences; only STATUS_NO_MEMORY is an error. */
static enum status recompute(struct search *f, int input, double factor,
                             struct neighbour *n)
{
    struct scene *c = &n->scene;
    struct fault why;

    *c = *f->s->scene; /* borrows what that owns */
    c->rtol = fmin(c->rtol, TOL_RTOL_DEFAULT);
    c->products = plan_products(f->s->stages & STUDY_NUMBERS);
    if (input == INPUT_ALPHA && factor != 1.0) {
        c->alpha *= factor;
        c->tan_alpha = tanl((long double) c->alpha);
    } else if (input >= INPUT_OWN) {
        c->material.own[input - INPUT_OWN] *= factor;
    } else if (input != INPUT_ALPHA) {
        *material_member(&c->material, (enum material_key) input) *= factor;
    }
    study_free(&n->study);
    n->found = false;
    if (c->alpha >= M_PI_2)
        return STATUS_OK;
    enum status status = study_run(&n->study, c, NULL, &why);
    n->found = status == STATUS_OK;
    if (n->found)
        status = numbers_of(&n->study, f->s->stages, &n->numbers);
    if (n->found)
        f->evaluations += study_cost(&n->study).field_evaluations;
    return status == STATUS_NO_MEMORY ? status : STATUS_OK;
}

/* ---- rates -------------------------------------------------------------- */

/* d q/d ln p from its neighbours; false where they do not tell it: one is
 * missing, or the two differences are unlike. */
static bool rate_of(const struct quantity *q, const struct quantity *up,
                    const struct quantity *down, double nudge, double *rate)
{
    const bool above = quantity_exists(up), below = quantity_exists(down);

    if (!quantity_exists(q) || (!above && !below))
        return !quantity_exists(q);
    if (!above || !below) {
        *rate = ((above ? up : down)->value - q->value) / nudge;
        return false;
    }
    const double first = up->value - down->value;
    const double second = up->value - 2.0 * q->value + down->value;
    const double noise = 10.0 * TOL_RTOL_DEFAULT * fabs(q->value);
    *rate = first / (2.0 * nudge);
    return fabs(second) <= TOL_CONDITION_BEND * fabs(first) + noise;
}

/* d q/d ln p of every number, infinite where it cannot be told; false if some
 * would rather have a smaller nudge. */
static bool find_rates(struct search *f, double nudge, double rate[],
                       bool settled[])
{
    const struct numbers *here = &f->here->numbers;
    const struct numbers *up = &f->up->numbers, *down = &f->down->numbers;
    bool all = true;

    if (!f->up->found || !f->down->found || up->count != here->count ||
        down->count != here->count)
        return false;
    for (size_t i = 0; i < here->count; i++) {
        if (!settled[i])
            settled[i] =
                rate_of(here->at[i], up->at[i], down->at[i], nudge, &rate[i]);
        all = all && settled[i];
    }
    return all;
}

/* A slope given by its tangent has one that is a double, and an angle whose
 * tangent is another. */
static bool given_by_tangent(const struct scene *c)
{
    return c->tan_alpha == (long double) (double) c->tan_alpha &&
           c->tan_alpha != tanl((long double) c->alpha);
}

/* How often the rounding of an input counts. */
static double weight_of(const struct scene *c, int input)
{
    const enum material_key key = (enum material_key) input;
    const double t = (double) c->tan_alpha;
    struct material m = c->material;

    if (input == INPUT_ALPHA && !scene_has_slope(c))
        return 0.0;
    if (input == INPUT_ALPHA) /* d ln alpha/d ln tan(alpha) */
        return given_by_tangent(c) ? t / ((1.0 + t * t) * c->alpha) : 1.0;
    if (input >= INPUT_OWN)
        return m.own[input - INPUT_OWN] != 0.0 ? 1.0 : 0.0;
    const double value = *material_member(&m, key);
    if (key == MATERIAL_L || key == MATERIAL_V_STAR || value == 0.0 ||
        !isfinite(value) || !law_uses(&c->law, key))
        return 0.0;
    return key == MATERIAL_G ? 4.0 : 1.0;
}

/* ---- the second opinion on sensitivities -------------------------------- */

static const struct {
    enum parameter parameter;
    int input;
} same[] = { { PARAMETER_ALPHA, INPUT_ALPHA },
             { PARAMETER_A, MATERIAL_A },
             { PARAMETER_B, MATERIAL_B },
             { PARAMETER_C, MATERIAL_C },
             { PARAMETER_R, MATERIAL_R },
             { PARAMETER_EPS2, MATERIAL_G },
             { PARAMETER_MU_STAR, MATERIAL_MU_STAR } };

/* Where d ln v/d ln p = rate contradicts *exact, the bar says so. */
static void hold_against(struct quantity *exact, double p, double rate)
{
    const double off = fabs(exact->value - rate / p);
    const double trust = TOL_CONDITION_TRUST * (1.0 + fabs(rate)) / fabs(p);

    if (quantity_exists(exact) && off > exact->error + trust)
        exact->error = off;
}

static void hold_all(struct search *f, int input, const double rate[],
                     const bool settled[])
{
    const struct scene *c = f->s->scene;
    struct material m = c->material;

    for (size_t k = 0; k < sizeof same / sizeof *same; k++) {
        const enum parameter which = same[k].parameter;
        if (same[k].input != input)
            continue;
        const double p = which == PARAMETER_ALPHA ? c->alpha
                         : which == PARAMETER_EPS2
                             ? -material_eps2(&m) /* ~ 1/g */
                             : *material_member(&m, (enum material_key) input);
        for (size_t i = 0; i < f->numbers.count; i++) {
            const struct quantity *q = f->numbers.at[i];
            if (settled[i] && q == &f->s->slider.critical.ln_v_plus)
                hold_against(&f->exact->v_plus.by[which], p, rate[i]);
            if (settled[i] && q == &f->s->slider.critical.ln_v_minus)
                hold_against(&f->exact->v_minus.by[which], p, rate[i]);
        }
    }
}

/* ---- all inputs --------------------------------------------------------- */

static enum status add_input(struct search *f, int input, double weight)
{
    double rate[NUMBERS_MAX], nudge = TOL_CONDITION_NUDGE;
    bool settled[NUMBERS_MAX] = { false };
    enum status status;

    for (size_t i = 0; i < f->numbers.count; i++)
        rate[i] = HUGE_VAL;
    do {
        status = recompute(f, input, 1.0 + nudge, f->up);
        if (status == STATUS_OK)
            status = recompute(f, input, 1.0 - nudge, f->down);
        if (status != STATUS_OK)
            return status;
    } while (!find_rates(f, nudge, rate, settled) &&
             (nudge *= TOL_CONDITION_SHRINK) >= TOL_CONDITION_NUDGE_MIN);
    for (size_t i = 0; i < f->numbers.count; i++) {
        struct quantity *q = f->numbers.at[i];
        if (quantity_exists(q) && q->value != 0.0)
            q->conditioning += weight * 0x1p-53 * fabs(rate[i] / q->value);
    }
    hold_all(f, input, rate, settled);
    return STATUS_OK;
}

static enum status add_inputs(struct search *f, const struct monitor *monitor)
{
    enum status status = recompute(f, INPUT_ALPHA, 1.0, f->here);

    if (status != STATUS_OK || !f->here->found ||
        f->here->numbers.count != f->numbers.count)
        return status; /* at a loose rtol knees may come and go */
    for (size_t i = 0; i < f->numbers.count; i++)
        if (quantity_exists(f->numbers.at[i]))
            f->numbers.at[i]->conditioning = 0.0;
    for (int input = 0; input < INPUTS && status == STATUS_OK; input++) {
        const double weight = weight_of(f->s->scene, input);
        if (monitor_tell(monitor, "sensitivities", (uint64_t) input, INPUTS))
            return STATUS_STOPPED;
        if (weight > 0.0)
            status = add_input(f, input, weight);
    }
    return status;
}

enum status conditioning_find(struct study *s, const struct monitor *monitor,
                              struct sensitivities *exact, size_t *evaluations)
{
    struct neighbour *n = calloc(3, sizeof *n);

    if (n == NULL)
        return STATUS_NO_MEMORY;
    struct search f = {
        .s = s, .here = &n[0], .up = &n[1], .down = &n[2], .exact = exact
    };
    enum status status = numbers_of(s, s->stages, &f.numbers);
    if (status == STATUS_OK)
        status = add_inputs(&f, monitor);
    for (int i = 0; i < 3; i++)
        study_free(&n[i].study);
    free(n);
    *evaluations += f.evaluations;
    return status;
}
