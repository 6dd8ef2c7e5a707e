#include "regression.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "row_inputs.h"

/* One row under one of its laws. */
struct comparison {
    const struct stated *stated;
    size_t row, law;
    double rtol;
    unsigned products;
    struct slope_row slope;
    struct row_numbers now, cost;
    bool has_cost;
    struct row_result *result;
};

static enum status add_finding(struct comparison *c, struct finding f)
{
    struct row_result *r = c->result;
    void *more = realloc(r->finding, (r->findings + 1) * sizeof f);

    if (more == NULL)
        return STATUS_NO_MEMORY;
    f.law = c->slope.law[c->law].preset;
    r->finding = more;
    r->finding[r->findings++] = f;
    return STATUS_OK;
}

/* ---- one value ----------------------------------------------------------- */

/* What the table gives no tolerance for; the costly part only where the rest
 * is not enough. */
static enum status combined_bars(struct comparison *c,
                                 const struct stated_column *column,
                                 const struct stated_value *v,
                                 double difference, double *tolerance)
{
    const struct quantity *now = row_quantity(&c->now, column->field);

    *tolerance = now->error + v->printed +
                 stated_lost(c->stated, c->row) * fabs(v->number);
    if (difference <= *tolerance)
        return STATUS_OK;
    if (!c->has_cost) {
        const enum status status = row_inputs_cost(
            &c->slope, c->law, c->rtol, c->products, &c->now, &c->cost);
        if (status != STATUS_OK)
            return status;
    }
    c->has_cost = true;
    *tolerance += row_quantity(&c->cost, column->field)->value;
    return STATUS_OK;
}

static enum status compare_number(struct comparison *c, size_t i,
                                  const struct stated_value *v)
{
    const struct stated_column *column = &c->stated->column[i];
    const struct quantity *now = row_quantity(&c->now, column->field);
    struct finding f = { .stored = v->cell,
                         .column = column->field->name,
                         .now = now->value,
                         .reason = now->reason,
                         .difference = NAN,
                         .tolerance = NAN };
    enum status status = STATUS_OK;

    if (v->said == SAID_NONE)
        return quantity_exists(now) ? add_finding(c, f) : STATUS_OK;
    if (!quantity_exists(now))
        return add_finding(c, f);
    f.difference = now->value - v->number;
    if (!stated_tolerance(c->stated, c->row, i, v->number, &f.tolerance))
        status = combined_bars(c, column, v, fabs(f.difference), &f.tolerance);
    if (status != STATUS_OK || fabs(f.difference) <= f.tolerance)
        return status;
    return add_finding(c, f);
}

static enum status compare_code(struct comparison *c,
                                const struct stated_column *column,
                                const struct stated_value *v)
{
    const struct record_field *field = column->field;
    const int8_t now = *(const int8_t *) ((char *) &c->now + field->offset);
    const int8_t stored = v->said == SAID_NONE ? -1 : v->code;

    return now == stored
               ? STATUS_OK
               : add_finding(c,
                             (struct finding){
                                 .stored = v->cell,
                                 .column = field->name,
                                 .now = NAN,
                                 .word = now < 0 ? "none" : field->codes[now],
                                 .difference = NAN,
                                 .tolerance = NAN });
}

static enum status compare_count(struct comparison *c,
                                 const struct stated_column *column,
                                 const struct stated_value *v)
{
    const double now = (double) *(
        const int64_t *) (void *) ((char *) &c->now + column->field->offset);

    return now == v->number
               ? STATUS_OK
               : add_finding(c, (struct finding){ .stored = v->cell,
                                                  .column = column->field->name,
                                                  .now = now,
                                                  .difference = now - v->number,
                                                  .tolerance = 0.0 });
}

static enum status compare_value(struct comparison *c, size_t i)
{
    const struct stated_column *column = &c->stated->column[i];
    const struct stated_value v = stated_at(c->stated, c->row, i);

    if (v.said == SAID_NOTHING)
        return STATUS_OK;
    c->result->compared++;
    if (column->field->kind == RECORD_CODE)
        return compare_code(c, column, &v);
    if (column->field->kind == RECORD_COUNT)
        return compare_count(c, column, &v);
    return compare_number(c, i, &v);
}

/* ---- one row ------------------------------------------------------------- */

static enum status compare_law(struct comparison *c, struct fault *why)
{
    enum status status =
        row_numbers_find(&c->slope, c->law, c->rtol, c->products, &c->now, why);

    if (status == STATUS_OK && stated_derives(c->stated, c->row))
        status = row_inputs_derive(&c->slope, c->law, c->rtol, &c->now);
    for (size_t i = 0; i < c->stated->columns && status == STATUS_OK; i++)
        status = compare_value(c, i);
    return status;
}

static void run_row(const struct stated *stated, size_t row, double rtol,
                    struct row_result *result)
{
    struct comparison c = { .stated = stated,
                            .row = row,
                            .rtol = rtol,
                            .products = stated_products(stated, row),
                            .result = result };
    struct fault why = { "" };

    enum status status = slope_row_read(stated->table, row, &c.slope, &why);
    for (; c.law < c.slope.laws && status == STATUS_OK; c.law++) {
        c.has_cost = false;
        status = compare_law(&c, &why);
    }
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

static enum status run_rows(struct regression *r, const struct stated *stated,
                            double rtol, const struct monitor *monitor)
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
        run_row(stated, i, rtol, &r->row[i]);
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
    struct stated stated;

    *r = (struct regression){ .table = t };
    enum status status = stated_read(&stated, t, why);
    if (status != STATUS_OK)
        return status;
    r->row = calloc(t->rows, sizeof *r->row);
    status = r->row ? run_rows(r, &stated, rtol, monitor) : STATUS_NO_MEMORY;
    stated_free(&stated);
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
