/*
 * rate_formula.h -- the observables that ride along an orbit, for the kinds of
 * number that need them; include after field_formula.h.
 */

/* The rates of block.h's observables, times exp(-scale). */
static void KIND(rate)(const struct law *law, const struct KIND(anchor) * at,
                       struct KIND(ctx) * c, enum block_observable which,
                       KIND(real) scale, const KIND(num) * X,
                       const KIND(num) * Y, KIND(num) * out)
{
    VAR(mu);
    VAR(v);
    VAR(total);

    switch (which) {
        case BLOCK_SLIP:
            KIND(exp)(c, at->x0 + X[0] - scale, 1, X, out);
            break;
        case BLOCK_EXCESS:
            KIND(expm1)
            (c, REAL(power)(at->x0 - scale), at->x0 - scale, 1, X, out);
            break;
        default: /* BLOCK_WORK */
            KIND(mu)(law, at, c, X, Y, mu);
            KIND(linear)(c, at->mu0, 1, mu, 0, mu, total);
            KIND(exp)(c, at->x0 + X[0] - scale, 1, X, v);
            KIND(product)(c, total, v, out);
            break;
    }
}
