#include "workshop.h"

#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "litter.h"

/* The first n bytes of a text and another, as a new string. */
static char *workshop_join(const char *a, size_t n, const char *b)
{
    const size_t m = strlen(b);
    char *s = malloc(n + m + 1);
    if (s) {
        memcpy(s, a, n);
        memcpy(s + n, b, m + 1);
    }
    return s;
}

static char *join_path(const char *folder, const char *name)
{
    const size_t n = strlen(folder);
    char *slashed = workshop_join(folder, n, "/");
    char *s = slashed ? workshop_join(slashed, n + 1, name) : NULL;
    free(slashed);
    return s;
}

/* Fills the names; false when memory is out. */
static bool name_files(struct workshop *w, const char *path, const char *base)
{
    const char *dot = strrchr(base, '.');
    const size_t stem = dot ? (size_t) (dot - base) : strlen(base);
    const size_t before = (size_t) (base - path);
    const char *const endings[] = { [WORKSHOP_SCRIPT] = ".gp",
                                    [WORKSHOP_DATA] = ".dat",
                                    [WORKSHOP_FIGURE] = dot ? dot : "" };
    for (int k = 0; k < WORKSHOP_FILES; k++) {
        w->name[k] = workshop_join(base, stem, endings[k]);
        w->goal[k] = workshop_join(path, before + stem, endings[k]);
        w->made[k] = w->name[k] ? join_path(w->folder, w->name[k]) : NULL;
        if (!w->name[k] || !w->goal[k] || !w->made[k])
            return false;
    }
    return true;
}

static enum status io_fault(struct fault *fault, const char *path)
{
    snprintf(fault->text, sizeof fault->text, "cannot write %.300s: %s", path,
             strerror(errno));
    return STATUS_IO;
}

static bool has_control(const char *name)
{
    for (; *name; name++)
        if ((unsigned char) *name < ' ' || *name == 0x7f)
            return true;
    return false;
}

enum status workshop_open(const char *path, struct workshop *w,
                          struct fault *fault)
{
    const char *slash = strrchr(path, '/');
    const char *base = slash ? slash + 1 : path;
    *w = WORKSHOP_EMPTY;
    if (has_control(base)) {
        snprintf(fault->text, sizeof fault->text,
                 "the name of the figure holds a control character");
        return STATUS_BAD_ARGUMENT;
    }
    char *folder =
        workshop_join(path, (size_t) (base - path), ".figure-XXXXXX");
    if (!folder)
        return STATUS_NO_MEMORY;
    if (!mkdtemp(folder)) {
        free(folder);
        return io_fault(fault, path);
    }
    w->folder = folder;
    litter_add(folder);
    if (name_files(w, path, base)) {
        for (int k = 0; k < WORKSHOP_FILES; k++)
            litter_add(w->made[k]);
        return STATUS_OK;
    }
    workshop_close(w);
    return STATUS_NO_MEMORY;
}

enum status workshop_deliver(const struct workshop *w, enum workshop_file which,
                             struct fault *fault)
{
    if (rename(w->made[which], w->goal[which]) != 0)
        return io_fault(fault, w->goal[which]);
    return STATUS_OK;
}

void workshop_close(struct workshop *w)
{
    for (int k = 0; k < WORKSHOP_FILES; k++) {
        if (w->made[k])
            unlink(w->made[k]);
        litter_drop(w->made[k]);
        free(w->name[k]);
        free(w->made[k]);
        free(w->goal[k]);
    }
    if (w->folder)
        rmdir(w->folder);
    litter_drop(w->folder);
    free(w->folder);
    *w = WORKSHOP_EMPTY;
}
