/* Interval Newton methods stop where natural scales differ by e^100; in
 * logarithms the steady curves of friction are nearly straight. */
#include "equations.h"

struct making {
    struct equations *e;
    const struct formula *from;
    const formula_real *value; /* by node of `from` */
    int made[FORMULA_NODES];   /* by node of `from`, plus one */
};

static const struct formula_node *node_of(const struct formula *f, int u)
{
    return &f->node[u];
}

/* ---- logarithms ---------------------------------------------------------- */

/* Whether ln u has no logarithm of what changes in it. */
static bool has_log(const struct formula *f, int u)
{
    const struct formula_node *n = node_of(f, u);

    if (!n->positive)
        return false;
    if (!n->moves)
        return true;
    if (n->kind == FORMULA_TIMES || n->kind == FORMULA_OVER)
        return has_log(f, n->of[0]) && has_log(f, n->of[1]);
    if (n->kind != FORMULA_CALL)
        return false;
    return n->function == FUNCTION_EXP ||
           ((n->function == FUNCTION_SQRT || n->function == FUNCTION_POWER) &&
            has_log(f, n->of[0]));
}

enum { FUEL = 400 }; /* nodes that are taken apart: shared ones count again */

/* ln u of u > 0; whole where there is no fuel left. */
static int log_in(struct formula *f, int u, int *fuel)
{
    const struct formula_node n = *node_of(f, u);
    const bool both = n.arguments == 2 && node_of(f, n.of[0])->positive &&
                      node_of(f, n.of[1])->positive;

    if (--*fuel < 0)
        return formula_of(f, FUNCTION_LN, u);
    if (n.kind == FORMULA_TIMES && both)
        return formula_sum(f, log_in(f, n.of[0], fuel),
                           log_in(f, n.of[1], fuel));
    if (n.kind == FORMULA_OVER && both)
        return formula_less(f, log_in(f, n.of[0], fuel),
                            log_in(f, n.of[1], fuel));
    if (n.kind == FORMULA_CALL && n.function == FUNCTION_SQRT)
        return formula_over(f, log_in(f, n.of[0], fuel), formula_number(f, 2));
    if (n.kind == FORMULA_CALL && n.function == FUNCTION_POWER &&
        node_of(f, n.of[0])->positive)
        return formula_times(f, n.of[1], log_in(f, n.of[0], fuel));
    return formula_of(f, FUNCTION_LN, u);
}

static int log_of(struct formula *f, int u)
{
    int fuel = FUEL;

    return log_in(f, u, &fuel);
}

/* Products and quotients of exponentials are one. */
static int gather(struct formula *f, int u)
{
    const struct formula_node n = *node_of(f, u);

    if (n.kind == FORMULA_NUMBER || n.kind == FORMULA_LEAF || !n.moves ||
        !has_log(f, u) ||
        (n.kind == FORMULA_CALL && n.function == FUNCTION_EXP))
        return u;
    return formula_of(f, FUNCTION_EXP, log_of(f, u));
}

/* ---- into the chart ------------------------------------------------------ */

static int chart_leaf(struct making *m, int i)
{
    const struct formula_node *n = node_of(m->from, i);
    const formula_real value = m->value[i];

    if (!n->moves && value >= 0 && value <= 0)
        return formula_number(&m->e->graph, 0);
    return formula_leaf(&m->e->graph, n->name, n->leaf);
}

/* The square of a constant may be 0: it counts as positive if that is. */
static int chart_product(struct formula *f, int u, int w)
{
    const int product = gather(f, formula_times(f, u, w));

    if (u == w && !f->node[u].moves && f->node[product].kind == FORMULA_TIMES)
        f->node[product].positive = f->node[u].positive;
    return product;
}

static int chart_node(struct making *m, int i)
{
    const struct formula_node *n = node_of(m->from, i);
    struct formula *f = &m->e->graph;
    int of[FUNCTION_ARGUMENTS] = { 0 };

    for (int k = 0; k < n->arguments; k++)
        of[k] = m->made[n->of[k]] - 1;
    switch (n->kind) {
        case FORMULA_NUMBER:
            return formula_number(f, n->number);
        case FORMULA_LEAF:
            return chart_leaf(m, i);
        case FORMULA_SUM:
            return formula_sum(f, of[0], of[1]);
        case FORMULA_TIMES:
            return chart_product(f, of[0], of[1]);
        case FORMULA_OVER:
            return gather(f, formula_over(f, of[0], of[1]));
        case FORMULA_CALL:
            break;
    }
    if (n->arguments > 1)
        return gather(f, formula_call(f, n->function, of));
    if (n->function == FUNCTION_LN && node_of(f, of[0])->positive)
        return log_of(f, of[0]);
    return gather(f, formula_of(f, n->function, of[0]));
}

/* ---- what vanishes ------------------------------------------------------- */

/* The function that undoes f where f is one to one; FUNCTIONS: none. */
static enum formula_function inverse_of(enum formula_function f)
{
    switch (f) {
        case FUNCTION_ASINH:
            return FUNCTION_SINH;
        case FUNCTION_SINH:
            return FUNCTION_ASINH;
        case FUNCTION_LN:
            return FUNCTION_EXP;
        default:
            return FUNCTIONS;
    }
}

/* k f(u) + c = 0 as u - f^-1(-c/k) = 0, k and c constants; not the logarithm of
 * what is > 0, which split is made of. */
static bool undo(struct formula *f, int u, int *out)
{
    const struct formula_node n = *node_of(f, u);

    if (n.kind != FORMULA_SUM)
        return false;
    for (int i = 0; i < 2; i++) {
        int k = formula_number(f, 1), call = n.of[i], c = n.of[1 - i], rest;
        const formula_real factor = formula_factor(f, call, &rest);
        const struct formula_node t = *node_of(f, rest);
        if (t.kind == FORMULA_TIMES && !node_of(f, t.of[0])->moves &&
            node_of(f, t.of[0])->positive) {
            k = t.of[0];
            rest = t.of[1];
        }
        const struct formula_node g = *node_of(f, rest);
        const enum formula_function inverse =
            g.kind == FORMULA_CALL ? inverse_of(g.function) : FUNCTIONS;
        if (node_of(f, c)->moves || inverse == FUNCTIONS || !g.moves ||
            (g.function == FUNCTION_LN && node_of(f, g.of[0])->positive))
            continue;
        call = formula_over(
            f, formula_times(f, formula_number(f, -1 / factor), c), k);
        *out = formula_less(f, g.of[0], formula_of(f, inverse, call));
        return true;
    }
    return false;
}

/* part[0] - part[1] = c u, of terms that are > 0. */
static bool split(struct formula *f, formula_real c, int u, int *fuel,
                  int part[2])
{
    int rest;
    const formula_real factor = c * formula_factor(f, u, &rest);
    const struct formula_node n = *node_of(f, rest);

    if (n.kind == FORMULA_NUMBER) {
        const formula_real number = factor * n.number;
        const int sign = number < 0;
        part[sign] = formula_sum(f, part[sign],
                                 formula_number(f, sign ? -number : number));
        return true;
    }
    if (n.positive) {
        const int sign = factor < 0;
        const int term =
            formula_times(f, formula_number(f, sign ? -factor : factor), rest);
        part[sign] = formula_sum(f, part[sign], term);
        return true;
    }
    return --*fuel > 0 && n.kind == FORMULA_SUM &&
           split(f, factor, n.of[0], fuel, part) &&
           split(f, factor, n.of[1], fuel, part);
}

/* f(u) = 0 where u = 0 and nowhere else; FUNCTION_POWER: u^n. */
static bool is_odd(enum formula_function f)
{
    return f == FUNCTION_SINH || f == FUNCTION_ASINH || f == FUNCTION_TANH ||
           f == FUNCTION_ATAN || f == FUNCTION_ASIN;
}

/* over/under; beside a pole, which intervals cannot see past, `over` is as good
 * as elsewhere. */
struct fraction {
    int over, under;
};

static struct fraction cross(struct formula *f, struct fraction a,
                             struct fraction b)
{
    if (a.under == b.under)
        return (struct fraction){ formula_sum(f, a.over, b.over), a.under };
    return (struct fraction){ formula_sum(f, formula_times(f, a.over, b.under),
                                          formula_times(f, b.over, a.under)),
                              formula_times(f, a.under, b.under) };
}

/* u = over/under, `under` of the denominators that change and may be 0. */
static struct fraction fraction_of(struct formula *f, int u, int *fuel)
{
    const struct formula_node n = *node_of(f, u);
    const struct fraction whole = { u, formula_number(f, 1) };

    if (n.kind == FORMULA_CALL && n.function == FUNCTION_TAN)
        return (struct fraction){ formula_of(f, FUNCTION_SIN, n.of[0]),
                                  formula_of(f, FUNCTION_COS, n.of[0]) };
    if (n.kind == FORMULA_NUMBER || n.kind == FORMULA_LEAF ||
        n.kind == FORMULA_CALL || n.positive || !n.moves || --*fuel < 0)
        return whole;
    const struct fraction a = fraction_of(f, n.of[0], fuel);
    if (n.kind == FORMULA_OVER &&
        (node_of(f, n.of[1])->positive || !node_of(f, n.of[1])->moves))
        return (struct fraction){ formula_over(f, a.over, n.of[1]), a.under };
    const struct fraction b = fraction_of(f, n.of[1], fuel);
    if (n.kind == FORMULA_SUM)
        return cross(f, a, b);
    if (n.kind == FORMULA_OVER)
        return (struct fraction){ formula_times(f, a.over, b.under),
                                  formula_times(f, a.under, b.over) };
    return (struct fraction){ formula_times(f, a.over, b.over),
                              formula_times(f, a.under, b.under) };
}

/* A simpler node that vanishes where u does; u if there is none. */
static int simpler(struct formula *f, int u)
{
    const struct formula_node n = *node_of(f, u);
    int part[2] = { 0, 0 }, out, fuel = FUEL, more = FUEL;

    if (n.kind == FORMULA_TIMES &&
        (node_of(f, n.of[0])->positive ||
         node_of(f, n.of[0])->kind == FORMULA_NUMBER || n.of[0] == n.of[1]))
        return n.of[1];
    if (n.kind == FORMULA_TIMES && node_of(f, n.of[1])->positive)
        return n.of[0];
    if (n.kind == FORMULA_OVER)
        return n.of[0];
    if (n.kind == FORMULA_CALL && is_odd(n.function))
        return n.of[0];
    if (n.kind == FORMULA_CALL && n.function == FUNCTION_POWER &&
        node_of(f, n.of[1])->kind == FORMULA_NUMBER &&
        node_of(f, n.of[1])->number > 0)
        return n.of[0];
    if (n.kind == FORMULA_SUM && undo(f, u, &out))
        return out;
    if (n.kind == FORMULA_SUM && split(f, 1, u, &fuel, part) && part[0] &&
        part[1])
        return formula_less(f, log_of(f, part[0]), log_of(f, part[1]));
    return fraction_of(f, u, &more).over;
}

/* ---- all ----------------------------------------------------------------- */

/* The leaves that are not the chart keep their values. */
static void carry_values(struct making *m)
{
    struct equations *e = m->e;

    for (int i = 0; i < e->graph.nodes; i++)
        e->value[i] = 0;
    for (int i = 0; i < m->from->nodes; i++)
        if (m->from->node[i].kind == FORMULA_LEAF && !m->from->node[i].moves)
            e->value[m->made[i] - 1] = m->value[i];
}

bool equations_make(struct equations *e, const struct formula *f,
                    const int state[2], const int rate[2],
                    const formula_real value[])
{
    static const struct making none;
    struct making m = none;
    struct formula *g = &e->graph;

    m.e = e;
    m.from = f;
    m.value = value;
    formula_init(g);
    for (int i = 0; i < 2; i++) {
        e->variable[i] =
            formula_leaf(g, i ? "chart y" : "chart x", FORMULA_STATE);
        m.made[state[i]] =
            1 + (f->node[state[i]].positive
                     ? formula_of(g, FUNCTION_EXP, e->variable[i])
                     : e->variable[i]);
    }
    for (int i = 0; i < f->nodes && !g->full; i++)
        if (m.made[i] == 0)
            m.made[i] = 1 + chart_node(&m, i);
    for (int i = 0; i < 2; i++) {
        const int own = m.made[rate[i]] - 1;
        int u = own, before = -1;
        while (u != before && !g->full) {
            before = u;
            u = simpler(g, u);
        }
        e->equation[i] = u;
        e->rate[i] = f->node[state[i]].positive
                         ? formula_over(g, own, m.made[state[i]] - 1)
                         : own;
    }
    carry_values(&m);
    return !g->full;
}
