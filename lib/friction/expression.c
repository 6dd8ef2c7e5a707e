#include "expression.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

struct expression expression_number(double number)
{
    return (struct expression){ .number = number };
}

/* ---- making nodes -------------------------------------------------------- */

static bool is_number(struct expression u, double number)
{
    return u.tape == NULL && u.number >= number && u.number <= number;
}

static bool is_same(const struct node *a, const struct node *b)
{
    const bool alike = a->kind == b->kind && a->arguments == b->arguments &&
                       a->function == b->function &&
                       memcmp(a->of, b->of, sizeof a->of) == 0;

    if (a->kind == NODE_LEAF && alike)
        return strcmp(a->name, b->name) == 0;
    return alike && memcmp(&a->number, &b->number, sizeof a->number) == 0;
}

/* What is there already is not made again. */
static struct expression add(struct tape *t, const struct node *n)
{
    for (size_t i = 0; i < t->nodes; i++)
        if (is_same(&t->node[i], n))
            return (struct expression){ .tape = t, .node = i };
    assert(t->nodes < TAPE_NODES);
    t->node[t->nodes] = *n;
    return (struct expression){ .tape = t, .node = t->nodes++ };
}

/* The node of an argument: a number gets one now. */
static size_t place(struct tape *t, struct expression u)
{
    const struct node number = { .kind = NODE_NUMBER, .number = u.number };

    return u.tape ? u.node : add(t, &number).node;
}

static struct expression join(enum node_kind kind, const char *function,
                              const struct expression of[], size_t arguments)
{
    struct node n = { .kind = kind, .function = function };
    struct tape *t = NULL;

    for (size_t i = 0; i < arguments; i++)
        t = of[i].tape ? of[i].tape : t;
    assert(t != NULL && arguments <= TAPE_ARGUMENTS);
    for (size_t i = 0; i < arguments; i++) {
        n.of[i] = place(t, of[i]);
        n.moves = n.moves || t->node[n.of[i]].moves;
    }
    n.arguments = arguments;
    return add(t, &n);
}

static struct expression pair(enum node_kind kind, struct expression u,
                              struct expression w)
{
    return join(kind, NULL, (struct expression[]){ u, w }, 2);
}

static struct expression minus(struct expression u)
{
    if (u.tape == NULL)
        return expression_number(-u.number);
    return join(NODE_MINUS, NULL, &u, 1);
}

struct expression expression_leaf(struct tape *t, const char *name, bool moves)
{
    struct node n = { .kind = NODE_LEAF, .moves = moves };

    assert(strlen(name) < sizeof n.name);
    strcpy(n.name, name);
    return add(t, &n);
}

struct expression expression_sum(struct expression u, struct expression w)
{
    if (is_number(u, 0.0))
        return w;
    if (is_number(w, 0.0))
        return u;
    if (!u.tape && !w.tape)
        return expression_number(u.number + w.number);
    if (w.tape && w.tape->node[w.node].kind == NODE_MINUS && u.tape)
        return pair(NODE_LESS, u,
                    (struct expression){
                        .tape = w.tape,
                        .node = w.tape->node[w.node].of[0],
                    });
    return pair(NODE_SUM, u, w);
}

struct expression expression_less(struct expression u, struct expression w)
{
    if (is_number(u, 0.0))
        return minus(w);
    if (is_number(w, 0.0))
        return u;
    if (!u.tape && !w.tape)
        return expression_number(u.number - w.number);
    return pair(NODE_LESS, u, w);
}

struct expression expression_times(struct expression u, struct expression w)
{
    if (is_number(u, 0.0) || is_number(w, 1.0))
        return u;
    if (is_number(w, 0.0) || is_number(u, 1.0))
        return w;
    if (!u.tape && !w.tape)
        return expression_number(u.number * w.number);
    if (is_number(u, -1.0) || is_number(w, -1.0))
        return minus(u.tape ? u : w);
    return pair(NODE_TIMES, u, w);
}

struct expression expression_over(struct expression u, struct expression w)
{
    if (is_number(u, 0.0) || is_number(w, 1.0))
        return u;
    if (!u.tape && !w.tape)
        return expression_number(u.number / w.number);
    return pair(NODE_OVER, u, w);
}

struct expression expression_call(const char *function,
                                  const struct expression of[],
                                  size_t arguments)
{
    return join(NODE_CALL, function, of, arguments);
}

/* ---- naming and counting ------------------------------------------------- */

void expression_name(struct expression u, const char *name)
{
    if (u.tape == NULL)
        return;
    struct node *n = &u.tape->node[u.node];
    if (n->kind == NODE_NUMBER || n->name[0])
        return;
    assert(strlen(name) < sizeof n->name);
    strcpy(n->name, name);
}

void expression_count(const struct expression results[], size_t count)
{
    struct tape *t = NULL;

    for (size_t i = 0; i < count; i++)
        t = results[i].tape ? results[i].tape : t;
    for (size_t i = 0; t && i < t->nodes; i++)
        t->node[i].uses = 0;
    for (size_t i = 0; i < count; i++)
        if (results[i].tape)
            t->node[results[i].node].uses++;
    for (size_t i = t ? t->nodes : 0; i-- > 0;) /* users come after */
        for (size_t j = 0; t->node[i].uses && j < t->node[i].arguments; j++)
            t->node[t->node[i].of[j]].uses++;
}

/* ---- writing ------------------------------------------------------------- */

struct pen {
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
    strcpy(p->text + p->used, word);
    p->used += length;
}

/* How tightly it binds: a sum, a product, a word. */
static int rank(const struct node *n)
{
    if (n->name[0] || n->kind == NODE_CALL)
        return 3;
    if (n->kind == NODE_NUMBER)
        return n->number < 0.0 ? 0 : 3;
    if (n->kind == NODE_TIMES || n->kind == NODE_OVER)
        return 2;
    return n->kind == NODE_MINUS ? 0 : 1;
}

static void write_node(const struct tape *t, size_t i, struct pen *p);

/* As an argument of something that binds with at least `rank_needed`. */
static void write_part(const struct tape *t, size_t i, int rank_needed,
                       struct pen *p)
{
    const bool open = rank(&t->node[i]) < rank_needed;

    put(p, open ? "(" : "");
    if (t->node[i].name[0])
        put(p, t->node[i].name);
    else
        write_node(t, i, p);
    put(p, open ? ")" : "");
}

static void write_call(const struct tape *t, const struct node *n,
                       struct pen *p)
{
    put(p, n->function);
    put(p, "(");
    for (size_t j = 0; j < n->arguments; j++) {
        put(p, j > 0 ? "," : "");
        write_part(t, n->of[j], 1, p);
    }
    put(p, ")");
}

static void write_node(const struct tape *t, size_t i, struct pen *p)
{
    static const char *const sign[] = { [NODE_SUM] = "+",
                                        [NODE_LESS] = "-",
                                        [NODE_TIMES] = "*",
                                        [NODE_OVER] = "/" };
    const struct node *n = &t->node[i];
    const int tight = n->kind == NODE_TIMES || n->kind == NODE_OVER ? 2 : 1;
    char number[32];

    switch (n->kind) {
        case NODE_NUMBER:
            snprintf(number, sizeof number, "%.17g", n->number);
            put(p, number);
            break;
        case NODE_LEAF:
            put(p, n->name);
            break;
        case NODE_CALL:
            write_call(t, n, p);
            break;
        case NODE_MINUS:
            put(p, "-");
            write_part(t, n->of[0], 3, p);
            break;
        default: /* u - (w + z), u/(w*z): the right one must bind tighter */
            write_part(t, n->of[0], tight, p);
            put(p, sign[n->kind]);
            write_part(t, n->of[1], tight + 1, p);
            break;
    }
}

bool expression_write(const struct tape *t, size_t i, char *text, size_t size)
{
    struct pen p = { text, size, 0, false };

    text[0] = '\0';
    write_node(t, i, &p);
    return !p.full;
}
