#include "regression.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "conditioning.h"
#include "plane_results.h"
#include "plane_row.h"
#include "tolerance.h"

/* One row under one of its laws. */
struct comparison {
    const struct expected *expected;
    size_t row, law;
    double rtol;
    unsigned products;
    struct slope_row slope;
    struct scene scene;
    struct study study;       /* of the scene */
    struct plane_study plane; /* the same of a system */
    bool has_cost; /* its numbers know what rounding the inputs costs */
    struct row_result *result;
};

static enum status add_finding(struct comparison *c, struct finding f)
{
    struct row_result *r = c->result;
    void *more = realloc(r->finding, (r->findings + 1) * sizeof f);

    if (more == NULL)
        return STATUS_NO_MEMORY;
    f.law = c->expected->of_systems ? "system" : c->slope.law[c->law].preset;
    r->finding = more;
    r->finding[r->findings++] = f;
    return STATUS_OK;
}

/* ---- one value ----------------------------------------------------------- */

static const char *name_of(const struct comparison *c, size_t i)
{
    return table_header(c->expected->table, c->expected->column[i].at)->text;
}

static struct results results_of(const struct comparison *c)
{
    return c->expected->of_systems ? plane_results(&c->plane)
                                   : study_results(&c->study);
}

static struct quantity now_of(struct comparison *c,
                              const struct expected_column *column)
{
    const struct results all = results_of(c);

    return result_quantity(&all, column->number);
}

/* What rounding the row's inputs to doubles costs a number. */
static enum status cost_of(struct comparison *c,
                           const struct expected_column *column, double *cost)
{
    enum status status = STATUS_OK;

    if (!c->has_cost && !c->expected->of_systems) {
        struct sensitivities none = sensitivity_none("nobody asked");
        size_t evaluations = 0;
        status = conditioning_find(&c->study, NULL, &none, &evaluations);
    }
    c->has_cost = true;
    const struct quantity now = now_of(c, column);
    *cost = isnan(now.conditioning)
                ? 0.0
                : CHECK_MARGIN * now.conditioning * fabs(now.value);
    return status;
}

/* Where the table gives no tolerance; the costly part only where the rest is
 * not enough. */
static enum status combined_bars(struct comparison *c,
                                 const struct expected_column *column,
                                 const struct expected_value *v,
                                 double difference, double *tolerance)
{
    double cost = 0.0;
    enum status status = STATUS_OK;

    *tolerance = now_of(c, column).error + v->printed +
                 expected_lost(c->expected, c->row) * fabs(v->number);
    if (difference > *tolerance)
        status = cost_of(c, column, &cost);
    *tolerance += cost;
    return status;
}

static enum status compare_number(struct comparison *c, size_t i,
                                  const struct expected_value *v)
{
    const struct expected_column *column = &c->expected->column[i];
    const struct quantity now = now_of(c, column);
    struct finding f = { .stored = v->cell,
                         .column = name_of(c, i),
                         .now = now.value,
                         .reason = now.reason,
                         .difference = NAN,
                         .tolerance = NAN };
    enum status status = STATUS_OK;

    if (v->kind == EXPECTED_NONE)
        return quantity_exists(&now) ? add_finding(c, f) : STATUS_OK;
    if (!quantity_exists(&now))
        return add_finding(c, f);
    f.difference = now.value - v->number;
    if (!expected_tolerance(c->expected, c->row, i, v->number, &f.tolerance))
        status = combined_bars(c, column, v, fabs(f.difference), &f.tolerance);
    if (status != STATUS_OK || fabs(f.difference) <= f.tolerance)
        return status;
    return add_finding(c, f);
}

static enum status compare_code(struct comparison *c, size_t i,
                                const struct expected_value *v)
{
    const struct result_number *number = c->expected->column[i].number;
    const struct results all = results_of(c);
    const int8_t now = result_code(&all, number);
    const struct finding f = {
        .stored = v->cell,
        .column = name_of(c, i),
        .now = NAN,
        .word = now < 0 ? "none" : number->field->codes[now],
        .difference = NAN,
        .tolerance = NAN,
    };

    return now == (v->kind == EXPECTED_NONE ? -1 : v->code) ? STATUS_OK
                                                            : add_finding(c, f);
}

static enum status compare_value(struct comparison *c, size_t i)
{
    const struct expected_value v = expected_at(c->expected, c->row, i);

    if (v.kind == EXPECTED_NOTHING)
        return STATUS_OK;
    c->result->compared++;
    return c->expected->column[i].number->field->kind == RECORD_CODE
               ? compare_code(c, i, &v)
               : compare_number(c, i, &v);
}

/* ---- one row ------------------------------------------------------------- */

static enum status compare_values(struct comparison *c)
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < c->expected->columns && status == STATUS_OK; i++)
        status = compare_value(c, i);
    return status;
}

/* Decimals of a system are taken as typed: rounding them costs nothing. */
static enum status compare_system(struct comparison *c, struct fault *why)
{
    enum status status =
        plane_row_read(c->expected->table, c->row, c->products, &c->scene, why);
    if (status != STATUS_OK)
        return status;
    status = plane_study_run(&c->plane, &c->scene, NULL, why);
    if (status == STATUS_OK)
        status = compare_values(c);
    plane_study_free(&c->plane);
    scene_free(&c->scene);
    return status;
}

static enum status compare_law(struct comparison *c, struct fault *why)
{
    c->scene = slope_row_scene(&c->slope, c->law, c->rtol, c->products);
    enum status status = study_run(&c->study, &c->scene, NULL, why);
    if (status != STATUS_OK)
        return status;
    c->has_cost = plan_has(c->study.stages, STAGE_SENSITIVITIES);
    status = compare_values(c);
    study_free(&c->study);
    return status;
}

static void run_row(const struct expected *expected, size_t row, double rtol,
                    struct row_result *result)
{
    struct comparison c = { .expected = expected,
                            .row = row,
                            .rtol = rtol,
                            .products = expected_products(expected, row),
                            .result = result };
    struct fault why = { "" };

    enum status status =
        expected->of_systems
            ? compare_system(&c, &why)
            : slope_row_read(expected->table, row, &c.slope, &why);
    for (; c.law < c.slope.laws && status == STATUS_OK; c.law++)
        status = compare_law(&c, &why);
    slope_row_free(&c.slope);
    result->status = status;
    if (status == STATUS_OK || status == STATUS_NO_MEMORY)
        return;
    result->reason = text_copy(why.text, strlen(why.text));
    if (result->reason == NULL)
        result->status = STATUS_NO_MEMORY;
}

/* ---- the table ----------------------------------------------------------- */

/* Adds up; STATUS_NO_MEMORY if a row ran out of it. */
static enum status sum_up(struct regression *r)
{
    for (size_t i = 0; i < r->table->rows; i++) {
        const struct row_result *row = &r->row[i];
        if (row->status == STATUS_NO_MEMORY)
            return STATUS_NO_MEMORY;
        r->compared += row->compared;
        r->moved += row->findings;
        r->failed += row->status != STATUS_OK;
    }
    return STATUS_OK;
}

static enum status run_rows(struct regression *r,
                            const struct expected *expected, double rtol,
                            const struct monitor *monitor)
{
    const size_t rows = r->table->rows;
    size_t done = 0;
    bool stop = false;

#pragma omp parallel for schedule(dynamic, 1)
    for (size_t i = 0; i < rows; i++) {
        bool stopped;
#pragma omp atomic read
        stopped = stop;
        if (stopped)
            continue;
        run_row(expected, i, rtol, &r->row[i]);
#pragma omp critical
        if (monitor_tell(monitor, "rows", ++done, rows)) {
#pragma omp atomic write
            stop = true;
        }
    }
    return stop ? STATUS_STOPPED : sum_up(r);
}

enum status regression_run(struct regression *r, const struct table *t,
                           double rtol, const struct monitor *monitor,
                           struct fault *why)
{
    struct expected expected;

    *r = (struct regression){ .table = t };
    enum status status = expected_read(&expected, t, why);
    if (status != STATUS_OK)
        return status;
    r->row = calloc(t->rows, sizeof *r->row);
    status = r->row ? run_rows(r, &expected, rtol, monitor) : STATUS_NO_MEMORY;
    expected_free(&expected);
    if (status == STATUS_OK)
        return STATUS_OK;
    snprintf(why->text, sizeof why->text, "%s", status_text(status));
    regression_free(r);
    return status;
}

void regression_free(struct regression *r)
{
    for (size_t i = 0; r->row && i < r->table->rows; i++) {
        free(r->row[i].finding);
        free(r->row[i].reason);
    }
    free(r->row);
    *r = (struct regression){ .table = r->table };
}
