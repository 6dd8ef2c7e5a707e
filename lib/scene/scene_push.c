#include "scene_push.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "scene_system.h"
#include "system.h"
#include "text.h"
#include "tolerance.h"
#include "unit_text.h"
#include "value.h"

/* ---- of a law ------------------------------------------------------------ */

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
        if (text_index(n->child[i]->key, known) < 0)
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

static enum status read_push(const struct node *n, struct scene_push *p,
                             struct fault *why)
{
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

/* ---- of a system --------------------------------------------------------- */

static enum status check_state_keys(const struct node *n,
                                    const struct system_state x[2],
                                    struct fault *why)
{
    for (size_t i = 0; i < n->count; i++) {
        const char *key = n->child[i]->key;
        if (strcmp(key, x[0].name) != 0 && strcmp(key, x[1].name) != 0 &&
            strcmp(key, "from") != 0)
            return place_blame(n->child[i]->key_at, why,
                               "ensemble.pushes: unknown key '%s', expected %s "
                               "and %s, perhaps from: EQUILIBRIUM",
                               text_shown(key).text, x[0].name, x[1].name);
    }
    return STATUS_OK;
}

static enum status read_from(const struct node *from, struct scene_push *p,
                             struct fault *why)
{
    if (from->kind != NODE_SCALAR || from->text[0] == '\0' ||
        strlen(from->text) >= sizeof p->from)
        return place_blame(from->at, why,
                           "ensemble.pushes: from: %s is not allowed, expected "
                           "the name of an equilibrium such as stable_node_1",
                           node_shown(from).text);
    strcpy(p->from, from->text);
    return STATUS_OK;
}

/* {x: A, y: B}; or {from: stable_node_1, x: DX, y: DY}, of which one may be
 * missing. */
static enum status read_state(const struct node *n,
                              const struct formula_system *f,
                              struct scene_push *p, struct fault *why)
{
    const struct node *from = node_find(n, "from");
    double *at[] = { &p->v, &p->psi };
    enum status status = check_state_keys(n, f->state, why);

    *p = (struct scene_push){ .v = 0.0 };
    if (status == STATUS_OK && from)
        status = read_from(from, p, why);
    for (int i = 0; i < 2 && status == STATUS_OK; i++) {
        const struct node *value = node_find(n, f->state[i].name);
        const enum formula_chart chart = from ? CHART_REAL : f->state[i].chart;
        if (value == NULL && from && n->count > 1)
            continue;
        if (!scene_system_is_state(value, chart, at[i]))
            status = place_blame(value ? value->at : n->at, why,
                                 "ensemble.pushes: %s: %s, expected %s",
                                 f->state[i].name,
                                 value ? node_shown(value).text : "missing",
                                 scene_system_expected(chart));
    }
    return status;
}

/* ---- the list --------------------------------------------------------------
 */

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
        status =
            n->child[i]->kind != NODE_MAP ? value_refuse(key, n->child[i], why)
            : s->system ? read_state(n->child[i], s->system, &e->push[i], why)
                        : read_push(n->child[i], &e->push[i], why);
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

enum status scene_push_settle(const struct node *root, struct scene *s,
                              struct fault *why)
{
    const struct node *list = node_at(root, "ensemble.pushes");

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
