/* slipway gallery: every scene that draws a figure, each by the command it is
 * for, into one folder with a page of HTML. */
#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <libgen.h>
#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "command.h"
#include "json.h"
#include "progress.h"
#include "replace.h"
#include "scene.h"
#include "texts.h"

/* ---- one scene ----------------------------------------------------------- */

/* Where all of them come from and go; borrowed. */
struct gallery_place {
    const struct options *options;
    const char *scenes, *output; /* folders */
    const char *progress;        /* of each scene, an option's word */
};

enum { GALLERY_NAME = 256 };

struct gallery_entry {
    char path[PATH_MAX];      /* of the scene; given */
    char name[GALLERY_NAME];  /* of all its files; given */
    struct panel_names panel; /* its files are NAME, a panel, .svg, ... */
    struct scene scene;       /* owned */
    char *comment, *command;  /* owned: the scene's first comment, its lines
                                 joined; what makes the figure; or NULL */
    enum exit_code code;
};

/* FOLDER/NAME + ending; false if that is too long. */
static bool gallery_path(char out[PATH_MAX], const char *folder,
                         const char *name, const char *ending)
{
    return snprintf(out, PATH_MAX, "%s/%s%s", folder, name, ending) < PATH_MAX;
}

/* "output.hdf5='DIR/NAME.h5'"; owned. */
static char *output_set(const struct gallery_place *g,
                        const struct gallery_entry *e, const char *key,
                        const char *ending)
{
    char path[PATH_MAX];

    return gallery_path(path, g->output, e->name, ending)
               ? options_setting(key, path, true)
               : NULL;
}

/* Runs the scene's command with its figure as NAME.svg and the others. */
static enum exit_code run_scene(const struct gallery_place *g,
                                struct gallery_entry *e)
{
    const char *file[] = { e->path };
    struct options o = { .command = command_find(scene_command(&e->scene)),
                         .file = file,
                         .files = 1,
                         .quiet = true,
                         .keep_script = g->options->keep_script,
                         .also = { ".png", ".pdf" },
                         .drawn = &e->panel,
                         .progress = g->progress };
    char *own[] = { output_set(g, e, "output.hdf5", ".h5"),
                    output_set(g, e, "output.figure", ".svg") };
    enum exit_code code = EXIT_FILE;

    o.sets = g->options->sets;
    memcpy(o.set, g->options->set, o.sets * sizeof *o.set);
    const bool fits = o.sets + 2 <= OPTIONS_SETS && own[0] && own[1];
    for (int i = 0; fits && i < 2; i++)
        o.set[o.sets++] = own[i];
    if (fits)
        code = command_run(o.command, &o);
    else
        command_fail(STATUS_IO, "gallery: too many settings, or a long path");
    for (int i = 0; i < 2; i++)
        free(own[i]);
    return code;
}

/* The scene's first comment, its lines joined; owned. */
static char *first_comment(const char *text)
{
    char *out = calloc(strlen(text) + 1, 1), *end = out;

    while (out && *text == '#') {
        const size_t n = strcspn(text, "\n");
        const size_t from = strspn(text, "# ");
        if (end > out)
            *end++ = ' ';
        if (from < n) {
            memcpy(end, text + from, n - from);
            end += n - from;
        }
        text += n + (text[n] == '\n');
    }
    return out;
}

static enum exit_code copy_scene(const struct gallery_place *g,
                                 const struct gallery_entry *e)
{
    struct fault why = { "" };
    char path[PATH_MAX];

    if (!gallery_path(path, g->output, e->name, ".yaml"))
        return EXIT_FILE;
    const enum status s =
        replace_file(path, e->scene.text, strlen(e->scene.text), &why);
    return s == STATUS_OK ? EXIT_DONE : command_fail(s, why.text);
}

/* Runs the scene by the command it is for: NAME.svg, .png, .pdf, .h5 and the
 * scene itself as NAME.yaml.  A scene that draws nothing is not run and has no
 * panels; of one that fails the command has complained, and e->code says how.
 * The user's settings hold for every scene. */
static void gallery_build(const struct gallery_place *g,
                          struct gallery_entry *e)
{
    const struct options *o = g->options;
    struct fault why = { "" };
    const enum status s = scene_read(&e->scene, e->path, o->set, o->sets, &why);

    if (s != STATUS_OK) {
        e->scene = (struct scene){ .title = NULL };
        e->code = command_fail(s, why.text);
    }
    if (s == STATUS_OK && e->scene.figure) {
        e->code = run_scene(g, e);
        if (e->code == EXIT_DONE)
            e->code = copy_scene(g, e);
    }
    e->comment = first_comment(e->scene.text ? e->scene.text : "");
    if (asprintf(&e->command, "slipway %s %s", scene_command(&e->scene),
                 e->path) < 0)
        e->command = NULL;
}

/* A second call is harmless. */
static void gallery_entry_free(struct gallery_entry *e)
{
    free(e->comment);
    free(e->command);
    e->comment = e->command = NULL;
    scene_free(&e->scene);
}

/* ---- page ---------------------------------------------------------------- */

/* As text, also inside quotes. */
static void put_text(FILE *out, const char *text)
{
    for (; *text; text++)
        switch (*text) {
            case '&':
                fputs("&amp;", out);
                break;
            case '<':
                fputs("&lt;", out);
                break;
            case '>':
                fputs("&gt;", out);
                break;
            case '"':
                fputs("&quot;", out);
                break;
            default:
                fputc(*text, out);
        }
}

static void put_address(FILE *out, const char *name)
{
    for (; *name; name++)
        if (isalnum((unsigned char) *name) || strchr("._-", *name))
            fputc(*name, out);
        else
            fprintf(out, "%%%02X", (unsigned) (unsigned char) *name);
}

/* %t: a text; %a: a part of a file's address; %i: a size_t. */
static void put(FILE *out, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    for (; *format; format++)
        if (*format != '%')
            fputc(*format, out);
        else if (*++format == 't')
            put_text(out, va_arg(args, const char *));
        else if (*format == 'a')
            put_address(out, va_arg(args, const char *));
        else
            fprintf(out, "%zu", va_arg(args, size_t));
    va_end(args);
}

static void put_links(FILE *out, const struct gallery_entry *e, bool scripts)
{
    put(out,
        "<p><a href=\"./%a.yaml\">scene</a> · <a href=\"./%a.h5\">HDF5</a>",
        e->name, e->name);
    for (size_t i = 0; i < e->panel.count; i++) {
        const char *panel = e->panel.name[i];
        put(out,
            " · <a href=\"./%a%a.png\">PNG</a>, <a href=\"./%a%a.pdf\">PDF</a>",
            e->name, panel, e->name, panel);
        if (scripts)
            put(out,
                ", <a href=\"./%a%a.gp\">script</a>, "
                "<a href=\"./%a%a.dat\">data</a>",
                e->name, panel, e->name, panel);
    }
    put(out, "</p>\n");
}

static void put_figure(FILE *out, const struct gallery_entry *e, size_t number,
                       bool scripts)
{
    const char *title = e->scene.title ? e->scene.title : "";

    put(out, "<figure id=\"figure-%i\"", number);
    put(out, e->panel.count > 1 ? " class=\"many\">\n" : ">\n");
    put(out, "<h2>%t%t%t</h2>\n", e->name, title[0] ? ": " : "", title);
    for (size_t i = 0; i < e->panel.count; i++)
        put(out, "<img src=\"./%a%a.svg\" alt=\"%t%t\">\n", e->name,
            e->panel.name[i], title[0] ? title : e->name, e->panel.name[i]);
    put(out, "<figcaption>\n<p>%t</p>\n<p><code>%t</code></p>\n",
        e->comment ? e->comment : "", e->command ? e->command : "");
    if (e->code == EXIT_DONE)
        put_links(out, e, scripts);
    else
        put(out, "<p class=\"failed\">This scene failed; nothing was "
                 "drawn.</p>\n");
    put(out, "</figcaption>\n</figure>\n");
}

/* The page as text, owned by the caller; NULL where memory is short.  scripts:
 * .gp and .dat lie beside each picture. */
static char *page_text(const struct gallery_entry entry[], size_t count,
                       bool scripts)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);

    if (out == NULL)
        return NULL;
    fputs(text_gallery, out);
    put(out, "<nav>\n");
    for (size_t i = 0; i < count; i++)
        put(out, "<a href=\"#figure-%i\">%t</a>\n", i + 1, entry[i].name);
    put(out, "</nav>\n");
    for (size_t i = 0; i < count; i++)
        put_figure(out, &entry[i], i + 1, scripts);
    put(out, "<p>Slipway %t</p>\n</body>\n</html>\n", SLIPWAY_VERSION);
    const int failed = ferror(out) | fclose(out);
    if (failed) {
        free(text);
        return NULL;
    }
    return text;
}

struct gallery {
    const struct options *options;
    char scenes[PATH_MAX], output[PATH_MAX]; /* folders */
    struct gallery_entry *entry;             /* owned */
    size_t count;
};

static enum status complain(struct fault *why, enum status s, const char *path,
                            const char *what)
{
    return fault_set(why, s, "gallery: %.400s: %s", path, what);
}

/* ---- where --------------------------------------------------------------- */

static bool is_folder(const char *path)
{
    struct stat about;
    return stat(path, &about) == 0 && S_ISDIR(about.st_mode);
}

/* --scenes; else ./scenes; else those of the source beside which the program
 * was built, or those installed with it. */
static enum status find_scenes(struct gallery *g, struct fault *why)
{
    static const char *const beside[] = { "../../scenes",
                                          "../share/slipway/scenes" };
    char program[PATH_MAX];
    const ssize_t n = readlink("/proc/self/exe", program, sizeof program - 1);
    const char *given = g->options->scenes ? g->options->scenes : "scenes";

    snprintf(g->scenes, sizeof g->scenes, "%s", given);
    if (is_folder(g->scenes))
        return STATUS_OK;
    if (!g->options->scenes && n > 0) {
        program[n] = '\0';
        const char *folder = dirname(program);
        for (size_t i = 0; i < sizeof beside / sizeof *beside; i++)
            if (gallery_path(g->scenes, folder, beside[i], "") &&
                is_folder(g->scenes))
                return STATUS_OK;
    }
    return complain(why, STATUS_IO, given,
                    "no such folder of scenes, expected --scenes DIR");
}

static enum status make_output(struct gallery *g, struct fault *why)
{
    const char *given =
        g->options->output ? g->options->output : "outputs/gallery";

    snprintf(g->output, sizeof g->output, "%s", given);
    if (!g->options->output)
        (void) !mkdir("outputs", 0777); /* or the next one says why not */
    if (mkdir(g->output, 0777) == 0 || (errno == EEXIST && is_folder(given)))
        return STATUS_OK;
    return complain(why, STATUS_IO, given, strerror(errno));
}

static int is_scene(const struct dirent *d)
{
    const size_t n = strlen(d->d_name);
    return n > 5 && d->d_name[0] != '.' &&
           strcmp(d->d_name + n - 5, ".yaml") == 0;
}

static enum status list_scenes(struct gallery *g, struct fault *why)
{
    struct dirent **name = NULL;
    const int n = scandir(g->scenes, &name, is_scene, alphasort);
    bool fits = true;

    if (n <= 0)
        return complain(why, STATUS_IO, g->scenes, "no scenes there");
    g->entry = calloc((size_t) n, sizeof *g->entry);
    for (int i = 0; i < n && g->entry; i++) {
        struct gallery_entry *e = &g->entry[g->count++];
        const int size = (int) strlen(name[i]->d_name) - 5;
        fits &= gallery_path(e->path, g->scenes, name[i]->d_name, "") &&
                snprintf(e->name, GALLERY_NAME, "%.*s", size, name[i]->d_name) <
                    GALLERY_NAME;
    }
    for (int i = 0; i < n; i++)
        free(name[i]);
    free(name);
    if (!fits)
        return complain(why, STATUS_IO, g->scenes, "a name is too long");
    return g->entry ? STATUS_OK : STATUS_NO_MEMORY;
}

/* ---- all ----------------------------------------------------------------- */

/* Builds them in turn and drops those that draw nothing; false when stopped. */
static bool build_all(struct gallery *g)
{
    const char *how = g->options->progress;
    const struct gallery_place place = { g->options, g->scenes, g->output,
                                         how && strcmp(how, "json") == 0
                                             ? how
                                             : "none" };
    size_t kept = 0;
    bool stopped = false;

    for (size_t i = 0; i < g->count; i++) {
        struct gallery_entry *e = &g->entry[i];
        if (!stopped && monitor_tell(progress_monitor(g->options), "scenes", i,
                                     g->count) != 0)
            stopped = command_fail(STATUS_STOPPED, "") == EXIT_INTERRUPT;
        if (!stopped) {
            gallery_build(&place, e);
            stopped = e->code == EXIT_INTERRUPT;
        }
        if (e->panel.count > 0 || e->code != EXIT_DONE)
            g->entry[kept++] = *e;
        else
            gallery_entry_free(e);
    }
    progress_end();
    g->count = kept;
    return !stopped;
}

static enum status write_page(const struct gallery *g, char path[PATH_MAX],
                              struct fault *why)
{
    char *text = page_text(g->entry, g->count, g->options->keep_script);
    enum status status = STATUS_NO_MEMORY;

    if (!gallery_path(path, g->output, "index", ".html"))
        status = complain(why, STATUS_IO, g->output, "the path is too long");
    else if (text)
        status = replace_file(path, text, strlen(text), why);
    free(text);
    return status;
}

static json_t *gallery_json(const struct gallery *g, const char *page)
{
    json_t *list = json_array();

    for (size_t i = 0; i < g->count; i++) {
        const struct gallery_entry *e = &g->entry[i];
        json_t *panels = json_array();
        for (size_t k = 0; k < e->panel.count; k++)
            json_array_append_new(
                panels, json_sprintf("%s%s", e->name, e->panel.name[k]));
        json_array_append_new(list, json_pack("{s:s, s:s, s:b, s:o}", "name",
                                              e->name, "scene", e->path,
                                              "built", e->code == EXIT_DONE,
                                              "panels", panels));
    }
    return json_pack("{s:s, s:o}", "page", page, "figures", list);
}

/* What was made; then, on stderr, what was not. */
static enum exit_code tell(const struct gallery *g, const char *page)
{
    enum exit_code code = EXIT_DONE;
    size_t failed = 0;

    for (size_t i = 0; i < g->count; i++) {
        const struct gallery_entry *e = &g->entry[i];
        if (e->code == EXIT_DONE)
            continue;
        code = failed++ == 0 ? e->code : code;
        fprintf(stderr, "slipway: gallery: %s failed\n", e->path);
    }
    if (g->options->json && !json_print(gallery_json(g, page)))
        return command_unwritten();
    if (!g->options->json && !g->options->quiet)
        printf("wrote %s: %zu figure%s%s\n", page, g->count - failed,
               g->count - failed == 1 ? "" : "s",
               failed ? ", the others failed" : "");
    return code;
}

static enum status prepare(struct gallery *g, struct fault *why)
{
    enum status s = find_scenes(g, why);

    if (s == STATUS_OK)
        s = list_scenes(g, why);
    return s ? s : make_output(g, why);
}

enum exit_code command_gallery(const struct options *o)
{
    struct gallery g = { .options = o };
    struct fault why = { "" };
    char page[PATH_MAX];
    enum exit_code code = EXIT_INTERRUPT;

    enum status s = prepare(&g, &why);
    if (s == STATUS_OK && build_all(&g)) {
        s = write_page(&g, page, &why);
        if (s == STATUS_OK)
            code = tell(&g, page);
    }
    if (s != STATUS_OK)
        code = command_fail(s, why.text);
    for (size_t i = 0; i < g.count; i++)
        gallery_entry_free(&g.entry[i]);
    free(g.entry);
    return code;
}
