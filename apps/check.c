/* slipway check: do the numbers of a table still hold?  And --record, which
 * writes such a table. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "baseline.h"
#include "command.h"
#include "json.h"
#include "number.h"
#include "output.h"
#include "progress.h"
#include "regression.h"
#include "replace.h"
#include "scene_scatter.h"
#include "tolerance.h"

/* ---- report -------------------------------------------------------------- */

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

/* What moved, one line a value, and one line of summary for the table. */
static void check_report_print(FILE *out, const struct regression *r)
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

static void tap_name(FILE *out, const struct table *t, size_t row)
{
    static const char *const parts[] = { "name", "law", "form", "alpha" };
    char text[200];

    text_show_end(t->name, text, sizeof text);
    command_plain(out, text);
    fprintf(out, ":%lu", (unsigned long) table_at(t, row, 0)->line);
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        const struct table_cell *cell = table_find(t, row, parts[i]);
        if (cell == NULL)
            continue;
        text_show(cell->text, text, 64);
        fprintf(out, " ");
        command_plain(out, text);
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

/* One test point a row, numbered from *number on, which moves behind them. */
static void check_report_tap(FILE *out, const struct regression *r,
                             size_t *number)
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

/* {file, rows, compared, moved[], failed[]}. */
static json_t *check_report_json(const struct regression *r)
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

/* ---- checking ------------------------------------------------------------ */

/* All tables of the command line, and what became of them. */
struct checks {
    struct table *table;           /* owned */
    struct regression *regression; /* owned */
    size_t count;
};

/* A table brings its own slopes: only --rtol may be set. */
static enum status read_rtol(const struct options *o, double *rtol,
                             struct fault *why)
{
    static const char key[] = "accuracy.rtol=";

    *rtol = CHECK_RTOL;
    if (o->output)
        return command_refuse(why, "check: -o %s: only --record writes a file",
                              o->output);
    for (size_t i = 0; i < o->sets; i++) {
        const char *value = o->set[i] + sizeof key - 1;
        if (strncmp(o->set[i], key, sizeof key - 1) != 0)
            return command_refuse(
                why,
                "check: %s: a table brings its own slopes (to write "
                "one: --record)",
                o->set[i]);
        if (!number_read(value, rtol) || !(*rtol >= 1e-14 && *rtol <= 0.1))
            return command_refuse(
                why,
                "check: --rtol %s: expected a number from 1e-14 to "
                "0.1",
                value);
    }
    return STATUS_OK;
}

static enum status read_tables(const struct options *o, struct checks *c,
                               struct fault *why)
{
    if (o->files == 0)
        return command_refuse(why, "check: no table, expected %s", "TABLE.csv");
    if (o->tap && o->json)
        return command_refuse(why, "check: --tap: expected it without %s",
                              "--json");
    c->table = calloc(o->files, sizeof *c->table);
    c->regression = calloc(o->files, sizeof *c->regression);
    if (c->table == NULL || c->regression == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < o->files; i++) {
        const enum status s = table_read(&c->table[i], o->file[i], why);
        if (s != STATUS_OK)
            return s;
        c->count++;
    }
    return STATUS_OK;
}

static enum status run_tables(const struct options *o, double rtol,
                              struct checks *c, struct fault *why)
{
    const struct monitor *monitor = progress_monitor(o);
    enum status s = STATUS_OK;

    for (size_t i = 0; i < c->count && s == STATUS_OK; i++)
        s = regression_run(&c->regression[i], &c->table[i], rtol, monitor, why);
    progress_end();
    return s;
}

static void free_checks(struct checks *c)
{
    for (size_t i = 0; i < c->count; i++) {
        regression_free(&c->regression[i]);
        table_free(&c->table[i]);
    }
    free(c->table);
    free(c->regression);
}

static bool print_json(const struct checks *c)
{
    json_t *list = json_array();

    for (size_t i = 0; i < c->count; i++)
        json_array_append_new(list, check_report_json(&c->regression[i]));
    return json_print(json_pack("{s:o}", "tables", list));
}

static bool print_tap(const struct checks *c)
{
    size_t rows = 0, number = 0;

    for (size_t i = 0; i < c->count; i++)
        rows += c->table[i].rows;
    printf("1..%zu\n", rows);
    for (size_t i = 0; i < c->count; i++)
        check_report_tap(stdout, &c->regression[i], &number);
    return fflush(stdout) == 0;
}

static bool print_checks(const struct options *o, const struct checks *c)
{
    if (o->json)
        return print_json(c);
    if (o->tap)
        return print_tap(c);
    for (size_t i = 0; i < c->count && !o->quiet; i++)
        check_report_print(stdout, &c->regression[i]);
    return fflush(stdout) == 0;
}

static enum exit_code verdict(const struct checks *c)
{
    size_t moved = 0, failed = 0;

    for (size_t i = 0; i < c->count; i++) {
        moved += c->regression[i].moved;
        failed += c->regression[i].failed;
    }
    return failed ? EXIT_NUMBER : moved ? EXIT_CHECK : EXIT_DONE;
}

static enum exit_code check(const struct options *o)
{
    struct checks c = { .count = 0 };
    struct fault why = { "" };
    double rtol;

    enum status s = read_rtol(o, &rtol, &why);
    if (s == STATUS_OK)
        s = read_tables(o, &c, &why);
    if (s == STATUS_OK)
        s = run_tables(o, rtol, &c, &why);
    enum exit_code code = s == STATUS_OK ? verdict(&c) : EXIT_DONE;
    if (s != STATUS_OK)
        code = command_fail(s, why.text);
    else if (!print_checks(o, &c))
        code = command_unwritten();
    free_checks(&c);
    return code;
}

/* ---- recording ----------------------------------------------------------- */

static enum status record_scene(const struct options *o, const char *path,
                                struct baseline *b, struct fault *why)
{
    struct scene scene;

    enum status s = scene_read(&scene, path, o->set, o->sets, why);
    if (s != STATUS_OK)
        return s;
    s = scene_scatter_refuse(&scene, "check", why);
    if (s == STATUS_OK)
        s = baseline_add(b, scene_name(&scene), &scene, why);
    scene_free(&scene);
    return s;
}

static enum status record_scenes(const struct options *o, struct baseline *b,
                                 struct fault *why)
{
    const struct monitor *monitor = progress_monitor(o);
    const size_t count = o->files ? o->files : 1;
    enum status s = STATUS_OK;

    if (o->tap || o->json)
        return command_refuse(why, "check: --%s: --record writes CSV",
                              o->tap ? "tap" : "json");
    if (output_path(o))
        s = output_path_check(o, NULL, o->output, why);
    for (size_t i = 0; i < count && s == STATUS_OK; i++) {
        if (monitor_tell(monitor, "scenes", i, count))
            s = STATUS_STOPPED;
        else
            s = record_scene(o, o->files ? o->file[i] : NULL, b, why);
    }
    progress_end();
    return s;
}

static enum status write_baseline(const struct options *o,
                                  const struct baseline *b, struct fault *why)
{
    const char *file = output_path(o);
    enum status s = STATUS_OK;

    if (file)
        s = replace_file(file, b->text, b->size, why);
    if (s != STATUS_OK)
        return s;
    if (file && !o->quiet)
        printf("wrote %s: %zu rows\n", file, b->rows);
    if (file == NULL)
        fputs(b->text, stdout);
    if (fflush(stdout) == 0 && !ferror(stdout))
        return STATUS_OK;
    return fault_set(why, STATUS_IO, "cannot write to standard output");
}

static enum exit_code record(const struct options *o)
{
    struct baseline b = { .text = NULL };
    struct fault why = { "" };

    enum status s = record_scenes(o, &b, &why);
    if (s == STATUS_OK)
        s = write_baseline(o, &b, &why);
    baseline_free(&b);
    return s == STATUS_OK ? EXIT_DONE : command_fail(s, why.text);
}

enum exit_code command_check(const struct options *o)
{
    return o->record ? record(o) : check(o);
}
