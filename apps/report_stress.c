#include "report_stress.h"

#include <math.h>
#include <string.h>

#include "json_results.h"
#include "stress_tolerance.h"
#include "system.h"

static const char *agreement(int8_t agree)
{
    return agree < 0 ? "-" : agree == STRESS_AGREE ? "yes" : "no";
}

/* ---- for people ---------------------------------------------------------- */

static void print_digits(FILE *out, double digits)
{
    if (isnan(digits))
        fprintf(out, " %6s", "-");
    else
        fprintf(out, " %6.1f", digits);
}

static void print_row(FILE *out, const struct stress_row *row)
{
    fprintf(out, "%-62s %-8s", row->name, stress_outcome_names[row->outcome]);
    print_digits(out, row->digits);
    print_digits(out, row->allowed);
    print_digits(out, row->missing);
    if (isnan(row->bar))
        fprintf(out, " %7s", "-");
    else
        fprintf(out, " %7.2g", row->bar);
    fprintf(out, " %6lld %9.2e %10.2e %-5s %s\n", (long long) row->steps,
            row->seconds, row->oracle_seconds, agreement(row->agree),
            row->outcome != STRESS_EXACT && row->reason ? row->reason : "");
}

/* Cases that are neither exact nor said not to exist. */
static void print_rest(FILE *out, const struct stress *s)
{
    bool told = false;

    for (size_t i = 0; i < s->count; i++) {
        const struct stress_row *row = &s->row[i];
        if (row->outcome == STRESS_EXACT || row->outcome == STRESS_NONE)
            continue;
        if (!told)
            fprintf(out, "not exact, and the options that repeat it:\n");
        told = true;
        fprintf(out, "  %s: %s, %s%s%s\n    %s\n", row->name,
                stress_outcome_names[row->outcome], row->reason,
                row->worst ? ": " : "", row->worst ? row->worst : "",
                row->settings);
    }
}

/* Of all cases; 0: none has a bar that was held to 113 bits. */
static double worst_bar(const struct stress *s)
{
    double worst = 0.0;

    for (size_t i = 0; i < s->count; i++)
        worst = fmax(worst, s->row[i].bar);
    return worst;
}

void report_stress_print(FILE *out, const struct stress *s)
{
    fprintf(out, "%-62s %-8s %6s %6s %6s %7s %6s %9s %10s %-5s %s\n", "case",
            "outcome", "digits", "allow", "lack", "err/bar", "steps",
            "time (s)", "oracle (s)", "agree", "reason");
    for (size_t i = 0; i < s->count; i++)
        print_row(out, &s->row[i]);
    print_rest(out, s);
    fprintf(out, "%zu cases:", s->count);
    for (int i = 0; i < STRESS_OUTCOMES; i++)
        fprintf(out, "%s %zu %s", i > 0 ? "," : "", s->outcome[i],
                stress_outcome_names[i]);
    if (s->counted > 0)
        fprintf(out,
                "\n%zu of %zu with digits within %g of what conditioning "
                "allows (%.1f %%)\n",
                s->full, s->counted, STRESS_MISSING,
                100.0 * (double) s->full / (double) s->counted);
    else
        fprintf(out, "\nheld to 113 bits: the worst error is %.2g of its bar\n",
                worst_bar(s));
}

/* ---- JSON ---------------------------------------------------------------- */

static json_t *parameters_json(const struct scene *c)
{
    json_t *j = json_object();
    struct material m = c->material;

    for (int p = 0; c->system && p < c->system->parameters; p++)
        json_object_set_new(
            j, c->system->parameter[p].name,
            json_number((double) c->system->parameter[p].value));
    if (c->system)
        return j;
    for (int key = 0; key < MATERIAL_KEYS; key++) {
        const enum material_key which = (enum material_key) key;
        if (law_uses(&c->law, which))
            json_object_set_new(j, material_key_name(which),
                                json_number(*material_member(&m, which)));
    }
    json_object_set_new(j, "eps2", json_number(material_eps2(&m)));
    json_object_set_new(j, "alpha", json_number(c->alpha));
    json_object_set_new(j, "rtol", json_number(c->rtol));
    if (c->starts > 0) {
        json_object_set_new(j, "v", json_number(c->start[0].v));
        json_object_set_new(j, "psi", json_number(c->start[0].psi));
    }
    return j;
}

json_t *report_stress_json(const struct stress *s,
                           const struct stress_list *list)
{
    const struct results all = { .table = stress_tables, .run = s };
    json_t *j = json_results(NULL, &all), *cases = json_object_get(j, "cases");

    for (size_t i = 0; i < s->count; i++) {
        json_t *row = json_array_get(cases, i);
        json_object_set_new(row, "parameters",
                            parameters_json(&list->at[i].scene));
        json_object_set_new(
            row, "agree",
            s->row[i].agree < 0 ? json_null() : json_boolean(s->row[i].agree));
    }
    return j;
}

/* ---- TAP ----------------------------------------------------------------- */

/* A text in which no harness finds a directive. */
static void put_plain(FILE *out, const char *text)
{
    for (; *text; text++)
        fprintf(out, "%s%c", *text == '#' || *text == '\\' ? "\\" : "", *text);
}

void report_stress_tap(FILE *out, const struct stress *s)
{
    fprintf(out, "1..%zu\n", s->count);
    for (size_t i = 0; i < s->count; i++) {
        const struct stress_row *row = &s->row[i];
        fprintf(out, "%s %zu - ", row->outcome == STRESS_LIE ? "not ok" : "ok",
                i + 1);
        put_plain(out, row->name);
        fprintf(out, " %s", stress_outcome_names[row->outcome]);
        fprintf(out, "\n");
        if (row->reason)
            fprintf(out, "# %s%s%s\n", row->reason, row->worst ? ": " : "",
                    row->worst ? row->worst : "");
    }
}
