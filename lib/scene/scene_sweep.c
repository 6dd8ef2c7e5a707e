#include "scene_sweep.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "scene_law.h"
#include "scene_shape.h"
#include "scene_vary.h"
#include "schema.h"
#include "tolerance.h"

#define BIT(p) (1u << PRODUCT_##p)

/* The section of axis i. */
static const struct node *section(const struct node *root, size_t i)
{
    const struct node *n = node_find(root, "sweep");

    return n && n->kind == NODE_LIST ? n->child[i] : n;
}

/* The value of a key of that section, or the section where it lacks it. */
static struct place place_of(const struct node *axis, const char *key)
{
    const struct node *n = node_find(axis, key);

    return n ? n->at : axis->at;
}

/* A key in any section; NULL: it is in none. */
static const struct node *find_of_sweep(const struct node *root,
                                        const struct scene_sweep *w,
                                        const char *key)
{
    const struct node *n = NULL;

    for (size_t i = 0; i < w->axes && n == NULL; i++)
        n = node_find(section(root, i), key);
    return n;
}

/* ---- one axis ------------------------------------------------------------ */

static enum status check_given(const struct node *n, const struct scene *s,
                               const struct scene_axis *axis, struct fault *why)
{
    static const char *const part[] = { "from", "to", "points" };

    if (axis->key == NULL)
        return place_blame(n->at, why,
                           "sweep: key is missing, expected the key of a "
                           "number, such as %s",
                           s->system ? "system.parameters.NAME"
                                     : "slope.alpha");
    for (int i = 0; i < 3 && axis->count == 0; i++)
        if (node_find(n, part[i]) == NULL)
            return place_blame(n->at, why,
                               "sweep: %s is missing, expected from, to and "
                               "points, or values",
                               part[i]);
    return STATUS_OK;
}

static enum status check_range(const struct node *n,
                               const struct scene_axis *axis, struct fault *why)
{
    const bool is_log = axis->scale == SWEEP_LOG;
    const double least = axis->count > 0 ? axis->value[0] : axis->from;

    if (axis->count == 0 && !(axis->from < axis->to))
        return place_blame(place_of(n, "from"), why,
                           "sweep: from %g to %g is empty, expected from < to",
                           axis->from, axis->to);
    if (is_log && !(least > 0.0))
        return place_blame(place_of(n, axis->count ? "values" : "from"), why,
                           "sweep: %g on a log scale, expected numbers > 0",
                           least);
    return STATUS_OK;
}

/* On a linear scale the double nearest to the decimal between those typed. */
static double value_between(const struct scene_axis *axis, size_t i)
{
    const size_t n = axis->points - 1;
    const double t = (double) i / (double) n;

    if (i == 0)
        return axis->from;
    if (i == n)
        return axis->to;
    return axis->scale == SWEEP_LOG
               ? axis->from * exp(t * log(axis->to / axis->from))
               : (double) (((long double) (n - i) * number_decimal(axis->from) +
                            (long double) i * number_decimal(axis->to)) /
                           (long double) n);
}

static enum status list_values(struct scene_axis *axis)
{
    if (axis->count > 0)
        return STATUS_OK;
    axis->value = malloc(axis->points * sizeof *axis->value);
    if (axis->value == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < axis->points; i++)
        axis->value[i] = value_between(axis, i);
    axis->count = axis->points;
    return STATUS_OK;
}

/* Every value is allowed for the key, and they ascend. */
static enum status check_values(const struct node *n, const struct scene *s,
                                const struct scene_axis *axis,
                                struct fault *why)
{
    const struct scene_vary vary = scene_vary_at(s, axis->key);
    const struct node *list = node_find(n, "values");
    struct scene trial = *s; /* borrows */

    for (size_t i = 0; i < axis->count; i++) {
        const char *part = list ? "values" : i == 0 ? "from" : "to";
        const struct place at = list ? list->child[i]->at : place_of(n, part);
        if (!scene_vary_set(&vary, axis->value[i], &trial))
            return place_blame(
                at, why, "sweep.%s: %s: %g is not allowed, expected %s", part,
                axis->key, axis->value[i], scene_vary_expected(&vary, s));
        if (i > 0 && !(axis->value[i] > axis->value[i - 1]))
            return place_blame(at, why,
                               "sweep.%s: %.17g after %.17g, expected numbers "
                               "that grow",
                               part, axis->value[i], axis->value[i - 1]);
    }
    return STATUS_OK;
}

/* A name that is no key must be one of the law's own. */
static enum status check_own(const struct node *n, const struct scene *s,
                             const struct scene_axis *axis, struct fault *why)
{
    if (s->system || axis->key == NULL || schema_find(axis->key) ||
        scene_law_find(s, axis->key) >= 0)
        return STATUS_OK;
    return place_blame(place_of(n, "key"), why,
                       "sweep.key: %s is not there, expected its number "
                       "under material, from which the sweep departs",
                       axis->key);
}

static enum status fill_axis(const struct node *n, const struct scene *s,
                             struct scene_axis *axis, struct fault *why)
{
    enum status status = check_given(n, s, axis, why);

    if (status == STATUS_OK)
        status = check_own(n, s, axis, why);
    if (status == STATUS_OK)
        status = check_range(n, axis, why);
    if (status == STATUS_OK)
        status = list_values(axis);
    return status ? status : check_values(n, s, axis, why);
}

/* ---- all of them --------------------------------------------------------- */

static enum status check_pair(const struct node *second, const struct scene *s,
                              struct fault *why)
{
    const struct scene_axis *a = s->sweep.axis;
    const struct place at = place_of(second, "key");

    if (strcmp(a[0].key, a[1].key) == 0 || schema_excludes(a[0].key, a[1].key))
        return place_blame(at, why, "sweep.key: %s beside %s, expected another",
                           a[1].key, a[0].key);
    if (a[0].count * a[1].count > SCENE_POINTS)
        return place_blame(second->at, why,
                           "sweep: a grid of %zu x %zu points, expected at "
                           "most %d in all",
                           a[0].count, a[1].count, SCENE_POINTS);
    if (s->sweep.refine > 0.0)
        return place_blame(second->at, why,
                           "sweep.refine: not for a grid, expected one key");
    return STATUS_OK;
}

static void begin(const struct node *root, struct scene *s)
{
    for (size_t i = 0; i < s->sweep.axes; i++) {
        const struct scene_axis *axis = &s->sweep.axis[i];
        const struct scene_vary vary = scene_vary_at(s, axis->key);
        scene_vary_begin(&vary, root, axis->value[0], s);
    }
}

enum status scene_sweep_fill(const struct node *root, struct scene *s,
                             struct fault *why)
{
    const struct node *n = node_find(root, "sweep");
    enum status status = STATUS_OK;

    if (n == NULL || node_is_nothing(n) || n->count == 0)
        return STATUS_OK;
    if (n->kind == NODE_MAP) {
        s->sweep.axis[0] = s->sweep.draft;
        s->sweep.draft = (struct scene_axis){ .key = NULL };
        s->sweep.axes = 1;
    }
    for (size_t i = 0; i < s->sweep.axes && status == STATUS_OK; i++)
        status = fill_axis(section(root, i), s, &s->sweep.axis[i], why);
    if (status == STATUS_OK && s->sweep.axes == 2)
        status = check_pair(section(root, 1), s, why);
    if (status == STATUS_OK)
        begin(root, s);
    return status;
}

static enum status check_used(const struct node *root, const struct scene *s,
                              size_t i, struct fault *why)
{
    return scene_vary_check_used(s->sweep.axis[i].key, s,
                                 place_of(section(root, i), "key"),
                                 "sweep.key: ", why);
}

bool scene_sweep_y_log(const struct scene_sweep *w)
{
    static const bool own[SHOWS] = {
        [SHOW_VELOCITIES] = true,
        [SHOW_VELOCITY_ESTIMATES] = true,
        [SHOW_FRACTURE_ENERGY] = true,
    };

    return w->y_scale == Y_SCALE_AUTO ? own[w->show]
                                      : w->y_scale == Y_SCALE_LOG;
}

/* What its figure shows is computed. */
static enum status check_shown(const struct node *root, const struct scene *s,
                               struct fault *why)
{
    const unsigned numbers = BIT(KNEES) | BIT(ESTIMATES);
    const unsigned maps = BIT(BASINS) | BIT(MARGIN) | BIT(SLIP) | BIT(TIME) |
                          BIT(FRICTION) | BIT(PEAK);
    const bool basins = s->sweep.show == SHOW_BASINS;
    const unsigned asked = s->products ? s->products : numbers;
    const struct node *products = node_find(root, "products");

    if (s->sweep.show == SHOW_VELOCITIES || asked & (basins ? maps : numbers))
        return STATUS_OK;
    return place_blame(products ? products->at : root->at, why,
                       "products: %s beside sweep.show: %s, expected them",
                       basins ? "no basins" : "neither knees nor estimates",
                       sweep_show_names[s->sweep.show]);
}

/* Its figure can be drawn. */
static enum status check_show(const struct node *root, const struct scene *s,
                              struct fault *why)
{
    const struct scene_sweep *w = &s->sweep;
    const struct node *range = find_of_sweep(root, w, "y_range");

    if (range && scene_sweep_y_log(w) && !(w->y_range[0] > 0.0))
        return place_blame(range->at, why,
                           "sweep.y_range: from %g on a log axis, expected "
                           "numbers > 0",
                           w->y_range[0]);
    if (range && w->axes == 2)
        return place_blame(range->at, why,
                           "sweep.y_range: not for a grid, expected one key");
    return check_shown(root, s, why);
}

/* Of a system: curves have no place in a sweep, nor has what is drawn or
 * refined by numbers that only laws have. */
static enum status check_of_system(const struct node *root,
                                   const struct scene *s, struct fault *why)
{
    static const char *const of_law[] = { "refine", "show", "y_scale",
                                          "y_range" };

    for (size_t i = 0; i < sizeof of_law / sizeof *of_law; i++) {
        const struct node *n = find_of_sweep(root, &s->sweep, of_law[i]);
        if (n)
            return place_blame(n->key_at, why,
                               "sweep.%s: for a law on a slope, not for a "
                               "system",
                               of_law[i]);
    }
    return scene_shape_check(root, s, why);
}

enum status scene_sweep_check(const struct node *root, const struct scene *s,
                              struct fault *why)
{
    const struct node *products = node_find(root, "products");
    enum status status = STATUS_OK;

    if (s->system)
        return s->sweep.axes > 0 ? check_of_system(root, s, why) : STATUS_OK;

    for (size_t i = 0; i < s->sweep.axes && status == STATUS_OK; i++)
        status = check_used(root, s, i, why);
    if (status != STATUS_OK || s->sweep.axes == 0)
        return status;
    status = scene_shape_check(root, s, why);
    if (status != STATUS_OK)
        return status;
    if (s->sweep.refine > 0.0 && s->products && !(s->products & BIT(KNEES)))
        return place_blame(products->at, why,
                           "products: no knees beside sweep.refine, expected "
                           "them: it follows v_plus and v_minus");
    return check_show(root, s, why);
}

bool scene_sweep_releases(const struct scene *s)
{
    const struct scene_rabinowicz *r = &s->rabinowicz;

    return r->block_mass > 0.0 || r->ball_mass > 0.0 || r->restitution >= 0.0;
}

bool scene_sweeps(const struct scene *s, const char *key)
{
    for (size_t i = 0; i < s->sweep.axes; i++)
        if (strcmp(s->sweep.axis[i].key, key) == 0)
            return true;
    return false;
}

void scene_at(const struct scene *s, const double x[], struct scene *point)
{
    *point = *s;
    for (size_t i = 0; i < s->sweep.axes; i++) {
        const struct scene_vary vary = scene_vary_at(s, s->sweep.axis[i].key);
        (void) scene_vary_set(&vary, x[i], point);
    }
}
