#include "command.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "progress.h"
#include "scene_scatter.h"
#include "text.h"

static bool has_rabinowicz(const struct scene_rabinowicz *r)
{
    return r->block_mass > 0.0 || r->ball_mass > 0.0 || r->restitution >= 0.0 ||
           r->slopes > 0 || r->data != NULL;
}

const char *scene_command(const struct scene *s)
{
    if (s->sweep.axes > 0)
        return "sweep";
    if (s->ensemble.parameters > s->ensemble.scattered || s->ensemble.samples ||
        s->ensemble.covariance)
        return "ensemble";
    if (s->system)
        return "study";
    if (s->products == 0 && has_rabinowicz(&s->rabinowicz))
        return "rabinowicz";
    if (s->products == 0 && s->starts > 0 && s->spread == 0)
        return "simulate";
    return "study";
}

enum exit_code command_run(const struct command *c, const struct options *o)
{
#define RUN(NAME, name, does) command_##name,
    static enum exit_code (*const run[])(
        const struct options *) = { COMMAND_LIST(RUN) };

    return options_suit(o, c) ? run[command_id(c)](o) : EXIT_USAGE;
}

/* Whether a setting names output.KEY. */
static bool names(const char *set, const char *key)
{
    const size_t n = strlen("output"), m = strlen(key);

    return strncmp(set, "output", n) == 0 &&
           (set[n] == '=' ||
            (strncmp(set + n + 1, key, m) == 0 && set[n + 1 + m] == '='));
}

/* Frees a path that no setting names. */
static void drop(char **path, const char *key, char *const set[], size_t sets)
{
    for (size_t i = 0; i < sets; i++)
        if (names(set[i], key))
            return;
    free(*path);
    *path = NULL;
}

enum status command_read(const struct options *o, char *const more[],
                         size_t count, struct scene *scene, struct fault *why)
{
    static const unsigned makers = COMMAND_LIST(COMMAND_MAKE_BIT);
    static const unsigned planes = COMMAND_LIST(COMMAND_PLANE_BIT);
    static const unsigned scatters =
        COMMAND_LIST(COMMAND_STUDY_BIT) + (1u << COMMAND_ENSEMBLE) +
        (1u << COMMAND_PUSH) + (1u << COMMAND_MERGE);
    char *set[OPTIONS_SETS + COMMAND_MORE];
    const size_t sets = o->sets + count;

    memcpy(set, o->set, o->sets * sizeof *set);
    for (size_t i = 0; i < count; i++)
        set[o->sets + i] = more[i];
    enum status s =
        scene_read(scene, o->files ? o->file[0] : NULL, set, sets, why);
    if (s == STATUS_OK && scene->system &&
        !(planes >> command_id(o->command) & 1u)) {
        scene_free(scene);
        return command_refuse(why,
                              "%s: not for a system of formulas, expected a "
                              "law on a slope",
                              o->command->name);
    }
    if (s == STATUS_OK && !(scatters >> command_id(o->command) & 1u))
        s = scene_scatter_refuse(scene, o->command->name, why);
    if (s != STATUS_OK)
        scene_free(scene); /* a second time, perhaps */
    if (s != STATUS_OK || makers >> command_id(o->command) & 1u)
        return s;
    drop(&scene->hdf5, "hdf5", set, sets);
    drop(&scene->figure, "figure", set, sets);
    return s;
}

enum status command_refuse(struct fault *why, const char *format,
                           const char *text)
{
    return fault_set(why, STATUS_BAD_ARGUMENT, format, text_shown(text).text);
}

enum exit_code command_fail(enum status s, const char *text)
{
    char line[2048]; /* one, whatever a file is called */

    if (s == STATUS_STOPPED)
        progress_heard();
    text_show(text[0] ? text : status_text(s), line, sizeof line);
    fprintf(stderr, "slipway: %s\n", line);
    switch (s) {
        case STATUS_BAD_SCENE:
        case STATUS_BAD_ARGUMENT:
            return EXIT_USAGE;
        case STATUS_IO:
        case STATUS_NO_GNUPLOT:
            return EXIT_FILE;
        case STATUS_STOPPED:
            return EXIT_INTERRUPT;
        default:
            return EXIT_NUMBER;
    }
}

enum exit_code command_with_scene(
    const struct options *o,
    enum status (*read)(const struct options *o, struct scene *scene,
                        struct fault *why),
    enum exit_code (*run)(const struct options *o, const struct scene *scene))
{
    struct scene scene;
    struct fault why = { "" };
    const enum status s =
        read ? read(o, &scene, &why) : command_read(o, NULL, 0, &scene, &why);

    if (s != STATUS_OK)
        return command_fail(s, why.text);
    const enum exit_code code = run(o, &scene);
    scene_free(&scene);
    return code;
}

enum exit_code command_unwritten(void)
{
    return command_fail(STATUS_IO, "cannot write to standard output");
}

void command_plain(FILE *out, const char *text)
{
    for (; *text; text++)
        fprintf(out, "%s%c", *text == '#' || *text == '\\' ? "\\" : "", *text);
}
