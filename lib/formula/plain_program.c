/* A graph as a list of operations, each once. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "plain_plane.h"

/* ---- building ------------------------------------------------------------ */

struct builder {
    struct plain_program *p;
    const struct formula_system *s;
    int at[FORMULA_NODES]; /* plus one; 0: not yet */
    const char *unknown;   /* a function without a rule */
};

static int add(struct plain_program *p, struct plain_op op)
{
    for (int i = 0; i < p->ops; i++) {
        const struct plain_op *q = &p->op[i];
        if (q->kind == op.kind && q->a == op.a &&
            (q->b == op.b || op.kind == PLAIN_CALL) &&
            q->function == op.function && q->number == op.number)
            return i;
    }
    if (p->ops == PLAIN_OPS ||
        p->ops + p->calls + (op.kind == PLAIN_CALL) >= JET_SLOTS - 8) {
        p->full = true;
        return 0;
    }
    p->calls += op.kind == PLAIN_CALL;
    p->op[p->ops] = op;
    return p->ops++;
}

static int number(struct plain_program *p, double x)
{
    return add(p, (struct plain_op){ .kind = PLAIN_NUMBER, .number = x });
}

static int arithmetic(struct plain_program *p, enum plain_kind kind, int a,
                      int b)
{
    return add(p, (struct plain_op){ .kind = kind, .a = a, .b = b });
}

static int one_and(struct plain_program *p, double sign, int u)
{
    return arithmetic(p, PLAIN_SUM, number(p, 1.0),
                      arithmetic(p, PLAIN_TIMES, number(p, sign),
                                 arithmetic(p, PLAIN_TIMES, u, u)));
}

static int call(struct plain_program *p, enum formula_function g, int u,
                double exponent);

static int over_root(struct plain_program *p, double sign, double by, int u)
{
    return arithmetic(p, PLAIN_OVER, number(p, by),
                      call(p, FUNCTION_SQRT, one_and(p, sign, u), 0.0));
}

static int over(struct plain_program *p, double by, int u)
{
    return arithmetic(p, PLAIN_OVER, number(p, by), u);
}

/* h of g' = h u'. */
static int slope_of(struct plain_program *p, enum formula_function f, int g,
                    int u, double exponent)
{
    switch (f) {
        case FUNCTION_EXP:
            return g;
        case FUNCTION_LN:
            return over(p, 1.0, u);
        case FUNCTION_SQRT:
            return over(p, 0.5, g);
        case FUNCTION_SINH:
            return call(p, FUNCTION_COSH, u, 0.0);
        case FUNCTION_COSH:
            return call(p, FUNCTION_SINH, u, 0.0);
        case FUNCTION_SIN:
            return call(p, FUNCTION_COS, u, 0.0);
        case FUNCTION_COS:
            return arithmetic(p, PLAIN_TIMES, number(p, -1.0),
                              call(p, FUNCTION_SIN, u, 0.0));
        case FUNCTION_TAN:
            return one_and(p, 1.0, g);
        case FUNCTION_TANH:
            return one_and(p, -1.0, g);
        case FUNCTION_ATAN:
            return over(p, 1.0, one_and(p, 1.0, u));
        case FUNCTION_ASINH:
            return over_root(p, 1.0, 1.0, u);
        case FUNCTION_ASIN:
            return over_root(p, -1.0, 1.0, u);
        case FUNCTION_POWER:
            return arithmetic(
                p, PLAIN_OVER,
                arithmetic(p, PLAIN_TIMES, number(p, exponent), g), u);
        default: /* Lambert's W of e^-u */
            return arithmetic(p, PLAIN_OVER,
                              arithmetic(p, PLAIN_TIMES, number(p, -1.0), g),
                              arithmetic(p, PLAIN_SUM, number(p, 1.0), g));
    }
}

static int call(struct plain_program *p, enum formula_function g, int u,
                double exponent)
{
    const int before = p->ops;
    const int i = add(p, (struct plain_op){ .kind = PLAIN_CALL,
                                            .function = g,
                                            .a = u,
                                            .b = -1,
                                            .number = exponent });

    if (i == before && !p->full) {
        const int h = slope_of(p, g, i, u, exponent);
        p->op[i].b = h;
    }
    return i;
}

static bool has_rule(enum formula_function f)
{
    static const enum formula_function known[] = {
        FUNCTION_EXP,   FUNCTION_LN,     FUNCTION_SQRT,  FUNCTION_SINH,
        FUNCTION_COSH,  FUNCTION_SIN,    FUNCTION_COS,   FUNCTION_TAN,
        FUNCTION_TANH,  FUNCTION_ATAN,   FUNCTION_ASINH, FUNCTION_ASIN,
        FUNCTION_POWER, FUNCTION_LAMBERT
    };

    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (known[i] == f)
            return true;
    return false;
}

static int place(struct builder *b, int node);

/* By squaring where the exponent is whole, for a base of any sign. */
static int power(struct builder *b, int base, double exponent)
{
    struct plain_program *p = b->p;
    const int u = place(b, base);
    const double size = fabs(exponent);

    if (!(size <= 64.0) || size != floor(size))
        return call(p, FUNCTION_POWER, u, exponent);
    int out = number(p, 1.0), square = u;
    bool first = true;
    for (int n = (int) size; n > 0; n /= 2) {
        if (n % 2) {
            out = first ? square : arithmetic(p, PLAIN_TIMES, out, square);
            first = false;
        }
        if (n > 1)
            square = arithmetic(p, PLAIN_TIMES, square, square);
    }
    return exponent < 0.0 ? over(p, 1.0, out) : out;
}

static double constant(struct builder *b, int node);

static int place_call(struct builder *b, const struct formula_node *n)
{
    if (!has_rule(n->function)) {
        b->unknown = functions[n->function].name;
        return 0;
    }
    if (n->function == FUNCTION_POWER && !b->s->graph.node[n->of[1]].moves)
        return power(b, n->of[0], constant(b, n->of[1]));
    if (n->function == FUNCTION_POWER) {
        b->unknown = "power";
        return 0;
    }
    return call(b->p, n->function, place(b, n->of[0]), 0.0);
}

static int place(struct builder *b, int node)
{
    const struct formula_node *n = &b->s->graph.node[node];
    int i = 0;

    if (b->at[node] > 0)
        return b->at[node] - 1;
    if (b->p->full || b->unknown)
        return 0;
    switch (n->kind) {
        case FORMULA_NUMBER:
            i = number(b->p, (double) n->number);
            break;
        case FORMULA_CALL:
            i = place_call(b, n);
            break;
        default: {
            const enum plain_kind kind = n->kind == FORMULA_SUM ? PLAIN_SUM
                                         : n->kind == FORMULA_TIMES
                                             ? PLAIN_TIMES
                                             : PLAIN_OVER;
            const int u = place(b, n->of[0]);
            i = arithmetic(b->p, kind, u, place(b, n->of[1]));
        }
    }
    b->at[node] = i + 1;
    return i;
}

/* Of a node that does not move. */
static double constant(struct builder *b, int node)
{
    double value[PLAIN_OPS];
    const int i = place(b, node);

    plain_values(b->p, (struct vec2){ 0.0, 0.0 }, value);
    return value[i];
}

static void place_leaves(struct builder *b)
{
    const struct formula_system *s = b->s;

    for (int i = 0; i < 2; i++) {
        const int z =
            add(b->p, (struct plain_op){ .kind = PLAIN_COORDINATE, .a = i });
        const bool positive = s->state[i].chart == CHART_POSITIVE;
        b->at[s->state[i].node] =
            (positive ? call(b->p, FUNCTION_EXP, z, 0.0) : z) + 1;
    }
    for (int i = 0; i < s->parameters; i++)
        b->at[s->parameter[i].node] =
            number(b->p, (double) s->parameter[i].value) + 1;
}

enum status plain_program(struct plain_program *p,
                          const struct formula_system *s, struct fault *why)
{
    struct builder b = { .p = p, .s = s };

    memset(p, 0, sizeof *p);
    place_leaves(&b);
    for (int i = 0; i < 2; i++) {
        const int rate = place(&b, s->rate[i]);
        p->rate[i] =
            s->state[i].chart == CHART_POSITIVE
                ? arithmetic(p, PLAIN_OVER, rate, b.at[s->state[i].node] - 1)
                : rate;
    }
    for (int i = 0; i < s->observables; i++)
        p->value[i] = place(&b, s->observable[i].node);
    if (!p->full && !b.unknown)
        return STATUS_OK;
    if (b.unknown)
        snprintf(why->text, sizeof why->text, "%s has no derivative here",
                 b.unknown);
    else
        snprintf(why->text, sizeof why->text,
                 "the formulas have more than %d operations", PLAIN_OPS);
    return STATUS_BAD_SCENE;
}
