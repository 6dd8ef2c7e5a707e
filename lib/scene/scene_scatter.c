#include "scene_scatter.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "number.h"
#include "scene_ensemble.h"
#include "tolerance.h"

static enum status blame(const struct node *n, const char *path,
                         const char *text, struct fault *why)
{
    return place_blame(n->at, why,
                       "%s: '%s' is not allowed, expected X +- S, two numbers, "
                       "S > 0",
                       path, text_shown(text).text);
}

/* "X +- S" as X, which is left in the node, and S. */
static enum status take(struct node *n, const char *path, struct scene *s,
                        struct fault *why)
{
    struct scene_ensemble *e = &s->ensemble;
    char *sign = n->kind == NODE_SCALAR ? strstr(n->text, "+-") : NULL;
    double x[2];

    if (sign == NULL)
        return STATUS_OK;
    char whole[64], *end = sign;
    snprintf(whole, sizeof whole, "%s", n->text);
    while (end > n->text && end[-1] == ' ')
        end--;
    *end = '\0';
    sign += 2 + strspn(sign + 2, " ");
    if (!number_read(n->text, &x[0]) || !number_read(sign, &x[1]) ||
        !isfinite(x[0]) || !isfinite(x[1]) || !(x[1] > 0.0))
        return blame(n, path, whole, why);
    if (e->scattered == SCENE_SPREADS)
        return place_blame(n->at, why, "more than %d inputs X +- S",
                           SCENE_SPREADS);
    struct scene_spread *p = scene_ensemble_add(e, path);
    if (p == NULL)
        return STATUS_NO_MEMORY;
    e->scattered++;
    *p = (struct scene_spread){ p->key,       SPREAD_NORMAL, { x[0], x[1] },
                                n->at.is_set, n->at.line,    n->at.column };
    return STATUS_OK;
}

/* All of a map at that path. */
static enum status take_all(struct node *map, const char *path, struct scene *s,
                            struct fault *why)
{
    enum status status = STATUS_OK;
    char key[128];

    for (size_t i = 0; map && i < map->count && status == STATUS_OK; i++) {
        snprintf(key, sizeof key, "%s.%s", path,
                 map->child[i]->key ? map->child[i]->key : "");
        status = take(map->child[i], key, s, why);
    }
    return status;
}

enum status scene_scatter_take(struct node *root, struct scene *s,
                               struct fault *why)
{
    struct node *gravity = node_find(root, "gravity");
    enum status status =
        take_all(node_find(root, "material"), "material", s, why);

    s->ensemble.is_drawn = node_at(root, "ensemble.draws") != NULL;
    if (status == STATUS_OK)
        status = take_all(node_find(root, "slope"), "slope", s, why);
    if (status == STATUS_OK && gravity)
        status = take(gravity, "gravity", s, why);
    if (status == STATUS_OK)
        status = take_all(node_find(node_find(root, "system"), "parameters"),
                          "system.parameters", s, why);
    return status;
}

struct place scene_scatter_place(const struct scene *s,
                                 const struct scene_spread *p,
                                 char set[SCENE_SCATTER_SET])
{
    snprintf(set, SCENE_SCATTER_SET, "%s=%s +- %s", p->key,
             number_shortest(p->of[0]).text, number_shortest(p->of[1]).text);
    return (struct place){ p->is_set ? set : s->file, p->is_set, p->line,
                           p->column };
}

enum status scene_scatter_check(const struct scene *s, struct fault *why)
{
    const struct scene_ensemble *e = &s->ensemble;
    char set[SCENE_SCATTER_SET];

    return e->scattered > 0 && (e->samples || e->covariance)
               ? place_blame(scene_scatter_place(s, e->parameter, set), why,
                             "%s: X +- S beside ensemble.%s, expected one of "
                             "the two",
                             e->parameter[0].key,
                             e->samples ? "samples" : "covariance")
               : STATUS_OK;
}

enum status scene_scatter_refuse(const struct scene *s, const char *what,
                                 struct fault *why)
{
    const struct scene_spread *p = s->ensemble.parameter;
    char set[SCENE_SCATTER_SET];

    return s->ensemble.scattered > 0
               ? place_blame(scene_scatter_place(s, p, set), why,
                             "%s: %s does not tell what +- makes, expected a "
                             "number, or knees, portrait, study, basin, "
                             "push or ensemble",
                             p->key, what)
               : STATUS_OK;
}
