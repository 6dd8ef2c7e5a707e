/* Whole exponents are numbers before anything is lowered, so that powers are
 * products for a base of any sign, also 0. */
#include "system_plane.h"

#include <stdlib.h>
#include <string.h>

/* ---- exponents ----------------------------------------------------------- */

static bool is_whole(formula_real p)
{
    return p > -1000 && p < 1000 && (formula_real) (int) p >= p &&
           (formula_real) (int) p <= p;
}

/* base^p for a whole number p */
static int whole_power(struct formula *f, int base, int p)
{
    const int of[] = { base, formula_number(f, p < 0 ? -p : p) };
    const int one = formula_number(f, 1);

    if (p == 0)
        return one;
    const int power =
        p == 1 || p == -1 ? base : formula_call(f, FUNCTION_POWER, of);
    return p < 0 ? formula_over(f, one, power) : power;
}

static int copy_call(struct formula *f, const struct formula_node *n,
                     const formula_real value[], const int at[])
{
    int of[FUNCTION_ARGUMENTS] = { 0 };

    for (int k = 0; k < n->arguments; k++)
        of[k] = at[n->of[k]];
    if (n->function == FUNCTION_POWER && !f->node[of[1]].moves &&
        is_whole(value[n->of[1]]))
        return whole_power(f, of[0], (int) value[n->of[1]]);
    return formula_call(f, n->function, of);
}

/* The graph once more; at[i]: where node i of the old one is. */
static void copy_graph(struct formula *f, const struct formula *old,
                       const formula_real value[], int at[])
{
    formula_init(f);
    for (int i = 0; i < old->nodes; i++) {
        const struct formula_node *n = &old->node[i];
        const int u = at[n->of[0]], w = at[n->of[1]];
        at[i] = n->kind == FORMULA_NUMBER  ? formula_number(f, n->number)
                : n->kind == FORMULA_LEAF  ? formula_leaf(f, n->name, n->leaf)
                : n->kind == FORMULA_SUM   ? formula_sum(f, u, w)
                : n->kind == FORMULA_TIMES ? formula_times(f, u, w)
                : n->kind == FORMULA_OVER  ? formula_over(f, u, w)
                                           : copy_call(f, n, value, at);
    }
}

/* The rate of a positive state, whose logarithm's is wanted: between terms that
 * vanish as the state does no digits are lost once it is taken out. */
static int rate_of(struct formula *f, const struct formula_system *s, int i,
                   const int at[])
{
    const int rate = at[s->rate[i]], x = at[s->state[i].node];
    int rest;

    return s->state[i].chart == CHART_POSITIVE &&
                   formula_take_out(f, rate, x, &rest)
               ? formula_times(f, x, rest)
               : rate;
}

/* ---- both ways ----------------------------------------------------------- */

static enum status lower(struct system_lowered *out,
                         const struct formula_system *s, struct formula *f,
                         const int at[], struct fault *why)
{
    struct plane_formulas p = { .observables = 0 };
    enum status status = STATUS_OK;

    for (int i = 0; i < 2; i++)
        p.state[i] = at[s->state[i].node];
    for (int i = 0; i < s->observables && i < TAPE_OBSERVABLES; i++)
        p.observable[p.observables++] = at[s->observable[i].node];
    for (int k = 0; k < 4 && status == STATUS_OK; k++) {
        for (int i = 0; i < 2; i++)
            p.rate[i] = formula_times(f, formula_number(f, k % 2 ? -1 : 1),
                                      rate_of(f, s, i, at));
        status = tape_plane_lower(&out->way[k / 2][k % 2], f, &p, k / 2, why);
    }
    return status == STATUS_BAD_ARGUMENT ? STATUS_BAD_SCENE : status;
}

enum status system_plane_lower(struct system_lowered *out,
                               const struct formula_system *s,
                               struct fault *why)
{
    formula_real *value = calloc(FORMULA_NODES, sizeof *value);
    struct formula *f = malloc(sizeof *f);
    int *at = calloc(FORMULA_NODES, sizeof *at);
    enum status status = value && f && at ? STATUS_OK : STATUS_NO_MEMORY;

    for (int i = 0; i < s->parameters; i++) {
        strcpy(out->name[i], s->parameter[i].name);
        out->value[i] =
            (struct formula_value){ out->name[i], s->parameter[i].value };
    }
    out->value[s->parameters] = (struct formula_value){ NULL, 0 };
    if (status == STATUS_OK) {
        formula_constants(&s->graph, out->value, NULL, 0, value);
        copy_graph(f, &s->graph, value, at);
        status = lower(out, s, f, at, why);
    }
    free(value);
    free(f);
    free(at);
    return status;
}

enum status system_plane_at(const struct system_lowered *l, bool equilibrium,
                            bool backward, const formula_real anchor[2],
                            struct tape_plane *out, struct fault *why)
{
    const enum status status = tape_plane_at(&l->way[equilibrium][backward],
                                             l->value, anchor, out, why);

    return status == STATUS_BAD_ARGUMENT ? STATUS_BAD_SCENE : status;
}
