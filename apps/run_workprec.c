/* slipway workprec: error against run time, our methods and others', on one
 * slope. */
#include <omp.h>
#include <string.h>

#include "command.h"
#include "json_results.h"
#include "picture_workprec.h"
#include "progress.h"
#include "replace.h"
#include "report_workprec.h"
#include "result_file.h"

/* Whether a setting names a key of that section. */
static bool has_section(const struct options *o, const char *section)
{
    for (size_t i = 0; i < o->sets; i++)
        if (strncmp(o->set[i], section, strlen(section)) == 0)
            return true;
    return false;
}

/* The scene; what nobody says of the slope is that of the paper's Fig 7b. */
static enum status read_scene(const struct options *o, struct scene *scene,
                              struct fault *why)
{
    static char law[] = "law.preset=spinodal_gen", slope[] = "slope.alpha=0.34";
    char *set[OPTIONS_SETS + 2];
    size_t sets = 0;

    if (o->files == 0 && !has_section(o, "law"))
        set[sets++] = law;
    if (o->files == 0 && !has_section(o, "slope"))
        set[sets++] = slope;
    memcpy(set + sets, o->set, o->sets * sizeof *set);
    return command_read(o, set, sets + o->sets, scene, why);
}

/* Could the files be written?  Asked before anything is computed. */
static enum status check_files(const struct scene *c, struct fault *why)
{
    char panel[PICTURE_WORKPREC_PATH];
    enum status s = c->hdf5 ? replace_check(c->hdf5, why) : STATUS_OK;

    for (int q = 0; c->figure && q < WORKPREC_QUANTITIES && s == STATUS_OK;
         q++) {
        if (picture_workprec_path(c->figure, (enum workprec_quantity) q,
                                  panel)) {
            s = replace_check(panel, why);
            continue;
        }
        snprintf(why->text, sizeof why->text,
                 "workprec: the path of the figure is too long");
        s = STATUS_BAD_ARGUMENT;
    }
    return s;
}

static enum status write_files(const struct workprec *w,
                               const struct options *o, struct fault *why)
{
    const struct results all = { .table = workprec_tables, .run = w };
    const struct scene *c = &w->scene;
    enum status s = STATUS_OK;

    if (c->hdf5)
        s = result_file_write(&all, c, "error against run time", c->hdf5, NULL,
                              why);
    if (c->figure && s == STATUS_OK)
        s = picture_workprec(w, c->figure, o->keep_script, why);
    return s;
}

static void tell_files(const struct workprec *w)
{
    char panel[PICTURE_WORKPREC_PATH];

    if (w->scene.hdf5)
        printf("wrote %s\n", w->scene.hdf5);
    for (int q = 0; w->scene.figure && q < WORKPREC_QUANTITIES; q++)
        if (w->course.reason[q] == NULL &&
            picture_workprec_path(w->scene.figure, (enum workprec_quantity) q,
                                  panel))
            printf("wrote %s\n", panel);
}

static enum exit_code print(const struct workprec *w, const struct options *o)
{
    if (o->json)
        return json_print(json_results(
                   NULL,
                   &(struct results){ .table = workprec_tables, .run = w }))
                   ? EXIT_DONE
                   : command_unwritten();
    if (o->quiet)
        return EXIT_DONE;
    report_workprec_print(stdout, w);
    tell_files(w);
    return EXIT_DONE;
}

/* On one thread: times must not compete. */
static enum exit_code run(const struct options *o, const struct scene *scene)
{
    static struct workprec w;
    struct fault why = { "" };
    enum status s = check_files(scene, &why);

    omp_set_num_threads(1);
    if (s == STATUS_OK)
        s = workprec_run(&w, scene, o->quick, progress_monitor(o), &why);
    progress_end();
    if (s != STATUS_OK)
        return command_fail(s, why.text);
    s = write_files(&w, o, &why);
    const enum exit_code code =
        s == STATUS_OK ? print(&w, o) : command_fail(s, why.text);
    workprec_free(&w);
    return code;
}

enum exit_code command_workprec(const struct options *o)
{
    return command_with_scene(o, read_scene, run);
}
