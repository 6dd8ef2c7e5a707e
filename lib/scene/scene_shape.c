#include "scene_shape.h"

#include <stdio.h>
#include <string.h>

#include "scene_slope.h"
#include "scene_sweep.h"
#include "tolerance.h"

#define BIT(p) (1u << PRODUCT_##p)

const unsigned scene_shape_curves = BIT(NULLCLINES) | BIT(MANIFOLDS) |
                                    BIT(FRICTION_LAW) | BIT(SPRING_BLOCK) |
                                    BIT(BIFURCATION) | BIT(FOLD_CURVES);
static const unsigned curves_of_system =
    BIT(NULLCLINES) | BIT(FIELD_ARROWS) | BIT(TRAJECTORIES);
static const unsigned maps = BIT(BASINS) | BIT(MARGIN) | BIT(SLIP) | BIT(TIME) |
                             BIT(FRICTION) | BIT(PEAK);

/* Where a path is, or else what holds it. */
static struct place place_of(const struct node *root, const char *path)
{
    const struct node *n = node_at(root, path);
    char section[32];

    if (n == NULL) {
        const size_t size = strcspn(path, ".");
        memcpy(section, path, size);
        section[size] = '\0';
        n = node_find(root, section);
    }
    return n ? n->at : root->at;
}

/* What to type for one point instead. */
static enum status blame(struct place at, const struct scene *s,
                         const char *what, const char *command,
                         struct fault *why)
{
    return place_blame(at, why,
                       "%s: not in a sweep, whose points all have the same "
                       "shape; for one point: slipway %s --set sweep={} --set "
                       "%s=VALUE",
                       what, command, s->sweep.axis[0].key);
}

static enum status check_curves(const struct node *root, const struct scene *s,
                                struct fault *why)
{
    const unsigned curves = s->system ? curves_of_system : scene_shape_curves;
    const struct node *list = node_find(root, "products");
    char what[64];

    for (size_t i = 0; s->products & curves && i < list->count; i++)
        for (int p = 0; p < PRODUCTS; p++)
            if (curves & 1u << p &&
                strcmp(list->child[i]->text, product_names[p]) == 0) {
                snprintf(what, sizeof what, "products: %s", product_names[p]);
                return blame(list->child[i]->at, s, what, "study", why);
            }
    return STATUS_OK;
}

/* ---- runs ---------------------------------------------------------------- */

/* A key by which what has a physical unit becomes another in the scene's own.
 */
static const char *scale_of(const struct scene *s)
{
    static const char *const scale[] = { "material.V_star", "material.L",
                                         "material.R" };

    for (size_t i = 0; i < sizeof scale / sizeof *scale; i++)
        if (scene_sweeps(s, scale[i]))
            return scale[i];
    return NULL;
}

static enum status check_units(const struct node *root, const struct scene *s,
                               struct fault *why)
{
    if (s->physical == NULL || scale_of(s) == NULL)
        return STATUS_OK;
    return place_blame(place_of(root, s->physical), why,
                       "%s: in physical units it would be another at each %s, "
                       "expected dimensionless",
                       s->physical, scale_of(s));
}

static enum status check_starts(const struct node *root, const struct scene *s,
                                struct fault *why)
{
    if (!(s->products & BIT(TRAJECTORIES)))
        return STATUS_OK;
    if (s->starts == 0)
        return place_blame(place_of(root, "products"), why,
                           "products: trajectories without "
                           "trajectories.starts, expected them in a sweep");
    if (s->spread > 0)
        return place_blame(place_of(root, "trajectories.spread"), why,
                           "trajectories.spread: not in a sweep, expected "
                           "trajectories.starts alone");
    if (s->linear_slip > 0 || s->log_time > 0)
        return blame(place_of(root, "trajectories.sample"), s,
                     "trajectories.sample", "simulate", why);
    return STATUS_OK;
}

/* ---- the experiment ------------------------------------------------------ */

static enum status check_release(const struct node *root, const struct scene *s,
                                 struct fault *why)
{
    if (s->rabinowicz.data)
        return blame(place_of(root, "rabinowicz.data"), s, "rabinowicz.data",
                     "rabinowicz", why);
    if (s->rabinowicz.slopes > 0)
        return place_blame(place_of(root, "rabinowicz.tan_alpha"), why,
                           "rabinowicz.tan_alpha: not in a sweep, expected "
                           "sweep: {key: slope.tan_alpha, ...}");
    if (scene_sweep_releases(s) && !scene_has_slope(s))
        return place_blame(place_of(root, "rabinowicz"), why,
                           "rabinowicz: takes a slope in a sweep, expected "
                           "'slope: {alpha: RAD}' or --alpha RAD");
    return STATUS_OK;
}

/* ---- maps ---------------------------------------------------------------- */

static enum status check_cells(const struct node *root, const struct scene *s,
                               struct fault *why)
{
    double points = 1.0;

    for (size_t i = 0; i < s->sweep.axes; i++)
        points *= (double) s->sweep.axis[i].count;
    if (!(s->products & maps) ||
        points * (double) s->cells[0] * (double) s->cells[1] <=
            SCENE_SWEEP_CELLS)
        return STATUS_OK;
    return place_blame(place_of(root, "basins.cells"), why,
                       "basins.cells: %zu x %zu at each of %g points, expected "
                       "at most %g in all (shares do not take them)",
                       s->cells[0], s->cells[1], points, SCENE_SWEEP_CELLS);
}

enum status scene_shape_check(const struct node *root, const struct scene *s,
                              struct fault *why)
{
    if (s->system)
        return check_curves(root, s, why);
    static enum status (*const check[])(
        const struct node *, const struct scene *,
        struct fault *) = { check_curves, check_starts, check_release,
                            check_cells, check_units };
    enum status status = STATUS_OK;

    for (size_t i = 0; i < sizeof check / sizeof *check; i++)
        if (status == STATUS_OK)
            status = check[i](root, s, why);
    return status;
}
