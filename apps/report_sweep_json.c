#include "report_sweep_json.h"

#include "sweep_summary.h"

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
        json_array_append_new(keys, json_pack("{s:s, s:s, s:s, s:o}", "key",
                                              a->key.path, "name", a->name,
                                              "unit", a->key.unit, "values",
                                              list_json(a->value, a->count)));
    }
    return keys;
}

static json_t *dims_json(const struct sweep *s)
{
    json_t *dims = json_object();

    for (int i = 0; i < SWEEP_DIMS; i++) {
        const struct sweep_dim_axis *a = &s->dims.of[i];
        if (a->count > 0)
            json_object_set_new(dims, a->name,
                                json_pack("{s:s, s:o}", "unit", a->unit,
                                          "values",
                                          list_json(a->value, a->count)));
    }
    return dims;
}

static json_t *starts_json(const struct sweep *s)
{
    json_t *starts = json_array();

    for (size_t i = 0; i < s->dims.of[DIM_START].count; i++)
        json_array_append_new(
            starts,
            json_pack("{s:o, s:o}", "v", json_number(s->scene->start[i].v),
                      "psi", json_number(s->scene->start[i].psi)));
    return starts;
}

static json_t *names_json(const struct sweep *s, const enum sweep_dim dim[],
                          size_t dims)
{
    json_t *names = json_array();

    for (size_t i = 0; i < dims; i++)
        json_array_append_new(names, json_string(s->dims.of[dim[i]].name));
    return names;
}

/* ---- numbers ------------------------------------------------------------- */

typedef json_t *teller(const struct sweep *s, int column, size_t point,
                       size_t entry);

static json_t *tell_word(const struct sweep *s, int k, size_t point,
                         size_t entry)
{
    const int code = sweep_entry_code(s, k, point, entry);

    return code < 0 ? json_null() : json_string(s->columns.at[k].codes[code]);
}

static json_t *tell_value(const struct sweep *s, int k, size_t point,
                          size_t entry)
{
    const struct quantity q = sweep_entry(s, k, point, entry);

    return quantity_exists(&q) ? json_number(q.value) : json_null();
}

static json_t *tell_error(const struct sweep *s, int k, size_t point,
                          size_t entry)
{
    const struct quantity q = sweep_entry(s, k, point, entry);

    return quantity_exists(&q) ? json_number(q.error) : json_null();
}

static json_t *tell_reason(const struct sweep *s, int k, size_t point,
                           size_t entry)
{
    const int code = sweep_entry_code(s, k, point, entry);

    return code == REASON_PRESENT ? json_null() : json_integer(code);
}

/* Of a point, along the dimensions from `dim` on. */
static json_t *nested(const struct sweep *s, int k, teller *tell, size_t point,
                      size_t dim, size_t entry)
{
    const struct sweep_column *c = &s->columns.at[k];

    if (dim == c->dims || dim == SWEEP_RANK)
        return tell(s, k, point, entry);
    const size_t count = s->dims.of[c->dim[dim]].count;
    json_t *list = json_array();
    for (size_t i = 0; i < count; i++)
        json_array_append_new(
            list, nested(s, k, tell, point, dim + 1, entry * count + i));
    return list;
}

static json_t *all_points(const struct sweep *s, int k, teller *tell)
{
    json_t *list = json_array();

    for (size_t i = 0; i < s->points; i++)
        json_array_append_new(list, nested(s, k, tell, i, 0, 0));
    return list;
}

static json_t *number_json(const struct sweep *s, int k)
{
    const struct sweep_column *c = &s->columns.at[k];

    if (c->codes && c->dims == 0)
        return all_points(s, k, tell_word);
    return json_pack(
        "{s:o*, s:o, s:o*, s:o*}", "dims",
        c->dims > 0 ? names_json(s, c->dim, c->dims) : NULL, "value",
        all_points(s, k, c->codes ? tell_word : tell_value), "error",
        c->kind == RECORD_QUANTITY ? all_points(s, k, tell_error) : NULL,
        "reason", c->codes ? NULL : all_points(s, k, tell_reason));
}

static json_t *numbers_json(const struct sweep *s)
{
    json_t *j = json_object();

    for (size_t k = 0; k < s->columns.count; k++)
        json_object_set_new(j, s->columns.at[k].name, number_json(s, (int) k));
    return j;
}

/* ---- maps ---------------------------------------------------------------- */

/* How many cells of each point have each word; null where it cannot be read. */
static json_t *words_json(const struct sweep *s, size_t k)
{
    const char *const *codes = s->layers.at[k].codes;
    json_t *j = json_object(), *list[SUMMARY_WORDS] = { NULL };
    struct fault why;

    for (size_t w = 0; w < SUMMARY_WORDS && codes[w]; w++) {
        list[w] = json_array();
        json_object_set_new(j, codes[w], list[w]);
    }
    for (size_t i = 0; i < s->points; i++) {
        struct sweep_summary is;
        const bool read = sweep_summary_find(s, k, i, &is, &why) == STATUS_OK;
        for (size_t w = 0; w < SUMMARY_WORDS && codes[w]; w++)
            json_array_append_new(list[w],
                                  read ? json_integer((json_int_t) is.counts[w])
                                       : json_null());
    }
    return j;
}

static void add_ranges(json_t *j, const struct sweep *s, size_t k)
{
    json_t *present = json_array(), *least = json_array(),
           *greatest = json_array();
    struct fault why;

    for (size_t i = 0; i < s->points; i++) {
        struct sweep_summary is;
        const bool read = sweep_summary_find(s, k, i, &is, &why) == STATUS_OK;
        json_array_append_new(present,
                              read ? json_integer((json_int_t) is.present)
                                   : json_null());
        json_array_append_new(least, json_number(is.least));
        json_array_append_new(greatest, json_number(is.greatest));
    }
    json_object_set_new(j, "present", present);
    json_object_set_new(j, "least", least);
    json_object_set_new(j, "greatest", greatest);
}

static json_t *maps_json(const struct sweep *s)
{
    json_t *maps = json_object();

    for (size_t k = 0; k < s->layers.count; k++) {
        const struct sweep_layer *l = &s->layers.at[k];
        json_t *j = json_object();
        json_object_set_new(j, "dims", names_json(s, l->dim, 2));
        json_object_set_new(
            j, "shape",
            json_pack("[II]", (json_int_t) l->rows, (json_int_t) l->columns));
        if (l->codes)
            json_object_set_new(j, "cells", words_json(s, k));
        else
            add_ranges(j, s, k);
        json_object_set_new(maps, l->name, j);
    }
    return maps;
}

/* ---- the whole ----------------------------------------------------------- */

json_t *report_sweep_json(const struct sweep *s)
{
    json_t *reasons = json_array();

    for (size_t r = 0; r < s->reasons.count; r++)
        json_array_append_new(reasons, json_string(s->reasons.text[r]));
    return json_pack("{s:s, s:s, s:o, s:I, s:I, s:o, s:o, s:o, s:o, s:o}",
                     "law", s->scene->law.preset, "form",
                     friction_form_names[s->scene->law.form], "keys",
                     keys_json(s), "points", (json_int_t) s->points, "failed",
                     (json_int_t) s->failed, "reasons", reasons, "dims",
                     dims_json(s), "starts", starts_json(s), "numbers",
                     numbers_json(s), "maps", maps_json(s));
}
