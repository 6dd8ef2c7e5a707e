#include "study_certificate.h"

#include <math.h>

#include "certificate.h"
#include "interval_math.h"
#include "law_typed.h"
#include "proof_fold.h"
#include "proof_numbers.h"
#include "proof_side.h"
#include "study.h"

/* ---- inputs -------------------------------------------------------------- */

static json_t *law_json(const struct law *law)
{
    json_t *formulas = json_object();

    for (int i = 0; i < LAW_PARTS; i++)
        if (law_text(law, (enum law_part) i))
            json_object_set_new(formulas, law_part_names[i],
                                json_string(law_text(law, (enum law_part) i)));
    return json_pack(
        "{s:s, s:s, s:o}", "friction", friction_form_names[law->form], "state",
        law_psi_is_log(law) ? "real" : "positive", "formulas", formulas);
}

/* Those that can change anything. */
static json_t *material_json(const struct block *b)
{
    const struct law_typed *typed = b->law.typed;
    struct material m = b->material;
    json_t *j = json_object();

    for (int i = 0; i < MATERIAL_KEYS; i++)
        if (law_uses(&b->law, (enum material_key) i))
            json_object_set_new(j, material_key_name((enum material_key) i),
                                certificate_decimal(*material_member(&m, i)));
    for (int i = 0; typed && i < typed->owns; i++)
        json_object_set_new(j, typed->own[i].name,
                            certificate_decimal(m.own[i]));
    return j;
}

static json_t *slope_json(const struct scene *scene)
{
    static const char *const names[] = { "alpha", "alpha_deg", "tan_alpha" };

    return json_pack("{s:o}", names[scene->slope_in],
                     certificate_decimal(scene->slope_given));
}

/* ---- the proof ----------------------------------------------------------- */

/* As many as are proved, and whether these are all. */
static json_t *knees_json(const struct proof_numbers *n, size_t side,
                          const struct proof_branch *b)
{
    json_t *at = json_array();

    for (size_t k = 0; k < b->knees; k++)
        json_array_append_new(
            at, json_pack("{s:o, s:o}", "v",
                          certificate_interval(
                              interval_of_double(n->knee[side][k].v.value)),
                          "psi",
                          certificate_interval(
                              interval_of_double(n->knee[side][k].psi.value))));
    return json_pack("{s:o, s:b}", "at", at, "all", b->no_more == NULL);
}

static json_t *branch_json(const struct proof *p, size_t side)
{
    const struct proof_branch *b = &p->branch[side];
    const struct proof_numbers n = proof_numbers_of(p);
    const bool open = b->end == END_OPEN;

    if (b->not_proved || b->end < 0)
        return json_pack("{s:s}", "not_proved", b->not_proved);
    json_t *j = certificate_tube(b);
    json_t *more =
        json_pack("{s:o, s:o, s:s, s:o*, s:o*}", "until",
                  isfinite(b->until) ? json_real(b->until) : json_null(),
                  "knees", knees_json(&n, side, b), "end", end_names[b->end],
                  "place", open ? NULL : certificate_interval(b->place),
                  "excess", open ? NULL : certificate_interval(b->excess));
    json_object_update(j, more);
    json_decref(more);
    return j;
}

/* An interval, or "absent". */
static json_t *numbers_json(const struct proof *p)
{
    const struct proof_numbers n = proof_numbers_of(p);
    json_t *j = json_object();

    for (size_t i = 0; i < PROOF_NAMED; i++) {
        const struct proof_number *x = &n.at[i];
        json_t *told = x->absent ? json_string("absent")
                       : x->not_proved
                           ? NULL
                           : certificate_interval(interval_of_double(x->value));
        if (told)
            json_object_set_new(j, proof_number_names[i], told);
    }
    return j;
}

/* What becomes of a side; NULL: it is not known. */
static const char *fate_of(const struct law *law, const struct material *m,
                           bool fast)
{
    const int node = proof_has_node(law, m, fast ? 1 : -1);

    return node > 0 ? "node" : node < 0 ? NULL : fast ? "v_infinity" : "v_0";
}

/* Of each row the columns before the first number are on the slow side, those
 * from the second on on the fast one; NULL: no labels are proved. */
static json_t *labels_json(const struct study *s, const struct law *law)
{
    const struct material *m = &s->scene->material;
    const struct basin_map *map = &s->basins;
    const struct proof_row *row = s->label_proof.row;

    if (row == NULL)
        return NULL;
    json_t *v = json_array(), *psi = json_array(), *rows = json_array();
    for (size_t i = 0; i < map->columns; i++)
        json_array_append_new(v, json_real(map->v[i]));
    for (size_t j = 0; j < map->rows; j++) {
        json_array_append_new(psi, json_real(map->psi[j]));
        json_array_append_new(
            rows, json_pack("[i, i]", (int) row[j].slow, (int) row[j].fast));
    }
    return json_pack("{s:s, s:s, s:o, s:o, s:o}", "slow",
                     fate_of(law, m, false), "fast", fate_of(law, m, true), "v",
                     v, "psi", psi, "rows", rows);
}

/* Theorems 15 and 20; NULL: it is not proved. */
static json_t *alone_json(const struct scene *scene)
{
    static const char *const tau[] = { NULL, "below", "above", "rises" };
    const struct proof_inputs in = study_proof_inputs(scene);
    const struct law *law = &scene->law;
    double window[2] = { 0 };
    const enum proof_alone found =
        proof_no_saddle(law, &scene->material, &in, window);
    const char *fate =
        found != PROOF_ALONE_RISING
            ? fate_of(law, &scene->material, found == PROOF_ALONE_FAST)
        : proof_rises_through(law, &scene->material) ? "node"
                                                     : NULL;

    if (found == PROOF_ALONE_NOT)
        return NULL;
    return json_pack("{s:s, s:o*, s:s*}", "tau", tau[found], "window",
                     found == PROOF_ALONE_RISING
                         ? NULL
                         : json_pack("[f, f]", window[0], window[1]),
                     "fate", fate);
}

json_t *study_certificate(const struct study *s)
{
    const struct proof *p = s->proof.exact;
    json_t *alone = p ? NULL : alone_json(s->scene);
    const char *why = alone       ? NULL
                      : p == NULL ? "that there is no saddle was not proved"
                      : p->not_proved.text[0] ? p->not_proved.text
                                              : NULL;

    if (why)
        return json_pack("{s:i, s:s}", "slipway_certificate",
                         CERTIFICATE_VERSION, "not_proved", why);
    return json_pack(
        "{s:i, s:o, s:o, s:o, s:o*, s:o*, s:o*, s:o*, s:o*}",
        "slipway_certificate", CERTIFICATE_VERSION, "law",
        law_json(p ? &p->law.law : &s->scene->law), "material",
        material_json(&s->slider.block), "slope", slope_json(s->scene),
        "no_saddle", alone, "upper", p ? branch_json(p, 0) : NULL, "lower",
        p ? branch_json(p, 1) : NULL, "numbers", p ? numbers_json(p) : NULL,
        "labels", p ? labels_json(s, &p->law.law) : NULL);
}
