/* slipway info: what a result file holds; and its scene back.  The file may be
 * anyone's: a child reads it (child.h). */
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "child.h"
#include "command.h"
#include "document.h"
#include "json.h"
#include "litter.h"
#include "merge.h"
#include "origin.h"
#include "replace.h"
#include "store_compare.h"
#include "store_read.h"
#include "text.h"
#include "tolerance.h"

/* ---- rerun --------------------------------------------------------------- */

/* The file may be anyone's: children read it (child.h).  What they bring back
 * is text: the command, the scene and the overrides; then what differs. */

enum { FOLDER = 256, PATH = FOLDER + 32 };

struct rerun {
    const struct options *options;
    const char *given;                 /* the file */
    const struct command *command;     /* that makes it again */
    struct origin origin;              /* of it; owned */
    char folder[FOLDER];               /* owned; "" until made */
    char scene_path[PATH], path[PATH]; /* in there */
    const char *scene_file;            /* the former */
};

/* ---- what made the file -------------------------------------------------- */

static enum status check_command(const char *path, const char *name,
                                 struct fault *why)
{
    if (strcmp(name, "push") == 0)
        return fault_set(
            why, STATUS_BAD_ARGUMENT,
            "%.300s: a file of push has its states in /push, not in its "
            "scene, expected push --states",
            path);
    if (strcmp(name, "stress") != 0 && strcmp(name, "workprec") != 0)
        return STATUS_OK;
    return fault_set(
        why, STATUS_BAD_ARGUMENT,
        "%.300s: a file of %s holds times, which no second run repeats", path,
        name);
}

static enum status read_file(struct rerun *r, struct fault *why)
{
    const enum status s = origin_read(r->given, check_command, &r->origin, why);

    if (s != STATUS_OK)
        return s;
    r->command = command_find(r->origin.command);
    if (r->command)
        return STATUS_OK;
    return fault_set(why, STATUS_IO, "%.300s: damaged", r->given);
}

/* ---- making it again ----------------------------------------------------- */

static enum status make_folder(struct rerun *r, struct fault *why)
{
    const char *base = getenv("TMPDIR");

    if (base == NULL || base[0] == '\0' || strlen(base) > FOLDER - 32 ||
        strchr(base, '\'')) /* it becomes a quoted text */
        base = "/tmp";
    snprintf(r->folder, FOLDER, "%s/slipway-XXXXXX", base);
    if (mkdtemp(r->folder) == NULL) {
        r->folder[0] = '\0';
        return fault_set(why, STATUS_IO, "%s: cannot make a folder there",
                         base);
    }
    snprintf(r->path, PATH, "%s/again.h5", r->folder);
    snprintf(r->scene_path, PATH, "%s/scene.yaml", r->folder);
    litter_add(r->folder);
    litter_add(r->path);
    litter_add(r->scene_path);
    return r->origin.scene[0] ? replace_file(r->scene_path, r->origin.scene,
                                             strlen(r->origin.scene), why)
                              : STATUS_OK;
}

/* What the command prints is not wanted, but how far it is. */
static const char *progress_of(const struct options *o)
{
    return o->quiet || (o->progress && strcmp(o->progress, "auto") != 0)
               ? o->progress
               : "bar";
}

/* The stored overrides, and the output in place of the scene's own; all
 * borrowed. */
static enum status set_options(struct rerun *r, struct options *o, char *output,
                               struct fault *why)
{
    char *line = r->origin.overrides;

    *o = (struct options){ .command = r->command,
                           .file = &r->scene_file,
                           .threads = r->options->threads,
                           .progress = progress_of(r->options),
                           .quiet = true };
    r->scene_file = r->scene_path;
    o->files = r->origin.scene[0] != '\0';
    while (*line && o->sets < OPTIONS_SETS - 1) {
        char *end = line + strcspn(line, "\n");
        o->set[o->sets++] = line;
        line = *end ? end + 1 : end;
        *end = '\0';
    }
    o->set[o->sets++] = output;
    if (*line == '\0')
        return STATUS_OK;
    return fault_set(why, STATUS_BAD_ARGUMENT, "%.300s: too many overrides",
                     r->given);
}

/* The command complains itself. */
static enum exit_code run_again(struct rerun *r)
{
    struct fault why = { "" };
    struct options o = { .sets = 0 };
    char output[PATH + 32];

    enum status s = make_folder(r, &why);
    snprintf(output, sizeof output, "output={hdf5: '%s'}", r->path);
    if (s == STATUS_OK)
        s = set_options(r, &o, output, &why);
    if (s != STATUS_OK)
        return command_fail(s, why.text);
    return command_run(r->command, &o);
}

/* ---- comparing ----------------------------------------------------------- */

/* False also where one cannot be read: then store_open says why. */
static bool same_bytes(const char *a, const char *b)
{
    FILE *x = fopen(a, "rb"), *y = fopen(b, "rb");
    bool same = x && y;

    for (int c = 0; same && c != EOF;) {
        c = getc(x);
        same = c == getc(y);
    }
    same = same && !ferror(x) && !ferror(y);
    if (x)
        fclose(x);
    if (y)
        fclose(y);
    return same;
}

struct differences {
    const struct rerun *rerun;
    FILE *out;
    json_t *list; /* owned; NULL: print */
};

static void tell(void *ctx, const struct store_difference *d)
{
    const struct differences *all = ctx;
    char line[4096], text[4096];

    if (all->list) {
        json_array_append_new(all->list, json_pack("{s:o, s:o, s:o}", "path",
                                                   json_text(d->path), "key",
                                                   json_text(d->key), "what",
                                                   json_text(d->what)));
        return;
    }
    snprintf(line, sizeof line, "%s%s%s: %s", d->path, d->key[0] ? " " : "",
             d->key, d->what);
    text_show(line, text, sizeof text);
    if (!all->rerun->options->quiet)
        fprintf(all->out, "%s\n", text);
}

static bool write_json(bool same, json_t *list, FILE *out)
{
    return json_write(
        json_pack("{s:b, s:O}", "same_bytes", same, "differences", list), out);
}

/* In the child. */
static enum status compare(void *ctx, FILE *out, struct fault *why)
{
    const struct rerun *r = ctx;
    struct differences all = { r, out, r->options->json ? json_array() : NULL };
    struct store *before = NULL, *now = NULL;
    enum status s = store_open(r->given, &before, why);

    if (s == STATUS_OK)
        s = store_open(r->path, &now, why);
    if (s == STATUS_OK)
        s = store_compare(before, now, tell, &all, why);
    if (s == STATUS_OK && all.list && !write_json(false, all.list, out))
        s = STATUS_NO_MEMORY;
    if (s == STATUS_OK && !r->options->json && !r->options->quiet)
        fprintf(out, "not the same bytes\n");
    json_decref(all.list);
    store_free(&before);
    store_free(&now);
    return s;
}

static enum exit_code tell_same(const struct rerun *r)
{
    if (r->options->json) {
        json_t *none = json_array();
        const bool told = write_json(true, none, stdout);
        json_decref(none);
        return told ? EXIT_DONE : command_unwritten();
    }
    if (!r->options->quiet)
        printf("same bytes\n");
    return EXIT_DONE;
}

static void remove_folder(struct rerun *r)
{
    if (r->folder[0] == '\0')
        return;
    unlink(r->path);
    unlink(r->scene_path);
    rmdir(r->folder);
    litter_drop(r->path);
    litter_drop(r->scene_path);
    litter_drop(r->folder);
    r->folder[0] = '\0';
}

/* Prints when nothing is left to remove: a reader who goes away ends us. */
static enum exit_code judge(struct rerun *r)
{
    struct fault why = { "" };
    char *text;
    size_t size;

    if (same_bytes(r->given, r->path)) {
        remove_folder(r);
        return tell_same(r);
    }
    const enum status s = child_read(compare, r, r->given,
                                     CHILD_COMPARE_SECONDS, &text, &size, &why);
    remove_folder(r);
    if (s != STATUS_OK)
        return command_fail(s, why.text);
    const bool told = fwrite(text, 1, size, stdout) == size && !fflush(stdout);
    free(text);
    return told ? EXIT_CHECK : command_unwritten();
}

/* ---- the whole ----------------------------------------------------------- */

static enum exit_code rerun(const struct options *o)
{
    struct rerun r = { .options = o, .given = o->file[0] };
    struct fault why = { "" };

    store_silence();
    const enum status s = read_file(&r, &why);
    enum exit_code code =
        s == STATUS_OK ? run_again(&r) : command_fail(s, why.text);
    if (code == EXIT_DONE)
        code = judge(&r);
    remove_folder(&r);
    free(r.origin.held);
    return code;
}

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
