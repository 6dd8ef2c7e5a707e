/* slipway simulate: the motion of the block from each start of a scene, or
 * from the one of --v and --psi. */
#include <math.h>
#include <string.h>

#include "output.h"
#include "picture_transient.h"
#include "progress.h"
#include "scene_units.h"
#include "state.h"
#include "tolerance.h"

static enum status read_scene(const struct options *o, struct scene *scene,
                              struct fault *why)
{
    char start[128], *more[] = { start };
    struct scene_start z;
    enum status s = command_read(o, NULL, 0, scene, why);

    if (s != STATUS_OK || !(o->v || o->psi || o->phi))
        return s;
    s = state_read(o, scene, &z, why);
    scene_free(scene);
    if (s != STATUS_OK)
        return s;
    state_setting(o, start, sizeof start);
    return command_read(o, more, 1, scene, why);
}

static enum status write_files(const struct simulation *s,
                               const struct options *o,
                               const struct results *all, struct fault *why)
{
    struct panels p = PANELS_EMPTY;
    enum status status =
        s->scene.figure ? picture_simulation_check(s, why) : STATUS_OK;

    if (status == STATUS_OK)
        status = output_write(o, "simulate", all, &s->scene, NULL,
                              s->study.slider.block.law.preset, why);
    if (status == STATUS_OK && s->scene.figure)
        picture_simulation(s, &p);
    return status ? status
                  : output_draw(o, &s->scene.paper, &p, s->scene.figure, why);
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

/* In both units. */
static void print_starts(FILE *out, const void *run)
{
    const struct simulation *s = run;

    for (size_t i = 0; i < s->runs; i++) {
        fprintf(out, "start %zu: ", i);
        state_print(out, &s->scene, s->run[i].sum.v, s->run[i].sum.psi);
        fputc('\n', out);
    }
}

static enum exit_code run(const struct options *o, const struct scene *scene)
{
    struct simulation s;
    struct fault why = { "" };
    const struct results all = { .table = simulation_tables,
                                 .run = &s,
                                 .units = scene_units(scene) };

    enum status status =
        output_check(o, scene, scene->figure, picture_simulation_panel, &why);
    if (status == STATUS_OK)
        status = simulation_run(&s, scene, progress_monitor(o), &why);
    progress_end();
    if (status != STATUS_OK)
        return command_fail(status, why.text);
    status = write_files(&s, o, &all, &why);
    enum exit_code code = status == STATUS_OK
                              ? output_print(o, &all, print_starts)
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
