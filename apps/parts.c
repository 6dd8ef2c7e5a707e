#include "parts.h"

#include <dirent.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "room.h"

enum { SHARES_MAX = 1000000, ENDING = 64 };

/* "3/8" or "3-of-8", whichever the separator says, and nothing behind it. */
static bool read_part(const char *text, const char *between, struct part *out)
{
    char again[ENDING];
    struct part p;
    char format[32];

    snprintf(format, sizeof format, "%%zu%s%%zu", between);
    if (sscanf(text, format, &p.share, &p.shares) != 2 || p.share < 1 ||
        p.share > p.shares || p.shares > SHARES_MAX)
        return false;
    snprintf(again, sizeof again, format, p.share, p.shares);
    *out = p;
    return strcmp(again, text) == 0;
}

enum status part_parse(const char *text, struct part *out, struct fault *why)
{
    if (read_part(text, "/", out))
        return STATUS_OK;
    return fault_set(
        why, STATUS_BAD_ARGUMENT,
        "--shard %.40s: expected I/N with 1 <= I <= N, such as 3/8", text);
}

char *part_path(const char *path, struct part part)
{
    const size_t size = strlen(path) + ENDING;
    char *out = malloc(size);

    if (out)
        snprintf(out, size, "%s.%zu-of-%zu", path, part.share, part.shares);
    return out;
}

/* ---- those that are there ------------------------------------------------ */

static int compare(const void *a, const void *b)
{
    const struct part *p = a, *q = b;

    if (p->shares != q->shares)
        return p->shares < q->shares ? -1 : 1;
    return (p->share > q->share) - (p->share < q->share);
}

/* Notes the file of that name, if it is a share's. */
static enum status look(struct parts *p, const char *base, const char *name)
{
    const size_t n = strlen(base);
    struct part part;

    if (strncmp(name, base, n) != 0 || name[n] != '.' ||
        !read_part(name + n + 1, "-of-", &part))
        return STATUS_OK;
    const enum status status = ROOM_FOR(p->part, p->room, p->count + 1);
    if (status == STATUS_OK)
        p->part[p->count++] = part;
    return status;
}

/* By N, then by K. */
static enum status name_all(struct parts *p, const char *path)
{
    enum status status = STATUS_OK;

    if (p->count > 0)
        qsort(p->part, p->count, sizeof *p->part, compare);
    p->path = calloc(p->count + 1, sizeof *p->path);
    for (size_t i = 0; p->path && i < p->count; i++) {
        p->path[i] = part_path(path, p->part[i]);
        status = p->path[i] ? status : STATUS_NO_MEMORY;
    }
    return p->path ? status : STATUS_NO_MEMORY;
}

enum status parts_find(const char *path, struct parts *out)
{
    const char *slash = strrchr(path, '/');
    char *folder =
        slash ? strndup(path, (size_t) (slash - path) + 1) : strdup("./");
    DIR *all = folder ? opendir(folder) : NULL;
    enum status status = folder ? STATUS_OK : STATUS_NO_MEMORY;

    *out = (struct parts){ .path = NULL };
    for (struct dirent *e; all && status == STATUS_OK && (e = readdir(all));)
        status = look(out, slash ? slash + 1 : path, e->d_name);
    if (all)
        closedir(all);
    free(folder);
    if (status == STATUS_OK)
        status = name_all(out, path);
    if (status != STATUS_OK)
        parts_free(out);
    return status;
}

enum status parts_check(const struct parts *p, const char *path,
                        struct fault *why)
{
    struct part want = { 1, 1 };

    for (size_t i = 0; i < p->count; i++) {
        if (want.share == 1)
            want.shares = p->part[i].shares;
        if (compare(&want, &p->part[i]) != 0)
            break;
        want.share = want.share == want.shares ? 1 : want.share + 1;
    }
    if (p->count > 0 && want.share == 1)
        return STATUS_OK;
    char *missing = part_path(path, want);
    if (p->count == 0)
        snprintf(why->text, sizeof why->text,
                 "%.300s: no share of it is there, expected %.40s.1-of-N and "
                 "so on (--shard 1/N)",
                 path, strrchr(path, '/') ? strrchr(path, '/') + 1 : path);
    else
        snprintf(why->text, sizeof why->text,
                 "%.300s: not there, expected one of each share",
                 missing ? missing : path);
    free(missing);
    return STATUS_BAD_SCENE;
}

void parts_forget(const struct parts *p)
{
    for (size_t i = 0; i < p->count; i++)
        (void) unlink(p->path[i]);
}

void parts_free(struct parts *p)
{
    for (size_t i = 0; p->path && i < p->count; i++)
        free(p->path[i]);
    free(p->path);
    free(p->part);
    *p = (struct parts){ .path = NULL };
}
