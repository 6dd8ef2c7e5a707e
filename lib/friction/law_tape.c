/* The components of laws as formulas; no other place has them as text. */
#include "law_tape.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

#include "law_typed.h"
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

/* A law as text: what each name of the model stands for; rate is dpsi/dt. */
struct law_text {
    const char *theta, *psi_ss, *T, *K, *mu, *rate; /* NULL: there is none */
    bool real;                                      /* psi: any number */
    bool typed;
    char buffer[200];
};

/* ---- text ---------------------------------------------------------------- */

/* T, of the terms of ln(1/T) */
static void write_timescale(const struct law *law, char *text, size_t size)
{
    const struct timescale_terms *t = law_timescale(law);

    snprintf(text, size,
             "exp(%d*ln(R) - (%d)*ln(v) - (%d)*ln(one_R + v) - (%d)*psi_ss",
             t->ln_r, t->ln_v, t->ln_r_plus_v, t->psi_ss);
    if (t->ln_psi_ss)
        snprintf(text + strlen(text), size - strlen(text), " - (%d)*ln(psi_ss)",
                 t->ln_psi_ss);
    strcat(text, ")");
}

static const char *given(const char *text)
{
    return text[0] ? text : NULL;
}

static void text_of(const struct law *law, struct law_text *out)
{
    const struct law_typed *t = law->typed;

    *out = (struct law_text){ .real = law_psi_is_log(law) };
    out->typed = t != NULL;
    if (t) {
        out->theta = given(t->text[LAW_THETA]);
        out->psi_ss = given(t->text[LAW_PSI_SS]);
        out->T = given(t->text[LAW_T]);
        out->K = given(t->text[LAW_K]);
        out->mu = given(t->text[LAW_MU]);
        out->rate = given(t->text[LAW_RATE]);
        out->mu = out->mu ? out->mu : mu_formula[law->form];
        out->rate = out->rate ? out->rate : out->K ? "-K/T" : "-d/T";
        return;
    }
    write_timescale(law, out->buffer, sizeof out->buffer);
    out->theta = theta_formula[law->theta];
    out->psi_ss = psi_ss_formula[law->psi_ss];
    out->T = out->buffer;
    out->mu = mu_formula[law->form];
    out->rate = rate_formula[law->kinetics];
}

/* ---- reading ------------------------------------------------------------- */

struct reading {
    struct formula *f;
    enum status status;
    const char **name; /* of what failed */
    struct fault *why;
};

/* The node, defined under the name; 0 after a failure. */
static int define(struct reading *r, const char *name, const char *text)
{
    int node = 0;

    if (r->status != STATUS_OK || text == NULL)
        return 0;
    *r->name = name;
    r->status = formula_parse(r->f, text, &node, r->why);
    if (r->status == STATUS_OK)
        formula_define(r->f, name, node);
    return node;
}

/* At lnv0 on the steady curve. */
static void anchor(struct reading *r, const struct law_text *text,
                   struct plane_formulas *p)
{
    struct formula *f = r->f;

    p->chart[0] = formula_find(f, "lnv0", 4);
    p->at[0] = formula_of(f, FUNCTION_EXP, p->chart[0]);
    formula_define(f, "v0", p->at[0]);
    formula_define(f, "v", p->at[0]);
    const int y0 = formula_find(f, "y0", 2);
    const int psi0 = text->psi_ss ? define(r, "psi0", text->psi_ss)
                     : text->real ? y0
                                  : formula_of(f, FUNCTION_EXP, y0);
    *r->name = "psi_ss";
    if (r->status == STATUS_OK && f->node[psi0].moves) {
        snprintf(r->why->text, sizeof r->why->text,
                 "psi stands in it, expected a formula of v");
        r->status = STATUS_BAD_SCENE;
    }
    if (r->status == STATUS_OK)
        r->status = tape_anchor(f, p, 1, psi0, r->why);
}

/* The plane (17), and mu beside it. */
static void name_plane(struct reading *r, const struct law_text *text,
                       struct plane_formulas *p)
{
    formula_define(r->f, "v", p->state[0]);
    define(r, "theta", text->theta);
    define(r, "psi_ss", text->psi_ss);
    if (text->typed && text->psi_ss)
        define(r, "d", "psi - psi_ss");
    define(r, "T", text->T);
    define(r, "K", text->K);
    p->value[0] = define(r, "mu", text->mu);
    p->values = 1;
    p->rate[0] = define(r, "dv",
                        "(tan_alpha - mu)/"
                        "(eps2*sqrt(1 + tan_alpha*tan_alpha))");
    p->rate[1] = define(r, "dpsi", text->rate);
}

/* In the order of enum block_observable (field.h). */
static void observe(struct reading *r, struct plane_formulas *p)
{
    p->observable[0] = define(r, "slip", "v");
    p->observable[1] = define(r, "work", "mu*v");
    p->observable[2] = define(r, "excess", "v - v0");
    p->observables = 3;
}

static enum status make(const struct law_text *text, bool equilibrium,
                        bool observed, struct tape_lowered *out,
                        const char **name, struct fault *why)
{
    struct plane_formulas *p = &out->p;
    struct reading r = { &out->f, STATUS_OK, name, why };

    *p = (struct plane_formulas){ .zero = { equilibrium, true } };
    p->state[0] = formula_leaf(&out->f, "v", FORMULA_POSITIVE_STATE);
    p->state[1] = formula_leaf(
        &out->f, "psi", text->real ? FORMULA_STATE : FORMULA_POSITIVE_STATE);
    anchor(&r, text, p);
    name_plane(&r, text, p);
    if (observed)
        observe(&r, p);
    *name = r.status == STATUS_OK ? NULL : *name;
    return r.status == STATUS_OK ? tape_lower(&out->t, &out->f, p, why)
                                 : r.status;
}

void law_tape(const struct law *law, bool equilibrium, struct tape_lowered *out)
{
    struct law_text text;
    struct fault why;
    const char *name;

    text_of(law, &text);
    const enum status s = make(&text, equilibrium, false, out, &name, &why);
    assert(s == STATUS_OK); /* tests/friction/test_field_text.c: every law */
    (void) s;
}

enum status law_tape_observed(const struct law *law, bool equilibrium,
                              struct tape_lowered *out, const char **name,
                              struct fault *why)
{
    struct law_text text;

    text_of(law, &text);
    return make(&text, equilibrium, true, out, name, why);
}
