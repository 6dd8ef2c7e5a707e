#include "ensemble_results.h"

#include <stdlib.h>
#include <string.h>

#include "ensemble.h"
#include "rows.h"

#define REAL(struct_, name_, member, text_)                                    \
    FIELD_AS(struct_, REAL, name_, member, "1", text_)
#define ESTIMATE(struct_, name_, member, text_, of)                            \
    REAL(struct_, name_, member.value, text_),                                 \
        REAL(struct_, name_ "_error", member.error,                            \
             "error of " of ", in 95 of 100 seeds")

/* ---- the draws ----------------------------------------------------------- */

struct head {
    char *keys; /* owned by its view */
    const char *method;
};
static const struct record_type record_head =
    RECORD(head, "head", "ensemble",
           FIELD(head, TEXT, keys, "1", "the keys that vary, in their order"),
           FIELD(head, TEXT, method, "1",
                 "sobol, random, grid, or samples of a file"));

static enum status view_head(const void *run, size_t k, struct result_view *out)
{
    const struct draws *d = &((const struct ensemble *) run)->draws;
    size_t size = sizeof(struct head) + 1;

    for (k = 0; k < d->keys; k++)
        size += strlen(d->key[k]) + 1;
    struct head *head = calloc(1, size);
    if (head == NULL)
        return STATUS_NO_MEMORY;
    head->keys = (char *) (head + 1);
    for (k = 0; k < d->keys; k++)
        strcat(strcat(head->keys, k ? " " : ""), d->key[k]);
    head->method = draws_method(d);
    out->owned = head;
    return result_lend(out, head, 1);
}

struct sample {
    int64_t draw;
    const char *id;
};
static const struct record_type record_sample =
    RECORD(sample, "sample", "the draws",
           FIELD(sample, COUNT, draw, "1", "number of the draw"),
           FIELD(sample, TEXT, id, "1", "what the sample is called"));

static enum status view_samples(const void *run, size_t k,
                                struct result_view *out)
{
    const struct draws *d = &((const struct ensemble *) run)->draws;
    struct rows rows = rows_of(&record_sample);
    enum status status = STATUS_OK;

    if (d->id < 0)
        return STATUS_OK;
    for (k = 0; k < d->count && status == STATUS_OK; k++)
        status =
            rows_push(&rows, &(struct sample){ (int64_t) k, draws_id(d, k) });
    return rows_lend(out, &rows, status);
}

/* ---- what they say together ---------------------------------------------- */

static const struct record_type record_number_row = RECORD(
    ensemble_number, "number_row", "numbers",
    FIELD(ensemble_number, TEXT, name, "1", "which number"),
    FIELD(ensemble_number, TEXT, unit, "1",
          "its unit, and that of what follows"),
    ESTIMATE(ensemble_number, "exists", exists,
             "share of the draws where it exists", "that"),
    ESTIMATE(ensemble_number, "mean", mean, "mean where it exists", "the mean"),
    REAL(ensemble_number, "quantile_025", quantile[0], "quantile 0.025"),
    REAL(ensemble_number, "quantile_16", quantile[1], "quantile 0.16"),
    REAL(ensemble_number, "quantile_50", quantile[2], "median"),
    REAL(ensemble_number, "quantile_84", quantile[3], "quantile 0.84"),
    REAL(ensemble_number, "quantile_975", quantile[4], "quantile 0.975"));

RESULT_VIEW(view_numbers, ensemble, s->number, s->batch.numbers)

/* A row a number and a parameter. */
struct share_row {
    const char *name, *key;
    struct estimate share;
};
static const struct record_type record_share_row =
    RECORD(share_row, "share_row", "shares of variance",
           FIELD(share_row, TEXT, name, "1", "which number"),
           FIELD(share_row, TEXT, key, "1", "of which parameter"),
           ESTIMATE(share_row, "share", share,
                    "first-order share of the variance", "that"));

static enum status view_shares(const void *run, size_t k,
                               struct result_view *out)
{
    const struct ensemble *e = run;
    const size_t keys = e->draws.keys, n = e->batch.numbers * keys;
    struct rows rows = rows_of(&record_share_row);
    enum status status = STATUS_OK;

    for (k = 0; k < n && status == STATUS_OK; k++)
        status = rows_push(
            &rows, &(struct share_row){ e->number[k / keys].name,
                                        e->draws.key[k % keys],
                                        e->number[k / keys].share[k % keys] });
    return rows_lend(out, &rows, status);
}

#define FATE(code, word)                                                       \
    ESTIMATE(ensemble_push, word, fate[code], "probability of that", "that")
static const struct record_type record_push_row_of_draws = RECORD(
    ensemble_push, "push_row", "pushes",
    FIELD(ensemble_push, TEXT, from, "1", "creep: v is added to that state's"),
    FIELD(ensemble_push, TEXT, unit, "1", "of v"),
    FIELD(ensemble_push, TEXT, state, "1", "psi or phi, as the scene has it"),
    REAL(ensemble_push, "v", at.v, "slip rate, or what is added to it"),
    REAL(ensemble_push, "psi", at.psi, "interfacial state"),
    ESTIMATE(ensemble_push, "arrest", arrest,
             "probability that it creeps or rests", "that"),
    FATE(FATE_CREEP, "creep"), FATE(FATE_SLIDING, "sliding"),
    FATE(FATE_REST_FINITE, "rest_finite"),
    FATE(FATE_REST_ASYMPTOTIC, "rest_asymptotic"),
    FATE(FATE_RUNAWAY, "runaway"), FATE(FATE_UNDECIDED, "undecided"),
    FATE(GOALS, "none"));

RESULT_VIEW_IF(view_pushes, ensemble,
               s->batch.pushes > 0 && s->scene->system == NULL,
               result_lend(out, s->push, s->batch.pushes))

/* A row a push and an attractor. */
struct goal_row {
    int64_t push;
    const char *state, *attractor;
    struct estimate probability;
};
static const struct record_type record_goal_row =
    RECORD(goal_row, "goal_row", "pushes of a system",
           FIELD(goal_row, COUNT, push, "1", "which push, from 0 on"),
           FIELD(goal_row, TEXT, state, "1", "its state"),
           FIELD(goal_row, TEXT, attractor, "1",
                 "whereto it goes; none: there is no such state"),
           ESTIMATE(goal_row, "probability", probability, "probability of that",
                    "that"));

static enum status view_goals(const void *run, size_t k,
                              struct result_view *out)
{
    const struct ensemble *e = run;
    struct rows rows = rows_of(&record_goal_row);
    enum status status = STATUS_OK;

    if (e->batch.pushes == 0 || e->scene->system == NULL)
        return STATUS_OK;
    for (k = 0; k < e->batch.pushes; k++)
        for (int f = 0; f <= GOALS && status == STATUS_OK; f++) {
            const struct ensemble_push *p = &e->push[k];
            const char *word = f == GOALS ? "none" : p->word[f];
            if (word)
                status =
                    rows_push(&rows, &(struct goal_row){ (int64_t) k, p->said,
                                                         word, p->fate[f] });
        }
    return rows_lend(out, &rows, status);
}

/* ---- the table ----------------------------------------------------------- */

static const struct result ensemble_results[] = {
    { "/ensemble", NULL, "ensemble: every draw; its columns are below",
      RESULT_ATTRIBUTES, .type = &record_head, .view = view_head },
    { "/ensemble", NULL,
      "with samples that have an id, and `draw` alone with others",
      RESULT_COLUMNS, .axis = "draw", .type = &record_sample,
      .view = view_samples },
    { "/ensemble_numbers", NULL, "ensemble: what the draws say of each number",
      RESULT_COLUMNS, .type = &record_number_row, .view = view_numbers },
    { "/ensemble_variance", NULL,
      "ensemble: which parameter makes which part of its variance by itself",
      RESULT_COLUMNS, .type = &record_share_row, .view = view_shares },
    { "/ensemble_pushes", NULL, "ensemble: what the draws say of each push",
      RESULT_COLUMNS, .type = &record_push_row_of_draws, .view = view_pushes },
    { "/ensemble_goals", NULL,
      "ensemble of a system: what the draws say of each push", RESULT_COLUMNS,
      .type = &record_goal_row, .view = view_goals },
    { .path = NULL },
};

const struct result *const ensemble_tables[] = { ensemble_results, NULL };
