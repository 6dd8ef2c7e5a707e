#include "sweep_csv.h"

#include <stdlib.h>
#include <string.h>

#include "csv_results.h"
#include "sweep_told.h"

/* A number or word of every point. */
struct part {
    int column;
    size_t entry;
    const char *suffix; /* "", "_error", "_reason" */
};

/* Of every entry whether a point lacks it; owned by the caller, NULL without
 * memory. */
static bool *find_gaps(const struct sweep *s)
{
    bool *gaps = calloc(s->columns.entries + 1, sizeof *gaps), *to = gaps;

    for (size_t k = 0; k < s->columns.count && gaps; k++)
        for (size_t e = 0; e < s->columns.at[k].entries; e++, to++)
            for (size_t i = 0; i < s->points && !s->columns.at[k].codes; i++)
                *to |= sweep_entry_code(s, (int) k, i, e) != REASON_PRESENT;
    return gaps;
}

static void put_head(FILE *out, const struct sweep *s,
                     const struct unit_system *u, struct part p)
{
    const struct sweep_column *c = &s->columns.at[p.column];
    const bool number = !c->codes && strcmp(p.suffix, "_reason") != 0;
    char count[48] = "";

    if (c->entries > 1)
        snprintf(count, sizeof count, "_%zu", p.entry);
    fprintf(out, ",%s%s%s", sweep_told_name(s, u, p.column).text, count,
            p.suffix);
    csv_unit(out, number ? sweep_column_unit(s, u, p.column) : "1");
}

static void put_cell(FILE *out, const struct sweep *s,
                     const struct unit_system *u, struct part p, size_t i)
{
    const struct sweep_column *c = &s->columns.at[p.column];
    const int code = sweep_entry_code(s, p.column, i, p.entry);
    const struct quantity q =
        c->codes ? quantity_none("") : sweep_told(s, u, p.column, i, p.entry);

    fputc(',', out);
    if (c->codes)
        csv_text(out, code < 0 ? "" : c->codes[code]);
    else if (strcmp(p.suffix, "_reason") == 0)
        csv_text(out, quantity_exists(&q) ? "" : q.reason);
    else
        csv_real(out, *p.suffix ? q.error : q.value);
}

/* The head, or of point i what stands under it. */
static void put(FILE *out, const struct sweep *s, const struct unit_system *u,
                struct part p, bool head, size_t i)
{
    if (head)
        put_head(out, s, u, p);
    else
        put_cell(out, s, u, p, i);
}

static void put_line(FILE *out, const struct sweep *s, const bool gaps[],
                     bool head, size_t i)
{
    const struct unit_system u = sweep_answer_units(s, i);

    for (size_t k = 0; k < s->columns.count; k++) {
        const struct sweep_column *c = &s->columns.at[k];
        for (size_t e = 0; e < c->entries; e++) {
            struct part p = { (int) k, e, "" };
            put(out, s, &u, p, head, i);
            p.suffix = "_error";
            if (c->kind == RECORD_QUANTITY)
                put(out, s, &u, p, head, i);
            p.suffix = "_reason";
            if (*gaps++)
                put(out, s, &u, p, head, i);
        }
    }
    fputc('\n', out);
}

enum status sweep_csv(FILE *out, const struct sweep *s)
{
    bool *gaps = find_gaps(s);

    if (gaps == NULL)
        return STATUS_NO_MEMORY;
    for (size_t k = 0; k < s->axes; k++) {
        fprintf(out, "%s%s", k ? "," : "", s->axis[k].name);
        csv_unit(out, sweep_told_unit(s, s->axis[k].key.unit));
    }
    put_line(out, s, gaps, true, 0);
    for (size_t i = 0; i < s->points; i++) {
        for (size_t k = 0; k < s->axes; k++) {
            fputs(k ? "," : "", out);
            csv_real(out, sweep_rows_x(&s->rows, i)[k]);
        }
        put_line(out, s, gaps, false, i);
    }
    free(gaps);
    return STATUS_OK;
}
