#include "picture_sweep.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A column as drawn over one key. */
struct look {
    const char *column, *entry;
    struct figure_style style;
};

static const struct look curves[] = {
    { "v_plus", "v₊", { FIGURE_SERIES_1, FIGURE_SOLID, 0 } },
    { "saddle_v", "v at the saddle", { FIGURE_SERIES_2, FIGURE_DASHED, 0 } },
    { "v_minus", "v₋", { FIGURE_SERIES_3, FIGURE_SOLID, 0 } },
    { "knee_upper_v", "upper knee", { FIGURE_SERIES_4, FIGURE_DOTTED, 0 } },
    { "knee_lower_v", "lower knee", { FIGURE_SERIES_5, FIGURE_DOTTED, 0 } },
};
enum { CURVES = sizeof curves / sizeof *curves };

/* A bar can be seen when it is this part of ln v long: 2 px of 600 over ten
 * decades. */
static const double visible = 0.04;

static double place(const struct sweep_axis *a, double x)
{
    return a->is_log ? log(x) : x;
}

/* From lo to hi, and half of `step` on both sides; of one value, around it. */
static struct figure_axis around(const char *label, double lo, double hi,
                                 bool is_log, double rim)
{
    if (!(lo < hi))
        rim = is_log ? 1.0 : fabs(lo) + 1.0;
    if (is_log)
        return (struct figure_axis){ label, lo * exp(-rim), hi * exp(rim),
                                     true };
    return (struct figure_axis){ label, lo - rim, hi + rim, false };
}

static void label_of(const struct sweep_axis *a, char *label, size_t size)
{
    if (a->key.unit[0] == '1')
        snprintf(label, size, "%s", a->key.path);
    else
        snprintf(label, size, "%s (%s)", a->key.path, a->key.unit);
}

static void title_of(const struct sweep *s, char *title, size_t size)
{
    const struct scene *c = s->scene;

    snprintf(title, size, "%s%s%s", c->title, c->title[0] ? " — " : "",
             c->law.preset);
    if (s->axis[0].key.path[0] != 's' &&
        (s->axes < 2 || s->axis[1].key.path[0] != 's')) {
        const size_t end = strlen(title);
        snprintf(title + end, size - end, ", α = %.6g rad", c->alpha);
    }
}

/* ---- over one key ---------------------------------------------------------
 */

/* Values of a column, NaN where there are none, and their errors. */
struct series {
    double *y, *error; /* owned */
};

static void free_series(struct series *q)
{
    free(q->y);
    free(q->error);
}

static enum status read_series(const struct sweep *s, int column,
                               struct series *q)
{
    q->y = malloc(s->points * sizeof *q->y);
    q->error = malloc(s->points * sizeof *q->error);
    if (q->y == NULL || q->error == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < s->points; i++) {
        const struct quantity v = sweep_quantity(s, column, i);
        q->y[i] = v.value;
        q->error[i] = v.error;
    }
    return STATUS_OK;
}

/* The least and largest value of all curves; 0.1 and 10 where there are none.
 */
static void span(const struct sweep *s, double range[2])
{
    range[0] = HUGE_VAL;
    range[1] = 0.0;
    for (int k = 0; k < CURVES; k++) {
        const int column = sweep_find(s, curves[k].column);
        for (size_t i = 0; column >= 0 && i < s->points; i++) {
            const struct quantity v = sweep_quantity(s, column, i);
            if (quantity_exists(&v) && v.value > 0.0 && isfinite(v.value)) {
                range[0] = fmin(range[0], v.value);
                range[1] = fmax(range[1], v.value);
            }
        }
    }
    if (!(range[0] <= range[1])) {
        range[0] = 0.1;
        range[1] = 10.0;
    }
}

static enum status add_bar(struct figure *f, const struct look *look, double x,
                           double y, double error)
{
    const double at[2] = { x, x };
    const double ends[2] = { fmax(y - error, 0.1 * y), y + error };

    return figure_add_curve(
        f, &(struct figure_curve){
               .style = { .role = look->style.role, .dash = FIGURE_SOLID },
               .x = at,
               .y = ends,
               .count = 2 });
}

static enum status add_curve(const struct sweep *s, const struct look *look,
                             int column, struct figure *f)
{
    struct series q = { .y = NULL };
    enum status status = read_series(s, column, &q);

    if (status == STATUS_OK)
        status =
            figure_add_curve(f, &(struct figure_curve){ .style = look->style,
                                                        .entry = look->entry,
                                                        .x = s->axis[0].value,
                                                        .y = q.y,
                                                        .count = s->points });
    for (size_t i = 0; i < s->points && status == STATUS_OK; i++)
        if (q.error[i] > 0.5 * visible * q.y[i])
            status = add_bar(f, look, s->axis[0].value[i], q.y[i], q.error[i]);
    free_series(&q);
    return status;
}

static enum status draw_curves(const struct sweep *s, struct figure *f)
{
    const struct sweep_axis *a = &s->axis[0];
    char title[512], label[96];
    double range[2];

    title_of(s, title, sizeof title);
    label_of(a, label, sizeof label);
    span(s, range);
    const struct figure_axis x =
        around(label, a->value[0], a->value[a->count - 1], a->is_log, 0.0);
    const struct figure_axis y =
        around("slip rate v = V/V*", range[0], range[1], true,
               0.03 * log(range[1] / range[0]) + 0.03);
    enum status status = figure_init(f, title, &x, &y);
    for (int k = 0; k < CURVES && status == STATUS_OK; k++) {
        const int column = sweep_find(s, curves[k].column);
        if (column >= 0)
            status = add_curve(s, &curves[k], column, f);
    }
    return status;
}

/* ---- over a grid ----------------------------------------------------------
 */

/* Cells of the map: no finer than can be seen. */
enum { COLUMNS = 360, ROWS = 240 };

/* The axis that shows all values, with half a step around them. */
static struct figure_axis frame(const struct sweep_axis *a, const char *label)
{
    const double lo = a->value[0], hi = a->value[a->count - 1];
    const double step =
        a->count > 1 ? (place(a, hi) - place(a, lo)) / (double) (a->count - 1)
                     : 0.0;

    return around(label, lo, hi, a->is_log, 0.5 * step);
}

/* The value nearest the middle of each of n cells, as an index. */
static void nearest(const struct sweep_axis *a, const struct figure_axis *shown,
                    size_t n, size_t index[])
{
    const double lo = place(a, shown->lo), hi = place(a, shown->hi);
    size_t k = 0;

    for (size_t i = 0; i < n; i++) {
        const double x = lo + (hi - lo) * ((double) i + 0.5) / (double) n;
        while (k + 1 < a->count && fabs(place(a, a->value[k + 1]) - x) <=
                                       fabs(place(a, a->value[k]) - x))
            k++;
        index[i] = k;
    }
}

static enum status add_map(const struct sweep *s, const struct figure_axis *x,
                           const struct figure_axis *y, struct figure *f)
{
    const int column = sweep_find(s, "ln_v_plus");
    size_t across[COLUMNS], up[ROWS];
    double *value = malloc((size_t) COLUMNS * ROWS * sizeof *value);

    if (value == NULL)
        return STATUS_NO_MEMORY;
    nearest(&s->axis[0], x, COLUMNS, across);
    nearest(&s->axis[1], y, ROWS, up);
    for (size_t j = 0; j < ROWS; j++)
        for (size_t i = 0; i < COLUMNS; i++)
            value[j * COLUMNS + i] =
                column < 0
                    ? (double) NAN
                    : sweep_quantity(s, column,
                                     across[i] * s->axis[1].count + up[j])
                          .value;
    const enum status status = figure_add_map(
        f, &(struct figure_map){ .value = value,
                                 .nx = COLUMNS,
                                 .ny = ROWS,
                                 .scale = { .label = "ln v₊" } });
    free(value);
    return status;
}

static enum status draw_map(const struct sweep *s, struct figure *f)
{
    char title[512], label[2][96];

    title_of(s, title, sizeof title);
    label_of(&s->axis[0], label[0], sizeof label[0]);
    label_of(&s->axis[1], label[1], sizeof label[1]);
    const struct figure_axis x = frame(&s->axis[0], label[0]);
    const struct figure_axis y = frame(&s->axis[1], label[1]);
    const enum status status = figure_init(f, title, &x, &y);
    return status ? status : add_map(s, &x, &y, f);
}

enum status picture_sweep(const struct sweep *s, struct figure *f)
{
    *f = FIGURE_EMPTY;
    const enum status status =
        s->axes == 1 ? draw_curves(s, f) : draw_map(s, f);
    if (status != STATUS_OK)
        figure_free(f);
    return status;
}
