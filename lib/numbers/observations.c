#include "observations.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "spell.h"

static const char *const columns[] = { "tan_alpha", "l_k",       "l_k_error",
                                       "x_k",       "x_k_error", NULL };

/* ---- the header ---------------------------------------------------------- */

static bool has_column(const struct table *t, const char *name)
{
    for (size_t i = 0; i < t->columns; i++)
        if (strcmp(table_header(t, i)->text, name) == 0)
            return true;
    return false;
}

static enum status check_column(const struct table *t, size_t column,
                                struct fault *why)
{
    const struct table_cell *cell = table_header(t, column);
    char words[100];

    if (text_index(cell->text, columns) >= 0)
        return STATUS_OK;
    const char *near = spell_nearest(cell->text, columns);
    text_list(columns, words, sizeof words);
    return place_blame(
        table_place(t, cell), why, "unknown column '%s', expected %s%s%s%s",
        text_shown(cell->text).text, words, near ? " (did you mean " : "",
        near ? near : "", near ? "?)" : "");
}

static enum status missing(const struct table *t, const char *name,
                           struct fault *why)
{
    return place_blame(table_place(t, table_header(t, 0)), why,
                       "no column '%s', expected tan_alpha and l_k or x_k",
                       name);
}

static enum status check_header(const struct table *t, struct fault *why)
{
    enum status s = STATUS_OK;

    for (size_t i = 0; i < t->columns && s == STATUS_OK; i++)
        s = check_column(t, i, why);
    if (s != STATUS_OK)
        return s;
    if (!has_column(t, "tan_alpha"))
        return missing(t, "tan_alpha", why);
    if (!has_column(t, "l_k") && !has_column(t, "x_k"))
        return missing(t, "l_k", why);
    if (has_column(t, "l_k_error") && !has_column(t, "l_k"))
        return missing(t, "l_k", why);
    if (has_column(t, "x_k_error") && !has_column(t, "x_k"))
        return missing(t, "x_k", why);
    return STATUS_OK;
}

/* ---- rows ---------------------------------------------------------------- */

/* A number > 0 in a cell that must not be empty. */
static enum status read_cell(const struct table *t, size_t row,
                             const char *name, double *value, struct fault *why)
{
    const struct table_cell *cell = table_find(t, row, name);

    if (cell == NULL)
        return place_blame(table_place(t, table_at(t, row, 0)), why,
                           "no %s in this row, expected a number > 0", name);
    if (number_read(cell->text, value) && *value > 0.0 && isfinite(*value))
        return STATUS_OK;
    return place_blame(table_place(t, cell), why,
                       "%s: '%s', expected a number > 0", name,
                       text_shown(cell->text).text);
}

static void series_free(struct series *s)
{
    free(s->tan_alpha);
    free(s->value);
    free(s->error);
    *s = (struct series){ .count = 0 };
}

static enum status make_room(struct series *s, size_t rows, bool with_error)
{
    s->tan_alpha = calloc(rows, sizeof *s->tan_alpha);
    s->value = calloc(rows, sizeof *s->value);
    if (with_error)
        s->error = calloc(rows, sizeof *s->error);
    return s->tan_alpha && s->value && (s->error || !with_error)
               ? STATUS_OK
               : STATUS_NO_MEMORY;
}

/* Those rows that state `name`. */
static enum status read_series(struct series *s, const struct table *t,
                               const char *name, const char *error,
                               struct fault *why)
{
    if (!has_column(t, name))
        return STATUS_OK;
    enum status status = make_room(s, t->rows, has_column(t, error));
    for (size_t row = 0; row < t->rows && status == STATUS_OK; row++) {
        if (table_find(t, row, name) == NULL)
            continue;
        status = read_cell(t, row, "tan_alpha", &s->tan_alpha[s->count], why);
        if (status == STATUS_OK)
            status = read_cell(t, row, name, &s->value[s->count], why);
        if (status == STATUS_OK && s->error)
            status = read_cell(t, row, error, &s->error[s->count], why);
        s->count++;
    }
    return status;
}

static enum status check_rows(const struct table *t, struct fault *why)
{
    for (size_t row = 0; row < t->rows; row++)
        if (!table_find(t, row, "l_k") && !table_find(t, row, "x_k"))
            return place_blame(table_place(t, table_at(t, row, 0)), why,
                               "neither l_k nor x_k in this row");
    return STATUS_OK;
}

enum status observations_read(struct observations *o, const struct table *t,
                              struct fault *why)
{
    *o = (struct observations){ .l_k.count = 0 };
    enum status s = check_header(t, why);
    if (s == STATUS_OK)
        s = check_rows(t, why);
    if (s == STATUS_OK)
        s = read_series(&o->l_k, t, "l_k", "l_k_error", why);
    if (s == STATUS_OK)
        s = read_series(&o->x_k, t, "x_k", "x_k_error", why);
    if (s != STATUS_OK)
        observations_free(o);
    return s;
}

void observations_free(struct observations *o)
{
    series_free(&o->l_k);
    series_free(&o->x_k);
}
