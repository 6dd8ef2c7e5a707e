#include "json_results.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- places -------------------------------------------------------------- */

/* The first part of a name "a[2].b": its key, and number of the list's item or
 * -1; what follows it, "" at the end. */
static const char *first_part(const char *name, char key[RESULT_NAME],
                              long *item)
{
    const size_t size = strcspn(name, ".[");

    memcpy(key, name, size);
    key[size] = '\0';
    name += size;
    *item = -1;
    if (*name == '[') {
        *item = strtol(name + 1, NULL, 10);
        name = strchr(name, ']') + 1;
    }
    return *name == '.' ? name + 1 : name;
}

/* An object at the end of a list may be new. */
static json_t *item_of(json_t *list, long item)
{
    while ((long) json_array_size(list) <= item)
        if (json_array_append_new(list, json_object()) != 0)
            return NULL;
    return json_array_get(list, (size_t) item);
}

static json_t *member_of(json_t *j, const char *key, json_t *(*make)(void) )
{
    if (!json_is_object(json_object_get(j, key)) &&
        !json_is_array(json_object_get(j, key)))
        json_object_set_new(j, key, make());
    return json_object_get(j, key);
}

/* Where a result of that name belongs: in the object returned (made where it is
 * missing), under *key; key "": the object itself. */
static json_t *place_of(json_t *j, const char *name, char key[RESULT_NAME])
{
    key[0] = '\0';
    while (j && *name) {
        long item;
        const char *rest = first_part(name, key, &item);
        if (item >= 0) {
            j = item_of(member_of(j, key, json_array), item);
            key[0] = '\0';
        } else if (*rest) {
            j = member_of(j, key, json_object);
        }
        name = rest;
    }
    return j;
}

/* ---- values -------------------------------------------------------------- */

/* Members of attributes that have no value. */
static bool is_missing(const struct record_field *f, const void *member)
{
    return (f->kind == RECORD_TEXT && *(const char *const *) member == NULL) ||
           (f->kind == RECORD_REAL && isnan(*(const double *) member));
}

static void put_members(json_t *to, const struct result *r,
                        const struct record_array *a)
{
    for (size_t i = 0; i < a->type->count; i++) {
        const struct record_field *f = &a->type->fields[i];
        const void *member = record_member(a, 0, f);
        if (r->shape != RESULT_ATTRIBUTES || !is_missing(f, member))
            json_object_set_new(to, f->name, json_member(f, member));
    }
}

static json_t *list_of(const struct record_array *a)
{
    if (a->type->count > 1)
        return json_records(a);
    json_t *list = json_array();
    for (size_t i = 0; i < a->count; i++)
        json_array_append_new(
            list,
            json_member(a->type->fields, record_member(a, i, a->type->fields)));
    return list;
}

static void put_view(json_t *j, const struct result *r, const char *name,
                     const struct result_view *v)
{
    char key[RESULT_NAME];
    json_t *at = place_of(j, name, key);

    if (r->shape == RESULT_COLUMNS)
        json_object_set_new(at, key, list_of(&v->records));
    else
        put_members(key[0] ? member_of(at, key, json_object) : at, r,
                    &v->records);
}

/* ---- units --------------------------------------------------------------- */

/* "m/s"; of a column with different ones, each row's by its first member. */
static json_t *unit_json(const struct record_field *f,
                         const struct record_field *first)
{
    const char *unit = unit_name(NULL, f->unit);
    json_t *j = json_object();

    for (size_t k = 0; f->units && first->codes[k]; k++)
        if (f->units[k] && strcmp(unit_name(NULL, f->units[k]), "1") != 0)
            json_object_set_new(j, first->codes[k],
                                json_string(unit_name(NULL, f->units[k])));
    if (f->units)
        return j;
    json_decref(j);
    return strcmp(unit, "1") == 0 ? NULL : json_string(unit);
}

json_t *json_units(json_t *at, const struct record_type *type)
{
    for (size_t i = 0; i < type->count; i++) {
        json_t *unit = unit_json(&type->fields[i], type->fields);
        if (unit)
            json_object_set_new(at, type->fields[i].name, unit);
    }
    return at;
}

/* Where numbers of that name have units: at the same name below "units", lists
 * being one object. */
static void put_units(json_t *j, const char *name,
                      const struct record_type *type, bool list)
{
    char path[RESULT_NAME] = "", key[RESULT_NAME], *end = path;
    json_t *all = json_units(json_object(), type);

    if (json_object_size(all) > 0) {
        for (const char *c = name; *c; c++) {
            if (*c == '[')
                c = strchr(c, ']');
            else
                *end++ = *c;
        }
        *end = '\0';
        json_t *at = place_of(member_of(j, "units", json_object), path, key);
        if (list && type->count == 1)
            json_object_set(at, key, json_object_get(all, type->fields->name));
        else
            json_object_update(key[0] ? member_of(at, key, json_object) : at,
                               all);
    }
    json_decref(all);
}

/* ---- all ----------------------------------------------------------------- */

static enum status put_result(json_t *j, const struct result *r,
                              const struct results *all)
{
    const size_t n = result_count(r, all->run);
    enum status status = STATUS_OK;

    for (size_t k = 0; k < n && status == STATUS_OK; k++) {
        struct result_view v;
        char name[RESULT_NAME];
        result_name(r->name, k, NULL, name);
        status = result_open(all, r, k, &v);
        if (v.here)
            put_view(j, r, name, &v);
        if (v.here)
            put_units(j, name, v.records.type, r->shape == RESULT_COLUMNS);
        else if (status == STATUS_OK && strpbrk(name, ".[") == NULL &&
                 json_object_get(j, name) == NULL)
            json_object_set_new(j, name, json_null());
        result_close(&v);
    }
    return status;
}

json_t *json_results(json_t *j, const struct results *all)
{
    enum status status = STATUS_OK;

    if (j == NULL)
        j = json_object();
    for (size_t t = 0; all->table[t]; t++)
        for (const struct result *r = all->table[t]; r->type && !status; r++)
            if (r->name && result_asked(r, all))
                status = put_result(j, r, all);
    if (status != STATUS_OK) {
        json_decref(j);
        return NULL;
    }
    json_t *units = json_incref(json_object_get(j, "units"));
    if (units) { /* behind what they are of */
        json_object_del(j, "units");
        json_object_set_new(j, "units", units);
    }
    return j;
}
