/* Slopes of steady states that are roots of a rate, for law_curve.c: SCALAR,
 * KIND, and CONSTANTS, SLOPES, ROOT of that type. */

/* dy/dx along rate = 0 */
static SCALAR KIND(root_slope)(const struct law_typed *t,
                               const struct formula_value leaf[])
{
    const struct formula *f = &t->growth;
    SCALAR value[FORMULA_NODES], slope[FORMULA_NODES];

    CONSTANTS(f, leaf, value);
    SLOPES(f, value, leaf_x(f), slope);
    const SCALAR by_x = slope[t->rate];
    SLOPES(f, value, leaf_y(f), slope);
    return -by_x / slope[t->rate];
}

/* d(y, psi, mu)/dx */
static void KIND(slopes_of_root)(const struct typed_curve *c, SCALAR x,
                                 SCALAR out[3])
{
    const struct law_typed *t = c->law->typed;
    const int node[] = { t->y, t->psi, t->mu };
    struct formula_value leaf[LAW_VALUES];
    SCALAR value[FORMULA_NODES], by_x[FORMULA_NODES], by_y[FORMULA_NODES];

    law_values(c->law, c->m, 0, x, ROOT(c->law, c->m, x), leaf);
    CONSTANTS(&t->steady, leaf, value);
    SLOPES(&t->steady, value, leaf_x(&t->steady), by_x);
    SLOPES(&t->steady, value, leaf_y(&t->steady), by_y);
    const SCALAR dy = KIND(root_slope)(t, leaf);
    for (int i = 0; i < 3; i++)
        out[i] = by_x[node[i]] + dy * by_y[node[i]];
}
