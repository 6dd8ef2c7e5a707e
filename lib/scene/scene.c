/* A scene from file and overrides: tree, table, then what only the whole can
 * tell: a law and one slope are there, parts fit together. */
#include "scene.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "physical.h"
#include "schema.h"
#include "tolerance.h"

enum { FILE_MAX = 1 << 20 };

/* ---- the file ------------------------------------------------------------ */

static enum status cannot_read(const char *path, const char *reason,
                               struct fault *why)
{
    char shown[300];

    node_printable(path, shown, sizeof shown);
    snprintf(why->text, sizeof why->text, "%s: cannot read: %s", shown, reason);
    return STATUS_IO;
}

static enum status read_file(const char *path, char **text, size_t *size,
                             struct fault *why)
{
    FILE *file = fopen(path, "rb");

    if (file == NULL)
        return cannot_read(path, strerror(errno), why);
    *text = malloc(FILE_MAX + 1);
    if (*text == NULL) {
        fclose(file);
        return STATUS_NO_MEMORY;
    }
    errno = 0;
    *size = fread(*text, 1, FILE_MAX + 1, file);
    const int error = ferror(file) ? errno : 0;
    fclose(file);
    if (error)
        return cannot_read(path, strerror(error), why);
    if (*size > FILE_MAX)
        return cannot_read(path, "more than 1 MiB is no scene", why);
    (*text)[*size] = '\0';
    char *fitted = realloc(*text, *size + 1);
    if (fitted)
        *text = fitted;
    return STATUS_OK;
}

/* ---- overrides ----------------------------------------------------------- */

/* Setting one of these keys takes back the others of its group. */
static const char *const alternatives[][2] = {
    { "slope", "alpha" },     { "slope", "alpha_deg" },
    { "slope", "tan_alpha" }, { "law", "preset" },
    { "law", "theta" },       { "law", "psi_ss" },
    { "law", "timescale" },   { "law", "kinetics" },
    { "sample", "log_time" }, { "sample", "linear_slip" },
};

static bool is_component(const char *key)
{
    return strcmp(key, "theta") == 0 || strcmp(key, "psi_ss") == 0 ||
           strcmp(key, "timescale") == 0 || strcmp(key, "kinetics") == 0;
}

static void take_back(struct node *root, const char *set)
{
    for (size_t i = 0; i < sizeof alternatives / sizeof *alternatives; i++) {
        const char *section = alternatives[i][0], *key = alternatives[i][1];
        const size_t n = strlen(section);
        struct node *map = node_find(root, section);
        if (strncmp(set, section, n) != 0 || set[n] != '.' || map == NULL ||
            map->kind != NODE_MAP)
            continue;
        char own[64];
        snprintf(own, sizeof own, "%.*s", (int) strcspn(set + n + 1, "="),
                 set + n + 1);
        const bool both_parts = is_component(own) && is_component(key);
        if (strcmp(own, "friction") != 0 && !both_parts)
            node_remove(map, key);
    }
}

static enum status override_all(struct node *root, char *const override[],
                                size_t overrides, struct fault *why)
{
    enum status s = STATUS_OK;

    for (size_t i = 0; i < overrides && s == STATUS_OK; i++) {
        take_back(root, override[i]);
        s = node_override(root, override[i], why);
    }
    return s;
}

static char *joined(char *const override[], size_t overrides)
{
    size_t size = 1;

    for (size_t i = 0; i < overrides; i++)
        size += strlen(override[i]) + 1;
    char *text = malloc(size), *end = text;
    for (size_t i = 0; text && i < overrides; i++)
        end += sprintf(end, "%s\n", override[i]);
    if (text)
        *end = '\0';
    return text;
}

/* ---- defaults and checks -------------------------------------------------- */

static enum status set_defaults(struct scene *s)
{
    static const double xi[] = { 0.85, 0.9, 0.99, 0.999 };

    s->law.preset = "composed";
    s->law.equation = "composed";
    s->material = material_bristol_board();
    s->window = (struct scene_window){ { 1e-6, 1e6 }, { NAN, NAN }, AXES_LOG };
    s->seed = 1;
    s->rtol = TOL_RTOL_DEFAULT;
    s->xi_count = sizeof xi / sizeof *xi;
    s->title = strdup("");
    s->xi = malloc(sizeof xi);
    if (s->title == NULL || s->xi == NULL)
        return STATUS_NO_MEMORY;
    memcpy(s->xi, xi, sizeof xi);
    return STATUS_OK;
}

/* A preset or all four components. */
static enum status check_law(const struct node *root, struct fault *why)
{
    static const char *const part[] = { "theta", "psi_ss", "timescale",
                                        "kinetics" };
    const struct node *law = node_find(root, "law");
    const bool preset = law && node_find(law, "preset");
    int parts = 0;

    for (int i = 0; i < 4; i++)
        parts += law && node_find(law, part[i]) != NULL;
    if (law == NULL || (!preset && parts == 0))
        return node_blame(law ? law : root, why,
                          "no law: add 'law: {preset: NAME}' or --law NAME "
                          "(see slipway laws)");
    if (preset && parts > 0)
        return node_blame(law, why,
                          "law: either preset or components, not both");
    for (int i = 0; !preset && i < 4; i++)
        if (node_find(law, part[i]) == NULL)
            return node_blame(law, why,
                              "law: a composed law needs theta, psi_ss, "
                              "timescale and kinetics; %s is missing",
                              part[i]);
    return STATUS_OK;
}

static enum status check_slope(const struct node *root, struct fault *why)
{
    const struct node *slope = node_find(root, "slope");

    if (slope == NULL || slope->count == 0)
        return node_blame(slope ? slope : root, why,
                          "no slope: add 'slope: {alpha: RAD}' or --alpha RAD");
    if (slope->count > 1)
        return node_blame(slope->child[1], why,
                          "slope: exactly one of alpha, alpha_deg, tan_alpha, "
                          "not both %s and %s",
                          slope->child[0]->key, slope->child[1]->key);
    return STATUS_OK;
}

static enum status check_material(const struct node *root,
                                  const struct scene *s, struct fault *why)
{
    const struct node *material = node_find(root, "material");
    const struct node *law = node_find(root, "law");
    struct fault reason;

    for (int i = 0; material && i < MATERIAL_KEYS; i++) {
        const enum material_key key = (enum material_key) i;
        const struct node *n = node_find(material, material_key_name(key));
        if (n && !law_uses(&s->law, key))
            return node_blame(n, why, "material.%s: the law %s does not use it",
                              n->key, s->law.preset);
    }
    if (law_uses(&s->law, MATERIAL_V_C) &&
        (material == NULL || node_find(material, "V_c") == NULL))
        return node_blame(law, why,
                          "law.preset: kato_tullis needs material.V_c");
    if (law_check(&s->law, &s->material, &reason) != STATUS_OK)
        return node_blame(law, why, "%s", reason.text);
    return STATUS_OK;
}

static enum status check_window(const struct node *root, struct scene *s,
                                struct fault *why)
{
    const struct node *window = node_find(root, "window");
    const bool is_log = !law_psi_is_log(&s->law);
    struct scene_window *w = &s->window;

    if (isnan(w->psi[0])) {
        w->psi[0] = is_log ? 1e-3 : -7.0;
        w->psi[1] = is_log ? 1e2 : 5.0;
    }
    if (!(w->v[0] >= 1e-300))
        return node_blame(node_find(window, "v"), why,
                          "window.v: %.17g, expected a lower end >= 1e-300",
                          w->v[0]);
    if (is_log && !(w->psi[0] >= 1e-300))
        return node_blame(node_find(window, "psi"), why,
                          "window.psi: %.17g, expected a lower end >= 1e-300",
                          w->psi[0]);
    if (!is_log && !(w->psi[0] >= -TOL_PSI_RANGE && w->psi[1] <= TOL_PSI_RANGE))
        return node_blame(node_find(window, "psi"), why,
                          "window.psi: expected ends between -700 and 700");
    return STATUS_OK;
}

/* Start values become dimensionless; psi > 0 unless it is a logarithm. */
static enum status check_starts(const struct node *root, struct scene *s,
                                struct fault *why)
{
    const bool si = s->units == UNITS_SI;

    for (size_t i = 0; i < s->starts; i++) {
        struct scene_start *z = &s->start[i];
        if ((si || !law_psi_is_log(&s->law)) && !(z->psi > 0.0)) {
            const struct node *n =
                node_find(node_find(root, "trajectories"), "starts");
            return node_blame(n->child[i], why,
                              "trajectories.starts: psi = %.17g, expected a "
                              "number > 0",
                              z->psi);
        }
        if (si) {
            z->v /= s->material.V_star;
            z->psi = physical_psi(&s->law, &s->material, z->psi);
        }
    }
    return STATUS_OK;
}

static enum status check_figure(const struct node *root, const struct scene *s,
                                struct fault *why)
{
    const char *dot = s->figure ? strrchr(s->figure, '.') : ".svg";

    if (dot && (strcmp(dot, ".svg") == 0 || strcmp(dot, ".pdf") == 0 ||
                strcmp(dot, ".png") == 0))
        return STATUS_OK;
    return node_blame(node_find(node_find(root, "output"), "figure"), why,
                      "output.figure: '%s' is not allowed, expected a path "
                      "ending in .svg, .pdf or .png",
                      s->figure);
}

static enum status fill(const struct node *root, struct scene *s,
                        struct fault *why)
{
    enum status status = set_defaults(s);

    if (status == STATUS_OK)
        status = schema_apply(root, s, why);
    if (status == STATUS_OK)
        status = check_law(root, why);
    if (status == STATUS_OK)
        status = check_slope(root, why);
    if (status == STATUS_OK)
        status = check_material(root, s, why);
    if (status == STATUS_OK)
        status = check_window(root, s, why);
    if (status == STATUS_OK)
        status = check_starts(root, s, why);
    if (status == STATUS_OK)
        status = check_figure(root, s, why);
    return status;
}

enum status scene_read(struct scene *s, const char *path,
                       char *const override[], size_t overrides,
                       struct fault *why)
{
    struct node *root = NULL;
    size_t size = 0;
    enum status status = STATUS_OK;

    *s = (struct scene){ .text = NULL };
    snprintf(why->text, sizeof why->text, "%s", status_text(STATUS_NO_MEMORY));
    if (path)
        status = read_file(path, &s->text, &size, why);
    else if ((s->text = strdup("")) == NULL)
        status = STATUS_NO_MEMORY;
    if (status == STATUS_OK)
        status = node_parse(s->text, size, path ? path : "command line", &root,
                            why);
    if (status == STATUS_OK)
        status = override_all(root, override, overrides, why);
    if (status == STATUS_OK && (s->overrides = joined(override, overrides)) == NULL)
        status = STATUS_NO_MEMORY;
    if (status == STATUS_OK)
        status = fill(root, s, why);
    node_free(root);
    if (status != STATUS_OK)
        scene_free(s);
    return status;
}

void scene_free(struct scene *s)
{
    free(s->title);
    free(s->xi);
    free(s->start);
    free(s->hdf5);
    free(s->figure);
    free(s->text);
    free(s->overrides);
    *s = (struct scene){ .title = NULL };
}
