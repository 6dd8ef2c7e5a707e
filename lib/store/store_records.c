#include "store_records.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "column.h"

/* What all columns of one call share. */
struct sheet {
    struct store *st;
    hid_t group;
    const struct record_array *a;
    struct axis *axis; /* NULL: scalars */
};

static const char *const existence[] = { "absent", "present", NULL };
static const char *const outcome[] = { "not_proved", "enclosed", "absent",
                                       NULL };

static void store_records_gather(const struct record_array *a, size_t offset,
                                 size_t size, char *out)
{
    for (size_t i = 0; i < a->count; i++)
        memcpy(out + i * size,
               (const char *) a->at + i * a->type->size + offset, size);
}

static size_t size_of(enum record_kind kind)
{
    return kind == RECORD_CODE ? sizeof(int8_t) : sizeof(double);
}

/* Creates, fills and returns a column; `values` NULL means out of memory. */
static hid_t put_values(const struct sheet *sh, const struct column *c,
                        const void *values)
{
    hid_t set = H5I_INVALID_HID;

    if (values != NULL) {
        set = column_create(sh->st, sh->group, c, sh->axis != NULL, &sh->axis);
        column_write(sh->st, set, c, values);
    }
    return set;
}

/* The members at `offset` of all records, as they are. */
static hid_t put_members(const struct sheet *sh, const struct column *c,
                         size_t offset)
{
    const size_t size = size_of(c->kind);
    char *values = hdf_memory(sh->st, sh->a->count, size);
    hid_t set;

    if (values != NULL)
        store_records_gather(sh->a, offset, size, values);
    set = put_values(sh, c, values);
    free(values);
    return set;
}

static const char *text_at(const struct record_array *a, size_t i,
                           size_t offset)
{
    const char *text;

    memcpy(&text, (const char *) a->at + i * a->type->size + offset,
           sizeof text);
    return text != NULL ? text : "";
}

/* The texts at `offset`. */
static hid_t put_texts(const struct sheet *sh, const struct column *c,
                       size_t offset)
{
    const char **values =
        (const char **) hdf_memory(sh->st, sh->a->count, sizeof *values);
    hid_t set;

    for (size_t i = 0; values != NULL && i < sh->a->count; i++)
        values[i] = text_at(sh->a, i, offset);
    set = put_values(sh, c, values);
    free((void *) values);
    return set;
}

/* Names and describes a companion column of a quantity. */
struct companion {
    char name[128];
    char text[256];
    struct column column; /* borrows the two above */
};

static void companion_of(struct companion *to, const struct record_field *f,
                         const char *suffix, const char *text)
{
    snprintf(to->name, sizeof to->name, "%s_%s", f->name, suffix);
    snprintf(to->text, sizeof to->text, "%s: %s", f->text, text);
    to->column = (struct column){
        .name = to->name, .unit = "1", .text = to->text, .kind = RECORD_REAL
    };
}

static void put_error(const struct sheet *sh, const struct record_field *f)
{
    struct companion to;

    companion_of(&to, f, "error", "bound on the absolute error");
    to.column.unit = f->unit;
    hdf_close(put_members(sh, &to.column,
                          f->offset + offsetof(struct quantity, error)));
}

/* Returns how many quantities exist. */
static size_t put_existence(const struct sheet *sh,
                            const struct record_field *f)
{
    struct companion to;
    size_t present = 0;
    int8_t *code = hdf_memory(sh->st, sh->a->count, sizeof *code);

    for (size_t i = 0; code != NULL && i < sh->a->count; i++) {
        code[i] = quantity_exists(record_member(sh->a, i, f)) ? 1 : 0;
        present += (size_t) code[i];
    }
    companion_of(&to, f, "exists", "whether it exists");
    to.column.kind = RECORD_CODE;
    to.column.codes = existence;
    hdf_close(put_values(sh, &to.column, code));
    free(code);
    return present;
}

static void put_reason(const struct sheet *sh, const struct record_field *f,
                       hid_t set)
{
    const size_t offset = f->offset + offsetof(struct quantity, reason);
    struct companion to;

    if (sh->a->count == 1) {
        hdf_put_text(sh->st, set, "comment", text_at(sh->a, 0, offset));
        return;
    }
    companion_of(&to, f, "reason", "why it is absent");
    to.column.kind = RECORD_TEXT;
    hdf_close(put_texts(sh, &to.column, offset));
}

/* What is beside a number only where somebody asked: that member of it, which
 * is infinite where it cannot be told, and missing here. */
static void put_beside(const struct sheet *sh, const struct record_field *f,
                       const char *name, const char *text, const char *unit,
                       size_t member)
{
    double *value = hdf_memory(sh->st, sh->a->count, sizeof *value);
    struct companion to;
    bool asked = false;

    for (size_t i = 0; value != NULL && i < sh->a->count; i++) {
        const char *q = record_member(sh->a, i, f);
        value[i] = *(const double *) (const void *) (q + member);
        asked |= !isnan(value[i]);
        value[i] = isfinite(value[i]) ? value[i] : (double) NAN;
    }
    companion_of(&to, f, name, text);
    to.column.unit = unit;
    if (asked)
        hdf_close(put_values(sh, &to.column, value));
    free(value);
}

/* NULL: nobody asked. */
static const struct proved *proved_at(const struct sheet *sh, size_t i,
                                      const struct record_field *f)
{
    return ((const struct quantity *) record_member(sh->a, i, f))->proved;
}

/* What is proved: outcome[], -1 where nobody asked. */
static int8_t outcome_of(const struct proved *p)
{
    return p == NULL ? -1 : p->not_proved ? 0 : p->absent ? 2 : 1;
}

static void put_bound(const struct sheet *sh, const struct record_field *f,
                      const char *name, const char *text, size_t member)
{
    double *value = hdf_memory(sh->st, sh->a->count, sizeof *value);
    struct companion to;

    for (size_t i = 0; value != NULL && i < sh->a->count; i++) {
        const struct proved *p = proved_at(sh, i, f);
        value[i] =
            outcome_of(p) == 1
                ? *(const double *) (const void *) ((const char *) p + member)
                : (double) NAN;
    }
    companion_of(&to, f, name, text);
    to.column.unit = f->unit;
    hdf_close(put_values(sh, &to.column, value));
    free(value);
}

static void put_why(const struct sheet *sh, const struct record_field *f,
                    hid_t set)
{
    const char **why =
        (const char **) hdf_memory(sh->st, sh->a->count, sizeof *why);
    struct companion to;

    for (size_t i = 0; why != NULL && i < sh->a->count; i++) {
        const struct proved *p = proved_at(sh, i, f);
        why[i] = p && p->not_proved ? p->not_proved : "";
    }
    companion_of(&to, f, "not_proved", "why nothing is proved of it");
    to.column.kind = RECORD_TEXT;
    if (why != NULL && sh->a->count == 1)
        hdf_put_text(sh->st, set, "comment", why[0]);
    else
        hdf_close(put_values(sh, &to.column, why));
    free((void *) why);
}

/* Where somebody asked. */
static void put_proof(const struct sheet *sh, const struct record_field *f)
{
    int8_t *code = hdf_memory(sh->st, sh->a->count, sizeof *code);
    struct companion to;
    bool asked = false, open = false;

    for (size_t i = 0; code != NULL && i < sh->a->count; i++) {
        code[i] = outcome_of(proved_at(sh, i, f));
        asked |= code[i] >= 0;
        open |= code[i] == 0;
    }
    if (asked) {
        companion_of(&to, f, "proved", "what is proved");
        to.column.kind = RECORD_CODE;
        to.column.codes = outcome;
        const hid_t set = put_values(sh, &to.column, code);
        put_bound(sh, f, "lo", "proved to be at least",
                  offsetof(struct proved, lo));
        put_bound(sh, f, "hi", "proved to be at most",
                  offsetof(struct proved, hi));
        if (open)
            put_why(sh, f, set);
        hdf_close(set);
    }
    free(code);
}

static void put_quantity(const struct sheet *sh, const struct record_field *f,
                         struct column c)
{
    hid_t set;

    c.kind = RECORD_REAL;
    set = put_members(sh, &c, f->offset + offsetof(struct quantity, value));
    put_error(sh, f);
    if (put_existence(sh, f) < sh->a->count)
        put_reason(sh, f, set);
    put_beside(sh, f, "conditioning", "relative error from rounding the inputs",
               "1", offsetof(struct quantity, conditioning));
    put_beside(sh, f, "spread",
               "standard deviation that the scatter of the inputs makes",
               f->unit, offsetof(struct quantity, spread));
    put_proof(sh, f);
    hdf_close(set);
}

static void put_field(const struct sheet *sh, const struct record_field *f)
{
    const struct column c = column_of(f);

    if (f->kind == RECORD_QUANTITY)
        put_quantity(sh, f, c);
    else if (f->kind == RECORD_TEXT)
        hdf_close(put_texts(sh, &c, f->offset));
    else
        hdf_close(put_members(sh, &c, f->offset));
}

static bool has_n(const struct record_type *type)
{
    for (size_t i = 0; i < type->count; i++)
        if (strcmp(type->fields[i].name, "n") == 0)
            return true;
    return false;
}

/* n, unless that is a field: a state may have any name. */
static struct axis *put_index(const struct sheet *sh)
{
    const struct column n = { .name = has_n(sh->a->type) ? "index" : "n",
                              .unit = "1",
                              .text = "index",
                              .kind = RECORD_COUNT };
    int64_t *values = hdf_memory(sh->st, sh->a->count, sizeof *values);
    struct axis *axis = NULL;

    for (size_t i = 0; values != NULL && i < sh->a->count; i++)
        values[i] = (int64_t) i;
    if (values != NULL)
        axis = column_axis(sh->st, sh->group, &n, sh->a->count, values);
    free(values);
    return axis;
}

static struct axis *put_axis(const struct sheet *sh,
                             const struct record_field *f)
{
    const struct column c = column_of(f);
    char *values = hdf_memory(sh->st, sh->a->count, size_of(f->kind));
    struct axis *axis = NULL;

    if (values != NULL) {
        store_records_gather(sh->a, f->offset, size_of(f->kind), values);
        axis = column_axis(sh->st, sh->group, &c, sh->a->count, values);
    }
    free(values);
    return axis;
}

/* NULL for NULL. */
static const struct record_field *field_named(const struct record_type *type,
                                              const char *name)
{
    for (size_t i = 0; name != NULL && i < type->count; i++)
        if (strcmp(type->fields[i].name, name) == 0)
            return &type->fields[i];
    assert(name == NULL); /* or it is no field */
    return NULL;
}

static void put_fields(const struct sheet *sh, const struct record_field *axis)
{
    const struct record_type *type = sh->a->type;

    for (size_t i = 0; i < type->count; i++)
        if (&type->fields[i] != axis && sh->st->status == STATUS_OK)
            put_field(sh, &type->fields[i]);
}

enum status store_put_records(struct store *st, const char *group,
                              const struct record_array *a, const char *axis)
{
    const struct record_field *f = field_named(a->type, axis);
    struct sheet sh = { .st = st, .a = a };

    assert(f == NULL || f->kind == RECORD_REAL || f->kind == RECORD_COUNT);
    if (st->status != STATUS_OK)
        return st->status;
    sh.group = hdf_group(st, group);
    sh.axis = f != NULL ? put_axis(&sh, f) : put_index(&sh);
    put_fields(&sh, f);
    return st->status;
}

enum status store_put_scalars(struct store *st, const char *group,
                              const struct record_type *type,
                              const void *record)
{
    const struct record_array one = { type, record, 1 };
    struct sheet sh = { .st = st, .a = &one };

    if (st->status != STATUS_OK)
        return st->status;
    sh.group = hdf_group(st, group);
    put_fields(&sh, NULL);
    return st->status;
}
