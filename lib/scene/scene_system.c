/* The formulas are read once, in the order in which they may use each other:
 * states, parameters, names for expressions, rates, observables. */
#include "scene_system.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "scene_parameter.h"
#include "spell.h"
#include "statements.h"
#include "system.h"
#include "tolerance.h"

#define BIT(p) (1u << PRODUCT_##p)

const unsigned scene_system_products =
    BIT(EQUILIBRIA) | BIT(NULLCLINES) | BIT(FIELD_ARROWS) | BIT(MANIFOLDS) |
    BIT(SENSITIVITIES) | BIT(TRAJECTORIES) | BIT(BASINS) | BIT(MARGIN);

/* ---- places -------------------------------------------------------------- */

/* Where a scalar's text begins: behind a quote, if it has one. */
struct origin {
    struct formula_place at;
    char name[96]; /* of an override */
};

static const struct formula_place *origin_of(struct origin *o,
                                             const struct scene *s,
                                             const struct node *n)
{
    const struct place at = n->at;
    const char *line = s->text;

    o->at = (struct formula_place){ at.name, at.line, at.column };
    if (at.is_set) {
        snprintf(o->name, sizeof o->name, "--set %.*s",
                 (int) strcspn(at.name, "="), at.name);
        o->at = (struct formula_place){ o->name, 0, 0 };
        return &o->at;
    }
    for (size_t i = 1; i < at.line && line; i++)
        line = (line = strchr(line, '\n')) ? line + 1 : NULL;
    if (line && strlen(line) >= at.column && at.column > 0 &&
        strchr("'\"", line[at.column - 1]))
        o->at.column++;
    return &o->at;
}

static enum status expect_map(const struct node *n, const char *path,
                              const char *expected, struct fault *why)
{
    if (n == NULL || n->kind == NODE_MAP || node_is_nothing(n))
        return STATUS_OK;
    return place_blame(n->at, why, "%s: %s is not allowed, expected %s", path,
                       node_shown(n).text, expected);
}

/* One of the words, or the nearest is offered. */
static enum status expect_key(const struct node *n, const char *section,
                              const char *const *words, struct fault *why)
{
    char list[160];

    if (text_index(n->key, words) >= 0)
        return STATUS_OK;
    const char *near = spell_nearest(n->key, words);
    text_list(words, list, sizeof list);
    return place_blame(n->key_at, why, "unknown key '%s.%s', expected %s%s%s%s",
                       section, text_shown(n->key).text, list,
                       near ? " (did you mean " : "", near ? near : "",
                       near ? "?)" : "");
}

/* ---- sections ------------------------------------------------------------ */

/* What is being read. */
struct reading {
    const struct node *node; /* `system` */
    struct scene *s;
    struct formula_system *system;
    const struct node *ode_node; /* NULL: none */
    char *ode_text;              /* owned: cut in place */
    struct statements ode;
    struct fault *why;
};

static const struct node *section(const struct reading *r, const char *key)
{
    return node_find(r->node, key);
}

static enum status blame_axis(const struct reading *r, const struct node *n)
{
    return place_blame(n->at, r->why,
                       "system.state.%s: %s is not allowed, expected real, "
                       "positive, angle or {angle: PERIOD}",
                       n->key, node_shown(n).text);
}

static enum status add_state(const struct reading *r, const char *name,
                             const struct node *n)
{
    static const char *const word[] = { "real", "positive", "angle" };
    static const char *const column[] = { "arc",  "error", "name", "slope",
                                          "time", "type",  NULL };
    const struct node *period = NULL;
    enum formula_chart chart = CHART_REAL;
    struct origin o;

    if (text_index(name, column) >= 0)
        return formula_blame(*origin_of(&o, r->s, n ? n : r->node), r->why,
                             "state %s: results have %s of their own", name,
                             name);
    if (n && n->kind == NODE_SCALAR) {
        while (chart <= CHART_ANGLE && strcmp(n->text, word[chart]) != 0)
            chart++;
        if (chart > CHART_ANGLE)
            return blame_axis(r, n);
    } else if (n) {
        period = node_find(n, "angle");
        chart = CHART_ANGLE;
        if (period == NULL || n->count != 1 || period->kind != NODE_SCALAR)
            return blame_axis(r, n);
    }
    return formula_system_state(r->system, name, chart,
                                period ? period->text : NULL,
                                *origin_of(&o, r->s, n ? n : r->node), r->why);
}

/* Those that `state` names, or else all that have a rate. */
static enum status add_states(const struct reading *r)
{
    const struct node *state = section(r, "state"),
                      *rates = section(r, "rates");
    enum status status = expect_map(
        state, "system.state", "{NAME: real, NAME: positive, ...}", r->why);

    for (size_t i = 0; i < r->ode.count && status == STATUS_OK; i++)
        if (r->ode.at[i].rate)
            status = add_state(r, r->ode.at[i].name,
                               node_find(state, r->ode.at[i].name));
    if (r->ode_node) {
        for (size_t i = 0; state && i < state->count && !status; i++)
            if (formula_system_find_state(r->system, state->child[i]->key) < 0)
                status = place_blame(state->child[i]->key_at, r->why,
                                     "system.state: %s has no rate",
                                     text_shown(state->child[i]->key).text);
        return status;
    }
    const struct node *from = state && state->count > 0 ? state : rates;
    for (size_t i = 0; from && i < from->count && status == STATUS_OK; i++)
        status = add_state(r, from->child[i]->key,
                           from == state ? from->child[i] : NULL);
    return status;
}

typedef enum status adder(struct formula_system *s, const char *name,
                          const char *text, struct formula_place at,
                          struct fault *why);

enum part { PARAMETER, DEFINITION, RATE };

static const struct {
    const char *key, *shape, *what;
    adder *add;
} parts[] = {
    [PARAMETER] = { "parameters", "{NAME: NUMBER, ...}", "a number",
                    formula_system_parameter },
    [DEFINITION] = { "define", "{NAME: FORMULA, ...}", "a formula",
                     formula_system_define },
    [RATE] = { "rates", "{NAME: FORMULA, ...}", "a formula",
               formula_system_rate },
};

static enum part part_of(const struct statement *t)
{
    double x;

    return t->rate ? RATE : number_read(t->text, &x) ? PARAMETER : DEFINITION;
}

static bool is_part(const struct node *n, enum part part)
{
    double x;

    return n->kind == NODE_SCALAR &&
           (part != PARAMETER || (number_read(n->text, &x) && isfinite(x)));
}

/* Those of the ode, of parameters those that the section does not set, then
 * those of the section. */
static enum status add_part(const struct reading *r, enum part part)
{
    const struct node *n = section(r, parts[part].key);
    char path[32];
    struct origin o;

    snprintf(path, sizeof path, "system.%s", parts[part].key);
    enum status status = expect_map(n, path, parts[part].shape, r->why);
    for (size_t i = 0; i < r->ode.count && status == STATUS_OK; i++) {
        const struct statement *t = &r->ode.at[i];
        if (part_of(t) == part && (part != PARAMETER || !node_find(n, t->name)))
            status = parts[part].add(r->system, t->name, t->text,
                                     *origin_of(&o, r->s, r->ode_node), r->why);
    }
    for (size_t i = 0; n && i < n->count && status == STATUS_OK; i++) {
        const struct node *p = n->child[i];
        status = is_part(p, part)
                     ? parts[part].add(r->system, p->key, p->text,
                                       *origin_of(&o, r->s, p), r->why)
                     : place_blame(p->at, r->why,
                                   "%s.%s: %s is not allowed, expected %s",
                                   path, text_shown(p->key).text,
                                   node_shown(p).text, parts[part].what);
    }
    return status;
}

static const char *text_of(const struct node *n)
{
    return n && n->kind == NODE_SCALAR ? n->text : NULL;
}

/* NAME: FORMULA or NAME: {rate: FORMULA, unit: TEXT, long_name: TEXT} */
static enum status add_observables(const struct reading *r)
{
    static const char *const words[] = { "rate", "unit", "long_name", NULL };
    const struct node *n = section(r, "observables");
    enum status status =
        expect_map(n, "system.observables", "{NAME: FORMULA, ...}", r->why);
    struct origin o;

    for (size_t i = 0; n && i < n->count && status == STATUS_OK; i++) {
        const struct node *p = n->child[i];
        const struct node *rate =
            p->kind == NODE_MAP ? node_find(p, "rate") : p;
        for (size_t k = 0; p->kind == NODE_MAP && k < p->count && !status; k++)
            status =
                expect_key(p->child[k], "system.observables", words, r->why);
        if (status == STATUS_OK && text_of(rate) == NULL)
            status = place_blame(p->at, r->why,
                                 "system.observables.%s: %s is not allowed, "
                                 "expected a formula or {rate: FORMULA, ...}",
                                 text_shown(p->key).text, node_shown(p).text);
        if (status == STATUS_OK)
            status = formula_system_observable(
                r->system, p->key, rate->text, text_of(node_find(p, "unit")),
                text_of(node_find(p, "long_name")), *origin_of(&o, r->s, rate),
                r->why);
    }
    return status;
}

static enum status read_system(struct reading *r)
{
    static const char *const words[] = { "state", "parameters",  "define",
                                         "rates", "observables", "ode",
                                         NULL };
    struct origin o;
    enum status status = expect_map(
        r->node, "system", "{state: ..., parameters: ..., rates: ...}", r->why);

    for (size_t i = 0; i < r->node->count && status == STATUS_OK; i++)
        status = expect_key(r->node->child[i], "system", words, r->why);
    if (status == STATUS_OK)
        r->ode_node = section(r, "ode");
    if (status == STATUS_OK)
        status = statements_read(r->ode_node, &r->ode_text, &r->ode, r->why);
    if (status == STATUS_OK)
        status = add_states(r);
    for (int part = PARAMETER; part <= RATE && status == STATUS_OK; part++)
        status = add_part(r, (enum part) part);
    if (status == STATUS_OK)
        status = add_observables(r);
    if (status == STATUS_OK)
        status = formula_system_finish(r->system, *origin_of(&o, r->s, r->node),
                                       r->why);
    free(r->ode_text);
    return status;
}

/* ---- window and starts --------------------------------------------------- */

bool scene_system_is_state(const struct node *n, enum formula_chart chart,
                           double *x)
{
    double read;

    if (n == NULL || n->kind != NODE_SCALAR || !number_read(n->text, &read) ||
        !(fabs(read) <= TOL_RANGE) ||
        (chart == CHART_POSITIVE && read < 1 / TOL_RANGE))
        return false;
    *x = read;
    return true;
}

const char *scene_system_expected(enum formula_chart chart)
{
    return chart == CHART_POSITIVE ? "a number from 1e-300 to 1e300"
                                   : "a number from -1e300 to 1e300";
}

static enum status read_range(const struct node *n,
                              const struct system_state *x, double range[2],
                              struct fault *why)
{
    if (n == NULL && x->chart == CHART_ANGLE) {
        range[1] = 0.5 * (double) x->period;
        range[0] = -range[1];
        return STATUS_OK;
    }
    if (n->kind != NODE_LIST || n->count != 2)
        return place_blame(n->at, why,
                           "window.%s: this is no pair, expected [lo, hi]",
                           x->name);
    for (int k = 0; k < 2; k++)
        if (!scene_system_is_state(n->child[k], x->chart, &range[k]))
            return place_blame(n->child[k]->at, why,
                               "window.%s: %s is not allowed, expected %s",
                               x->name, node_shown(n->child[k]).text,
                               scene_system_expected(x->chart));
    return range[0] < range[1]
               ? STATUS_OK
               : place_blame(n->at, why,
                             "window.%s: [%s, %s] is empty, expected lo < hi",
                             x->name, text_shown(n->child[0]->text).text,
                             text_shown(n->child[1]->text).text);
}

static void take_out(struct node *map, const char *key)
{
    for (size_t i = map ? map->count : 0; i-- > 0;)
        if (strcmp(map->child[i]->key, key) == 0)
            node_remove(map, i);
}

static enum status take_window(struct node *root, struct scene *s,
                               struct fault *why)
{
    const struct system_state *x = s->system->state;
    const char *const words[] = { x[0].name, x[1].name, "axes", NULL };
    double *range[] = { s->window.v, s->window.psi };
    struct node *window = node_find(root, "window");
    enum status status =
        expect_map(window, "window", "{STATE: [lo, hi], ...}", why);

    for (size_t i = 0; window && i < window->count && status == STATUS_OK; i++)
        status = expect_key(window->child[i], "window", words, why);
    for (int i = 0; i < 2 && status == STATUS_OK; i++) {
        const struct node *n = node_find(window, x[i].name);
        if (n == NULL && x[i].chart != CHART_ANGLE)
            return place_blame(window ? window->at : root->at, why,
                               "window.%s is missing, expected [lo, hi]",
                               x[i].name);
        status = read_range(n, &x[i], range[i], why);
        take_out(window, x[i].name);
    }
    return status;
}

static enum status read_start(const struct node *n, const struct scene *s,
                              struct scene_start *out, struct fault *why)
{
    const struct system_state *x = s->system->state;
    const char *const words[] = { x[0].name, x[1].name, NULL };
    double *at[] = { &out->v, &out->psi };

    for (size_t i = 0; n->kind == NODE_MAP && i < n->count; i++) {
        const enum status status =
            expect_key(n->child[i], "trajectories.starts", words, why);
        if (status != STATUS_OK)
            return status;
    }
    for (int i = 0; i < 2; i++) {
        const struct node *value = node_find(n, x[i].name);
        if (!scene_system_is_state(value, x[i].chart, at[i]))
            return place_blame(value ? value->at : n->at, why,
                               "trajectories.starts: %s: %s, expected %s",
                               x[i].name,
                               value ? node_shown(value).text : "missing",
                               scene_system_expected(x[i].chart));
    }
    return STATUS_OK;
}

static enum status take_starts(struct node *root, struct scene *s,
                               struct fault *why)
{
    struct node *n = node_find(root, "trajectories");
    const struct node *list = node_find(n, "starts");
    enum status status = STATUS_OK;

    if (list == NULL)
        return STATUS_OK;
    if (list->kind != NODE_LIST)
        return place_blame(list->at, why,
                           "trajectories.starts: %s is not allowed, expected a "
                           "list [{%s: A, %s: B}, ...]",
                           node_shown(list).text, s->system->state[0].name,
                           s->system->state[1].name);
    s->start = calloc(list->count + 1, sizeof *s->start);
    if (s->start == NULL)
        return STATUS_NO_MEMORY;
    for (s->starts = 0; s->starts < list->count && status == STATUS_OK;
         s->starts++)
        status =
            read_start(list->child[s->starts], s, &s->start[s->starts], why);
    take_out(n, "starts");
    return status;
}

/* ---- the whole ----------------------------------------------------------- */

enum status scene_system_take(struct node *root, struct scene *s,
                              struct fault *why)
{
    struct reading r = { .node = node_find(root, "system"),
                         .s = s,
                         .why = why };

    if (r.node == NULL)
        return STATUS_OK;
    s->system = r.system = malloc(sizeof *r.system);
    if (s->system == NULL)
        return STATUS_NO_MEMORY;
    formula_system_init(s->system);
    s->audit = SCENE_SYSTEM_AUDIT;
    enum status status = read_system(&r);
    if (status == STATUS_OK)
        status =
            scene_parameter_keys(s, section(&r, "parameters"), r.ode_node, why);
    if (status == STATUS_OK)
        status = take_window(root, s, why);
    if (status == STATUS_OK)
        status = take_starts(root, s, why);
    take_out(root, "system");
    return status;
}

enum status scene_system_check(const struct node *root, const struct scene *s,
                               struct fault *why)
{
    const unsigned others = s->products & ~scene_system_products;
    const struct node *axes = node_at(root, "window.axes");
    const struct node *list = node_find(root, "products");
    static const char *const of_law[] = { "trajectories.until.slip",
                                          "trajectories.sample", "basins.exact",
                                          "basins.rtol" };
    char words[200];
    const char *known[PRODUCTS + 1] = { NULL };
    size_t count = 0;

    if (axes && s->window.axes == AXES_EIGEN)
        return place_blame(axes->at, why,
                           "window.axes: eigen is for a law on a slope, "
                           "expected log or linear");
    for (size_t i = 0; i < sizeof of_law / sizeof *of_law; i++) {
        const struct node *n = node_at(root, of_law[i]);
        if (n)
            return place_blame(n->key_at, why,
                               "%s: for a law on a slope, not for a system",
                               of_law[i]);
    }
    if (others == 0)
        return STATUS_OK;
    for (int i = 0; i < PRODUCTS; i++)
        if (scene_system_products >> i & 1u)
            known[count++] = product_names[i];
    text_list(known, words, sizeof words);
    return place_blame(list ? list->at : root->at, why,
                       "products: %s is for a law on a slope, a system has %s",
                       product_names[__builtin_ctz(others)], words);
}
