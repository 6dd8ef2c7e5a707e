/* slipway info: what a result file holds; and its scene back. */
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "json.h"
#include "library.h"
#include "merge.h"
#include "rerun.h"
#include "store_read.h"

struct listing {
    json_t *list;  /* NULL: print */
    bool of_group; /* texts that come now are a group's */
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

/* Texts of a group, such as the version; of a data set its comment, which says
 * why a number is absent.  Long ones (the scene) are left to 'info scene'. */
static void print_text(const struct store_item *item, bool of_group)
{
    if (strchr(item->text, '\n') || item->text[0] == '\0')
        return;
    if (of_group)
        printf("  %-22s %s\n", item->key, item->text);
    else if (strcmp(item->key, "comment") == 0)
        printf("  %-22s (%s)\n", "", item->text);
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
    json_object_set_new(j, "texts", json_object());
    json_array_append_new(list, j);
}

/* Texts follow what they belong to. */
static void add_text(json_t *list, const struct store_item *item)
{
    json_t *last = json_array_get(list, json_array_size(list) - 1);

    json_object_set_new(json_object_get(last, "texts"), item->key,
                        json_string(item->text));
}

static int visit(void *ctx, const struct store_item *item)
{
    struct listing *l = ctx;

    if (item->kind != STORE_TEXT)
        l->of_group = item->kind == STORE_GROUP;
    if (l->list && item->kind == STORE_TEXT)
        add_text(l->list, item);
    else if (l->list)
        add_item(l->list, item);
    else if (item->kind == STORE_TEXT)
        print_text(item, l->of_group);
    else
        print_item(item);
    return 0;
}

/* One scene that makes this file again, overrides included. */
static enum exit_code print_scene(struct store *file)
{
    struct fault why = { "" };
    char *text = NULL, *overrides = NULL, *scene = NULL;

    enum status s = store_read_text(file, "/provenance", "scene", &text, &why);
    if (s == STATUS_OK)
        s = store_read_text(file, "/provenance", "overrides", &overrides, &why);
    if (s == STATUS_OK)
        s = scene_merge(text, overrides, &scene, &why);
    if (s == STATUS_OK)
        fputs(scene, stdout);
    free(text);
    free(overrides);
    free(scene);
    return s == STATUS_OK ? EXIT_DONE : command_fail(s, why.text);
}

enum exit_code command_info(const struct options *o)
{
    struct fault why = { "" };
    struct store *file = NULL;
    struct listing l = { .list = NULL };
    const bool scene = o->files == 2 && strcmp(o->file[1], "scene") == 0;

    if (o->files == 0 || (o->files > 1 && !scene))
        return command_fail(STATUS_BAD_SCENE,
                            "info: expected FILE.h5, then perhaps 'scene'");
    if (o->rerun)
        return command_allow(o, 1) ? EXIT_USAGE : rerun(o);
    store_silence();
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
            code = json_print(json_incref(l.list)) ? EXIT_DONE
                                                   : command_unwritten();
        json_decref(l.list);
    }
    store_free(&file);
    return code;
}
