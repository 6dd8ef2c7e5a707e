/* Draws are computed a block at a time, so that what stands between the rooms'
 * reasons, which are sentences, and the caller's, which are numbers, stays
 * small. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "api.h"
#include "batch.h"
#include "sweep_reason.h"

enum { BLOCK = 4096 };

struct slipway_batch {
    struct scene scene;
    char **key; /* owned, and each text */
    size_t keys;
    struct batch batch;
    struct sweep_reasons reasons; /* codes are the caller's + REASON_PRESENT */
};

/* ---- opening ------------------------------------------------------------- */

/* The first key that is a slope, or V_c; NULL: none. */
static const char *first_of(const slipway_batch *b, bool slope)
{
    for (size_t k = 0; k < b->keys; k++)
        if (slope ? strncmp(b->key[k], "slope.", 6) == 0
                  : strcmp(b->key[k], "material.V_c") == 0)
            return b->key[k];
    return NULL;
}

/* A scene must have a slope, and V_c where the law needs it, unless they are
 * swept over: the batch's own stand in a sweep that nobody runs. */
static slipway_status read_scene(slipway_batch *b, const slipway_scene *scene,
                                 slipway_fault *why)
{
    struct slipway_scene with = *scene;
    char text[160], *end = text;
    const char *sep = "sweep=[";

    for (int slope = 0; slope < 2; slope++) {
        const char *key = first_of(b, slope);
        if (key)
            end += sprintf(end, "%s{key: %s, values: [0.5]}", sep, key);
        sep = key ? ", " : sep;
    }
    if (end == text)
        return api_read(scene, &b->scene, why);
    strcpy(end, "]");
    with.set = malloc((scene->sets + 1) * sizeof *with.set);
    if (with.set == NULL)
        return api_fault(why, SLIPWAY_NO_MEMORY, status_text(STATUS_NO_MEMORY));
    if (scene->sets > 0)
        memcpy(with.set, scene->set, scene->sets * sizeof *with.set);
    with.set[with.sets++] = text;
    const slipway_status s = api_read(&with, &b->scene, why);
    free(with.set);
    return s;
}

static enum status copy_keys(slipway_batch *b, const char *const key[],
                             size_t keys)
{
    b->key = calloc(keys + 1, sizeof *b->key);
    for (; b->key && b->keys < keys; b->keys++)
        if ((b->key[b->keys] = strdup(key[b->keys])) == NULL)
            return STATUS_NO_MEMORY;
    return b->key ? STATUS_OK : STATUS_NO_MEMORY;
}

static slipway_status open_batch(slipway_batch *b, const slipway_scene *scene,
                                 const char *const name[], size_t names,
                                 slipway_fault *why)
{
    struct fault fault = { "" };
    const slipway_status s = read_scene(b, scene, why);

    if (s != SLIPWAY_OK)
        return s;
    enum status status =
        batch_init(&b->batch, &b->scene, (const char *const *) b->key, b->keys,
                   name, names, &fault);
    if (status == STATUS_OK)
        status = sweep_reasons_init(&b->reasons);
    return api_answer(why, status, &fault);
}

slipway_status slipway_batch_open(const slipway_scene *scene,
                                  const char *const key[], size_t keys,
                                  const char *const name[], size_t names,
                                  slipway_batch **out, slipway_fault *why)
{
    slipway_batch *b = calloc(1, sizeof *b);

    if (b == NULL || copy_keys(b, key, keys) != STATUS_OK) {
        slipway_batch_free(b);
        return api_fault(why, SLIPWAY_NO_MEMORY, status_text(STATUS_NO_MEMORY));
    }
    const slipway_status s = open_batch(b, scene, name, names, why);
    if (s == SLIPWAY_OK)
        *out = b;
    else
        slipway_batch_free(b);
    return s;
}

void slipway_batch_free(slipway_batch *batch)
{
    if (batch == NULL)
        return;
    sweep_reasons_free(&batch->reasons);
    batch_free(&batch->batch);
    scene_free(&batch->scene);
    for (size_t k = 0; k < batch->keys; k++)
        free(batch->key[k]);
    free(batch->key);
    free(batch);
}

/* ---- running ------------------------------------------------------------- */

/* Of one call. */
struct call {
    slipway_batch *b;
    const double *const *column;
    const slipway_column *out;
    const double **at;         /* owned: the columns from the block on */
    struct batch_column *part; /* owned: where its numbers go */
    size_t count, first;       /* draws in all, the block's first */
    int threads;
    const slipway_monitor *monitor;
};

/* A block tells of all draws. */
static int tell(void *ctx, const char *stage, uint64_t done, uint64_t total)
{
    const struct call *c = ctx;

    (void) total;
    return c->monitor && c->monitor->tell
               ? c->monitor->tell(c->monitor->ctx, stage, c->first + done,
                                  c->count)
               : 0;
}

static enum status tell_reasons(struct call *c, size_t n, size_t some)
{
    const char *const *reason = c->part[n].reason;
    uint8_t *told = c->out[n].reason;
    enum status status = STATUS_OK;

    for (size_t i = 0; told && i < some && status == STATUS_OK; i++) {
        int8_t code = REASON_PRESENT;
        if (reason[i])
            status = sweep_reasons_code(&c->b->reasons, reason[i], &code);
        told[c->first + i] =
            (uint8_t) (code == REASON_ABSENT ? UINT8_MAX : code - 1);
    }
    return status;
}

static enum status run_block(struct call *c)
{
    const struct monitor monitor = { tell, c };
    const size_t left = c->count - c->first, some = left < BLOCK ? left : BLOCK;

    for (size_t k = 0; k < c->b->keys; k++)
        c->at[k] = c->column[k] + c->first;
    for (size_t n = 0; n < c->b->batch.numbers; n++) {
        const slipway_column *out = &c->out[n];
        c->part[n].value = out->value ? out->value + c->first : NULL;
        c->part[n].error = out->error ? out->error + c->first : NULL;
    }
    enum status status = batch_run(&c->b->batch, some, c->at, c->threads,
                                   &monitor, c->part, NULL);
    for (size_t n = 0; n < c->b->batch.numbers && status == STATUS_OK; n++)
        status = tell_reasons(c, n, some);
    c->first += some;
    return status;
}

static enum status prepare(struct call *c)
{
    const size_t names = c->b->batch.numbers;

    c->at = malloc((c->b->keys + 1) * sizeof *c->at);
    c->part = calloc(names + 1, sizeof *c->part);
    enum status status = c->at && c->part ? STATUS_OK : STATUS_NO_MEMORY;
    for (size_t n = 0; n < names && status == STATUS_OK; n++) {
        c->part[n].reason = malloc(BLOCK * sizeof *c->part[n].reason);
        status = c->part[n].reason ? STATUS_OK : STATUS_NO_MEMORY;
    }
    return status;
}

slipway_status slipway_batch_run(slipway_batch *batch, size_t count,
                                 const double *const column[], int threads,
                                 const slipway_monitor *monitor,
                                 const slipway_column out[], slipway_fault *why)
{
    struct call c = { .b = batch,
                      .column = column,
                      .out = out,
                      .count = count,
                      .threads = threads,
                      .monitor = monitor };
    if (threads < 0)
        return api_fault(why, SLIPWAY_BAD_ARGUMENT,
                         "threads below 0, expected 0 for those of OpenMP, or "
                         "how many");
    enum status status = prepare(&c);

    while (status == STATUS_OK && c.first < count)
        status = run_block(&c);
    for (size_t n = 0; c.part && n < batch->batch.numbers; n++)
        free(c.part[n].reason);
    free(c.part);
    free(c.at);
    return api_answer(why, status, NULL);
}

const char *slipway_batch_reason(const slipway_batch *batch, uint8_t reason)
{
    static const char *const other = "there are too many reasons to tell apart";
    const size_t code = (size_t) reason + REASON_PRESENT;

    if (reason == UINT8_MAX)
        return other;
    return reason > 0 && code < batch->reasons.count ? batch->reasons.text[code]
                                                     : NULL;
}
