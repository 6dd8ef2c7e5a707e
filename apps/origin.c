#include "origin.h"

#include <stdlib.h>
#include <string.h>

#include "child.h"
#include "store_read.h"
#include "tolerance.h"

struct look {
    const char *path;
    origin_suits *suits;
};

/* In the child: command, scene and overrides, a zero after each. */
static enum status look(void *ctx, FILE *out, struct fault *why)
{
    static const char *const key[] = { "command", "scene", "overrides" };
    const struct look *l = ctx;
    struct store *file = NULL;
    enum status s = store_open(l->path, &file, why);

    for (int i = 0; i < 3 && s == STATUS_OK; i++) {
        char *text = NULL;
        s = store_read_text(file, "/provenance", key[i], &text, why);
        if (s == STATUS_OK && i == 0)
            s = l->suits(l->path, text, why);
        if (s == STATUS_OK)
            fwrite(text, 1, strlen(text) + 1, out);
        free(text);
    }
    store_free(&file);
    return s;
}

/* The text at *at, which is moved past it; NULL at the end. */
static char *next_text(char **at, const char *end)
{
    char *text = *at;

    if (text >= end)
        return NULL;
    *at += strlen(text) + 1;
    return text;
}

enum status origin_read(const char *path, origin_suits *suits,
                        struct origin *out, struct fault *why)
{
    struct look l = { path, suits };
    struct origin o = { .held = NULL };
    size_t size;

    *out = o;
    store_silence();
    const enum status s =
        child_read(look, &l, path, CHILD_LIST_SECONDS, &o.held, &size, why);
    if (s != STATUS_OK)
        return s;
    char *at = o.held;
    o.command = next_text(&at, o.held + size);
    o.scene = next_text(&at, o.held + size);
    o.overrides = next_text(&at, o.held + size);
    if (o.overrides) {
        *out = o;
        return STATUS_OK;
    }
    free(o.held);
    return fault_set(why, STATUS_IO, "%.300s: damaged", path);
}
