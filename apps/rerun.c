/* The file may be anyone's: children read it (child.h).  What they bring back
 * is text: the command, the scene and the overrides; then what differs. */
#include "rerun.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "child.h"
#include "json.h"
#include "litter.h"
#include "origin.h"
#include "replace.h"
#include "store_compare.h"
#include "text.h"
#include "tolerance.h"

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
    if (strcmp(name, "push") == 0) {
        snprintf(why->text, sizeof why->text,
                 "%.300s: a file of push has its states in /push, not in its "
                 "scene, expected push --states",
                 path);
        return STATUS_BAD_ARGUMENT;
    }
    if (strcmp(name, "stress") != 0 && strcmp(name, "workprec") != 0)
        return STATUS_OK;
    snprintf(why->text, sizeof why->text,
             "%.300s: a file of %s holds times, which no second run repeats",
             path, name);
    return STATUS_BAD_ARGUMENT;
}

static enum status read_file(struct rerun *r, struct fault *why)
{
    const enum status s = origin_read(r->given, check_command, &r->origin, why);

    if (s != STATUS_OK)
        return s;
    r->command = command_find(r->origin.command);
    if (r->command)
        return STATUS_OK;
    snprintf(why->text, sizeof why->text, "%.300s: damaged", r->given);
    return STATUS_IO;
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
        snprintf(why->text, sizeof why->text, "%s: cannot make a folder there",
                 base);
        return STATUS_IO;
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
    snprintf(why->text, sizeof why->text, "%.300s: too many overrides",
             r->given);
    return STATUS_BAD_ARGUMENT;
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

enum exit_code rerun(const struct options *o)
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
