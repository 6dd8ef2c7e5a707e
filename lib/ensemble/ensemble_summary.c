#include "ensemble_summary.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "quantile.h"
#include "shares.h"
#include "system.h"

const double ensemble_quantile[ENSEMBLE_QUANTILES] = { 0.025, 0.16, 0.5, 0.84,
                                                       0.975 };

/* A block of a column, and what is added up. */
struct sums {
    double value[SPOOL_DRAWS], error[SPOOL_DRAWS];
    int8_t code[SPOOL_DRAWS], goal[SPOOL_DRAWS];
    struct tally value_sum, error_sum, exists;
    struct tally fate[GOALS + 1], arrest;
    struct variate variate;
    int8_t of[REASONS_MAX]; /* of a system: the goal by its name's code */
};

/* ---- numbers ------------------------------------------------------------- */

static enum status add_block(struct ensemble *e, struct sums *s, size_t k,
                             size_t block, struct fault *why)
{
    struct ensemble_number *n = &e->number[k];
    enum status status =
        spool_read(&e->spool, block, SPOOL_VALUE, k, s->value, why);

    if (status == STATUS_OK)
        status = spool_read(&e->spool, block, SPOOL_ERROR, k, s->error, why);
    if (status == STATUS_OK)
        status = spool_read(&e->spool, block, SPOOL_CODE, k, s->code, why);
    for (size_t i = 0; i < spool_count(&e->spool, block) && !status; i++) {
        const size_t r = draws_repeat(&e->draws, block * SPOOL_DRAWS + i);
        const bool exists = s->code[i] == REASON_PRESENT;
        tally_add(&s->exists, r, exists ? 1.0 : 0.0);
        n->reason[s->code[i]]++;
        if (exists) {
            tally_add(&s->value_sum, r, s->value[i]);
            tally_add(&s->error_sum, r, s->error[i]);
        }
    }
    return status;
}

static enum status sum_number(struct ensemble *e, struct sums *s, size_t k,
                              struct fault *why)
{
    struct ensemble_number *n = &e->number[k];
    enum status status = STATUS_OK;

    *n = (struct ensemble_number){ .name = e->batch.number[k].name,
                                   .unit = e->batch.number[k].field->unit };
    s->value_sum = s->error_sum = s->exists = (struct tally){ 0 };
    n->share = calloc(e->draws.keys + 1, sizeof *n->share);
    if (n->share == NULL)
        return STATUS_NO_MEMORY;
    for (size_t b = 0; b < spool_blocks(&e->spool) && !status; b++)
        status = add_block(e, s, k, b, why);
    n->exists = tally_share(&s->exists, &e->draws);
    n->mean = tally_mean(&s->value_sum, &e->draws);
    n->mean.error += tally_mean(&s->error_sum, &e->draws).value;
    if (status == STATUS_OK)
        status = quantile_find(&e->spool, SPOOL_VALUE, k, ensemble_quantile,
                               ENSEMBLE_QUANTILES, n->quantile, why);
    return status ? status
                  : shares_find(&e->spool, &e->draws, k, n->mean.value,
                                n->share, why);
}

/* ---- pushes -------------------------------------------------------------- */

/* Of a system the names that its draws have come to, by count and then by name:
 * those beyond GOALS are one. */
static void set_goals(const struct ensemble *e, struct ensemble_push *p,
                      const size_t count[], int8_t of[])
{
    bool taken[REASONS_MAX] = { false };

    for (int f = 0; f < GOALS; f++) {
        size_t best = REASONS_MAX;
        for (size_t r = 0; r < e->reasons.count; r++)
            if (count[r] > 0 && !taken[r] &&
                (best == REASONS_MAX || count[r] > count[best] ||
                 (count[r] == count[best] &&
                  strcmp(e->reasons.text[r], e->reasons.text[best]) < 0)))
                best = r;
        if (best == REASONS_MAX)
            return;
        taken[best] = true;
        of[best] = (int8_t) f;
        p->word[f] = best == REASON_ABSENT || f == GOALS - 1
                         ? "others"
                         : e->reasons.text[best];
    }
}

static enum status find_goals(struct ensemble *e, struct sums *s, size_t k,
                              struct fault *why)
{
    size_t count[REASONS_MAX] = { 0 };
    enum status status = STATUS_OK;

    for (size_t b = 0; b < spool_blocks(&e->spool) && !status; b++) {
        status = spool_read(&e->spool, b, SPOOL_FATE, k, s->goal, why);
        if (status == STATUS_OK)
            status =
                spool_read(&e->spool, b, SPOOL_FATE_REASON, k, s->code, why);
        for (size_t i = 0; i < spool_count(&e->spool, b) && !status; i++)
            count[s->code[i]] += s->goal[i] >= 0;
    }
    memset(s->of, GOALS - 1, sizeof s->of);
    set_goals(e, &e->push[k], count, s->of);
    return status;
}

/* One draw: whether its goal is f, less what is known to even out. */
static void add_fate(const struct ensemble *e, struct sums *s, size_t i,
                     int goal)
{
    const size_t r = draws_repeat(&e->draws, i);
    double off[GOALS + 1], stops = 0.0;

    variate_at(&s->variate, i, off);
    for (int f = 0; f <= GOALS; f++) {
        const double one = (f == goal ? 1.0 : 0.0) - off[f];
        tally_add(&s->fate[f], r, one);
        stops += fate_stops(f) ? one : 0.0;
    }
    tally_add(&s->arrest, r, stops);
}

static enum status add_fates(struct ensemble *e, struct sums *s, size_t k,
                             const int8_t of[], size_t block, struct fault *why)
{
    struct ensemble_push *p = &e->push[k];
    enum status status = variate_goals(&e->spool, block, k, of, s->goal, why);

    if (status == STATUS_OK)
        status =
            spool_read(&e->spool, block, SPOOL_FATE_REASON, k, s->code, why);
    for (size_t i = 0; i < spool_count(&e->spool, block) && !status; i++) {
        add_fate(e, s, block * SPOOL_DRAWS + i, s->goal[i]);
        p->count[s->goal[i]]++;
        if (of == NULL || s->goal[i] == GOALS)
            p->reason[s->code[i]]++;
    }
    return status;
}

/* Estimates that add up to 1, as probabilities: none is below 0, by which
 * those that are exceeded 1 otherwise. */
static void tell_fates(struct ensemble_push *p, const struct sums *s,
                       const struct draws *d)
{
    double beyond = 0.0;

    p->arrest = tally_share(&s->arrest, d);
    p->arrest.value = 0.0;
    for (int f = 0; f <= GOALS; f++) {
        p->fate[f] = tally_share(&s->fate[f], d);
        beyond += fmax(-p->fate[f].value, 0.0);
    }
    for (int f = 0; f <= GOALS; f++) {
        p->fate[f].value = fmax(p->fate[f].value, 0.0) / (1.0 + beyond);
        p->arrest.value += fate_stops(f) ? p->fate[f].value : 0.0;
    }
}

/* "v = 2500 V_star, psi = 10". */
static void say(const struct scene *scene, struct ensemble_push *p)
{
    const struct system_state *x = scene->system ? scene->system->state : NULL;
    const char *rate = p->at.is_si ? "m/s" : "V_star";

    if (x && p->at.from[0])
        snprintf(p->said, sizeof p->said, "%s with %.20s + %.6g, %.20s + %.6g",
                 p->at.from, x[0].name, p->at.v, x[1].name, p->at.psi);
    else if (x)
        snprintf(p->said, sizeof p->said, "%.40s = %.6g, %.40s = %.6g",
                 x[0].name, p->at.v, x[1].name, p->at.psi);
    else if (p->at.from_creep)
        snprintf(p->said, sizeof p->said, "from creep, kick %.6g %s", p->at.v,
                 rate);
    else
        snprintf(p->said, sizeof p->said, "v = %.6g %s, %s = %.6g", p->at.v,
                 rate, p->state, p->at.psi);
}

static void begin_push(const struct ensemble *e, size_t k, struct sums *s)
{
    struct ensemble_push *p = &e->push[k];

    *p = (struct ensemble_push){ .at = e->batch.push[k] };
    p->from = p->at.from_creep ? "creep" : "";
    p->unit = p->at.is_si ? "m s-1" : "V_star";
    p->state = p->at.is_phi ? "phi" : "psi";
    if (p->at.from_creep)
        p->at.psi = (double) NAN;
    say(e->scene, p);
    for (int f = 0; f < (int) FATES && e->scene->system == NULL; f++)
        p->word[f] = fate_names[f];
    s->arrest = (struct tally){ 0 };
    for (int f = 0; f <= GOALS; f++)
        s->fate[f] = (struct tally){ 0 };
}

static enum status sum_push(struct ensemble *e, struct sums *s, size_t k,
                            struct fault *why)
{
    const int8_t *of = e->scene->system ? s->of : NULL;
    enum status status = STATUS_OK;

    begin_push(e, k, s);
    if (of)
        status = find_goals(e, s, k, why);
    if (status == STATUS_OK)
        status = variate_fit(&s->variate, &e->spool, &e->draws, k, of, why);
    for (size_t b = 0; b < spool_blocks(&e->spool) && !status; b++)
        status = add_fates(e, s, k, of, b, why);
    tell_fates(&e->push[k], s, &e->draws);
    return status;
}

enum status ensemble_summary(struct ensemble *e, struct fault *why)
{
    struct sums *s = malloc(sizeof *s);
    enum status status = STATUS_OK;

    e->number = calloc(e->batch.numbers + 1, sizeof *e->number);
    e->push = calloc(e->batch.pushes + 1, sizeof *e->push);
    if (s == NULL || e->number == NULL || e->push == NULL)
        status = STATUS_NO_MEMORY;
    if (status == STATUS_OK)
        status = spool_sort(&e->spool, &e->reasons, why);
    for (size_t k = 0; k < e->batch.numbers && status == STATUS_OK; k++)
        status = sum_number(e, s, k, why);
    for (size_t k = 0; k < e->batch.pushes && status == STATUS_OK; k++)
        status = sum_push(e, s, k, why);
    free(s);
    return status;
}
