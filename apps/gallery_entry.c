/* One scene of the gallery: run, drawn as SVG, PNG and PDF, and described. */
#include "gallery_entry.h"

#include <stdlib.h>
#include <string.h>

#include "replace.h"
#include "scene_command.h"

bool gallery_path(char out[PATH_MAX], const char *folder, const char *name,
                  const char *ending)
{
    return snprintf(out, PATH_MAX, "%s/%s%s", folder, name, ending) < PATH_MAX;
}

/* "output.hdf5='DIR/NAME.h5'"; owned. */
static char *output_set(const struct gallery_place *g,
                        const struct gallery_entry *e, const char *key,
                        const char *ending)
{
    char path[PATH_MAX];

    return gallery_path(path, g->output, e->name, ending)
               ? options_setting(key, path, true)
               : NULL;
}

/* Runs the scene's command with its figure as NAME.svg and the others. */
static enum exit_code run_scene(const struct gallery_place *g,
                                struct gallery_entry *e)
{
    const char *file[] = { e->path };
    struct options o = { .command = command_find(scene_command(&e->scene)),
                         .file = file,
                         .files = 1,
                         .quiet = true,
                         .keep_script = g->options->keep_script,
                         .also = { ".png", ".pdf" },
                         .drawn = &e->panel,
                         .progress = g->progress };
    char *own[] = { output_set(g, e, "output.hdf5", ".h5"),
                    output_set(g, e, "output.figure", ".svg") };
    enum exit_code code = EXIT_FILE;

    o.sets = g->options->sets;
    memcpy(o.set, g->options->set, o.sets * sizeof *o.set);
    const bool fits = o.sets + 2 <= OPTIONS_SETS && own[0] && own[1];
    for (int i = 0; fits && i < 2; i++)
        o.set[o.sets++] = own[i];
    if (fits)
        code = command_run(o.command, &o);
    else
        command_fail(STATUS_IO, "gallery: too many settings, or a long path");
    for (int i = 0; i < 2; i++)
        free(own[i]);
    return code;
}

/* The scene's first comment, its lines joined; owned. */
static char *first_comment(const char *text)
{
    char *out = calloc(strlen(text) + 1, 1), *end = out;

    while (out && *text == '#') {
        const size_t n = strcspn(text, "\n");
        const size_t from = strspn(text, "# ");
        if (end > out)
            *end++ = ' ';
        if (from < n) {
            memcpy(end, text + from, n - from);
            end += n - from;
        }
        text += n + (text[n] == '\n');
    }
    return out;
}

static enum exit_code copy_scene(const struct gallery_place *g,
                                 const struct gallery_entry *e)
{
    struct fault why = { "" };
    char path[PATH_MAX];

    if (!gallery_path(path, g->output, e->name, ".yaml"))
        return EXIT_FILE;
    const enum status s =
        replace_file(path, e->scene.text, strlen(e->scene.text), &why);
    return s == STATUS_OK ? EXIT_DONE : command_fail(s, why.text);
}

void gallery_build(const struct gallery_place *g, struct gallery_entry *e)
{
    const struct options *o = g->options;
    struct fault why = { "" };
    const enum status s = scene_read(&e->scene, e->path, o->set, o->sets, &why);

    if (s != STATUS_OK) {
        e->scene = (struct scene){ .title = NULL };
        e->code = command_fail(s, why.text);
    }
    if (s == STATUS_OK && e->scene.figure) {
        e->code = run_scene(g, e);
        if (e->code == EXIT_DONE)
            e->code = copy_scene(g, e);
    }
    e->comment = first_comment(e->scene.text ? e->scene.text : "");
    if (asprintf(&e->command, "slipway %s %s", scene_command(&e->scene),
                 e->path) < 0)
        e->command = NULL;
}

void gallery_entry_free(struct gallery_entry *e)
{
    free(e->comment);
    free(e->command);
    e->comment = e->command = NULL;
    scene_free(&e->scene);
}
