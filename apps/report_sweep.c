#include "report_sweep.h"

#include <string.h>

/* ---- text -----------------------------------------------------------------
 */

/* More points than these are shown in part. */
enum { ROWS = 24 };

static const char *const shown[] = { "saddle_v", "v_minus", "v_plus",
                                     "mu_s_num" };
enum { SHOWN = sizeof shown / sizeof *shown };

static void print_axes(FILE *out, const struct sweep *s)
{
    for (size_t k = 0; k < s->axes; k++) {
        const struct sweep_axis *a = &s->axis[k];
        fprintf(out, "%s: %zu values from %.6g to %.6g\n", a->key.path,
                a->count, a->value[0], a->value[a->count - 1]);
    }
}

static void print_point(FILE *out, const struct sweep *s, size_t i)
{
    const size_t inner = s->axes > 1 ? s->axis[1].count : 1;

    fprintf(out, "  %-14.8g", s->axis[0].value[i / inner]);
    if (s->axes > 1)
        fprintf(out, " %-14.8g", s->axis[1].value[i % inner]);
    for (int k = 0; k < SHOWN; k++) {
        const int column = sweep_find(s, shown[k]);
        if (column < 0)
            continue;
        const struct quantity q = sweep_quantity(s, column, i);
        if (quantity_exists(&q))
            fprintf(out, " %-16.10g", q.value);
        else
            fprintf(out, " %-16s", "-");
    }
    fputc('\n', out);
}

static void print_table(FILE *out, const struct sweep *s)
{
    const size_t rows = s->points < ROWS ? s->points : ROWS;

    for (size_t k = 0; k < s->axes; k++)
        fprintf(out, "%s%-14s", k ? " " : "  ", s->axis[k].name);
    for (int k = 0; k < SHOWN; k++)
        if (sweep_find(s, shown[k]) >= 0)
            fprintf(out, " %-16s", shown[k]);
    fputc('\n', out);
    for (size_t i = 0; i < rows; i++)
        print_point(out, s, rows > 1 ? i * (s->points - 1) / (rows - 1) : 0);
    if (rows < s->points)
        fprintf(out, "  (%zu of %zu points)\n", rows, s->points);
}

/* "v_plus is missing at 3 of 41 points: there is no saddle at this slope" */
static void print_missing(FILE *out, const struct sweep *s, const char *name)
{
    const int column = sweep_find(s, name);

    for (size_t r = 0; column >= 0 && r < s->reasons.count; r++) {
        size_t count = 0;
        for (size_t i = 0; i < s->points; i++)
            count += sweep_code(s, column, i) == (int) r;
        if (r != REASON_PRESENT && count > 0)
            fprintf(out, "%s is missing at %zu of %zu points: %s\n", name,
                    count, s->points, s->reasons.text[r]);
    }
}

void report_sweep_print(FILE *out, const struct sweep *s)
{
    fprintf(out, "%s (%s form)\n", s->scene->law.preset,
            friction_form_names[s->scene->law.form]);
    print_axes(out, s);
    print_table(out, s);
    print_missing(out, s, "v_minus");
    print_missing(out, s, "v_plus");
}

/* ---- JSON -----------------------------------------------------------------
 */

static json_t *axis_json(const struct sweep_axis *a)
{
    json_t *j = json_object(), *values = json_array();

    for (size_t i = 0; i < a->count; i++)
        json_array_append_new(values, json_number(a->value[i]));
    json_object_set_new(j, "key", json_string(a->key.path));
    json_object_set_new(j, "name", json_string(a->name));
    json_object_set_new(j, "unit", json_string(a->key.unit));
    json_object_set_new(j, "values", values);
    return j;
}

static json_t *words_json(const struct sweep *s, int column)
{
    const char *const *word = s->columns.at[column].codes;
    json_t *j = json_array();

    for (size_t i = 0; i < s->points; i++) {
        const int code = sweep_code(s, column, i);
        json_array_append_new(j,
                              code < 0 ? json_null() : json_string(word[code]));
    }
    return j;
}

static json_t *quantity_json(const struct sweep *s, int column)
{
    json_t *j = json_object(), *value = json_array(), *error = json_array(),
           *reason = json_array();

    for (size_t i = 0; i < s->points; i++) {
        const struct quantity q = sweep_quantity(s, column, i);
        const bool is = quantity_exists(&q);
        json_array_append_new(value, is ? json_number(q.value) : json_null());
        json_array_append_new(error, is ? json_number(q.error) : json_null());
        json_array_append_new(
            reason, is ? json_null() : json_integer(sweep_code(s, column, i)));
    }
    json_object_set_new(j, "value", value);
    json_object_set_new(j, "error", error);
    json_object_set_new(j, "reason", reason);
    return j;
}

static json_t *numbers_json(const struct sweep *s)
{
    json_t *j = json_object();

    for (size_t k = 0; k < s->columns.count; k++)
        json_object_set_new(j, s->columns.at[k].name,
                            s->columns.at[k].codes ? words_json(s, (int) k)
                                                   : quantity_json(s, (int) k));
    return j;
}

json_t *report_sweep_json(const struct sweep *s)
{
    json_t *j = json_object(), *keys = json_array(), *reasons = json_array();

    for (size_t k = 0; k < s->axes; k++)
        json_array_append_new(keys, axis_json(&s->axis[k]));
    for (size_t r = 0; r < s->reasons.count; r++)
        json_array_append_new(reasons, json_string(s->reasons.text[r]));
    json_object_set_new(j, "law", json_string(s->scene->law.preset));
    json_object_set_new(j, "form",
                        json_string(friction_form_names[s->scene->law.form]));
    json_object_set_new(j, "keys", keys);
    json_object_set_new(j, "points", json_integer((json_int_t) s->points));
    json_object_set_new(j, "failed", json_integer((json_int_t) s->failed));
    json_object_set_new(j, "reasons", reasons);
    json_object_set_new(j, "numbers", numbers_json(s));
    return j;
}

/* ---- plan -----------------------------------------------------------------
 */

size_t report_sweep_plan(const struct scene *s, char *text, size_t size)
{
    size_t points = 1, end = 0;

    for (size_t k = 0; k < s->sweep.axes && end < size; k++) {
        const struct scene_axis *a = &s->sweep.axis[k];
        end += (size_t) snprintf(text + end, size - end,
                                 "%s%s at %zu values from %g to %g",
                                 k ? ", " : "", a->key, a->count, a->value[0],
                                 a->value[a->count - 1]);
        points *= a->count;
    }
    if (s->sweep.refine > 0.0 && end < size)
        snprintf(text + end, size - end, ", refined to %g", s->sweep.refine);
    return points;
}
