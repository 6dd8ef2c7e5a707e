/* slipway export: law, slope and saddle as input of other programs. */
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "auto07p.h"
#include "command.h"
#include "exchange.h"
#include "output.h"
#include "progress.h"
#include "replace.h"
#include "report.h"
#include "scene_slope.h"
#include "text.h"
#include "xppaut.h"

enum { FILES = 4, PATH_ROOM = PATH_MAX + 16 };

/* A file of an export: its path and who writes it. */
struct export_file {
    char path[PATH_ROOM];
    bool printed; /* not written */
    void (*write)(FILE *out, const struct interchange *x);
};

struct job {
    const struct options *options;
    struct scene scene;
    struct study study;
    bool has_study;
    bool to_auto;
    enum xppaut_form form;
    char name[NAME_MAX + 1]; /* NAME of the files */
    struct export_file file[FILES];
    size_t files;
};

/* ---- what is asked ------------------------------------------------------- */

static enum status usage(struct fault *why, const char *option,
                         const char *text, const char *expected)
{
    snprintf(why->text, sizeof why->text, "export: %s%s%s: expected %s", option,
             text ? " " : "", text ? text_shown(text).text : "", expected);
    return STATUS_BAD_ARGUMENT;
}

/* The words themselves are known to be of the table of options. */
static enum status read_format(struct job *j, struct fault *why)
{
    const char *as = j->options->as, *form = j->options->form;

    if (as == NULL)
        return usage(why, "--as", as, "xppaut or auto");
    j->to_auto = strcmp(as, "auto") == 0;
    j->form =
        form && strcmp(form, "time") == 0 ? XPPAUT_TIME : XPPAUT_ARCLENGTH;
    return j->to_auto && form
               ? usage(why, "--form", form, "it with --as xppaut only")
               : STATUS_OK;
}

static void write_time(FILE *out, const struct interchange *x)
{
    xppaut_write(out, x, XPPAUT_TIME);
}

static void write_arclength(FILE *out, const struct interchange *x)
{
    xppaut_write(out, x, XPPAUT_ARCLENGTH);
}

/* FOLDER/BEFORE NAME AFTER, FOLDER being that of `path`. */
static void add_file(struct job *j, const char *path, const char *before,
                     const char *after,
                     void (*write)(FILE *, const struct interchange *))
{
    const char *slash = strrchr(path, '/');
    struct export_file *f = &j->file[j->files++];

    snprintf(f->path, sizeof f->path, "%.*s%s%s%s",
             slash ? (int) (slash + 1 - path) : 0, path, before, j->name,
             after);
    f->write = write;
}

/* NAME of FOLDER/NAME.ENDING; AUTO makes names of other files and of Python
 * out of it. */
static bool read_name(const char *path, const char *ending, char *name,
                      size_t size)
{
    static const char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopq"
                                  "rstuvwxyz0123456789_-";
    const char *slash = strrchr(path, '/'), *own = slash ? slash + 1 : path;
    const size_t n = strspn(own, letters);

    if (n == 0 || n >= size || strcmp(own + n, ending) != 0 ||
        strlen(path) >= PATH_MAX)
        return false;
    snprintf(name, n + 1, "%s", own);
    return true;
}

static enum status name_files(struct job *j, struct fault *why)
{
    const char *ending = j->to_auto ? ".c" : ".ode";
    char given[PATH_MAX];
    const char *path = output_path(j->options);

    if (path == NULL && output_is_standard(j->options) && j->to_auto)
        return usage(why, "-o", "-", "NAME.c: they are several files");
    if (path == NULL) {
        snprintf(given, sizeof given, "%s%s", j->scene.law.preset, ending);
        path = given;
    }
    if (!read_name(path, ending, j->name, sizeof j->name))
        return usage(why, "-o", path,
                     j->to_auto
                         ? "NAME.c with NAME of letters, digits, _ and -"
                         : "NAME.ode with NAME of letters, digits, _ and -");
    if (!j->to_auto) {
        add_file(j, path, "", ending,
                 j->form == XPPAUT_TIME ? write_time : write_arclength);
        j->file[0].printed = output_is_standard(j->options);
        return STATUS_OK;
    }
    add_file(j, path, "", ending, auto07p_write_equations);
    add_file(j, path, "", ".auto", auto07p_write_script);
    add_file(j, path, "c.", "", auto07p_write_steady);
    add_file(j, path, "c.", ".folds", auto07p_write_folds); /* the last one */
    return STATUS_OK;
}

static enum status read_scene(struct job *j, struct fault *why)
{
    const struct options *o = j->options;

    enum status s = command_read(o, NULL, 0, &j->scene, why);
    if (s == STATUS_OK)
        s = scene_slope_demand(&j->scene, exchange_products, why);
    j->scene.products = exchange_products;
    return s;
}

/* ---- what is written ----------------------------------------------------- */

static enum status check_study(const struct job *j, struct fault *why)
{
    const struct study *s = &j->study;

    if (j->to_auto && s->slider.plane.equilibria == 0) {
        snprintf(why->text, sizeof why->text,
                 "export: there is no steady state at this slope for AUTO to "
                 "start from");
        return STATUS_NOT_HYPERBOLIC;
    }
    if (!j->to_auto && j->form == XPPAUT_ARCLENGTH &&
        !slider_has_manifolds(&s->slider)) {
        snprintf(why->text, sizeof why->text,
                 "export: --form arclength: %s (--form time needs none)",
                 s->slider.critical.v_plus.reason);
        return STATUS_NOT_HYPERBOLIC;
    }
    return STATUS_OK;
}

static enum status write_file(const struct export_file *f,
                              const struct interchange *x, struct fault *why)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);

    if (out == NULL)
        return STATUS_NO_MEMORY;
    f->write(out, x);
    const bool whole = !ferror(out);
    enum status s = fclose(out) == 0 && whole ? STATUS_OK : STATUS_NO_MEMORY;
    if (s == STATUS_OK && f->printed)
        fwrite(text, 1, size, stdout); /* main() asks whether it arrived */
    else if (s == STATUS_OK)
        s = replace_file(f->path, text, size, why);
    free(text);
    return s;
}

static enum status write_files(struct job *j, struct fault *why)
{
    char *remarks = exchange_remarks(&j->study);
    enum status s = remarks ? STATUS_OK : STATUS_NO_MEMORY;

    if (s != STATUS_OK)
        return s;
    const struct interchange x = exchange_of(&j->study, j->name, remarks);
    if (j->to_auto && !x.has_folds)
        j->files--; /* nothing to follow */
    for (size_t i = 0; i < j->files && s == STATUS_OK; i++)
        s = write_file(&j->file[i], &x, why);
    free(remarks);
    return s;
}

/* ---- the command --------------------------------------------------------- */

static enum status run(struct job *j, struct fault *why)
{
    enum status s = read_format(j, why);

    if (s == STATUS_OK)
        s = read_scene(j, why);
    if (s == STATUS_OK)
        s = name_files(j, why);
    if (s == STATUS_OK)
        s = output_standard_check(j->options, why);
    for (size_t i = 0; i < j->files && s == STATUS_OK; i++)
        if (!j->file[i].printed)
            s = output_path_check(j->options, &j->scene, j->file[i].path, why);
    if (s == STATUS_OK) {
        s = study_run(&j->study, &j->scene, progress_monitor(j->options), why);
        j->has_study = s == STATUS_OK;
    }
    progress_end();
    if (s == STATUS_OK)
        s = check_study(j, why);
    return s == STATUS_OK ? write_files(j, why) : s;
}

static enum exit_code tell(const struct job *j)
{
    if (j->options->json)
        return json_print(report_json(&j->study, NULL)) ? EXIT_DONE
                                                        : command_unwritten();
    for (size_t i = 0; i < j->files && !j->options->quiet; i++)
        if (!j->file[i].printed)
            printf("wrote %s\n", j->file[i].path);
    return EXIT_DONE;
}

enum exit_code command_export(const struct options *o)
{
    struct job j = { .options = o };
    struct fault why = { "" };

    const enum status s = run(&j, &why);
    const enum exit_code code =
        s == STATUS_OK ? tell(&j) : command_fail(s, why.text);
    if (j.has_study)
        study_free(&j.study);
    scene_free(&j.scene);
    return code;
}
