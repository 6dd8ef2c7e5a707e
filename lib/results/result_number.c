#include "result_number.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "room.h"

/* ---- which --------------------------------------------------------------- */

static bool stands_alone(const struct record_field *f)
{
    return f->kind == RECORD_QUANTITY || f->kind == RECORD_CODE ||
           f->kind == RECORD_COUNT;
}

static enum status add(struct result_numbers *n, const struct result_number *x)
{
    const enum status s = ROOM_FOR(n->at, n->room, n->count + 1);

    if (s == STATUS_OK)
        n->at[n->count++] = *x;
    return s;
}

/* Of one instance, and one row of columns. */
static enum status add_record(struct result_numbers *n, const struct result *r,
                              size_t instance, size_t row)
{
    enum status status = STATUS_OK;
    char prefix[RESULT_NAME];

    result_prefix(r, instance, prefix);
    const size_t end = strlen(prefix);
    if (r->shape == RESULT_COLUMNS)
        snprintf(prefix + end, sizeof prefix - end, "%zu_", row);
    for (size_t i = 0; i < r->type->count && status == STATUS_OK; i++) {
        const struct record_field *f = &r->type->fields[i];
        struct result_number x = {
            .of = r, .instance = instance, .row = row, .field = f
        };
        memcpy(x.name, prefix, sizeof x.name);
        strncat(x.name, f->name, sizeof x.name - strlen(x.name) - 1);
        if (stands_alone(f))
            status = add(n, &x);
    }
    return status;
}

static enum status add_result(struct result_numbers *n, const struct result *r,
                              const void *run)
{
    const size_t instances = result_count(r, run);
    const size_t rows = r->shape == RESULT_COLUMNS ? r->alone : 1;
    enum status status = STATUS_OK;

    for (size_t i = 0; i < instances * rows && status == STATUS_OK; i++)
        status = add_record(n, r, i / rows, i % rows);
    return status;
}

static enum status add_shape(struct result_numbers *n,
                             const struct results *all, enum result_shape shape)
{
    enum status status = STATUS_OK;

    for (size_t t = 0; all->table[t]; t++)
        for (const struct result *r = all->table[t]; r->type && !status; r++)
            if (r->name && r->shape == shape && result_asked(r, all) &&
                (shape == RESULT_SCALARS || r->alone > 0))
                status = add_result(n, r, all->run);
    return status;
}

enum status result_numbers_init(struct result_numbers *n,
                                const struct results *all)
{
    *n = (struct result_numbers){ .at = NULL };
    enum status status = add_shape(n, all, RESULT_SCALARS);
    if (status == STATUS_OK)
        status = add_shape(n, all, RESULT_COLUMNS);
    if (status != STATUS_OK)
        result_numbers_free(n);
    return status;
}

void result_numbers_free(struct result_numbers *n)
{
    free(n->at);
    *n = (struct result_numbers){ .at = NULL };
}

const struct result_number *result_numbers_find(const struct result_numbers *n,
                                                const char *name)
{
    for (size_t i = 0; i < n->count; i++)
        if (strcmp(n->at[i].name, name) == 0)
            return &n->at[i];
    return NULL;
}

/* ---- what is there ------------------------------------------------------- */

/* Copies the member, if it is there. */
static bool read_member(const struct results *all,
                        const struct result_number *n, void *to, size_t size)
{
    struct result_view v;
    const bool here = result_open(all, n->of, n->instance, &v) == STATUS_OK &&
                      v.here && n->row < v.records.count;

    if (here)
        memcpy(to, record_member(&v.records, n->row, n->field), size);
    result_close(&v);
    return here;
}

static struct quantity bound_of(const struct quantity *q, enum result_part part)
{
    const struct proved *p = q->proved;

    if (p == NULL)
        return quantity_none(quantity_exists(q)
                                 ? "nothing is proved of this number"
                                 : q->reason);
    if (p->not_proved || p->absent)
        return quantity_none(p->absent ? "that there is none is proved"
                                       : p->not_proved);
    return quantity_of(part == RESULT_LO ? p->lo : p->hi, 0.0);
}

struct quantity result_quantity(const struct results *all,
                                const struct result_number *n)
{
    const char *fewer = n->of->fewer;
    struct quantity q =
        quantity_none(fewer ? fewer : status_text(STATUS_NO_MEMORY));
    double real;
    int64_t count;

    if (n->field->kind == RECORD_REAL &&
        read_member(all, n, &real, sizeof real))
        return quantity_of(real, 0.0);
    if (n->field->kind == RECORD_COUNT &&
        read_member(all, n, &count, sizeof count))
        return count == RECORD_COUNT_NONE ? quantity_none("there is none")
                                          : quantity_of((double) count, 0.0);
    if (n->field->kind == RECORD_QUANTITY)
        (void) read_member(all, n, &q, sizeof q);
    return n->part == RESULT_VALUE ? q : bound_of(&q, n->part);
}

int8_t result_code(const struct results *all, const struct result_number *n)
{
    int8_t code = -1;

    (void) read_member(all, n, &code, sizeof code);
    return code;
}
