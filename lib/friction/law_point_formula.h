/* The functions of law_graph.h for SCALAR, KIND(f), their names, FN(f), the
 * mathematical function f, VALUES and SLOPES, those of constants.h and slope.h,
 * and ROOT. */

void KIND(init)(struct POINT *p, const struct law *law,
                const struct material *m, SCALAR tan_alpha)
{
    const SCALAR V = m->V_star, gL = (SCALAR) m->g * (SCALAR) m->L;
    const SCALAR model[] = {
        tan_alpha, m->mu_star, m->a,
        m->b,      m->c,       isinf(m->R) ? (SCALAR) LAW_R_INFINITE : m->R,
        m->V_c,    V * V / gL
    };
    int n = 1;

    p->law = law;
    p->m = m;
    p->g = law_graph_kept(law, &p->room);
    for (size_t i = 0; i < sizeof model / sizeof *model; i++)
        p->value[n++] = model[i];
    n += 2; /* x and y */
    for (int i = 0; law->typed && i < law->typed->owns; i++)
        p->value[n++] = m->own[i];
    for (int i = 0; i < n; i++)
        p->slope[i] = 0;
}

SCALAR KIND(also)(struct POINT *p, enum law_number what)
{
    const struct law_graph *g = p->g;
    const struct law_steps *then = &g->then[what];

    VALUES(&g->f, then->node, then->count, p->value);
    return p->value[g->node[what]];
}

/* At the steady state if y is NULL. */
static SCALAR KIND(run)(struct POINT *p, SCALAR x, const SCALAR *y,
                        enum law_number what)
{
    const struct law_graph *g = p->g;
    SCALAR *value = p->value;

    value[g->x] = x;
    VALUES(&g->f, g->steady.node, g->steady.count, value);
    value[g->y] = y ? *y : value[g->y_ss];
    value[g->psi] = y == NULL        ? value[g->psi_ss]
                    : g->psi == g->y ? *y
                                     : FN(exp)(*y);
    return KIND(also)(p, what);
}

SCALAR KIND(at)(struct POINT *p, SCALAR x, SCALAR y, enum law_number what)
{
    return KIND(run)(p, x, &y, what);
}

SCALAR KIND(steady)(struct POINT *p, SCALAR x, enum law_number what)
{
    if (p->g->psi_ss >= 0)
        return KIND(run)(p, x, NULL, what);
    const SCALAR y = ROOT(p, x);
    return KIND(run)(p, x, &y, what);
}

SCALAR KIND(by)(struct POINT *p, enum law_number what, int leaf)
{
    const struct law_graph *g = p->g;
    const struct law_steps *then = &g->then[what];
    SCALAR *slope = p->slope;

    slope[leaf] = 1;
    SLOPES(&g->f, g->steady.node, g->steady.count, p->value, slope);
    slope[g->psi] = leaf != g->y ? 0 : g->psi == g->y ? 1 : p->value[g->psi];
    SLOPES(&g->f, then->node, then->count, p->value, slope);
    slope[leaf] = 0;
    return g->node[what] == leaf ? 1 : slope[g->node[what]];
}

SCALAR KIND(climb)(struct POINT *p, SCALAR x)
{
    const struct law_graph *g = p->g;

    if (g->psi_ss < 0) { /* along growth = 0 */
        (void) KIND(steady)(p, x, LAW_AT_GROWTH);
        return -KIND(by)(p, LAW_AT_GROWTH, g->x) /
               KIND(by)(p, LAW_AT_GROWTH, g->y);
    }
    (void) KIND(steady)(p, x, LAW_AT_Y);
    (void) KIND(by)(p, LAW_AT_Y, g->x);
    return p->slope[g->y_ss];
}

SCALAR KIND(along)(struct POINT *p, SCALAR x, enum law_number what)
{
    const struct law_graph *g = p->g;
    const SCALAR rise = KIND(climb)(p, x);

    if (g->psi_ss < 0)
        (void) KIND(at)(p, x, p->value[g->y], what);
    else
        (void) KIND(run)(p, x, NULL, what);
    return KIND(by)(p, what, g->x) + rise * KIND(by)(p, what, g->y);
}
