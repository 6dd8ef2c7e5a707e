#include "expected.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "plane_numbers.h"
#include "plane_row.h"
#include "scene_slope.h"
#include "spell.h"

/* Columns that state nothing: labels, and what the tables say of their own
 * digits. */
static const char *const labels[] = { "name",      "title",       "note",
                                      "comment",   "tag",         "seconds",
                                      "tolerance", "digits_lost", NULL };
static const char *const label_heads[] = { "dig_", "digits_lost_", NULL };

/* ---- the header ---------------------------------------------------------- */

static bool is_label(const char *name)
{
    for (size_t i = 0; label_heads[i]; i++)
        if (strncmp(name, label_heads[i], strlen(label_heads[i])) == 0)
            return true;
    return text_index(name, labels) >= 0;
}

static size_t find_column(const struct table *t, const char *name, size_t size)
{
    for (size_t i = 0; i < t->columns; i++) {
        const char *other = table_header(t, i)->text;
        if (strlen(other) == size && strncmp(other, name, size) == 0)
            return i;
    }
    return EXPECTED_NO_COLUMN;
}

/* The column that NAME_tol is about; EXPECTED_NO_COLUMN if it is about none. */
static size_t tolerance_of(const struct expected *s, const char *name)
{
    const struct table *t = s->table;
    const size_t size = strlen(name);

    if (size <= 4 || strcmp(name + size - 4, "_tol") != 0)
        return EXPECTED_NO_COLUMN;
    const size_t i = find_column(t, name, size - 4);
    const struct result_number *n =
        i == EXPECTED_NO_COLUMN
            ? NULL
            : result_numbers_find(&s->numbers, table_header(t, i)->text);
    return n && n->field->kind == RECORD_QUANTITY ? i : EXPECTED_NO_COLUMN;
}

static const char *const *inputs_of(const struct expected *s)
{
    return s->of_systems ? plane_row_columns : slope_row_columns;
}

static enum status blame_name(const struct expected *s,
                              const struct table_cell *cell, struct fault *why)
{
    enum { KNOWN = 256 };
    const char *known[KNOWN];
    size_t n = 0;

    for (size_t i = 0; i < s->numbers.count && n < KNOWN - 1; i++)
        known[n++] = s->numbers.at[i].name;
    for (const char *const *c = inputs_of(s); *c && n < KNOWN - 1; c++)
        known[n++] = *c;
    for (size_t i = 0; labels[i] && n < KNOWN - 1; i++)
        known[n++] = labels[i];
    known[n] = NULL;
    const char *near = spell_nearest(cell->text, known);
    return place_blame(table_place(s->table, cell), why,
                       "unknown column '%s'%s%s%s (see docs/check.md)",
                       text_shown(cell->text).text,
                       near ? ", did you mean " : "", near ? near : "",
                       near ? "?" : "");
}

static enum status read_header(struct expected *s, struct fault *why)
{
    const struct table *t = s->table;

    for (size_t i = 0; i < t->columns; i++) {
        const char *name = table_header(t, i)->text;
        const struct result_number *number =
            result_numbers_find(&s->numbers, name);
        if (number)
            s->column[s->columns++] =
                (struct expected_column){ number, i, EXPECTED_NO_COLUMN };
        else if (!is_label(name) && text_index(name, inputs_of(s)) < 0 &&
                 tolerance_of(s, name) == EXPECTED_NO_COLUMN)
            return blame_name(s, table_header(t, i), why);
    }
    for (size_t i = 0; i < t->columns; i++) {
        const size_t of = tolerance_of(s, table_header(t, i)->text);
        for (size_t k = 0; k < s->columns; k++)
            if (s->column[k].at == of)
                s->column[k].tolerance = i;
    }
    return STATUS_OK;
}

/* ---- cells --------------------------------------------------------------- */

/* Half a unit of the last digit of a decimal number. */
static double half_unit(const char *text)
{
    const char *e = strpbrk(text, "eE"), *point = strchr(text, '.');
    const size_t size = e ? (size_t) (e - text) : strlen(text);
    const long power = e ? strtol(e + 1, NULL, 10) : 0;
    const long places = point ? (long) size - (long) (point - text) - 1 : 0;

    return 0.5 * pow(10.0, (double) power - (double) places);
}

/* False where the cell makes no sense in its column. */
static bool read_value(const struct record_field *f, struct expected_value *v)
{
    const char *text = v->cell->text;

    if (text[0] == '\0')
        return true;
    if (strcmp(text, "none") == 0 || strcmp(text, "-inf") == 0 ||
        strcmp(text, "inf") == 0) {
        v->kind = EXPECTED_NONE;
        return true;
    }
    v->kind = f->kind == RECORD_CODE ? EXPECTED_CODE : EXPECTED_NUMBER;
    if (f->kind == RECORD_CODE) {
        v->code = (int8_t) text_index(text, f->codes);
        return v->code >= 0;
    }
    v->printed = half_unit(text);
    return number_read(text, &v->number);
}

struct expected_value expected_at(const struct expected *s, size_t row,
                                  size_t i)
{
    const struct expected_column *c = &s->column[i];
    struct expected_value v = { .cell = table_at(s->table, row, c->at) };

    (void) read_value(c->number->field, &v);
    return v;
}

static enum status check_cell(const struct expected *s, size_t row, size_t i,
                              struct fault *why)
{
    const struct expected_column *c = &s->column[i];
    struct expected_value v = { .cell = table_at(s->table, row, c->at) };
    char words[160] = "a decimal number or none";

    if (read_value(c->number->field, &v))
        return STATUS_OK;
    if (c->number->field->kind == RECORD_CODE)
        text_list(c->number->field->codes, words, sizeof words);
    return place_blame(table_place(s->table, v.cell), why,
                       "%s: '%s' makes no sense here, expected %s",
                       c->number->name, text_shown(v.cell->text).text, words);
}

/* ---- tolerances ---------------------------------------------------------- */

bool expected_tolerance(const struct expected *s, size_t row, size_t i,
                        double value, double *tolerance)
{
    const struct expected_column *c = &s->column[i];
    const struct table_cell *common = table_find(s->table, row, "tolerance");

    if (c->tolerance != EXPECTED_NO_COLUMN &&
        number_read(table_at(s->table, row, c->tolerance)->text, tolerance))
        return true;
    if (common == NULL || !number_read(common->text, tolerance))
        return false;
    *tolerance *= fabs(value);
    return true;
}

double expected_lost(const struct expected *s, size_t row)
{
    const struct table_cell *cell = table_find(s->table, row, "digits_lost");
    double digits;

    return cell && number_read(cell->text, &digits) ? pow(10.0, digits - 15.0)
                                                    : 0.0;
}

static enum status check_tolerance(const struct table *t,
                                   const struct table_cell *cell,
                                   const char *name, struct fault *why)
{
    double value;

    if (cell == NULL || cell->text[0] == '\0')
        return STATUS_OK;
    if (number_read(cell->text, &value) && value >= 0.0 && isfinite(value))
        return STATUS_OK;
    return place_blame(table_place(t, cell), why,
                       "%s: '%s' is no tolerance, expected a number >= 0", name,
                       text_shown(cell->text).text);
}

static enum status check_tolerances(const struct expected *s, size_t row,
                                    struct fault *why)
{
    const struct table *t = s->table;
    enum status status =
        check_tolerance(t, table_find(t, row, "tolerance"), "tolerance", why);

    if (status == STATUS_OK)
        status = check_tolerance(t, table_find(t, row, "digits_lost"),
                                 "digits_lost", why);
    for (size_t i = 0; i < s->columns && status == STATUS_OK; i++) {
        const size_t at = s->column[i].tolerance;
        if (at != EXPECTED_NO_COLUMN)
            status = check_tolerance(t, table_at(t, row, at),
                                     table_header(t, at)->text, why);
    }
    return status;
}

/* ---- rows ---------------------------------------------------------------- */

unsigned expected_products(const struct expected *s, size_t row)
{
    uint64_t needs = 0;

    for (size_t i = 0; i < s->columns; i++)
        if (expected_at(s, row, i).kind != EXPECTED_NOTHING)
            needs |= s->column[i].number->of->needs;
    if (s->of_systems)
        return (unsigned) needs | 1u << PRODUCT_EQUILIBRIA;
    return plan_products((unsigned) (needs & EXPECTED_STAGES));
}

/* The names of the states are those of the first row. */
static enum status check_system(const struct expected *s, size_t row,
                                struct fault *why)
{
    struct scene scene;
    const enum status status = plane_row_read(s->table, row, 0, &scene, why);

    if (status != STATUS_OK)
        return status;
    bool same = true;
    for (int i = 0; i < 2; i++)
        same = same && strcmp(scene.system->state[i].name,
                              s->scene.system->state[i].name) == 0;
    scene_free(&scene);
    return same ? STATUS_OK
                : place_blame(table_place(s->table, table_at(s->table, row, 0)),
                              why,
                              "states are not called %s, %s as in the "
                              "first row",
                              s->scene.system->state[0].name,
                              s->scene.system->state[1].name);
}

static enum status check_slope(const struct expected *s, size_t row,
                               struct fault *why)
{
    struct slope_row slope;
    enum status status = slope_row_read(s->table, row, &slope, why);

    if (status != STATUS_OK)
        return status;
    if (isnan(slope.alpha) && (expected_products(s, row) & ~scene_slopeless))
        status = place_blame(table_place(s->table, table_at(s->table, row, 0)),
                             why, "no alpha, expected an angle in rad");
    slope_row_free(&slope);
    return status;
}

static enum status check_row(const struct expected *s, size_t row,
                             struct fault *why)
{
    enum status status =
        s->of_systems ? check_system(s, row, why) : check_slope(s, row, why);

    for (size_t i = 0; i < s->columns && status == STATUS_OK; i++)
        status = check_cell(s, row, i, why);
    if (status == STATUS_OK)
        status = check_tolerances(s, row, why);
    return status;
}

/* All numbers that the rows may state. */
static enum status find_numbers(struct expected *s, struct fault *why)
{
    const unsigned all = 1u << PRODUCT_EQUILIBRIA | 1u << PRODUCT_MANIFOLDS |
                         1u << PRODUCT_BASINS | 1u << PRODUCT_SENSITIVITIES;

    if (!s->of_systems)
        return study_numbers(&s->numbers, EXPECTED_STAGES);
    enum status status = plane_row_read(s->table, 0, all, &s->scene, why);
    if (status == STATUS_OK)
        status = plane_numbers_frame(&s->frame, &s->scene);
    return status ? status : plane_numbers(&s->numbers, &s->frame);
}

enum status expected_read(struct expected *s, const struct table *t,
                          struct fault *why)
{
    *s = (struct expected){ .table = t, .of_systems = plane_row_is(t) };
    enum status status = find_numbers(s, why);
    if (status != STATUS_OK && status != STATUS_NO_MEMORY) {
        expected_free(s);
        return status;
    }
    s->column = malloc(t->columns * sizeof *s->column);
    if (status != STATUS_OK || s->column == NULL) {
        expected_free(s);
        return fault_set(why, STATUS_NO_MEMORY, "%s",
                         status_text(STATUS_NO_MEMORY));
    }
    status = read_header(s, why);
    if (status == STATUS_OK && s->columns == 0)
        status = place_blame(table_place(t, table_header(t, 0)), why,
                             "no column states a number to check");
    for (size_t row = 0; row < t->rows && status == STATUS_OK; row++)
        status = check_row(s, row, why);
    if (status != STATUS_OK)
        expected_free(s);
    return status;
}

void expected_free(struct expected *s)
{
    free(s->column);
    result_numbers_free(&s->numbers);
    plane_numbers_free(&s->frame);
    scene_free(&s->scene);
    *s = (struct expected){ .table = s->table };
}
