/* Steady states of laws that are formulas.  The extrema of mu_ss are where its
 * slope changes sign: looked for in steps of an e-fold of v, between steps
 * where the slope is least, and settled in 113 bits. */
#include "law_typed.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "parse.h"
#include "quad.h"
#include "tolerance.h"

const char *const law_part_names[] = { "theta", "psi_ss", "T", "K",
                                       "mu",    "rate",   NULL };

/* ---- making -------------------------------------------------------------- */

/* By sign: a formula may be positive whatever its parameters are. */
static const struct {
    const char *name;
    bool positive;
} model[] = {
    { "tan_alpha", true }, { "mu_star", false }, { "a", true },
    { "b", true },         { "c", true },        { "R", true },
    { "one_R", true },     { "V_c", true },      { "eps2", true },
    { "lnv0", false },
};
enum { MODEL = sizeof model / sizeof *model };

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

    if (!t->text[LAW_PSI_SS][0])
        return lack(why, "psi_ss is missing, expected the state in steady "
                         "sliding, as in 1/v");
    if (!t->text[LAW_THETA][0] && !t->text[LAW_MU][0])
        return lack(why, "theta is missing, expected it, as in ln(psi), or mu");
    if (rate && (t->text[LAW_T][0] || t->text[LAW_K][0]))
        return lack(why, "rate beside T or K, expected one of the two");
    if (!rate && !t->text[LAW_T][0])
        return lack(why, "T is missing, expected it, as in 1/v, or rate");
    return STATUS_OK;
}

/* A part of the steady graph, of v0 = e^lnv0 and psi = psi_ss(v0). */
static int steady_part(struct formula *f, const char *name, const char *text)
{
    struct fault why;
    int node = 0;

    if (text[0] && formula_parse(f, text, &node, &why) == STATUS_OK)
        formula_define(f, name, node);
    return node;
}

static void make_steady(struct law_typed *t)
{
    static const char *const friction[FRICTION_FORMS] = {
        [FRICTION_ASINH] = "a*asinh(v/2*exp((mu_star + b*theta)/a))",
        [FRICTION_LOG] = "mu_star + a*ln(v) + b*theta",
    };
    struct formula *f = &t->steady;

    name_constants(t, f);
    formula_define(f, "v",
                   formula_of(f, FUNCTION_EXP, formula_find(f, "lnv0", 4)));
    t->psi = steady_part(f, "psi_ss", t->text[LAW_PSI_SS]);
    formula_define(f, "psi", t->psi);
    t->y = t->real ? t->psi : formula_of(f, FUNCTION_LN, t->psi);
    steady_part(f, "theta", t->text[LAW_THETA]);
    steady_part(f, "T", t->text[LAW_T]);
    t->mu = steady_part(
        f, "mu", t->text[LAW_MU][0] ? t->text[LAW_MU] : friction[t->form]);
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
    if (s == STATUS_OK)
        make_steady(t);
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

/* All names, ended by none. */
static void values(const struct law_typed *t, const struct material *m,
                   long double tan_alpha, long double x,
                   struct formula_value out[])
{
    const quad V = m->V_star, gL = (quad) m->g * (quad) m->L;
    const quad value[MODEL] = {
        tan_alpha, m->mu_star,      m->a,   m->b,       m->c,
        m->R,      1 / (quad) m->R, m->V_c, V * V / gL, x
    };
    int n = 0;

    for (; n < MODEL; n++)
        out[n] = (struct formula_value){ model[n].name, value[n] };
    for (int i = 0; i < t->owns; i++)
        out[n++] = (struct formula_value){ t->own[i].name, t->own[i].value };
    out[n] = (struct formula_value){ NULL, 0 };
}

enum { VALUES = MODEL + LAW_OWNS + 1 };

struct typed_steady law_typed_steady(const struct law *law,
                                     const struct material *m, long double x)
{
    const struct law_typed *t = law->typed;
    struct formula_value leaf[VALUES];
    long double value[FORMULA_NODES];

    values(t, m, 0, x, leaf);
    formula_long_constants(&t->steady, leaf, value);
    return (struct typed_steady){ value[t->y], value[t->psi], value[t->mu] };
}

static quad friction_at(const struct law *law, const struct material *m, quad x)
{
    const struct law_typed *t = law->typed;
    struct formula_value leaf[VALUES];
    quad value[FORMULA_NODES];

    values(t, m, 0, 0, leaf);
    leaf[MODEL - 1].value = x;
    formula_constants(&t->steady, leaf, 0, value);
    return value[t->mu];
}

bool law_typed_anchor(const struct law *law, const struct material *m,
                      long double tan_alpha, long double x, bool equilibrium,
                      struct tape_plane *plane)
{
    const struct law_typed *t = law->typed;
    struct formula_value leaf[VALUES];
    struct fault why;
    const quad anchor[2] = { x, law_typed_steady(law, m, x).y };

    values(t, m, tan_alpha, x, leaf);
    return tape_plane_at(&t->tape[equilibrium], leaf, anchor, plane, &why) ==
           STATUS_OK;
}

/* ---- where mu_ss is, and its extrema ------------------------------------- */

static bool is_there(const struct law *law, const struct material *m,
                     long double x)
{
    const struct typed_steady s = law_typed_steady(law, m, x);

    return isfinite(s.y) && isfinite(s.mu);
}

/* The last x from `in`, where mu_ss is, towards `out`. */
static long double last_there(const struct law *law, const struct material *m,
                              long double in, long double out)
{
    if (is_there(law, m, out))
        return out;
    for (int i = 0; i < 80; i++) {
        const long double mid = (in + out) / 2;
        *(is_there(law, m, mid) ? &in : &out) = mid;
    }
    return in;
}

void law_typed_range(const struct law *law, const struct material *m,
                     long double *lo, long double *hi)
{
    const long double far = (long double) TOL_LN_RANGE;
    long double in = 0;

    for (int i = 1; i < 40 && !is_there(law, m, in); i++)
        in = (i % 2 ? -1 : 1) * (long double) i; /* 0, -1, 2, -3, ... */
    *lo = in;
    *hi = in;
    for (long double step = 1; step < 2 * far; step *= 2) {
        if (is_there(law, m, fmaxl(in - step, -far)))
            *lo = fmaxl(in - step, -far);
        if (is_there(law, m, fminl(in + step, far)))
            *hi = fminl(in + step, far);
    }
    *lo = last_there(law, m, *lo, fmaxl(-far, in - 2 * (in - *lo) - 1));
    *hi = last_there(law, m, *hi, fminl(far, in + 2 * (*hi - in) + 1));
}

/* d mu_ss/dx in 113 bits, to 1e-16 of its scale */
static quad slope_at(const struct law *law, const struct material *m,
                     long double x)
{
    const quad h = 1e-9;

    return (friction_at(law, m, x + h) - friction_at(law, m, x - h)) / (2 * h);
}

static long double rough_slope(const struct law *law, const struct material *m,
                               long double x)
{
    const long double h = 1e-4L;

    return (law_typed_steady(law, m, x + h).mu -
            law_typed_steady(law, m, x - h).mu) /
           (2 * h);
}

/* -1, 1, or 0 where it is none to all digits */
static int sign_at(const struct law *law, const struct material *m,
                   long double x)
{
    const quad slope = slope_at(law, m, x), least = 1e-20;

    return (slope > least) - (slope < -least);
}

struct extrema {
    const struct law *law;
    const struct material *m;
    long double *x;
    size_t n;
};

/* By false position, the older end's slope halved (Illinois). */
static void between(struct extrema *e, long double lo, long double hi)
{
    const quad least = 1e-20;
    quad at_lo = slope_at(e->law, e->m, lo), at_hi = slope_at(e->law, e->m, hi);
    long double x = lo, before = hi;

    if (e->n == 4 || !((at_lo > least && at_hi < -least) ||
                       (at_lo < -least && at_hi > least)))
        return;
    for (int i = 0; i < 60 && fabsl(x - before) > 1e-19L * (1 + fabsl(x));
         i++) {
        before = x;
        x = hi - (long double) (at_hi / (at_hi - at_lo)) * (hi - lo);
        const quad at_x = slope_at(e->law, e->m, x);
        if ((at_x > 0) == (at_hi > 0)) {
            at_lo /= 2;
        } else {
            lo = hi;
            at_lo = at_hi;
        }
        hi = x;
        at_hi = at_x;
    }
    e->x[e->n++] = x;
}

/* Whether the slope, of one sign at lo and hi, has the other between. */
static bool dips(const struct extrema *e, long double lo, long double hi,
                 bool rises, long double *at)
{
    const long double sign = rises ? 1 : -1;

    for (int i = 0; i < 60; i++) {
        const long double s = lo + (hi - lo) / 3, t = hi - (hi - lo) / 3;
        if (sign * rough_slope(e->law, e->m, s) <
            sign * rough_slope(e->law, e->m, t))
            hi = t;
        else
            lo = s;
    }
    *at = (lo + hi) / 2;
    return sign_at(e->law, e->m, *at) == (rises ? -1 : 1);
}

/* In steps of at most an e-fold from lo to hi. */
static void look_between(struct extrema *e, long double lo, long double hi)
{
    const int steps = (int) ceill(hi - lo);
    const long double h = (hi - lo) / (long double) steps;
    const long double off = 1e-3L; /* at a step's end the sign is uncertain */
    long double at, slope[3] = { 0, 0, 0 };

    for (int i = 0; i <= steps; i++) {
        const long double here = lo + h * i;
        slope[2] = rough_slope(e->law, e->m, here);
        if (i > 0 && (slope[1] > 0) != (slope[2] > 0)) {
            between(e, here - h - off, here + off);
        } else if (i > 1 && (slope[0] > 0) == (slope[1] > 0) &&
                   fabsl(slope[1]) < fabsl(slope[0]) &&
                   fabsl(slope[1]) < fabsl(slope[2]) &&
                   dips(e, here - 2 * h, here, slope[1] > 0, &at)) {
            between(e, here - 2 * h, at);
            between(e, at, here);
        }
        slope[0] = slope[1];
        slope[1] = slope[2];
    }
}

/* Whether mu_ss is not a straight line of x around a step of three e-folds. */
static bool bends(const long double mu[3])
{
    const long double bend = mu[0] - 2 * mu[1] + mu[2];

    return fabsl(bend) > 1e-13L * (1 + fabsl(mu[1]));
}

size_t law_typed_extrema(const struct law *law, const struct material *m,
                         long double x[4])
{
    enum { STEP = 3 };
    const long double edge = 2e-3L; /* slopes are taken a bit to both sides */
    struct extrema e = { law, m, x, 0 };
    long double lo, hi, done, from = NAN, mu[3] = { 0, 0, 0 };

    law_typed_range(law, m, &lo, &hi);
    done = lo + edge;
    const int steps = (int) ((hi - lo) / STEP);
    for (int i = 0; i <= steps; i++) {
        const long double here = lo + STEP * i;
        mu[0] = mu[1];
        mu[1] = mu[2];
        mu[2] = law_typed_steady(law, m, here).mu;
        const bool bent = i > 1 && bends(mu);
        if (bent && isnan(from))
            from = fmaxl(done, here - 3 * STEP);
        if (isnan(from) || (bent && i < steps))
            continue;
        done = fminl(hi - edge, here + STEP);
        look_between(&e, from, done);
        from = NAN;
    }
    return e.n;
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
    const long double slope = (long double) slope_at(law, m, x);

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
