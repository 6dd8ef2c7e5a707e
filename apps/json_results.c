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
    for (size_t i = 0; i < r->type->count; i++) {
        const struct record_field *f = &r->type->fields[i];
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
    if (status == STATUS_OK)
        return j;
    json_decref(j);
    return NULL;
}
