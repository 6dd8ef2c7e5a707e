/* Where psi_ss is a formula of v, its nodes and their slopes; where it is the
 * root y of a rate, dy/dx = -(d rate/dx)/(d rate/dy). */
#include "law_curve.h"

#include <math.h>
#include <string.h>

#include "law_root.h"
#include "quad.h"
#include "slope.h"

static bool is_root(const struct typed_curve *c)
{
    return c->law->typed->text[LAW_PSI_SS][0] == '\0';
}

static int leaf_x(const struct formula *f)
{
    return formula_find(f, "lnv0", 4);
}

static int leaf_y(const struct formula *f)
{
    return formula_find(f, "y0", 2);
}

void law_curve_init(struct typed_curve *c, const struct law *law,
                    const struct material *m)
{
    const struct law_typed *t = law->typed;
    const int x = leaf_x(&t->steady);
    struct formula_value leaf[LAW_VALUES];

    c->law = law;
    c->m = m;
    law_values(law, m, 0, 0, 0, leaf);
    formula_long_constants(&t->steady, leaf, NULL, c->value);
    c->count = formula_changing(&t->steady, x, (int[]){ t->y, t->psi, t->mu },
                                3, c->changing);
    c->count_mu = formula_changing(&t->steady, x, &t->mu, 1, c->of_mu);
    c->is_exact = false;
    memset(c->slope, 0, sizeof c->slope);
    c->slope[x] = 1;
}

/* The first that changes is x. */
struct typed_steady law_curve_at(struct typed_curve *c, long double x)
{
    const struct law_typed *t = c->law->typed;

    if (is_root(c))
        return law_typed_steady(c->law, c->m, x);
    c->value[c->changing[0]] = x;
    formula_long_again(&t->steady, c->changing + 1, c->count - 1, c->value);
    return (struct typed_steady){ c->value[t->y], c->value[t->psi],
                                  c->value[t->mu] };
}

/* ---- slopes -------------------------------------------------------------- */

#define SCALAR             long double
#define KIND(f)            long_##f
#define CONSTANTS(f, l, v) ((void) formula_long_constants(f, l, NULL, v))
#define SLOPES             formula_long_slopes
#define ROOT               law_root
#include "law_curve_formula.h"
#undef SCALAR
#undef KIND
#undef CONSTANTS
#undef SLOPES
#undef ROOT

#define SCALAR             quad
#define KIND(f)            quad_##f
#define CONSTANTS(f, l, v) formula_constants(f, l, NULL, 0, v)
#define SLOPES             formula_slopes
#define ROOT               law_root_quad
#include "law_curve_formula.h"

struct typed_steady law_curve_slopes(struct typed_curve *c, long double x)
{
    const struct law_typed *t = c->law->typed;
    long double all[3];

    if (is_root(c)) {
        long_slopes_of_root(c, x, all);
        return (struct typed_steady){ all[0], all[1], all[2] };
    }
    law_curve_at(c, x);
    formula_long_slopes_again(&t->steady, c->changing + 1, c->count - 1,
                              c->value, c->slope);
    return (struct typed_steady){ c->slope[t->y], c->slope[t->psi],
                                  c->slope[t->mu] };
}

static void make_exact(struct typed_curve *c)
{
    const struct formula *f = &c->law->typed->steady;
    struct formula_value leaf[LAW_VALUES];

    law_values(c->law, c->m, 0, 0, 0, leaf);
    formula_constants(f, leaf, NULL, 0, c->exact);
    memset(c->exact_slope, 0, sizeof c->exact_slope);
    c->exact_slope[leaf_x(f)] = 1;
    c->is_exact = true;
}

formula_real law_curve_slope(struct typed_curve *c, long double x)
{
    const struct law_typed *t = c->law->typed;
    quad all[3];

    if (is_root(c)) {
        quad_slopes_of_root(c, x, all);
        return all[2];
    }
    if (!c->is_exact)
        make_exact(c);
    c->exact[c->of_mu[0]] = x;
    formula_again(&t->steady, c->of_mu + 1, c->count_mu - 1, c->exact);
    formula_slopes_again(&t->steady, c->of_mu + 1, c->count_mu - 1, c->exact,
                         c->exact_slope);
    return c->exact_slope[t->mu];
}
