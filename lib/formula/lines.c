#include "lines.h"

#include <stdio.h>
#include <string.h>

#include "number.h"

/* ---- the tape over nodes ------------------------------------------------- */

static int call(struct formula *f, enum formula_function which, int u, int w,
                int z)
{
    return formula_call(f, which, (int[FUNCTION_ARGUMENTS]){ u, w, z });
}

static int exponential(struct formula *f, int u)
{
    return formula_of(f, FUNCTION_EXP, u);
}

static int larger(struct formula *f, int u, int w)
{
    return call(f, FUNCTION_MAX, u, w, 0);
}

static int minus(struct formula *f, int u)
{
    return formula_less(f, 0, u);
}

/* Constants first. */
static int linear(struct formula *f, const struct linear *u, const int reg[])
{
    int sum = u->constant;

    for (int i = 0; i < u->terms; i++)
        sum = formula_sum(f, sum,
                          formula_times(f, u->term[i].c, reg[u->term[i].reg]));
    return sum;
}

/* ln of what a growth has grown to */
static int grown(struct formula *f, const struct step *s, const int reg[])
{
    return s->b >= 0 ? reg[s->b] : formula_sum(f, s->q, reg[s->a]);
}

/* How large a growth is, and an apart but for its factor: the logarithm. */
static int size(struct formula *f, const struct step *s, const int reg[])
{
    if (s->kind == STEP_GROWTH)
        return grown(f, s, reg);
    return larger(f, reg[s->a], formula_sum(f, reg[s->b], s->q));
}

static int scale_of(struct formula *f, const struct tape *t,
                    const struct linear *u, const int reg[])
{
    int scale = 0;

    for (int i = 0; i < u->terms; i++)
        if (tape_grows(t, u->term[i].reg))
            scale =
                larger(f, scale, size(f, &t->step[u->term[i].reg - 2], reg));
    return scale;
}

/* Of k e^-scale. */
static int growth(struct formula *f, const struct step *s, int k, int scale,
                  const int reg[])
{
    const int l = formula_less(f, grown(f, s, reg), scale);

    return s->k ? call(f, FUNCTION_GROWTH, k, l, reg[s->a]) : exponential(f, l);
}

/* A growth or an apart times e^-scale. */
static int shrunk(struct formula *f, const struct step *s, int scale,
                  const int reg[])
{
    if (s->kind == STEP_GROWTH)
        return growth(f, s, exponential(f, formula_less(f, s->q, scale)), scale,
                      reg);
    const int w = formula_sum(f, reg[s->b], s->q);
    return call(f, FUNCTION_APART, s->k, formula_less(f, reg[s->a], scale),
                formula_less(f, w, scale));
}

static int scaled(struct formula *f, const struct tape *t,
                  const struct linear *u, const int reg[])
{
    const int scale = scale_of(f, t, u, reg),
              less = exponential(f, minus(f, scale));
    int sum = formula_times(f, u->constant, less);

    for (int i = 0; i < u->terms; i++) {
        const int r = u->term[i].reg;
        const int part = tape_grows(t, r)
                             ? shrunk(f, &t->step[r - 2], scale, reg)
                             : formula_times(f, reg[r], less);
        sum = formula_sum(f, sum, formula_times(f, u->term[i].c, part));
    }
    return sum;
}

/* k (cos u - 1) + q sin u = 2 sin(u/2) (q cos(u/2) - k sin(u/2)) */
static int sine(struct formula *f, int k, int q, int u)
{
    const int half = formula_over(f, u, formula_number(f, 2)),
              s = formula_of(f, FUNCTION_SIN, half),
              c = formula_of(f, FUNCTION_COS, half);

    return formula_times(
        f, formula_times(f, formula_number(f, 2), s),
        formula_less(f, formula_times(f, q, c), formula_times(f, k, s)));
}

/* As a difference that keeps fewer digits near the anchor. */
static int change(struct formula *f, enum step_kind kind, int k, int u)
{
    const enum formula_function which = kind == STEP_COSH   ? FUNCTION_COSH
                                        : kind == STEP_TAN  ? FUNCTION_TAN
                                        : kind == STEP_TANH ? FUNCTION_TANH
                                        : kind == STEP_ASIN ? FUNCTION_ASIN
                                        : kind == STEP_ATAN ? FUNCTION_ATAN
                                                            : FUNCTION_ASINH;

    return formula_less(f, formula_of(f, which, formula_sum(f, k, u)),
                        formula_of(f, which, k));
}

static int make(struct formula *f, const struct tape *t, const struct step *s,
                const int reg[])
{
    const int u = s->a >= 0 ? reg[s->a] : 0, w = s->b >= 0 ? reg[s->b] : 0;
    const int four = formula_number(f, 4), two = formula_number(f, 2);

    switch (s->kind) {
        case STEP_LINEAR:
            return linear(f, &s->form, reg);
        case STEP_GROWTH:
            return growth(f, s, s->k, 0, reg);
        case STEP_APART:
            return call(f, FUNCTION_APART, s->k, u, formula_sum(f, w, s->q));
        case STEP_MIXED:
            return call(f, FUNCTION_MIXED, s->k, s->q, u);
        case STEP_LN1P:
            return call(f, FUNCTION_LN1P, formula_over(f, u, s->k), 0, 0);
        case STEP_SINH:
            return call(f, FUNCTION_SINHS, formula_sum(f, s->k, u), 0, 0);
        case STEP_FRICTION:
            return call(
                f, FUNCTION_BEND, s->k,
                formula_times(
                    f, four,
                    exponential(f, minus(f, formula_times(f, two, s->k)))),
                u);
        case STEP_SIN:
            return sine(f, s->k, s->q, u);
        case STEP_PRODUCT:
            return formula_times(f, u, w);
        case STEP_QUOTIENT:
            return formula_over(f, u, formula_sum(f, s->k, w));
        case STEP_SCALED:
            return scaled(f, t, &s->form, reg);
        default:
            return change(f, s->kind, s->k, u);
    }
}

static int exponent(struct formula *f, const struct tape *t,
                    const struct tape_rate *r, const int reg[])
{
    int sum = linear(f, &r->exponent[0], reg);

    if (r->sinh >= 0) {
        const struct step *s = &t->step[r->sinh - 2];
        const int u = formula_sum(f, s->k, reg[s->a]),
                  rest = formula_less(f, sum, u),
                  other = linear(f, &r->exponent[1], reg);
        sum =
            rest == formula_sum(f, other, u)
                ? formula_sum(f, rest, call(f, FUNCTION_ABS, u, 0, 0))
                : formula_call(f, FUNCTION_CHOOSE, (int[]){ u, 0, other, sum });
    }
    if (r->scaled >= 0)
        sum = formula_sum(f, sum,
                          scale_of(f, t, &t->step[r->scaled - 2].form, reg));
    return sum;
}

void text_of_tape(struct formula *f, const struct tape *t, const int offset[2],
                  struct tape_text *out)
{
    int reg[TAPE_STEPS + 2] = { offset[0], offset[1] }, e[2];

    for (int i = 0; i < t->steps; i++) {
        reg[i + 2] = make(f, t, &t->step[i], reg);
        formula_name(f, reg[i + 2], t->step[i].name);
    }
    for (int i = 0; i < 2; i++)
        e[i] = exponent(f, t, &t->rate[i], reg);
    out->scale = larger(f, e[0], e[1]);
    for (int i = 0; i < 2; i++)
        out->rate[i] =
            formula_times(f, linear(f, &t->rate[i].mantissa, reg),
                          exponential(f, formula_less(f, e[i], out->scale)));
    for (int i = 0; i < TAPE_VALUES; i++)
        out->value[i] = linear(f, &t->value[i], reg);
}

/* ---- writing ------------------------------------------------------------- */

struct pen {
    const struct formula *f;
    char *text;
    size_t size, used;
    bool full;
};

static void put(struct pen *p, const char *word)
{
    const size_t length = strlen(word);

    p->full = p->full || p->used + length + 1 > p->size;
    if (p->full)
        return;
    memcpy(p->text + p->used, word, length + 1);
    p->used += length;
}

static void put_node(struct pen *p, int i);

/* How tightly it binds: a sign, a sum, a product, a word. */
static int rank(const struct formula *f, int i)
{
    const struct formula_node *n = &f->node[i];

    if (n->name[0] || n->kind == FORMULA_CALL)
        return 3;
    if (n->kind == FORMULA_NUMBER)
        return n->number < 0 ? 0 : 3;
    if (n->kind == FORMULA_SUM)
        return 1;
    return n->kind == FORMULA_TIMES && f->node[n->of[0]].number < 0 ? 0 : 2;
}

/* As an argument of something that binds with at least `needed`. */
static void put_part(struct pen *p, int i, int needed)
{
    const struct formula_node *n = &p->f->node[i];
    const bool open = rank(p->f, i) < needed;

    put(p, open ? "(" : "");
    if (n->name[0])
        put(p, n->name);
    else
        put_node(p, i);
    put(p, open ? ")" : "");
}

static void put_number(struct pen *p, double number)
{
    put(p, number_shortest(number).text);
}

/* +w, or -|c| w */
static void put_term(struct pen *p, int w)
{
    const struct formula_node *n = &p->f->node[w];
    int rest;
    const formula_real c = formula_factor(p->f, w, &rest);

    if (n->name[0] || c >= 0) {
        put(p, "+");
        put_part(p, w, 2);
        return;
    }
    put(p, "-");
    if (c < -1 || c > -1) {
        put_number(p, (double) -c);
        put(p, "*");
    }
    put_part(p, rest, c < -1 || c > -1 ? 3 : 2);
}

static void put_product(struct pen *p, const struct formula_node *n)
{
    if (formula_is(p->f, n->of[0], -1.0)) {
        put(p, "-");
        put_part(p, n->of[1], 3);
        return;
    }
    if (p->f->node[n->of[0]].kind == FORMULA_NUMBER)
        put_number(p, (double) p->f->node[n->of[0]].number);
    else
        put_part(p, n->of[0], 2);
    put(p, n->kind == FORMULA_TIMES ? "*" : "/");
    put_part(p, n->of[1], 3);
}

static void put_node(struct pen *p, int i)
{
    const struct formula_node *n = &p->f->node[i];

    switch (n->kind) {
        case FORMULA_NUMBER:
            put_number(p, (double) n->number);
            break;
        case FORMULA_LEAF:
            put(p, n->name);
            break;
        case FORMULA_SUM:
            put_part(p, n->of[0], 1);
            put_term(p, n->of[1]);
            break;
        case FORMULA_CALL:
            put(p, functions[n->function].name);
            for (int j = 0; j < n->arguments; j++) {
                put(p, j ? "," : "(");
                put_part(p, n->of[j], 1);
            }
            put(p, ")");
            break;
        default:
            put_product(p, n);
            break;
    }
}

/* ---- lines --------------------------------------------------------------- */

/* A constant in what changes counts twice: it gets a line of its own. */
static void count(const struct formula *f, const int result[], int results,
                  int uses[])
{
    memset(uses, 0, FORMULA_NODES * sizeof *uses);
    for (int i = 0; i < results; i++)
        uses[result[i]]++;
    for (int i = f->nodes; i-- > 0;) /* users come after */
        for (int j = 0; uses[i] && j < f->node[i].arguments; j++) {
            const int u = f->node[i].of[j];
            uses[u] += 1 + (f->node[i].moves && !f->node[u].moves);
        }
}

/* -w and 2 w are no more than w, if that has a name. */
static bool can_be_named(const struct formula *f, int i)
{
    int rest;

    (void) formula_factor(f, i, &rest);
    return !f->node[i].name[0] && !formula_is_plain(f, i) &&
           (rest == i || !f->node[rest].name[0]);
}

static void name_repeated(struct formula *f, const int uses[])
{
    char name[FORMULA_NAME];
    int named = 0;

    for (int i = 0; i < f->nodes; i++)
        while (uses[i] > 1 && can_be_named(f, i)) {
            snprintf(name, sizeof name, "k%d", ++named);
            formula_name(f, i, name);
        }
}

static bool write_line(const struct formula *f, int i, struct text_lines *out)
{
    if (out->lines == TEXT_LINES)
        return false;
    struct text_line *line = &out->line[out->lines++];
    struct pen p = { f, line->text, sizeof line->text, 0, false };

    strcpy(line->name, f->node[i].name);
    line->moves = f->node[i].moves;
    line->text[0] = '\0';
    put_node(&p, i);
    return !p.full;
}

bool text_write(struct formula *f, const int result[], int results,
                struct text_lines *out)
{
    int uses[FORMULA_NODES];

    count(f, result, results, uses);
    name_repeated(f, uses);
    memset(out->calls, 0, sizeof out->calls);
    memset(out->uses, 0, sizeof out->uses);
    out->lines = 0;
    for (int i = 0; i < f->nodes; i++) {
        const struct formula_node *n = &f->node[i];
        if (uses[i] == 0)
            continue;
        if (n->kind == FORMULA_LEAF)
            out->uses[i] = true;
        else if (n->name[0] && !write_line(f, i, out))
            return false;
        if (n->kind == FORMULA_CALL)
            out->calls[n->function] = true;
    }
    function_complete(out->calls);
    for (int i = 0; i < FUNCTIONS; i++)
        out->calls[i] = out->calls[i] && functions[i].body;
    return !f->full;
}
