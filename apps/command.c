#include "command.h"

#include <stdio.h>

#include "text.h"

enum exit_code command_run(const struct command *c, const struct options *o)
{
#define RUN(NAME, name) command_##name,
    static enum exit_code (*const run[])(
        const struct options *) = { COMMAND_LIST(RUN) };

    return options_suit(o, c) ? run[command_id(c)](o) : EXIT_USAGE;
}

enum exit_code command_fail(enum status s, const char *text)
{
    char line[2048]; /* one, whatever a file is called */

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
    const enum status s = read(o, &scene, &why);

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
