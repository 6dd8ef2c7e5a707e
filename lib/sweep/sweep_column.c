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

enum status column_add_result(const struct column_adder *a,
                              const struct result *r)
{
    const size_t n = result_count(r, NULL);
    enum status status = STATUS_OK;

    for (size_t k = 0; k < n && status == STATUS_OK; k++) {
        const size_t first = a->to->count;
        char prefix[RESULT_NAME];
        result_prefix(r, k, prefix);
        status = column_add_record(
            a,
            &(struct column_part){ .prefix = prefix, .source = SOURCE_RESULT },
            r->type);
        for (size_t i = first; i < a->to->count; i++) {
            a->to->at[i].result = r;
            a->to->at[i].instance = k;
        }
    }
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

/* Copies the member of an entry, if it is there. */
static bool read_member(const struct sweep_column *c,
                        const struct sweep_point *p, size_t entry, void *to,
                        size_t size)
{
    if (c->source != SOURCE_RESULT) {
        memcpy(to, member_of(c, p, entry), size);
        return true;
    }
    const struct results all = study_results(&p->study);
    struct result_view v;
    const bool here =
        result_open(&all, c->result, c->instance, &v) == STATUS_OK && v.here;
    if (here)
        memcpy(to, (const char *) v.records.at + c->offset, size);
    result_close(&v);
    return here;
}

struct quantity sweep_column_quantity(const struct sweep_column *c,
                                      const struct sweep_point *p, size_t entry)
{
    struct quantity q = quantity_none(status_text(STATUS_NO_MEMORY));
    double real;
    int64_t count;

    if (p->failed)
        return quantity_none(p->failed);
    if (c->kind == RECORD_REAL && read_member(c, p, entry, &real, sizeof real))
        return quantity_of(real, 0.0);
    if (c->kind == RECORD_COUNT &&
        read_member(c, p, entry, &count, sizeof count))
        return quantity_of((double) count, 0.0);
    if (c->kind == RECORD_QUANTITY)
        (void) read_member(c, p, entry, &q, sizeof q);
    return q;
}

int8_t sweep_column_code(const struct sweep_column *c,
                         const struct sweep_point *p, size_t entry)
{
    int8_t code = -1;

    if (!p->failed)
        (void) read_member(c, p, entry, &code, sizeof code);
    return code;
}
