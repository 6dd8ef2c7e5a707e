/*
 * proof_law.h -- a block on a slope, (17), over intervals: the field around its
 * exact saddle, and what the ends of the stable manifold need to know of the
 * law.
 *
 * The saddle is where h(x) = mu_ss(e^x) - tan(alpha) falls through 0: a sign
 * change of h between two points proves a root between them, and det J < 0 for
 * any of them (proof.c) that it is one and a saddle.
 */
#pragma once

#include "block.h"
#include "interval_graph.h"
#include "interval_tape.h"
#include "law_graph.h"
#include "unit.h"

/* What the numbers of a scene are taken for. */
struct proof_inputs {
    bool decimal; /* the shortest decimals that read as these doubles; else
                     the doubles themselves */
    enum unit_angle slope_in;
    double slope;           /* as it was given */
    const char *slope_text; /* borrowed: its decimal; NULL: the shortest */
    const double *far;      /* borrowed: psi to which an open branch's tube is
                               followed; NULL: not at all */
};

struct proof_law {
    const struct tape_lowered *lowered; /* borrowed, or == room */
    const struct law_graph *graph;      /* borrowed, or == graph_room */
    struct tape_lowered *room;          /* owned */
    struct law_graph *graph_room;       /* owned */
    struct interval_graph at;           /* constants at the anchor */
    struct interval_graph steady;       /* psi_ss and T of x */
    int psi_ss, T;                      /* nodes of `steady`; -1: none */
    struct interval_tape tape;
    struct interval x, y, v, psi; /* the saddle: ln v, the chart's y */
    struct interval tan_alpha, eps2, a, b, R;
    struct interval force; /* cos(alpha)/eps^2 */
    bool is_log;           /* psi is a logarithm */
    bool first_order;      /* K(d) = d, else sinh d */
    enum psi_ss form;      /* of psi_ss */
    int node[2]; /* whether there is one above, below the saddle; -1: not known
                  */
};

/* With the saddle near b's anchor.  Of a law of named components, which have
 * what proof_end.h uses: theta' > 0, at most 1/psi (1 if psi is a logarithm);
 * psi_ss does not rise, 1/T does not fall with v; K = sinh or the identity;
 * 0 <= d mu/d ln v <= a, 0 <= d mu/d theta <= b.  *why: a plain sentence where
 * the answer is STATUS_BAD_ARGUMENT, "not proved"; STATUS_NO_MEMORY.
 * proof_law_free either way. */
MUST_CHECK enum status proof_law_at(struct proof_law *p, const struct block *b,
                                    const struct proof_inputs *in,
                                    struct fault *why);
void proof_law_free(struct proof_law *p);

/* psi_ss and 1/T at x = ln v; false where one has no finite enclosure. */
bool proof_law_steady(struct proof_law *p, struct interval x,
                      struct interval *psi_ss, struct interval *rate);
