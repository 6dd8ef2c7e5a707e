#include "baseline.h"

#include <float.h>
#include <locale.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene_slope.h"
#include "slope_row.h"
#include "study_results.h"
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

static void add_header(struct baseline *b, const struct result_numbers *n)
{
    add(b, "%sname,law,form,theta,psi_ss,timescale,kinetics", preface);
    for (int i = 0; i < MATERIAL_KEYS; i++)
        add(b, ",%s", material_key_name((enum material_key) i));
    add(b, ",alpha");
    for (size_t i = 0; i < n->count; i++) {
        add(b, ",%s", n->at[i].name);
        if (n->at[i].field->kind == RECORD_QUANTITY)
            add(b, ",%s_tol", n->at[i].name);
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

/* Of a number that the study was not asked for the cells stay empty. */
static void add_cells(struct baseline *b, const struct results *all,
                      const struct result_number *n)
{
    const bool is_code = n->field->kind == RECORD_CODE;

    if (!result_asked(n->of, all)) {
        add(b, is_code ? "," : ",,");
    } else if (is_code) {
        const int8_t code = result_code(all, n);
        add(b, ",%s", code < 0 ? "none" : n->field->codes[code]);
    } else {
        const struct quantity q = result_quantity(all, n);
        add_quantity(b, &q);
    }
}

static void add_row(struct baseline *b, const char *name,
                    const struct slope_row *slope, const struct study *s,
                    const struct result_numbers *n)
{
    const struct results all = study_results(s);

    if (b->rows == 0)
        add_header(b, n);
    add_inputs(b, name, slope);
    for (size_t i = 0; i < n->count; i++)
        add_cells(b, &all, &n->at[i]);
    add(b, "\n");
    b->rows++;
}

static enum status add_scene(struct baseline *b, const char *name,
                             const struct scene *scene, struct fault *why)
{
    const unsigned all = plan_products((unsigned) STUDY_NUMBERS);
    const struct slope_row slope = slope_row_of(scene);
    const struct scene plain =
        slope_row_scene(&slope, 0, scene->rtol,
                        scene_has_slope(scene) ? all : all & scene_slopeless);
    struct result_numbers n;
    struct study s;

    enum status status = study_numbers(&n, STUDY_NUMBERS);
    if (status != STATUS_OK)
        return status;
    status = study_run(&s, &plain, NULL, why);
    if (status == STATUS_OK) {
        add_row(b, name, &slope, &s, &n);
        study_free(&s);
    }
    result_numbers_free(&n);
    return status == STATUS_OK && b->full ? STATUS_NO_MEMORY : status;
}

enum status baseline_add(struct baseline *b, const char *name,
                         const struct scene *scene, struct fault *why)
{
    const struct baseline before = *b;
    const enum status status = add_scene(b, name, scene, why);

    if (status == STATUS_OK)
        return STATUS_OK;
    if (status == STATUS_NO_MEMORY)
        snprintf(why->text, sizeof why->text, "%s", status_text(status));
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
