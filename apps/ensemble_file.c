#include "ensemble_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "provenance.h"
#include "result_file.h"
#include "scene_ensemble.h"
#include "store_grid.h"
#include "store_records.h"
#include "sweep_key.h"

static const char group[] = "/ensemble";

/* What all columns share. */
struct file {
    const struct ensemble *e;
    struct store *out;
    void *values; /* owned; of a block */
    struct fault *why;
};

/* ---- columns ------------------------------------------------------------- */

static enum status put_column(const struct file *f, enum spool_kind kind,
                              size_t k, const struct record_field *field)
{
    static const char *const draw[] = { "draw" };
    const struct spool *s = &f->e->spool;
    enum status status = store_put_cube(f->out, group, field, 1, draw);

    for (size_t b = 0; b < spool_blocks(s) && status == STATUS_OK; b++) {
        status = spool_read(s, b, kind, k, f->values, f->why);
        if (status == STATUS_OK)
            status = store_put_rows(f->out, group, field, b * SPOOL_DRAWS,
                                    spool_count(s, b), f->values);
    }
    return status;
}

/* The last word of its path; of two keys with the same, the path. */
static const char *name_of(const struct draws *d, size_t k)
{
    const char *name = strrchr(d->key[k], '.') + 1;

    for (size_t i = 0; i < d->keys; i++)
        if (i != k && strcmp(strrchr(d->key[i], '.') + 1, name) == 0)
            return d->key[k];
    return name;
}

static enum status put_key(const struct file *f, size_t k)
{
    const struct draws *d = &f->e->draws;
    const struct sweep_key key = sweep_key_of(d->key[k]);

    return put_column(f, SPOOL_KEY, k,
                      &(struct record_field){ .name = name_of(d, k),
                                              .unit = key.unit,
                                              .text = key.text,
                                              .kind = RECORD_REAL });
}

static enum status put_number(const struct file *f, size_t k)
{
    const struct result_number *n = f->e->number[k].of;
    struct record_field field = { .name = n->name,
                                  .unit = n->field->unit,
                                  .text = n->field->text,
                                  .kind = RECORD_REAL };
    char name[RESULT_NAME + 8], text[256];
    enum status status = put_column(f, SPOOL_VALUE, k, &field);

    field.name = name;
    field.text = text;
    snprintf(name, sizeof name, "%s_error", n->name);
    snprintf(text, sizeof text, "%.200s: bound on the absolute error",
             n->field->text);
    if (status == STATUS_OK)
        status = put_column(f, SPOOL_ERROR, k, &field);
    field.unit = "1";
    field.kind = RECORD_CODE;
    field.codes = sweep_reasons_words(&f->e->reasons);
    snprintf(name, sizeof name, "%s_exists", n->name);
    snprintf(text, sizeof text, "%.200s: whether it exists, or why not",
             n->field->text);
    return status ? status : put_column(f, SPOOL_CODE, k, &field);
}

static enum status put_fates(const struct file *f, size_t k)
{
    char name[32];

    snprintf(name, sizeof name, "push_%zu", k);
    return put_column(
        f, SPOOL_FATE, k,
        &(struct record_field){ .name = name,
                                .unit = "1",
                                .text = "what becomes of the pushed state",
                                .kind = RECORD_CODE,
                                .codes = fate_names });
}

/* ---- the axis ------------------------------------------------------------ */

struct sample {
    int64_t draw;
    const char *id;
};
static const struct record_field sample_fields[] = {
    FIELD(sample, COUNT, draw, "1", "number of the draw"),
    FIELD(sample, TEXT, id, "1", "what the sample is called"),
};
static const struct record_type record_sample =
    RECORD_TYPE("sample", "the draws", sample_fields, sample);

static enum status put_samples(const struct file *f)
{
    const size_t count = f->e->draws.count;
    struct sample *at = malloc(count * sizeof *at);

    if (at == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < count; i++)
        at[i] = (struct sample){ (int64_t) i, draws_id(&f->e->draws, i) };
    const enum status status = store_put_records(
        f->out, group, &(struct record_array){ &record_sample, at, count },
        "draw");
    free(at);
    return status;
}

/* ---- what they say together ---------------------------------------------- */

#define REAL(struct_, member, unit_, text_)                                    \
    FIELD(struct_, REAL, member, unit_, text_)

/* A row a number; in its unit. */
struct number_row {
    const char *name, *unit;
    double exists, exists_error, mean, mean_error;
    double quantile_025, quantile_16, quantile_50, quantile_84, quantile_975;
};
static const struct record_field number_fields[] = {
    FIELD(number_row, TEXT, name, "1", "which number"),
    FIELD(number_row, TEXT, unit, "1", "its unit, and that of what follows"),
    REAL(number_row, exists, "1", "share of the draws where it exists"),
    REAL(number_row, exists_error, "1", "error of that, in 95 of 100 seeds"),
    REAL(number_row, mean, "1", "mean where it exists"),
    REAL(number_row, mean_error, "1", "error of the mean, in 95 of 100 seeds"),
    REAL(number_row, quantile_025, "1", "quantile 0.025"),
    REAL(number_row, quantile_16, "1", "quantile 0.16"),
    REAL(number_row, quantile_50, "1", "median"),
    REAL(number_row, quantile_84, "1", "quantile 0.84"),
    REAL(number_row, quantile_975, "1", "quantile 0.975"),
};
static const struct record_type record_number_row =
    RECORD_TYPE("number_row", "numbers", number_fields, number_row);

/* A row a number and a parameter. */
struct share_row {
    const char *name, *key;
    double share, share_error;
};
static const struct record_field share_fields[] = {
    FIELD(share_row, TEXT, name, "1", "which number"),
    FIELD(share_row, TEXT, key, "1", "of which parameter"),
    REAL(share_row, share, "1", "first-order share of the variance"),
    REAL(share_row, share_error, "1", "error of that, in 95 of 100 seeds"),
};
static const struct record_type record_share_row =
    RECORD_TYPE("share_row", "shares of variance", share_fields, share_row);

/* A row a push. */
struct push_row {
    const char *from, *unit, *state;
    double v, psi, arrest, arrest_error;
    struct estimate fate[FATES + 1];
};
#define FATE(code, word)                                                       \
    { .name = word,                                                            \
      .unit = "1",                                                             \
      .text = "probability of that",                                           \
      .offset = offsetof(struct push_row, fate[code].value),                   \
      .kind = RECORD_REAL },                                                   \
    {                                                                          \
        .name = word "_error", .unit = "1",                                    \
        .text = "error of that, in 95 of 100 seeds",                           \
        .offset = offsetof(struct push_row, fate[code].error),                 \
        .kind = RECORD_REAL                                                    \
    }
static const struct record_field push_fields[] = {
    FIELD(push_row, TEXT, from, "1", "creep: v is added to that state's"),
    FIELD(push_row, TEXT, unit, "1", "of v"),
    FIELD(push_row, TEXT, state, "1", "psi or phi, as the scene has it"),
    REAL(push_row, v, "1", "slip rate, or what is added to it"),
    REAL(push_row, psi, "1", "interfacial state"),
    REAL(push_row, arrest, "1", "probability that it creeps or rests"),
    REAL(push_row, arrest_error, "1", "error of that, in 95 of 100 seeds"),
    FATE(FATE_CREEP, "creep"),
    FATE(FATE_SLIDING, "sliding"),
    FATE(FATE_REST_FINITE, "rest_finite"),
    FATE(FATE_REST_ASYMPTOTIC, "rest_asymptotic"),
    FATE(FATE_RUNAWAY, "runaway"),
    FATE(FATE_UNDECIDED, "undecided"),
    FATE(FATES, "none"),
};
static const struct record_type record_push_row_of_draws =
    RECORD_TYPE("push_row", "pushes", push_fields, push_row);

static enum status put_numbers(const struct file *f)
{
    const size_t n = f->e->batch.numbers;
    struct number_row *at = calloc(n + 1, sizeof *at);

    if (at == NULL)
        return STATUS_NO_MEMORY;
    for (size_t k = 0; k < n; k++) {
        const struct ensemble_number *x = &f->e->number[k];
        const double *q = x->quantile;
        at[k] = (struct number_row){ x->of->name,
                                     x->of->field->unit,
                                     x->exists.value,
                                     x->exists.error,
                                     x->mean.value,
                                     x->mean.error,
                                     q[0],
                                     q[1],
                                     q[2],
                                     q[3],
                                     q[4] };
    }
    const enum status status = store_put_records(
        f->out, "/ensemble_numbers",
        &(struct record_array){ &record_number_row, at, n }, NULL);
    free(at);
    return status;
}

static enum status put_shares(const struct file *f)
{
    const size_t keys = f->e->draws.keys, n = f->e->batch.numbers * keys;
    struct share_row *at = calloc(n + 1, sizeof *at);

    if (at == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < n; i++) {
        const struct ensemble_number *x = &f->e->number[i / keys];
        const struct estimate *s = &x->share[i % keys];
        at[i] = (struct share_row){ x->of->name, f->e->draws.key[i % keys],
                                    s->value, s->error };
    }
    const enum status status = store_put_records(
        f->out, "/ensemble_variance",
        &(struct record_array){ &record_share_row, at, n }, NULL);
    free(at);
    return status;
}

static enum status put_pushes(const struct file *f)
{
    const size_t n = f->e->batch.pushes;
    struct push_row *at = calloc(n + 1, sizeof *at);

    if (at == NULL)
        return STATUS_NO_MEMORY;
    for (size_t k = 0; k < n; k++) {
        const struct ensemble_push *p = &f->e->push[k];
        at[k] = (struct push_row){
            .from = p->at.from_creep ? "creep" : "",
            .unit = p->at.is_si ? "m s-1" : "V_star",
            .state = p->at.is_phi ? "phi" : "psi",
            .v = p->at.v,
            .psi = p->at.from_creep ? (double) NAN : p->at.psi,
            .arrest = p->arrest.value,
            .arrest_error = p->arrest.error,
        };
        memcpy(at[k].fate, p->fate, sizeof at[k].fate);
    }
    const enum status status = store_put_records(
        f->out, "/ensemble_pushes",
        &(struct record_array){ &record_push_row_of_draws, at, n }, NULL);
    free(at);
    return status;
}

static enum status put_head(const struct file *f)
{
    const struct draws *d = &f->e->draws;
    char keys[SCENE_SPREADS * 32] = "";

    for (size_t k = 0; k < d->keys; k++)
        snprintf(keys + strlen(keys), sizeof keys - strlen(keys), "%s%s",
                 k ? " " : "", d->key[k]);
    enum status status = store_put_text(f->out, group, "keys", keys);
    if (status == STATUS_OK)
        status = store_put_text(
            f->out, group, "method",
            d->is_sample ? "samples" : ensemble_method_names[d->method]);
    return status;
}

/* ---- the whole ----------------------------------------------------------- */

static enum status put_all(const struct file *f)
{
    const struct ensemble *e = f->e;
    enum status status = put_head(f);

    if (status == STATUS_OK)
        status = e->draws.id >= 0
                     ? put_samples(f)
                     : store_put_index(f->out, group, "draw",
                                       "number of the draw", e->draws.count);
    for (size_t k = 0; k < e->draws.keys && status == STATUS_OK; k++)
        status = put_key(f, k);
    for (size_t k = 0; k < e->batch.numbers && status == STATUS_OK; k++)
        status = put_number(f, k);
    for (size_t k = 0; k < e->batch.pushes && status == STATUS_OK; k++)
        status = put_fates(f, k);
    if (status == STATUS_OK)
        status = put_numbers(f);
    if (status == STATUS_OK)
        status = put_shares(f);
    if (status == STATUS_OK && e->batch.pushes > 0)
        status = put_pushes(f);
    return status;
}

enum status ensemble_file_put(const struct ensemble *e, struct store *out,
                              struct fault *why)
{
    struct file f = { e, out, malloc(SPOOL_DRAWS * sizeof(double)), why };
    const enum status status = f.values ? put_all(&f) : STATUS_NO_MEMORY;

    free(f.values);
    return status;
}

enum status ensemble_file_write(const struct ensemble *e, const char *path,
                                struct fault *why)
{
    struct store *out;
    enum status status = result_file_begin_large(
        &out, path, e->scene,
        e->scene->system ? "system" : e->scene->law.preset, why);

    if (status != STATUS_OK)
        return status;
    status = provenance_put("ensemble", e->scene, out);
    if (status == STATUS_OK)
        status = ensemble_file_put(e, out, why);
    return result_file_end(&out, path, status, why);
}

/* ---- for the reference --------------------------------------------------- */

static const struct record_field head_fields[] = {
    { .name = "keys",
      .unit = "1",
      .text = "the keys that vary, in their order",
      .kind = RECORD_TEXT },
    { .name = "method",
      .unit = "1",
      .text = "sobol, random, grid, or samples of a file",
      .kind = RECORD_TEXT },
};
static const struct record_type record_head = {
    .name = "head", .text = "ensemble", .fields = head_fields, .count = 2
};

static const struct result ensemble_results[] = {
    { "/ensemble", NULL, "ensemble: every draw; its columns are below",
      RESULT_ATTRIBUTES, .type = &record_head },
    { "/ensemble", NULL,
      "with samples that have an id, and `draw` alone with others",
      RESULT_COLUMNS, .axis = "draw", .type = &record_sample },
    { "/ensemble_numbers", NULL, "ensemble: what the draws say of each number",
      RESULT_COLUMNS, .type = &record_number_row },
    { "/ensemble_variance", NULL,
      "ensemble: which parameter makes which part of its variance by itself",
      RESULT_COLUMNS, .type = &record_share_row },
    { "/ensemble_pushes", NULL, "ensemble: what the draws say of each push",
      RESULT_COLUMNS, .type = &record_push_row_of_draws },
    { .path = NULL },
};

const struct result *const ensemble_tables[] = { ensemble_results, NULL };
