/* Laws that are formulas, and their steady states. */
#include "law_typed.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "law_root.h"
#include "parse.h"
#include "quad.h"

const char *const law_part_names[] = { "theta", "psi_ss", "T", "K",
                                       "mu",    "rate",   NULL };

/* ---- making -------------------------------------------------------------- */

/* By sign: a formula may be positive whatever its parameters are. */
static const struct {
    const char *name;
    bool positive;
} model[] = {
    { "tan_alpha", true },
    { "mu_star", false },
    { "a", true },
    { "b", true },
    { "c", true },
    { "R", true },
    { "one_R", true },
    { "V_c", true },
    { "eps2", true },
    [LAW_LNV0] = { "lnv0", false },
    [LAW_Y0] = { "y0", false },
};
enum { MODEL = sizeof model / sizeof *model };
_Static_assert(MODEL + LAW_OWNS + 1 == LAW_VALUES, "one value a name");

static void name_constants(const struct law_typed *t, struct formula *f)
{
    formula_init(f);
    for (int i = 0; i < MODEL; i++)
        formula_leaf(f, model[i].name,
                     model[i].positive ? FORMULA_POSITIVE_PARAMETER
                                       : FORMULA_PARAMETER);
    for (int i = 0; i < t->owns; i++)
        formula_leaf(f, t->own[i].name,
                     t->own[i].value > 0 ? FORMULA_POSITIVE_PARAMETER
                                         : FORMULA_PARAMETER);
}

static enum law_part part_of(const char *name)
{
    int part = 0;

    while (name && part < LAW_PARTS && strcmp(law_part_names[part], name) != 0)
        part++;
    return !name                       ? LAW_PARTS
           : strcmp(name, "dpsi") == 0 ? LAW_RATE
                                       : (enum law_part) part;
}

static enum status lack(struct fault *why, const char *text)
{
    snprintf(why->text, sizeof why->text, "%s", text);
    return STATUS_BAD_SCENE;
}

static enum status check_parts(const struct law_typed *t, struct fault *why)
{
    const bool rate = t->text[LAW_RATE][0];

    if (!t->text[LAW_PSI_SS][0] && !rate)
        return lack(why, "psi_ss is missing, expected the state in steady "
                         "sliding, as in 1/v, or rate");
    if (!t->text[LAW_THETA][0] && !t->text[LAW_MU][0])
        return lack(why, "theta is missing, expected it, as in ln(psi), or mu");
    if (rate && (t->text[LAW_T][0] || t->text[LAW_K][0]))
        return lack(why, "rate beside T or K, expected one of the two");
    if (!rate && !t->text[LAW_T][0])
        return lack(why, "T is missing, expected it, as in 1/v, or rate");
    return STATUS_OK;
}

/* A part of a graph of lnv0 and y0. */
static int part(struct formula *f, const char *name, const char *text)
{
    struct fault why;
    int node = 0;

    if (text[0] && formula_parse(f, text, &node, &why) == STATUS_OK)
        formula_define(f, name, node);
    return node;
}

/* psi of y0, the chart's y */
static int psi_of(const struct law_typed *t, struct formula *f)
{
    const int y = formula_find(f, "y0", 2);

    return t->real ? y : formula_of(f, FUNCTION_EXP, y);
}

static void begin(const struct law_typed *t, struct formula *f)
{
    name_constants(t, f);
    formula_define(f, "v",
                   formula_of(f, FUNCTION_EXP, formula_find(f, "lnv0", 4)));
}

/* dpsi/dt at any psi, where nothing else is said of psi_ss. */
static void make_growth(struct law_typed *t)
{
    struct formula *f = &t->growth;

    begin(t, f);
    formula_define(f, "psi", psi_of(t, f));
    part(f, "theta", t->text[LAW_THETA]);
    if (t->text[LAW_MU][0])
        part(f, "mu", t->text[LAW_MU]);
    t->rate = part(f, "dpsi", t->text[LAW_RATE]);
}

static const char *const friction[FRICTION_FORMS] = {
    [FRICTION_ASINH] = "a*asinh(v/2*exp((mu_star + b*theta)/a))",
    [FRICTION_LOG] = "mu_star + a*ln(v) + b*theta",
};

static void make_plain(struct law_typed *t)
{
    struct formula *f = &t->plain;
    const char *const *text =
        (const char *const[]){ t->text[LAW_THETA], t->text[LAW_PSI_SS],
                               t->text[LAW_T], t->text[LAW_K] };

    begin(t, f);
    formula_define(f, "psi", psi_of(t, f));
    t->theta = part(f, "theta", text[0]);
    if (part(f, "psi_ss", text[1]))
        part(f, "d", "psi - psi_ss");
    part(f, "T", text[2]);
    part(f, "K", text[3]);
    part(f, "mu", t->text[LAW_MU][0] ? t->text[LAW_MU] : friction[t->form]);
    t->psi_rate = part(f, "dpsi",
                       t->text[LAW_RATE][0] ? t->text[LAW_RATE]
                       : text[3][0]         ? "-K/T"
                                            : "-d/T");
    t->chart_rate[0] = part(f, "fx",
                            "(tan_alpha - mu)/"
                            "(v*eps2*sqrt(1 + tan_alpha*tan_alpha))");
    t->chart_rate[1] = t->real ? t->psi_rate : part(f, "fy", "dpsi/psi");
}

static void make_steady(struct law_typed *t)
{
    struct formula *f = &t->steady;

    begin(t, f);
    t->psi = t->text[LAW_PSI_SS][0] ? part(f, "psi_ss", t->text[LAW_PSI_SS])
                                    : psi_of(t, f);
    formula_define(f, "psi", t->psi);
    t->y = t->real ? t->psi : formula_of(f, FUNCTION_LN, t->psi);
    part(f, "theta", t->text[LAW_THETA]);
    part(f, "T", t->text[LAW_T]);
    t->mu =
        part(f, "mu", t->text[LAW_MU][0] ? t->text[LAW_MU] : friction[t->form]);
}

enum status law_typed_make(struct law_typed *t, enum law_part *wrong,
                           struct fault *why)
{
    const struct law law = law_of_typed(t);
    enum status s = check_parts(t, why);

    *wrong = LAW_PARTS;
    for (int i = 0; i < 2 && s == STATUS_OK; i++) {
        const char *name = NULL;
        name_constants(t, &t->tape[i].f);
        s = law_tape_observed(&law, i, &t->tape[i], &name, why);
        *wrong = part_of(name);
    }
    if (s == STATUS_OK) {
        make_steady(t);
        make_plain(t);
    }
    if (s == STATUS_OK && !t->text[LAW_PSI_SS][0])
        make_growth(t);
    return s == STATUS_OK ? s : STATUS_BAD_SCENE;
}

/* Kato and Tullis', of which the closed forms of others do not hold. */
struct law law_of_typed(const struct law_typed *t)
{
    return (struct law){ .preset = "typed",
                         .equation = "formulas of the scene",
                         .form = t->form,
                         .theta = t->real ? THETA_PSI : THETA_LN_PSI,
                         .psi_ss = PSI_SS_LAMBERT,
                         .timescale = TIMESCALE_SLIP,
                         .kinetics = KINETICS_COMPOSITE,
                         .typed = t };
}

/* ---- presets ------------------------------------------------------------- */

void law_typed_of_preset(const struct law *p, struct law_typed *out)
{
    static const char *const theta[THETAS] = {
        [THETA_LN_PSI] = "ln(psi)",
        [THETA_PSI] = "psi",
        [THETA_LN_C_PSI] = "ln(c + psi)",
        [THETA_LN_C_1PR_PSI] = "ln(c + (1 + R)*psi)",
    };
    static const char *const psi_ss[PSI_SSES] = {
        [PSI_SS_INVERSE] = "1/v",
        [PSI_SS_MINUS_LOG] = "-ln(v)",
        [PSI_SS_SPINODAL] = "(1 + R)/(1 + R*v)",
        [PSI_SS_SPINODAL_UNIT] = "1/(1 + R*v)",
        [PSI_SS_LAMBERT] = "exp(lambert(v/V_c))/v",
    };
    static const char *const timescale[TIMESCALES] = {
        [TIMESCALE_SLIP] = "1/v",
        [TIMESCALE_SPINODAL] = "R/(1 + R*v)",
        [TIMESCALE_AGEING44] = "R*psi_ss",
        [TIMESCALE_SLIP45] = "R*exp(psi_ss)",
    };

    memset(out, 0, sizeof *out);
    out->real = law_psi_is_log(p);
    out->form = p->form;
    strcpy(out->text[LAW_THETA], theta[p->theta]);
    strcpy(out->text[LAW_PSI_SS], psi_ss[p->psi_ss]);
    if (p->kinetics == KINETICS_COMPOSITE) {
        strcpy(out->text[LAW_RATE],
               "v*psi*(exp(-v/V_c - ln(v*psi)) - ln(v*psi))");
        return;
    }
    strcpy(out->text[LAW_T], timescale[p->timescale]);
    strcpy(out->text[LAW_K], p->kinetics == KINETICS_SINH ? "sinh(d)" : "d");
}

void law_typed_formula(const struct law_typed *t, char *text, size_t size)
{
    size_t used = 0;

    text[0] = '\0';
    for (int i = 0; i < LAW_PARTS && used < size; i++)
        if (t->text[i][0])
            used += (size_t) snprintf(
                text + used, size - used, "%s%s = %s", used ? ", " : "",
                i == LAW_RATE ? "dpsi/dt" : law_part_names[i], t->text[i]);
}

/* ---- numbers ------------------------------------------------------------- */

void law_typed_values(const struct law_typed *t, const struct material *m,
                      long double tan_alpha, formula_real x, formula_real y,
                      struct formula_value out[LAW_VALUES])
{
    const quad V = m->V_star, gL = (quad) m->g * (quad) m->L;
    const quad value[MODEL] = {
        tan_alpha,       m->mu_star, m->a,       m->b, m->c, m->R,
        1 / (quad) m->R, m->V_c,     V * V / gL, x,    y,
    };
    int n = 0;

    for (; n < MODEL; n++)
        out[n] = (struct formula_value){ model[n].name, value[n] };
    for (int i = 0; i < t->owns; i++)
        out[n++] = (struct formula_value){ t->own[i].name, m->own[i] };
    out[n] = (struct formula_value){ NULL, 0 };
}

struct typed_steady law_typed_steady(const struct law *law,
                                     const struct material *m, long double x)
{
    const struct law_typed *t = law->typed;
    struct formula_value leaf[LAW_VALUES];
    long double value[FORMULA_NODES];

    law_typed_values(t, m, 0, x, law_root(t, m, x), leaf);
    formula_long_constants(&t->steady, leaf, NULL, value);
    return (struct typed_steady){ value[t->y], value[t->psi], value[t->mu] };
}

void law_curve_init(struct typed_curve *c, const struct law *law,
                    const struct material *m)
{
    const struct law_typed *t = law->typed;
    const int x = formula_find(&t->steady, model[LAW_LNV0].name,
                               strlen(model[LAW_LNV0].name));
    struct formula_value leaf[LAW_VALUES];

    c->law = law;
    c->m = m;
    law_typed_values(t, m, 0, 0, 0, leaf);
    formula_long_constants(&t->steady, leaf, NULL, c->value);
    c->count = formula_changing(&t->steady, x, (int[]){ t->y, t->psi, t->mu },
                                3, c->changing);
    c->count_mu = formula_changing(&t->steady, x, &t->mu, 1, c->of_mu);
    c->is_exact = false;
}

/* The first that changes is x. */
struct typed_steady law_curve_at(struct typed_curve *c, long double x)
{
    const struct law_typed *t = c->law->typed;

    if (!t->text[LAW_PSI_SS][0])
        return law_typed_steady(c->law, c->m, x);
    c->value[c->changing[0]] = x;
    formula_long_again(&t->steady, c->changing + 1, c->count - 1, c->value);
    return (struct typed_steady){ c->value[t->y], c->value[t->psi],
                                  c->value[t->mu] };
}

struct typed_steady_quad law_typed_steady_quad(const struct law *law,
                                               const struct material *m,
                                               formula_real x)
{
    const struct law_typed *t = law->typed;
    struct formula_value leaf[LAW_VALUES];
    quad value[FORMULA_NODES];

    law_typed_values(t, m, 0, x, law_root_quad(t, m, x), leaf);
    formula_constants(&t->steady, leaf, NULL, 0, value);
    return (struct typed_steady_quad){ value[t->y], value[t->psi],
                                       value[t->mu] };
}

static quad friction_at(const struct law *law, const struct material *m, quad x)
{
    return law_typed_steady_quad(law, m, x).mu;
}

formula_real law_typed_slope(const struct law *law, const struct material *m,
                             long double x)
{
    const quad h = 1e-9;

    return (friction_at(law, m, x + h) - friction_at(law, m, x - h)) / (2 * h);
}

static quad curve_friction(struct typed_curve *c, quad x)
{
    const struct law_typed *t = c->law->typed;

    if (!t->text[LAW_PSI_SS][0])
        return friction_at(c->law, c->m, x);
    c->exact[c->of_mu[0]] = x;
    formula_again(&t->steady, c->of_mu + 1, c->count_mu - 1, c->exact);
    return c->exact[t->mu];
}

formula_real law_curve_slope(struct typed_curve *c, long double x)
{
    const quad h = 1e-9;
    struct formula_value leaf[LAW_VALUES];

    if (!c->is_exact) {
        law_typed_values(c->law->typed, c->m, 0, 0, 0, leaf);
        formula_constants(&c->law->typed->steady, leaf, NULL, 0, c->exact);
        c->is_exact = true;
    }
    return (curve_friction(c, x + h) - curve_friction(c, x - h)) / (2 * h);
}

bool law_typed_anchor(const struct law *law, const struct material *m,
                      long double tan_alpha, long double x, bool equilibrium,
                      struct tape_plane *plane)
{
    const struct law_typed *t = law->typed;
    struct formula_value leaf[LAW_VALUES];
    struct fault why;
    const quad root = law_root_quad(t, m, x);
    const quad anchor[2] = { x, t->text[LAW_PSI_SS][0]
                                    ? law_typed_steady(law, m, x).y
                                    : root };

    law_typed_values(t, m, tan_alpha, x, root, leaf);
    return tape_plane_at(&t->tape[equilibrium], leaf, anchor, plane, &why) ==
           STATUS_OK;
}

/* ---- around a steady state ----------------------------------------------- */

/* mu = work/slip of a tape with the observables of block.h */
static struct vec2 friction_gradient(const struct planar *s)
{
    const struct vec2 z = { 0, 0 };
    double v, work;
    struct vec2 dv, dwork;

    s->rate_gradient(s->ctx, 0, z, &v, &dv);
    s->rate_gradient(s->ctx, 1, z, &work, &dwork);
    return (struct vec2){ (dwork.x - work / v * dv.x) / v,
                          (dwork.y - work / v * dv.y) / v };
}

struct response law_typed_response(const struct law *law,
                                   const struct material *m, long double x)
{
    struct tape_plane plane;
    struct planar_jacobian J;
    const long double slope = (long double) law_typed_slope(law, m, x);

    if (!law_typed_anchor(law, m, law_typed_steady(law, m, x).mu, x, true,
                          &plane))
        return (struct response){ .slope = slope };
    const struct planar s = tape_planar(&plane);
    const double direct = friction_gradient(&s).x;
    s.jacobian(s.ctx, (struct vec2){ 0, 0 }, &J);
    const double rate = -J.matrix.yy * exp(J.field.log_scale);
    return (struct response){
        .slope = slope,
        .direct = (long double) direct,
        .rate = (long double) rate,
        .slope_error = 16 * LDBL_EPSILON * (fabsl(slope) + fabs(direct)),
        .rate_error = 16 * (long double) DBL_EPSILON,
    };
}

/* ---- what it uses -------------------------------------------------------- */

static bool is_used(const struct formula *f, const bool wanted[], int leaf)
{
    bool used[FORMULA_NODES];

    memcpy(used, wanted, sizeof used);
    for (int i = f->nodes; i-- > 0;)
        for (int j = 0; used[i] && j < f->node[i].arguments; j++)
            used[f->node[i].of[j]] = true;
    return leaf >= 0 && used[leaf];
}

bool law_typed_uses(const struct law_typed *t, const char *name)
{
    const struct formula *f = &t->tape[0].f;
    bool wanted[FORMULA_NODES] = { false };

    for (int i = 0; i < 2; i++)
        wanted[t->tape[0].p.rate[i]] = wanted[t->tape[0].p.chart[i]] = true;
    return is_used(f, wanted, formula_find(f, name, strlen(name)));
}
