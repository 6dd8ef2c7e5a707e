#include "draws.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "draws_table.h"
#include "ensemble_tolerance.h"
#include "normal.h"
#include "scene_ensemble.h"

/* ---- how many ------------------------------------------------------------ */

/* The largest m with m^keys <= draws. */
static size_t grid_side(size_t draws, size_t keys)
{
    for (size_t m = 1;; m++) {
        size_t all = 1;
        for (size_t k = 0; k < keys && all <= draws; k++)
            all *= m + 1;
        if (all > draws)
            return m;
    }
}

static enum status plan(struct draws *d, const struct scene_ensemble *e)
{
    d->method = e->method;
    d->seed = e->seed;
    d->count = e->draws;
    d->each = (e->draws + ENSEMBLE_REPEATS - 1) / ENSEMBLE_REPEATS;
    if (d->method == ENSEMBLE_SOBOL)
        return sobol_init(&d->sobol, d->keys, d->each);
    if (d->method == ENSEMBLE_GRID) {
        d->each = grid_side(e->draws, d->keys);
        d->count = 1;
        for (size_t k = 0; k < d->keys; k++)
            d->count *= d->each;
    }
    return STATUS_OK;
}

enum status draws_init(struct draws *d, const struct scene *scene,
                       struct fault *why)
{
    const struct scene_ensemble *e = &scene->ensemble;
    enum status status = STATUS_OK;

    *d = (struct draws){ .id = -1 };
    why->text[0] = '\0';
    if (e->samples)
        status = draws_read_samples(d, scene, why);
    else if (e->covariance)
        status = draws_read_covariance(d, scene, why);
    else
        d->spread = e->parameter;
    for (size_t k = 0; d->spread && k < e->parameters; k++)
        d->key[d->keys++] = e->parameter[k].key;
    if (status == STATUS_OK && !d->is_sample)
        status = plan(d, e);
    if (status != STATUS_OK)
        draws_free(d);
    return status;
}

void draws_free(struct draws *d)
{
    free(d->mean);
    free(d->root);
    free(d->sample);
    table_free(&d->table);
    *d = (struct draws){ .id = -1 };
}

/* ---- values -------------------------------------------------------------- */

/* Of key k at draw i, in (0, 1). */
static double unit_at(const struct draws *d, size_t i, size_t k)
{
    if (d->method == ENSEMBLE_SOBOL)
        return sobol_at(&d->sobol, i % d->each, k,
                        sobol_hash(d->seed, i / d->each));
    if (d->method == ENSEMBLE_RANDOM)
        return sobol_unit(sobol_hash(sobol_hash(d->seed, i), k));
    for (size_t j = d->keys; --j > k;) /* the last key runs fastest */
        i /= d->each;
    return ((double) (i % d->each) + 0.5) / (double) d->each;
}

static double value_of(const struct scene_spread *p, double u)
{
    switch (p->law) {
        case SPREAD_NORMAL:
            return p->of[0] + p->of[1] * normal_quantile(u);
        case SPREAD_UNIFORM:
            return p->of[0] + (p->of[1] - p->of[0]) * u;
        case SPREAD_LOGNORMAL:
            return p->of[0] * exp(log(p->of[1]) * normal_quantile(u));
    }
    return NAN;
}

/* mean + root z, z normal. */
static void fill_covariant(const struct draws *d, size_t first, size_t count,
                           double *const column[])
{
    double z[SCENE_SPREADS];

    for (size_t i = 0; i < count; i++) {
        for (size_t k = 0; k < d->keys; k++)
            z[k] = normal_quantile(unit_at(d, first + i, k));
        for (size_t k = 0; k < d->keys; k++) {
            double x = d->mean[k];
            for (size_t j = 0; j <= k; j++)
                x += d->root[k * d->keys + j] * z[j];
            column[k][i] = x;
        }
    }
}

void draws_fill(const struct draws *d, size_t first, size_t count,
                double *const column[])
{
    if (d->root) {
        fill_covariant(d, first, count, column);
        return;
    }
    for (size_t k = 0; k < d->keys; k++) {
        if (d->is_sample)
            memcpy(column[k], d->sample + k * d->count + first,
                   count * sizeof *d->sample);
        else
            for (size_t i = 0; i < count; i++)
                column[k][i] =
                    value_of(&d->spread[k], unit_at(d, first + i, k));
    }
}

bool draws_is_scrambled(const struct draws *d)
{
    return d->method == ENSEMBLE_SOBOL && !d->is_sample;
}

static bool is_uniform(const struct draws *d, size_t k)
{
    return d->spread && d->spread[k].law == SPREAD_UNIFORM;
}

void draws_scores(const struct draws *d, size_t i, double z[])
{
    for (size_t k = 0; k < d->keys; k++) {
        const double u = unit_at(d, i, k);
        z[k] = is_uniform(d, k) ? 2.0 * u - 1.0 : normal_quantile(u);
    }
}

double draws_below(const struct draws *d, size_t k, double z)
{
    return is_uniform(d, k) ? fmin(fmax(0.5 + 0.5 * z, 0.0), 1.0)
                            : normal_below(z);
}

size_t draws_repeat(const struct draws *d, size_t i)
{
    return draws_is_scrambled(d) ? i / d->each : i % ENSEMBLE_REPEATS;
}

const char *draws_method(const struct draws *d)
{
    return d->is_sample ? "samples" : ensemble_method_names[d->method];
}

const char *draws_id(const struct draws *d, size_t i)
{
    return d->id < 0 ? NULL : table_at(&d->table, i, (size_t) d->id)->text;
}
