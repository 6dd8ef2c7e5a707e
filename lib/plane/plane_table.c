#include "plane_table.h"

#include <stdarg.h>
#include <stdio.h>

/* A text that stays with the table. */
const char *plane_table_keep(struct plane_table *t, const char *format, ...)
{
    char *out = t->text + t->letters;
    const size_t left = TEXTS - t->letters;
    va_list words;

    va_start(words, format);
    const int n = vsnprintf(out, left, format, words);
    va_end(words);
    t->letters += (size_t) n + 1 < left ? (size_t) n + 1 : left - 1;
    return out;
}

/* A field of the type that is being made. */
struct record_field *plane_table_field(struct plane_table *t, const char *name,
                                       enum record_kind kind, size_t offset,
                                       const char *text)
{
    struct record_field *f = &t->field[t->fields++];

    *f = (struct record_field){
        .name = name, .unit = "1", .text = text, .offset = offset, .kind = kind
    };
    return f;
}

/* The type of the fields since `first`. */
const struct record_type *plane_table_type(struct plane_table *t, size_t first,
                                           const char *name, const char *text,
                                           size_t size)
{
    struct record_type *r = &t->type[t->types++];

    *r = (struct record_type){ name, text, t->field + first, t->fields - first,
                               size };
    return r;
}

struct result *plane_table_result(struct plane_table *t,
                                  const struct record_type *type,
                                  uint64_t needs)
{
    struct result *r = &t->result[t->results++];

    *r = (struct result){ .shape = RESULT_COLUMNS,
                          .type = type,
                          .needs = needs };
    return r;
}

/* Two fields, one a state, whose first is at offset. */
void plane_table_states(const struct plane_study *s, struct plane_table *t,
                        const char *pattern, enum record_kind kind,
                        size_t offset)
{
    const size_t size =
        kind == RECORD_QUANTITY ? sizeof(struct quantity) : sizeof(double);

    for (size_t i = 0; i < 2; i++) {
        const char *name = s->system[0].axis[i].name;
        char full[RESULT_NAME];
        result_name(pattern, 0, name, full);
        plane_table_field(t, plane_table_keep(t, "%s", full), kind,
                          offset + i * size, plane_table_keep(t, "%s", name));
    }
}
