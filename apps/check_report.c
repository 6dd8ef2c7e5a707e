#include "check_report.h"

#include <math.h>

#include "number.h"

enum { WIDE = 26 };

/* Now's value as text: a number, a word or none. */
static void show_now(const struct finding *f, char text[WIDE])
{
    if (f->word || f->reason)
        snprintf(text, WIDE, "%s", f->word ? f->word : "none");
    else
        snprintf(text, WIDE, "%s", number_shortest(f->now).text);
}

/* ---- for people ---------------------------------------------------------- */

static void print_finding(FILE *out, const struct finding *f)
{
    char stored[WIDE], now[WIDE];

    text_show(f->stored->text, stored, sizeof stored);
    show_now(f, now);
    fprintf(out, "%6lu  %-16s %-25s %-25s", (unsigned long) f->stored->line,
            f->column, stored, now);
    if (isnan(f->difference))
        fprintf(out, " %s\n", f->reason ? f->reason : "");
    else
        fprintf(out, " %11.3g %10.3g\n", f->difference, f->tolerance);
}

void check_report_print(FILE *out, const struct regression *r)
{
    char name[200];

    text_show_end(r->table->name, name, sizeof name);
    if (r->moved > 0)
        fprintf(out, "%6s  %-16s %-25s %-25s %11s %10s\n", "line", "quantity",
                "stored", "now", "difference", "tolerance");
    for (size_t i = 0; i < r->table->rows; i++) {
        const struct row_result *row = &r->row[i];
        for (size_t k = 0; k < row->findings; k++)
            print_finding(out, &row->finding[k]);
        if (row->reason)
            fprintf(out, "%6lu  failed: %s\n",
                    (unsigned long) table_at(r->table, i, 0)->line,
                    row->reason);
    }
    fprintf(out, "%s: %zu rows, %zu values: ", name, r->table->rows,
            r->compared);
    if (r->moved + r->failed == 0)
        fprintf(out, "all hold\n");
    else
        fprintf(out, "%zu moved, %zu rows failed\n", r->moved, r->failed);
}

/* ---- TAP ----------------------------------------------------------------- */

/* A text in which no harness finds a directive. */
static void put_plain(FILE *out, const char *text)
{
    for (; *text; text++)
        fprintf(out, "%s%c", *text == '#' || *text == '\\' ? "\\" : "", *text);
}

static void tap_name(FILE *out, const struct table *t, size_t row)
{
    static const char *const parts[] = { "name", "law", "form", "alpha" };
    char text[200];

    text_show_end(t->name, text, sizeof text);
    put_plain(out, text);
    fprintf(out, ":%lu", (unsigned long) table_at(t, row, 0)->line);
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        const struct table_cell *cell = table_find(t, row, parts[i]);
        if (cell == NULL)
            continue;
        text_show(cell->text, text, 64);
        fprintf(out, " ");
        put_plain(out, text);
    }
    fprintf(out, "\n");
}

static void tap_finding(FILE *out, const struct finding *f)
{
    char stored[64], now[WIDE];

    text_show(f->stored->text, stored, sizeof stored);
    show_now(f, now);
    fprintf(out, "# %s (%s): stored %s, now %s", f->column, f->law, stored,
            now);
    if (f->reason)
        fprintf(out, " (%s)", f->reason);
    if (!isnan(f->difference))
        fprintf(out, ", difference %.3g, tolerance %.3g", f->difference,
                f->tolerance);
    fprintf(out, "\n");
}

void check_report_tap(FILE *out, const struct regression *r, size_t *number)
{
    for (size_t i = 0; i < r->table->rows; i++) {
        const struct row_result *row = &r->row[i];
        const bool ok = row->findings == 0 && row->status == STATUS_OK;
        fprintf(out, "%s %zu - ", ok ? "ok" : "not ok", ++*number);
        tap_name(out, r->table, i);
        for (size_t k = 0; k < row->findings; k++)
            tap_finding(out, &row->finding[k]);
        if (row->reason)
            fprintf(out, "# failed: %s\n", row->reason);
    }
}

/* ---- JSON ---------------------------------------------------------------- */

static json_t *text_json(const char *text)
{
    char shown[256];

    text_show(text, shown, sizeof shown);
    return json_string(shown);
}

static json_t *finding_json(const struct finding *f)
{
    return json_pack("{s:I, s:I, s:s, s:s, s:o, s:o, s:s*, s:o, s:o}", "line",
                     (json_int_t) f->stored->line, "column",
                     (json_int_t) f->stored->column, "law", f->law, "quantity",
                     f->column, "stored", text_json(f->stored->text), "now",
                     f->word ? json_string(f->word) : json_number(f->now),
                     "reason", f->reason, "difference",
                     json_number(f->difference), "tolerance",
                     json_number(f->tolerance));
}

json_t *check_report_json(const struct regression *r)
{
    json_t *moved = json_array(), *failed = json_array();

    for (size_t i = 0; i < r->table->rows; i++) {
        const struct row_result *row = &r->row[i];
        for (size_t k = 0; k < row->findings; k++)
            json_array_append_new(moved, finding_json(&row->finding[k]));
        if (row->reason)
            json_array_append_new(
                failed, json_pack("{s:I, s:s}", "line",
                                  (json_int_t) table_at(r->table, i, 0)->line,
                                  "reason", row->reason));
    }
    return json_pack(
        "{s:o, s:I, s:I, s:o, s:o}", "file", text_json(r->table->name), "rows",
        (json_int_t) r->table->rows, "compared", (json_int_t) r->compared,
        "moved", moved, "failed", failed);
}
