/* slipway study and its shortcuts: read the scene, run what it asks for, write
 * the file, draw the figure, print the numbers. */
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "drawn.h"
#include "json.h"
#include "options.h"
#include "output.h"
#include "picture.h"
#include "picture_plane.h"
#include "plane_certificate.h"
#include "plane_results.h"
#include "product_setting.h"
#include "progress.h"
#include "remark.h"
#include "replace.h"
#include "report.h"
#include "report_ensemble.h"
#include "report_sweep.h"
#include "run_plane.h"
#include "scene.h"
#include "scene_slope.h"
#include "study_certificate.h"
#include "study_results.h"
#include "sweep_point.h"

#define BIT(p) (1u << PRODUCT_##p)

/* What a shortcut adds to a scene, or runs without one. */
struct shortcut {
    unsigned always;    /* products it cannot do without */
    unsigned if_none;   /* products where the scene names none */
    const char *figure; /* drawn where the scene names no output at all */
    bool print_numbers; /* the report goes to stdout */
    bool hands_over;    /* scenes that are for another command */
    size_t spread;      /* trajectories without a scene */
};

static const struct shortcut study_shortcut = {
    .hands_over = true,
    .if_none = BIT(EQUILIBRIA) | BIT(FOLDS) | BIT(MANIFOLDS) | BIT(KNEES),
    .print_numbers = true,
};

static const struct shortcut portrait_shortcut = {
    .always = BIT(EQUILIBRIA),
    .if_none = BIT(NULLCLINES) | BIT(MANIFOLDS) | BIT(TRAJECTORIES),
    .figure = "portrait.svg",
    .spread = 20,
};

static const struct shortcut knees_shortcut = {
    .always = BIT(EQUILIBRIA) | BIT(FOLDS) | BIT(KNEES) | BIT(ESTIMATES),
    .print_numbers = true,
};

static const struct shortcut basin_shortcut = {
    .always = BIT(EQUILIBRIA) | BIT(BASINS),
    .print_numbers = true,
};

/* The products that are run. */
static unsigned products_of(const struct options *o, const struct shortcut *how,
                            const struct scene *s)
{
    if (s->system)
        return (s->products ? s->products : plane_products(o)) |
               (how->always & (BIT(EQUILIBRIA) | BIT(BASINS))) |
               (o->sensitivities ? BIT(SENSITIVITIES) : 0) | BIT(EQUILIBRIA);
    const unsigned none = how->hands_over && s->sweep.axes > 0
                              ? knees_shortcut.always
                              : how->if_none;

    return (s->products ? s->products : none) | how->always |
           (o->sensitivities ? BIT(SENSITIVITIES) : 0);
}

/* *other: the command the scene is for instead of this one, or NULL. */
static enum status read_scene(const struct options *o,
                              const struct shortcut *how, struct scene *scene,
                              const struct command **other, struct fault *why)
{
    char line[PRODUCT_SETTING], spread[64], *more[COMMAND_MORE];
    size_t count = 0;

    *other = NULL;
    const enum status s = command_read(o, NULL, 0, scene, why);
    if (s != STATUS_OK)
        return s;
    const char *name = scene_command(scene);
    const unsigned products = products_of(o, how, scene);
    if (how->hands_over && strcmp(name, "study") != 0)
        *other = command_find(name);
    if (scene->products == 0 && scene->starts + scene->spread == 0 &&
        how->spread > 0) {
        snprintf(spread, sizeof spread, "trajectories.spread=%zu", how->spread);
        more[count++] = spread;
    }
    if (products != scene->products) {
        product_setting(products, line);
        more[count++] = line;
    }
    if (count == 0)
        return STATUS_OK;
    scene_free(scene);
    return command_read(o, more, count, scene, why);
}

/* The figure to draw; NULL: none. */
static const char *figure_of(const struct scene *c, const struct shortcut *how)
{
    return c->figure ? c->figure : c->hdf5 ? NULL : how->figure;
}

static enum status check_files(const struct options *o, const struct scene *c,
                               const struct shortcut *how, struct fault *why)
{
    static const char *const panel[] = { "", NULL };
    const char *figure = figure_of(c, how);

    if (figure && c->products == BIT(FOLDS) && !scene_has_slope(c))
        return fault_set(why, STATUS_BAD_SCENE,
                         "%.300s: nothing to draw: folds are numbers, expected "
                         "fold_curves or bifurcation beside them, or a slope",
                         figure);
    return output_check(o, c, figure, panel, why);
}

/* ---- the certificate ----------------------------------------------------- */

/* Whether --certificate, if it is given, can be followed: something is proved,
 * and the file can be written. */
static enum status certificate_check(const struct options *o,
                                     const struct scene *scene,
                                     struct fault *why)
{
    if (o->certificate == NULL)
        return STATUS_OK;
    if (!scene->proved)
        return command_refuse(why,
                              "--certificate %s: nothing is proved, expected a "
                              "slope or a system, and --proved",
                              o->certificate);
    return output_path_check(o, scene, o->certificate, why);
}

/* Writes the file that is asked for, whole or not at all, and says so.  Steals
 * proof. */
static enum status certificate_write(const struct options *o, json_t *proof,
                                     struct fault *why)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);

    if (out == NULL) {
        json_decref(proof);
        return STATUS_NO_MEMORY;
    }
    const bool whole = json_write(proof, out);
    enum status status =
        fclose(out) == 0 && whole ? STATUS_OK : STATUS_NO_MEMORY;
    if (status == STATUS_OK)
        status = replace_file(o->certificate, text, size, why);
    free(text);
    if (status == STATUS_OK)
        output_tell(o, o->certificate);
    return status;
}

static void print_remarks(const struct study *s)
{
    const char *text[4];
    const size_t n = study_remarks(s, text, 4);

    for (size_t i = 0; i < n; i++)
        printf("note: %s\n", text[i]);
}

/* What was found of a scene, which has a system of formulas or a law. */
struct found {
    const struct scene *scene;
    union {
        struct plane_study plane;
        struct study law;
    };
    struct ensemble drawn;
};

static enum status find(struct found *f, const struct options *o,
                        struct fault *why)
{
    const struct monitor *monitor = progress_monitor(o);

    return f->scene->system ? plane_study_run(&f->plane, f->scene, monitor, why)
                            : study_run(&f->law, f->scene, monitor, why);
}

static void forget(struct found *f)
{
    ensemble_free(&f->drawn);
    if (f->scene->system)
        plane_study_free(&f->plane);
    else
        study_free(&f->law);
}

static enum status write_files(const struct found *f, const struct options *o,
                               const struct shortcut *how, struct fault *why)
{
    const bool system = f->scene->system != NULL;
    const char *figure = figure_of(f->scene, how);
    const struct results all =
        system ? plane_results(&f->plane) : study_results(&f->law);
    struct panels p = PANELS_EMPTY;
    /* the shortcuts are studies, but one of a scene with a sweep would sweep */
    const char *command =
        system || f->scene->sweep.axes > 0 ? o->command->name : "study";
    enum status status = output_write(
        o, command, &all, f->scene, drawn_of(&f->drawn),
        system ? f->plane.system[0].name : f->law.slider.block.law.preset, why);

    if (status == STATUS_OK && o->certificate)
        status = certificate_write(o,
                                   system ? plane_certificate(&f->plane)
                                          : study_certificate(&f->law),
                                   why);
    if (status == STATUS_OK && figure && system)
        picture_plane(&f->plane, &p);
    else if (status == STATUS_OK && figure)
        picture_study(&f->law, progress_monitor(o), &p);
    return status ? status : output_draw(o, &f->scene->paper, &p, figure, why);
}

static enum status print_law(const struct study *s, const struct shortcut *how)
{
    const enum status status =
        how->print_numbers ? report_print(stdout, s) : STATUS_OK;

    if (status == STATUS_OK)
        print_remarks(s);
    return status;
}

static enum exit_code print_results(const struct found *f,
                                    const struct options *o,
                                    const struct shortcut *how)
{
    const struct ensemble *drawn = drawn_of(&f->drawn);
    const bool system = f->scene->system != NULL;

    if (o->json)
        return json_print(system ? plane_json(&f->plane, drawn)
                                 : report_json(&f->law, drawn))
                   ? EXIT_DONE
                   : command_unwritten();
    if (o->quiet)
        return EXIT_DONE;
    const enum status status =
        system ? plane_print(&f->plane) : print_law(&f->law, how);
    if (status != STATUS_OK)
        return command_fail(status, status_text(status));
    if (drawn)
        report_ensemble_print(stdout, drawn);
    return EXIT_DONE;
}

/* Files are written and numbers printed: the user may see for himself. */
static enum exit_code judge_audit(const struct found *f)
{
    const struct plane_basin *b = &f->plane.basin;
    const struct basin_map *m = &f->law.basins;
    const bool system = f->scene->system != NULL;
    const size_t wrong =
        system ? (size_t) b->disagreements : m->audit.disagreements;
    char text[160];

    if (wrong == 0)
        return EXIT_DONE;
    snprintf(text, sizeof text, "audit: the orbits of %zu of %zu %s", wrong,
             system ? (size_t) b->cells : m->audit.cells,
             system ? "states go elsewhere than the map says"
                    : "cells have another fate than the map says");
    return command_fail(STATUS_NO_CONVERGENCE, text);
}

/* Likewise: a bar and a proof cannot both be right. */
static enum exit_code judge_proof(const struct fault *lie)
{
    if (lie->text[0] == '\0')
        return EXIT_DONE;
    fprintf(stderr, "slipway: %s\n", lie->text);
    return EXIT_CHECK;
}

/* Writes, draws and prints what was found. */
static enum exit_code tell(const struct found *f, const struct options *o,
                           const struct shortcut *how)
{
    struct fault why = { "" };
    const enum status s = write_files(f, o, how, &why);

    progress_end();
    enum exit_code code =
        s == STATUS_OK ? print_results(f, o, how) : command_fail(s, why.text);
    if (code == EXIT_DONE)
        code = judge_audit(f);
    return code == EXIT_DONE
               ? judge_proof(f->scene->system ? &f->plane.proof.lie
                                              : &f->law.proof.lie)
               : code;
}

static enum exit_code run_scene(const struct options *o,
                                const struct scene *scene,
                                const struct shortcut *how)
{
    struct found f = { .scene = scene, .drawn = ENSEMBLE_EMPTY };
    struct fault why = { "" };
    enum status s = certificate_check(o, scene, &why);

    if (s == STATUS_OK)
        s = drawn_check(o, scene, &why);
    if (s == STATUS_OK)
        s = check_files(o, scene, how, &why);
    if (s == STATUS_OK)
        s = find(&f, o, &why);
    progress_end();
    if (s != STATUS_OK)
        return command_fail(s, why.text);
    s = drawn_run(o, scene, &f.drawn, &why);
    const enum exit_code code =
        s == STATUS_OK ? tell(&f, o, how) : command_fail(s, why.text);
    forget(&f);
    return code;
}

static enum exit_code run(const struct options *o, const struct shortcut *how)
{
    const struct command *other;
    struct scene scene;
    struct fault why = { "" };

    const enum status s = read_scene(o, how, &scene, &other, &why);
    if (s != STATUS_OK)
        return command_fail(s, why.text);
    const enum exit_code code = other ? EXIT_DONE : run_scene(o, &scene, how);
    scene_free(&scene);
    return other ? command_run(other, o) : code;
}

enum exit_code command_study(const struct options *o)
{
    return run(o, &study_shortcut);
}

enum exit_code command_portrait(const struct options *o)
{
    return run(o, &portrait_shortcut);
}

enum exit_code command_knees(const struct options *o)
{
    return run(o, &knees_shortcut);
}

enum exit_code command_basin(const struct options *o)
{
    return run(o, &basin_shortcut);
}

/* ---- plan ---------------------------------------------------------------- */

/* The points of a sweep, at each of which the stages run. */
static void plan_sweep(const struct options *o, json_t *list,
                       const struct scene *scene)
{
    char text[256];
    const size_t points = report_sweep_plan(scene, text, sizeof text);

    json_array_append_new(list,
                          json_pack("{s:s, s:s, s:I}", "stage", "sweep", "text",
                                    text, "points", (json_int_t) points));
    if (!o->json && !o->quiet)
        printf("%-13s %zu points: %s\n", "sweep", points, text);
}

/* Of a law; other: the command that the scene is for, or NULL. */
static void plan_law(const struct options *o, json_t *list,
                     const struct scene *scene, const struct command *other)
{
    const bool sweeps = scene->sweep.axes > 0;
    struct scene point = *scene; /* borrows */

    if (sweeps)
        point.products = sweep_point_products(scene, scene->hdf5 != NULL);
    const unsigned stages = other && !sweeps ? 0 : plan_scene(&point);
    if (other && !sweeps && !o->json && !o->quiet)
        printf("%-13s %s\n", other->name, other->text);
    for (int i = 0; i < STAGES; i++)
        if (plan_has(stages, (enum stage) i))
            plan_row(o, list, stage_table[i].name, stage_table[i].text,
                     stage_table[i].cost);
}

enum exit_code command_plan(const struct options *o)
{
    const struct command *other;
    struct scene scene;
    struct fault why = { "" };
    const enum status s = read_scene(o, &study_shortcut, &scene, &other, &why);

    if (s != STATUS_OK)
        return command_fail(s, why.text);
    json_t *list = json_array();
    if (scene.sweep.axes > 0)
        plan_sweep(o, list, &scene);
    if (scene.system)
        plane_plan(o, list, &scene);
    else
        plan_law(o, list, &scene, other);
    if (!o->json && !o->quiet && scene.hdf5)
        printf("%-13s %s\n", "write", scene.hdf5);
    if (!o->json && !o->quiet && scene.figure)
        printf("%-13s %s\n", "draw", scene.figure);
    scene_free(&scene);
    if (o->json)
        return json_print(list) ? EXIT_DONE : command_unwritten();
    json_decref(list);
    return EXIT_DONE;
}
