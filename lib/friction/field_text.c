/* The field as text: a number is a node of a tape (expression.h). */
#include "field_text.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "expression.h"

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

/* ---- elements ------------------------------------------------------------ */

static inline struct expression same(struct expression u)
{
    return u;
}

/* An element, or a plain number as one. */
#define AS(u)                                                                  \
    _Generic((u), struct expression : same, default : expression_number)(u)

#define PLUS(u, w)       expression_sum(AS(u), AS(w))
#define LESS(u, w)       expression_less(AS(u), AS(w))
#define TIMES(u, w)      expression_times(AS(u), AS(w))
#define OVER(u, w)       expression_over(AS(u), AS(w))
#define PLAIN(n)         expression_number(n)
#define GIVEN(m, member) ((m)->member)
#define EPS2(m)          ((m)->eps2)

#define CALL(function, ...)                                                    \
    expression_call(function, (const struct expression[]){ __VA_ARGS__ },      \
                    sizeof(struct expression[]){ __VA_ARGS__ } /               \
                        sizeof(struct expression))

#define FN(f)                   call_##f
#define call_exp(u)             CALL("exp", u)
#define call_log(u)             CALL("ln", u)
#define call_fabs(u)            CALL("abs", u)
#define call_log1p(u)           CALL("ln1p", u)
#define call_expm1(u)           CALL("em1", u)
#define REAL(f)                 real_##f
#define real_size(u)            CALL("abs", u)
#define real_power(u)           CALL("exp", u)
#define real_ln(u)              CALL("ln", u)
#define real_larger(u, w)       CALL("max", u, w)
#define real_at_least(p, u)     CALL("max", u, AS(p))
#define real_asinh_exp(w)       CALL("asinhexp", w)
#define real_lambert(k)         CALL("lambert", k)
#define real_choose(u, p, q, r) CALL("choose", u, AS(p), AS(q), AS(r))

/* ---- the anchor ---------------------------------------------------------- */

struct text_material {
    struct expression mu_star, a, b, c, R, V_c, eps2;
};

#define T       struct expression
#define NAME(f) text_##f
struct text_anchor {
    ANCHOR_MEMBERS(struct expression)
};
#define material text_material
#include "steady_formula.h"
#undef material

static void name_anchor(const struct text_anchor *at)
{
    expression_name(at->y0, "y0");
    expression_name(at->v0, "v0");
    expression_name(at->psi0, "psi0");
    expression_name(at->log_psi0, "lnpsi0");
    expression_name(at->mu0, "mu0");
    expression_name(at->force0, "force0");
    expression_name(at->theta_r, "theta_r");
    expression_name(at->theta_s, "theta_s");
    expression_name(at->steady_r, "steady_r");
    expression_name(at->steady_s, "steady_s");
    expression_name(at->log_inertia, "inertia0");
    expression_name(at->log_rate, "rate0");
    expression_name(at->w0, "w0");
    expression_name(at->q0, "q0");
    expression_name(at->kappa0, "kappa0");
    expression_name(at->log_kappa0, "lnkappa0");
    expression_name(at->log_composite, "heal0");
}

/* ---- numbers ------------------------------------------------------------- */

#define KIND(f) text_##f
#define VAR(w)  struct expression w[1] = { { .hint = #w } }

typedef struct expression text_num;
typedef struct expression text_real;
struct text_ctx {
    struct expression scale, frozen[4];
};

static int text_order(const struct text_ctx *c)
{
    (void) c;
    return 0;
}

/* Variables of the formulas whose names are too short for others to read, or
 * taken: differences from the anchor begin with d. */
static const char *const longer[][2] = {
    { "theta", "dtheta" }, { "mu_log", "dmu_log" }, { "mu", "dmu" },
    { "l", "dsatur" },     { "s", "dsteady" },      { "d", "lag" },
    { "t", "dquick" },     { "u", "dpower" },       { "w", "dpower2" },
    { "psi", "freeze" },   { "z", "dlnvpsi" },      { "q", "dheal" },
};

/* Stores a result under the name that its variable would like. */
static void settle(struct expression u, struct expression *out)
{
    const char *name = out->hint;

    for (size_t i = 0; i < sizeof longer / sizeof *longer; i++)
        if (strcmp(name, longer[i][0]) == 0)
            name = longer[i][1];
    expression_name(u, name);
    *out = u;
}

#define text_linear(c, p, q, u, r, v, out)                                     \
    ((void) (c), settle(PLUS(PLUS(p, TIMES(q, (u)[0])), TIMES(r, (v)[0])), out))
#define text_product(c, u, v, out) ((void) (c), settle(TIMES(*(u), *(v)), out))
#define text_exp(c, l, s, u, out)                                              \
    ((void) (c), (void) (s), (void) (u), settle(CALL("exp", l), out))
#define text_expm1(c, p, log_p, s, u, out)                                     \
    ((void) (c),                                                               \
     settle(CALL("growth", AS(p), AS(log_p), TIMES(s, (u)[0])), out))
#define text_difference(c, p, u, w, out)                                       \
    ((void) (c), settle(CALL("apart", AS(p), *(u), *(w)), out))
#define text_log1p_expm1(c, r, s, u, out)                                      \
    ((void) (c), settle(CALL("mixed", AS(r), AS(s), *(u)), out))
#define text_sinh(c, u, out) ((void) (c), settle(CALL("sinhs", *(u)), out))
#define text_friction(c, a, w0, q0, u, out)                                    \
    ((void) (c), settle(TIMES(a, CALL("bend", w0, q0, *(u))), out))

#include "field_formula.h"

/* ---- lines --------------------------------------------------------------- */

/* Names what stands in several places. */
static void name_repeated(struct tape *t)
{
    size_t named = 0;

    for (size_t i = 0; i < t->nodes; i++) {
        const struct node *n = &t->node[i];
        char name[TAPE_NAME];
        if (n->uses < 2 || n->name[0] || n->kind == NODE_NUMBER)
            continue;
        snprintf(name, sizeof name, "k%zu", ++named);
        expression_name((struct expression){ .tape = t, .node = i }, name);
    }
}

static void write_line(const struct tape *t, size_t i, struct field_text *out)
{
    struct text_line *line = &out->line[out->lines++];

    assert(out->lines <= TEXT_LINES);
    strcpy(line->name, t->node[i].name);
    line->moves = t->node[i].moves;
    const bool whole = expression_write(t, i, line->text, sizeof line->text);
    assert(whole);
    (void) whole;
}

static void write_lines(const struct tape *t, struct field_text *out)
{
    for (size_t i = 0; i < t->nodes; i++) {
        const struct node *n = &t->node[i];
        if (n->uses > 0 && n->kind != NODE_LEAF && n->name[0])
            write_line(t, i, out);
        for (int p = 0; p < TEXT_PARAMETERS; p++)
            if (n->uses > 0 && n->kind == NODE_LEAF &&
                strcmp(n->name, text_parameters[p].name) == 0)
                out->uses[p] = true;
        for (int f = 0; f < SCALAR_TEXTS; f++)
            if (n->uses > 0 && n->kind == NODE_CALL &&
                strcmp(n->function, scalar_texts[f].name) == 0)
                out->calls[f] = true;
    }
    scalar_text_complete(out->calls);
}

static struct expression leaf(struct tape *t, enum text_parameter p)
{
    return expression_leaf(t, text_parameters[p].name, false);
}

static void anchor_on(struct tape *t, const struct law *law,
                      struct text_anchor *at)
{
    const struct text_material m = {
        .mu_star = leaf(t, TEXT_MU_STAR),
        .a = leaf(t, TEXT_A),
        .b = leaf(t, TEXT_B),
        .c = leaf(t, TEXT_C),
        .R = leaf(t, TEXT_R),
        .V_c = leaf(t, TEXT_V_C),
        .eps2 = leaf(t, TEXT_EPS2),
    };
    const struct expression tan_alpha = CALL("tan", leaf(t, TEXT_ALPHA));

    expression_name(tan_alpha, "tan_alpha");
    expression_name(text_inverse_R(&m), "one_R");
    text_anchor(law, &m, tan_alpha, leaf(t, TEXT_LNV0), false, at);
    name_anchor(at);
}

void field_text(const struct law *law, struct field_text *out)
{
    struct tape t = { .nodes = 0 };
    struct text_ctx c = { .scale = expression_number(0) };
    struct text_anchor at;

    *out = (struct field_text){ .lines = 0 };
    anchor_on(&t, law, &at);
    VAR(X);
    VAR(Y);
    VAR(fx);
    VAR(fy);
    VAR(dmu);
    settle(LESS(expression_leaf(&t, text_state_name(law, 0), true), at.x0), X);
    settle(LESS(expression_leaf(&t, text_state_name(law, 1), true), at.y0), Y);
    text_field(law, &at, &c, X, Y, fx, fy);
    text_mu(law, &at, &c, X, Y, dmu);
    const struct expression mu = PLUS(at.mu0, *dmu);
    expression_name(c.scale, "scale");
    expression_name(mu, "mu");
    expression_count((struct expression[]){ *fx, *fy, c.scale, mu }, 4);
    name_repeated(&t);
    write_lines(&t, out);
}
