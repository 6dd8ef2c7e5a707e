/* slipway ensemble: the numbers of many materials, and the fates of pushes. */
#include <stdlib.h>
#include <string.h>

#include "crew.h"
#include "ensemble_file.h"
#include "picture_ensemble.h"
#include "report_ensemble.h"
#include "shared.h"
#include "side_file.h"
#include "sweep.h"

static enum status read_scene(const struct options *o, struct scene *scene,
                              struct fault *why)
{
    const enum status s = command_read(o, NULL, 0, scene, why);

    if (s != STATUS_OK || (ensemble_is_asked(scene) && !scene->proved))
        return s;
    const bool proved = scene->proved;
    scene_free(scene);
    snprintf(
        why->text, sizeof why->text, "%s",
        proved
            ? "ensemble: accuracy.proved: draws are not proved, "
              "expected knees, study or basin"
            : "ensemble: the scene has none, expected 'ensemble: {parameters: "
              "{material.a: {normal: [m, s]}}, draws: N}'");
    return STATUS_BAD_SCENE;
}

/* An ensemble in the making. */
struct work {
    struct ensemble ensemble;
    const struct scene *scene;
};

static enum status run_work(void *work, const struct sweep_options *how,
                            const struct monitor *monitor, struct fault *why)
{
    struct work *w = work;

    return ensemble_run(&w->ensemble, w->scene, how, monitor, why);
}

static void free_work(void *work)
{
    struct work *w = work;

    ensemble_free(&w->ensemble);
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
    struct work work = { .scene = scene,
                         .ensemble = {
                             .draws = { .id = -1 },
                             .spool = { .journal = { .file = -1 } } } };
    struct ensemble *e = &work.ensemble;
    const struct shared_work shared = { run_work, free_work, &work, &e->missing,
                                        &e->taken };
    bool whole = true;
    const char *panel[PICTURE_ENSEMBLE_PANELS];
    char *journal = side_file_of(scene);

    picture_ensemble_panels(scene, panel);
    enum status s =
        scene->hdf5 && !journal
            ? STATUS_NO_MEMORY
            : side_file_check(o, scene, "ensemble", journal, panel, &why);

    s = crew_agree(s, &why, NULL);
    if (s == STATUS_OK)
        s = shared_run(&shared, o, journal, &whole, &why);
    if (s != STATUS_OK) {
        free(journal);
        return command_fail(s, why.text);
    }
    if (whole)
        s = write_files(e, o, journal, &why);
    else if (!o->quiet && o->shard)
        printf("share %s: %zu of %zu draws, beside %s; 'slipway merge' joins "
               "all shares\n",
               o->shard, e->draws.count - e->missing, e->draws.count, journal);
    const enum exit_code code = s != STATUS_OK ? command_fail(s, why.text)
                                : whole        ? print_results(e, o, journal)
                                               : EXIT_DONE;
    ensemble_free(e);
    free(journal);
    return code;
}

enum exit_code command_ensemble(const struct options *o)
{
    return command_with_scene(o, read_scene, run);
}
