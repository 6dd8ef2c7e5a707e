#include "sweep_finish.h"

#include <stdlib.h>
#include <string.h>

static bool is_failure(const char *reason)
{
    for (int s = STATUS_OK + 1; s < STATUS_COUNT; s++)
        if (strcmp(reason, status_text((enum status) s)) == 0)
            return true;
    return false;
}

static enum status sort_reason(struct sweep *s, struct sweep_reasons *sorted,
                               int8_t *code)
{
    return *code >= REASON_FIRST
               ? sweep_reasons_code(sorted, s->reasons.text[*code], code)
               : STATUS_OK;
}

/* Reasons numbered as they come from the first point to the last. */
static enum status sort_reasons(struct sweep *s)
{
    struct sweep_reasons sorted;
    enum status status = sweep_reasons_init(&sorted);

    for (size_t i = 0; i < s->rows.count && status == STATUS_OK; i++)
        for (size_t k = 0; k < s->columns.count && status == STATUS_OK; k++) {
            const struct sweep_column *c = &s->columns.at[k];
            int8_t *code = sweep_rows_code(&s->rows, i, c->first);
            for (size_t n = 0; n < c->entries && !c->codes && !status; n++)
                status = sort_reason(s, &sorted, &code[n]);
        }
    sweep_reasons_free(&s->reasons);
    s->reasons = sorted;
    return status;
}

/* Numbers of things that are counted: of rows, or of instances. */
static bool is_one_of_many(const struct sweep_column *c)
{
    return c->dims == 0 &&
           ((c->names == 0 && c->number.of->count) ||
            (c->number.of->shape == RESULT_COLUMNS && c->number.of->alone > 0));
}

static bool is_anywhere(const struct sweep *s, const struct sweep_column *c)
{
    for (size_t i = 0; i < s->rows.count; i++) {
        const int8_t code = *sweep_rows_code(&s->rows, i, c->first);
        if (c->codes ? code >= 0 : code == REASON_PRESENT)
            return true;
    }
    return false;
}

/* Columns of those that no point has go. */
static void trim_columns(struct sweep *s)
{
    size_t kept = 0;

    for (size_t k = 0; k < s->columns.count; k++)
        if (!is_one_of_many(&s->columns.at[k]) ||
            is_anywhere(s, &s->columns.at[k]))
            s->columns.at[kept++] = s->columns.at[k];
    s->columns.count = kept;
}

static void count_failures(struct sweep *s)
{
    size_t k = 0;

    while (k < s->columns.count && s->columns.at[k].codes)
        k++;
    for (size_t i = 0; k < s->columns.count && i < s->points; i++) {
        const struct quantity q = sweep_quantity(s, (int) k, i);
        s->failed += !quantity_exists(&q) && is_failure(q.reason);
    }
}

/* Its last word, where that is not the other's, too. */
static const char *name_of(const struct scene_sweep *w, size_t k)
{
    const char *last[SCENE_AXES];

    for (size_t i = 0; i < w->axes; i++) {
        const char *dot = strrchr(w->axis[i].key, '.');
        last[i] = dot ? dot + 1 : w->axis[i].key;
    }
    return w->axes == 2 && strcmp(last[0], last[1]) == 0 ? w->axis[k].key
                                                         : last[k];
}

static enum status set_axes(struct sweep *s)
{
    for (size_t k = 0; k < s->axes; k++) {
        const struct scene_axis *from = &s->scene->sweep.axis[k];
        struct sweep_axis *axis = &s->axis[k];
        *axis = (struct sweep_axis){
            .key = sweep_key_of(from->key),
            .name = name_of(&s->scene->sweep, k),
            .count = s->axes == 1 ? s->rows.count : from->count,
            .is_log = from->scale == SWEEP_LOG,
        };
        axis->value = malloc(axis->count * sizeof *axis->value);
        if (axis->value == NULL)
            return STATUS_NO_MEMORY;
        for (size_t i = 0; i < axis->count; i++)
            axis->value[i] =
                s->axes == 1 ? sweep_rows_x(&s->rows, i)[0] : from->value[i];
    }
    return STATUS_OK;
}

enum status sweep_finish(struct sweep *s)
{
    enum status status = set_axes(s);

    s->points = s->rows.count;
    trim_columns(s);
    if (status == STATUS_OK)
        status = sort_reasons(s);
    if (status == STATUS_OK)
        count_failures(s);
    return status;
}
