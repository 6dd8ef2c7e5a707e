/* Laws that are formulas, and their steady states. */
#include "law_typed.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "law_curve.h"
#include "law_root.h"
#include "parse.h"
#include "quad.h"
#include "steady.h"

/* ---- making -------------------------------------------------------------- */

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
    const struct law law = law_of_typed(t);

    law_names(&law, f);
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

static void make_plain(struct law_typed *t)
{
    const struct law law = law_of_typed(t);
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
    part(f, "mu", law_text_mu(&law));
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
    const struct law law = law_of_typed(t);
    struct formula *f = &t->steady;

    begin(t, f);
    t->psi = t->text[LAW_PSI_SS][0] ? part(f, "psi_ss", t->text[LAW_PSI_SS])
                                    : psi_of(t, f);
    formula_define(f, "psi", t->psi);
    t->y = t->real ? t->psi : formula_of(f, FUNCTION_LN, t->psi);
    part(f, "theta", t->text[LAW_THETA]);
    part(f, "T", t->text[LAW_T]);
    t->mu = part(f, "mu", law_text_mu(&law));
}

enum status law_typed_make(struct law_typed *t, enum law_part *wrong,
                           struct fault *why)
{
    const struct law law = law_of_typed(t);
    enum status s = check_parts(t, why);

    *wrong = LAW_PARTS;
    for (int i = 0; i < 2 && s == STATUS_OK; i++) {
        const char *name = NULL;
        law_names(&law, &t->tape[i].f);
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

void law_typed_of_preset(const struct law *p, struct law_typed *out)
{
    memset(out, 0, sizeof *out);
    out->real = law_psi_is_log(p);
    out->form = p->form;
    for (int i = 0; i < LAW_PARTS; i++) {
        const char *text = law_text(p, (enum law_part) i);
        strcpy(out->text[i], text ? text : "");
    }
}

const char *law_typed_text(const struct law_typed *t, enum law_part part)
{
    return t->text[part][0] ? t->text[part] : NULL;
}

/* ---- numbers ------------------------------------------------------------- */

struct typed_steady law_typed_steady(const struct law *law,
                                     const struct material *m, long double x)
{
    const struct law_typed *t = law->typed;
    struct formula_value leaf[LAW_VALUES];
    long double value[FORMULA_NODES];

    law_values(law, m, 0, x, law_root(law, m, x), leaf);
    formula_long_constants(&t->steady, leaf, NULL, value);
    return (struct typed_steady){ value[t->y], value[t->psi], value[t->mu] };
}

struct typed_steady_quad law_typed_steady_quad(const struct law *law,
                                               const struct material *m,
                                               formula_real x)
{
    const struct law_typed *t = law->typed;
    struct formula_value leaf[LAW_VALUES];
    quad value[FORMULA_NODES];

    law_values(law, m, 0, x, law_root_quad(law, m, x), leaf);
    formula_constants(&t->steady, leaf, NULL, 0, value);
    return (struct typed_steady_quad){ value[t->y], value[t->psi],
                                       value[t->mu] };
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
    struct typed_curve c;
    law_curve_init(&c, law, m);
    const long double slope = (long double) law_curve_slope(&c, x);

    if (!steady_plane(law, m, law_typed_steady(law, m, x).mu, x, true, &plane))
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
