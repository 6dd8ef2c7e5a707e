/* slipway rabinowicz: critical release distances of a law, and what measured
 * ones say of it. */
#include <string.h>

#include "command.h"
#include "export_rabinowicz.h"
#include "progress.h"
#include "replace.h"
#include "report_rabinowicz.h"

static enum status check_options(const struct options *o, struct fault *why)
{
    static const char figure[] = "output.figure=";

    for (size_t i = 0; i < o->sets; i++)
        if (strncmp(o->set[i], figure, sizeof figure - 1) == 0) {
            snprintf(why->text, sizeof why->text,
                     "rabinowicz: %s: rabinowicz draws no figure",
                     text_shown(o->set[i]).text);
            return STATUS_BAD_ARGUMENT;
        }
    return STATUS_OK;
}

static enum status run(const struct options *o, const struct scene *scene,
                       struct release *r, struct fault *why)
{
    enum status s = scene->hdf5 ? replace_check(scene->hdf5, why) : STATUS_OK;

    if (s == STATUS_OK)
        s = release_run(r, scene, progress_monitor(o), why);
    progress_end();
    if (s == STATUS_OK && scene->hdf5)
        s = export_rabinowicz(r, scene, scene->hdf5, why);
    return s;
}

static enum exit_code print(const struct options *o, const struct scene *scene,
                            const struct release *r)
{
    if (o->json)
        return json_print(report_rabinowicz_json(r)) ? EXIT_DONE
                                                     : command_unwritten();
    if (o->quiet)
        return EXIT_DONE;
    report_rabinowicz_print(stdout, r);
    if (scene->hdf5)
        printf("wrote %s\n", scene->hdf5);
    return EXIT_DONE;
}

enum exit_code command_rabinowicz(const struct options *o)
{
    struct release r = { .row = NULL };
    struct scene scene;
    struct fault why = { "" };

    if (command_allow(o, 1) != EXIT_DONE)
        return EXIT_USAGE;
    enum status s = check_options(o, &why);
    if (s == STATUS_OK)
        s = scene_read(&scene, o->files ? o->file[0] : NULL, o->set, o->sets,
                       &why);
    if (s != STATUS_OK)
        return command_fail(s, why.text);
    s = run(o, &scene, &r, &why);
    const enum exit_code code =
        s == STATUS_OK ? print(o, &scene, &r) : command_fail(s, why.text);
    release_free(&r);
    scene_free(&scene);
    return code;
}
