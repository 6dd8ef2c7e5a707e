#include "json.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
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

/* Adds "proved": the enclosure as decimals, or that there is no number; else
 * null, with the reason. */
static json_t *with_proof(json_t *out, const struct proved *p)
{
    if (out == NULL || p == NULL)
        return out;
    if (p->not_proved) {
        json_object_set_new(out, "proved", json_null());
        json_object_set_new(out, "not_proved", json_string(p->not_proved));
        return out;
    }
    json_object_set_new(out, "proved",
                        p->absent
                            ? json_pack("{s:b}", "absent", 1)
                            : json_pack("{s:s, s:s}", "lo",
                                        number_outward(p->lo, false).text, "hi",
                                        number_outward(p->hi, true).text));
    return out;
}

json_t *json_quantity(const struct quantity *q)
{
    if (!quantity_exists(q))
        return with_proof(json_pack("{s:n, s:s}", "value", "reason", q->reason),
                          q->proved);
    return with_proof(
        json_pack("{s:o, s:o, s:o*, s:o*}", "value", json_number(q->value),
                  "error", json_number(q->error), "conditioning",
                  isnan(q->conditioning) ? NULL : json_number(q->conditioning),
                  "spread", isnan(q->spread) ? NULL : json_number(q->spread)),
        q->proved);
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

/* ---- writing ------------------------------------------------------------- */

static void begin_line(FILE *out, int depth)
{
    fprintf(out, "\n%*s", 2 * depth, "");
}

/* A text, a whole number, true, false or null. */
static bool write_word(const json_t *j, FILE *out)
{
    return json_dumpf(j, out, JSON_ENCODE_ANY) == 0;
}

static bool write_value(json_t *j, FILE *out, int depth);

static bool write_members(json_t *object, FILE *out, int depth)
{
    const char *key;
    json_t *member;
    bool first = true, ok = true;

    json_object_foreach(object, key, member)
    {
        json_t *name = json_string(key);
        fputs(first ? "" : ",", out);
        begin_line(out, depth + 1);
        ok = ok && write_word(name, out) && fputs(": ", out) >= 0 &&
             write_value(member, out, depth + 1);
        json_decref(name);
        first = false;
    }
    return ok;
}

static bool write_items(json_t *list, FILE *out, int depth)
{
    size_t i;
    json_t *item;
    bool ok = true;

    json_array_foreach(list, i, item)
    {
        fputs(i ? "," : "", out);
        begin_line(out, depth + 1);
        ok = ok && write_value(item, out, depth + 1);
    }
    return ok;
}

static bool write_value(json_t *j, FILE *out, int depth)
{
    const bool object = json_is_object(j);
    bool ok;

    if (json_is_real(j))
        return fputs(number_shortest(json_real_value(j)).text, out) >= 0;
    if (!object && !json_is_array(j))
        return write_word(j, out);
    fputs(object ? "{" : "[", out);
    ok = (object ? write_members : write_items)(j, out, depth);
    if (object ? json_object_size(j) : json_array_size(j))
        begin_line(out, depth);
    return fputs(object ? "}" : "]", out) >= 0 && ok;
}

bool json_write(json_t *j, FILE *out)
{
    const bool ok = j != NULL && !starved && write_value(j, out, 0) &&
                    putc('\n', out) != EOF && fflush(out) == 0 && !ferror(out);

    json_decref(j);
    return ok;
}

bool json_print(json_t *j)
{
    return json_write(j, stdout);
}
