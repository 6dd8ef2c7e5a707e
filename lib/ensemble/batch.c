/* Every thread has a scene and a study of its own, in which it changes what the
 * keys change. */
#include "batch.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "batch_fate.h"
#include "ensemble_tolerance.h"
#include "scene_slope.h"
#include "schema.h"
#include "study_results.h"

/* ---- keys ---------------------------------------------------------------- */

static enum status blame(struct fault *why, const char *name, const char *what)
{
    snprintf(why->text, sizeof why->text, "%s: %s", text_shown(name).text,
             what);
    return STATUS_BAD_ARGUMENT;
}

static enum status check_key(const struct batch *b, size_t k, struct fault *why)
{
    const char *path = b->key[k].path;

    if (!scene_vary_is(&b->key[k]))
        return blame(why, path,
                     "no key of a number, expected one such as material.a");
    for (size_t i = 0; i < k; i++)
        if (strcmp(b->key[i].path, path) == 0 ||
            schema_excludes(b->key[i].path, path))
            return blame(why, path, "beside itself or a key that excludes it");
    return STATUS_OK;
}

static enum status take_keys(struct batch *b, const char *const key[],
                             size_t keys, struct fault *why)
{
    enum status status = STATUS_OK;

    b->key = calloc(keys + 1, sizeof *b->key);
    b->beyond = calloc(keys + 1, sizeof *b->beyond);
    if (b->key == NULL || b->beyond == NULL)
        return STATUS_NO_MEMORY;
    for (b->keys = 0; b->keys < keys && status == STATUS_OK; b->keys++) {
        const size_t k = b->keys;
        b->key[k] = scene_vary_at(b->scene, key[k]);
        status = check_key(b, k, why);
        if (status == STATUS_OK &&
            asprintf(&b->beyond[k], "%s is not allowed, expected %s", key[k],
                     scene_vary_expected(&b->key[k], b->scene)) < 0) {
            b->beyond[k] = NULL;
            status = STATUS_NO_MEMORY;
        }
    }
    return status;
}

/* Every draw has a slope. */
static enum status check_slope(const struct batch *b, struct fault *why)
{
    for (size_t k = 0; k < b->keys; k++)
        if (strncmp(b->key[k].path, "slope.", 6) == 0)
            return STATUS_OK;
    return scene_slope_demand(b->scene, 1u << PRODUCT_EQUILIBRIA, why);
}

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

static enum status take_named(struct batch *b, const struct result_numbers *all,
                              const char *const name[], size_t names,
                              struct fault *why)
{
    for (size_t i = 0; i < names; i++) {
        const struct result_number *n = find(all, name[i]);
        if (n == NULL)
            return blame(why, name[i],
                         "no number of a study, expected one such as v_plus");
        b->number[b->numbers++] = *n;
    }
    return STATUS_OK;
}

/* What the products give, but steady states by number, of which draws have
 * different ones. */
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

static enum status take_numbers(struct batch *b, const char *const name[],
                                size_t names, struct fault *why)
{
    struct result_numbers all;
    enum status status = study_numbers(&all, STUDY_NUMBERS);

    if (status != STATUS_OK)
        return status;
    b->number = calloc(all.count + names + 1, sizeof *b->number);
    if (b->number == NULL)
        status = STATUS_NO_MEMORY;
    else if (name)
        status = take_named(b, &all, name, names, why);
    else
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
    if (b->scene->system) {
        snprintf(why->text, sizeof why->text,
                 "a system of formulas, expected a law");
        return STATUS_BAD_SCENE;
    }
    enum status status = take_keys(b, key, keys, why);
    if (status == STATUS_OK)
        status = check_slope(b, why);
    if (status == STATUS_OK)
        status = take_numbers(b, name, names, why);
    for (size_t i = 0; i < b->numbers; i++)
        b->stages |= stage_of(&b->number[i]);
    b->stages = plan_close(b->stages | 1u << STAGE_STEADY);
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

void batch_push(struct batch *b, const struct scene_push push[], size_t pushes)
{
    b->push = push;
    b->pushes = pushes;
}

void batch_free(struct batch *b)
{
    for (size_t k = 0; k < b->keys; k++)
        free(b->beyond[k]);
    free(b->beyond);
    free(b->key);
    free(b->number);
    *b = (struct batch){ .scene = NULL };
}

/* ---- draws --------------------------------------------------------------- */

/* What a thread works with. */
struct worker {
    struct scene scene; /* borrows */
    struct study study;
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
    return law_check(&scene->law, &scene->material, &why) == STATUS_OK
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
                           const struct study *study,
                           const struct monitor *monitor)
{
    const struct results all = study_results(study);

    for (size_t k = 0; k < t->b->numbers; k++) {
        const struct quantity q = result_quantity(&all, &t->b->number[k]);
        put(&t->out[k], i, &q);
    }
    return t->b->pushes == 0
               ? STATUS_OK
               : batch_fate_find(t->b, study, i, monitor, t->fates);
}

static enum status compute(const struct task *t, size_t i, struct worker *w,
                           const struct monitor *monitor)
{
    struct fault why;
    const char *reason = set_values(t, i, &w->scene);
    enum status status = STATUS_OK;

    if (reason == NULL)
        status =
            study_run_stages(&w->study, &w->scene, t->b->stages, monitor, &why);
    if (status == STATUS_OK && reason == NULL) {
        status = put_all(t, i, &w->study, monitor);
        study_free(&w->study);
    }
    if (status == STATUS_NO_MEMORY || status == STATUS_STOPPED)
        return status;
    if (status != STATUS_OK)
        reason = status_text(status);
    if (reason)
        put_none(t, i, reason);
    return STATUS_OK;
}

/* Draws first .. first + size - 1 by one thread. */
static enum status compute_some(const struct task *t, size_t first, size_t size)
{
    struct worker *w = malloc(sizeof *w);
    enum status status = w ? STATUS_OK : STATUS_NO_MEMORY;

    if (w) {
        w->scene = *t->b->scene;
        w->scene.products = plan_products(t->b->stages);
    }
    for (size_t i = first; i < first + size && status == STATUS_OK; i++)
        status = compute(t, i, w, NULL);
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
