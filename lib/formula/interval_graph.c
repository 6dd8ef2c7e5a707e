#include "interval_graph.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Newton's method doubles the digits, from one or so to 256 bits in eight, and
 * falls by 1 at first where k < 0 is large, which nothing asks for. */
enum { LAMBERT_STEPS = 16 };

/* ---- numbers ------------------------------------------------------------- */

/* 113 bits are the sum of three doubles. */
void interval_graph_decimal(mpfi_ptr out, formula_real x)
{
    const struct interval_quad u = interval_decimal(x);
    const formula_real end[2] = { u.lo, u.hi };
    mpfr_t sum[2];

    for (int i = 0; i < 2; i++) {
        formula_real rest = end[i];
        mpfr_init2(sum[i], 160);
        mpfr_set_zero(sum[i], 1);
        for (int k = 0; k < 3; k++) {
            const double part = (double) rest;
            mpfr_add_d(sum[i], sum[i], part, i == 0 ? MPFR_RNDD : MPFR_RNDU);
            rest -= part;
        }
    }
    mpfi_interv_fr(out, sum[0], sum[1]);
    for (int i = 0; i < 2; i++)
        mpfr_clear(sum[i]);
}

bool interval_has_64_bits(void)
{
    const volatile long double one = 1;

    return one + 0x1p-63L > one;
}

struct interval interval_of_mpfi(mpfi_srcptr u)
{
    if (!interval_has_64_bits())
        return (struct interval){ -HUGE_VAL, HUGE_VAL };
    return (struct interval){ mpfr_get_ld(&u->left, MPFR_RNDD),
                              mpfr_get_ld(&u->right, MPFR_RNDU) };
}

/* ---- functions ----------------------------------------------------------- */

static void asinh_exp(mpfi_ptr out, mpfi_srcptr u)
{
    mpfi_exp(out, u);
    mpfi_div_2ui(out, out, 1);
    mpfi_asinh(out, out);
}

static bool is_whole(mpfi_srcptr w, long *n)
{
    *n = mpfr_get_si(&w->left, MPFR_RNDN);
    return mpfr_equal_p(&w->left, &w->right) && mpfr_cmp_si(&w->left, *n) == 0;
}

/* u^n rises with |u|, or with u where n is odd. */
static void whole_power(mpfi_ptr out, mpfi_srcptr u, long n)
{
    const unsigned long size = n < 0 ? -(unsigned long) n : (unsigned long) n;

    if (size % 2)
        mpfi_set(out, u);
    else
        mpfi_abs(out, u);
    mpfr_pow_ui(&out->left, &out->left, size, MPFR_RNDD);
    mpfr_pow_ui(&out->right, &out->right, size, MPFR_RNDU);
    if (n < 0)
        mpfi_inv(out, out);
}

/* Of a whole w; else exp(w ln u) of u > 0. */
static void power(mpfi_ptr out, mpfi_srcptr u, mpfi_srcptr w)
{
    mpfi_t l;
    long n;

    if (is_whole(w, &n)) {
        whole_power(out, u, n);
        return;
    }
    mpfi_init2(l, mpfi_get_prec(out));
    mpfi_log(l, u);
    mpfi_mul(l, l, w);
    mpfi_exp(out, l);
    mpfi_clear(l);
}

/* ln W(e^-k), where w + e^w + k, which rises, goes through 0: w from Newton's
 * method, moved as far as its sign needs. */
static void ln_lambert(mpfr_ptr w, mpfr_srcptr k, mpfr_rnd_t to)
{
    const double away = to == MPFR_RNDD ? -1 : 1;
    mpfr_t e, f, step;

    mpfr_inits2(mpfr_get_prec(w), e, f, step, NULL);
    mpfr_neg(w, k, MPFR_RNDN);
    for (int i = 0; i < LAMBERT_STEPS; i++) {
        mpfr_exp(e, w, MPFR_RNDN);
        mpfr_add(f, w, e, MPFR_RNDN);
        mpfr_add(f, f, k, MPFR_RNDN);
        mpfr_add_ui(e, e, 1, MPFR_RNDN);
        mpfr_div(f, f, e, MPFR_RNDN);
        mpfr_sub(w, w, f, MPFR_RNDN);
    }
    mpfr_set_d(step, away, to);
    mpfr_mul_2si(step, step, 8 - (long) mpfr_get_prec(w), to);
    mpfr_fma(step, step, k, step, to); /* an ulp of w or k, and more */
    for (int i = 0; i < LAMBERT_STEPS; i++) {
        const mpfr_rnd_t from = to == MPFR_RNDD ? MPFR_RNDU : MPFR_RNDD;
        mpfr_exp(e, w, from);
        mpfr_add(f, w, e, from);
        mpfr_add(f, f, k, from);
        if (mpfr_sgn(f) * away >= 0)
            break;
        mpfr_add(w, w, step, to);
        mpfr_mul_2ui(step, step, 1, to);
        if (i + 1 == LAMBERT_STEPS)
            mpfr_set_nan(w);
    }
    mpfr_clears(e, f, step, NULL);
}

/* W(e^-k) of k >= 0 falls. */
static void lambert(mpfi_ptr out, mpfi_srcptr k)
{
    mpfr_t end[2];

    mpfr_inits2(mpfi_get_prec(out), end[0], end[1], NULL);
    ln_lambert(end[0], &k->right, MPFR_RNDD);
    ln_lambert(end[1], &k->left, MPFR_RNDU);
    mpfi_interv_fr(out, end[0], end[1]);
    mpfi_exp(out, out);
    mpfr_clears(end[0], end[1], NULL);
}

/* False: there is no rule. */
static bool call(enum formula_function function, mpfi_ptr out, mpfi_srcptr u)
{
    static int (*const by[FUNCTIONS])(mpfi_ptr, mpfi_srcptr) = {
        [FUNCTION_EXP] = mpfi_exp,   [FUNCTION_LN] = mpfi_log,
        [FUNCTION_SQRT] = mpfi_sqrt, [FUNCTION_SINH] = mpfi_sinh,
        [FUNCTION_COSH] = mpfi_cosh, [FUNCTION_TANH] = mpfi_tanh,
        [FUNCTION_SIN] = mpfi_sin,   [FUNCTION_COS] = mpfi_cos,
        [FUNCTION_TAN] = mpfi_tan,   [FUNCTION_ASIN] = mpfi_asin,
        [FUNCTION_ATAN] = mpfi_atan, [FUNCTION_ASINH] = mpfi_asinh,
        [FUNCTION_EM1] = mpfi_expm1, [FUNCTION_LN1P] = mpfi_log1p,
    };

    if (function == FUNCTION_ASINHEXP)
        asinh_exp(out, u);
    else if (function == FUNCTION_LAMBERT)
        lambert(out, u);
    else if (by[function])
        by[function](out, u);
    else
        return false;
    return true;
}

struct interval interval_function(enum formula_function function,
                                  struct interval u)
{
    struct interval out = { -HUGE_VAL, HUGE_VAL };
    mpfi_t w;

    mpfi_init2(w, LDBL_MANT_DIG);
    mpfr_set_ld(&w->left, u.lo, MPFR_RNDD);
    mpfr_set_ld(&w->right, u.hi, MPFR_RNDU);
    if (call(function, w, w) && !mpfi_nan_p(w))
        out = interval_of_mpfi(w);
    mpfi_clear(w);
    return out;
}

/* ---- nodes --------------------------------------------------------------- */

static mpfi_ptr value_of(const struct interval_graph *g, int node)
{
    return g->value[g->place[node]];
}

/* False: there is no rule. */
static bool make(struct interval_graph *g, int node)
{
    const struct formula_node *n = &g->f->node[node];
    mpfi_ptr out = value_of(g, node);

    switch (n->kind) {
        case FORMULA_LEAF:
            return true;
        case FORMULA_NUMBER:
            interval_graph_decimal(out, n->number);
            return true;
        case FORMULA_SUM:
            mpfi_add(out, value_of(g, n->of[0]), value_of(g, n->of[1]));
            return true;
        case FORMULA_TIMES:
            mpfi_mul(out, value_of(g, n->of[0]), value_of(g, n->of[1]));
            return true;
        case FORMULA_OVER:
            mpfi_div(out, value_of(g, n->of[0]), value_of(g, n->of[1]));
            return true;
        case FORMULA_CALL:
            if (n->function == FUNCTION_POWER) {
                power(out, value_of(g, n->of[0]), value_of(g, n->of[1]));
                return true;
            }
            return call(n->function, out, value_of(g, n->of[0]));
    }
    return false;
}

enum status interval_graph_run(struct interval_graph *g, struct fault *why)
{
    for (int i = 0; i < g->nodes; i++) {
        const struct formula_node *n = &g->f->node[g->node[i]];
        const char *name =
            n->kind == FORMULA_CALL ? functions[n->function].name : "a formula";
        const bool made = make(g, g->node[i]);
        if (made && mpfi_bounded_p(value_of(g, g->node[i])))
            continue;
        return fault_set(why, STATUS_BAD_ARGUMENT, "%s %s", name,
                         made ? "of a constant has no finite value"
                              : "has no rule for proofs");
    }
    return STATUS_OK;
}

/* ---- all ----------------------------------------------------------------- */

enum status interval_graph_init(struct interval_graph *g,
                                const struct formula *f, const bool needed[],
                                int bits)
{
    bool all[FORMULA_NODES];

    memcpy(all, needed, sizeof all);
    formula_complete(f, all);
    *g = (struct interval_graph){ .f = f };
    for (int i = 0; i < FORMULA_NODES; i++) {
        g->place[i] = -1;
        if (i < f->nodes && all[i] && !f->node[i].moves) {
            g->place[i] = (short) g->nodes;
            g->node[g->nodes++] = (short) i;
        }
    }
    g->value = malloc((size_t) (g->nodes + 1) * sizeof *g->value);
    if (g->value == NULL)
        return STATUS_NO_MEMORY;
    for (int i = 0; i < g->nodes; i++)
        mpfi_init2(g->value[i], bits);
    return STATUS_OK;
}

void interval_graph_free(struct interval_graph *g)
{
    for (int i = 0; g->value && i < g->nodes; i++)
        mpfi_clear(g->value[i]);
    free(g->value);
    g->value = NULL;
}

void interval_graph_set(struct interval_graph *g, const char *leaf,
                        mpfi_srcptr value)
{
    for (int i = 0; i < g->nodes; i++) {
        const struct formula_node *n = &g->f->node[g->node[i]];
        if (n->kind == FORMULA_LEAF && strcmp(n->name, leaf) == 0)
            mpfi_set(g->value[i], value);
    }
}

mpfi_srcptr interval_graph_value(const struct interval_graph *g, int node)
{
    return value_of(g, node);
}

struct interval interval_graph_get(const struct interval_graph *g, int node)
{
    return interval_of_mpfi(value_of(g, node));
}
