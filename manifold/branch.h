/*
 * branch.h -- one half of an invariant manifold of a saddle, from the saddle
 * outward, and how it ends.
 */
#pragma once

#include "curve.h"
#include "local.h"

/* Why a branch ended: data, not an error. */
enum branch_end {
    BRANCH_LIMIT_X, /* y -> +-infinity while x has a limit */
    BRANCH_LIMIT_Y, /* x -> +-infinity while y has a limit */
    BRANCH_DOMAIN,  /* left the domain, or goes on for ever, without a limit */
    BRANCH_EQUILIBRIUM, /* ran into one, or where its follower ended it */
    BRANCH_STEPS        /* more steps than allowed, or too short ones */
};

/* A piece's part in the errors at the end: an error e of dep before it is
 * `grown` e after it and adds drift[i] e to integral i's; and bounds on what
 * its own estimates are off by. */
struct branch_miss {
    double grown, drift[LOCAL_CARRY_MAX];
    double bar, total_bar[LOCAL_CARRY_MAX];
};

struct branch {
    enum manifold_kind kind;
    int side;           /* sign of the independent coordinate of the series */
    struct carry carry; /* what rides along: curve components 2, 3, ... */
    bool from_saddle[LOCAL_CARRY_MAX]; /* counted from the saddle itself, not
                                          from the end of the series */
    struct curve curve;                /* owned; component 0, 1: offsets */
    enum branch_end end;
    int sign;          /* LIMIT_*: sign of the infinity */
    struct vec2 limit; /* offsets at the end; the infinite one as reached */
    struct vec2 error; /* bound on the limit's error */
    double total[LOCAL_CARRY_MAX]; /* integrals at the end */
    double total_error[LOCAL_CARRY_MAX];
    /* What the limit and the integrals are off by, with its sign, as far as it
     * is known, else 0: a part of their bounds. */
    double limit_off, total_off[LOCAL_CARRY_MAX];
    struct branch_miss *miss; /* owned; one a piece, or NULL: not known */
    size_t steps, rejected, evaluations; /* a jet of order k counts once */
};

void branch_free(struct branch *b);

/* One more piece of the curve, with its coefficients to be filled in
 * (curve_push), and its errors. */
MUST_CHECK enum status branch_push(struct branch *b, size_t degree,
                                   const struct branch_miss *miss,
                                   double **coef);

/* Bound on the error of by_limit * limit + by_total * total[i], of which the
 * parts may cancel. */
double branch_error(const struct branch *b, size_t i, double by_limit,
                    double by_total);

/* The coordinate over which a piece is a graph, linear in theta there. */
int branch_graph(const struct branch *b, size_t piece);

/* Slope dy/dx of the manifold at theta on a piece, from the field (exact up to
 * rounding); at the saddle itself the eigenvector's. */
double branch_slope(const struct planar *sys, const struct branch *b,
                    size_t piece, double theta);
