/* slipway workprec: error against run time, our methods and others', on one
 * slope. */
#include <omp.h>
#include <string.h>

#include "output.h"
#include "picture_workprec.h"
#include "progress.h"
#include "report_workprec.h"

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
    char *more[COMMAND_MORE];
    size_t count = 0;

    if (o->files == 0 && !has_section(o, "law"))
        more[count++] = law;
    if (o->files == 0 && !has_section(o, "slope"))
        more[count++] = slope;
    return command_read(o, more, count, scene, why);
}

/* On one thread: times must not compete. */
static enum exit_code run(const struct options *o, const struct scene *scene)
{
    static struct workprec w;
    struct panels p = PANELS_EMPTY;
    struct fault why = { "" };
    const struct results all = { .table = workprec_tables, .run = &w };
    enum status s =
        output_check(o, scene, scene->figure, picture_workprec_panel, &why);

    omp_set_num_threads(1);
    if (s == STATUS_OK)
        s = workprec_run(&w, scene, o->quick, progress_monitor(o), &why);
    progress_end();
    if (s != STATUS_OK)
        return command_fail(s, why.text);
    s = output_write(o, "workprec", &all, scene, "error against run time",
                     &why);
    if (s == STATUS_OK && scene->figure)
        picture_workprec(&w, &p);
    if (s == STATUS_OK)
        s = output_draw(o, &p, scene->figure, &why);
    const enum exit_code code =
        s == STATUS_OK ? output_print(o, &all, report_workprec_print)
                       : command_fail(s, why.text);
    workprec_free(&w);
    return code;
}

enum exit_code command_workprec(const struct options *o)
{
    return command_with_scene(o, read_scene, run);
}
