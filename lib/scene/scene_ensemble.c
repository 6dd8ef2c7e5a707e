#include "scene_ensemble.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "scene_parameter.h"
#include "scene_push.h"
#include "scene_scatter.h"
#include "schema.h"
#include "synonym.h"
#include "text.h"
#include "tolerance.h"
#include "value.h"

const char *const spread_names[] = { "normal", "uniform", "lognormal", NULL };
const char *const ensemble_method_names[] = { "sobol", "random", "grid", NULL };

/* ---- parameters ---------------------------------------------------------- */

static const char *const spread_expected[] = {
    [SPREAD_NORMAL] = "{normal: [mean, standard deviation > 0]}",
    [SPREAD_UNIFORM] = "{uniform: [lo, hi]}, lo < hi",
    [SPREAD_LOGNORMAL] = "{lognormal: [median > 0, factor > 1]}",
};

static bool is_law(const struct scene_spread *p)
{
    switch (p->law) {
        case SPREAD_NORMAL:
            return p->of[1] > 0.0;
        case SPREAD_UNIFORM:
            return p->of[0] < p->of[1];
        case SPREAD_LOGNORMAL:
            return p->of[0] > 0.0 && p->of[1] > 1.0;
    }
    return false;
}

/* The value of a parameter that is exceeded with probability 1/2, in the
 * scene's units. */
static double scene_spread_median(const struct scene_spread *p)
{
    return p->law == SPREAD_UNIFORM ? 0.5 * p->of[0] + 0.5 * p->of[1]
                                    : p->of[0];
}

/* {normal: [m, s]} and its like. */
static enum status read_law(const struct node *n, struct scene_spread *p,
                            struct fault *why)
{
    static const struct schema_key number = { .lo = -DBL_MAX, .hi = DBL_MAX };
    const struct node *law =
        n->kind == NODE_MAP && n->count == 1 ? n->child[0] : NULL;
    int word = 0;

    while (law && spread_names[word] && strcmp(law->key, spread_names[word]))
        word++;
    if (law == NULL || spread_names[word] == NULL)
        return place_blame(law ? law->key_at : n->at, why,
                           "ensemble.parameters: %s: %s%s%s is not allowed, "
                           "expected {normal: [m, s]}, {uniform: [lo, hi]} or "
                           "{lognormal: [median, factor]}",
                           text_shown(n->key).text, law ? "'" : "",
                           law ? text_shown(law->key).text : node_shown(n).text,
                           law ? "'" : "");
    p->law = (enum spread_law) word;
    if (law->kind == NODE_LIST && law->count == 2 &&
        value_is_number(&number, law->child[0], &p->of[0]) &&
        value_is_number(&number, law->child[1], &p->of[1]) && is_law(p))
        return STATUS_OK;
    return place_blame(law->at, why,
                       "ensemble.parameters: %s: %s is not allowed, expected "
                       "%s",
                       text_shown(n->key).text, node_shown(law).text,
                       spread_expected[word]);
}

struct scene_spread *scene_ensemble_add(struct scene_ensemble *e,
                                        const char *key)
{
    const size_t size = (e->parameters + 1) * sizeof *e->parameter;
    struct scene_spread *p = realloc(e->parameter, size);

    if (p)
        e->parameter = p;
    char *copy = p ? text_copy(key, strlen(key)) : NULL;
    if (copy == NULL)
        return NULL;
    p += e->parameters++;
    *p = (struct scene_spread){ .key = copy };
    return p;
}

VALUE_READER(value_spreads)
{
    struct scene_ensemble *e = &s->ensemble;
    enum status status = STATUS_OK;

    if (n->kind != NODE_MAP || n->count == 0 ||
        n->count + e->scattered > SCENE_SPREADS)
        return value_refuse(key, n, why);
    for (size_t i = 0; i < n->count && status == STATUS_OK; i++) {
        struct scene_spread *p = scene_ensemble_add(e, n->child[i]->key);
        status = p ? read_law(n->child[i], p, why) : STATUS_NO_MEMORY;
    }
    return status;
}

/* ---- numbers ------------------------------------------------------------- */

static void free_numbers(struct scene_ensemble *e)
{
    for (size_t i = 0; i < e->numbers; i++)
        free(e->number[i].name);
    free(e->number);
    e->number = NULL;
    e->numbers = 0;
}

VALUE_READER(value_numbers)
{
    struct scene_ensemble *e = &s->ensemble;

    if (n->kind != NODE_LIST || n->count > SCENE_NUMBERS)
        return value_refuse(key, n, why);
    free_numbers(e);
    e->number = calloc(n->count + 1, sizeof *e->number);
    if (e->number == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < n->count; i++) {
        const struct node *one = n->child[i];
        if (one->kind != NODE_SCALAR)
            return value_refuse(key, one, why);
        e->number[i] =
            (struct scene_number){ text_copy(one->text, strlen(one->text)),
                                   one->at.is_set, one->at.line,
                                   one->at.column };
        if (e->number[i].name == NULL)
            return STATUS_NO_MEMORY;
        e->numbers++;
    }
    return STATUS_OK;
}

/* ---- the whole ----------------------------------------------------------- */

bool scene_ensemble_has(const struct scene *s, const char *key)
{
    const struct scene_ensemble *e = &s->ensemble;

    for (size_t i = 0; i < e->parameters; i++)
        if (strcmp(e->parameter[i].key, key) == 0)
            return true;
    return e->samples || e->covariance;
}

static void begin(const struct node *root, struct scene *s)
{
    for (size_t i = 0; i < s->ensemble.parameters; i++) {
        const struct scene_spread *p = &s->ensemble.parameter[i];
        const struct scene_vary vary = scene_vary_at(s, p->key);
        scene_vary_begin(&vary, root, scene_spread_median(p), s);
    }
}

enum status scene_ensemble_settle(const struct node *root, struct scene *s,
                                  struct fault *why)
{
    begin(root, s);
    return scene_push_settle(root, s, why);
}

enum status scene_ensemble_check_key(const struct scene *s, const char *path,
                                     struct place at, struct fault *why)
{
    const struct scene_vary vary = scene_vary_at(s, path);
    const char *known[SCHEMA_KEYS_MAX + 1] = { NULL };
    size_t count = 0;

    for (const struct schema_key *k = schema_table; k->path; k++)
        if (value_is_real(k))
            known[count++] = k->path;
    if (s->system ? !scene_parameter_is(s, path) : !scene_vary_is(&vary)) {
        const char *near = synonym_nearest(
            path, s->system ? (const char *const *) s->parameter_key : known);
        return place_blame(at, why,
                           "'%s' is no key of a number, expected one such as "
                           "%s%s%s%s",
                           text_shown(path).text,
                           s->system ? "system.parameters.NAME" : "material.a",
                           near ? " (did you mean " : "", near ? near : "",
                           near ? "?)" : "");
    }
    return scene_vary_check_used(path, s, at, "", why);
}

/* Where the key of parameter i stands, and its value. */
static void find_places(const struct node *root, const struct scene *s,
                        size_t i, char set[SCENE_SCATTER_SET],
                        struct place *key, struct place *value)
{
    const size_t scattered = s->ensemble.scattered;

    if (i < scattered) {
        *key = *value = scene_scatter_place(s, &s->ensemble.parameter[i], set);
        return;
    }
    const struct node *list = node_at(root, "ensemble.parameters");
    *key = list->child[i - scattered]->key_at;
    *value = list->child[i - scattered]->at;
}

static enum status check_parameter(const struct node *root,
                                   const struct scene *s, size_t i,
                                   struct fault *why)
{
    const struct scene_spread *p = &s->ensemble.parameter[i];
    struct scene trial = *s; /* borrows */
    struct place at, value;
    char set[SCENE_SCATTER_SET];

    find_places(root, s, i, set, &at, &value);
    const enum status status = scene_ensemble_check_key(s, p->key, at, why);
    if (status != STATUS_OK)
        return status;
    for (size_t j = 0; j < i; j++)
        if (strcmp(s->ensemble.parameter[j].key, p->key) == 0)
            return place_blame(at, why,
                               "ensemble.parameters: %s has a scatter where "
                               "it stands, expected one of the two",
                               p->key);
        else if (schema_excludes(s->ensemble.parameter[j].key, p->key))
            return place_blame(at, why, "%s beside %s, expected one of the two",
                               p->key, s->ensemble.parameter[j].key);
    const struct scene_vary vary = scene_vary_at(s, p->key);
    return scene_vary_set(&vary, scene_spread_median(p), &trial)
               ? STATUS_OK
               : place_blame(value, why,
                             "ensemble.parameters: %s: its median %g is not "
                             "allowed, expected %s",
                             p->key, scene_spread_median(p),
                             scene_vary_expected(&vary, s));
}

enum status scene_ensemble_check(const struct node *root, const struct scene *s,
                                 struct fault *why)
{
    enum status status = scene_scatter_check(s, why);

    for (size_t i = 0; i < s->ensemble.parameters && status == STATUS_OK; i++)
        status = check_parameter(root, s, i, why);
    return status;
}

void scene_ensemble_free(struct scene_ensemble *e)
{
    for (size_t i = 0; i < e->parameters; i++)
        free(e->parameter[i].key);
    free(e->parameter);
    free_numbers(e);
    free(e->push);
    free(e->samples);
    free(e->covariance);
    *e = (struct scene_ensemble){ .draws = 0 };
}
