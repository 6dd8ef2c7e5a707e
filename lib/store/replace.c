#include "replace.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "litter.h"

enum { NAME_ROOM = 64, NAMES_MAX = 1000 };

struct place {
    char target[PATH_MAX]; /* symbolic links followed */
    char folder[PATH_MAX];
    char temporary[PATH_MAX + NAME_ROOM];
};

struct replacing {
    struct place place;
    int fd;
};

static enum status replace_blame(const char *path, const char *why,
                                 struct fault *fault)
{
    snprintf(fault->text, sizeof fault->text, "%.300s: %s", path, why);
    return STATUS_IO;
}

/* Zero, or the errno that says why there is no such place. */
static int place_find(const char *path, struct place *p)
{
    const char *slash;

    if (realpath(path, p->target) == NULL) {
        if (errno != ENOENT || path[0] == '\0')
            return errno;
        if (strlen(path) >= sizeof p->target)
            return ENAMETOOLONG;
        strcpy(p->target, path);
    }
    slash = strrchr(p->target, '/');
    if (slash == NULL) {
        strcpy(p->folder, ".");
        return 0;
    }
    const size_t length = slash == p->target ? 1 : (size_t) (slash - p->target);
    memcpy(p->folder, p->target, length);
    p->folder[length] = '\0';
    return 0;
}

/* Zero, or the errno that says why the folder is not there, nor can be. */
static int folder_check(const char *folder)
{
    char path[PATH_MAX];
    char *slash;

    strcpy(path, folder);
    while (faccessat(AT_FDCWD, path, W_OK | X_OK, AT_EACCESS) != 0) {
        if (errno != ENOENT || strcmp(path, ".") == 0)
            return errno;
        slash = strrchr(path, '/');
        if (slash == NULL)
            strcpy(path, ".");
        else
            slash[slash == path] = '\0';
    }
    return 0;
}

static int folder_make(const char *folder)
{
    char path[PATH_MAX];

    strcpy(path, folder);
    for (char *end = path + 1; path[0]; end++) {
        const char was = *end;
        if (was != '/' && was != '\0')
            continue;
        *end = '\0';
        if (access(path, F_OK) != 0 && mkdir(path, 0777) != 0 &&
            errno != EEXIST)
            return errno;
        *end = was;
        if (was == '\0')
            break;
    }
    return 0;
}

/* NULL, or why this place takes no file. */
static const char *place_refuses(const struct place *p)
{
    struct stat about;

    if (stat(p->target, &about) == 0 && !S_ISREG(about.st_mode))
        return S_ISDIR(about.st_mode) ? strerror(EISDIR) : "not a regular file";
    const int error = folder_check(p->folder);
    return error ? strerror(error) : NULL;
}

static int open_new(const char *name, int fd)
{
    (void) fd;
    return open(name, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

/* /proc names files without a name, and asks for no privileges. */
static int link_new(const char *name, int fd)
{
    char from[32];

    snprintf(from, sizeof from, "/proc/self/fd/%d", fd);
    return linkat(AT_FDCWD, from, AT_FDCWD, name, AT_SYMLINK_FOLLOW);
}

/* What `make` makes under the first name that nobody has, or -1 and errno;
 * p->temporary is then empty. */
static int make_temporary(struct place *p, int (*make)(const char *, int),
                          int fd)
{
    for (int k = 0; k < NAMES_MAX; k++) {
        snprintf(p->temporary, sizeof p->temporary, "%s/.slipway-%ld-%d.tmp",
                 p->folder, (long) getpid(), k);
        const int made = make(p->temporary, fd);
        if (made >= 0)
            return made;
        if (errno != EEXIST)
            break;
    }
    p->temporary[0] = '\0';
    return -1;
}

/* A descriptor of a file nobody else has, or -1 and errno.  Where the system
 * can, it has no name yet: a kill while it is written leaves nothing. */
static int open_temporary(struct place *p)
{
    const int fd = access("/proc/self/fd", X_OK) == 0
                       ? open(p->folder, O_RDWR | O_TMPFILE | O_CLOEXEC, 0666)
                       : -1;

    p->temporary[0] = '\0';
    return fd >= 0 ? fd : make_temporary(p, open_new, -1);
}

static int write_all(int fd, const char *bytes, size_t size)
{
    while (size > 0) {
        const ssize_t took = write(fd, bytes, size);
        if (took < 0 && errno == EINTR)
            continue;
        if (took <= 0)
            return took < 0 ? errno : ENOSPC;
        bytes += took;
        size -= (size_t) took;
    }
    return 0;
}

static int sync_all(int fd)
{
    while (fsync(fd) != 0)
        if (errno != EINTR)
            return errno;
    return 0;
}

static int begin_at(struct place *p, int *fd)
{
    const int error = folder_make(p->folder);

    *fd = error == 0 ? open_temporary(p) : -1;
    if (*fd < 0)
        return error ? error : errno;
    litter_add(p->temporary);
    return 0;
}

/* Into place, or gone where there was an error. */
static int end_at(struct place *p, int fd, int error)
{
    if (error == 0)
        error = sync_all(fd);
    if (error == 0 && p->temporary[0] == '\0' &&
        make_temporary(p, link_new, fd) != 0)
        error = errno;
    if (close(fd) != 0 && error == 0)
        error = errno;
    if (error == 0 && rename(p->temporary, p->target) != 0)
        error = errno;
    if (error != 0 && p->temporary[0] != '\0')
        unlink(p->temporary);
    litter_drop(p->temporary);
    return error;
}

static enum status replace_find(const char *path, struct place *p,
                                struct fault *fault)
{
    const int error = place_find(path, p);
    const char *why = error != 0 ? strerror(error) : place_refuses(p);

    return why == NULL ? STATUS_OK : replace_blame(path, why, fault);
}

enum status replace_check(const char *path, struct fault *fault)
{
    struct place p;

    return replace_find(path, &p, fault);
}

enum status replace_folder(const char *path, struct fault *fault)
{
    struct place p;
    const enum status s = replace_find(path, &p, fault);
    const int error = s == STATUS_OK ? folder_make(p.folder) : 0;

    return error ? replace_blame(path, strerror(error), fault) : s;
}

enum status replace_begin(const char *path, struct replacing **out,
                          struct fault *fault)
{
    struct replacing *r = malloc(sizeof *r);

    *out = NULL;
    if (r == NULL)
        return STATUS_NO_MEMORY;
    const enum status s = replace_find(path, &r->place, fault);
    const int error = s == STATUS_OK ? begin_at(&r->place, &r->fd) : 0;
    if (s == STATUS_OK && error == 0) {
        *out = r;
        return STATUS_OK;
    }
    free(r);
    return error ? replace_blame(path, strerror(error), fault) : s;
}

int replace_descriptor(const struct replacing *r)
{
    return r->fd;
}

enum status replace_end(struct replacing **of, int error, const char *path,
                        struct fault *fault)
{
    if (*of == NULL)
        return STATUS_OK;
    error = end_at(&(*of)->place, (*of)->fd, error);
    free(*of);
    *of = NULL;
    return error == 0 ? STATUS_OK : replace_blame(path, strerror(error), fault);
}

enum status replace_file(const char *path, const void *bytes, size_t size,
                         struct fault *fault)
{
    struct place p;
    const enum status s = replace_find(path, &p, fault);
    int fd;

    if (s != STATUS_OK)
        return s;
    int error = begin_at(&p, &fd);
    if (error == 0)
        error = end_at(&p, fd, write_all(fd, bytes, size));
    return error == 0 ? STATUS_OK : replace_blame(path, strerror(error), fault);
}
