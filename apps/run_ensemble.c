/* slipway ensemble: the numbers of many materials, and the fates of pushes. */
#include <stdlib.h>
#include <string.h>

#include "ensemble_file.h"
#include "picture_ensemble.h"
#include "progress.h"
#include "replace.h"
#include "report_ensemble.h"
#include "side_file.h"
#include "sweep.h"

static enum status read_scene(const struct options *o, struct scene *scene,
                              struct fault *why)
{
    const enum status s = command_read(o, NULL, 0, scene, why);

    if (s != STATUS_OK || ensemble_is_asked(scene))
        return s;
    scene_free(scene);
    snprintf(why->text, sizeof why->text,
             "ensemble: the scene has none, expected 'ensemble: {parameters: "
             "{material.a: {normal: [m, s]}}, draws: N}'");
    return STATUS_BAD_SCENE;
}

static enum status run_draws(struct ensemble *e, const struct scene *scene,
                             const struct options *o, const char *journal,
                             struct fault *why)
{
    const struct ensemble_options how = { .journal = journal,
                                          .resume = o->resume,
                                          .version = SLIPWAY_VERSION };
    enum status status = journal ? replace_folder(journal, why) : STATUS_OK;

    if (status == STATUS_OK)
        status = ensemble_run(e, scene, &how, progress_monitor(o), why);
    progress_end();
    if (status == STATUS_STOPPED && journal)
        snprintf(why->text, sizeof why->text,
                 "interrupted; what is computed stays in %.300s for --resume",
                 journal);
    return status;
}

static enum status write_files(const struct ensemble *e,
                               const struct options *o, const char *journal,
                               struct fault *why)
{
    const struct scene *c = e->scene;
    struct panels p = PANELS_EMPTY;
    enum status status = STATUS_OK;

    if (c->hdf5)
        status = ensemble_file_write(e, c->hdf5, why);
    if (status == STATUS_OK && c->hdf5) {
        sweep_forget(journal);
        output_tell(o, c->hdf5);
    }
    if (status == STATUS_OK && c->figure)
        status = picture_ensemble(e, &p, why);
    return status ? status : output_draw(o, &c->paper, &p, c->figure, why);
}

static enum exit_code print_results(const struct ensemble *e,
                                    const struct options *o,
                                    const char *journal)
{
    if (o->json && !json_print(report_ensemble_json(e)))
        return command_unwritten();
    if (o->json || o->quiet)
        return EXIT_DONE;
    report_ensemble_print(stdout, e);
    if (e->replaced)
        printf("note: %s of an interrupted run was replaced; --resume would "
               "have gone on\n",
               journal);
    if (e->taken > 0)
        printf("note: %zu of %zu draws were there already\n", e->taken,
               e->draws.count);
    return EXIT_DONE;
}

static enum exit_code run(const struct options *o, const struct scene *scene)
{
    struct fault why = { "" };
    struct ensemble e;
    const char *panel[PICTURE_ENSEMBLE_PANELS];
    char *journal = side_file_of(scene);

    picture_ensemble_panels(scene, panel);
    enum status s =
        scene->hdf5 && !journal
            ? STATUS_NO_MEMORY
            : side_file_check(o, scene, "ensemble", journal, panel, &why);

    if (s == STATUS_OK)
        s = run_draws(&e, scene, o, journal, &why);
    if (s != STATUS_OK) {
        free(journal);
        return command_fail(s, why.text);
    }
    s = write_files(&e, o, journal, &why);
    const enum exit_code code = s == STATUS_OK ? print_results(&e, o, journal)
                                               : command_fail(s, why.text);
    ensemble_free(&e);
    free(journal);
    return code;
}

enum exit_code command_ensemble(const struct options *o)
{
    return command_with_scene(o, read_scene, run);
}
