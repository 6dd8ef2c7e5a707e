/* The components of laws as formulas; no other place has them as text. */
#include "law_tape.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

#include "parse.h"

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
static void name_plane(struct formula *f, const struct law *law,
                       struct plane_formulas *p)
{
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
}

void law_tape(const struct law *law, bool equilibrium, struct law_tape *out)
{
    struct formula *f = &out->f;
    struct plane_formulas *p = &out->p;
    struct fault why;

    *p = (struct plane_formulas){ .zero = { equilibrium, true } };
    p->state[0] = formula_leaf(f, "v", FORMULA_POSITIVE_STATE);
    p->state[1] = formula_leaf(
        f, "psi", law_psi_is_log(law) ? FORMULA_STATE : FORMULA_POSITIVE_STATE);
    enum status s = anchor(f, law, p, &why);
    name_plane(f, law, p);
    if (s == STATUS_OK)
        s = tape_lower(&out->t, f, p, &why);
    assert(s == STATUS_OK); /* tests/friction/test_field_text.c: every law */
    (void) s;
}
