#include "scene_ensemble.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "scene_parameter.h"
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

/* ---- pushes -------------------------------------------------------------- */

static const struct schema_key push_rate = { .path = "ensemble.pushes: v",
                                             .lo = 0.0,
                                             .open_lo = true,
                                             .hi = DBL_MAX,
                                             .unit = "V_star",
                                             .expected = "a number > 0" };
static const struct schema_key push_kick = { .path = "ensemble.pushes: kick",
                                             .lo = -DBL_MAX,
                                             .hi = DBL_MAX,
                                             .unit = "V_star",
                                             .expected = "a number" };
static const struct schema_key push_state = { .path = "ensemble.pushes: psi",
                                              .lo = -DBL_MAX,
                                              .hi = DBL_MAX,
                                              .expected = "a number" };

static enum status check_push_keys(const struct node *n, struct fault *why)
{
    static const char *const known[] = {
        "v", "psi", "phi", "from", "kick", NULL
    };

    for (size_t i = 0; i < n->count; i++) {
        int word = 0;
        while (known[word] && strcmp(known[word], n->child[i]->key) != 0)
            word++;
        if (known[word] == NULL)
            return place_blame(n->child[i]->key_at, why,
                               "ensemble.pushes: unknown key '%s', expected v "
                               "and psi, or from: creep and kick",
                               text_shown(n->child[i]->key).text);
    }
    return STATUS_OK;
}

/* {from: creep, kick: DV}. */
static enum status read_kick(const struct node *n, struct scene_push *p,
                             struct fault *why)
{
    const struct node *from = node_find(n, "from");
    const struct node *kick = node_find(n, "kick");

    if (n->count != 2 || !from || !kick || from->kind != NODE_SCALAR ||
        strcmp(from->text, "creep") != 0)
        return place_blame(from ? from->at : n->at, why,
                           "ensemble.pushes: expected {from: creep, kick: DV}");
    *p = (struct scene_push){ .from_creep = true };
    return value_is_number(&push_kick, kick, &p->v)
               ? STATUS_OK
               : value_refuse(&push_kick, kick, why);
}

static enum status read_push(const struct schema_key *key, const struct node *n,
                             struct scene_push *p, struct fault *why)
{
    if (n->kind != NODE_MAP)
        return value_refuse(key, n, why);
    const struct node *v = node_find(n, "v"), *psi = node_find(n, "psi");
    const struct node *phi = node_find(n, "phi");
    const enum status status = check_push_keys(n, why);

    if (status != STATUS_OK)
        return status;
    if (node_find(n, "from") || node_find(n, "kick"))
        return read_kick(n, p, why);
    if (!v || !psi == !phi)
        return place_blame(n->at, why,
                           "ensemble.pushes: expected v and psi (or phi), or "
                           "from: creep and kick");
    *p = (struct scene_push){ .is_phi = phi != NULL };
    psi = psi ? psi : phi;
    if (!value_is_number(&push_rate, v, &p->v))
        return value_refuse(&push_rate, v, why);
    if (!value_is_number(&push_state, psi, &p->psi) ||
        (p->is_phi && !(p->psi > 0.0)))
        return value_refuse(&push_state, psi, why);
    return STATUS_OK;
}

VALUE_READER(value_pushes)
{
    struct scene_ensemble *e = &s->ensemble;
    enum status status = STATUS_OK;

    if (n->kind != NODE_LIST || n->count > SCENE_PUSHES)
        return value_refuse(key, n, why);
    free(e->push);
    e->pushes = 0;
    e->push = calloc(n->count + 1, sizeof *e->push);
    if (e->push == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < n->count && status == STATUS_OK; i++)
        status = read_push(key, n->child[i], &e->push[i], why);
    e->pushes = n->count;
    return status;
}

/* Whether its slip rate is in m/s. */
static bool is_si(const struct scene *s, const struct node *rate)
{
    enum unit_text in = UNIT_TEXT_BARE;
    double x;

    (void) unit_text_read(unit_text_of("V_star"), rate->text, &x, &in);
    return in == UNIT_TEXT_BARE ? s->units == UNITS_SI : in == UNIT_TEXT_SI;
}

static enum status settle_pushes(const struct node *list, struct scene *s,
                                 struct fault *why)
{
    for (size_t i = 0; i < s->ensemble.pushes; i++) {
        const struct node *n = list->child[i], *psi = node_find(n, "psi");
        struct scene_push *p = &s->ensemble.push[i];
        p->is_si = is_si(s, node_find(n, p->from_creep ? "kick" : "v"));
        if (psi && s->units == UNITS_SI)
            return place_blame(psi->key_at, why,
                               "ensemble.pushes: psi: it could be psi or phi, "
                               "expected phi beside units: si");
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
    const struct node *pushes = node_at(root, "ensemble.pushes");

    begin(root, s);
    return pushes ? settle_pushes(pushes, s, why) : STATUS_OK;
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
    const struct node *pushes = node_at(root, "ensemble.pushes");
    enum status status = scene_scatter_check(s, why);

    if (status == STATUS_OK && s->system && pushes)
        return place_blame(pushes->key_at, why,
                           "ensemble.pushes: for a law on a slope, not for a "
                           "system");
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
