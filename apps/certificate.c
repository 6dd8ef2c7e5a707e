#include "certificate.h"

#include <stdlib.h>

#include "command.h"
#include "interval_math.h"
#include "json.h"
#include "law_typed.h"
#include "number.h"
#include "output.h"
#include "proof_fold.h"
#include "proof_numbers.h"
#include "proof_side.h"
#include "records.h"
#include "replace.h"

enum { CERTIFICATE_VERSION = 3 };

/* ---- inputs -------------------------------------------------------------- */

static json_t *decimal(double x)
{
    return json_string(number_shortest(x).text);
}

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
                                decimal(*material_member(&m, i)));
    for (int i = 0; typed && i < typed->owns; i++)
        json_object_set_new(j, typed->own[i].name, decimal(m.own[i]));
    return j;
}

static json_t *slope_json(const struct scene *scene)
{
    static const char *const names[] = { "alpha", "alpha_deg", "tan_alpha" };

    return json_pack("{s:o}", names[scene->slope_in],
                     decimal(scene->slope_given));
}

/* ---- the proof ----------------------------------------------------------- */

static json_t *interval_json(struct interval u)
{
    const struct interval_double out = interval_outward(u);

    return json_pack("[f, f]", out.lo, out.hi);
}

static json_t *piece_json(const struct proof_branch *b,
                          const struct proof_piece *p)
{
    json_t *coef = json_array(), *cells = json_array();

    for (size_t k = 0; k <= p->degree; k++)
        json_array_append_new(coef, json_real(p->coef[k]));
    for (size_t k = p->first; k < p->first + p->cells; k++)
        json_array_append_new(cells,
                              json_pack("[f, f, f, o]", b->cell[k].to,
                                        b->cell[k].radius, b->cell[k].after,
                                        interval_json(b->cell[k].excess)));
    return json_pack("{s:s, s:f, s:f, s:o, s:o}", "independent",
                     p->ind == 0 ? "x" : "y", "start", p->start, "step",
                     p->step, "coef", coef, "cells", cells);
}

/* As many as are proved, and whether these are all. */
static json_t *knees_json(const struct proof_numbers *n, size_t side,
                          const struct proof_branch *b)
{
    json_t *at = json_array();

    for (size_t k = 0; k < b->knees; k++)
        json_array_append_new(
            at,
            json_pack(
                "{s:o, s:o}", "v",
                interval_json(interval_of_double(n->knee[side][k].v.value)),
                "psi",
                interval_json(interval_of_double(n->knee[side][k].psi.value))));
    return json_pack("{s:o, s:b}", "at", at, "all", b->no_more == NULL);
}

/* An open branch may have no cells, but the cone's piece. */
static json_t *branch_json(const struct proof *p, size_t side)
{
    const struct proof_branch *b = &p->branch[side];
    const struct proof_numbers n = proof_numbers_of(p);
    const bool open = b->end == END_OPEN;
    json_t *pieces = json_array();

    if (b->not_proved || b->end < 0)
        return json_pack("{s:s}", "not_proved", b->not_proved);
    for (size_t i = 0; i < b->pieces && (i == 0 || b->piece[i].cells); i++)
        json_array_append_new(pieces, piece_json(b, &b->piece[i]));
    return json_pack("{s:{s:f, s:f, s:o}, s:o, s:o, s:o, s:s, s:o*, s:o*}",
                     "cone", "reach", b->cone.reach, "slope", b->cone.slope,
                     "excess", interval_json(b->cone.excess), "pieces", pieces,
                     "until",
                     isfinite(b->until) ? json_real(b->until) : json_null(),
                     "knees", knees_json(&n, side, b), "end", end_names[b->end],
                     "place", open ? NULL : interval_json(b->place), "excess",
                     open ? NULL : interval_json(b->excess));
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
                           : interval_json(interval_of_double(x->value));
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

static json_t *proof_json(const struct study *s)
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

/* ---- the file ------------------------------------------------------------ */

enum status certificate_check(const struct options *o,
                              const struct scene *scene, struct fault *why)
{
    if (o->certificate == NULL)
        return STATUS_OK;
    if (scene->system)
        return command_refuse(why,
                              "--certificate %s: not for a system of formulas, "
                              "expected a law on a slope",
                              o->certificate);
    if (!scene->proved)
        return command_refuse(why,
                              "--certificate %s: nothing is proved, expected a "
                              "slope and --proved",
                              o->certificate);
    return output_path_check(o, scene, o->certificate, why);
}

enum status certificate_write(const struct options *o, const struct study *s,
                              struct fault *why)
{
    char *text = NULL;
    size_t size = 0;

    if (o->certificate == NULL)
        return STATUS_OK;
    FILE *out = open_memstream(&text, &size);
    if (out == NULL)
        return STATUS_NO_MEMORY;
    const bool whole = json_write(proof_json(s), out);
    enum status status =
        fclose(out) == 0 && whole ? STATUS_OK : STATUS_NO_MEMORY;
    if (status == STATUS_OK)
        status = replace_file(o->certificate, text, size, why);
    free(text);
    if (status == STATUS_OK)
        output_tell(o, o->certificate);
    return status;
}
