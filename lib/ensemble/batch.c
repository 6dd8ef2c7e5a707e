/* Every thread has scenes and points of its own, in which it changes what the
 * keys change. */
#include "batch.h"

#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "batch_fate.h"
#include "batch_goal.h"
#include "batch_keys.h"
#include "batch_points.h"
#include "batch_words.h"
#include "ensemble_tolerance.h"
#include "scene_parameter.h"
#include "study_results.h"

/* ---- numbers ------------------------------------------------------------- */

static bool is_quantity(const struct result_number *n)
{
    return n->field->kind == RECORD_QUANTITY;
}

/* That of a name; NULL: there is none. */
static const struct result_number *find(const struct result_numbers *all,
                                        const char *name)
{
    const struct result_number *n = result_numbers_find(all, name);

    return n && is_quantity(n) ? n : NULL;
}

static enum status begin_points(struct batch *b)
{
    if (b->points)
        return STATUS_OK;
    b->points = malloc(sizeof *b->points);
    if (b->points == NULL)
        return STATUS_NO_MEMORY;
    return batch_points_init(b->points, b->scene);
}

/* The column of that name; NULL: none. */
static const struct sweep_column *column_of(const struct batch_points *p,
                                            const char *name)
{
    for (size_t k = 0; k < p->columns.count; k++)
        if (strcmp(p->columns.at[k].name, name) == 0)
            return batch_points_has(p, k) ? &p->columns.at[k] : NULL;
    return NULL;
}

static void take_column(struct batch *b, const struct sweep_column *c)
{
    b->column[b->numbers] = c;
    b->number[b->numbers++] = c->number;
}

static enum status take_named(struct batch *b, const struct result_numbers *all,
                              const char *const name[], size_t names,
                              struct fault *why)
{
    for (size_t i = 0; i < names; i++) {
        for (size_t k = 0; k < i; k++)
            if (strcmp(name[k], name[i]) == 0)
                return batch_keys_blame(why, name[i], "named twice");
        const struct result_number *n =
            b->scene->system ? NULL : find(all, name[i]);
        if (n) {
            b->number[b->numbers++] = *n;
            continue;
        }
        if (begin_points(b) != STATUS_OK)
            return STATUS_NO_MEMORY;
        const struct sweep_column *c = column_of(b->points, name[i]);
        if (c == NULL)
            return batch_keys_blame(
                why, name[i],
                b->scene->system ? "no number of this system's sweeps"
                                 : "no number of a study, expected one such as "
                                   "v_plus, or a single one of the products");
        take_column(b, c);
    }
    return STATUS_OK;
}

/* Steady states by number are not the same from draw to draw, and estimates by
 * xi are many. */
bool batch_draws(const struct sweep_column *c)
{
    const struct result *of = c->number.of;
    const bool study = c->names == 0 && of->shape != RESULT_COLUMNS &&
                       of->needs & (STUDY_NUMBERS | ASKED_BY(TAYLOR));

    return c->kind == RECORD_QUANTITY && c->entries == 1 &&
           (study || of->needs & ASKED_BY(BASINS));
}

/* What the products give. */
static void take_products(struct batch *b, const struct result_numbers *all)
{
    const unsigned products = b->scene->products;
    const uint64_t asked =
        products ? plan_stages(products) : ASKED_BY(CRITICAL);

    for (size_t i = 0; i < all->count; i++)
        if (is_quantity(&all->at[i]) && (all->at[i].of->needs & asked) &&
            all->at[i].of->shape == RESULT_SCALARS)
            b->number[b->numbers++] = all->at[i];
}

/* The same of points; of a system what its own study has. */
static enum status take_points(struct batch *b)
{
    const struct batch_points *p = b->points;
    const bool whole = b->scene->system != NULL;
    bool *there = calloc(p->columns.count + 1, sizeof *there);
    enum status status = there ? STATUS_OK : STATUS_NO_MEMORY;

    if (status == STATUS_OK && whole)
        status = batch_points_there(p, there);
    for (size_t k = 0; k < p->columns.count && status == STATUS_OK; k++) {
        const struct sweep_column *c = &p->columns.at[k];
        const bool counts =
            c->kind != RECORD_QUANTITY && c->number.of->shape == RESULT_COLUMNS;
        if (whole ? there[k] && !counts : batch_draws(c))
            take_column(b, c);
    }
    free(there);
    return status;
}

/* Whether the products have numbers beyond those of a study. */
static bool needs_points(const struct scene *s)
{
    const unsigned stages = plan_stages(sweep_point_products(s, false));

    return s->system || plan_has(stages, STAGE_BASINS) ||
           plan_has(stages, STAGE_TAYLOR);
}

static enum status take_numbers(struct batch *b, const char *const name[],
                                size_t names, struct fault *why)
{
    const bool points = name == NULL && needs_points(b->scene);
    struct result_numbers all;
    enum status status = study_numbers(&all, STUDY_NUMBERS);

    if (status == STATUS_OK && points)
        status = begin_points(b);
    if (status == STATUS_OK) {
        const size_t room =
            all.count + names + (points ? b->points->columns.count : 0) + 1;
        b->number = calloc(room, sizeof *b->number);
        b->column = calloc(room, sizeof *b->column);
        if (b->number == NULL || b->column == NULL)
            status = STATUS_NO_MEMORY;
    }
    if (status == STATUS_OK && name)
        status = take_named(b, &all, name, names, why);
    else if (status == STATUS_OK && points)
        status = take_points(b);
    else if (status == STATUS_OK)
        take_products(b, &all);
    result_numbers_free(&all);
    return status;
}

/* The cheapest stage of those that a number may come from. */
static unsigned stage_of(const struct result_number *n)
{
    const unsigned asked = (unsigned) (n->of->needs & STUDY_NUMBERS);

    return asked & -asked;
}

/* ---- the whole ----------------------------------------------------------- */

static enum status begin(struct batch *b, const char *const key[], size_t keys,
                         const char *const name[], size_t names,
                         struct fault *why)
{
    enum status status = batch_keys_take(b, key, keys, why);
    if (status == STATUS_OK)
        status = take_numbers(b, name, names, why);
    bool deficit = false, saddle = true; /* columns of steady states are those
                                             of nodes, too */
    for (size_t i = 0; i < b->numbers; i++) {
        if (b->column[i] == NULL)
            b->stages |= stage_of(&b->number[i]);
        saddle = saddle && b->number[i].of->shape == RESULT_SCALARS;
        deficit |= b->number[i].of->type == &record_critical &&
                   b->number[i].field->offset ==
                       offsetof(struct critical_numbers, x_deficit);
    }
    b->stages = plan_close(b->stages | 1u << STAGE_STEADY);
    if (saddle && (b->stages & ~PLAN_OF_SADDLE) == 0)
        b->stages |= PLAN_SADDLE | (deficit ? 0 : PLAN_NO_DEFICIT);
    if (b->points && b->scene->system == NULL)
        b->points->scene.products |= plan_products(b->stages);
    return status;
}

enum status batch_init(struct batch *b, const struct scene *scene,
                       const char *const key[], size_t keys,
                       const char *const name[], size_t names,
                       struct fault *why)
{
    *b = (struct batch){ .scene = scene };
    snprintf(why->text, sizeof why->text, "%s", status_text(STATUS_NO_MEMORY));
    const enum status status = begin(b, key, keys, name, names, why);
    if (status != STATUS_OK)
        batch_free(b);
    return status;
}

/* Attractors are those of basins, which nobody need audit. */
static enum status push_system(struct batch *b)
{
    b->words = calloc(1, sizeof *b->words);
    if (b->words == NULL || begin_points(b) != STATUS_OK)
        return STATUS_NO_MEMORY;
    struct scene *s = &b->points->scene;
    if ((s->products & 1u << PRODUCT_BASINS) == 0)
        s->audit = 0;
    s->products |= 1u << PRODUCT_BASINS;
    return STATUS_OK;
}

enum status batch_push(struct batch *b, const struct scene_push push[],
                       size_t pushes)
{
    b->push = push;
    b->pushes = pushes;
    if (pushes > 0) /* they come to nodes */
        b->stages &= ~(PLAN_SADDLE | PLAN_NO_DEFICIT);
    return b->scene && b->scene->system && pushes > 0 ? push_system(b)
                                                      : STATUS_OK;
}

void batch_free(struct batch *b)
{
    for (size_t k = 0; k < b->keys; k++)
        free(b->beyond[k]);
    free(b->beyond);
    free(b->key);
    free(b->number);
    free(b->column);
    if (b->points)
        batch_points_free(b->points);
    free(b->points);
    if (b->words)
        batch_words_free(b->words);
    free(b->words);
    *b = (struct batch){ .scene = NULL };
}

/* ---- draws --------------------------------------------------------------- */

/* What a thread works with. */
struct worker {
    struct scene scene[STUDY_JOBS]; /* borrow */
    struct sweep_point point[STUDY_JOBS];
};

/* What one call of batch_run works on. */
struct task {
    const struct batch *b;
    const double *const *column;
    const struct batch_column *out;
    const struct batch_fates *fates;
};

/* The draw's values; NULL, or why they are not allowed.  Keys in the scene's
 * units come last, for the units may be among the others. */
static const char *set_values(const struct task *t, size_t i,
                              struct scene *scene)
{
    const struct batch *b = t->b;

    for (int in_units = 0; in_units < 2; in_units++)
        for (size_t k = 0; k < b->keys; k++)
            if ((b->key[k].unit != NULL) == in_units &&
                !scene_vary_set(&b->key[k], t->column[k][i], scene))
                return b->beyond[k];
    struct fault why;
    return scene->system ||
                   law_check(&scene->law, &scene->material, &why) == STATUS_OK
               ? NULL
               : "the law does not allow this material";
}

static void put(const struct batch_column *c, size_t i,
                const struct quantity *q)
{
    if (c->value)
        c->value[i] = q->value;
    if (c->error)
        c->error[i] = q->error;
    if (c->reason)
        c->reason[i] = q->reason;
}

/* No numbers at draw i, and why. */
static void put_none(const struct task *t, size_t i, const char *reason)
{
    const struct quantity none = quantity_none(reason);

    for (size_t k = 0; k < t->b->numbers; k++)
        put(&t->out[k], i, &none);
    for (size_t k = 0; k < t->b->pushes; k++)
        batch_fate_put(&t->fates[k], i, -1, reason);
}

static enum status put_all(const struct task *t, size_t i,
                           const struct sweep_point *p,
                           const struct monitor *monitor)
{
    const struct results all =
        p->system ? (struct results){ .run = NULL } : study_results(&p->study);

    for (size_t k = 0; k < t->b->numbers; k++) {
        const struct sweep_column *c = t->b->column[k];
        const struct quantity q = c ? sweep_column_quantity(c, p, 0)
                                    : result_quantity(&all, &t->b->number[k]);
        put(&t->out[k], i, &q);
    }
    return t->b->pushes == 0 ? STATUS_OK
           : p->system       ? batch_goal_find(t->b, p, i, t->fates)
                             : batch_fate_find(t->b, p, i, monitor, t->fates);
}

/* *reason: why there are no numbers. */
static enum status run_point(const struct task *t, size_t i, struct worker *w,
                             const struct monitor *monitor, const char **reason)
{
    const struct batch *b = t->b;
    struct sweep_point *p = &w->point[0];
    enum status status = sweep_point_begin(p, &w->scene[0]);

    for (size_t k = 0; p->system && k < b->keys && status == STATUS_OK; k++)
        status =
            scene_parameter_set(p->system, b->key[k].path, t->column[k][i]);
    if (status != STATUS_OK) {
        free(p->system);
        return status;
    }
    status = sweep_point_run(p, b->points->scene.products, monitor);
    if (status != STATUS_OK)
        return status;
    *reason = p->failed;
    if (*reason == NULL)
        status = put_all(t, i, p, monitor);
    sweep_point_free(p);
    return status;
}

/* What ends a draw but not the others. */
static enum status settle(const struct task *t, size_t i, enum status status,
                          const char *reason)
{
    if (status == STATUS_NO_MEMORY || status == STATUS_STOPPED)
        return status;
    if (status != STATUS_OK)
        reason = status_text(status);
    if (reason)
        put_none(t, i, reason);
    return STATUS_OK;
}

static enum status compute_point(const struct task *t, size_t i,
                                 struct worker *w)
{
    const char *reason = set_values(t, i, &w->scene[0]);
    const enum status status =
        reason ? STATUS_OK : run_point(t, i, w, NULL, &reason);

    return settle(t, i, status, reason);
}

/* Draws first .. first + size - 1, size <= STUDY_JOBS, side by side. */
static enum status compute_studies(const struct task *t, size_t first,
                                   size_t size, struct worker *w)
{
    enum status ran[STUDY_JOBS], status = STATUS_OK;
    size_t draw[STUDY_JOBS], n = 0;

    for (size_t i = first; i < first + size; i++) {
        const char *reason = set_values(t, i, &w->scene[n]);
        if (reason)
            put_none(t, i, reason);
        else
            draw[n++] = i;
    }
    sweep_points_study(w->point, w->scene, n, t->b->stages, ran);
    for (size_t k = 0; k < n; k++) {
        enum status own = ran[k];
        if (own == STATUS_OK && status == STATUS_OK)
            own = put_all(t, draw[k], &w->point[k], NULL);
        if (ran[k] == STATUS_OK)
            study_free(&w->point[k].study);
        if (status == STATUS_OK)
            status = settle(t, draw[k], own, NULL);
    }
    return status;
}

/* Draws first .. first + size - 1 by one thread. */
static enum status compute_some(const struct task *t, size_t first, size_t size)
{
    const size_t each = t->b->points ? 1 : STUDY_JOBS, end = first + size;
    struct worker *w = calloc(1, sizeof *w);
    enum status status = w ? STATUS_OK : STATUS_NO_MEMORY;

    for (int k = 0; k < STUDY_JOBS && w; k++) {
        w->scene[k] = t->b->points ? t->b->points->scene : *t->b->scene;
        if (t->b->points == NULL)
            w->scene[k].products = plan_products(t->b->stages);
    }
    for (size_t i = first; i < end && status == STATUS_OK; i += each)
        status =
            t->b->points
                ? compute_point(t, i, w)
                : compute_studies(t, i, end - i < each ? end - i : each, w);
    free(w);
    return status;
}

enum status batch_run(const struct batch *b, size_t count,
                      const double *const column[], int threads,
                      const struct monitor *monitor,
                      const struct batch_column out[],
                      const struct batch_fates fates[])
{
    const struct task t = { b, column, out, fates };
    const size_t size = BATCH_DRAWS, parts = (count + size - 1) / size;
    enum status failed = STATUS_OK;
    size_t done = 0;

#pragma omp parallel for schedule(dynamic, 1)                                  \
    num_threads(threads > 0 ? threads : omp_get_max_threads())
    for (size_t p = 0; p < parts; p++) {
        const size_t first = p * size;
        const size_t some = count - first < size ? count - first : size;
        enum status status;
#pragma omp atomic read
        status = failed;
        if (status == STATUS_OK)
            status = compute_some(&t, first, some);
#pragma omp critical(batch)
        {
            done += some;
            if (failed == STATUS_OK && status == STATUS_OK &&
                monitor_tell(monitor, "draws", done, count))
                status = STATUS_STOPPED;
            if (failed == STATUS_OK)
                failed = status;
        }
    }
    return failed;
}
