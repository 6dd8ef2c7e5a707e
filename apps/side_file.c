#include "side_file.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "origin.h"
#include "provenance.h"

char *side_file_of(const struct scene *c)
{
    const size_t size = c->hdf5 ? strlen(c->hdf5) + sizeof ".part" : 0;
    char *path = size ? malloc(size) : NULL;

    if (path)
        snprintf(path, size, "%s.part", c->hdf5);
    return path;
}

static enum status is_of(const char *path, const char *command,
                         const char *expected, struct fault *why)
{
    if (strcmp(command, expected) == 0)
        return STATUS_OK;
    snprintf(why->text, sizeof why->text,
             "%.300s: made by %.40s, expected a file of this %s (without "
             "--resume it is replaced)",
             path, command, expected);
    return STATUS_BAD_SCENE;
}

static enum status is_sweep(const char *path, const char *command,
                            struct fault *why)
{
    return is_of(path, command, "sweep", why);
}

static enum status is_ensemble(const char *path, const char *command,
                               struct fault *why)
{
    return is_of(path, command, "ensemble", why);
}

/* A file that is there already is this run's own, which was finished. */
static enum status check_finished(const struct scene *c, const char *command,
                                  struct fault *why)
{
    struct origin was;
    const bool sweeps = strcmp(command, "sweep") == 0;
    enum status s =
        origin_read(c->hdf5, sweeps ? is_sweep : is_ensemble, &was, why);
    char *overrides = s == STATUS_OK ? provenance_overrides(c) : NULL;

    if (s == STATUS_OK && overrides == NULL)
        s = STATUS_NO_MEMORY;
    if (s == STATUS_OK && (strcmp(was.scene, c->text) != 0 ||
                           strcmp(was.overrides, overrides) != 0)) {
        snprintf(why->text, sizeof why->text,
                 "%.300s: of another scene, expected a file of this %s "
                 "(without --resume it is replaced)",
                 c->hdf5, command);
        s = STATUS_BAD_SCENE;
    }
    free(overrides);
    free(was.held);
    return s;
}

enum status side_file_check(const struct options *o, const struct scene *c,
                            const char *command, const char *journal,
                            const char *const panel[], struct fault *why)
{
    if (o->resume && c->hdf5 == NULL) {
        snprintf(why->text, sizeof why->text,
                 "%s: --resume without a file, expected -o FILE.h5", command);
        return STATUS_BAD_SCENE;
    }
    const enum status s = output_check(o, c, c->figure, panel, why);
    return s == STATUS_OK && o->resume && access(journal, F_OK) != 0 &&
                   access(c->hdf5, F_OK) == 0
               ? check_finished(c, command, why)
               : s;
}
