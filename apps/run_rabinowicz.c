/* slipway rabinowicz: critical release distances of a law, and what measured
 * ones say of it. */
#include <stdio.h>

#include "command.h"
#include "json_results.h"
#include "panel.h"
#include "picture_rabinowicz.h"
#include "picture_transient.h"
#include "progress.h"
#include "replace.h"
#include "report_rabinowicz.h"
#include "result_file.h"

/* Could the files be written?  Asked before anything is computed. */
static enum status check_files(const struct scene *c, struct fault *why)
{
    char path[PANEL_PATH];
    enum status s = c->hdf5 ? replace_check(c->hdf5, why) : STATUS_OK;

    if (c->figure && !c->rabinowicz.data) {
        snprintf(why->text, sizeof why->text,
                 "rabinowicz: %.300s: a figure shows data, expected --data",
                 c->figure);
        return STATUS_BAD_ARGUMENT;
    }
    for (int i = 0; c->figure && i < PICTURE_RABINOWICZ_PANELS && !s; i++) {
        if (panel_path(c->figure, picture_rabinowicz_panel[i], path)) {
            s = replace_check(path, why);
            continue;
        }
        snprintf(why->text, sizeof why->text,
                 "rabinowicz: the path of the figure is too long");
        s = STATUS_BAD_ARGUMENT;
    }
    return s;
}

static enum status run(const struct options *o, const struct scene *scene,
                       struct release *r, struct fault *why)
{
    const struct results all = { .table = release_tables, .run = r };
    enum status s = check_files(scene, why);

    if (s == STATUS_OK)
        s = release_run(r, scene, progress_monitor(o), why);
    progress_end();
    if (s == STATUS_OK && scene->hdf5)
        s = result_file_write(&all, scene, "Rabinowicz's experiment",
                              scene->hdf5, NULL, why);
    if (s == STATUS_OK && scene->figure)
        s = picture_rabinowicz(r, scene, scene->figure, o->keep_script, why);
    return s;
}

static void tell_files(const struct scene *scene)
{
    char path[PANEL_PATH];

    if (scene->hdf5)
        printf("wrote %s\n", scene->hdf5);
    for (int i = 0; scene->figure && i < PICTURE_RABINOWICZ_PANELS; i++)
        if (panel_path(scene->figure, picture_rabinowicz_panel[i], path))
            printf("wrote %s\n", path);
}

static enum exit_code print(const struct options *o, const struct scene *scene,
                            const struct release *r)
{
    if (o->json)
        return json_print(json_results(
                   NULL,
                   &(struct results){ .table = release_tables, .run = r }))
                   ? EXIT_DONE
                   : command_unwritten();
    if (o->quiet)
        return EXIT_DONE;
    report_rabinowicz_print(stdout, r);
    tell_files(scene);
    return EXIT_DONE;
}

enum exit_code command_rabinowicz(const struct options *o)
{
    struct release r = { .row = NULL };
    struct scene scene;
    struct fault why = { "" };

    enum status s = command_read(o, o->set, o->sets, &scene, &why);
    if (s != STATUS_OK)
        return command_fail(s, why.text);
    s = run(o, &scene, &r, &why);
    const enum exit_code code =
        s == STATUS_OK ? print(o, &scene, &r) : command_fail(s, why.text);
    release_free(&r);
    scene_free(&scene);
    return code;
}
