/*
 * tape.h -- the rates of a plane as a short program of differences from an
 * anchor, in which nothing cancels and nothing overflows.
 *
 * The chart of a state is its logarithm if it is positive, itself if not.
 * Registers 0 and 1 are the offsets of the chart from the anchor; the others
 * are made by steps.  A node g is kept linear in registers,
 *     g = g0 + sum c r    or, if it is positive and rather a product,
 *     ln g = l0 + sum c r,
 * so that differences are never taken and exponents add before anything is
 * exponentiated; a step is needed only where something is really nonlinear.  A
 * rate of the chart is M exp(E): where it has a factor sinh(u), whose e^|u| is
 * e^u or e^-u, E is one of two, so that u, a linear form, joins the others
 * before a number is put in.
 *
 * All constants are formulas of the parameters and of the anchor: what is 0 at
 * the anchor for every value of the parameters is 0 exactly.
 */
#pragma once

#include "formula.h"
#include "status.h"

enum {
    TAPE_STEPS = 256,
    TAPE_TERMS = 10,
    TAPE_VALUES = 2,
    TAPE_OBSERVABLES = 6,
    TAPE_RATES = 2 + TAPE_OBSERVABLES
};

/* constant + sum of c reg: nodes and registers */
struct linear {
    int constant, terms;
    struct {
        int reg, c;
    } term[TAPE_TERMS];
};

/* Step i makes register i + 2; u and w are registers a and b, k and q nodes. */
enum step_kind {
    STEP_LINEAR,   /* the linear form */
    STEP_GROWTH,   /* e^(q + u) - k, k = e^q or, of what is not 0 at the anchor,
                      0; b, if it is there: q + u, made without the anchor */
    STEP_APART,    /* k (e^u - e^(w + q)), q = 0 if it is 0 at the anchor */
    STEP_MIXED,    /* ln(k e^u + q), k + q = 1 */
    STEP_LN1P,     /* ln(1 + u/k) */
    STEP_SINH,     /* e^-|k + u| sinh(k + u) */
    STEP_FRICTION, /* asinh(e^(k + u)/2) - asinh(e^k/2) */
    STEP_SIN,      /* k (cos u - 1) + q sin u: sine and cosine */
    STEP_COSH,     /* cosh(k + u) - cosh k, and so on */
    STEP_TAN,
    STEP_TANH,
    STEP_ASIN,
    STEP_ATAN,
    STEP_ASINH,
    STEP_PRODUCT,  /* u w */
    STEP_QUOTIENT, /* u/(k + w) */
    STEP_SCALED    /* the linear form times e^-s, s the largest of 0, q + u of
                      its growths, u and w + q of its aparts */
};

struct step {
    enum step_kind kind;
    int a, b; /* -1: none */
    int k, q;
    struct linear form;
    char name[FORMULA_NAME]; /* for people; may be empty */
};

/* mantissa exp(exponent + s).  The second exponent holds where u of step `sinh`
 * is < 0; those from TAPE_NEAR on are the same forms with growths, k (e^u - 1),
 * where the others have what grew, k e^u: the first lose no digits near the
 * anchor, the second none where all growths have all but taken it away. */
enum { TAPE_NEAR = 2, TAPE_EXPONENTS = 4 };
struct tape_rate {
    struct linear mantissa;
    struct linear exponent[TAPE_EXPONENTS];
    int sinh, scaled; /* registers; -1: there is none, s = 0 */
    bool joined;      /* e^|u| has met terms that it cancels */
};

struct tape {
    struct step step[TAPE_STEPS];
    int steps;
    struct tape_rate rate[TAPE_RATES]; /* of the chart, and observables */
    int rates;
    struct linear value[TAPE_VALUES];
    bool needs[FORMULA_NODES]; /* its constants, and what they are made of */
};

/* What a tape is made of: nodes. */
struct plane_formulas {
    int state[2]; /* leaves */
    int chart[2]; /* the anchor in the chart, and */
    int at[2];    /* the states there, e^chart or chart: constants */
    int rate[2];  /* d state/dt */
    bool zero[2]; /* 0 at the anchor, whatever rounding makes of its terms */
    int observable[TAPE_OBSERVABLES], observables; /* rates of integrals */
    int value[TAPE_VALUES], values;                /* what else is asked for */
};

/* STATUS_BAD_ARGUMENT where something has no rule (yet), or is too long. */
MUST_CHECK enum status tape_lower(struct tape *t, struct formula *f,
                                  const struct plane_formulas *p,
                                  struct fault *why);

/* Puts the anchor of state i at a constant: its logarithm, or itself. */
MUST_CHECK enum status tape_anchor(struct formula *f, struct plane_formulas *p,
                                   int i, int node, struct fault *why);

/* Whether the register is a growth or an apart; whether it is a growth that
 * takes a value at the anchor away. */
static inline bool tape_grows(const struct tape *t, int reg)
{
    return reg >= 2 && (t->step[reg - 2].kind == STEP_GROWTH ||
                        t->step[reg - 2].kind == STEP_APART);
}

static inline bool tape_takes(const struct tape *t, int reg)
{
    return reg >= 2 && t->step[reg - 2].kind == STEP_GROWTH &&
           t->step[reg - 2].k != 0;
}

/* Marks the registers that a form or a rate reads, and then all that those
 * which are marked are made of; needed[TAPE_STEPS + 2]. */
void tape_need_linear(const struct linear *u, bool needed[]);
void tape_need_rate(const struct tape_rate *r, bool needed[]);
void tape_need_parts(const struct tape *t, bool needed[]);
