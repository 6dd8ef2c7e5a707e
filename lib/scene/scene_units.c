#include "scene_units.h"

#include <stdio.h>

#include "number.h"
#include "physical.h"
#include "schema_table.h"
#include "unit_text.h"

struct unit_system scene_units(const struct scene *s)
{
    return physical_units(&s->law, &s->material, s->units == UNITS_SI);
}

/* The first key with a physical unit. */
static void note(struct scene *s, const char *path)
{
    if (s->physical == NULL)
        s->physical = path;
}

/* ---- keys with a dimension ----------------------------------------------- */

/* Whether a number is in the SI's unit: behind it, or the scene's. */
static bool is_si(const struct scene *s, enum unit_text in)
{
    return in == UNIT_TEXT_BARE ? s->units == UNITS_SI : in == UNIT_TEXT_SI;
}

static enum status settle_number(const struct schema_key *key,
                                 const struct node *n, struct scene *s,
                                 double *value, struct fault *why)
{
    const struct unit *unit = unit_text_of(key->unit);
    const struct unit_system units = scene_units(s);
    enum unit_text in = UNIT_TEXT_BARE;
    double x;

    if (!unit_text_read(unit, n->text, &x, &in) || !is_si(s, in))
        return STATUS_OK; /* `inf` has no unit */
    note(s, key->path);
    *value = x / unit_scale(&units, unit);
    if (*value >= key->lo && *value <= key->hi)
        return STATUS_OK;
    return place_blame(n->at, why, "%s: %s is %g%s, expected %s", key->path,
                       node_shown(n).text, *value,
                       unit_text_name(unit, UNIT_TEXT_OWN).text, key->expected);
}

static enum status settle_key(const struct schema_key *key,
                              const struct node *n, struct scene *s,
                              struct fault *why)
{
    double *value = (double *) (void *) ((char *) s + key->offset);
    enum status status = STATUS_OK;

    if (n->kind == NODE_SCALAR)
        return settle_number(key, n, s, value, why);
    for (size_t i = 0; i < n->count && status == STATUS_OK; i++)
        status = settle_number(key, n->child[i], s, &value[i], why);
    if (status == STATUS_OK && !(value[0] < value[1]))
        return place_blame(n->at, why,
                           "%s: [%s, %s] is empty, expected lo < hi", key->path,
                           text_shown(n->child[0]->text).text,
                           text_shown(n->child[1]->text).text);
    return status;
}

/* ---- states -------------------------------------------------------------- */

static enum status settle_start(const struct node *n, struct scene *s,
                                struct scene_start *start, struct fault *why)
{
    const struct node *v = node_find(n, "v"), *psi = node_find(n, "psi");
    enum unit_text in = UNIT_TEXT_BARE;
    double x;

    (void) unit_text_read(unit_find("V_star"), v->text, &x, &in);
    const bool si = is_si(s, in);
    if (si)
        start->v /= s->material.V_star;
    if ((si || !psi) && s->products & 1u << PRODUCT_TRAJECTORIES)
        note(s, "trajectories.starts");
    if (psi && s->units == UNITS_SI)
        return place_blame(psi->key_at, why,
                           "trajectories.starts: psi: it could be psi or phi, "
                           "expected phi beside units: si");
    if (!psi)
        start->psi = physical_psi(&s->law, &s->material, start->psi);
    return STATUS_OK;
}

static enum status settle_window(const struct node *root, struct scene *s,
                                 struct fault *why)
{
    const struct node *psi = node_at(root, "window.psi");
    const struct node *phi = node_at(root, "window.phi");

    if (psi && s->units == UNITS_SI)
        return place_blame(psi->key_at, why,
                           "window.psi: it could be psi or phi, expected "
                           "window.phi beside units: si");
    for (int i = 0; phi && i < 2; i++) {
        note(s, "window.phi");
        if (!(s->window.psi[i] > 0.0))
            return place_blame(phi->child[i]->at, why,
                               "window.phi: %s is not allowed, expected a "
                               "number > 0",
                               node_shown(phi->child[i]).text);
        s->window.psi[i] =
            physical_psi(&s->law, &s->material, s->window.psi[i]);
    }
    return STATUS_OK;
}

enum status scene_units_settle(const struct node *root, struct scene *s,
                               struct fault *why)
{
    const struct node *starts = node_at(root, "trajectories.starts");
    enum status status = settle_window(root, s, why);

    for (const struct schema_key *key = schema_table; key->path; key++) {
        const struct node *n = node_at(root, key->path);
        if (unit_text_of(key->unit) && n && status == STATUS_OK)
            status = settle_key(key, n, s, why);
    }
    for (size_t i = 0; i < s->starts && status == STATUS_OK; i++)
        status = settle_start(starts->child[i], s, &s->start[i], why);
    return status;
}

/* ---- elsewhere ----------------------------------------------------------- */

static bool read_rate(const struct scene *s, const char *text, double *v)
{
    enum unit_text in;
    double x;

    if (!unit_text_read(unit_find("V_star"), text, &x, &in))
        return false;
    *v = is_si(s, in) ? x / s->material.V_star : x;
    return true;
}

bool scene_state_read(const struct scene *s, const struct scene_state *text,
                      struct scene_start *out, const char **wrong,
                      char expected[128])
{
    struct scene_start z;

    *wrong = text->v;
    snprintf(expected, 128, "expected a number, perhaps with m/s or V_star");
    if (!text->v || !read_rate(s, text->v, &z.v))
        return false;
    *wrong = text->psi && text->phi ? text->psi : NULL;
    snprintf(expected, 128, "expected psi or phi, one of them");
    if (!text->psi == !text->phi)
        return false;
    *wrong = text->psi ? text->psi : text->phi;
    snprintf(expected, 128, "expected a number%s", text->phi ? " > 0" : "");
    if (!number_read(*wrong, &z.psi) || (text->phi && !(z.psi > 0.0)))
        return false;
    snprintf(
        expected, 128,
        "expected phi (unit %s) instead of psi, as the scene has units: si",
        physical_unit(&s->law));
    if (text->psi && s->units == UNITS_SI)
        return false;
    if (text->phi)
        z.psi = physical_psi(&s->law, &s->material, z.psi);
    *out = z;
    return true;
}
