/* slipway export: law, slope and saddle as input of other programs. */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "auto07p.h"
#include "command.h"
#include "interchange.h"
#include "number.h"
#include "output.h"
#include "progress.h"
#include "replace.h"
#include "report.h"
#include "scene_slope.h"
#include "study.h"
#include "text.h"
#include "tolerance.h"
#include "xppaut.h"

/* ---- exchange ------------------------------------------------------------ */

/* What exchange_of needs of a study: bits of enum product. */
static const unsigned exchange_products =
    1u << PRODUCT_EQUILIBRIA | 1u << PRODUCT_FOLDS | 1u << PRODUCT_KNEES;

/* ---- branches ------------------------------------------------------------ */

/* |d other/d running| at z, where coordinate `running` runs to infinity. */
static double slope_at(const struct planar *sys, int running, struct vec2 z)
{
    struct planar_field f;

    sys->field(sys->ctx, z, &f);
    const double x = f.direction.x, y = f.direction.y;
    return fabs(running == 0 ? y / x : x / y);
}

static bool has_limit(const struct branch *b)
{
    return b->end == BRANCH_LIMIT_X || b->end == BRANCH_LIMIT_Y;
}

/* How far from the branch's last point on, along its limit, the slope stays
 * above EXCHANGE_FLAT. */
static double way_to_limit(const struct planar *sys, const struct branch *b)
{
    const int running = b->end == BRANCH_LIMIT_X ? 1 : 0;
    struct vec2 z = b->limit;
    double way = 0.0;

    while (way < LN_RANGE && slope_at(sys, running, z) > EXCHANGE_FLAT) {
        way += EXCHANGE_STRIDE;
        *(running == 1 ? &z.y : &z.x) += b->sign * EXCHANGE_STRIDE;
    }
    return way;
}

static struct interchange_branch branch_of(const struct study *s, int side)
{
    const struct branch *b = &s->stable[side];
    const struct vec2 start =
        curve_point(&b->curve, 0, 1.0); /* piece 0 is the series */
    struct vec2 last = start;
    double length = 0.0;

    for (size_t i = 1; i < b->curve.count; i++) {
        const struct vec2 next = curve_point(&b->curve, i, 1.0);
        length += hypot(next.x - last.x, next.y - last.y);
        last = next;
    }
    length = has_limit(b) ? length + way_to_limit(&s->slider.plane.system, b)
                          : fmin(length, EXCHANGE_ARC);
    return (struct interchange_branch){
        .name = side == SIDE_UPPER ? "upper" : "lower",
        .start = { s->slider.plane.system.origin.x + start.x,
                   s->slider.plane.system.origin.y + start.y },
        .length = ceil(length) + 1.0,
    };
}

/* ---- steady states ------------------------------------------------------- */

/* Towards the folds: up in alpha along creep, down along the saddles and along
 * sliding above the last fold. */
static double toward(const struct study *s)
{
    const struct quantity *top = &s->folds.alpha_cM;
    const bool creeps =
        s->slider.plane.equilibrium[0].type == EQUILIBRIUM_STABLE_NODE;

    if (!creeps || (quantity_exists(top) && s->scene->alpha > top->value))
        return -1.0;
    return 1.0;
}

static void set_slopes(const struct study *s, double alpha[2])
{
    const struct quantity *fold[] = { &s->folds.alpha_cm, &s->folds.alpha_cM };
    double lo = s->scene->alpha, hi = lo;

    for (int i = 0; i < 2; i++)
        if (quantity_exists(fold[i])) {
            lo = fmin(lo, fold[i]->value);
            hi = fmax(hi, fold[i]->value);
        }
    alpha[0] = fmax(lo - EXCHANGE_MARGIN, lo / 2.0);
    alpha[1] = fmin(hi + EXCHANGE_MARGIN, (hi + M_PI_2) / 2.0);
}

/* The slowest rate at the anchor, per unit of time. */
static double slow_rate(const struct study *s)
{
    const int i =
        slider_saddle(&s->slider) >= 0 ? slider_saddle(&s->slider) : 0;
    const double rate = s->slider.plane.equilibria
                            ? fabs(s->slider.plane.equilibrium[i].lambda[1])
                            : 0.0;

    return rate > 0.0 && isfinite(rate) ? rate : s->slider.block.at.v0;
}

/* Borrows the study's block, `name` and `remarks`.  Without a saddle that
 * doubles can hold there are no branches; without a steady state `steady` is a
 * point of the steady curve. */
static struct interchange exchange_of(const struct study *s, const char *name,
                                      const char *remarks)
{
    const struct vec2 at = s->slider.plane.system.origin;
    struct interchange x = {
        .block = &s->slider.block,
        .name = name,
        .remarks = remarks,
        .branches = slider_has_manifolds(&s->slider) ? SIDES : 0,
        .start = { at.x + EXCHANGE_KICK, at.y },
        .time = EXCHANGE_RATES / slow_rate(s),
        .steady =
            s->slider.plane.equilibria ? s->slider.plane.equilibrium[0].z : at,
        .toward = s->slider.plane.equilibria ? toward(s) : 1.0,
        .has_folds = law_uses(&s->slider.block.law, MATERIAL_C) &&
                     (quantity_exists(&s->folds.alpha_cm) ||
                      quantity_exists(&s->folds.alpha_cM)),
    };

    for (size_t i = 0; i < x.branches; i++)
        x.branch[i] = branch_of(s, (int) i);
    set_slopes(s, x.alpha);
    return x;
}

/* ---- remarks ------------------------------------------------------------- */

/* An eigenvector, from the row of J - lambda where less cancels. */
static void print_direction(FILE *out, const struct equilibrium *e, int i)
{
    const struct mat2 *m = &e->matrix;
    const double up = e->scaled[i] - m->xx, down = e->scaled[i] - m->yy;
    const bool first = fabs(up) > fabs(down);
    const struct vec2 d =
        first ? (struct vec2){ m->xy, up } : (struct vec2){ down, m->yx };
    const double size = copysign(hypot(d.x, d.y), d.x);

    fprintf(out, "  along %-10s (%.15g, %.15g)\n",
            i == 0 ? "lambda_minus" : "lambda_plus", d.x / size, d.y / size);
}

static void print_saddle(FILE *out, const struct study *s)
{
    const struct equilibrium *e = phase_plane_saddle(&s->slider.plane);

    fprintf(out,
            "saddle in the chart (ln v, %s)\n"
            "  at               (%s, %s)\n"
            "  lambda           %.15g, %.15g\n",
            text_state_name(&s->slider.block.law, 1),
            number_shortest(e->z.x).text, number_shortest(e->z.y).text,
            e->lambda[0], e->lambda[1]);
    print_direction(out, e, 0);
    print_direction(out, e, 1);
}

/* The scene and the study's numbers with their errors, as lines; owned by the
 * caller, NULL without memory. */
static char *exchange_remarks(const struct study *s)
{
    char *text = NULL, formula[256];
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);

    if (out == NULL)
        return NULL;
    law_formula(&s->slider.block.law, formula, sizeof formula);
    fprintf(out, "slipway %s\n%s\n\n", SLIPWAY_VERSION, formula);
    const enum status status = report_print(out, s);
    if (slider_has_manifolds(&s->slider))
        print_saddle(out, s);
    fprintf(out, "\nscene\n%s\noverrides\n%s", s->scene->text,
            s->scene->overrides);
    const bool whole = status == STATUS_OK && !ferror(out);
    if (fclose(out) == 0 && whole)
        return text;
    free(text);
    return NULL;
}

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
    return fault_set(why, STATUS_BAD_ARGUMENT, "export: %s%s%s: expected %s",
                     option, text ? " " : "", text ? text_shown(text).text : "",
                     expected);
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

    if (j->to_auto && s->slider.plane.equilibria == 0)
        return fault_set(
            why, STATUS_NOT_HYPERBOLIC,
            "export: there is no steady state at this slope for AUTO to "
            "start from");
    if (!j->to_auto && j->form == XPPAUT_ARCLENGTH &&
        !slider_has_manifolds(&s->slider))
        return fault_set(
            why, STATUS_NOT_HYPERBOLIC,
            "export: --form arclength: %s (--form time needs none)",
            s->slider.critical.v_plus.reason);
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
