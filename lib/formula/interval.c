#include "interval.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "parse.h"
#include "quad.h"

#define LINK
#define REAL    double
#define FN(f)   f
#define NAME(x) x##_double
#define OWN(x)  x##_53
#define UNIT    0x1p-52
#define LEAST   0x1p-1074
#define MOST    0x1.fffffffffffffp1023
#include "interval_formula.h"

#include "interval_done.h"

#define REAL    formula_real
#define FN(f)   f##q
#define NAME(x) x##_quad
#define OWN(x)  x##_113
#define UNIT    ((formula_real) 0x1p-112)
#define LEAST   ((formula_real) 0x1p-16400L)
#define MOST    ((formula_real) 0x1.fffffffffffffffep16383L)
#include "interval_formula.h"

#include "interval_done.h"

struct interval_quad interval_divide_quad(struct interval_quad u,
                                          struct interval_quad w)
{
    return interval_times_quad(u, inverse_113(w));
}

struct interval_quad interval_sqrt_quad(struct interval_quad u)
{
    return root_113(u);
}

/* Whole ones to 60 bits are meant. */
struct interval_quad interval_decimal(formula_real x)
{
    const formula_real scaled = x * 0x1p60;

    if (fabsq(scaled) < 0x1p100 && floorq(scaled) >= scaled)
        return point_113(x);
    return (struct interval_quad){ below_113(x), above_113(x) };
}

/* ---- plans --------------------------------------------------------------- */

/* Rounded outward to doubles. */
static struct interval_double outward(struct interval_quad u)
{
    const double lo = (double) u.lo, hi = (double) u.hi;

    return (struct interval_double){ lo > u.lo ? nextafter(lo, -HUGE_VAL) : lo,
                                     hi < u.hi ? nextafter(hi, HUGE_VAL) : hi };
}

/* Marks what the results need. */
static void mark(const struct formula *f, const int result[], int results,
                 bool needed[])
{
    for (int i = 0; i < results; i++)
        needed[result[i]] = true;
    formula_complete(f, needed);
}

/* About what it costs, in additions. */
static int effort_of(const struct formula_node *n)
{
    static const enum formula_function slow[] = { FUNCTION_SIN, FUNCTION_COS,
                                                  FUNCTION_TAN, FUNCTION_ATAN };

    for (size_t i = 0; i < sizeof slow / sizeof *slow; i++)
        if (n->kind == FORMULA_CALL && n->function == slow[i])
            return 150;
    return n->kind == FORMULA_CALL ? 8 : 2;
}

/* What is the same everywhere is enclosed once; what is not joins the list.
 * Says what is wrong, or NULL. */
static const char *add_node(struct interval_plan *p, int i, formula_real value)
{
    static const struct interval_slope_quad none;
    const struct formula_node *n = &p->f->node[i];
    int domain = INTERVAL_WHOLE;

    p->of_quad[i] = none;
    if (n->kind == FORMULA_NUMBER || (n->kind == FORMULA_LEAF && !n->moves))
        p->of_quad[i].value =
            interval_decimal(n->kind == FORMULA_NUMBER ? n->number : value);
    else if (n->kind != FORMULA_LEAF)
        domain = node_113(p->f, i, p->of_quad);
    if (domain < 0)
        return "has no rule for intervals";
    if (n->moves) {
        p->node[p->nodes] = i;
        p->nodes += n->kind != FORMULA_LEAF;
        p->effort += effort_of(n);
        return NULL;
    }
    p->of_double[i] =
        (struct interval_slope_double){ outward(p->of_quad[i].value),
                                        { { 0, 0 }, { 0, 0 } } };
    return domain == INTERVAL_WHOLE ? NULL : "of a constant is not defined";
}

static const char *name_of(const struct formula_node *n)
{
    return n->kind == FORMULA_CALL ? functions[n->function].name : "a quotient";
}

enum status interval_plan(struct interval_plan *p, const struct formula *f,
                          const int variable[2], const int result[],
                          int results, const formula_real value[],
                          struct fault *why)
{
    bool needed[FORMULA_NODES] = { false };

    p->f = f;
    p->nodes = p->effort = 0;
    p->results = results;
    memcpy(p->variable, variable, sizeof p->variable);
    memcpy(p->result, result, (size_t) results * sizeof *result);
    mark(f, result, results, needed);
    for (int i = 0; i < f->nodes; i++) {
        const char *wrong = needed[i] ? add_node(p, i, value[i]) : NULL;
        if (wrong)
            return fault_set(why, STATUS_BAD_ARGUMENT, "%s %s",
                             name_of(&f->node[i]), wrong);
    }
    return STATUS_OK;
}
