/*
 * tape_course.h -- for the files of tape_jet.c only: how an order of the series
 * is made, and where things stand in the workspace.
 */
#ifndef FORMULA_TAPE_COURSE_H
#define FORMULA_TAPE_COURSE_H

#include "tape_plane.h"

/* Of order k. */
struct course {
    const struct tape_plane *p;
    const struct real_tape *t;
    jet_pair *all, *reg; /* the workspace, registers */
    jet_pair *A, *B;     /* row k */
    const jet_pair *S;   /* sums */
    double k, inverse;
};

/* An expression for each lane i. */
#define EACH(out, value)                                                       \
    do {                                                                       \
        for (int i = 0; i < JET_LANES; i++)                                    \
            (out)[i] = value;                                                  \
    } while (0)

/* What is kept of order 0 is kept by slot, three each, and one more. */
enum { KEPT = 3 };

/* How many sums a step needs, by its kind and with its parts; and a rate: the
 * exponential, and its product with the mantissa. */
int tape_kind_slots(enum step_kind kind);
int tape_step_slots(const struct real_tape *t, const struct real_tape_entry *n);
int tape_rate_slots(const struct real_tape_rate *r);

/* The sums of order k > 0. */
void tape_sums(const struct tape_plane *p, struct jet_work *w, size_t k,
               int part);

/* They on rows a and b: sum[i] of a[j width + i] b[(k - j) width + i]; width is
 * even.  On registers twice as wide, false where there are none. */
void tape_sums_plain(size_t k, size_t width, const jet_pair *a,
                     const jet_pair *b, jet_pair *sum);
bool tape_sums_wide(size_t k, size_t width, const jet_pair *a,
                    const jet_pair *b, jet_pair *sum);

/* Order 0 of a step. */
void tape_start(const struct course *c, int i);

/* No exponential then. */
static inline bool is_fixed(const struct real_tape_rate *r)
{
    return r->exponent[0].terms == 0 && r->exponent[1].terms == 0;
}

static inline bool is_joined(const struct real_tape *t, int reg)
{
    return t->step[reg - 2].joined;
}

static inline jet_pair linear(const struct course *c,
                              const struct real_tape_form *u)
{
    jet_pair sum = JET_PAIR(0.0);

    for (int i = u->first; i < u->first + u->terms; i++)
        sum += c->t->term[i].c * c->reg[c->t->term[i].reg];
    return sum;
}

#endif
