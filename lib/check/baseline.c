#include "baseline.h"

#include <float.h>
#include <locale.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "row_numbers.h"
#include "scene_slope.h"
#include "tolerance.h"

static const char preface[] =
    "# Recorded by slipway check --record.  NAME_tol is the tolerance of NAME, "
    "absolute.\n";

/* ---- text ---------------------------------------------------------------- */

static void add(struct baseline *b, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static bool make_room(struct baseline *b, size_t size)
{
    const size_t need = b->size + size + 1;

    if (b->full || need <= b->room)
        return !b->full;
    char *more = realloc(b->text, 2 * need);
    if (more == NULL) {
        b->full = true;
        return false;
    }
    b->text = more;
    b->room = 2 * need;
    return true;
}

static void add(struct baseline *b, const char *format, ...)
{
    va_list list;

    va_start(list, format);
    const int size = vsnprintf(NULL, 0, format, list);
    va_end(list);
    if (size < 0 || !make_room(b, (size_t) size))
        return;
    va_start(list, format);
    b->size +=
        (size_t) vsnprintf(b->text + b->size, b->room - b->size, format, list);
    va_end(list);
}

/* With a decimal point whatever the locale. */
static void add_number(struct baseline *b, int digits, double value)
{
    char text[40];

    snprintf(text, sizeof text, "%.*g", digits, value);
    char *point = strchr(text, localeconv()->decimal_point[0]);
    if (point)
        *point = '.';
    add(b, "%s", text);
}

/* In the fewest digits that read back as the same double. */
static void add_input(struct baseline *b, double value)
{
    char text[40];
    int digits = DBL_DIG - 1;

    do
        snprintf(text, sizeof text, "%.*g", ++digits, value);
    while (strtod(text, NULL) != value && digits < DBL_DECIMAL_DIG);
    add_number(b, digits, value);
}

/* A label in quotes, cut to a reasonable length. */
static void add_name(struct baseline *b, const char *name)
{
    char shown[200];

    text_show(name, shown, sizeof shown);
    add(b, "\"");
    for (const char *p = shown; *p; p++)
        add(b, "%s%c", *p == '"' ? "\"" : "", *p);
    add(b, "\"");
}

/* ---- columns ------------------------------------------------------------- */

/* What belongs to one steady state of the slope. */
static bool is_of_state(const struct record_field *f)
{
    return f->offset >= offsetof(struct row_numbers, type) &&
           f->offset < offsetof(struct row_numbers, has_saddle);
}

/* What takes no slope. */
static bool is_of_folds(const struct record_field *f)
{
    return (row_column_products(f) & ~(1u << PRODUCT_FOLDS)) == 0;
}

/* Derivatives are differences, without a bar that would hold elsewhere; marks
 * are for those who ask for a psi. */
static bool is_recorded(const struct record_field *f)
{
    const bool is_mark = f->offset >= offsetof(struct row_numbers, v_mark) &&
                         f->offset < offsetof(struct row_numbers, folds);
    return !is_mark && !row_column_is_derivative(f);
}

static void add_header(struct baseline *b)
{
    add(b, "%sname,law,form,theta,psi_ss,timescale,kinetics", preface);
    for (int i = 0; i < MATERIAL_KEYS; i++)
        add(b, ",%s", material_key_name((enum material_key) i));
    add(b, ",alpha");
    for (size_t i = 0; i < record_row.count; i++) {
        const struct record_field *f = &record_row.fields[i];
        if (!is_recorded(f))
            continue;
        add(b, ",%s", f->name);
        if (f->kind == RECORD_QUANTITY)
            add(b, ",%s_tol", f->name);
    }
    add(b, "\n");
}

/* ---- rows ---------------------------------------------------------------- */

static void add_inputs(struct baseline *b, const char *name,
                       const struct slope_row *s)
{
    const struct law *law = &s->law[0];
    struct material m = s->material;

    add_name(b, name);
    add(b, ",%s,%s", law->preset, friction_form_names[law->form]);
    if (strcmp(law->preset, "composed") == 0)
        add(b, ",%s,%s,%s,%s", theta_names[law->theta],
            psi_ss_names[law->psi_ss], timescale_names[law->timescale],
            kinetics_names[law->kinetics]);
    else
        add(b, ",,,,");
    for (int i = 0; i < MATERIAL_KEYS; i++) {
        add(b, ",");
        if (law_uses(law, (enum material_key) i))
            add_input(b, *material_member(&m, (enum material_key) i));
    }
    add(b, ",");
    if (!isnan(s->alpha))
        add_input(b, s->alpha);
}

static void add_quantity(struct baseline *b, const struct quantity *q)
{
    if (!quantity_exists(q)) {
        add(b, ",none,");
        return;
    }
    add(b, ",");
    add_number(b, DBL_DECIMAL_DIG, q->value);
    add(b, ",");
    add_number(b, 4,
               CHECK_RECORDED_BARS * q->error + DBL_EPSILON * fabs(q->value));
}

static void add_cells(struct baseline *b, const struct row_numbers *n,
                      const struct record_field *f)
{
    const void *member = (const char *) n + f->offset;
    const int8_t *code = member;

    switch (f->kind) {
        case RECORD_CODE:
            add(b, ",%s", *code < 0 ? "none" : f->codes[*code]);
            return;
        case RECORD_COUNT:
            add(b, ",%lld", (long long) *(const int64_t *) member);
            return;
        default:
            add_quantity(b, member);
    }
}

/* Cells that belong to no such part (NULL: the whole) stay empty. */
static void add_row(struct baseline *b, const char *name,
                    const struct slope_row *s, const struct row_numbers *n,
                    bool (*is_of_part)(const struct record_field *f))
{
    if (b->rows == 0)
        add_header(b);
    add_inputs(b, name, s);
    for (size_t i = 0; i < record_row.count; i++) {
        const struct record_field *f = &record_row.fields[i];
        if (is_recorded(f) && (!is_of_part || is_of_part(f)))
            add_cells(b, n, f);
        else if (is_recorded(f))
            add(b, f->kind == RECORD_QUANTITY ? ",," : ",");
    }
    add(b, "\n");
    b->rows++;
}

/* The slip rates of the slope's other steady states. */
static enum status other_states(const struct slope_row *s, double rtol,
                                double v[EQUILIBRIA_MAX], size_t *count,
                                struct fault *why)
{
    const struct scene scene =
        slope_row_scene(s, 0, rtol, 1u << PRODUCT_EQUILIBRIA);
    struct study study;
    const enum status status = study_run(&study, &scene, NULL, why);

    *count = 0;
    if (status != STATUS_OK)
        return status;
    const int home =
        slider_saddle(&study.slider) >= 0 ? slider_saddle(&study.slider) : 0;
    for (size_t i = 0; i < study.slider.plane.equilibria; i++)
        if ((int) i != home)
            v[(*count)++] = study.slider.steady[i].v.value;
    study_free(&study);
    return STATUS_OK;
}

static enum status add_slope(struct baseline *b, const char *name,
                             const struct scene *scene, struct fault *why)
{
    const unsigned all =
        1u << PRODUCT_EQUILIBRIA | 1u << PRODUCT_KNEES | 1u << PRODUCT_FOLDS;
    struct slope_row s = slope_row_of(scene);
    struct row_numbers n;
    double v[EQUILIBRIA_MAX];
    size_t others;

    enum status status = other_states(&s, scene->rtol, v, &others, why);
    if (status == STATUS_OK)
        status = row_numbers_find(&s, 0, scene->rtol, all, &n, why);
    if (status == STATUS_OK)
        add_row(b, name, &s, &n, NULL);
    for (size_t i = 0; i < others && status == STATUS_OK; i++) {
        s.v = v[i];
        status = row_numbers_find(&s, 0, scene->rtol, 1u << PRODUCT_EQUILIBRIA,
                                  &n, why);
        if (status == STATUS_OK)
            add_row(b, name, &s, &n, is_of_state);
    }
    return status;
}

/* A scene without a slope. */
static enum status add_folds(struct baseline *b, const char *name,
                             const struct scene *scene, struct fault *why)
{
    struct slope_row s = slope_row_of(scene);
    struct row_numbers n;

    s.alpha = (double) NAN;
    const enum status status =
        row_numbers_find(&s, 0, scene->rtol, 1u << PRODUCT_FOLDS, &n, why);
    if (status == STATUS_OK)
        add_row(b, name, &s, &n, is_of_folds);
    return status;
}

enum status baseline_add(struct baseline *b, const char *name,
                         const struct scene *scene, struct fault *why)
{
    const struct baseline before = *b;
    enum status status = scene_has_slope(scene)
                             ? add_slope(b, name, scene, why)
                             : add_folds(b, name, scene, why);

    if (status == STATUS_OK && b->full) {
        status = STATUS_NO_MEMORY;
        snprintf(why->text, sizeof why->text, "%s", status_text(status));
    }
    if (status == STATUS_OK)
        return status;
    b->size = before.size;
    b->rows = before.rows;
    b->full = false;
    if (b->text)
        b->text[b->size] = '\0';
    return status;
}

void baseline_free(struct baseline *b)
{
    free(b->text);
    *b = (struct baseline){ .text = NULL };
}
