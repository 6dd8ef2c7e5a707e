/* The law as formulas, lowered to differences (tape.h) and written. */
#include "field_text.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "parse.h"

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
        [TEXT_R] = isinf(m->R) ? 1e300 : m->R,
        [TEXT_V_C] = m->V_c,
        [TEXT_EPS2] = material_eps2(m),
        [TEXT_LNV0] = b->at.x0,
    };
    return value[p];
}

const char *text_state_name(const struct law *law, int coordinate)
{
    return coordinate == 0 ? "lnv" : law_psi_is_log(law) ? "psi" : "lnpsi";
}

/* ---- formulas ------------------------------------------------------------ */

/* one_R is 1/R: R may be infinite. */
static const char *const theta_formula[THETAS] = {
    [THETA_LN_PSI] = "ln(psi)",
    [THETA_PSI] = "psi",
    [THETA_LN_C_PSI] = "ln(c + psi)",
    [THETA_LN_C_1PR_PSI] = "ln(c + (1 + R)*psi)",
};
static const char *const psi_ss_formula[PSI_SSES] = {
    [PSI_SS_INVERSE] = "1/v",
    [PSI_SS_MINUS_LOG] = "-ln(v)",
    [PSI_SS_SPINODAL] = "(1 + one_R)/(one_R + v)",
    [PSI_SS_SPINODAL_UNIT] = "one_R/(one_R + v)",
    [PSI_SS_LAMBERT] = "exp(lambert(v/V_c))/v",
};
static const char *const mu_formula[FRICTION_FORMS] = {
    [FRICTION_ASINH] = "a*asinh(v/2*exp((mu_star + b*theta)/a))",
    [FRICTION_LOG] = "mu_star + a*ln(v) + b*theta",
};
/* The last is exp(-v/V_c) - v psi ln(v psi). */
static const char *const rate_formula[KINETICSES] = {
    [KINETICS_LINEAR] = "-(psi - psi_ss)/T",
    [KINETICS_SINH] = "-sinh(psi - psi_ss)/T",
    [KINETICS_COMPOSITE] = "v*psi*(exp(-v/V_c - ln(v*psi)) - ln(v*psi))",
};

static int define(struct formula *f, const char *name, const char *text)
{
    struct fault why;
    int node = 0;
    const enum status s = formula_parse(f, text, &node, &why);

    assert(s == STATUS_OK);
    (void) s;
    formula_define(f, name, node);
    return node;
}

/* T, of the terms of ln(1/T) */
static void define_timescale(struct formula *f, const struct law *law)
{
    const struct timescale_terms *t = law_timescale(law);
    char text[200];

    snprintf(text, sizeof text,
             "exp(%d*ln(R) - (%d)*ln(v) - (%d)*ln(one_R + v) - (%d)*psi_ss",
             t->ln_r, t->ln_v, t->ln_r_plus_v, t->psi_ss);
    if (t->ln_psi_ss)
        snprintf(text + strlen(text), sizeof text - strlen(text),
                 " - (%d)*ln(psi_ss)", t->ln_psi_ss);
    strcat(text, ")");
    define(f, "T", text);
}

static void name_parameters(struct formula *f)
{
    for (int p = 0; p < TEXT_PARAMETERS; p++) {
        const bool signs =
            p == TEXT_ALPHA || p == TEXT_MU_STAR || p == TEXT_LNV0;
        formula_leaf(f, text_parameters[p].name,
                     signs ? FORMULA_PARAMETER : FORMULA_POSITIVE_PARAMETER);
    }
    define(f, "tan_alpha", "tan(alpha)");
    define(f, "one_R", "1/R");
}

/* At lnv0 on the steady curve. */
static enum status anchor(struct formula *f, const struct law *law,
                          struct plane_formulas *p, struct fault *why)
{
    p->chart[0] = formula_find(f, "lnv0", 4);
    p->at[0] = formula_of(f, FUNCTION_EXP, p->chart[0]);
    formula_define(f, "v0", p->at[0]);
    formula_define(f, "v", p->at[0]);
    const int psi0 = define(f, "psi0", psi_ss_formula[law->psi_ss]);
    return tape_anchor(f, p, 1, psi0, why);
}

/* The plane (17), and mu beside it. */
static enum status name_law(struct formula *f, const struct law *law,
                            struct plane_formulas *p, struct fault *why)
{
    p->state[0] = formula_leaf(f, "v", FORMULA_POSITIVE_STATE);
    p->state[1] = formula_leaf(
        f, "psi", law_psi_is_log(law) ? FORMULA_STATE : FORMULA_POSITIVE_STATE);
    const enum status s = anchor(f, law, p, why);

    formula_define(f, "v", p->state[0]);
    define(f, "theta", theta_formula[law->theta]);
    define(f, "psi_ss", psi_ss_formula[law->psi_ss]);
    define_timescale(f, law);
    p->value[0] = define(f, "mu", mu_formula[law->form]);
    p->values = 1;
    p->rate[0] = define(f, "dv",
                        "(tan_alpha - mu)/"
                        "(eps2*sqrt(1 + tan_alpha*tan_alpha))");
    p->rate[1] = define(f, "dpsi", rate_formula[law->kinetics]);
    p->zero[1] = true;
    return s;
}

/* ---- lines --------------------------------------------------------------- */

static void write_tape(struct formula *f, const struct law *law,
                       const struct plane_formulas *p, const struct tape *t,
                       struct field_text *out)
{
    struct tape_text all;
    int offset[2];

    for (int i = 0; i < 2; i++) {
        const int place =
            formula_leaf(f, text_state_name(law, i), FORMULA_STATE);
        offset[i] = formula_less(f, place, p->chart[i]);
        formula_name(f, offset[i], i ? "Y" : "X");
    }
    text_of_tape(f, t, offset, &all);
    formula_name(f, all.rate[0], "fx");
    formula_name(f, all.rate[1], "fy");
    formula_name(f, all.scale, "scale");
    formula_name(f, all.value[0], "mu");
    const int result[] = { all.rate[0], all.rate[1], all.scale, all.value[0] };
    const bool whole = text_write(f, result, 4, &out->lines);
    assert(whole);
    (void) whole;
}

void field_text(const struct law *law, struct field_text *out)
{
    struct formula f;
    struct plane_formulas p = { .values = 0 };
    struct tape t;
    struct fault why;

    formula_init(&f);
    name_parameters(&f);
    enum status s = name_law(&f, law, &p, &why);
    if (s == STATUS_OK)
        s = tape_lower(&t, &f, &p, &why);
    assert(s == STATUS_OK); /* tests/friction/test_field_text.c: every law */
    write_tape(&f, law, &p, &t, out);
    for (int i = 0; i < TEXT_PARAMETERS; i++) {
        const char *name = text_parameters[i].name;
        out->uses[i] = out->lines.uses[formula_find(&f, name, strlen(name))];
    }
}
