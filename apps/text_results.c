#include "text_results.h"

#include <math.h>
#include <string.h>

/* More rows than these are shown in part. */
enum { ROWS = 24 };

/* ---- lines --------------------------------------------------------------- */

/* "name   value +- error" or "name   -   reason"; what rounding of the inputs
 * costs follows where it is known. */
static void print_quantity(FILE *out, const char *name,
                           const struct quantity *q)
{
    if (!quantity_exists(q))
        fprintf(out, "  %-16s -  (%s)\n", name, q->reason);
    else
        fprintf(out, "  %-16s %-22.15g +- %.1e", name, q->value, q->error);
    if (quantity_exists(q) && !isnan(q->conditioning))
        fprintf(out, "  (inputs +- %.1e)", q->conditioning * fabs(q->value));
    if (quantity_exists(q))
        fputc('\n', out);
}

static void print_member(FILE *out, const char *name,
                         const struct record_field *f, const void *member)
{
    const char *text = NULL;

    switch (f->kind) {
        case RECORD_QUANTITY:
            print_quantity(out, name, member);
            return;
        case RECORD_REAL:
            fprintf(out, "  %-16s %.15g\n", name, *(const double *) member);
            return;
        case RECORD_COUNT:
            fprintf(out, "  %-16s %lld\n", name,
                    (long long) *(const int64_t *) member);
            return;
        case RECORD_CODE:
            if (*(const int8_t *) member >= 0)
                text = f->codes[*(const int8_t *) member];
            break;
        case RECORD_TEXT:
            text = *(const char *const *) member;
    }
    if (text)
        fprintf(out, "  %-16s %s\n", name, text);
}

static void print_record(FILE *out, const struct record_array *a,
                         const char *prefix)
{
    for (size_t i = 0; i < a->type->count; i++) {
        const struct record_field *f = &a->type->fields[i];
        char name[2 * RESULT_NAME];
        snprintf(name, sizeof name, "%s%s", prefix, f->name);
        print_member(out, name, f, record_member(a, 0, f));
    }
}

/* "name   v = value +- error, psi = value +- error" */
static void print_pairs(FILE *out, const struct record_array *a,
                        const char *name)
{
    for (size_t i = 0; i < a->count; i++) {
        fprintf(out, "  %-16s", name);
        for (size_t k = 0; k < a->type->count; k++) {
            const struct record_field *f = &a->type->fields[k];
            const struct quantity *q = record_member(a, i, f);
            if (quantity_exists(q))
                fprintf(out, "%s %s = %.12g +- %.1e", k ? "," : "", f->name,
                        q->value, q->error);
            else if (k == 0)
                fprintf(out, " -  (%s)", q->reason);
        }
        fputc('\n', out);
    }
    if (a->count == 0)
        fprintf(out, "  %-16s -  (none)\n", name);
}

/* ---- tables -------------------------------------------------------------- */

static int width_of(const struct record_field *f)
{
    return f->kind == RECORD_CODE || f->kind == RECORD_REAL ? 13 : 22;
}

/* `last` of its line: nothing behind it. */
static void print_cell(FILE *out, const struct record_field *f,
                       const void *member, bool last)
{
    char text[32] = "-";

    switch (f->kind) {
        case RECORD_QUANTITY:
            if (quantity_exists(member))
                snprintf(text, sizeof text, "%.15g",
                         ((const struct quantity *) member)->value);
            break;
        case RECORD_REAL:
            if (!isnan(*(const double *) member))
                snprintf(text, sizeof text, "%.10g", *(const double *) member);
            break;
        case RECORD_COUNT:
            snprintf(text, sizeof text, "%lld",
                     (long long) *(const int64_t *) member);
            break;
        case RECORD_CODE:
            if (*(const int8_t *) member >= 0)
                snprintf(text, sizeof text, "%s",
                         f->codes[*(const int8_t *) member]);
            break;
        case RECORD_TEXT:
            if (*(const char *const *) member)
                snprintf(text, sizeof text, "%s",
                         *(const char *const *) member);
    }
    fprintf(out, " %-*s", last ? 0 : width_of(f), text);
}

/* Why a table has gaps, once for each reason in a row. */
static void print_gaps(FILE *out, const struct record_array *a)
{
    const char *told = NULL;

    for (size_t i = 0; i < a->count; i++)
        for (size_t k = 0; k < a->type->count; k++) {
            const struct record_field *f = &a->type->fields[k];
            const struct quantity *q = record_member(a, i, f);
            if (f->kind != RECORD_QUANTITY || quantity_exists(q) ||
                q->reason == told)
                continue;
            told = q->reason;
            fprintf(out, "  - in line %zu: %s\n", i + 1, told);
        }
}

static void print_table(FILE *out, const struct record_array *a)
{
    const struct record_field *f = a->type->fields;
    const size_t rows = a->count < ROWS ? a->count : ROWS;
    const size_t n = a->type->count;

    fputc(' ', out);
    for (size_t k = 0; k < n; k++)
        fprintf(out, " %-*s", k + 1 < n ? width_of(&f[k]) : 0, f[k].name);
    fputc('\n', out);
    for (size_t i = 0; i < rows; i++) {
        const size_t at = rows > 1 ? i * (a->count - 1) / (rows - 1) : 0;
        fputc(' ', out);
        for (size_t k = 0; k < n; k++)
            print_cell(out, &f[k], record_member(a, at, &f[k]), k + 1 == n);
        fputc('\n', out);
    }
    if (rows < a->count)
        fprintf(out, "  (%zu of %zu)\n", rows, a->count);
    print_gaps(out, a);
}

/* ---- results ------------------------------------------------------------- */

static void print_view(FILE *out, const struct result *r, size_t k,
                       const struct record_array *a)
{
    char title[RESULT_NAME], prefix[RESULT_NAME];

    result_name(r->title, k, NULL, title);
    result_prefix(r, k, prefix);
    if (title[0])
        fprintf(out, "%s\n", title);
    if (r->shape != RESULT_COLUMNS) {
        print_record(out, a, title[0] ? "" : prefix);
    } else if (a->type->count > 2) {
        if (a->count > 0)
            print_table(out, a);
        else
            fputs("  none\n", out);
    } else {
        prefix[strlen(prefix) - 1] = '\0';
        print_pairs(out, a, prefix);
    }
    if (r->note)
        fputs(r->note, out);
}

static enum status print_result(FILE *out, const struct results *all,
                                const struct result *r)
{
    const size_t n = result_count(r, all->run);
    enum status status = STATUS_OK;

    for (size_t k = 0; k < n && status == STATUS_OK; k++) {
        struct result_view v;
        status = result_open(all, r, k, &v);
        if (v.here)
            print_view(out, r, k, &v.records);
        result_close(&v);
    }
    return status;
}

enum status text_results(FILE *out, const struct results *all)
{
    enum status status = STATUS_OK;

    for (size_t t = 0; all->table[t]; t++)
        for (const struct result *r = all->table[t]; r->type && !status; r++)
            if (r->name && r->title && result_asked(r, all))
                status = print_result(out, all, r);
    return status;
}
