#include "push_file.h"

#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "csv_results.h"
#include "output.h"
#include "replace.h"
#include "result_file.h"
#include "result_units.h"
#include "scene_units.h"

RESULT_VIEW(view_answers, push_answers, s->at, s->count)
RESULT_VIEW_IF(view_arrest, push_answers, s->scattered,
               result_lend(out, s->at, s->count))

/* clang-format off */
static const struct result push_results[] = {
    { "/push", NULL, "push: states and what becomes of them", RESULT_COLUMNS,
      .type = &record_push[1][0], .view = view_answers },
    { "/push_arrest", NULL, "push where inputs scatter: the same states",
      RESULT_COLUMNS, .type = &record_push_arrest, .view = view_arrest },
    { .path = NULL },
};
/* clang-format on */

const struct result *const push_tables[] = { push_results, NULL };

static bool is_csv(const char *path)
{
    const char *dot = strrchr(path, '.');

    return (dot && strcmp(dot, ".csv") == 0) || strcmp(path, "-") == 0;
}

enum status push_file_check(const struct options *o, struct fault *why)
{
    const char *path = o->output;
    const char *dot = strrchr(path, '.');

    if (!is_csv(path) && !(dot && strcmp(dot, ".h5") == 0))
        return command_refuse(
            why,
            "push: --output %s: expected - or a path ending in .csv or .h5",
            path);
    if (strcmp(path, "-") == 0)
        return STATUS_OK;
    return output_path_check(o, NULL, path, why);
}

static enum status print(const char *text, size_t size)
{
    return fwrite(text, 1, size, stdout) == size && fflush(stdout) == 0
               ? STATUS_OK
               : STATUS_IO;
}

static enum status write_csv(const struct scene *scene,
                             const struct push_answers *answers,
                             const char *path, struct fault *why)
{
    const struct unit_system units = scene_units(scene);
    struct result_view v = { .records = { &record_push[1][answers->scattered],
                                          answers->at, answers->count } };
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    enum status s = out ? result_tell(&units, &v) : STATUS_NO_MEMORY;

    if (s == STATUS_OK)
        csv_results(out, &v.records);
    if (out && (ferror(out) | fclose(out)) && s == STATUS_OK)
        s = STATUS_NO_MEMORY;
    if (s == STATUS_OK)
        s = strcmp(path, "-") == 0 ? print(text, size)
                                   : replace_file(path, text, size, why);
    result_close(&v);
    free(text);
    return s;
}

enum status push_file_write(const struct scene *scene,
                            const struct push_answers *answers,
                            const struct ensemble *drawn, const char *path,
                            struct fault *why)
{
    const struct results all = { .table = push_tables, .run = answers };

    return is_csv(path) ? write_csv(scene, answers, path, why)
                        : result_file_write("push", &all, scene, drawn,
                                            scene->law.preset, path, NULL, why);
}
