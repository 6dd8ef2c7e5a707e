#include "report_sweep_json.h"

#include <string.h>

#include "sweep_told.h"

/* ---- axes ---------------------------------------------------------------- */

static json_t *list_json(const double value[], size_t count)
{
    json_t *values = json_array();

    for (size_t i = 0; i < count; i++)
        json_array_append_new(values, json_number(value[i]));
    return values;
}

static json_t *keys_json(const struct sweep *s)
{
    json_t *keys = json_array();

    for (size_t k = 0; k < s->axes; k++) {
        const struct sweep_axis *a = &s->axis[k];
        json_array_append_new(
            keys, json_pack("{s:s, s:s, s:s, s:o}", "key", a->key.path, "name",
                            a->name, "unit", sweep_told_unit(s, a->key.unit),
                            "values", list_json(a->value, a->count)));
    }
    return keys;
}

static json_t *told_json(const struct sweep *s, const struct sweep_dim_axis *a)
{
    json_t *values = json_array();

    for (size_t i = 0; i < a->count; i++)
        json_array_append_new(
            values, json_number(sweep_told_value(s, a->unit, a->value[i])));
    return values;
}

static json_t *dims_json(const struct sweep *s)
{
    json_t *dims = json_object();

    for (int i = 0; i < SWEEP_DIMS; i++) {
        const struct sweep_dim_axis *a = &s->dims.of[i];
        if (a->count > 0)
            json_object_set_new(
                dims, sweep_told_dim(s, (enum sweep_dim) i).text,
                json_pack("{s:s, s:o}", "unit", sweep_told_unit(s, a->unit),
                          "values", told_json(s, a)));
    }
    return dims;
}

static json_t *starts_json(const struct sweep *s)
{
    json_t *starts = json_array();

    for (size_t i = 0; i < s->dims.of[DIM_START].count; i++)
        json_array_append_new(
            starts, json_pack("{s:o, s:o}", "v",
                              json_number(sweep_told_value(
                                  s, "V_star", s->scene->start[i].v)),
                              sweep_told_state(s),
                              json_number(sweep_told_value(
                                  s, "psi", s->scene->start[i].psi))));
    return starts;
}

static json_t *names_json(const struct sweep *s, const enum sweep_dim dim[],
                          size_t dims)
{
    json_t *names = json_array();

    for (size_t i = 0; i < dims; i++)
        json_array_append_new(names,
                              json_string(sweep_told_dim(s, dim[i]).text));
    return names;
}

/* ---- numbers ------------------------------------------------------------- */

/* What is told of an entry; of a code its word. */
enum part { VALUE, ERROR, REASON };

static json_t *entry_json(const struct sweep *s, int k, enum part part,
                          size_t point, size_t entry)
{
    const char *const *codes = s->columns.at[k].codes;
    const int code = sweep_entry_code(s, k, point, entry);

    if (codes)
        return code < 0 ? json_null() : json_string(codes[code]);
    if (part == REASON)
        return code == REASON_PRESENT ? json_null() : json_integer(code);
    const struct unit_system u = sweep_units(s, point);
    const struct quantity q = sweep_told(s, &u, k, point, entry);
    return json_number(part == VALUE ? q.value : q.error);
}

/* A list of all points, of lists along the dimensions of the column; `at`:
 * among all entries, from the list `depth` on. */
static json_t *nested(const struct sweep *s, int k, enum part part,
                      size_t depth, size_t at)
{
    const struct sweep_column *c = &s->columns.at[k];

    if (depth > c->dims || depth > SWEEP_RANK)
        return entry_json(s, k, part, at / c->entries, at % c->entries);
    const size_t count =
        depth == 0 ? s->points : s->dims.of[c->dim[depth - 1]].count;
    json_t *list = json_array();
    for (size_t i = 0; i < count; i++)
        json_array_append_new(list,
                              nested(s, k, part, depth + 1, at * count + i));
    return list;
}

static json_t *number_json(const struct sweep *s, int k)
{
    const struct sweep_column *c = &s->columns.at[k];

    if (c->codes && c->dims == 0)
        return nested(s, k, VALUE, 0, 0);
    return json_pack("{s:o*, s:o, s:o*, s:o*}", "dims",
                     c->dims > 0 ? names_json(s, c->dim, c->dims) : NULL,
                     "value", nested(s, k, VALUE, 0, 0), "error",
                     c->kind == RECORD_QUANTITY ? nested(s, k, ERROR, 0, 0)
                                                : NULL,
                     "reason", c->codes ? NULL : nested(s, k, REASON, 0, 0));
}

static json_t *numbers_json(const struct sweep *s)
{
    const struct unit_system u = sweep_units(s, 0);
    json_t *j = json_object();

    for (size_t k = 0; k < s->columns.count; k++)
        json_object_set_new(j, sweep_told_name(s, &u, (int) k).text,
                            number_json(s, (int) k));
    return j;
}

/* ---- maps ---------------------------------------------------------------- */

static const char *const range[] = { "present", "least", "greatest" };

static json_t *count_json(const struct sweep_summary *is, size_t count)
{
    return is->cells ? json_integer((json_int_t) count) : json_null();
}

static void add_point(json_t *j, const struct sweep_layer *l,
                      const struct unit_system *u,
                      const struct sweep_summary *is)
{
    const struct unit *unit = unit_find(l->unit);
    const json_t *cells = json_object_get(j, "cells");

    for (size_t w = 0; w < json_object_size(cells); w++)
        json_array_append_new(json_object_get(cells, l->codes[w]),
                              count_json(is, is->counts[w]));
    if (l->codes)
        return;
    json_array_append_new(json_object_get(j, "present"),
                          count_json(is, is->present));
    json_array_append_new(json_object_get(j, "least"),
                          json_number(unit_value(u, unit, is->least)));
    json_array_append_new(json_object_get(j, "greatest"),
                          json_number(unit_value(u, unit, is->greatest)));
}

/* How many cells of each point have each word, or a value, and which are least
 * and greatest; null where the side file cannot be read. */
static json_t *map_json(const struct sweep *s, size_t k)
{
    const struct sweep_layer *l = &s->layers.at[k];
    struct fault why;
    json_t *cells = json_object();

    for (size_t w = 0; l->codes && w < SUMMARY_WORDS && l->codes[w]; w++)
        json_object_set_new(cells, l->codes[w], json_array());
    json_t *j =
        json_pack("{s:o, s:[II]}", "dims", names_json(s, l->dim, 2), "shape",
                  (json_int_t) l->rows, (json_int_t) l->columns);
    if (l->codes)
        json_object_set(j, "cells", cells);
    for (size_t i = 0; !l->codes && i < sizeof range / sizeof *range; i++)
        json_object_set_new(j, range[i], json_array());
    json_decref(cells);
    for (size_t i = 0; i < s->points; i++) {
        struct sweep_summary is;
        if (sweep_summary_find(s, k, i, &is, &why) != STATUS_OK)
            is.cells = 0;
        const struct unit_system u = sweep_units(s, i);
        add_point(j, l, &u, &is);
    }
    return j;
}

static json_t *maps_json(const struct sweep *s)
{
    json_t *maps = json_object();

    for (size_t k = 0; k < s->layers.count; k++)
        json_object_set_new(maps, s->layers.at[k].name, map_json(s, k));
    return maps;
}

/* ---- units ----------------------------------------------------------------
 */

static void add_unit(json_t *j, const char *name, const char *unit)
{
    if (strcmp(unit, "1") != 0)
        json_object_set_new(j, name, json_string(unit));
}

/* Of what has one: numbers and maps by their names, and a start's. */
static json_t *units_json(const struct sweep *s)
{
    const struct unit_system u = sweep_units(s, 0);
    json_t *numbers = json_object(), *maps = json_object();
    json_t *starts = json_object();

    for (size_t k = 0; k < s->columns.count; k++)
        add_unit(numbers, sweep_told_name(s, &u, (int) k).text,
                 sweep_column_unit(s, &u, (int) k));
    for (size_t k = 0; k < s->layers.count; k++)
        add_unit(maps, s->layers.at[k].name,
                 sweep_told_unit(s, s->layers.at[k].unit));
    add_unit(starts, "v", sweep_told_unit(s, "V_star"));
    add_unit(starts, sweep_told_state(s), sweep_told_unit(s, "psi"));
    return json_pack("{s:o, s:o, s:o}", "numbers", numbers, "starts", starts,
                     "maps", maps);
}

/* ---- the whole ----------------------------------------------------------- */

/* What it is a sweep of. */
static json_t *what_json(const struct scene *c)
{
    return c->system ? json_pack("{s:s}", "system", scene_name(c))
                     : json_pack("{s:s, s:s}", "law", c->law.preset, "form",
                                 friction_form_names[c->law.form]);
}

json_t *report_sweep_json(const struct sweep *s)
{
    json_t *reasons = json_array();

    for (size_t r = 0; r < s->reasons.count; r++)
        json_array_append_new(reasons, json_string(s->reasons.text[r]));
    json_t *j = what_json(s->scene);
    json_object_update_new(
        j, json_pack("{s:o, s:I, s:I, s:o, s:o, s:o, s:o, s:o, s:o}", "keys",
                     keys_json(s), "points", (json_int_t) s->points, "failed",
                     (json_int_t) s->failed, "reasons", reasons, "dims",
                     dims_json(s), "starts", starts_json(s), "numbers",
                     numbers_json(s), "maps", maps_json(s), "units",
                     units_json(s)));
    return j;
}
