#include "draws_table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "scene_ensemble.h"
#include "schema.h"

/* ---- columns ------------------------------------------------------------- */

/* "material.L [m]" is material.L, of the unit m. */
static void split_header(char *text, const char **unit)
{
    char *open = strrchr(text, '[');
    const size_t size = strlen(text);

    *unit = NULL;
    if (open == NULL || open == text || text[size - 1] != ']')
        return;
    text[size - 1] = '\0';
    *unit = open + 1;
    while (open > text && open[-1] == ' ')
        open--;
    *open = '\0';
}

/* What a header may say of a key's unit: that of the schema; m/s, m or s where
 * it is one of the scene's own. */
static enum status check_unit(const struct scene *s, const char *path,
                              const char *unit, struct place at,
                              struct fault *why)
{
    const struct scene_vary vary = scene_vary_at(s, path);
    const char *own = vary.key && vary.key->unit ? vary.key->unit : "1";
    const struct unit *known = unit_text_of(own);
    const struct unit_text_name si = unit_text_name(known, UNIT_TEXT_SI);
    const char *expected = vary.unit ? si.text + (si.text[0] == ' ') : own;

    if (unit == NULL || strcmp(unit, expected) == 0)
        return STATUS_OK;
    return place_blame(at, why, "%s: unit '%s', expected %s", path,
                       text_shown(unit).text, expected);
}

/* A cell's text as one more key, which goes with those before it. */
static enum status add_key(struct draws *d, const struct scene *s,
                           const struct table_cell *cell, struct fault *why)
{
    const struct place at = table_place(&d->table, cell);
    const enum status status = scene_ensemble_check_key(s, cell->text, at, why);

    if (status != STATUS_OK)
        return status;
    for (size_t k = 0; k < d->keys; k++)
        if (strcmp(d->key[k], cell->text) == 0 ||
            schema_excludes(d->key[k], cell->text))
            return place_blame(at, why, "%s beside %s, expected one",
                               cell->text, d->key[k]);
    if (d->keys == SCENE_SPREADS)
        return place_blame(at, why, "more than %d keys", SCENE_SPREADS);
    d->key[d->keys++] = cell->text;
    return STATUS_OK;
}

/* The header's cell as a key; its text is cut in the table's own copy. */
static enum status take_key(struct draws *d, const struct scene *s,
                            size_t column, struct fault *why)
{
    const struct table_cell *cell = table_header(&d->table, column);
    const struct place at = table_place(&d->table, cell);
    const char *unit;

    split_header(d->table.bytes + (cell->text - d->table.bytes), &unit);
    const enum status status = add_key(d, s, cell, why);
    return status ? status : check_unit(s, cell->text, unit, at, why);
}

static enum status blame_cell(const struct draws *d,
                              const struct table_cell *cell, const char *key,
                              const char *expected, struct fault *why)
{
    return place_blame(table_place(&d->table, cell), why,
                       "%s: '%s' is not allowed, expected %s", key,
                       text_shown(cell->text).text, expected);
}

/* ---- samples ------------------------------------------------------------- */

static enum status read_sample(struct draws *d, const struct scene *s, size_t k,
                               size_t column, size_t row, struct fault *why)
{
    const struct scene_vary vary = scene_vary_at(s, d->key[k]);
    const struct table_cell *cell = table_at(&d->table, row, column);
    struct scene trial = *s; /* borrows */
    double x;

    if (!number_read(cell->text, &x) || !scene_vary_set(&vary, x, &trial))
        return blame_cell(d, cell, d->key[k], scene_vary_expected(&vary, s),
                          why);
    d->sample[k * d->count + row] = x;
    return STATUS_OK;
}

static enum status read_header(struct draws *d, const struct scene *s,
                               size_t at[], struct fault *why)
{
    enum status status = STATUS_OK;

    for (size_t c = 0; c < d->table.columns && status == STATUS_OK; c++) {
        if (strcmp(table_header(&d->table, c)->text, "id") == 0) {
            d->id = (int) c;
            continue;
        }
        at[d->keys < SCENE_SPREADS ? d->keys : 0] = c;
        status = take_key(d, s, c, why);
    }
    if (status == STATUS_OK && d->keys == 0)
        return place_blame(table_place(&d->table, table_header(&d->table, 0)),
                           why,
                           "no column of a key, expected one such as "
                           "material.a");
    return status;
}

enum status draws_read_samples(struct draws *d, const struct scene *scene,
                               struct fault *why)
{
    size_t at[SCENE_SPREADS] = { 0 };
    enum status status = table_read(&d->table, scene->ensemble.samples, why);

    if (status == STATUS_OK)
        status = read_header(d, scene, at, why);
    if (status != STATUS_OK)
        return status;
    d->is_sample = true;
    d->count = d->table.rows;
    d->sample = malloc(d->count * d->keys * sizeof *d->sample);
    if (d->sample == NULL)
        return STATUS_NO_MEMORY;
    for (size_t row = 0; row < d->count; row++)
        for (size_t k = 0; k < d->keys && status == STATUS_OK; k++)
            status = read_sample(d, scene, k, at[k], row, why);
    return status;
}

/* ---- covariances --------------------------------------------------------- */

/* The column of this name; the header is blamed where there is none. */
static enum status find_column(const struct draws *d, const char *name,
                               size_t *column, struct fault *why)
{
    for (size_t c = 0; c < d->table.columns; c++)
        if (strcmp(table_header(&d->table, c)->text, name) == 0) {
            *column = c;
            return STATUS_OK;
        }
    return place_blame(table_place(&d->table, table_header(&d->table, 0)), why,
                       "no column '%s', expected key, mean and one for each "
                       "key",
                       text_shown(name).text);
}

static enum status read_number(const struct draws *d, size_t row, size_t column,
                               double *x, struct fault *why)
{
    const struct table_cell *cell = table_at(&d->table, row, column);

    return number_read(cell->text, x) && isfinite(*x)
               ? STATUS_OK
               : blame_cell(d, cell, table_header(&d->table, column)->text,
                            "a number", why);
}

/* The rows' keys are all keys of the law, each once. */
static enum status take_rows(struct draws *d, const struct scene *s,
                             struct fault *why)
{
    size_t column = 0;
    enum status status = find_column(d, "key", &column, why);

    for (size_t row = 0; row < d->table.rows && status == STATUS_OK; row++)
        status = add_key(d, s, table_at(&d->table, row, column), why);
    return status;
}

static enum status read_matrix(struct draws *d, struct fault *why)
{
    const size_t n = d->keys;
    size_t mean = 0, column = 0;
    enum status status = find_column(d, "mean", &mean, why);

    for (size_t i = 0; i < n && status == STATUS_OK; i++)
        status = read_number(d, i, mean, &d->mean[i], why);
    for (size_t j = 0; j < n && status == STATUS_OK; j++) {
        status = find_column(d, d->key[j], &column, why);
        for (size_t i = 0; i < n && status == STATUS_OK; i++)
            status = read_number(d, i, column, &d->root[i * n + j], why);
        for (size_t i = 0; i < j && status == STATUS_OK; i++)
            if (d->root[i * n + j] != d->root[j * n + i])
                status =
                    blame_cell(d, table_at(&d->table, i, column), d->key[j],
                               "the same as in its transpose", why);
    }
    return status;
}

/* The lower triangle L of L L^T in place of the matrix: Golub & Van Loan,
 * Matrix Computations (2013), sec. 4.2. */
static enum status factor(struct draws *d, struct fault *why)
{
    const size_t n = d->keys;

    for (size_t j = 0; j < n; j++)
        for (size_t i = j; i < n; i++) {
            double sum = d->root[i * n + j];
            for (size_t k = 0; k < j; k++)
                sum -= d->root[i * n + k] * d->root[j * n + k];
            if (i == j && !(sum > 0.0))
                return place_blame(
                    table_place(&d->table, table_at(&d->table, i, 0)), why,
                    "the covariances up to this row are not positive definite");
            d->root[i * n + j] = i == j ? sqrt(sum) : sum / d->root[j * n + j];
        }
    return STATUS_OK;
}

enum status draws_read_covariance(struct draws *d, const struct scene *scene,
                                  struct fault *why)
{
    enum status status = table_read(&d->table, scene->ensemble.covariance, why);

    if (status == STATUS_OK)
        status = take_rows(d, scene, why);
    if (status != STATUS_OK)
        return status;
    d->mean = calloc(d->keys, sizeof *d->mean);
    d->root = calloc(d->keys * d->keys, sizeof *d->root);
    if (d->mean == NULL || d->root == NULL)
        return STATUS_NO_MEMORY;
    status = read_matrix(d, why);
    return status ? status : factor(d, why);
}
