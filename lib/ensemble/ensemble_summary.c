#include "ensemble_summary.h"

#include <math.h>
#include <stdlib.h>

#include "quantile.h"
#include "shares.h"
#include "variate.h"

const double ensemble_quantile[ENSEMBLE_QUANTILES] = { 0.025, 0.16, 0.5, 0.84,
                                                       0.975 };

/* A block of a column, and what is added up. */
struct sums {
    double value[SPOOL_DRAWS], error[SPOOL_DRAWS];
    int8_t code[SPOOL_DRAWS], reason[SPOOL_DRAWS];
    struct tally value_sum, error_sum, exists;
    struct tally fate[FATES + 1], arrest;
    struct variate variate;
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

/* One draw: whether its fate is f, less what is known to even out. */
static void add_fate(const struct ensemble *e, struct sums *s, size_t i,
                     int fate)
{
    const size_t r = draws_repeat(&e->draws, i);
    double off[FATES + 1], stops = 0.0;

    variate_at(&s->variate, i, off);
    for (int f = 0; f <= (int) FATES; f++) {
        const double one = (f == fate ? 1.0 : 0.0) - off[f];
        tally_add(&s->fate[f], r, one);
        stops += fate_stops(f) ? one : 0.0;
    }
    tally_add(&s->arrest, r, stops);
}

static enum status add_fates(struct ensemble *e, struct sums *s, size_t k,
                             size_t block, struct fault *why)
{
    struct ensemble_push *p = &e->push[k];
    enum status status =
        spool_read(&e->spool, block, SPOOL_FATE, k, s->code, why);

    if (status == STATUS_OK)
        status =
            spool_read(&e->spool, block, SPOOL_FATE_REASON, k, s->reason, why);
    for (size_t i = 0; i < spool_count(&e->spool, block) && !status; i++) {
        const int fate = s->code[i] < 0 ? (int) FATES : s->code[i];
        add_fate(e, s, block * SPOOL_DRAWS + i, fate);
        p->count[fate]++;
        p->reason[s->reason[i]]++;
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
    for (int f = 0; f <= (int) FATES; f++) {
        p->fate[f] = tally_share(&s->fate[f], d);
        beyond += fmax(-p->fate[f].value, 0.0);
    }
    for (int f = 0; f <= (int) FATES; f++) {
        p->fate[f].value = fmax(p->fate[f].value, 0.0) / (1.0 + beyond);
        p->arrest.value += fate_stops(f) ? p->fate[f].value : 0.0;
    }
}

static enum status sum_push(struct ensemble *e, struct sums *s, size_t k,
                            struct fault *why)
{
    struct ensemble_push *p = &e->push[k];

    *p = (struct ensemble_push){ .at = e->batch.push[k] };
    p->from = p->at.from_creep ? "creep" : "";
    p->unit = p->at.is_si ? "m s-1" : "V_star";
    p->state = p->at.is_phi ? "phi" : "psi";
    if (p->at.from_creep)
        p->at.psi = (double) NAN;
    s->arrest = (struct tally){ 0 };
    for (int f = 0; f <= (int) FATES; f++)
        s->fate[f] = (struct tally){ 0 };
    enum status status = variate_fit(&s->variate, &e->spool, &e->draws, k, why);
    for (size_t b = 0; b < spool_blocks(&e->spool) && !status; b++)
        status = add_fates(e, s, k, b, why);
    tell_fates(p, s, &e->draws);
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
