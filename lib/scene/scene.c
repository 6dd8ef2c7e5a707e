/* A scene from file and overrides: tree, table, then what only the whole can
 * tell: a law is there, and a slope where one is needed, or a system in place
 * of both; parts fit. */
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "document.h"
#include "law_typed.h"
#include "override.h"
#include "scene_ensemble.h"
#include "scene_figure.h"
#include "scene_law.h"
#include "scene_ode.h"
#include "scene_scatter.h"
#include "scene_slope.h"
#include "scene_sweep.h"
#include "scene_system.h"
#include "scene_units.h"
#include "schema.h"
#include "system.h"
#include "text.h"
#include "text_file.h"
#include "tolerance.h"

/* ---- the file ------------------------------------------------------------ */

/* A model's text by the scene that it makes. */
static enum status replace_by_scene(const char *path, char **text, size_t *size,
                                    struct fault *why)
{
    char *scene = NULL;
    const enum status s = scene_of_ode(path, *text, &scene, why);

    free(*text);
    *text = scene;
    if (s == STATUS_OK)
        *size = strlen(scene);
    return s;
}

static enum status read_file(const char *path, char **text, size_t *size,
                             struct fault *why)
{
    const enum status s = text_file_read(path, SCENE_BYTES, text, size, why);

    if (s == STATUS_OK && *size > SCENE_BYTES)
        return place_blame((struct place){ path, false, 1, 1 }, why,
                           "a file of more than %zu bytes, expected a scene",
                           SCENE_BYTES);
    return s == STATUS_OK && scene_is_ode(path)
               ? replace_by_scene(path, text, size, why)
               : s;
}

/* ---- defaults ------------------------------------------------------------ */

static enum status set_defaults(struct scene *s)
{
    static const double xi[] = { 0.85, 0.9, 0.99, 0.999 };
    static const double chi[] = { 0.2, 0.28, 0.34, 0.38 };

    s->law.preset = "composed";
    s->law.words = "The scene's law";
    s->law.equation = "composed";
    s->material = material_bristol_board();
    s->window = (struct scene_window){ { 1e-6, 1e6 }, { NAN, NAN }, AXES_LOG };
    s->seed = 1;
    s->cells[0] = s->cells[1] = 512;
    s->audit = 1000;
    s->cell_rtol = TOL_COARSEST;
    s->rabinowicz.restitution = -1.0;
    s->spring_block.sigma = SCENE_SIGMA;
    s->spring_block.mass = s->spring_block.v[0] = NAN;
    s->fold_c[0] = SCENE_FOLD_LEAST;
    s->fold_c[1] = SCENE_FOLD_MOST;
    s->ensemble.draws = SCENE_DRAWS_DEFAULT;
    s->ensemble.seed = 1;
    s->rtol = TOL_RTOL_DEFAULT;
    scene_figure_begin(&s->paper);
    s->xi_count = sizeof xi / sizeof *xi;
    s->title = text_copy("", 0);
    s->xi = malloc(sizeof xi);
    s->chi_alphas = sizeof chi / sizeof *chi;
    s->chi_alpha = malloc(sizeof chi);
    if (s->title == NULL || s->xi == NULL || s->chi_alpha == NULL)
        return STATUS_NO_MEMORY;
    memcpy(s->xi, xi, sizeof xi);
    memcpy(s->chi_alpha, chi, sizeof chi);
    return STATUS_OK;
}

/* ---- checks of the whole ------------------------------------------------- */

/* The place of a path, or of what holds it. */
static struct place place_of(const struct node *root, const char *section,
                             const char *path)
{
    const struct node *n = node_at(root, path);

    if (n == NULL)
        n = node_at(root, section);
    return n ? n->at : root->at;
}

static enum status check_law(const struct node *root, const struct scene *s,
                             struct fault *why)
{
    static const char *const part[] = { "theta", "psi_ss", "timescale",
                                        "kinetics" };
    const struct node *law = node_find(root, "law");
    const struct place at = place_of(root, "law", "law");
    const char *missing = NULL;
    int parts = 0;

    if (s->typed)
        return STATUS_OK;
    for (int i = 0; i < 4; i++) {
        const bool given = node_find(law, part[i]) != NULL;
        parts += given;
        missing = given ? missing : part[i];
    }
    if (node_find(law, "preset") || parts == 4)
        return STATUS_OK;
    if (parts == 0)
        return place_blame(at, why,
                           "no law, expected 'law: {preset: NAME}' or --law "
                           "NAME (see slipway laws)");
    return place_blame(at, why,
                       "law: %s is missing, expected theta, psi_ss, timescale "
                       "and kinetics together",
                       missing);
}

/* A key of the material that the law has no use for. */
static enum status blame_unused(const struct node *n, const struct law *law,
                                struct fault *why)
{
    const char *used[MATERIAL_KEYS + 1] = { NULL };
    char names[100];
    size_t count = 0;

    for (int key = 0; key < MATERIAL_G; key++)
        if (law_uses(law, (enum material_key) key))
            used[count++] = material_key_name((enum material_key) key);
    text_list(used, names, sizeof names);
    return place_blame(n->key_at, why,
                       "material.%s: not used by this law (%s), expected %s",
                       n->key, law->preset, names);
}

static enum status check_material(const struct node *root,
                                  const struct scene *s, struct fault *why)
{
    const struct node *material = node_find(root, "material");

    for (int i = 0; i < MATERIAL_KEYS; i++) {
        const enum material_key key = (enum material_key) i;
        const struct node *n = node_find(material, material_key_name(key));
        if (n && !law_uses(&s->law, key))
            return blame_unused(n, &s->law, why);
    }
    if (law_uses(&s->law, MATERIAL_V_C) && !node_find(material, "V_c") &&
        !scene_sweeps(s, "material.V_c") &&
        !scene_ensemble_has(s, "material.V_c"))
        return s->typed
                   ? place_blame(place_of(root, "law", "law"), why,
                                 "law: V_c stands in it, expected "
                                 "material.V_c, a number > 0")
                   : place_blame(place_of(root, "law", "law.preset"), why,
                                 "law.preset: kato_tullis needs material.V_c, "
                                 "expected a number > 0");
    return STATUS_OK;
}

/* Ranges are the table's; left are components and an infinite R. */
static enum status check_composition(const struct node *root,
                                     const struct scene *s, struct fault *why)
{
    struct material finite = s->material;
    struct fault reason;

    if (law_check(&s->law, &s->material, &reason) == STATUS_OK)
        return STATUS_OK;
    finite.R = 1.0;
    const bool by_R = law_check(&s->law, &finite, why) == STATUS_OK;
    const char *key = by_R ? "material.R" : "law.timescale";
    return place_blame(place_of(root, "law", key), why, "%s: %s", key,
                       reason.text);
}

/* Where psi is a logarithm, its own range; else that of v. */
static bool psi_in_range(const struct law *law, double psi)
{
    if (law_psi_is_log(law))
        return fabs(psi) <= TOL_RANGE;
    return psi >= 1.0 / TOL_RANGE && psi <= TOL_RANGE;
}

static const char *psi_expected(const struct law *law)
{
    return law_psi_is_log(law) ? "a number from -1e300 to 1e300"
                               : "a number from 1e-300 to 1e300";
}

static enum status check_window(const struct node *root, const struct scene *s,
                                struct fault *why)
{
    for (int i = 0; i < 2; i++) {
        const struct node *psi = node_at(root, "window.psi");
        if (psi == NULL)
            psi = node_at(root, "window.phi");
        if (psi == NULL || psi_in_range(&s->law, s->window.psi[i]))
            continue;
        return place_blame(
            psi->child[i]->at, why, "window.%s: %s is not allowed, expected %s",
            psi->key, node_shown(psi->child[i]).text, psi_expected(&s->law));
    }
    return STATUS_OK;
}

static enum status check_starts(const struct node *root, const struct scene *s,
                                struct fault *why)
{
    const struct node *list = node_at(root, "trajectories.starts");

    for (size_t i = 0; i < s->starts; i++) {
        const struct scene_start z = s->start[i];
        const struct node *v = node_find(list->child[i], "v");
        const struct node *psi = node_find(list->child[i], "psi");
        if (psi == NULL)
            psi = node_find(list->child[i], "phi");
        if (!(z.v >= 1.0 / TOL_RANGE && z.v <= TOL_RANGE))
            return place_blame(v->at, why,
                               "trajectories.starts: v: %s is not allowed, "
                               "expected v/V_star from 1e-300 to 1e300",
                               node_shown(v).text);
        if (!psi_in_range(&s->law, z.psi))
            return place_blame(psi->at, why,
                               "trajectories.starts: %s: %s is not allowed, "
                               "expected %s",
                               psi->key, node_shown(psi).text,
                               strcmp(psi->key, "phi") == 0
                                   ? "a number > 0"
                                   : psi_expected(&s->law));
    }
    return STATUS_OK;
}

/* ---- the whole ----------------------------------------------------------- */

/* A block pressed by its own weight, where nothing else is said. */
static void settle_spring(struct scene *s)
{
    struct scene_spring *b = &s->spring_block;

    if (isnan(b->mass))
        b->mass = b->sigma / s->material.g;
    if (isnan(b->v[0]))
        memcpy(b->v, s->window.v, sizeof b->v);
}

/* What a scene leaves open where psi is a logarithm. */
static void settle(struct scene *s)
{
    const bool is_log = law_psi_is_log(&s->law);

    settle_spring(s);
    if (isnan(s->window.psi[0])) {
        s->window.psi[0] = is_log ? -7.0 : 1e-3;
        s->window.psi[1] = is_log ? 5.0 : 1e2;
    }
}

typedef enum status scene_check(const struct node *root, const struct scene *s,
                                struct fault *why);

static enum status check_all(scene_check *const check[],
                             const struct node *root, const struct scene *s,
                             struct fault *why)
{
    enum status status = STATUS_OK;

    for (; *check && status == STATUS_OK; check++)
        status = (*check)(root, s, why);
    return status;
}

/* Sections that are for laws. */
static enum status refuse_others(const struct node *root, struct fault *why)
{
    static const char *const known[] = { "title",    "system",       "window",
                                         "products", "trajectories", "basins",
                                         "sweep",    "ensemble",     "accuracy",
                                         "output",   "figure",       NULL };

    for (size_t i = 0; i < root->count; i++) {
        const struct node *n = root->child[i];
        if (text_index(n->key, known) < 0)
            return place_blame(n->key_at, why,
                               "%s: not beside system, expected one of the two",
                               text_shown(n->key).text);
    }
    return STATUS_OK;
}

/* Formulas blame words as they are typed. */
static enum status take_system(struct node *root, struct scene *s,
                               struct fault *why)
{
    struct fault raw = { "" };
    enum status status = STATUS_OK;

    if (node_find(root, "system"))
        status = refuse_others(root, &raw);
    if (status == STATUS_OK)
        status = scene_system_take(root, s, &raw);
    if (status != STATUS_OK)
        text_show(raw.text, why->text, sizeof why->text);
    return status;
}

static enum status fill(struct node *root, struct scene *s, struct fault *why)
{
    static scene_check *const of_law[] = {
        check_law,         scene_slope_check,    check_material,
        check_composition, check_window,         check_starts,
        scene_sweep_check, scene_ensemble_check, NULL
    };
    static scene_check *const of_system[] = { scene_system_check,
                                              scene_sweep_check,
                                              scene_ensemble_check, NULL };
    enum status status = set_defaults(s);

    if (status == STATUS_OK)
        status = scene_scatter_take(root, s, why);
    if (status == STATUS_OK)
        status = take_system(root, s, why);
    if (status == STATUS_OK && s->system == NULL)
        status = scene_law_begin(root, s);
    if (status == STATUS_OK)
        status = schema_apply(root, s, why);
    if (status == STATUS_OK)
        scene_figure_settle(&s->paper);
    if (status == STATUS_OK && s->system)
        status = scene_sweep_fill(root, s, why);
    if (status == STATUS_OK && s->system)
        return check_all(of_system, root, s, why);
    if (status == STATUS_OK)
        status = scene_law_finish(root, s, why);
    if (status == STATUS_OK)
        status = scene_units_settle(root, s, why);
    if (status == STATUS_OK)
        settle(s);
    if (status == STATUS_OK)
        status = scene_sweep_fill(root, s, why);
    if (status == STATUS_OK)
        status = scene_ensemble_settle(root, s, why);
    return status ? status : check_all(of_law, root, s, why);
}

/* One override a line. */
static char *joined(char *const override[], size_t overrides)
{
    size_t size = 1;

    for (size_t i = 0; i < overrides; i++)
        size += strlen(override[i]) + 1;
    char *text = malloc(size), *end = text;
    if (text == NULL)
        return NULL;
    for (size_t i = 0; i < overrides; i++)
        end = stpcpy(stpcpy(end, override[i]), "\n");
    *end = '\0';
    return text;
}

/* Text and overrides stay with the scene; *root is the caller's. */
static enum status read_tree(struct scene *s, const char *path,
                             char *const override[], size_t overrides,
                             struct node **root, struct fault *why)
{
    size_t size = 0;
    enum status status = STATUS_OK;

    if (path && (s->file = text_copy(path, strlen(path))) == NULL)
        return STATUS_NO_MEMORY;
    if (path)
        status = read_file(path, &s->text, &size, why);
    else if ((s->text = text_copy("", 0)) == NULL)
        status = STATUS_NO_MEMORY;
    if (status == STATUS_OK)
        status = document_read(s->text, size, path, root, why);
    for (size_t i = 0; i < overrides && status == STATUS_OK; i++)
        status = override_apply(*root, override[i], why);
    if (status == STATUS_OK &&
        (s->overrides = joined(override, overrides)) == NULL)
        status = STATUS_NO_MEMORY;
    return status;
}

enum status scene_read(struct scene *s, const char *path,
                       char *const override[], size_t overrides,
                       struct fault *why)
{
    struct node *root = NULL;

    *s = (struct scene){ .text = NULL };
    snprintf(why->text, sizeof why->text, "%s", status_text(STATUS_NO_MEMORY));
    enum status status = read_tree(s, path, override, overrides, &root, why);
    if (status == STATUS_OK)
        status = fill(root, s, why);
    node_free(root);
    if (status != STATUS_OK)
        scene_free(s);
    return status;
}

const char *scene_name(const struct scene *s)
{
    return s->title[0] ? s->title : s->file ? s->file : "command line";
}

void scene_free(struct scene *s)
{
    free(s->title);
    free(s->system);
    free(s->parameter_key);
    free(s->xi);
    free(s->chi_alpha);
    law_typed_free(s->typed);
    free(s->start);
    free(s->rabinowicz.tan_alpha);
    free(s->rabinowicz.data);
    for (int i = 0; i < SCENE_AXES; i++)
        free(s->sweep.axis[i].value);
    free(s->sweep.draft.value);
    scene_ensemble_free(&s->ensemble);
    free(s->paper.font);
    free(s->hdf5);
    free(s->figure);
    free(s->file);
    free(s->text);
    free(s->overrides);
    *s = (struct scene){ .title = NULL };
}

/* A state in the chart. */
static double chart(bool is_log, double x)
{
    return is_log ? log(x) : x;
}

bool scene_axis_is_log(const struct scene *s, int axis)
{
    if (s->system)
        return s->system->state[axis].chart == CHART_POSITIVE;
    return axis == 0 || !law_psi_is_log(&s->law);
}

struct box scene_box(const struct scene *s)
{
    const bool x = scene_axis_is_log(s, 0), y = scene_axis_is_log(s, 1);
    const struct scene_window *w = &s->window;

    return (struct box){ { chart(x, w->v[0]), chart(y, w->psi[0]) },
                         { chart(x, w->v[1]), chart(y, w->psi[1]) } };
}
