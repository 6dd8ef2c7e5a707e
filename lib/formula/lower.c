/* From formulas to differences.  Every node is asked for its linear form, of
 * itself or of its logarithm; each answer is made once. */
#include "lower.h"

#include <stdio.h>
#include <string.h>

static int value_of(struct lowering *L, int i);
static struct linear whole(struct lowering *L, int i);

/* ---- logarithms ---------------------------------------------------------- */

/* ln(1/4) is -ln 4. */
static int ln(struct lowering *L, int node)
{
    struct formula *f = L->s.f;
    const struct formula_node *n = &f->node[node];
    const formula_real turned = n->number > 0 ? 1 / n->number : 0;

    if (turned > 1 && turned >= (double) turned && turned <= (double) turned)
        return formula_less(
            f, 0, formula_of(f, FUNCTION_LN, formula_number(f, turned)));
    return formula_of(f, FUNCTION_LN, node);
}

/* ln(p + q), p rather a product: ln q + ln(p/q + 1) but for constants q */
static struct linear log_of_sum(struct lowering *L, int i, int p, int q)
{
    struct formula *f = L->s.f;
    struct linear u = lower_log(L, p), w = { 0 };

    if (f->node[q].moves) {
        w = lower_log(L, q);
        linear_add_times(&L->s, &u, -1, &w);
    }
    const int sum = value_of(L, i);
    const struct linear mixed = linear_function(
        &L->s, STEP_MIXED, &u, formula_over(f, value_of(L, p), sum),
        formula_over(f, value_of(L, q), sum), 0);
    linear_add_times(&L->s, &w, 1, &mixed);
    w.constant = formula_of(f, FUNCTION_LN, sum);
    return w;
}

static struct linear log_by_plain(struct lowering *L, int i)
{
    const struct linear u = whole(L, i);

    return linear_function(&L->s, STEP_LN1P, &u, u.constant, 0,
                           ln(L, u.constant));
}

static struct linear log_of_call(struct lowering *L, int i,
                                 const struct formula_node *n)
{
    if (n->function == FUNCTION_EXP)
        return lower_plain(L, n->of[0]);
    if (n->function != FUNCTION_SQRT && n->function != FUNCTION_POWER)
        return n->moves ? log_by_plain(L, i) : linear_constant(ln(L, i));
    const struct linear u = lower_log(L, n->of[0]);
    return linear_times(&L->s,
                        n->function == FUNCTION_SQRT
                            ? formula_over(L->s.f, formula_number(L->s.f, 1),
                                           formula_number(L->s.f, 2))
                            : n->of[1],
                        &u);
}

static struct linear make_log(struct lowering *L, int i)
{
    const struct formula_node n = L->s.f->node[i];
    struct linear u, w;
    int q;

    switch (n.kind) {
        case FORMULA_LEAF:
            for (int k = 0; k < 2 && n.positive; k++)
                if (L->p->state[k] == i)
                    return linear_one(&L->s, k, L->p->chart[k]);
            return n.moves ? log_by_plain(L, i) : linear_constant(ln(L, i));
        case FORMULA_TIMES:
        case FORMULA_OVER:
            if (!L->s.f->node[n.of[0]].positive ||
                !L->s.f->node[n.of[1]].positive)
                return log_by_plain(L, i);
            u = lower_log(L, n.of[0]);
            w = lower_log(L, n.of[1]);
            linear_add_times(&L->s, &u, n.kind == FORMULA_TIMES ? 1 : -1, &w);
            return u;
        case FORMULA_SUM:
            if (!formula_has_log(L->s.f, i))
                return log_by_plain(L, i);
            q = formula_has_log(L->s.f, n.of[0]);
            return log_of_sum(L, i, n.of[!q], n.of[q]);
        case FORMULA_CALL:
            return log_of_call(L, i, &n);
        default:
            return linear_constant(ln(L, i));
    }
}

/* ---- themselves ---------------------------------------------------------- */

/* e^u, at the anchor `value`, which gains nothing where u is another there. */
static struct linear grown(struct lowering *L, const struct linear *u,
                           int value)
{
    const struct linear far = linear_grown(&L->s, u);
    const int k = linear_rests(&L->s, u) ? value : 0;

    if (u->terms == 0)
        return linear_constant(value);
    const int b = far.constant == u->constant ? -1 : linear_value(&L->s, &far);
    return linear_one(&L->s,
                      linear_step(&L->s, STEP_GROWTH, linear_reg(&L->s, u), b,
                                  k, u->constant),
                      k);
}

static struct linear growth(struct lowering *L, int i)
{
    const struct linear u = lower_log(L, i);

    return grown(L, &u, value_of(L, i));
}

/* zero: both parts are the same at the anchor, whatever rounding makes of
 * their logarithms there. */
static struct linear apart(struct lowering *L, const int part[2], bool zero)
{
    const struct linear u = lower_log(L, part[0]), w = lower_log(L, part[1]);
    const int q = zero ? 0 : formula_less(L->s.f, w.constant, u.constant);

    return linear_one(&L->s,
                      linear_step(&L->s, STEP_APART, linear_reg(&L->s, &u),
                                  linear_reg(&L->s, &w), value_of(L, part[0]),
                                  q),
                      0);
}

bool lower_apart(struct lowering *L, int i, bool zero, int part[2])
{
    const struct formula_node *n = L->s.f->node;
    bool all = n[i].kind == FORMULA_SUM && !n[i].positive;

    part[0] = part[1] = 0;
    if (all)
        formula_sort(L->s.f, i, 1, part);
    for (int k = 0; k < 2 && all; k++)
        all = formula_has_log(L->s.f, part[k]) ||
              (zero && part[k] && n[part[k]].positive && !n[part[k]].moves);
    return all;
}

struct linear lower_both(struct lowering *L, int i)
{
    const struct formula_node n = L->s.f->node[i];
    struct linear u = lower_plain(L, n.of[0]);
    const struct linear w = lower_plain(L, n.of[1]);

    linear_add_times(&L->s, &u, 1, &w);
    return u;
}

static struct linear plain_sum(struct lowering *L, int i)
{
    int part[2];

    return lower_apart(L, i, false, part) ? apart(L, part, false)
                                          : lower_both(L, i);
}

/* a asinh(e^w/2), e^w/2 positive by its form */
static struct linear plain_asinh(struct lowering *L, int argument)
{
    struct formula *f = L->s.f;
    struct linear u = lower_log(L, argument);
    u.constant = formula_sum(f, u.constant,
                             formula_of(f, FUNCTION_LN, formula_number(f, 2)));
    return linear_function(&L->s, STEP_FRICTION, &u, u.constant, 0,
                           formula_of(f, FUNCTION_ASINHEXP, u.constant));
}

/* sinh u0 + e^u0/2 (e^du - 1) - e^-u0/2 (e^-du - 1) */
static struct linear sinh_of(struct lowering *L, const struct linear *u)
{
    struct formula *f = L->s.f;
    struct linear w = { 0 };
    const int half = formula_of(f, FUNCTION_LN, formula_number(f, 2));
    struct linear out =
        linear_constant(formula_of(f, FUNCTION_SINH, u->constant));

    for (int sign = 1; sign >= -1; sign -= 2) {
        w = linear_times(&L->s, formula_number(f, sign), u);
        const int q = formula_less(f, w.constant, half);
        const struct linear part = linear_function(
            &L->s, STEP_GROWTH, &w,
            formula_over(f, formula_of(f, FUNCTION_EXP, w.constant),
                         formula_number(f, 2)),
            q, 0);
        linear_add_times(&L->s, &out, sign, &part);
    }
    return out;
}

/* Whether the plain form has differences of two products in it, whose constant
 * is 0 whatever they are at the anchor. */
static bool is_away(struct lowering *L, int i)
{
    const struct formula_node n = L->s.f->node[i];
    bool away = false;
    int part[2];

    if (!n.moves || n.kind == FORMULA_LEAF)
        return false;
    if (L->away[i])
        return L->away[i] > 1;
    const bool logs = n.kind == FORMULA_CALL && n.function == FUNCTION_LN &&
                      !L->s.f->node[n.of[0]].natural; /* of the whole */
    for (int k = 0; !logs && k < (n.kind == FORMULA_CALL ? n.arguments : 2);
         k++)
        away = is_away(L, n.of[k]) || away;
    away = away || lower_apart(L, i, false, part);
    L->away[i] = away ? 2 : 1;
    return away;
}

/* As lower_plain, of what is multiplied or called with: a constant that is not
 * the value at the anchor is not taken apart from the rest, with which it may
 * all but vanish. */
static struct linear factor(struct lowering *L, int i)
{
    const struct linear u = lower_plain(L, i);

    return u.constant && is_away(L, i)
               ? linear_one(&L->s, linear_value(&L->s, &u), 0)
               : u;
}

/* By the parser a number; 0: it is no such power. */
static int whole_exponent(const struct lowering *L,
                          const struct formula_node *n)
{
    if (n->kind != FORMULA_CALL || n->function != FUNCTION_POWER ||
        L->s.f->node[n->of[1]].kind != FORMULA_NUMBER)
        return 0;
    const formula_real p = L->s.f->node[n->of[1]].number;
    return p > 1 && p < FORMULA_WHOLE && (formula_real) (int) p >= p ? (int) p
                                                                     : 0;
}

static struct linear plain_power(struct lowering *L, int i,
                                 const struct formula_node *n)
{
    const int p = whole_exponent(L, n);

    if (!p)
        return growth(L, i);
    const struct linear u = factor(L, n->of[0]);
    return linear_power(&L->s, &u, p);
}

/* f(u0 + du) - f(u0) by a step of its own; 0: it has none */
static const enum step_kind step_of[FUNCTIONS] = {
    [FUNCTION_SIN] = STEP_SIN,   [FUNCTION_COS] = STEP_SIN,
    [FUNCTION_COSH] = STEP_COSH, [FUNCTION_TAN] = STEP_TAN,
    [FUNCTION_TANH] = STEP_TANH, [FUNCTION_ASIN] = STEP_ASIN,
    [FUNCTION_ATAN] = STEP_ATAN, [FUNCTION_ASINH] = STEP_ASINH,
};

/* Of the sine and the cosine: value and slope at u0. */
static struct linear by_step(struct lowering *L, enum formula_function function,
                             const struct linear *u)
{
    struct formula *f = L->s.f;
    const int there = formula_of(f, function, u->constant);

    if (function == FUNCTION_SIN)
        return linear_function(&L->s, STEP_SIN, u, there,
                               formula_of(f, FUNCTION_COS, u->constant), there);
    if (function == FUNCTION_COS)
        return linear_function(
            &L->s, STEP_SIN, u, there,
            formula_less(f, 0, formula_of(f, FUNCTION_SIN, u->constant)),
            there);
    return linear_function(&L->s, step_of[function], u, u->constant, 0, there);
}

static struct linear plain_call(struct lowering *L, int i,
                                const struct formula_node *n)
{
    struct linear u;

    switch (n->function) {
        case FUNCTION_LN:
            return lower_log(L, n->of[0]);
        case FUNCTION_SINH:
            u = lower_plain(L, n->of[0]);
            return sinh_of(L, &u);
        case FUNCTION_POWER:
            return plain_power(L, i, n);
        case FUNCTION_EXP:
        case FUNCTION_SQRT:
            return growth(L, i);
        default:
            break;
    }
    if (n->function == FUNCTION_ASINH && L->s.f->node[n->of[0]].natural)
        return plain_asinh(L, n->of[0]);
    if (!step_of[n->function])
        return linear_fail(&L->s, "lambert is for parameters only");
    u = factor(L, n->of[0]);
    return by_step(L, n->function, &u);
}

static struct linear make_plain(struct lowering *L, int i)
{
    const struct formula_node n = L->s.f->node[i];
    struct linear u, w;

    if (!n.moves)
        return linear_constant(i);
    if (n.natural)
        return growth(L, i);
    switch (n.kind) {
        case FORMULA_LEAF:
            for (int k = 0; k < 2; k++)
                if (L->p->state[k] == i)
                    return linear_one(&L->s, k, L->p->at[k]);
            return linear_fail(&L->s, "a state is not of this plane");
        case FORMULA_SUM:
            return plain_sum(L, i);
        case FORMULA_TIMES:
        case FORMULA_OVER:
            u = factor(L, n.of[0]);
            w = n.kind == FORMULA_TIMES ? factor(L, n.of[1])
                                        : whole(L, n.of[1]);
            return n.kind == FORMULA_TIMES ? linear_product(&L->s, &u, &w)
                                           : linear_quotient(&L->s, &u, &w);
        default:
            return plain_call(L, i, &n);
    }
}

/* As lower_plain, but that the constant is the value at the anchor: of such
 * differences both parts. */
static struct linear make_whole(struct lowering *L, int i)
{
    const struct formula_node n = L->s.f->node[i];
    const int p = whole_exponent(L, &n);

    if (n.kind == FORMULA_CALL && !step_of[n.function] && !p &&
        n.function != FUNCTION_EXP && n.function != FUNCTION_SINH)
        return lower_plain(L, i);
    struct linear u = whole(L, n.of[0]);
    if (p)
        return linear_power(&L->s, &u, p);
    if (n.kind == FORMULA_CALL && n.function == FUNCTION_SINH)
        return sinh_of(L, &u);
    if (n.kind == FORMULA_CALL && n.function == FUNCTION_EXP)
        return grown(L, &u, formula_of(L->s.f, FUNCTION_EXP, u.constant));
    if (n.kind == FORMULA_CALL)
        return by_step(L, n.function, &u);
    const struct linear w = whole(L, n.of[1]);
    if (n.kind == FORMULA_TIMES)
        return linear_product(&L->s, &u, &w);
    if (n.kind == FORMULA_OVER)
        return linear_quotient(&L->s, &u, &w);
    linear_add_times(&L->s, &u, 1, &w);
    return u;
}

/* ---- made once ----------------------------------------------------------- */

/* A register that is a named node, and a constant that is its value, may use
 * the name. */
static void name_after(struct lowering *L, const char *name,
                       const struct linear *u, bool logarithm)
{
    char own[FORMULA_NAME + 4];

    snprintf(own, sizeof own, "%s%s0", logarithm ? "ln" : "", name);
    if (!formula_is_plain(L->s.f, u->constant))
        formula_name(L->s.f, u->constant, own);
    if (u->terms != 1 || u->term[0].reg < 2 ||
        !formula_is(L->s.f, u->term[0].c, 1.0))
        return;
    struct step *s = &L->s.t->step[u->term[0].reg - 2];
    snprintf(own, sizeof own, "%s%s", logarithm ? "dln" : "d", name);
    if (!s->name[0] && strlen(own) < sizeof s->name)
        strcpy(s->name, own);
}

static void name_definitions(struct lowering *L, int i, const struct linear *u,
                             bool logarithm)
{
    for (int k = 0; k < L->s.f->definitions && L->s.f->node[i].moves; k++)
        if (L->s.f->definition[k].node == i)
            name_after(L, L->s.f->definition[k].name, u, logarithm);
}

static struct linear once(struct lowering *L, short *place, int i,
                          struct linear (*make)(struct lowering *L, int i),
                          bool logarithm)
{
    if (*place)
        return L->form[*place - 1];
    if (L->s.failed)
        return linear_constant(0);
    const struct linear u = make(L, i);
    if (L->s.failed || L->s.f->full || L->forms == LOWER_FORMS)
        return linear_fail(&L->s, "it has too many parts");
    name_definitions(L, i, &u, logarithm);
    L->form[L->forms++] = u;
    *place = (short) L->forms;
    return u;
}

struct linear lower_plain(struct lowering *L, int i)
{
    return once(L, &L->plain[i], i, make_plain, false);
}

struct linear lower_log(struct lowering *L, int i)
{
    return once(L, &L->log[i], i, make_log, true);
}

static struct linear whole(struct lowering *L, int i)
{
    const struct linear plain = lower_plain(L, i);

    return is_away(L, i) ? once(L, &L->whole[i], i, make_whole, false) : plain;
}

struct linear lower_zero(struct lowering *L, int i)
{
    const struct linear plain = lower_plain(L, i);
    int part[2];

    if (linear_rests(&L->s, &plain))
        return plain;
    return lower_apart(L, i, true, part) ? apart(L, part, true) : whole(L, i);
}

static int value_of_call(struct lowering *L, int i,
                         const struct formula_node *n)
{
    struct formula *f = L->s.f;

    switch (n->function) {
        case FUNCTION_POWER:
            return formula_call(f, FUNCTION_POWER,
                                (int[]){ value_of(L, n->of[0]), n->of[1] });
        case FUNCTION_SQRT:
            return formula_of(f, FUNCTION_SQRT, value_of(L, n->of[0]));
        case FUNCTION_EXP:
            return formula_of(f, FUNCTION_EXP,
                              lower_plain(L, n->of[0]).constant);
        default:
            return whole(L, i).constant;
    }
}

static int make_value(struct lowering *L, int i)
{
    const struct formula_node n = L->s.f->node[i];
    struct formula *f = L->s.f;

    if (n.moves && n.kind == FORMULA_CALL)
        return value_of_call(L, i, &n);
    if (!n.moves || !n.positive)
        return whole(L, i).constant;
    switch (n.kind) {
        case FORMULA_LEAF:
            return L->p->at[i == L->p->state[1]];
        case FORMULA_SUM:
            return formula_sum(f, value_of(L, n.of[0]), value_of(L, n.of[1]));
        case FORMULA_TIMES:
            return formula_times(f, value_of(L, n.of[0]), value_of(L, n.of[1]));
        default:
            return formula_over(f, value_of(L, n.of[0]), value_of(L, n.of[1]));
    }
}

static int value_of(struct lowering *L, int i)
{
    if (!L->value[i] && !L->s.failed)
        L->value[i] = (short) (make_value(L, i) + 1);
    return L->value[i] ? L->value[i] - 1 : 0;
}

void lower_start(struct lowering *L, struct formula *f, struct tape *t,
                 const struct plane_formulas *p)
{
    memset(L, 0, sizeof *L);
    L->s = (struct forms){ .f = f, .t = t };
    L->p = p;
    t->steps = 0;
}
