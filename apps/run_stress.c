/* slipway stress: the catalogue of stiff and extreme cases, held to 113 bits;
 * a user's scene is one more case. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "command.h"
#include "json.h"
#include "json_results.h"
#include "output.h"
#include "progress.h"
#include "result_file.h"
#include "stress_plane.h"
#include "stress_run.h"
#include "stress_tolerance.h"
#include "system.h"

/* ---- report -------------------------------------------------------------- */

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

/* One line a case, how many came to what, and those that are not exact once
 * more with their causes and the options that repeat them. */
static void report_stress_print(FILE *out, const struct stress *s)
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

/* The object of `stress --json`; `list` as it was run. */
static json_t *report_stress_json(const struct stress *s,
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

/* One test a case: only a lie is not ok. */
static void report_stress_tap(FILE *out, const struct stress *s)
{
    fprintf(out, "1..%zu\n", s->count);
    for (size_t i = 0; i < s->count; i++) {
        const struct stress_row *row = &s->row[i];
        fprintf(out, "%s %zu - ", row->outcome == STRESS_LIE ? "not ok" : "ok",
                i + 1);
        command_plain(out, row->name);
        fprintf(out, " %s", stress_outcome_names[row->outcome]);
        fprintf(out, "\n");
        if (row->reason)
            fprintf(out, "# %s%s%s\n", row->reason, row->worst ? ": " : "",
                    row->worst ? row->worst : "");
    }
}

static bool begins(const char *text, const char *with)
{
    return strncmp(text, with, strlen(with)) == 0;
}

/* Whether a scene is given, as a file or by options. */
static bool has_scene(const struct options *o)
{
    bool given = o->files > 0;

    for (size_t i = 0; i < o->sets; i++)
        given = given || begins(o->set[i], "law.") ||
                begins(o->set[i], "slope.") || begins(o->set[i], "system.");
    return given;
}

/* What means something here: the catalogue brings its own scenes. */
static enum status check_options(const struct options *o, struct fault *why)
{
    if (o->tap && o->json)
        return command_refuse(why, "stress: --tap: expected it without %s",
                              "--json");
    for (size_t i = 0; i < o->sets; i++) {
        if (begins(o->set[i], "output.figure="))
            return command_refuse(why, "stress: %s: stress draws no figure",
                                  o->set[i]);
        if (!has_scene(o) && !begins(o->set[i], "output.hdf5="))
            return command_refuse(
                why,
                "stress: %s: the cases bring their own settings (to "
                "add one: a scene, or --law and --alpha)",
                o->set[i]);
    }
    return STATUS_OK;
}

/* The scene's file and the options that change it. */
static void describe(const struct options *o, char *text, size_t size)
{
    size_t n = (size_t) snprintf(text, size, "%s", o->files ? o->file[0] : "");

    for (size_t i = 0; i < o->sets && n < size; i++)
        if (!begins(o->set[i], "output."))
            n += (size_t) snprintf(text + n, size - n, "%s--set '%s'",
                                   n > 0 ? " " : "", o->set[i]);
}

/* The scene as number k of its cases; of a system `more` sets its parameters.
 */
static enum status add_scene(const struct options *o, struct stress_list *list,
                             int k, char *more, struct scene *scene,
                             struct fault *why)
{
    enum status s = command_read(o, &more, k > 0, scene, why);
    char settings[sizeof list->at->settings], name[sizeof list->at->name];

    if (s != STATUS_OK)
        return s;
    describe(o, settings, sizeof settings);
    if (k > 0)
        snprintf(settings + strlen(settings),
                 sizeof settings - strlen(settings), " --set '%s'", more);
    snprintf(name, sizeof name, k > 0 ? "%.80s/%d" : "%.80s", scene_name(scene),
             k);
    if (stress_matches(name, o->only))
        s = stress_list_add(list, name, settings, scene);
    return s;
}

/* A system, and as often as that with other parameters. */
static enum status add_system(const struct options *o, struct stress_list *list,
                              const struct scene *first, struct fault *why)
{
    const int count = o->quick ? STRESS_PLANE_CASES / 4 : STRESS_PLANE_CASES;
    char more[sizeof list->at->settings] = "";
    enum status s = STATUS_OK;

    for (int k = 0; k <= count && s == STATUS_OK; k++) {
        struct scene scene;
        if (k > 0 && !stress_plane_setting(first, k, more, sizeof more / 2))
            break;
        s = add_scene(o, list, k, more, &scene, why);
        if (s == STATUS_OK)
            scene_free(&scene);
    }
    return s;
}

static enum status make_list(const struct options *o, struct stress_list *list,
                             struct fault *why)
{
    struct scene scene = { .title = NULL };
    enum status s =
        has_scene(o) ? command_read(o, NULL, 0, &scene, why) : STATUS_OK;

    if (s == STATUS_OK && scene.system) {
        s = add_system(o, list, &scene, why);
    } else if (s == STATUS_OK) {
        scene_free(&scene);
        s = stress_list_init(list, o->only, o->quick, why);
        if (s == STATUS_OK && has_scene(o))
            s = add_scene(o, list, 0, NULL, &scene, why);
    }
    scene_free(&scene);
    if (s == STATUS_OK && list->count == 0)
        s = command_refuse(why,
                           "stress: --only %s: no case has that in its name",
                           o->only ? o->only : "");
    return s;
}

static bool print(const struct options *o, const struct stress *s,
                  const struct stress_list *list)
{
    if (o->json)
        return json_print(report_stress_json(s, list));
    if (o->tap)
        report_stress_tap(stdout, s);
    else if (!o->quiet)
        report_stress_print(stdout, s);
    if (o->output && !o->quiet && !o->tap)
        printf("wrote %s\n", o->output);
    return fflush(stdout) == 0;
}

static enum exit_code run(const struct options *o,
                          const struct stress_list *list)
{
    struct fault why = { "" };
    struct stress s = { .row = NULL };
    const struct results all = { .table = stress_tables, .run = &s };
    enum status status =
        o->output ? output_file_check(o, NULL, o->output, &why) : STATUS_OK;

    if (status == STATUS_OK)
        status = stress_run(&s, list, progress_monitor(o));
    progress_end();
    if (status == STATUS_OK && o->output)
        status =
            result_file_write("stress", &all, NULL, NULL,
                              "stiff and extreme cases", o->output, NULL, &why);
    enum exit_code code = s.outcome[STRESS_LIE] > 0 ? EXIT_CHECK : EXIT_DONE;
    if (status != STATUS_OK)
        code = command_fail(status, why.text);
    else if (!print(o, &s, list))
        code = command_unwritten();
    stress_free(&s);
    return code;
}

enum exit_code command_stress(const struct options *o)
{
    struct stress_list list = { .at = NULL };
    struct fault why = { "" };

    enum status s = check_options(o, &why);
    if (s == STATUS_OK)
        s = make_list(o, &list, &why);
    const enum exit_code code =
        s == STATUS_OK ? run(o, &list) : command_fail(s, why.text);
    stress_list_free(&list);
    return code;
}
