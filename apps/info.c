/* slipway info: what a result file holds; and its scene back. */
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "json.h"
#include "store_read.h"

struct listing {
    json_t *list; /* NULL: print */
};

static void print_item(const struct store_item *item)
{
    if (item->kind == STORE_GROUP) {
        printf("%s\n", item->path);
        return;
    }
    const char *name = strrchr(item->path, '/') + 1;
    char shape[64] = "";
    for (int i = 0; i < item->rank && strlen(shape) < 40; i++)
        snprintf(shape + strlen(shape), sizeof shape - strlen(shape), "%s%llu",
                 i ? " x " : "", (unsigned long long) item->extent[i]);
    printf("  %-22s %-14s %-6s %s\n", name, item->rank ? shape : "scalar",
           item->units, item->long_name);
}

static void add_item(json_t *list, const struct store_item *item)
{
    json_t *j = json_object(), *shape = json_array();

    for (int i = 0; i < item->rank; i++)
        json_array_append_new(shape,
                              json_integer((json_int_t) item->extent[i]));
    json_object_set_new(j, "path", json_string(item->path));
    json_object_set_new(
        j, "kind",
        json_string(item->kind == STORE_GROUP ? "group" : "dataset"));
    json_object_set_new(j, "shape", shape);
    json_object_set_new(j, "units", json_string(item->units));
    json_object_set_new(j, "long_name", json_string(item->long_name));
    json_array_append_new(list, j);
}

static int visit(void *ctx, const struct store_item *item)
{
    struct listing *l = ctx;

    if (item->kind == STORE_TEXT)
        return 0;
    if (l->list)
        add_item(l->list, item);
    else
        print_item(item);
    return 0;
}

static enum exit_code print_scene(struct store *file)
{
    struct fault why = { "" };
    char *text = NULL;
    const enum status s =
        store_read_text(file, "/provenance", "scene", &text, &why);

    if (s != STATUS_OK)
        return command_fail(s, why.text);
    fputs(text, stdout);
    free(text);
    return EXIT_DONE;
}

enum exit_code command_info(const struct options *o)
{
    struct fault why = { "" };
    struct store *file = NULL;
    struct listing l = { NULL };
    const bool scene = o->files == 2 && strcmp(o->file[1], "scene") == 0;

    if (o->files == 0 || (o->files > 1 && !scene))
        return command_fail(STATUS_BAD_SCENE,
                            "info: expected FILE.h5, then perhaps 'scene'");
    enum status s = store_open(o->file[0], &file, &why);
    if (s != STATUS_OK)
        return command_fail(s, why.text);
    enum exit_code code = EXIT_DONE;
    if (scene) {
        code = print_scene(file);
    } else {
        l.list = o->json ? json_array() : NULL;
        s = store_visit(file, visit, &l, &why);
        if (s != STATUS_OK)
            code = command_fail(s, why.text);
        else if (l.list)
            code = json_print(json_incref(l.list)) ? EXIT_DONE : EXIT_FILE;
        json_decref(l.list);
    }
    store_free(&file);
    return code;
}
