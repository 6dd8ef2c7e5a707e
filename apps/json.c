#include "json.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "text.h"

/* Has an allocation failed? */
static bool starved;

static void *allocate(size_t size)
{
    void *at = malloc(size);

    starved = starved || at == NULL;
    return at;
}

void json_watch_memory(void)
{
    json_set_alloc_funcs(allocate, free);
}

json_t *json_number(double value)
{
    return isfinite(value) ? json_real(value) : json_null();
}

json_t *json_quantity(const struct quantity *q)
{
    if (!quantity_exists(q))
        return json_pack("{s:n, s:s}", "value", "reason", q->reason);
    return json_pack("{s:o, s:o, s:o*}", "value", json_number(q->value),
                     "error", json_number(q->error), "conditioning",
                     isnan(q->conditioning) ? NULL
                                            : json_number(q->conditioning));
}

json_t *json_member(const struct record_field *f, const void *member)
{
    switch (f->kind) {
        case RECORD_REAL:
            return json_number(*(const double *) member);
        case RECORD_COUNT:
            return *(const int64_t *) member == RECORD_COUNT_NONE
                       ? json_null()
                       : json_integer(*(const int64_t *) member);
        case RECORD_QUANTITY:
            return json_quantity(member);
        case RECORD_CODE:
        case RECORD_TEXT:
            break;
    }
    const char *text = record_word(f, member);
    return text ? json_string(text) : json_null();
}

json_t *json_record(const struct record_type *type, const void *at)
{
    const struct record_array one = { type, at, 1 };
    json_t *j = json_object();

    for (size_t i = 0; i < type->count; i++) {
        const struct record_field *f = &type->fields[i];
        json_object_set_new(j, f->name,
                            json_member(f, record_member(&one, 0, f)));
    }
    return j;
}

json_t *json_records(const struct record_array *a)
{
    json_t *list = json_array();

    for (size_t i = 0; i < a->count; i++)
        json_array_append_new(
            list,
            json_record(a->type, (const char *) a->at + i * a->type->size));
    return list;
}

json_t *json_text(const char *text)
{
    json_t *j = json_string(text);

    if (j != NULL)
        return j;
    const size_t room = 4 * strlen(text) + 8;
    char *shown = malloc(room);
    if (shown == NULL)
        return NULL;
    text_show(text, shown, room);
    j = json_string(shown);
    free(shown);
    return j;
}

bool json_write(json_t *j, FILE *out)
{
    const size_t flags = JSON_INDENT(2) | JSON_REAL_PRECISION(17);
    const bool ok = j != NULL && !starved && json_dumpf(j, out, flags) == 0 &&
                    putc('\n', out) != EOF && fflush(out) == 0;

    json_decref(j);
    return ok;
}

bool json_print(json_t *j)
{
    return json_write(j, stdout);
}
