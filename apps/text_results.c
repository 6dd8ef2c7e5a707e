#include "text_results.h"

#include <math.h>
#include <string.h>

#include "number.h"
#include "result_units.h"

/* More rows than these are shown in part, unless words tell them apart; more
 * columns than these in fewer digits. */
enum { ROWS = 24, WIDE = 7 };

/* ---- lines --------------------------------------------------------------- */

/* " m"; nothing for "1". */
static void print_unit(FILE *out, const struct record_field *f)
{
    const char *unit = unit_name(NULL, f->unit);

    if (strcmp(unit, "1") != 0)
        fprintf(out, " %s", unit);
}

/* On a line of its own, in the number's unit; whose, if that is not clear. */
static void print_proof(FILE *out, const char *whose, const struct proved *p)
{
    if (p == NULL)
        return;
    fprintf(out, "  %-16s ", whose);
    if (p->not_proved)
        fprintf(out, "not proved: %s\n", p->not_proved);
    else if (p->absent)
        fputs("proved: there is none\n", out);
    else
        fprintf(out, "proved: %s .. %s\n", number_outward(p->lo, false).text,
                number_outward(p->hi, true).text);
}

/* What the scatter of the inputs makes, where there is one. */
static void print_spread(FILE *out, const struct quantity *q)
{
    if (isinf(q->spread))
        fputs("  (spread not known)", out);
    else if (!isnan(q->spread))
        fprintf(out, "  (spread %.2g)", q->spread);
}

/* "name   value +- error unit" or "name   -   reason"; what rounding of the
 * inputs costs follows where it is known. */
static void print_quantity(FILE *out, const char *name,
                           const struct record_field *f,
                           const struct quantity *q)
{
    if (!quantity_exists(q)) {
        fprintf(out, "  %-16s -  (%s)\n", name, q->reason);
        print_proof(out, "", q->proved);
        return;
    }
    const struct number_bar shown = number_with_bar(q->value, q->error);
    fprintf(out, "  %-16s %-22s +- %s", name, shown.value.text,
            shown.error.text);
    print_unit(out, f);
    if (!isnan(q->conditioning))
        fprintf(out, "  (inputs +- %.1e)", q->conditioning * fabs(q->value));
    print_spread(out, q);
    fputc('\n', out);
    print_proof(out, "", q->proved);
}

static void print_real(FILE *out, const char *name,
                       const struct record_field *f, double value)
{
    if (isnan(value))
        return;
    fprintf(out, "  %-16s %.15g", name, value);
    print_unit(out, f);
    fputc('\n', out);
}

static void print_member(FILE *out, const char *name,
                         const struct record_field *f, const void *member)
{
    const char *text = NULL;

    switch (f->kind) {
        case RECORD_QUANTITY:
            print_quantity(out, name, f, member);
            return;
        case RECORD_REAL:
            print_real(out, name, f, *(const double *) member);
            return;
        case RECORD_COUNT:
            fprintf(out, "  %-16s %lld\n", name,
                    (long long) *(const int64_t *) member);
            return;
        case RECORD_CODE:
        case RECORD_TEXT:
            text = record_word(f, member);
    }
    if (text)
        fprintf(out, "  %-16s %s\n", name, text);
}

/* By the names that a file has where it has its own. */
static void print_record(FILE *out, const struct result *r, size_t k,
                         const struct record_array *a, const char *prefix)
{
    for (size_t i = 0; i < a->type->count; i++) {
        const struct record_field *f = &a->type->fields[i];
        char name[2 * RESULT_NAME], member[RESULT_NAME];
        result_member(r, k, f, member);
        snprintf(name, sizeof name, "%s%s", r->member ? "" : prefix, member);
        print_member(out, name, f, record_member(a, 0, f));
    }
}

void text_rest(FILE *out, const struct record_array *a)
{
    for (size_t i = 1; i < a->type->count; i++) {
        const struct record_field *f = &a->type->fields[i];
        print_member(out, f->name, f, record_member(a, 0, f));
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
            if (quantity_exists(q)) {
                const struct number_bar shown =
                    number_with_bar(q->value, q->error);
                fprintf(out, "%s %s = %s +- %s", k ? "," : "", f->name,
                        shown.value.text, shown.error.text);
                print_unit(out, f);
                print_spread(out, q);
            } else if (k == 0) {
                fprintf(out, " -  (%s)", q->reason);
            }
        }
        fputc('\n', out);
        for (size_t k = 0; k < a->type->count; k++) {
            const struct record_field *f = &a->type->fields[k];
            const struct quantity *q = record_member(a, i, f);
            print_proof(out, f->name, q->proved);
        }
    }
    if (a->count == 0)
        fprintf(out, "  %-16s -  (none)\n", name);
}

/* ---- tables -------------------------------------------------------------- */

enum { CELL = 64 };

/* "name (unit)" */
static void head_text(const struct record_field *f, char text[CELL])
{
    const char *unit = unit_name(NULL, f->unit);
    const bool bare = strcmp(unit, "1") == 0;

    snprintf(text, CELL, "%s%s%s%s", f->name, bare ? "" : " (",
             bare ? "" : unit, bare ? "" : ")");
}

static void add_unit(char text[CELL], const char *unit)
{
    const size_t size = strlen(text);

    if (strcmp(unit, "1") != 0)
        snprintf(text + size, CELL - size, " %s", unit);
}

static int width_of(const struct record_type *type,
                    const struct record_field *f)
{
    char head[CELL];

    head_text(f, head);
    size_t width = strlen(head) > 13 ? strlen(head) : 13;

    for (size_t i = 0; f->kind == RECORD_CODE && f->codes[i]; i++)
        if (strlen(f->codes[i]) > width)
            width = strlen(f->codes[i]);
    if (f->units)
        width += 9;
    return f->kind == RECORD_CODE || f->kind == RECORD_REAL ||
                   type->count > WIDE || width > 22
               ? (int) width
               : 22;
}

/* As many digits as its bar leaves, or few. */
static struct number_text number_cell(const struct quantity *q, bool few)
{
    struct number_text shown = number_with_bar(q->value, q->error).value;

    if (few)
        snprintf(shown.text, sizeof shown.text, "%.7g", q->value);
    return shown;
}

static void cell_text(const struct record_field *f, const void *member,
                      bool few, char text[32])
{
    const char *word = NULL;

    strcpy(text, "-");
    switch (f->kind) {
        case RECORD_QUANTITY:
            if (quantity_exists(member))
                strcpy(text, number_cell(member, few).text);
            break;
        case RECORD_REAL:
            if (!isnan(*(const double *) member))
                snprintf(text, 32, "%.*g", few ? 7 : 10,
                         *(const double *) member);
            break;
        case RECORD_COUNT:
            if (*(const int64_t *) member != RECORD_COUNT_NONE)
                snprintf(text, 32, "%lld",
                         (long long) *(const int64_t *) member);
            break;
        case RECORD_CODE:
        case RECORD_TEXT:
            word = record_word(f, member);
    }
    if (word)
        snprintf(text, 32, "%s", word);
}

/* A line of cells, nothing behind the last; row NULL: the names, with units. */
static void print_line(FILE *out, const struct record_array *a,
                       const size_t *row)
{
    const size_t n = a->type->count;
    char text[CELL];

    fputc(' ', out);
    for (size_t k = 0; k < n; k++) {
        const struct record_field *f = &a->type->fields[k];
        if (row)
            cell_text(f, record_member(a, *row, f), n > WIDE, text);
        else
            head_text(f, text);
        if (row && f->units && strcmp(text, "-") != 0)
            add_unit(text, result_unit(a, *row, f));
        fprintf(out, " %-*s", k + 1 < n ? width_of(a->type, f) : 0, text);
    }
    fputc('\n', out);
}

/* Below a row, where any of its numbers has one. */
static void print_spreads(FILE *out, const struct record_array *a, size_t row)
{
    const size_t n = a->type->count;
    char text[CELL];
    bool asked = false;

    for (size_t k = 0; k < n; k++) {
        const struct record_field *f = &a->type->fields[k];
        const struct quantity *q = record_member(a, row, f);
        asked |= f->kind == RECORD_QUANTITY && !isnan(q->spread);
    }
    for (size_t k = 0; k < n && asked; k++) {
        const struct record_field *f = &a->type->fields[k];
        const struct quantity *q = record_member(a, row, f);
        strcpy(text, k ? "" : "(spread)");
        if (f->kind == RECORD_QUANTITY && isfinite(q->spread))
            snprintf(text, sizeof text, "%.2g", q->spread);
        fprintf(out, "%s%-*s%s", k ? " " : "  ",
                k + 1 < n ? width_of(a->type, f) : 0, text,
                k + 1 < n ? "" : "\n");
    }
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

/* What is proved of a table's numbers. */
static void print_proofs(FILE *out, const struct record_array *a)
{
    char of[CELL];

    for (size_t i = 0; i < a->count; i++)
        for (size_t k = 0; k < a->type->count; k++) {
            const struct record_field *f = &a->type->fields[k];
            const struct quantity *q = record_member(a, i, f);
            snprintf(of, sizeof of, "%s in line %zu", f->name, i + 1);
            if (f->kind == RECORD_QUANTITY)
                print_proof(out, of, q->proved);
        }
}

static void print_table(FILE *out, const struct record_array *a)
{
    const enum record_kind first = a->type->fields[0].kind;
    const bool whole = first == RECORD_CODE || first == RECORD_TEXT;
    const size_t rows = a->count < ROWS || whole ? a->count : ROWS;

    print_line(out, a, NULL);
    for (size_t i = 0; i < rows; i++) {
        const size_t at = rows > 1 ? i * (a->count - 1) / (rows - 1) : 0;
        print_line(out, a, &at);
        print_spreads(out, a, at);
    }
    if (rows < a->count)
        fprintf(out, "  (%zu of %zu)\n", rows, a->count);
    print_gaps(out, a);
    print_proofs(out, a);
}

/* "name   a b c", if there are any. */
static void print_list(FILE *out, const struct record_array *a)
{
    const struct record_field *f = a->type->fields;
    char text[32];

    if (a->count > 0)
        fprintf(out, "  %-16s", f->name);
    for (size_t i = 0; i < a->count; i++) {
        cell_text(f, record_member(a, i, f), false, text);
        fprintf(out, " %s", text);
    }
    if (a->count > 0) {
        print_unit(out, f);
        fputc('\n', out);
    }
}

static bool are_numbers(const struct record_type *type)
{
    for (size_t i = 0; i < type->count; i++)
        if (type->fields[i].kind != RECORD_QUANTITY)
            return false;
    return true;
}

/* ---- results ------------------------------------------------------------- */

static void print_columns(FILE *out, const struct record_array *a, char *prefix)
{
    if (a->type->count <= 2 && are_numbers(a->type)) {
        prefix[strlen(prefix) - 1] = '\0';
        print_pairs(out, a, prefix);
    } else if (a->type->count == 1) {
        print_list(out, a);
    } else if (a->count > 0) {
        print_table(out, a);
    } else {
        fputs("  none\n", out);
    }
}

/* Of one place with the result before it: *place, which it changes. */
static void print_view(FILE *out, const struct result *r, size_t k,
                       const struct record_array *a, const char **place)
{
    char title[RESULT_NAME], prefix[RESULT_NAME] = "";

    result_name(r->title, k, NULL, title);
    if (r->name)
        result_prefix(r, k, prefix);
    if (title[0])
        fprintf(out, "%s\n", title);
    const bool below = *place && r->name && strcmp(*place, r->name) == 0;
    *place = title[0] ? r->name : *place;
    if (r->shape == RESULT_COLUMNS)
        print_columns(out, a, prefix);
    else
        print_record(out, r, k, a, title[0] || below ? "" : prefix);
    if (r->note)
        fputs(r->note, out);
}

static enum status print_instance(FILE *out, const struct results *all,
                                  const struct result *r, size_t k,
                                  const char **place)
{
    struct result_view v;
    const enum status status = result_open(all, r, k, &v);

    if (v.here)
        print_view(out, r, k, &v.records, place);
    result_close(&v);
    return status;
}

static bool is_told(const struct result *r, const struct results *all)
{
    return r->title && result_asked(r, all);
}

/* Results with the same count belong together, instance by instance; how many
 * they are. */
static size_t block_of(const struct result *r)
{
    size_t n = 1;

    while (r->count && r[n].type && r[n].count == r->count)
        n++;
    return n;
}

static enum status print_block(FILE *out, const struct results *all,
                               const struct result *r, size_t n,
                               const char **place)
{
    const size_t instances = result_count(r, all->run);
    enum status status = STATUS_OK;

    for (size_t k = 0; k < instances; k++)
        for (size_t i = 0; i < n && status == STATUS_OK; i++)
            if (is_told(&r[i], all))
                status = print_instance(out, all, &r[i], k, place);
    return status;
}

enum status text_results(FILE *out, const struct results *all)
{
    enum status status = STATUS_OK;
    const char *place = NULL;

    for (size_t t = 0; all->table[t]; t++) {
        size_t n = 0;
        for (const struct result *r = all->table[t]; r->type && !status;
             r += n) {
            n = block_of(r);
            status = print_block(out, all, r, n, &place);
        }
    }
    return status;
}
