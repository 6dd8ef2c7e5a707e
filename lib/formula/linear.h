/*
 * linear.h -- linear forms in the registers of a tape that is being made;
 * their coefficients are nodes.
 */
#pragma once

#include "tape.h"

/* Where forms are made: a graph, a tape, and why it failed if it did. */
struct forms {
    struct formula *f; /* borrowed */
    struct tape *t;    /* borrowed */
    const char *failed;
};

/* Says why, once; answers 0. */
struct linear linear_fail(struct forms *s, const char *reason);

struct linear linear_constant(int node);
/* node + reg */
struct linear linear_one(struct forms *s, int reg, int node);

/* u += c w, and with a plain number c */
void linear_add(struct forms *s, struct linear *u, int c,
                const struct linear *w);
void linear_add_times(struct forms *s, struct linear *u, double c,
                      const struct linear *w);
struct linear linear_times(struct forms *s, int c, const struct linear *w);
struct linear linear_over(struct forms *s, const struct linear *w, int c);

/* A register that is the form without its constant. */
int linear_reg(struct forms *s, const struct linear *u);

/* The register of a step; the same step is made once. */
int linear_step(struct forms *s, enum step_kind kind, int a, int b, int k,
                int q);
/* A register that is its value. */
int linear_value(struct forms *s, const struct linear *u);
/* Whether all its registers are 0 at the anchor. */
bool linear_rests(const struct forms *s, const struct linear *u);

/* With what grew instead of growths: far from the anchor it keeps the digits
 * that a growth, which has all but taken away the anchor's value, would cancel.
 */
struct linear linear_grown(struct forms *s, const struct linear *u);

/* The register of u times e^-s, STEP_SCALED. */
int linear_scaled(struct forms *s, const struct linear *u);

/* node + the step of u alone; the node where u does not change. */
struct linear linear_function(struct forms *s, enum step_kind kind,
                              const struct linear *u, int k, int q, int node);

/* u w, u/w and u^p, p = 1, 2, ... */
struct linear linear_product(struct forms *s, const struct linear *u,
                             const struct linear *w);
struct linear linear_quotient(struct forms *s, const struct linear *u,
                              const struct linear *w);
struct linear linear_power(struct forms *s, const struct linear *u, int p);
