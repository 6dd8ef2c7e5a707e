/* slipway simulate: the motion of the block from each start of a scene, or
 * from the one of --v and --psi. */
#include <math.h>
#include <string.h>

#include "command.h"
#include "json_results.h"
#include "panel.h"
#include "picture_transient.h"
#include "progress.h"
#include "replace.h"
#include "report_transient.h"
#include "result_file.h"
#include "state.h"
#include "tolerance.h"

static enum status complain(struct fault *why, const char *text)
{
    snprintf(why->text, sizeof why->text, "simulate: %s", text);
    return STATUS_BAD_ARGUMENT;
}

static enum status read_scene(const struct options *o, struct scene *scene,
                              struct fault *why)
{
    char *set[OPTIONS_SETS + 1], start[128];
    struct scene_start z;
    enum status s = command_read(o, o->set, o->sets, scene, why);

    if (s != STATUS_OK || !(o->v || o->psi || o->phi))
        return s;
    s = state_read(o, scene, &z, why);
    scene_free(scene);
    if (s != STATUS_OK)
        return s;
    /* once more: the file then says what was run */
    memcpy(set, o->set, o->sets * sizeof *set);
    state_setting(o, start, sizeof start);
    set[o->sets] = start;
    return command_read(o, set, o->sets + 1, scene, why);
}

/* Could the files be written?  Asked before anything is computed. */
static enum status check_files(const struct scene *c, struct fault *why)
{
    char path[PANEL_PATH];
    enum status s = c->hdf5 ? replace_check(c->hdf5, why) : STATUS_OK;

    for (int i = 0; c->figure && i < PICTURE_PANELS && s == STATUS_OK; i++)
        s = panel_path(c->figure, picture_transient_panel[i], path)
                ? replace_check(path, why)
                : complain(why, "the path of the figure is too long");
    return s;
}

static void tell(const struct options *o, const char *path)
{
    if (!o->quiet && !o->json)
        printf("wrote %s\n", path);
}

static enum status write_files(const struct simulation *s,
                               const struct options *o, struct fault *why)
{
    const char *hdf5 = s->scene.hdf5, *figure = s->scene.figure;
    const struct results all = { .table = simulation_tables, .run = s };
    char path[PANEL_PATH];
    enum status status = STATUS_OK;

    if (hdf5)
        status = result_file_write(
            &all, &s->scene, s->study.slider.block.law.preset, hdf5, NULL, why);
    if (status == STATUS_OK && hdf5)
        tell(o, hdf5);
    if (status != STATUS_OK || !figure)
        return status;
    status = picture_simulation(s, figure, o->keep_script, why);
    for (int i = 0; i < PICTURE_PANELS && status == STATUS_OK; i++)
        if (panel_path(figure, picture_transient_panel[i], path))
            tell(o, path);
    return status;
}

/* Numbers are printed and files written: the user may see for himself. */
static enum exit_code judge(const struct simulation *s)
{
    for (size_t i = 0; i < s->runs; i++) {
        char text[128];
        if (s->run[i].sum.end == TRANSIENT_LOST) {
            snprintf(text, sizeof text, "run %zu: lost: %s", i,
                     s->run[i].reason);
            return command_fail(STATUS_NO_CONVERGENCE, text);
        }
        const double defect = s->run[i].sum.energy_defect;
        if (fabs(defect) <= TOL_TRANSIENT_ENERGY * s->scene.rtol)
            continue;
        snprintf(text, sizeof text,
                 "run %zu: the balance of energy (27) is off by %.1e of its "
                 "largest term",
                 i, defect);
        return command_fail(STATUS_NO_CONVERGENCE, text);
    }
    return EXIT_DONE;
}

static enum exit_code print_results(const struct simulation *s,
                                    const struct options *o)
{
    if (o->json)
        return json_print(json_results(
                   NULL,
                   &(struct results){ .table = simulation_tables, .run = s }))
                   ? EXIT_DONE
                   : command_unwritten();
    if (!o->quiet)
        report_simulation_print(stdout, s);
    return EXIT_DONE;
}

static enum exit_code run(const struct options *o, const struct scene *scene)
{
    struct simulation s;
    struct fault why = { "" };

    enum status status = check_files(scene, &why);
    if (status == STATUS_OK)
        status = simulation_run(&s, scene, progress_monitor(o), &why);
    progress_end();
    if (status != STATUS_OK)
        return command_fail(status, why.text);
    status = write_files(&s, o, &why);
    enum exit_code code = status == STATUS_OK ? print_results(&s, o)
                                              : command_fail(status, why.text);
    if (code == EXIT_DONE)
        code = judge(&s);
    simulation_free(&s);
    return code;
}

enum exit_code command_simulate(const struct options *o)
{
    return command_with_scene(o, read_scene, run);
}
