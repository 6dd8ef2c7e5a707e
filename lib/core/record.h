/*
 * record.h -- how a result describes itself.
 *
 * A record is a plain C struct; its type is a table with one line per member:
 * name, unit, meaning, offset.  The same table drives HDF5 data sets, JSON
 * keys, the printed report and the documentation, so that none can disagree.
 */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What is proved of a number, its inputs being decimals. */
struct proved {
    double lo, hi;          /* the number is between them, or */
    bool absent;            /* there is none, or */
    const char *not_proved; /* why nothing is; borrowed, else NULL */
};
/* What a contradiction is told by, behind the number's name. */
#define PROVED_LIE "what is proved contradicts the error bar"

/* A computed number: either a value with a finite absolute error bound in its
 * own unit, or the reason (a plain sentence) why there is none. */
struct quantity {
    double value;
    double error;
    double conditioning; /* relative; NaN where nobody asked */
    const char *reason;  /* borrowed, static; NULL when the value exists */
    const struct proved *proved; /* borrowed, two: of the number as it is, of
                                    it in the SI; NULL: nobody asked */
    double spread;    /* the standard deviation that the scatter of the inputs
                         makes, linear; NaN: nobody asked, infinite: it cannot
                         be told */
    double spread_si; /* the same of the number in the SI */
};

/* A count that there is not. */
#define RECORD_COUNT_NONE INT64_MIN

/* C type of a member. */
enum record_kind {
    RECORD_REAL,     /* double */
    RECORD_COUNT,    /* int64_t */
    RECORD_CODE,     /* int8_t, words in record_field.codes */
    RECORD_QUANTITY, /* struct quantity */
    RECORD_TEXT,     /* const char *, may be NULL */
};

struct record_field {
    const char *name; /* HDF5 name = JSON key */
    const char *unit; /* UDUNITS, or one of unit.h; "1" if none */
    const char *text; /* one plain phrase: CF long_name */
    size_t offset;
    enum record_kind kind;
    const char *const *codes; /* RECORD_CODE: NULL-ended words, code = index;
                                 -1 means "no value" */
    const char *const *units; /* of a column whose rows have different ones,
                                 by the code that is the record's first
                                 member; else NULL */
};

struct record_type {
    const char *name;
    const char *text;
    const struct record_field *fields;
    size_t count;
    size_t size; /* sizeof the struct */
};

/* A line of a table: a member of a struct, by its name or by another; and one
 * that holds a code. */
#define FIELD_AS(struct_, kind_, name_, member, unit_, text_)                  \
    {                                                                          \
        .name = name_, .unit = unit_, .text = text_,                           \
        .offset = offsetof(struct struct_, member), .kind = RECORD_##kind_     \
    }
#define FIELD(struct_, kind_, member, unit_, text_)                            \
    FIELD_AS(struct_, kind_, #member, member, unit_, text_)
#define FIELD_CODE(struct_, member, words, text_)                              \
    {                                                                          \
        .name = #member, .unit = "1", .text = text_,                           \
        .offset = offsetof(struct struct_, member), .kind = RECORD_CODE,       \
        .codes = words                                                         \
    }

/* The type of structs whose table is such an array. */
#define RECORD_TYPE(name_, text_, table, struct_)                              \
    {                                                                          \
        .name = name_, .text = text_, .fields = table,                         \
        .count = sizeof table / sizeof *table, .size = sizeof(struct struct_)  \
    }

/* A line that is no member of a struct; and the type of values that are all of
 * a record, or of records that are only described (void). */
#define FIELD_OF(kind_, name_, unit_, text_)                                   \
    {                                                                          \
        .name = name_, .unit = unit_, .text = text_, .kind = RECORD_##kind_    \
    }
#define RECORD_OF(type_, name_, text_, ...)                                    \
    {                                                                          \
        .name = name_, .text = text_,                                          \
        .fields = (const struct record_field[]){ __VA_ARGS__ },                \
        .count = sizeof((const struct record_field[]){ __VA_ARGS__ }) /        \
                 sizeof(struct record_field),                                  \
        .size = sizeof(type_)                                                  \
    }

/* `count` structs of one type, one after another; borrowed. */
struct record_array {
    const struct record_type *type;
    const void *at;
    size_t count;
};

static inline const void *record_member(const struct record_array *a, size_t i,
                                        const struct record_field *f)
{
    return (const char *) a->at + i * a->type->size + f->offset;
}

/* The word that a code or a text is; NULL: none. */
static inline const char *record_word(const struct record_field *f,
                                      const void *member)
{
    if (f->kind == RECORD_TEXT)
        return *(const char *const *) member;
    return *(const int8_t *) member < 0 ? NULL
                                        : f->codes[*(const int8_t *) member];
}

/* True for a quantity that exists. */
static inline int quantity_exists(const struct quantity *q)
{
    return q->reason == NULL;
}

static inline struct quantity quantity_none(const char *reason)
{
    const double nan = (double) __builtin_nanf("");
    return (struct quantity){ nan, nan, nan, reason, NULL, nan, nan };
}

/* A number whose bar is not finite is none. */
static inline struct quantity quantity_of(double value, double error)
{
    const double nan = (double) __builtin_nanf("");

    if (!__builtin_isfinite(value) || !__builtin_isfinite(error))
        return quantity_none("no bound on its error could be found");
    return (struct quantity){ value, error, nan, NULL, NULL, nan, nan };
}

/* The same for one whose bar grew since. */
static inline void quantity_settle(struct quantity *q)
{
    if (quantity_exists(q) &&
        !(__builtin_isfinite(q->value) && __builtin_isfinite(q->error)))
        *q = quantity_of(q->value, q->error);
}

/* Of every number of `count` records. */
static inline void record_settle(const struct record_type *type, void *at,
                                 size_t count)
{
    for (size_t i = 0; i < count * type->count; i++) {
        const struct record_field *f = &type->fields[i % type->count];
        char *record = (char *) at + i / type->count * type->size;
        if (f->kind == RECORD_QUANTITY)
            quantity_settle((struct quantity *) (void *) (record + f->offset));
    }
}

/* All numbers of a record are none, for that reason, and its reals NaN. */
static inline void record_absent(const struct record_type *type, void *at,
                                 const char *reason)
{
    for (size_t i = 0; i < type->count; i++) {
        void *member = (char *) at + type->fields[i].offset;
        if (type->fields[i].kind == RECORD_QUANTITY)
            *(struct quantity *) member = quantity_none(reason);
        else if (type->fields[i].kind == RECORD_REAL)
            *(double *) member = (double) __builtin_nanf("");
    }
}

/* The type of structs with those lines; RECORD_TYPE where others need the
 * table, too. */
#define RECORD(struct_, name_, text_, ...)                                     \
    RECORD_OF(struct struct_, name_, text_, __VA_ARGS__)
