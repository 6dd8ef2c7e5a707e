/*
 * tape_course.h -- for the files of tape_jet.c only: how an order of the series
 * is made, and where things stand in the workspace.
 */
#pragma once

#include "tape_plane.h"

/* Of order k. */
struct course {
    const struct tape_plane *p; /* the first lane's */
    const void *const *ctx;     /* each lane's */
    jet_pair *reg, *keep;       /* registers, what is kept of order 0 */
    jet_pair *constant;         /* coefficients of entries, two each */
    jet_pair *A, *B, *S, *next; /* rows k, sums, and those of k + 1 */
    double k, inverse;
    bool first; /* rows A end after the first */
};

/* What is kept of order 0 is kept by slot, three each, and one more. */
enum { TAPE_KEPT = 3 };

/* How many sums a step needs, by its kind and with its parts. */
int tape_kind_slots(enum step_kind kind);
int tape_step_slots(const struct real_tape *t, const struct real_tape_entry *n);

/* Registers and what is kept of them, in the places of p->kept and rate_kept;
 * reg[0] and reg[1] are the chart's offsets. */
struct tape_kept {
    const struct tape_plane *p;
    double reg[TAPE_STEPS + 2], keep[TAPE_KEEPS];
};

/* Steps of a part, for series, those that the chart's rates need being there:
 * e^-|w| sinh w has the |w| of this point. */
void tape_keep(struct tape_kept *v, int part);

/* A rate, e^e for its exponential. */
double tape_start_rate(struct tape_kept *v, int rate, double e);

/* Registers at z that a rate needs (0: both of the chart, 1: everything), and
 * with them d register/d(x, y). */
void tape_values(const struct tape_plane *p, struct vec2 z, int rate,
                 double reg[]);
void tape_gradients(const struct tape_plane *p, struct vec2 z, int rate,
                    double reg[], jet_pair g[]);

/* Of a linear form. */
jet_pair tape_linear_gradient(const struct real_tape *t,
                              const struct real_tape_form *u,
                              const jet_pair g[]);

/* No exponential then. */
static inline bool is_fixed(const struct real_tape_rate *r)
{
    return r->exponent[0].terms == 0 && r->exponent[1].terms == 0;
}

static inline bool is_joined(const struct real_tape *t, int reg)
{
    return t->step[reg - 2].joined;
}

/* Whether the exponent is the mean of two: sinh w with |w| of order 0. */
static inline bool is_mean(const struct real_tape *t,
                           const struct real_tape_rate *r)
{
    return r->sinh >= 0 && !is_joined(t, r->sinh);
}
