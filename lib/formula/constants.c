#include "constants.h"

#include <assert.h>
#include <string.h>

#include "interval_graph.h"
#include "quad.h"

#define SCALAR  quad
#define KIND(f) quad_##f
#define FN(f)   f##q
#include "constants_formula.h"

void formula_constants(const struct formula *f,
                       const struct formula_value leaf[], const bool needed[],
                       formula_real value[])
{
    (void) quad_constants(f, leaf, needed, 0, NULL, value);
}

/* ---- enclosed ------------------------------------------------------------ */

/* Leaves are taken as they are told; they may be roots, known to some 100 bits,
 * which a sum that vanishes allows for.  A constant is known where it has the
 * bits of a long double. */
enum { BITS = 320 };
static const double leaves_known = 0x1p-90, known = 0x1p-66;

static void set_leaves(struct interval_graph *g,
                       const struct formula_value leaf[])
{
    mpfi_t x;

    mpfi_init2(x, BITS);
    for (; leaf->name; leaf++) {
        interval_graph_decimal(x, leaf->value);
        interval_graph_set(g, leaf->name, x);
    }
    mpfi_clear(x);
}

static bool is_known(mpfi_srcptr u)
{
    mpfr_t wide;

    mpfr_init2(wide, BITS);
    mpfi_diam_rel(wide, u);
    const bool is = !mpfi_has_zero(u) && mpfr_cmp_d(wide, known) < 0;
    mpfr_clear(wide);
    return is;
}

/* A long double and what it leaves. */
static quad middle(mpfi_srcptr u)
{
    mpfr_t rest, part;

    mpfr_inits2(BITS, rest, part, NULL);
    mpfi_mid(rest, u);
    const long double most = mpfr_get_ld(rest, MPFR_RNDN);
    mpfr_set_ld(part, most, MPFR_RNDN);
    mpfr_sub(rest, rest, part, MPFR_RNDN);
    const quad out = (quad) most + mpfr_get_ld(rest, MPFR_RNDN);
    mpfr_clears(rest, part, NULL);
    return out;
}

static bool has_leaf(const struct formula *f, const bool needed[])
{
    for (int i = 0; i < f->nodes; i++)
        if (needed[i] && f->node[i].kind == FORMULA_LEAF)
            return true;
    return false;
}

/* A node by its enclosure, where that tells it; if not, a sum of leaves that is
 * less of its first term than these are known to is 0. */
static quad enclosed(const struct formula *f, const struct formula_value leaf[],
                     int node, const quad value[])
{
    const struct formula_node *n = &f->node[node];
    bool needed[FORMULA_NODES] = { false };
    struct interval_graph g;
    struct fault why;

    needed[node] = true;
    formula_complete(f, needed);
    const bool vanishes =
        n->kind == FORMULA_SUM && has_leaf(f, needed) &&
        fabsq(value[node]) < leaves_known * fabsq(value[n->of[0]]);
    quad out = vanishes ? 0 : value[node];
    if (interval_graph_init(&g, f, needed, BITS) == STATUS_OK) {
        set_leaves(&g, leaf);
        if (interval_graph_run(&g, &why) == STATUS_OK &&
            is_known(interval_graph_value(&g, node)))
            out = middle(interval_graph_value(&g, node));
    }
    interval_graph_free(&g);
    return out;
}

void formula_exact_constants(const struct formula *f,
                             const struct formula_value leaf[],
                             const bool needed[], formula_real value[])
{
    (void) quad_constants(f, leaf, needed, 0x1p-40, enclosed, value);
}

/* ---- again --------------------------------------------------------------- */

void formula_again(const struct formula *f, const short node[], int count,
                   formula_real value[])
{
    quad_again(f, node, count, value);
}
