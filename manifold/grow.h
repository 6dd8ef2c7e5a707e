/*
 * grow.h -- the stable manifold of a saddle, grown outward from its series.
 *
 * Backward along its stable manifold a saddle is not stiff: the graph y(x) or
 * x(y), whichever is flatter, is continued by Taylor steps; where nobody wants
 * pieces also the graph over a sum of both, which leans.
 */
#pragma once

#include "branch.h"
#include "monitor.h"

/* Who follows a branch: asked after every step, whose end z (an offset) is off
 * by no more than `error`, whether it ends there. */
struct grow_follower {
    bool (*ends)(void *ctx, const struct branch *b, struct vec2 z,
                 double error);
    void *ctx; /* borrowed */
};

struct grow_options {
    double rtol;  /* asked of the limits and integrals */
    size_t order; /* of the Taylor series */
    size_t max_steps;
    double longest; /* of a step, along x or y; 0: as far as it holds */
    struct carry carry;
    bool bare; /* pieces are constants: where the branch was, for who wants its
                  limits and what they are off by; it leans where it may */
    const struct box *reach; /* absolute, borrowed; the branch is not closed
                                inside it; NULL: close as soon as possible */
    const struct grow_follower *follower; /* borrowed.  With one a branch has no
        limits: it goes on to the end of the domain, to where the follower ends
        it (BRANCH_EQUILIBRIUM), or as far as steps go (BRANCH_STEPS) */
    const struct monitor *monitor;        /* borrowed, may be NULL */
};

/* The order of Taylor series that is cheapest for an accuracy. */
size_t grow_order(double rtol);

struct grow_options grow_defaults(double rtol);

/* Both branches of the local series of a stable manifold, backward in time,
 * out[0] on the side of growing ind and out[1] on the other, to their limits or
 * the end of the domain: their series are expanded side by side.  The caller
 * frees them (branch_free).  STATUS_NO_CONVERGENCE: no step is short enough;
 * STATUS_STOPPED; STATUS_NO_MEMORY.  On error both are empty. */
MUST_CHECK enum status grow_branches(const struct planar *sys,
                                     const struct local_series *start,
                                     const struct grow_options *o,
                                     struct branch out[2]);

/* The same of several systems at once; each has the bits that it has alone. */
enum { GROW_JOBS = 8 };
struct grow_job {
    const struct planar *sys;
    const struct local_series *start;
    const struct grow_options *options;
    int side;           /* 0: both, +1 or -1: one; the other is empty */
    int carries;        /* likewise; the other one carries nothing */
    struct branch *out; /* [2] */
    enum status status; /* when it is done */
};

/* n <= GROW_JOBS. */
void grow_jobs(struct grow_job job[], size_t n);

/* One of them, +1 or -1, at the price of both; on error *out is empty. */
MUST_CHECK enum status grow_branch(const struct planar *sys,
                                   const struct local_series *start, int side,
                                   const struct grow_options *o,
                                   struct branch *out);
