/* Rates as mantissas and exponents. */
#include "tape.h"

#include <string.h>

#include "lower.h"

/* ---- rates --------------------------------------------------------------- */

/* mantissa exp(exponent + |u|): the last where there is a factor sinh u, that
 * of node `sinh` */
struct factors {
    struct linear mantissa, exponent;
    int sinh; /* -1: none */
};

static void split(struct lowering *L, int i, bool zero, struct factors *out);

/* i = other pos or other/pos; a constant stays with the mantissa unless it is
 * positive. */
static void split_product(struct lowering *L, int other, int pos, double sign,
                          bool zero, struct factors *out)
{
    const struct linear l = lower_log(L, pos);

    split(L, other, zero, out);
    linear_add_times(&L->s, &out->exponent, sign, &l);
}

/* zero: it is 0 at the anchor. */
static void split(struct lowering *L, int i, bool zero, struct factors *out)
{
    const struct formula_node n = L->s.f->node[i];
    const struct formula_node *a = &L->s.f->node[n.of[0]],
                              *b = &L->s.f->node[n.of[1]];

    *out = (struct factors){ .sinh = -1 };
    if (n.natural) {
        out->mantissa.constant = formula_number(L->s.f, 1);
        out->exponent = lower_log(L, i);
    } else if (n.kind == FORMULA_TIMES && !a->moves && !a->positive) {
        split(L, n.of[1], zero, out);
        out->mantissa = linear_times(&L->s, n.of[0], &out->mantissa);
    } else if (n.kind == FORMULA_TIMES && a->positive) {
        split_product(L, n.of[1], n.of[0], 1, zero, out);
    } else if (n.kind == FORMULA_TIMES && b->positive) {
        split_product(L, n.of[0], n.of[1], 1, zero, out);
    } else if (n.kind == FORMULA_OVER && b->positive) {
        split_product(L, n.of[0], n.of[1], -1, zero, out);
    } else if (n.kind == FORMULA_CALL && n.function == FUNCTION_SINH) {
        const struct linear u = lower_plain(L, n.of[0]);
        out->mantissa =
            linear_one(&L->s,
                       linear_step(&L->s, STEP_SINH, linear_reg(&L->s, &u), -1,
                                   u.constant, 0),
                       0);
        out->sinh = n.of[0];
    } else {
        out->mantissa = zero ? lower_zero(L, i) : lower_plain(L, i);
    }
}

static bool shares(const struct linear *u, const struct linear *w)
{
    for (int i = 0; i < u->terms; i++)
        for (int j = 0; j < w->terms; j++)
            if (u->term[i].reg == w->term[j].reg && u->term[i].reg >= 2)
                return true;
    return false;
}

/* e^|u| joins the exponent, as one with terms that it has in common: these may
 * be as large as 1e300 and cancel. */
static void join_sinh(struct lowering *L, int argument, struct tape_rate *r)
{
    struct linear u = lower_plain(L, argument), terms = u;
    int part[2];

    if (lower_apart(L, argument, false, part))
        terms = lower_both(L, argument);
    r->joined = shares(&r->exponent[0], &terms);
    if (r->joined)
        u = terms;
    linear_add_times(&L->s, &r->exponent[0], 1, &u);
    linear_add_times(&L->s, &r->exponent[1], -1, &u);
}

static bool may_be_large(const struct tape *t, const struct linear *u)
{
    for (int i = 0; i < u->terms; i++)
        if (tape_grows(t, u->term[i].reg))
            return true;
    return false;
}

/* A node as mantissa and exponent. */
static void lower_factors(struct lowering *L, const struct factors *s,
                          bool zero, struct tape_rate *r)
{
    *r = (struct tape_rate){ .mantissa = s->mantissa,
                             .exponent = { s->exponent, s->exponent },
                             .sinh = -1,
                             .scaled = -1 };
    if (zero)
        r->mantissa.constant = 0;
    if (s->sinh >= 0) {
        r->sinh = s->mantissa.term[0].reg;
        join_sinh(L, s->sinh, r);
    } else if (may_be_large(L->s.t, &r->mantissa)) {
        r->scaled = linear_scaled(&L->s, &r->mantissa);
        r->mantissa = linear_one(&L->s, r->scaled, 0);
    }
    for (int k = 0; k < TAPE_NEAR; k++) {
        r->exponent[k + TAPE_NEAR] = r->exponent[k];
        r->exponent[k] = linear_grown(&L->s, &r->exponent[k]);
    }
}

static void lower_rate(struct lowering *L, int i)
{
    const int state = L->p->state[i];
    struct factors s;

    split(L, L->p->rate[i], L->p->zero[i], &s);
    if (L->s.f->node[state].positive) { /* d ln v/dt = (dv/dt)/v */
        const struct linear l = lower_log(L, state);
        linear_add_times(&L->s, &s.exponent, -1, &l);
    }
    lower_factors(L, &s, L->p->zero[i], &L->s.t->rate[i]);
}

/* A value times something positive: its own form is the mantissa, for ln of a
 * value that is small beside that of the anchor has no digits. */
static bool split_value(struct lowering *L, int i, struct factors *out)
{
    const struct formula_node n = L->s.f->node[i];

    for (int k = 0; k < 2 && n.kind == FORMULA_TIMES && L->p->values; k++)
        if (n.of[k] == L->p->value[0] && L->s.f->node[n.of[1 - k]].positive) {
            *out = (struct factors){ .sinh = -1 };
            out->mantissa = lower_plain(L, n.of[k]);
            out->exponent = lower_log(L, n.of[1 - k]);
            return true;
        }
    return false;
}

static void lower_observable(struct lowering *L, int i)
{
    struct factors s;

    if (!split_value(L, L->p->observable[i], &s))
        split(L, L->p->observable[i], false, &s);
    lower_factors(L, &s, false, &L->s.t->rate[2 + i]);
}

/* ---- constants ----------------------------------------------------------- */

static void need_linear(struct tape *t, const struct linear *u)
{
    t->needs[u->constant] = true;
    for (int i = 0; i < u->terms; i++)
        t->needs[u->term[i].c] = true;
}

static void find_needs(struct tape *t, const struct formula *f)
{
    memset(t->needs, 0, sizeof t->needs);
    for (int i = 0; i < t->steps; i++) {
        need_linear(t, &t->step[i].form);
        t->needs[t->step[i].k] = t->needs[t->step[i].q] = true;
    }
    for (int i = 0; i < t->rates; i++) {
        need_linear(t, &t->rate[i].mantissa);
        for (int k = 0; k < TAPE_EXPONENTS; k++)
            need_linear(t, &t->rate[i].exponent[k]);
    }
    for (int i = 0; i < TAPE_VALUES; i++)
        need_linear(t, &t->value[i]);
    formula_complete(f, t->needs);
}

/* ---- all ----------------------------------------------------------------- */

static enum status answer(const struct lowering *L, struct fault *why)
{
    if (!L->s.failed && !L->s.f->full)
        return STATUS_OK;
    return fault_set(why, STATUS_BAD_ARGUMENT, "the formula cannot be used: %s",
                     L->s.failed ? L->s.failed : "it has too many parts");
}

enum status tape_lower(struct tape *t, struct formula *f,
                       const struct plane_formulas *p, struct fault *why)
{
    struct lowering L;

    lower_start(&L, f, t, p);
    for (int i = 0; i < 2; i++)
        lower_rate(&L, i);
    for (int i = 0; i < p->observables; i++)
        lower_observable(&L, i);
    t->rates = 2 + p->observables;
    for (int i = 0; i < TAPE_VALUES; i++)
        t->value[i] =
            i < p->values ? lower_plain(&L, p->value[i]) : linear_constant(0);
    find_needs(t, f);
    return answer(&L, why);
}

enum status tape_anchor(struct formula *f, struct plane_formulas *p, int i,
                        int node, struct fault *why)
{
    struct lowering L;
    struct tape t;

    lower_start(&L, f, &t, p);
    p->at[i] = node;
    p->chart[i] =
        f->node[p->state[i]].positive ? lower_log(&L, node).constant : node;
    return answer(&L, why);
}

/* ---- which registers are needed -------------------------------------------
 */

void tape_need_linear(const struct linear *u, bool needed[])
{
    for (int i = 0; i < u->terms; i++)
        needed[u->term[i].reg] = true;
}

void tape_need_rate(const struct tape_rate *r, bool needed[])
{
    tape_need_linear(&r->mantissa, needed);
    for (int k = 0; k < TAPE_EXPONENTS; k++)
        tape_need_linear(&r->exponent[k], needed);
    if (r->sinh >= 0)
        needed[r->sinh] = true;
    if (r->scaled >= 0)
        needed[r->scaled] = true;
}

/* Users come after what they use. */
void tape_need_parts(const struct tape *t, bool needed[])
{
    for (int i = t->steps; i-- > 0;) {
        const struct step *s = &t->step[i];
        if (!needed[i + 2])
            continue;
        if (s->a >= 0)
            needed[s->a] = true;
        if (s->b >= 0)
            needed[s->b] = true;
        if (s->kind == STEP_LINEAR || s->kind == STEP_SCALED)
            tape_need_linear(&s->form, needed);
    }
}
