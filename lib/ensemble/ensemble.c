#include "ensemble.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ensemble_summary.h"
#include "sweep_key.h"

bool ensemble_is_asked(const struct scene *scene)
{
    const struct scene_ensemble *e = &scene->ensemble;

    return e->parameters > 0 || e->samples || e->covariance;
}

/* ---- blocks -------------------------------------------------------------- */

/* A run, with what a block takes. */
struct run {
    struct ensemble *e;
    const struct sweep_options *o;
    const struct monitor *monitor;
    struct fault *why;
    double *key[SCENE_SPREADS]; /* columns of the spool's block */
    struct batch_column *out;   /* owned, with its reasons */
    struct batch_fates *fates;  /* owned, with its reasons */
    size_t first;               /* draw of the block */
};

static int tell(void *ctx, const char *stage, uint64_t done, uint64_t total)
{
    const struct run *r = ctx;

    (void) total;
    return monitor_tell(r->monitor, stage, r->first + done, r->e->draws.count);
}

/* The codes of a column's sentences; new ones go into the side file. */
static enum status set_codes(struct run *r, const char *const reason[],
                             size_t count, int8_t code[])
{
    struct sweep_reasons *all = &r->e->reasons;
    enum status status = STATUS_OK;

    for (size_t i = 0; i < count && status == STATUS_OK; i++) {
        const size_t known = all->count;
        code[i] = REASON_PRESENT;
        if (reason[i])
            status = sweep_reasons_code(all, reason[i], &code[i]);
        if (status == STATUS_OK && all->count > known)
            status =
                sweep_journal_reason(&r->e->spool.journal, reason[i], r->why);
    }
    return status;
}

static enum status code_block(struct run *r, size_t count)
{
    const struct batch *b = &r->e->batch;
    enum status status = STATUS_OK;

    for (size_t k = 0; k < b->numbers && status == STATUS_OK; k++)
        status = set_codes(r, r->out[k].reason, count,
                           spool_column(&r->e->spool, SPOOL_CODE, k));
    for (size_t k = 0; k < b->pushes && status == STATUS_OK; k++)
        status = set_codes(r, r->fates[k].reason, count,
                           spool_column(&r->e->spool, SPOOL_FATE_REASON, k));
    return status;
}

static void fill_keys(const struct run *r, size_t count)
{
    const size_t parts = (count + BATCH_DRAWS - 1) / BATCH_DRAWS;

#pragma omp parallel for
    for (size_t p = 0; p < parts; p++) {
        const size_t at = p * BATCH_DRAWS, left = count - at;
        double *column[SCENE_SPREADS];
        for (size_t k = 0; k < r->e->draws.keys; k++)
            column[k] = r->key[k] + at;
        draws_fill(&r->e->draws, r->first + at,
                   left < BATCH_DRAWS ? left : BATCH_DRAWS, column);
    }
}

static enum status run_block(struct run *r, size_t block)
{
    const struct monitor monitor = { tell, r };
    const size_t count = spool_count(&r->e->spool, block);

    r->first = block * SPOOL_DRAWS;
    fill_keys(r, count);
    enum status status =
        batch_run(&r->e->batch, count, (const double *const *) r->key, 0,
                  &monitor, r->out, r->fates);
    if (status == STATUS_OK)
        status = code_block(r, count);
    return status ? status : spool_push(&r->e->spool, block, r->why);
}

static enum status prepare(struct run *r)
{
    const struct batch *b = &r->e->batch;
    const struct spool *s = &r->e->spool;
    const size_t size = SPOOL_DRAWS * sizeof(const char *);
    bool good;

    r->out = calloc(b->numbers + 1, sizeof *r->out);
    r->fates = calloc(b->pushes + 1, sizeof *r->fates);
    good = r->out && r->fates;
    for (size_t k = 0; k < r->e->draws.keys; k++)
        r->key[k] = spool_column(s, SPOOL_KEY, k);
    for (size_t k = 0; k < b->numbers && good; k++) {
        r->out[k] = (struct batch_column){ spool_column(s, SPOOL_VALUE, k),
                                           spool_column(s, SPOOL_ERROR, k),
                                           malloc(size) };
        good = r->out[k].reason != NULL;
    }
    for (size_t k = 0; k < b->pushes && good; k++) {
        r->fates[k] =
            (struct batch_fates){ spool_column(s, SPOOL_FATE, k), malloc(size),
                                  spool_column(s, SPOOL_MARGIN, k) };
        good = r->fates[k].reason != NULL;
    }
    return good ? STATUS_OK : STATUS_NO_MEMORY;
}

/* The next of `count` blocks, *at first. */
static size_t next(const struct run *r, size_t count, size_t *at)
{
    const struct sweep_share *share = r->o->share;

    return share ? share->next(share->ctx, count) : (*at)++;
}

/* Those that are missing; of a share, its own. */
static enum status run_missing(struct run *r)
{
    const struct spool *s = &r->e->spool;
    const size_t blocks = spool_blocks(s);
    enum status status = STATUS_OK;
    size_t at = 0;

    for (size_t i; r->e->missing > 0 && status == STATUS_OK &&
                   (i = next(r, blocks, &at)) < blocks;)
        if (!s->there[i])
            status = run_block(r, i);
    r->e->missing = r->e->draws.count - spool_done(s);
    return status;
}

static enum status run_blocks(struct run *r)
{
    const struct batch *b = &r->e->batch;
    enum status status = prepare(r);

    if (status == STATUS_OK)
        status = run_missing(r);
    for (size_t k = 0; r->out && k < b->numbers; k++)
        free(r->out[k].reason);
    for (size_t k = 0; r->fates && k < b->pushes; k++)
        free(r->fates[k].reason);
    free(r->out);
    free(r->fates);
    return status;
}

/* ---- opening ------------------------------------------------------------- */

/* A number that is none has a place in the scene. */
static enum status blame_number(const struct scene *scene, struct fault *why)
{
    char text[sizeof why->text];

    memcpy(text, why->text, sizeof text);
    for (size_t i = 0; i < scene->ensemble.numbers; i++) {
        const struct scene_number *n = &scene->ensemble.number[i];
        const size_t size = strlen(n->name);
        const struct place at = { n->is_set ? NULL : scene->file, false,
                                  n->line, n->column };
        if (strncmp(text, n->name, size) == 0 && text[size] == ':')
            return place_blame(at, why, "ensemble.numbers: %.400s", text);
    }
    return STATUS_BAD_SCENE;
}

static enum status open_batch(struct ensemble *e, struct fault *why)
{
    const struct scene_ensemble *s = &e->scene->ensemble;
    const char *name[SCENE_NUMBERS];

    for (size_t i = 0; i < s->numbers; i++)
        name[i] = s->number[i].name;
    enum status status =
        batch_init(&e->batch, e->scene, e->draws.key, e->draws.keys,
                   s->number ? name : NULL, s->numbers, why);
    if (status == STATUS_OK)
        status = batch_push(&e->batch, s->push, s->pushes);
    return status == STATUS_BAD_ARGUMENT ? blame_number(e->scene, why) : status;
}

/* The same for the same scene, files and version. */
static uint64_t key_of(const struct ensemble *e, const char *version)
{
    const struct draws *d = &e->draws;
    uint64_t sum = sweep_key_sum(e->scene, version);

    for (size_t k = 0; k < d->keys; k++)
        sum = sweep_journal_sum(sum, d->key[k], strlen(d->key[k]) + 1);
    if (d->sample)
        sum = sweep_journal_sum(sum, d->sample,
                                d->keys * d->count * sizeof *d->sample);
    if (d->root) {
        sum = sweep_journal_sum(sum, d->mean, d->keys * sizeof *d->mean);
        sum = sweep_journal_sum(sum, d->root,
                                d->keys * d->keys * sizeof *d->root);
    }
    return sum;
}

/* No numbers, and no pushes either. */
static enum status check_asked(const struct scene *scene, struct fault *why)
{
    const struct scene_ensemble *e = &scene->ensemble;

    return e->number && e->numbers == 0 && e->pushes == 0
               ? place_blame((struct place){ scene->file, false, 0, 0 }, why,
                             "ensemble.numbers: none and no pushes, expected "
                             "either")
               : STATUS_OK;
}

static enum status begin(struct ensemble *e, const struct sweep_options *o,
                         struct fault *why)
{
    enum status status = check_asked(e->scene, why);

    if (status == STATUS_OK)
        status = draws_init(&e->draws, e->scene, why);

    if (status == STATUS_OK)
        status = open_batch(e, why);
    if (status == STATUS_OK)
        status = sweep_reasons_init(&e->reasons);
    const struct spool_shape shape = { e->draws.count, e->draws.keys,
                                       e->batch.numbers, e->batch.pushes };
    if (status == STATUS_OK)
        status = spool_open(&e->spool, o, key_of(e, o->version), &shape,
                            &e->reasons, &e->replaced, why);
    if (status == STATUS_OK)
        e->taken = spool_done(&e->spool);
    e->missing = e->draws.count - e->taken;
    return status;
}

/* ---- the whole ----------------------------------------------------------- */

enum status ensemble_run(struct ensemble *e, const struct scene *scene,
                         const struct sweep_options *options,
                         const struct monitor *monitor, struct fault *why)
{
    struct run r = { .e = e, .o = options, .monitor = monitor, .why = why };

    *e = ENSEMBLE_EMPTY;
    e->scene = scene;
    why->text[0] = '\0';
    enum status status = begin(e, options, why);
    if (status == STATUS_OK)
        status = run_blocks(&r);
    if (status == STATUS_OK && e->missing == 0 &&
        (options->share == NULL || options->join))
        status = ensemble_summary(e, why);
    if (status == STATUS_OK)
        return STATUS_OK;
    if (why->text[0] == '\0')
        snprintf(why->text, sizeof why->text, "%s", status_text(status));
    ensemble_free(e);
    return status;
}

void ensemble_free(struct ensemble *e)
{
    for (size_t k = 0; e->number && k < e->batch.numbers; k++)
        free(e->number[k].share);
    free(e->number);
    free(e->push);
    spool_close(&e->spool);
    sweep_reasons_free(&e->reasons);
    batch_free(&e->batch);
    draws_free(&e->draws);
    *e = ENSEMBLE_EMPTY;
}
