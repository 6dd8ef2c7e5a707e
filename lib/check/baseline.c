#include "baseline.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "plane_numbers.h"
#include "plane_results.h"
#include "scene_slope.h"
#include "slope_law.h"
#include "slope_row.h"
#include "study_results.h"
#include "tolerance.h"

static const char preface[] =
    "# Recorded by slipway check --record.  NAME_tol is the tolerance of NAME, "
    "absolute.\n";

/* ---- cells --------------------------------------------------------------- */

static void add_number(FILE *out, double value)
{
    fputs(number_shortest(value).text, out);
}

/* A label in quotes, cut to a reasonable length. */
static void add_name(FILE *out, const char *name)
{
    char shown[200];

    text_show(name, shown, sizeof shown);
    fprintf(out, "\"");
    for (const char *p = shown; *p; p++)
        fprintf(out, "%s%c", *p == '"' ? "\"" : "", *p);
    fprintf(out, "\"");
}

/* ---- columns ------------------------------------------------------------- */

static void add_title(FILE *out, const struct result_number *n)
{
    fprintf(out, ",%s", n->name);
    if (n->field->kind == RECORD_QUANTITY)
        fprintf(out, ",%s_tol", n->name);
}

static void add_header(FILE *out, const struct result_numbers *n)
{
    fprintf(out, "%sname,law,form,theta,psi_ss,timescale,kinetics", preface);
    for (int i = 0; i < MATERIAL_KEYS; i++)
        fprintf(out, ",%s", material_key_name((enum material_key) i));
    fputs(",alpha", out);
    for (size_t i = 0; i < n->count; i++)
        add_title(out, &n->at[i]);
    fputs("\n", out);
}

/* ---- rows ---------------------------------------------------------------- */

static void add_inputs(FILE *out, const char *name, const struct slope_row *s)
{
    const struct law *law = &s->law[0];
    struct material m = s->material;

    add_name(out, name);
    fputs(law->typed ? ",\"" : ",", out);
    if (law->typed)
        slope_law_write(out, law->typed, &m);
    else
        fputs(law->preset, out);
    fprintf(out, "%s,%s", law->typed ? "\"" : "",
            friction_form_names[law->form]);
    if (strcmp(law->preset, "composed") == 0)
        fprintf(out, ",%s,%s,%s,%s", theta_names[law->theta],
                psi_ss_names[law->psi_ss], timescale_names[law->timescale],
                kinetics_names[law->kinetics]);
    else
        fputs(",,,,", out);
    for (int i = 0; i < MATERIAL_KEYS; i++) {
        fputs(",", out);
        if (law_uses(law, (enum material_key) i))
            add_number(out, *material_member(&m, (enum material_key) i));
    }
    fputs(",", out);
    if (!isnan(s->alpha))
        add_number(out, s->alpha);
}

static void add_quantity(FILE *out, const struct quantity *q)
{
    if (!quantity_exists(q)) {
        fputs(",none,", out);
        return;
    }
    fputs(",", out);
    add_number(out, q->value);
    fputs(",", out);
    add_number(out,
               CHECK_RECORDED_BARS * q->error + DBL_EPSILON * fabs(q->value));
}

/* Of a number that the study was not asked for the cells stay empty. */
static void add_cells(FILE *out, const struct results *all,
                      const struct result_number *n)
{
    const bool is_code = n->field->kind == RECORD_CODE;

    if (!result_asked(n->of, all)) {
        fputs(is_code ? "," : ",,", out);
    } else if (is_code) {
        const int8_t code = result_code(all, n);
        fprintf(out, ",%s", code < 0 ? "none" : n->field->codes[code]);
    } else if (n->field->kind == RECORD_COUNT) {
        fprintf(out, ",%.0f", result_quantity(all, n).value);
    } else {
        const struct quantity q = result_quantity(all, n);
        add_quantity(out, &q);
    }
}

/* Below a header in an empty table. */
static void add_row(struct baseline *b, const char *name,
                    const struct slope_row *slope, const struct study *s,
                    const struct result_numbers *n)
{
    const struct results all = study_results(s);

    if (b->rows++ == 0)
        add_header(b->out, n);
    add_inputs(b->out, name, slope);
    for (size_t i = 0; i < n->count; i++)
        add_cells(b->out, &all, &n->at[i]);
    fputs("\n", b->out);
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

    if (b->out == NULL)
        b->out = open_memstream(&b->text, &b->size);
    enum status status =
        b->out ? study_numbers(&n, STUDY_NUMBERS) : STATUS_NO_MEMORY;
    if (status != STATUS_OK)
        return status;
    status = study_run(&s, &plain, NULL, why);
    if (status == STATUS_OK) {
        add_row(b, name, &slope, &s, &n);
        study_free(&s);
    }
    result_numbers_free(&n);
    if (status == STATUS_OK && (fflush(b->out) != 0 || ferror(b->out)))
        status = STATUS_NO_MEMORY;
    return status;
}

/* ---- systems ------------------------------------------------------------- */

static void add_quoted(FILE *out, const char *text, size_t size)
{
    fputs(",\"", out);
    for (size_t i = 0; i < size; i++)
        fprintf(out, "%s%c", text[i] == '"' ? "\"" : "", text[i]);
    fputs("\"", out);
}

/* Whether the number exists, of a study that was asked for it. */
static bool is_there(const struct results *all, const struct result_number *n)
{
    const struct quantity q = result_quantity(all, n);

    return result_asked(n->of, all) &&
           (n->field->kind == RECORD_CODE ? result_code(all, n) >= 0
                                          : quantity_exists(&q));
}

/* A table of its numbers, those that there are. */
static void add_plane(struct baseline *b, const char *name,
                      const struct plane_study *s,
                      const struct result_numbers *n)
{
    const struct results all = plane_results(s);
    const struct scene *c = s->scene;
    const size_t lines = strlen(c->overrides);

    fprintf(b->out, "%sname,scene,set", preface);
    for (size_t i = 0; i < n->count; i++)
        if (is_there(&all, &n->at[i]))
            add_title(b->out, &n->at[i]);
    fputs("\n", b->out);
    add_name(b->out, name);
    add_quoted(b->out, c->file ? c->file : "", c->file ? strlen(c->file) : 0);
    add_quoted(b->out, c->overrides, lines > 0 ? lines - 1 : 0);
    for (size_t i = 0; i < n->count; i++)
        if (is_there(&all, &n->at[i]))
            add_cells(b->out, &all, &n->at[i]);
    fputs("\n", b->out);
    b->rows++;
    b->of_system = true;
}

static enum status add_system(struct baseline *b, const char *name,
                              const struct scene *scene, struct fault *why)
{
    struct scene plain = *scene; /* borrows */
    struct plane_study frame, s;
    struct result_numbers n = { .at = NULL };

    plain.products |= 1u << PRODUCT_EQUILIBRIA | 1u << PRODUCT_MANIFOLDS;
    b->out = open_memstream(&b->text, &b->size);
    if (b->out == NULL)
        return STATUS_NO_MEMORY;
    enum status status = plane_study_run(&s, &plain, NULL, why);
    if (status != STATUS_OK)
        return status;
    status = plane_numbers_frame(&frame, &plain);
    if (status == STATUS_OK)
        status = plane_numbers(&n, &frame);
    if (status == STATUS_OK)
        add_plane(b, name, &s, &n);
    if (status == STATUS_OK && (fflush(b->out) != 0 || ferror(b->out)))
        status = STATUS_NO_MEMORY;
    result_numbers_free(&n);
    plane_numbers_free(&frame);
    plane_study_free(&s);
    return status;
}

enum status baseline_add(struct baseline *b, const char *name,
                         const struct scene *scene, struct fault *why)
{
    if (b->of_system || (scene->system && b->rows > 0))
        return fault_set(why, STATUS_BAD_SCENE,
                         "%.300s: a table holds laws, or one system alone",
                         name);
    const enum status status = scene->system ? add_system(b, name, scene, why)
                                             : add_scene(b, name, scene, why);

    return status == STATUS_NO_MEMORY
               ? fault_set(why, status, "%s", status_text(status))
               : status;
}

void baseline_free(struct baseline *b)
{
    if (b->out)
        fclose(b->out);
    free(b->text);
    *b = (struct baseline){ .text = NULL };
}
