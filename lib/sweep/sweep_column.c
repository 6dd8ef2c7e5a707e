#include "sweep_column.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "study_results.h"
#include "sweep_product.h"

/* ---- which --------------------------------------------------------------- */

static size_t entries_of(const struct sweep_dims *d,
                         const struct column_part *part)
{
    size_t n = 1;

    for (size_t i = 0; i < part->dims; i++)
        n *= d->of[part->dim[i]].count;
    return n;
}

static struct sweep_column *room_for_one(struct sweep_columns *c)
{
    if (c->count == c->room) {
        const size_t room = c->room ? 2 * c->room : 64;
        struct sweep_column *at = realloc(c->at, room * sizeof *at);
        if (at == NULL)
            return NULL;
        c->at = at;
        c->room = room;
    }
    return &c->at[c->count++];
}

enum status column_add(const struct column_adder *a,
                       const struct column_part *part,
                       const struct record_field *f)
{
    struct sweep_columns *c = a->to;
    struct sweep_column *column = room_for_one(c);

    if (column == NULL)
        return STATUS_NO_MEMORY;
    *column = (struct sweep_column){
        .unit = f->unit,
        .codes = f->codes,
        .kind = f->kind,
        .source = part->source,
        .offset = part->base + f->offset,
        .stride = part->stride,
        .dim = { part->dim[0], part->dim[1] },
        .dims = part->dims,
        .first = c->entries,
        .entries = entries_of(a->dims, part),
    };
    c->entries += column->entries;
    snprintf(column->name, sizeof column->name, "%s%s", part->prefix, f->name);
    snprintf(column->text, sizeof column->text, "%s", f->text);
    return STATUS_OK;
}

enum status column_add_record(const struct column_adder *a,
                              const struct column_part *part,
                              const struct record_type *type)
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < type->count && status == STATUS_OK; i++)
        if (type->fields[i].kind == RECORD_QUANTITY ||
            type->fields[i].kind == RECORD_CODE)
            status = column_add(a, part, &type->fields[i]);
    return status;
}

enum status column_add_number(const struct column_adder *a,
                              const struct result_number *n)
{
    const struct column_part part = { .prefix = "", .source = SOURCE_RESULT };
    struct record_field f = *n->field;

    f.name = n->name;
    const enum status status = column_add(a, &part, &f);
    if (status == STATUS_OK)
        a->to->at[a->to->count - 1].number = *n;
    return status;
}

enum status sweep_columns_init(struct sweep_columns *c,
                               const struct scene *scene,
                               const struct sweep_dims *d)
{
    const unsigned stages = plan_stages(scene->products);
    const struct column_adder a = { c, scene, d, stages };

    *c = (struct sweep_columns){
        .conditioning = plan_has(stages, STAGE_SENSITIVITIES),
    };
    const enum status status = sweep_product_add(&a);
    if (status != STATUS_OK)
        sweep_columns_free(c);
    return status;
}

void sweep_columns_free(struct sweep_columns *c)
{
    free(c->at);
    *c = (struct sweep_columns){ .at = NULL };
}

/* ---- what is there ------------------------------------------------------- */

static const void *member_of(const struct sweep_column *c,
                             const struct sweep_point *p, size_t entry)
{
    if (c->dims == 0)
        return (const char *) p + c->offset;
    const size_t outer = c->source == SOURCE_START ? p->starts
                         : c->source == SOURCE_CHI ? c->entries
                                                   : 1;
    const size_t inner = c->entries / outer;
    const size_t offset = c->offset + entry % inner * c->stride;

    if (c->source == SOURCE_START)
        return (const char *) &p->start[entry / inner] + offset;
    if (c->source == SOURCE_CHI)
        return (const char *) &p->study.diagrams.chi.slope[entry] + offset;
    return (const char *) p + offset;
}

struct quantity sweep_column_quantity(const struct sweep_column *c,
                                      const struct sweep_point *p, size_t entry)
{
    const struct results all = study_results(&p->study);

    if (p->failed)
        return quantity_none(p->failed);
    if (c->source == SOURCE_RESULT)
        return result_quantity(&all, &c->number);
    const void *member = member_of(c, p, entry);
    if (c->kind == RECORD_REAL)
        return quantity_of(*(const double *) member, 0.0);
    if (c->kind == RECORD_COUNT)
        return quantity_of((double) *(const int64_t *) member, 0.0);
    return *(const struct quantity *) member;
}

int8_t sweep_column_code(const struct sweep_column *c,
                         const struct sweep_point *p, size_t entry)
{
    const struct results all = study_results(&p->study);

    if (p->failed)
        return -1;
    return c->source == SOURCE_RESULT
               ? result_code(&all, &c->number)
               : *(const int8_t *) member_of(c, p, entry);
}
