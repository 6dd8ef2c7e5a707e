#include "output.h"

#include <string.h>
#include <sys/stat.h>

#include "json_results.h"
#include "progress.h"
#include "replace.h"
#include "result_file.h"
#include "text_results.h"

enum { PANEL_PATH = 4096 };

/* "a.svg", "_time" -> "a_time.svg"; false if that is too long. */
static bool panel_path(const char *path, const char *panel,
                       char out[PANEL_PATH])
{
    const char *slash = strrchr(path, '/'), *dot = strrchr(path, '.');
    const char *end =
        dot && (!slash || dot > slash) ? dot : path + strlen(path);

    return snprintf(out, PANEL_PATH, "%.*s%s%s", (int) (end - path), path,
                    panel, end) < PANEL_PATH;
}

static enum status refuse(struct fault *why, const char *what, const char *text)
{
    return fault_set(why, STATUS_BAD_SCENE, "%.300s: %s", what, text);
}

static bool is_same_file(const char *a, const char *b)
{
    struct stat one, other;

    return stat(a, &one) == 0 && stat(b, &other) == 0 &&
           one.st_dev == other.st_dev && one.st_ino == other.st_ino &&
           S_ISREG(one.st_mode);
}

enum status output_path_check(const struct options *o,
                              const struct scene *scene, const char *path,
                              struct fault *why)
{
    const char *const data = scene ? scene->rabinowicz.data : NULL;
    bool is_read = (o->states && is_same_file(o->states, path)) ||
                   (data && is_same_file(data, path));

    for (size_t i = 0; i < o->files; i++)
        is_read |= is_same_file(o->file[i], path);
    return is_read
               ? refuse(why, path, "is read, expected another file to write")
               : replace_check(path, why);
}

enum status output_file_check(const struct options *o,
                              const struct scene *scene, const char *path,
                              struct fault *why)
{
    const char *dot = strrchr(path, '.');

    if (strcmp(path, "-") == 0)
        return refuse(why, "--output -",
                      "HDF5 is not printed, expected FILE.h5, or --json");
    const enum status s = output_path_check(o, scene, path, why);
    return s == STATUS_OK && dot && strcmp(dot, ".csv") == 0
               ? refuse(why, path,
                        "the file is HDF5, expected FILE.h5 (CSV of a sweep: "
                        "--output -)")
               : s;
}

enum status output_check(const struct options *o, const struct scene *scene,
                         const char *path, const char *const panel[],
                         struct fault *why)
{
    char file[PANEL_PATH];
    enum status s = STATUS_OK;

    if (scene->hdf5 && path && strcmp(scene->hdf5, path) == 0)
        return refuse(why, path, "both the HDF5 file and the figure");
    if (scene->hdf5)
        s = output_file_check(o, scene, scene->hdf5, why);
    for (size_t i = 0; path && panel[i] && s == STATUS_OK; i++)
        s = panel_path(path, panel[i], file)
                ? output_path_check(o, scene, file, why)
                : refuse(why, o->command->name,
                         "the path of the figure is too long");
    return s;
}

bool output_is_standard(const struct options *o)
{
    return o->output && strcmp(o->output, "-") == 0;
}

const char *output_path(const struct options *o)
{
    return output_is_standard(o) ? NULL : o->output;
}

enum status output_standard_check(const struct options *o, struct fault *why)
{
    return output_is_standard(o) && o->json
               ? command_refuse(why,
                                "%s: --output -: expected no --json "
                                "beside it",
                                o->command->name)
               : STATUS_OK;
}

void output_tell(const struct options *o, const char *path)
{
    if (!o->quiet && !o->json && !output_is_standard(o))
        printf("wrote %s\n", path);
}

enum status output_write(const struct options *o, const char *command,
                         const struct results *all, const struct scene *scene,
                         const struct ensemble *drawn, const char *untitled,
                         struct fault *why)
{
    if (scene->hdf5 == NULL)
        return STATUS_OK;
    const enum status s =
        result_file_write(command, all, scene, drawn, untitled, scene->hdf5,
                          progress_monitor(o), why);
    if (s == STATUS_OK)
        output_tell(o, scene->hdf5);
    return s;
}

struct figure *panels_add(struct panels *p, const char *name)
{
    struct panel_names *n = &p->names;

    snprintf(n->name[n->count], PANEL_NAME, "%s", name);
    p->figure[n->count] = FIGURE_EMPTY;
    return &p->figure[n->count++];
}

static struct figure_page page_of(const struct scene_figure *paper)
{
    static const enum figure_legend legend[] = {
        [LEGEND_AUTO] = FIGURE_LEGEND_OUTSIDE,
        [LEGEND_OUTSIDE] = FIGURE_LEGEND_OUTSIDE,
        [LEGEND_INSIDE] = FIGURE_LEGEND_INSIDE,
        [LEGEND_BELOW] = FIGURE_LEGEND_BELOW,
        [LEGEND_NONE] = FIGURE_LEGEND_NONE,
    };
    static const enum figure_colours colours[] = {
        [COLOURS_VIRIDIS] = FIGURE_VIRIDIS,
        [COLOURS_CIVIDIS] = FIGURE_CIVIDIS,
        [COLOURS_GREYS] = FIGURE_GREYS,
    };

    return (struct figure_page){ .width = paper->width,
                                 .height = paper->height,
                                 .type = paper->type,
                                 .dpi = paper->dpi,
                                 .font = paper->font,
                                 .untitled = !paper->title,
                                 .legend = legend[paper->legend],
                                 .colours = colours[paper->colours] };
}

/* All panels, beside `path`, or as its like with another ending. */
static enum status draw_as(const struct options *o, const struct panels *p,
                           const char *path, const char *ending,
                           struct fault *why)
{
    char file[PANELS_MAX][PANEL_PATH];
    const char *to[PANELS_MAX];
    enum status s = STATUS_OK;

    for (size_t i = 0; i < p->names.count && s == STATUS_OK; i++) {
        to[i] = file[i];
        if (!panel_path(path, p->names.name[i], file[i]))
            s = refuse(why, path, "too long a path");
        else if (ending) /* as long as the other */
            strcpy(strrchr(file[i], '.'), ending);
    }
    if (s == STATUS_OK)
        s = replace_folder(path, why);
    if (s == STATUS_OK)
        s = figures_write(p->figure, to, p->names.count, o->keep_script, why);
    for (size_t i = 0; i < p->names.count && s == STATUS_OK; i++)
        output_tell(o, file[i]);
    return s;
}

enum status output_draw(const struct options *o,
                        const struct scene_figure *paper, struct panels *p,
                        const char *path, struct fault *why)
{
    enum status s = STATUS_OK;

    for (size_t i = 0; i < p->names.count; i++)
        p->figure[i].page = page_of(paper);
    if (p->names.count > 0)
        s = draw_as(o, p, path, NULL, why);
    for (size_t i = 0; p->names.count > 0 && i < OPTIONS_ALSO && o->also[i];
         i++)
        if (s == STATUS_OK)
            s = draw_as(o, p, path, o->also[i], why);
    for (size_t i = 0; i < p->names.count; i++)
        figure_free(&p->figure[i]);
    if (o->drawn && s == STATUS_OK)
        *o->drawn = p->names;
    *p = PANELS_EMPTY;
    return s;
}

enum exit_code output_print(const struct options *o, const struct results *all,
                            void (*head)(FILE *out, const void *run))
{
    if (o->json && !json_print(json_results(NULL, all)))
        return command_unwritten();
    if (o->json || o->quiet)
        return EXIT_DONE;
    if (head)
        head(stdout, all->run);
    const enum status s = text_results(stdout, all);
    return s ? command_fail(s, status_text(s)) : EXIT_DONE;
}
