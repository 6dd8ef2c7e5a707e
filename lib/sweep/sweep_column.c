#include "sweep_column.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plane_numbers.h"
#include "plane_proof.h"
#include "plane_results.h"
#include "room.h"
#include "study_results.h"
#include "sweep_results.h"

/* ---- which --------------------------------------------------------------- */

/* A column for a number, along these dimensions (NULL: by itself). */
static enum status add(struct sweep_columns *c, const struct sweep_dims *d,
                       const struct result_number *n, const char *axis,
                       size_t names)
{
    if (ROOM_FOR(c->at, c->room, c->count + 1) != STATUS_OK)
        return STATUS_NO_MEMORY;
    struct sweep_column *column = &c->at[c->count++];
    *column = (struct sweep_column){
        .unit = n->field->unit,
        .codes = n->field->codes,
        .kind = n->field->kind,
        .number = *n,
        .names = names,
        .inner = 1,
        .first = c->entries,
        .entries = 1,
    };
    column->dims = sweep_dims_of(axis, "", column->dim);
    for (size_t i = 0; i < column->dims; i++)
        column->entries *= d->of[column->dim[i]].count;
    if (axis && n->of->shape == RESULT_COLUMNS)
        column->inner = d->of[column->dim[column->dims - 1]].count;
    c->entries += column->entries;
    snprintf(column->name, sizeof column->name, "%.63s", n->name);
    snprintf(column->text, sizeof column->text, "%s", n->field->text);
    return STATUS_OK;
}

/* And, if it is a quantity, one for each bound that is proved of it. */
static enum status add_bounds(struct sweep_columns *c,
                              const struct sweep_dims *d,
                              const struct result_number *n)
{
    static const char *const text[] = { ": proved to be at least",
                                        ": proved to be at most" };
    enum status status = STATUS_OK;

    for (int k = 0; k < 2 && n->field->kind == RECORD_QUANTITY; k++) {
        struct result_number bound = *n;
        bound.part = k ? RESULT_HI : RESULT_LO;
        strncat(bound.name, k ? "_hi" : "_lo",
                sizeof bound.name - strlen(bound.name) - 1);
        status = add(c, d, &bound, NULL, 0);
        if (status != STATUS_OK)
            return status;
        struct sweep_column *column = &c->at[c->count - 1];
        column->kind = RECORD_REAL;
        const size_t end = strlen(column->text);
        snprintf(column->text + end, sizeof column->text - end, "%s", text[k]);
    }
    return status;
}

/* Of rows of columns, or the others. */
static enum status add_numbers(struct sweep_columns *c,
                               const struct sweep_dims *d,
                               const struct result_numbers *n, bool columns)
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < n->count && status == STATUS_OK; i++) {
        const struct result_number *x = &n->at[i];
        if ((x->of->shape == RESULT_COLUMNS) != columns)
            continue;
        status = add(c, d, x, NULL, 0);
        if (status == STATUS_OK && c->proved && study_proves(x->of->type))
            status = add_bounds(c, d, x);
    }
    return status;
}

/* Attributes have members of any kind. */
static bool is_kept(const struct result *r, const struct record_field *f)
{
    return f->kind == RECORD_QUANTITY || f->kind == RECORD_CODE ||
           (r->shape == RESULT_ATTRIBUTES && f->kind != RECORD_TEXT);
}

/* Under one of its names. */
static enum status add_name(struct sweep_columns *c, const struct sweep_dims *d,
                            const struct result *r, size_t k, size_t names)
{
    enum status status = STATUS_OK;
    char prefix[RESULT_NAME], member[RESULT_NAME];

    result_prefix(r, k, prefix);
    for (size_t i = 0; i < r->type->count && status == STATUS_OK; i++) {
        struct result_number n = { .of = r,
                                   .instance = k,
                                   .field = &r->type->fields[i] };
        result_member(r, k, n.field, member);
        memcpy(n.name, prefix, sizeof n.name);
        strncat(n.name, member, sizeof n.name - strlen(n.name) - 1);
        if (is_kept(r, n.field))
            status = add(c, d, &n, r->axis, names);
    }
    return status;
}

static enum status add_result(struct sweep_columns *c,
                              const struct sweep_dims *d,
                              const struct scene *scene, const struct result *r)
{
    const struct sweep_point some = { .scene = *scene };
    const size_t names = result_count(r, &some);
    enum status status = STATUS_OK;

    for (size_t k = 0; k < names && status == STATUS_OK; k++) {
        const size_t first = c->count;
        status = add_name(c, d, r, k, names);
        for (size_t i = first; i < c->count && r->type == &record_xi; i++) {
            char *text = c->at[i].text;
            const size_t end = strlen(text);
            snprintf(text + end, sizeof c->at[i].text - end, " at xi = %.15g",
                     scene->xi[k]);
        }
    }
    return status;
}

static enum status add_all(struct sweep_columns *c, const struct scene *scene,
                           const struct sweep_dims *d,
                           const struct result_numbers *n)
{
    const struct results all = { .asked = sweep_asked(scene) };
    enum status status = add_numbers(c, d, n, false);

    for (size_t t = 0; point_tables[t]; t++)
        for (const struct result *r = point_tables[t]; r->type && !status; r++)
            if (r->name && result_asked(r, &all))
                status = add_result(c, d, scene, r);
    return status ? status : add_numbers(c, d, n, true);
}

static enum status add_of_law(struct sweep_columns *c,
                              const struct scene *scene,
                              const struct sweep_dims *d)
{
    const uint64_t asked = sweep_asked(scene);
    struct result_numbers n;

    c->conditioning = (asked & ASKED_BY(SENSITIVITIES)) != 0;
    c->proved = scene->proved;
    enum status status = study_numbers(&n, asked);
    if (status == STATUS_OK)
        status = add_all(c, scene, d, &n);
    result_numbers_free(&n);
    return status;
}

static enum status add_of_system(struct sweep_columns *c,
                                 const struct scene *scene,
                                 const struct sweep_dims *d)
{
    struct result_numbers n = { .at = NULL };

    c->conditioning = (scene->products & 1u << PRODUCT_SENSITIVITIES) != 0;
    c->frame = malloc(sizeof *c->frame);
    if (c->frame == NULL)
        return STATUS_NO_MEMORY;
    enum status status = plane_numbers_frame(c->frame, scene);
    if (status == STATUS_OK)
        status = plane_numbers(&n, c->frame);
    for (size_t i = 0; i < n.count && status == STATUS_OK; i++) {
        status = add(c, d, &n.at[i], NULL, 0);
        if (status == STATUS_OK && scene->proved &&
            plane_proof_is_of(n.at[i].of, n.at[i].field))
            status = add_bounds(c, d, &n.at[i]);
    }
    result_numbers_free(&n);
    return status;
}

enum status sweep_columns_init(struct sweep_columns *c,
                               const struct scene *scene,
                               const struct sweep_dims *d)
{
    *c = (struct sweep_columns){ .at = NULL };
    const enum status status =
        scene->system ? add_of_system(c, scene, d) : add_of_law(c, scene, d);
    if (status != STATUS_OK)
        sweep_columns_free(c);
    return status;
}

void sweep_columns_free(struct sweep_columns *c)
{
    free(c->at);
    if (c->frame)
        plane_numbers_free(c->frame);
    free(c->frame);
    *c = (struct sweep_columns){ .at = NULL };
}

/* ---- what is there ------------------------------------------------------- */

static struct results results_of(const struct sweep_column *c,
                                 const struct sweep_point *p)
{
    if (p->system)
        return plane_results(&p->plane);
    return c->names > 0 ? (struct results){ .table = point_tables, .run = p }
                        : study_results(&p->study);
}

static struct result_number number_of(const struct sweep_column *c,
                                      size_t entry)
{
    struct result_number n = c->number;

    n.instance += entry / c->inner * c->names;
    n.row += entry % c->inner;
    return n;
}

struct quantity sweep_column_quantity(const struct sweep_column *c,
                                      const struct sweep_point *p, size_t entry)
{
    static const char *const hidden = "not all equilibria could be told apart";
    const struct result_number n = number_of(c, entry);

    if (p->failed)
        return quantity_none(p->failed);
    const struct results all = results_of(c, p);
    const struct quantity q = result_quantity(&all, &n);
    return p->system && !p->plane.complete && q.reason == n.of->fewer &&
                   !quantity_exists(&q)
               ? quantity_none(hidden)
               : q;
}

int8_t sweep_column_code(const struct sweep_column *c,
                         const struct sweep_point *p, size_t entry)
{
    const struct result_number n = number_of(c, entry);

    if (p->failed)
        return -1;
    const struct results all = results_of(c, p);
    return result_code(&all, &n);
}
