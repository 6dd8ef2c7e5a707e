/* slipway info: what a result file holds; and its scene back.  The file may be
 * anyone's: a child reads it (child.h). */
#include <stdlib.h>
#include <string.h>

#include "child.h"
#include "command.h"
#include "document.h"
#include "json.h"
#include "merge.h"
#include "rerun.h"
#include "store_read.h"
#include "tolerance.h"

struct listing {
    const char *path; /* of the file */
    bool as_json;
    FILE *out;     /* where to print, or */
    json_t *list;  /* where to add */
    bool of_group; /* texts that come now are a group's */
};

/* What a file says must not command the terminal; what is longer is cut. */
struct shown {
    char text[4096];
};

static struct shown shown(const char *text)
{
    struct shown s;

    text_show(text, s.text, sizeof s.text);
    return s;
}

static void print_item(FILE *out, const struct store_item *item)
{
    if (item->kind == STORE_GROUP) {
        fprintf(out, "%s\n", shown(item->path).text);
        return;
    }
    const char *name = strrchr(item->path, '/') + 1;
    char shape[64] = "";
    for (int i = 0; i < item->rank && strlen(shape) < 40; i++)
        snprintf(shape + strlen(shape), sizeof shape - strlen(shape), "%s%llu",
                 i ? " x " : "", (unsigned long long) item->extent[i]);
    fprintf(out, "  %-22s %-14s %-6s %s\n", shown(name).text,
            item->rank ? shape : "scalar", shown(item->units).text,
            shown(item->long_name).text);
}

/* Texts of a group, such as the version; of a data set its comment, which says
 * why a number is absent.  Long ones (the scene) are left to 'info scene'. */
static void print_text(FILE *out, const struct store_item *item, bool of_group)
{
    if (strchr(item->text, '\n') || item->text[0] == '\0')
        return;
    if (of_group)
        fprintf(out, "  %-22s %s\n", shown(item->key).text,
                shown(item->text).text);
    else if (strcmp(item->key, "comment") == 0)
        fprintf(out, "  %-22s (%s)\n", "", shown(item->text).text);
}

static void add_item(json_t *list, const struct store_item *item)
{
    json_t *shape = json_array();

    for (int i = 0; i < item->rank; i++)
        json_array_append_new(shape,
                              json_integer((json_int_t) item->extent[i]));
    json_array_append_new(
        list, json_pack("{s:o, s:s, s:o, s:o, s:o, s:{}}", "path",
                        json_text(item->path), "kind",
                        item->kind == STORE_GROUP ? "group" : "dataset",
                        "shape", shape, "units", json_text(item->units),
                        "long_name", json_text(item->long_name), "texts"));
}

/* Texts follow what they belong to. */
static void add_text(json_t *list, const struct store_item *item)
{
    json_t *last = json_array_get(list, json_array_size(list) - 1);

    json_object_set_new(json_object_get(last, "texts"), item->key,
                        json_text(item->text));
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
        print_text(l->out, item, l->of_group);
    else
        print_item(l->out, item);
    return 0;
}

/* In the child. */
static enum status list_items(void *ctx, FILE *out, struct fault *why)
{
    struct listing *l = ctx;
    struct store *file = NULL;

    l->out = out;
    l->list = l->as_json ? json_array() : NULL;
    store_silence();
    enum status s = store_open(l->path, &file, why);
    if (s == STATUS_OK)
        s = store_visit(file, visit, l, why);
    store_free(&file);
    if (s == STATUS_OK && l->as_json && !json_write(json_incref(l->list), out))
        s = STATUS_NO_MEMORY;
    json_decref(l->list);
    return s;
}

/* ---- the scene ----------------------------------------------------------- */

/* One scene that makes this file again, overrides included; what is no YAML is
 * none. */
static enum status merge(const char *text, const char *overrides, char **scene,
                         struct fault *why)
{
    struct node *root = NULL;
    const enum status s =
        document_read(text, strlen(text), "scene", &root, why);

    node_free(root);
    return s == STATUS_OK ? scene_merge(text, overrides, scene, why) : s;
}

/* In the child. */
static enum status read_scene(void *ctx, FILE *out, struct fault *why)
{
    const struct listing *l = ctx;
    struct store *file = NULL;
    char *text = NULL, *overrides = NULL, *scene = NULL;

    store_silence();
    enum status s = store_open(l->path, &file, why);
    if (s == STATUS_OK)
        s = store_read_text(file, "/provenance", "scene", &text, why);
    if (s == STATUS_OK)
        s = store_read_text(file, "/provenance", "overrides", &overrides, why);
    if (s == STATUS_OK)
        s = merge(text, overrides, &scene, why);
    if (s == STATUS_OK)
        fputs(scene, out);
    store_free(&file);
    free(text);
    free(overrides);
    free(scene);
    return s;
}

/* ---- the command --------------------------------------------------------- */

enum exit_code command_info(const struct options *o)
{
    const bool scene = o->files == 2 && strcmp(o->file[1], "scene") == 0;
    struct fault why = { "" };
    char *text;
    size_t size;

    if (o->files == 0 || (o->files > 1 && !scene))
        return command_fail(STATUS_BAD_SCENE,
                            "info: expected FILE.h5, then perhaps 'scene'");
    if (scene && (o->rerun || o->json))
        return command_fail(STATUS_BAD_ARGUMENT,
                            "info: a scene is printed as YAML, expected no "
                            "--json or --rerun beside it");
    if (o->rerun)
        return rerun(o);
    if (o->quiet || o->progress || o->threads)
        return command_fail(STATUS_BAD_ARGUMENT,
                            "info: --quiet, --progress, --threads: expected "
                            "with --rerun only");
    struct listing l = { .path = o->file[0], .as_json = o->json };
    const enum status s =
        child_read(scene ? read_scene : list_items, &l, l.path,
                   CHILD_LIST_SECONDS, &text, &size, &why);
    if (s != STATUS_OK)
        return command_fail(s, why.text);
    fwrite(text, 1, size, stdout); /* main() asks whether it arrived */
    free(text);
    return EXIT_DONE;
}
