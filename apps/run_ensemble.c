/* slipway ensemble: the numbers of many materials, and the fates of pushes. */
#include "picture_ensemble.h"
#include "report_ensemble.h"
#include "result_file.h"
#include "shared.h"

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

static enum status run_work(void *work, const struct scene *scene,
                            const struct sweep_options *how,
                            const struct monitor *monitor, struct fault *why)
{
    return ensemble_run(work, scene, how, monitor, why);
}

static void free_work(void *work)
{
    ensemble_free(work);
}

static enum status write_work(const void *work, const char *path,
                              struct fault *why)
{
    static const struct result *const none[] = { NULL };
    const struct ensemble *e = work;

    return result_file_write(
        "ensemble", &(struct results){ .table = none }, e->scene, e,
        e->scene->system ? "system" : e->scene->law.preset, path, NULL, why);
}

static enum status draw_work(const void *work, struct panels *p,
                             struct fault *why)
{
    return picture_ensemble(work, p, why);
}

static enum exit_code print_work(const void *work, const struct options *o)
{
    if (o->json && !json_print(report_ensemble_json(work)))
        return command_unwritten();
    if (!o->json && !o->quiet)
        report_ensemble_print(stdout, work);
    return EXIT_DONE;
}

static void note_work(const void *work)
{
    (void) work;
}

static enum exit_code run(const struct options *o, const struct scene *scene)
{
    const char *panel[PICTURE_ENSEMBLE_PANELS];
    struct ensemble e = ENSEMBLE_EMPTY;
    const struct shared_work work = { "ensemble", "draws",        panel,
                                      &e,         run_work,       free_work,
                                      write_work, draw_work,      print_work,
                                      note_work,  &e.draws.count, &e.missing,
                                      &e.taken,   &e.replaced };

    picture_ensemble_panels(scene, panel);
    return shared_command(&work, o, scene);
}

enum exit_code command_ensemble(const struct options *o)
{
    return command_with_scene(o, read_scene, run);
}
