#include "quad_formulas.h"

#include <stdlib.h>
#include <string.h>

#include "stress_tolerance.h"

void quad_formulas_needed(const struct formula_system *s,
                          bool needed[FORMULA_NODES])
{
    memset(needed, 0, FORMULA_NODES * sizeof *needed);
    for (int k = 0; k < 2; k++)
        needed[s->rate[k]] = true;
    formula_complete(&s->graph, needed);
}

enum status quad_formulas_init(struct quad_formulas *f,
                               const struct formula_system *s)
{
    bool needed[FORMULA_NODES];

    *f = (struct quad_formulas){ s, calloc(1, sizeof *f->scratch) };
    if (f->scratch == NULL)
        return STATUS_NO_MEMORY;
    quad_formulas_needed(s, needed);
    for (int i = 0; i < s->graph.nodes; i++) {
        const struct formula_node *n = &s->graph.node[i];
        if (n->kind == FORMULA_NUMBER)
            f->scratch->value[i] = n->number;
        else if (needed[i] && n->kind != FORMULA_LEAF)
            f->scratch->node[f->scratch->count++] = (short) i;
    }
    for (int i = 0; i < s->parameters; i++)
        f->scratch->value[s->parameter[i].node] = s->parameter[i].value;
    return STATUS_OK;
}

/* Of the chart. */
static void rates(const void *ctx, quad time, const quad z[2], quad out[2])
{
    const struct quad_formulas *f = ctx;
    const struct formula_system *s = f->system;
    formula_real *value = f->scratch->value;

    (void) time;
    for (int k = 0; k < 2; k++)
        value[s->state[k].node] =
            s->state[k].chart == CHART_POSITIVE ? expq(z[k]) : z[k];
    formula_again(&s->graph, f->scratch->node, f->scratch->count, value);
    for (int k = 0; k < 2; k++)
        out[k] =
            value[s->rate[k]] /
            (s->state[k].chart == CHART_POSITIVE ? value[s->state[k].node] : 1);
    f->scratch->evaluations++;
}

struct quad_way quad_formulas_way(const struct plane_study *s,
                                  const struct quad_formulas *f)
{
    return (struct quad_way){
        .rates = rates,
        .ctx = f,
        .side = { s->scale.side.x, s->scale.side.y },
        .period = { s->scale.period.x, s->scale.period.y },
        .accuracy = STRESS_WAY_STEP,
        .most = 0.01,
    };
}

void quad_formulas_place(struct quad_way *w, const struct plane_rest *r)
{
    for (int k = 0; k < 2; k++)
        w->z[k] = r->exact.chart[k].value;
    quad_way_settle(w);
}

void quad_formulas_free(struct quad_formulas *f)
{
    free(f->scratch);
    f->scratch = NULL;
}
