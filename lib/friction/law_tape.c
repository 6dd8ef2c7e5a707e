#include "law_tape.h"

#include <assert.h>
#include <math.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>

#include "law_typed.h"
#include "parse.h"
#include "quad.h"

/* ---- names --------------------------------------------------------------- */

/* By sign: a formula may be positive whatever its parameters are. */
static const struct {
    const char *name;
    bool positive;
} model[] = {
    { "tan_alpha", true }, { "mu_star", false }, { "a", true },
    { "b", true },         { "c", true },        { "R", true },
    { "V_c", true },       { "eps2", true },     { LAW_LNV0, false },
    { LAW_Y0, false },
};
enum { MODEL = sizeof model / sizeof *model };
_Static_assert(MODEL + LAW_OWNS + 1 == LAW_VALUES, "one value a name");

static enum formula_leaf leaf_of(bool positive)
{
    return positive ? FORMULA_POSITIVE_PARAMETER : FORMULA_PARAMETER;
}

void law_names(const struct law *law, struct formula *f)
{
    const struct law_typed *t = law->typed;

    formula_init(f);
    for (int i = 0; i < MODEL; i++)
        formula_leaf(f, model[i].name, leaf_of(model[i].positive));
    for (int i = 0; t && i < t->owns; i++)
        formula_know(
            f, formula_leaf(f, t->own[i].name, leaf_of(t->own[i].value > 0)),
            t->own[i].value);
}

void law_values(const struct law *law, const struct material *m,
                formula_real tan_alpha, formula_real x, formula_real y,
                struct formula_value out[LAW_VALUES])
{
    const quad V = m->V_star, gL = (quad) m->g * (quad) m->L;
    const quad R = isinf(m->R) ? (quad) LAW_R_INFINITE : m->R;
    const quad value[MODEL] = {
        tan_alpha, m->mu_star, m->a, m->b, m->c, R, m->V_c, V * V / gL, x, y,
    };
    int n = 0;

    for (; n < MODEL; n++)
        out[n] = (struct formula_value){ model[n].name, value[n] };
    for (int i = 0; law->typed && i < law->typed->owns; i++)
        out[n++] = (struct formula_value){ law->typed->own[i].name, m->own[i] };
    out[n] = (struct formula_value){ NULL, 0 };
}

/* ---- reading ------------------------------------------------------------- */

struct reading {
    struct formula *f;
    enum status status;
    const char **name; /* of what failed */
    struct fault *why;
};

/* The node; 0 after a failure. */
static int read_as(struct reading *r, const char *name, const char *text)
{
    int node = 0;

    if (r->status != STATUS_OK || text == NULL)
        return 0;
    *r->name = name;
    r->status = formula_parse(r->f, text, &node, r->why);
    return node;
}

/* And defined under the name. */
static int define(struct reading *r, const char *name, const char *text)
{
    const int node = read_as(r, name, text);

    if (r->status == STATUS_OK && text)
        formula_define(r->f, name, node);
    return node;
}

/* On the steady curve. */
static void anchor(struct reading *r, const struct law *law,
                   struct plane_formulas *p)
{
    const char *psi_ss = law_text(law, LAW_PSI_SS);
    struct formula *f = r->f;

    p->chart[0] = formula_find(f, LAW_LNV0, sizeof LAW_LNV0 - 1);
    p->at[0] = formula_of(f, FUNCTION_EXP, p->chart[0]);
    formula_name(f, p->at[0], "v0");
    formula_define(f, "v", p->at[0]);
    const int y0 = formula_find(f, LAW_Y0, sizeof LAW_Y0 - 1);
    const int psi0 = psi_ss                ? read_as(r, "psi_ss", psi_ss)
                     : law_psi_is_log(law) ? y0
                                           : formula_of(f, FUNCTION_EXP, y0);
    formula_name(f, psi0, "psi0");
    if (r->status == STATUS_OK && f->node[psi0].moves) {
        snprintf(r->why->text, sizeof r->why->text,
                 "psi stands in it, expected a formula of v");
        r->status = STATUS_BAD_SCENE;
    }
    if (r->status == STATUS_OK)
        r->status = tape_anchor(f, p, 1, psi0, r->why);
}

/* The plane (17), and mu beside it. */
static void name_plane(struct reading *r, const struct law *law,
                       struct plane_formulas *p)
{
    const char *psi_ss = law_text(law, LAW_PSI_SS), *K = law_text(law, LAW_K),
               *rate = law_text(law, LAW_RATE);

    formula_define(r->f, "v", p->state[0]);
    define(r, "theta", law_text(law, LAW_THETA));
    define(r, "psi_ss", psi_ss);
    define(r, "d", psi_ss ? "psi - psi_ss" : NULL);
    define(r, "T", law_text(law, LAW_T));
    define(r, "K", K);
    p->value[0] = define(r, "mu", law_text_mu(law));
    p->values = 1;
    p->rate[0] = read_as(r, "dv",
                         "(tan_alpha - mu)/"
                         "(eps2*sqrt(1 + tan_alpha*tan_alpha))");
    p->rate[1] = read_as(r, "dpsi", rate ? rate : K ? "-K/T" : "-d/T");
}

/* In the order of enum block_observable (block.h). */
static void observe(struct reading *r, struct plane_formulas *p)
{
    const int v = p->state[0];

    p->observable[0] = v;
    p->observable[1] = formula_times(r->f, p->value[0], v);
    p->observable[2] = formula_less(r->f, v, p->at[0]);
    p->observables = 3;
}

static enum status make(const struct law *law, bool equilibrium, bool observed,
                        struct tape_lowered *out, const char **name,
                        struct fault *why)
{
    struct plane_formulas *p = &out->p;
    struct reading r = { &out->f, STATUS_OK, name, why };

    *p = (struct plane_formulas){ .zero = { equilibrium, true } };
    p->state[0] = formula_leaf(&out->f, "v", FORMULA_POSITIVE_STATE);
    p->state[1] = formula_leaf(&out->f, "psi",
                               law_psi_is_log(law) ? FORMULA_STATE
                                                   : FORMULA_POSITIVE_STATE);
    anchor(&r, law, p);
    name_plane(&r, law, p);
    if (observed)
        observe(&r, p);
    *name = r.status == STATUS_OK ? NULL : *name;
    return r.status == STATUS_OK ? tape_lower(&out->t, &out->f, p, why)
                                 : r.status;
}

/* tests/friction/test_law_tape.c: every composition */
static void make_surely(const struct law *law, bool equilibrium, bool observed,
                        struct tape_lowered *out)
{
    struct fault why;
    const char *name;
    const enum status s = make(law, equilibrium, observed, out, &name, &why);

    assert(s == STATUS_OK);
    (void) s;
}

void law_tape(const struct law *law, bool equilibrium, struct tape_lowered *out)
{
    make_surely(law, equilibrium, false, out);
}

enum status law_tape_observed(const struct law *law, bool equilibrium,
                              struct tape_lowered *out, const char **name,
                              struct fault *why)
{
    return make(law, equilibrium, true, out, name, why);
}

/* ---- kept ---------------------------------------------------------------- */

const struct tape_lowered *law_tape_kept(const struct law *law,
                                         bool equilibrium,
                                         struct tape_lowered *room)
{
    static _Atomic(struct tape_lowered *) kept[LAW_COMPOSITIONS][2];
    _Atomic(struct tape_lowered *) *place =
        &kept[law_composition(law)][equilibrium];
    struct tape_lowered *there = atomic_load(place), *made;

    if (law->typed)
        return &law->typed->tape[equilibrium];
    if (there)
        return there;
    made = malloc(sizeof *made);
    room = made ? made : room;
    law_names(law, &room->f);
    make_surely(law, equilibrium, true, room);
    if (made == NULL)
        return room;
    if (atomic_compare_exchange_strong(place, &there, made))
        return made;
    free(made); /* another thread was sooner */
    return there;
}
