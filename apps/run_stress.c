/* slipway stress: the catalogue of stiff and extreme cases, held to 113 bits;
 * a user's scene is one more case. */
#include <string.h>

#include "command.h"
#include "output.h"
#include "progress.h"
#include "report_stress.h"
#include "result_file.h"
#include "stress_plane.h"

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
