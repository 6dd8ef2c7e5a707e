/* The law as formulas, lowered to differences (law_tape.h) and written. */
#include "field_text.h"

#include <assert.h>
#include <math.h>
#include <string.h>
#include <strings.h>

#include "law_tape.h"

const struct text_symbol text_parameters[TEXT_PARAMETERS] = {
    [TEXT_ALPHA] = { "alpha", "rad", "slope angle" },
    [TEXT_MU_STAR] = { "mu_star", "1", "friction at V_star and psi = 1" },
    [TEXT_A] = { "a", "1", "direct effect" },
    [TEXT_B] = { "b", "1", "evolution effect" },
    [TEXT_C] = { "c", "1", "cut-off of the state" },
    [TEXT_R] = { "R", "1", "ratio of the two time scales" },
    [TEXT_V_C] = { "V_c", "1", "cut-off velocity in units of V_star" },
    [TEXT_EPS2] = { "eps2", "1", "inertia, V_star^2/(g L)" },
    [TEXT_LNV0] = { "lnv0", "1",
                    "where differences are taken from: any number gives the "
                    "same field, ln v of a steady state keeps its digits" },
    [TEXT_Y0] = { "y0", "1",
                  "where psi stands still there, in the chart: to be found "
                  "again where lnv0 is changed" },
};

double text_parameter_value(const struct block *b, enum text_parameter p)
{
    const struct material *m = &b->material;
    const double value[TEXT_PARAMETERS] = {
        [TEXT_ALPHA] = (double) atanl(b->tan_alpha),
        [TEXT_MU_STAR] = m->mu_star,
        [TEXT_A] = m->a,
        [TEXT_B] = m->b,
        [TEXT_C] = m->c,
        [TEXT_R] = isinf(m->R) ? 1e200 : m->R,
        [TEXT_V_C] = m->V_c,
        [TEXT_EPS2] = material_eps2(m),
        [TEXT_LNV0] = b->at.x0,
        [TEXT_Y0] = b->at.y0,
    };
    return value[p];
}

const char *text_state_name(const struct law *law, int coordinate)
{
    return coordinate == 0 ? "lnv" : law_psi_is_log(law) ? "psi" : "lnpsi";
}

/* ---- lines ------------------------------------------------------------ */

static void name_parameters(struct formula *f, int leaf[TEXT_PARAMETERS])
{
    for (int p = 0; p < TEXT_PARAMETERS; p++) {
        const bool signs =
            p == TEXT_ALPHA || p == TEXT_MU_STAR || p >= TEXT_LNV0;
        leaf[p] = formula_leaf(f, text_parameters[p].name,
                               signs ? FORMULA_PARAMETER
                                     : FORMULA_POSITIVE_PARAMETER);
    }
    formula_define(f, LAW_LNV0, leaf[TEXT_LNV0]);
    formula_define(f, LAW_Y0, leaf[TEXT_Y0]);
    formula_define(f, "tan_alpha",
                   formula_of(f, FUNCTION_TAN, leaf[TEXT_ALPHA]));
}

/* Whether another program can have the name: capitals do not count there. */
static bool is_free(const struct law *law, const struct formula *f,
                    const char *name)
{
    enum { LETTERS = 9 };
    bool free = strlen(name) <= LETTERS;

    for (int i = 0; i < f->nodes; i++)
        free = free && strcasecmp(f->node[i].name, name) != 0;
    for (int i = 0; i < 2; i++)
        free = free && strcasecmp(text_state_name(law, i), name) != 0;
    return free;
}

/* Others become numbers. */
static void name_owns(const struct law *law, struct formula *f)
{
    const struct law_typed *t = law->typed;

    for (int i = 0; t && i < t->owns; i++)
        if (is_free(law, f, t->own[i].name))
            formula_know(f,
                         formula_leaf(f, t->own[i].name,
                                      t->own[i].value > 0
                                          ? FORMULA_POSITIVE_PARAMETER
                                          : FORMULA_PARAMETER),
                         t->own[i].value);
        else
            formula_define(f, t->own[i].name,
                           formula_number(f, t->own[i].value));
}

static bool is_used(const struct formula *f, const struct text_lines *lines,
                    int node)
{
    return f->node[node].kind == FORMULA_LEAF && lines->uses[node];
}

static void write_tape(const struct law *law, struct tape_lowered *tape,
                       struct text_lines *out)
{
    struct formula *f = &tape->f;
    struct tape_text all;
    int offset[2];

    for (int i = 0; i < 2; i++) {
        const int place =
            formula_leaf(f, text_state_name(law, i), FORMULA_STATE);
        offset[i] = formula_less(f, place, tape->p.chart[i]);
        formula_name(f, offset[i], i ? "Y" : "X");
    }
    text_of_tape(f, &tape->t, offset, &all);
    formula_name(f, all.rate[0], "fx");
    formula_name(f, all.rate[1], "fy");
    formula_name(f, all.scale, "scale");
    formula_name(f, all.value[0], "mu");
    const int result[] = { all.rate[0], all.rate[1], all.scale, all.value[0] };
    const bool whole = text_write(f, result, 4, out);
    assert(whole);
    (void) whole;
}

void field_text(const struct law *law, struct field_text *out)
{
    struct tape_lowered tape;
    int parameter[TEXT_PARAMETERS];

    formula_init(&tape.f);
    name_parameters(&tape.f, parameter);
    name_owns(law, &tape.f);
    law_tape(law, false, &tape);
    write_tape(law, &tape, &out->lines);
    for (int i = 0; i < TEXT_PARAMETERS; i++)
        out->uses[i] = is_used(&tape.f, &out->lines, parameter[i]);
    memset(out->owns, 0, sizeof out->owns);
    for (int i = 0; law->typed && i < law->typed->owns; i++) {
        const char *name = law->typed->own[i].name;
        out->owns[i] = is_used(&tape.f, &out->lines,
                               formula_find(&tape.f, name, strlen(name)));
    }
}
