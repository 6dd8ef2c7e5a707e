#include "csv_results.h"

#include <math.h>
#include <string.h>

#include "number.h"
#include "unit.h"

/* RFC 4180: in quotes where it must be. */
void csv_text(FILE *out, const char *text)
{
    const bool plain = text[strcspn(text, ",\"\n\r")] == '\0';

    if (plain) {
        fputs(text, out);
        return;
    }
    fputc('"', out);
    for (; *text; text++)
        fprintf(out, *text == '"' ? "\"%c" : "%c", *text);
    fputc('"', out);
}

void csv_real(FILE *out, double x)
{
    if (isfinite(x))
        fputs(number_shortest(x).text, out);
}

void csv_unit(FILE *out, const char *unit)
{
    if (strcmp(unit, "1") != 0)
        fprintf(out, " [%s]", unit);
}

static bool has_gaps(const struct record_array *a, const struct record_field *f)
{
    for (size_t i = 0; i < a->count; i++)
        if (!quantity_exists(record_member(a, i, f)))
            return true;
    return false;
}

static void put_head(FILE *out, const char *suffix,
                     const struct record_field *f)
{
    fprintf(out, "%s%s", f->name, suffix);
    csv_unit(out, unit_name(NULL, f->unit));
}

/* The name of a field's columns, or row i of them. */
static void put_heads(FILE *out, const struct record_array *a,
                      const struct record_field *f)
{
    put_head(out, "", f);
    if (f->kind != RECORD_QUANTITY)
        return;
    fputc(',', out);
    put_head(out, "_error", f);
    if (has_gaps(a, f))
        fprintf(out, ",%s_reason", f->name);
}

static void put_quantity(FILE *out, const struct quantity *q, bool gaps)
{
    csv_real(out, q->value);
    fputc(',', out);
    csv_real(out, q->error);
    if (gaps)
        fputc(',', out);
    if (gaps && !quantity_exists(q))
        csv_text(out, q->reason);
}

static void put_cells(FILE *out, const struct record_array *a, size_t i,
                      const struct record_field *f)
{
    const void *member = record_member(a, i, f);
    const char *word = NULL;

    switch (f->kind) {
        case RECORD_QUANTITY:
            put_quantity(out, member, has_gaps(a, f));
            return;
        case RECORD_REAL:
            csv_real(out, *(const double *) member);
            return;
        case RECORD_COUNT:
            if (*(const int64_t *) member != RECORD_COUNT_NONE)
                fprintf(out, "%lld", (long long) *(const int64_t *) member);
            return;
        case RECORD_CODE:
        case RECORD_TEXT:
            word = record_word(f, member);
    }
    csv_text(out, word ? word : "");
}

void csv_results(FILE *out, const struct record_array *a)
{
    for (size_t k = 0; k < a->type->count; k++) {
        fputs(k ? "," : "", out);
        put_heads(out, a, &a->type->fields[k]);
    }
    fputc('\n', out);
    for (size_t i = 0; i < a->count; i++) {
        for (size_t k = 0; k < a->type->count; k++) {
            fputs(k ? "," : "", out);
            put_cells(out, a, i, &a->type->fields[k]);
        }
        fputc('\n', out);
    }
}
