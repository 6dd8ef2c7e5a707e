#include "formula.h"

#include <string.h>
#include <strings.h>

enum { FUEL = 60 }; /* sums and products that a search takes apart */

/* ---- nodes --------------------------------------------------------------- */

static bool is_same(const struct formula_node *a, const struct formula_node *b)
{
    if (a->kind != b->kind || a->arguments != b->arguments ||
        memcmp(a->of, b->of, sizeof a->of) != 0)
        return false;
    switch (a->kind) {
        case FORMULA_NUMBER:
            return a->number >= b->number && a->number <= b->number;
        case FORMULA_LEAF:
            return strcmp(a->name, b->name) == 0;
        default:
            return a->kind != FORMULA_CALL || a->function == b->function;
    }
}

static int add(struct formula *f, const struct formula_node *n)
{
    for (int i = 0; i < f->nodes; i++)
        if (is_same(&f->node[i], n))
            return i;
    if (f->nodes == FORMULA_NODES) {
        f->full = true;
        return 0;
    }
    f->node[f->nodes] = *n;
    return f->nodes++;
}

void formula_init(struct formula *f)
{
    f->nodes = f->definitions = 0;
    f->full = false;
    formula_number(f, 0);
}

int formula_number(struct formula *f, formula_real number)
{
    const struct formula_node n = { .kind = FORMULA_NUMBER,
                                    .number = number,
                                    .positive = number > 0 };
    return add(f, &n);
}

int formula_leaf(struct formula *f, const char *name, enum formula_leaf leaf)
{
    struct formula_node n = { .kind = FORMULA_LEAF, .leaf = leaf };

    strncpy(n.name, name, sizeof n.name - 1);
    n.moves = leaf == FORMULA_STATE || leaf == FORMULA_POSITIVE_STATE;
    n.positive =
        leaf == FORMULA_POSITIVE_PARAMETER || leaf == FORMULA_POSITIVE_STATE;
    n.natural = leaf == FORMULA_POSITIVE_STATE;
    return add(f, &n);
}

/* A function that is positive whatever its argument is, or if that is. */
static bool call_is_positive(const struct formula_node *n, bool argument)
{
    switch (n->function) {
        case FUNCTION_EXP:
        case FUNCTION_COSH:
        case FUNCTION_LAMBERT:
            return true;
        case FUNCTION_SQRT:
        case FUNCTION_SINH:
        case FUNCTION_TANH:
        case FUNCTION_ASIN:
        case FUNCTION_ATAN:
        case FUNCTION_ASINH:
        case FUNCTION_ASINHEXP:
        case FUNCTION_POWER:
            return argument;
        default:
            return false;
    }
}

/* Sets what a node is by its form. */
static int join(struct formula *f, struct formula_node *n)
{
    bool positive = true, natural = false;

    for (int i = 0; i < n->arguments; i++) {
        const struct formula_node *u = &f->node[n->of[i]];
        n->moves = n->moves || u->moves;
        positive = positive && (u->positive || (n->kind == FORMULA_CALL && i));
        natural = natural || u->natural;
    }
    n->positive =
        n->kind == FORMULA_CALL ? call_is_positive(n, positive) : positive;
    if (n->kind == FORMULA_TIMES && n->of[0] == n->of[1])
        n->positive = n->positive || !n->moves;
    n->natural =
        n->positive && n->moves &&
        (n->kind == FORMULA_OVER || (n->kind == FORMULA_TIMES && natural) ||
         (n->kind == FORMULA_CALL &&
          (n->function == FUNCTION_EXP || n->function == FUNCTION_SQRT ||
           n->function == FUNCTION_POWER)));
    return add(f, n);
}

static int pair(struct formula *f, enum formula_kind kind, int u, int w)
{
    struct formula_node n = { .kind = kind, .of = { u, w }, .arguments = 2 };

    return join(f, &n);
}

static bool is_number(const struct formula *f, int u)
{
    return f->node[u].kind == FORMULA_NUMBER;
}

bool formula_is(const struct formula *f, int u, double number)
{
    const formula_real found = f->node[u].number;

    return is_number(f, u) && found >= number && found <= number;
}

void formula_know(struct formula *f, int leaf, formula_real value)
{
    f->node[leaf].known = true;
    f->node[leaf].number = value;
}

/* Of numbers, known leaves and their sums, products and quotients. */
static bool value_of(struct formula *f, int u, int *fuel, formula_real *value)
{
    struct formula_node *n = &f->node[u];
    formula_real a, b;

    if (n->kind == FORMULA_NUMBER || n->kind == FORMULA_LEAF) {
        n->exponent = n->kind == FORMULA_LEAF;
        *value = n->number;
        return n->kind == FORMULA_NUMBER || n->known;
    }
    if (n->kind == FORMULA_CALL || --*fuel < 0 ||
        !value_of(f, n->of[0], fuel, &a) || !value_of(f, n->of[1], fuel, &b))
        return false;
    *value = n->kind == FORMULA_SUM     ? a + b
             : n->kind == FORMULA_TIMES ? a * b
                                        : a / b;
    return true;
}

bool formula_whole(struct formula *f, int u, int *p)
{
    formula_real value;
    int fuel = FUEL;

    if (!value_of(f, u, &fuel, &value) ||
        !(value > -FORMULA_WHOLE && value < FORMULA_WHOLE))
        return false;
    *p = (int) value;
    return *p >= value && *p <= value;
}

formula_real formula_factor(const struct formula *f, int u, int *rest)
{
    const struct formula_node *n = &f->node[u];

    *rest = u;
    if (n->kind != FORMULA_TIMES || !is_number(f, n->of[0]))
        return 1;
    *rest = n->of[1];
    return f->node[n->of[0]].number;
}

/* ---- sums ---------------------------------------------------------------- */

static int scaled(struct formula *f, formula_real c, int u)
{
    return formula_times(f, formula_number(f, c), u);
}

/* u + c t where the sum u has a term in t, which changes; `fuel` bounds the
 * search. */
static bool absorb(struct formula *f, int u, formula_real c, int t, int *fuel,
                   int *out)
{
    int rest;
    const formula_real found = formula_factor(f, u, &rest);

    if (rest == t) {
        *out = scaled(f, found + c, t);
        return true;
    }
    if (f->node[rest].kind != FORMULA_SUM || --*fuel < 0 ||
        !(found == 1 || found == -1)) /* others are not exact */
        return false;
    const int a = f->node[rest].of[0], b = f->node[rest].of[1];
    if (absorb(f, b, found * c, t, fuel, out))
        *out = formula_sum(f, a, *out);
    else if (absorb(f, a, found * c, t, fuel, out))
        *out = formula_sum(f, *out, b);
    else
        return false;
    *out = scaled(f, found, *out);
    return true;
}

/* u + w where they have terms in common. */
static bool meet(struct formula *f, int u, int w, int *fuel, int *out)
{
    int t;
    const formula_real c = formula_factor(f, w, &t);

    if (absorb(f, u, c, t, fuel, out))
        return true;
    if (f->node[t].kind != FORMULA_SUM || --*fuel < 0)
        return false;
    const int a = f->node[t].of[0], b = f->node[t].of[1];
    if (meet(f, u, scaled(f, c, b), fuel, out)) {
        *out = formula_sum(f, *out, scaled(f, c, a));
        return true;
    }
    if (meet(f, u, scaled(f, c, a), fuel, out)) {
        *out = formula_sum(f, *out, scaled(f, c, b));
        return true;
    }
    return false;
}

int formula_sum(struct formula *f, int u, int w)
{
    int fuel = FUEL, out;

    if (formula_is(f, u, 0.0))
        return w;
    if (formula_is(f, w, 0.0))
        return u;
    if (is_number(f, u) && is_number(f, w))
        return formula_number(f, f->node[u].number + f->node[w].number);
    if (!is_number(f, u) && !is_number(f, w) && meet(f, u, w, &fuel, &out))
        return out;
    if (formula_factor(f, u, &out) < 0 && formula_factor(f, w, &out) > 0)
        return pair(f, FORMULA_SUM, w, u); /* w - |u| */
    return pair(f, FORMULA_SUM, u, w);
}

void formula_sort(struct formula *f, int u, formula_real sign, int part[2])
{
    int rest;
    const formula_real c = sign * formula_factor(f, u, &rest);
    const struct formula_node n = f->node[rest];

    if (n.kind == FORMULA_SUM && c * c >= 1 && c * c <= 1) {
        formula_sort(f, n.of[0], c, part);
        formula_sort(f, n.of[1], c, part);
    } else {
        const int term = scaled(f, c < 0 ? -c : c, rest);
        part[c < 0] = formula_sum(f, part[c < 0], term);
    }
}

bool formula_has_log(const struct formula *f, int u)
{
    const struct formula_node *n = &f->node[u];

    return n->natural ||
           (n->kind == FORMULA_SUM && n->positive && n->moves &&
            (formula_has_log(f, n->of[0]) || formula_has_log(f, n->of[1])));
}

int formula_less(struct formula *f, int u, int w)
{
    return formula_sum(f, u, scaled(f, -1, w));
}

/* ---- products ------------------------------------------------------------ */

/* Numbers go first. */
int formula_times(struct formula *f, int u, int w)
{
    int a, b;

    if (formula_is(f, u, 0.0) || formula_is(f, w, 1.0))
        return u;
    if (formula_is(f, w, 0.0) || formula_is(f, u, 1.0))
        return w;
    if (is_number(f, u) && is_number(f, w))
        return formula_number(f, f->node[u].number * f->node[w].number);
    if (is_number(f, w))
        return formula_times(f, w, u);
    const formula_real c = formula_factor(f, u, &a),
                       d = formula_factor(f, w, &b);
    if (is_number(f, u) && b != w)
        return scaled(f, f->node[u].number * d, b);
    if (!is_number(f, u) && (a != u || b != w))
        return scaled(f, c * d, formula_times(f, a, b));
    return pair(f, FORMULA_TIMES, u, w);
}

/* Halves, quarters, ...: their reciprocal is exact. */
static bool is_power_of_two(formula_real x)
{
    for (int i = 0; i < 60 && x > 1; i++)
        x /= 2;
    return x >= 1 && x <= 1;
}

int formula_over(struct formula *f, int u, int w)
{
    int a, b;

    if (formula_is(f, u, 0.0) || formula_is(f, w, 1.0))
        return u;
    if (u == w)
        return formula_number(f, 1);
    if (is_number(f, w) && is_power_of_two(f->node[w].number))
        return scaled(f, 1 / f->node[w].number, u);
    const formula_real c = formula_factor(f, u, &a),
                       d = formula_factor(f, w, &b);
    if (a != u)
        return scaled(f, c, formula_over(f, a, w));
    if (is_number(f, u) && !is_number(f, w) && !formula_is(f, u, 1.0))
        return formula_times(f, u, formula_over(f, formula_number(f, 1), w));
    if (b != w && d >= -1 && d <= -1)
        return scaled(f, d, formula_over(f, u, b));
    return pair(f, FORMULA_OVER, u, w);
}

/* ---- functions ----------------------------------------------------------- */

int formula_call(struct formula *f, enum formula_function function,
                 const int of[])
{
    struct formula_node n = { .kind = FORMULA_CALL, .function = function };

    n.arguments = function_arguments(function);
    memcpy(n.of, of, (size_t) n.arguments * sizeof *of);
    return join(f, &n);
}

static bool calls(const struct formula *f, int u, enum formula_function which)
{
    return f->node[u].kind == FORMULA_CALL && f->node[u].function == which;
}

/* f(0) as it is, in *value. */
static bool is_known_at_zero(enum formula_function function, double *value)
{
    switch (function) {
        case FUNCTION_EXP:
        case FUNCTION_COS:
        case FUNCTION_COSH:
            *value = 1.0;
            return true;
        case FUNCTION_SIN:
        case FUNCTION_TAN:
        case FUNCTION_SINH:
        case FUNCTION_TANH:
        case FUNCTION_ASIN:
        case FUNCTION_ATAN:
        case FUNCTION_ASINH:
            *value = 0.0;
            return true;
        default:
            return false;
    }
}

int formula_of(struct formula *f, enum formula_function function, int u)
{
    int rest;
    const formula_real c = formula_factor(f, u, &rest);
    double value;

    if (formula_is(f, u, 0.0) && is_known_at_zero(function, &value))
        return formula_number(f, value);
    if (function == FUNCTION_LN && formula_is(f, u, 1.0))
        return formula_number(f, 0);
    if (function == FUNCTION_EXP && calls(f, u, FUNCTION_LN))
        return f->node[u].of[0];
    if (function == FUNCTION_EXP && c >= -1 && c <= -1)
        return formula_over(f, formula_number(f, 1),
                            formula_of(f, FUNCTION_EXP, rest));
    if (function == FUNCTION_LN && calls(f, u, FUNCTION_EXP))
        return f->node[u].of[0];
    if (function == FUNCTION_LN && f->node[u].kind == FORMULA_OVER &&
        formula_is(f, f->node[u].of[0], 1.0))
        return scaled(f, -1, formula_of(f, FUNCTION_LN, f->node[u].of[1]));
    return formula_call(f, function, &u);
}

/* ---- names --------------------------------------------------------------- */

int formula_find(const struct formula *f, const char *name, size_t size)
{
    for (int i = f->definitions; i-- > 0;)
        if (strlen(f->definition[i].name) == size &&
            strncmp(f->definition[i].name, name, size) == 0)
            return f->definition[i].node;
    for (int i = 0; i < f->nodes; i++)
        if (f->node[i].kind == FORMULA_LEAF &&
            strlen(f->node[i].name) == size &&
            strncmp(f->node[i].name, name, size) == 0)
            return i;
    return -1;
}

bool formula_is_plain(const struct formula *f, int u)
{
    int rest;

    (void) formula_factor(f, u, &rest);
    return is_number(f, u) || f->node[rest].kind == FORMULA_LEAF;
}

void formula_complete(const struct formula *f, bool needed[])
{
    for (int i = f->nodes; i-- > 0;)
        for (int j = 0; needed[i] && j < f->node[i].arguments; j++)
            needed[f->node[i].of[j]] = true;
}

void formula_name(struct formula *f, int u, const char *name)
{
    if (is_number(f, u) || f->node[u].name[0] || strlen(name) >= FORMULA_NAME)
        return;
    for (int i = 0; i < f->nodes; i++)
        if (strcasecmp(f->node[i].name, name) == 0)
            return;
    strcpy(f->node[u].name, name);
}

void formula_define(struct formula *f, const char *name, int u)
{
    if (f->definitions == FORMULA_DEFINITIONS || strlen(name) >= FORMULA_NAME) {
        f->full = true;
        return;
    }
    strcpy(f->definition[f->definitions].name, name);
    f->definition[f->definitions++].node = u;
    if (!f->node[u].moves)
        formula_name(f, u, name);
}

bool formula_take_out(struct formula *f, int u, int x, int *out)
{
    const struct formula_node n = f->node[u];
    int part[2] = { n.of[0], n.of[1] };
    formula_real exponent;
    int fuel = FUEL;

    *out = formula_number(f, 1);
    if (u == x)
        return true;
    if (n.kind == FORMULA_CALL && n.function == FUNCTION_POWER &&
        value_of(f, n.of[1], &fuel, &exponent) && exponent >= 1 &&
        formula_take_out(f, n.of[0], x, out)) {
        part[1] = formula_less(f, n.of[1], formula_number(f, 1));
        *out = formula_times(f, *out,
                             formula_is(f, part[1], 0.0) ? formula_number(f, 1)
                             : formula_is(f, part[1], 1.0)
                                 ? n.of[0]
                                 : formula_call(f, FUNCTION_POWER, part));
        return true;
    }
    if (n.kind == FORMULA_SUM) {
        const bool both = formula_take_out(f, n.of[0], x, &part[0]) &&
                          formula_take_out(f, n.of[1], x, &part[1]);
        *out = formula_sum(f, part[0], part[1]);
        return both;
    }
    if (n.kind == FORMULA_OVER && formula_take_out(f, n.of[0], x, &part[0])) {
        *out = formula_over(f, part[0], n.of[1]);
        return true;
    }
    for (int i = 0; i < 2 && n.kind == FORMULA_TIMES; i++)
        if (formula_take_out(f, n.of[i], x, &part[i])) {
            *out = formula_times(f, part[i], n.of[1 - i]);
            return true;
        }
    return false;
}
