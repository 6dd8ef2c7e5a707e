#include "rerun.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "json.h"
#include "library.h"
#include "replace.h"
#include "scene.h"
#include "store_compare.h"
#include "store_read.h"

enum { FOLDER = 256, PATH = FOLDER + 32 };

struct rerun {
    const struct options *options;
    const char *given;                 /* the file */
    const char *command;               /* that makes it again; static */
    char *scene, *overrides;           /* owned; of its provenance */
    char folder[FOLDER];               /* owned; "" until made */
    char scene_path[PATH], path[PATH]; /* in there */
};

/* ---- what made the file ----------------------------------------------------
 */

/* Commands whose files are told by a group. */
static int visit(void *ctx, const struct store_item *item)
{
    static const char *const mark[][2] = {
        { "/sweep", "sweep" },
        { "/rabinowicz", "rabinowicz" },
        { "/trajectory_0/summary", "simulate" },
        { "/stress", "stress" },
        { "/workprec", "workprec" },
    };
    struct rerun *r = ctx;

    for (size_t i = 0; i < sizeof mark / sizeof *mark; i++)
        if (item->kind == STORE_GROUP && strcmp(item->path, mark[i][0]) == 0)
            r->command = mark[i][1];
    return 0;
}

static enum status check_command(const struct rerun *r, struct fault *why)
{
    if (strcmp(r->command, "stress") != 0 &&
        strcmp(r->command, "workprec") != 0)
        return STATUS_OK;
    snprintf(why->text, sizeof why->text,
             "%.300s: a file of %s holds times, which no second run repeats",
             r->given, r->command);
    return STATUS_BAD_ARGUMENT;
}

static enum status read_file(struct rerun *r, struct fault *why)
{
    struct store *file = NULL;
    enum status s = store_open(r->given, &file, why);

    if (s == STATUS_OK)
        s = store_visit(file, visit, r, why);
    if (s == STATUS_OK)
        s = check_command(r, why);
    if (s == STATUS_OK)
        s = store_read_text(file, "/provenance", "scene", &r->scene, why);
    if (s == STATUS_OK)
        s = store_read_text(file, "/provenance", "overrides", &r->overrides,
                            why);
    store_free(&file);
    return s;
}

/* ---- making it again -------------------------------------------------------
 */

static enum status make_folder(struct rerun *r, struct fault *why)
{
    const char *base = getenv("TMPDIR");

    if (base == NULL || base[0] == '\0' || strlen(base) > FOLDER - 32 ||
        strchr(base, '\'')) /* it becomes a quoted text */
        base = "/tmp";
    snprintf(r->folder, FOLDER, "%s/slipway-XXXXXX", base);
    if (mkdtemp(r->folder) == NULL) {
        r->folder[0] = '\0';
        snprintf(why->text, sizeof why->text, "%s: cannot make a folder there",
                 base);
        return STATUS_IO;
    }
    snprintf(r->path, PATH, "%s/again.h5", r->folder);
    snprintf(r->scene_path, PATH, "%s/scene.yaml", r->folder);
    return r->scene[0]
               ? replace_file(r->scene_path, r->scene, strlen(r->scene), why)
               : STATUS_OK;
}

/* The stored overrides, and the output in place of the scene's own; all
 * borrowed. */
static enum status set_options(const struct rerun *r, struct options *o,
                               char *output, struct fault *why)
{
    char *line = r->overrides;

    *o = (struct options){ .command = r->command,
                           .threads = r->options->threads,
                           .progress = r->options->progress,
                           .quiet = true };
    if (r->scene[0])
        o->file[o->files++] = r->scene_path;
    while (*line && o->sets < OPTIONS_SETS - 1) {
        char *end = line + strcspn(line, "\n");
        o->set[o->sets++] = line;
        line = *end ? end + 1 : end;
        *end = '\0';
    }
    o->set[o->sets++] = output;
    if (*line == '\0')
        return STATUS_OK;
    snprintf(why->text, sizeof why->text, "%.300s: too many overrides",
             r->given);
    return STATUS_BAD_ARGUMENT;
}

/* A scene with a sweep that made a file without one was not run by `study`,
 * which would sweep; portrait adds nothing to what the file names. */
static enum status choose_study(struct rerun *r, const struct options *o,
                                struct fault *why)
{
    struct scene scene;
    const enum status s =
        scene_read(&scene, o->files ? o->file[0] : NULL, o->set, o->sets, why);

    if (s != STATUS_OK)
        return s;
    r->command = scene.sweep.axes > 0 ? "portrait" : "study";
    scene_free(&scene);
    return STATUS_OK;
}

/* The command complains itself. */
static enum exit_code run_again(struct rerun *r)
{
    struct fault why = { "" };
    struct options o = { .sets = 0 };
    char output[PATH + 32];
    const char *nearest;

    enum status s = make_folder(r, &why);
    snprintf(output, sizeof output, "output={hdf5: '%s'}", r->path);
    if (s == STATUS_OK)
        s = set_options(r, &o, output, &why);
    if (s == STATUS_OK && strcmp(r->command, "study") == 0)
        s = choose_study(r, &o, &why);
    o.command = r->command;
    const struct command *c = command_find(r->command, &nearest);
    const enum exit_code code =
        s == STATUS_OK ? c->run(&o) : command_fail(s, why.text);
    return code;
}

/* ---- comparing -------------------------------------------------------------
 */

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

static void print_difference(void *ctx, const struct store_difference *d)
{
    const struct options *o = ctx;

    if (!o->quiet)
        printf("%s%s%s: %s\n", d->path, d->key[0] ? " " : "", d->key, d->what);
}

static void list_difference(void *list, const struct store_difference *d)
{
    json_t *j = json_object();

    json_object_set_new(j, "path", json_string(d->path));
    json_object_set_new(j, "key", json_string(d->key));
    json_object_set_new(j, "what", json_string(d->what));
    json_array_append_new(list, j);
}

static enum status compare(const struct rerun *r, json_t *list,
                           struct fault *why)
{
    struct store *before = NULL, *now = NULL;
    struct options options = *r->options;
    enum status s = store_open(r->given, &before, why);

    if (s == STATUS_OK)
        s = store_open(r->path, &now, why);
    if (s == STATUS_OK && list)
        s = store_compare(before, now, list_difference, list, why);
    else if (s == STATUS_OK)
        s = store_compare(before, now, print_difference, &options, why);
    store_free(&before);
    store_free(&now);
    return s;
}

static bool print_json(bool same, json_t *list)
{
    json_t *j = json_object();

    json_object_set_new(j, "same_bytes", json_boolean(same));
    json_object_set_new(j, "differences", json_incref(list));
    return json_print(j);
}

static enum exit_code judge(const struct rerun *r)
{
    struct fault why = { "" };
    const bool same = same_bytes(r->given, r->path);
    json_t *list = r->options->json ? json_array() : NULL;
    const enum status s = same ? STATUS_OK : compare(r, list, &why);
    enum exit_code code = same ? EXIT_DONE : EXIT_CHECK;

    if (s != STATUS_OK)
        code = command_fail(s, why.text);
    else if (list && !print_json(same, list))
        code = command_unwritten();
    else if (!list && same && !r->options->quiet)
        printf("same bytes\n");
    else if (!list && !same && !r->options->quiet)
        printf("not the same bytes\n");
    json_decref(list);
    return code;
}

/* ---- the whole -------------------------------------------------------------
 */

static void clean_up(struct rerun *r)
{
    if (r->folder[0]) {
        unlink(r->path);
        unlink(r->scene_path);
        rmdir(r->folder);
    }
    free(r->scene);
    free(r->overrides);
}

enum exit_code rerun(const struct options *o)
{
    struct rerun r = { .options = o, .given = o->file[0], .command = "study" };
    struct fault why = { "" };

    store_silence();
    const enum status s = read_file(&r, &why);
    enum exit_code code =
        s == STATUS_OK ? run_again(&r) : command_fail(s, why.text);
    if (code == EXIT_DONE)
        code = judge(&r);
    clean_up(&r);
    return code;
}
