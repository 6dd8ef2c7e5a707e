#include "law_graph.h"

#include <float.h>
#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "constants.h"
#include "law_tape.h"
#include "law_typed.h"
#include "parse.h"
#include "quad.h"
#include "slope.h"

/* ---- making -------------------------------------------------------------- */

/* A part of the graph, under this name if formulas may use it; 0 where it is
 * not given. */
static int part(struct formula *f, const char *name, const char *text)
{
    struct fault why;
    int node = 0;

    if (text && formula_parse(f, text, &node, &why) == STATUS_OK && name)
        formula_define(f, name, node);
    return node;
}

/* What nodes are made of, but for those of `done`. */
static void find_steps(const struct formula *f, const int wanted[], int count,
                       const bool done[], struct law_steps *out)
{
    bool needed[FORMULA_NODES] = { false };

    for (int i = 0; i < count; i++)
        needed[wanted[i]] = true;
    formula_complete(f, needed);
    out->count = 0;
    for (int i = 0; i < f->nodes; i++)
        if (needed[i] && !done[i] && f->node[i].kind != FORMULA_LEAF)
            out->node[out->count++] = (short) i;
}

static void order(struct law_graph *g)
{
    const int first[] = { g->y_ss, g->psi_ss };
    bool done[FORMULA_NODES] = { false };

    find_steps(&g->f, first, g->psi_ss >= 0 ? 2 : 0, done, &g->steady);
    for (int i = 0; i < g->steady.count; i++)
        done[g->steady.node[i]] = true;
    done[g->psi] = true;
    for (int i = 0; i < LAW_NUMBERS; i++)
        find_steps(&g->f, &g->node[i], 1, done, &g->then[i]);
}

static void make_state(const struct law *law, struct law_graph *g)
{
    const bool is_log = law_psi_is_log(law);
    const char *psi_ss = law_text(law, LAW_PSI_SS);
    struct formula *f = &g->f;

    law_names(law, f);
    g->x = formula_find(f, LAW_LNV0, sizeof LAW_LNV0 - 1);
    g->y = formula_find(f, LAW_Y0, sizeof LAW_Y0 - 1);
    formula_define(f, "v", formula_of(f, FUNCTION_EXP, g->x));
    g->psi_ss = psi_ss ? part(f, "psi_ss", psi_ss) : -1;
    g->y_ss = g->psi_ss < 0 || is_log ? g->psi_ss
                                      : formula_of(f, FUNCTION_LN, g->psi_ss);
    g->psi = is_log ? g->y : formula_of(f, FUNCTION_EXP, g->y);
    formula_define(f, "psi", g->psi);
}

/* asinh(v/2 e^..) as it does not overflow */
static void make_friction(const struct law *law, struct law_graph *g)
{
    const char *own = law_text(law, LAW_MU);
    struct formula *f = &g->f;
    const int a = formula_find(f, "a", 1);
    int mu = part(f, NULL, own ? own : "mu_star + a*ln(v) + b*theta");

    g->node[LAW_AT_MU_LOG] = mu;
    if (own == NULL && law->form == FRICTION_ASINH)
        mu = formula_times(
            f, a, formula_of(f, FUNCTION_ASINHEXP, formula_over(f, mu, a)));
    g->node[LAW_AT_MU] = mu;
    formula_define(f, "mu", mu);
}

void law_graph_make(const struct law *law, struct law_graph *g)
{
    const char *K = law_text(law, LAW_K), *rate = law_text(law, LAW_RATE);
    struct formula *f = &g->f;
    int *node = g->node;

    make_state(law, g);
    node[LAW_AT_Y] = g->y;
    node[LAW_AT_PSI] = g->psi;
    node[LAW_AT_THETA] = part(f, "theta", law_text(law, LAW_THETA));
    part(f, "d", g->psi_ss < 0 ? NULL : "psi - psi_ss");
    part(f, "T", law_text(law, LAW_T));
    part(f, "K", K);
    make_friction(law, g);
    node[LAW_AT_GROWTH] = part(f, NULL, rate ? rate : K ? "-K/T" : "-d/T");
    node[LAW_AT_DX] = part(f, NULL,
                           "(tan_alpha - mu)/"
                           "(v*eps2*sqrt(1 + tan_alpha*tan_alpha))");
    if (law_psi_is_log(law))
        node[LAW_AT_DY] = node[LAW_AT_GROWTH];
    else if (!formula_take_out(f, node[LAW_AT_GROWTH], g->psi,
                               &node[LAW_AT_DY]))
        node[LAW_AT_DY] = formula_over(f, node[LAW_AT_GROWTH], g->psi);
    order(g);
}

const struct law_graph *law_graph_kept(const struct law *law,
                                       struct law_graph *room)
{
    static _Atomic(struct law_graph *) kept[LAW_COMPOSITIONS];
    _Atomic(struct law_graph *) *place = &kept[law_composition(law)];
    struct law_graph *there = atomic_load(place), *made;

    if (law->typed)
        return &law->typed->graph;
    if (there)
        return there;
    made = malloc(sizeof *made);
    room = made ? made : room;
    law_graph_make(law, room);
    if (made == NULL || atomic_compare_exchange_strong(place, &there, made))
        return room;
    free(made); /* another thread was sooner */
    return there;
}

/* ---- numbers ------------------------------------------------------------- */

#define SCALAR  long double
#define POINT   law_long
#define KIND(f) law_long_##f
#define FN(f)   f##l
#define VALUES  formula_long_again
#define SLOPES  formula_long_slopes
#define ROOT    law_root
#include "law_point_formula.h"
#undef SCALAR
#undef POINT
#undef KIND
#undef FN
#undef VALUES
#undef SLOPES
#undef ROOT

#define SCALAR  quad
#define POINT   law_quad
#define KIND(f) law_quad_##f
#define FN(f)   f##q
#define VALUES  formula_again
#define SLOPES  formula_slopes
#define ROOT    law_root_quad
#include "law_point_formula.h"

/* ---- rounding ------------------------------------------------------------ */

/* Where the growth of psi is 0: its own rounding over its slope there, and that
 * of y. */
static void round_root(struct law_long *p)
{
    const struct law_graph *g = p->g;
    const struct law_steps *growth = &g->then[LAW_AT_GROWTH];
    const int node = g->node[LAW_AT_GROWTH];

    (void) law_long_also(p, LAW_AT_GROWTH);
    const long double y = p->value[g->y],
                      slope = law_long_by(p, LAW_AT_GROWTH, g->y);
    p->slope[g->psi] = LDBL_EPSILON * p->value[g->psi];
    formula_long_roundings(&g->f, growth->node, growth->count, p->value,
                           p->slope);
    p->slope[g->y] =
        p->slope[node] / fabsl(slope) + LDBL_EPSILON * (1 + fabsl(y));
    p->slope[g->psi] = p->slope[g->y] * (g->psi == g->y ? 1 : p->value[g->psi]);
}

long double law_long_rounding(struct law_long *p, enum law_number what)
{
    const struct law_graph *g = p->g;
    const struct law_steps *then = &g->then[what];

    formula_long_roundings(&g->f, g->steady.node, g->steady.count, p->value,
                           p->slope);
    if (g->psi_ss < 0) {
        round_root(p);
    } else {
        p->slope[g->y] = p->slope[g->y_ss];
        p->slope[g->psi] = p->slope[g->psi_ss];
    }
    formula_long_roundings(&g->f, then->node, then->count, p->value, p->slope);
    const long double off = p->slope[g->node[what]];
    p->slope[g->y] = 0;
    return off;
}
