/*
 * quad_tape.h -- a tape (tape.h) in 113 bits: its constants as numbers, and
 * what it computes at offsets from the anchor.
 */
#ifndef RACE_QUAD_TAPE_H
#define RACE_QUAD_TAPE_H

#include "quad.h"
#include "tape.h"

enum { QUAD_STEPS = 40 };

struct quad_linear {
    quad constant;
    int terms, reg[TAPE_TERMS];
    quad c[TAPE_TERMS];
};

struct quad_tape {
    struct {
        enum step_kind kind;
        int a, b;
        quad k, q;
        struct quad_linear form;
    } step[QUAD_STEPS];
    int steps;
    struct {
        struct quad_linear mantissa, exponent[2];
        int sinh, scaled;
    } rate[2];
    struct quad_linear value;
};

/* A leaf and what it is; the last has no name. */
struct quad_leaf {
    const char *name;
    quad value;
};

/* Constants of the parameters; t has at most QUAD_STEPS steps. */
void quad_tape_at(const struct formula *f, const struct tape *t,
                  const struct quad_leaf leaf[], struct quad_tape *out);

/* Rates of the chart, rate[i] exp(scale); value 0 of the tape in *value. */
void quad_tape_field(const struct quad_tape *t, quad X, quad Y, quad rate[2],
                     quad *scale, quad *value);

#endif
