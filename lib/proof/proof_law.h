/*
 * proof_law.h -- a block on a slope, (17), over intervals: the field around its
 * exact saddle, and the law's formulas at any state.
 *
 * The saddle is where h(x) = mu(x, y_ss(x)) - tan(alpha) falls through 0: a
 * sign change of h between two points proves a root between them, and det J < 0
 * for any of them (proof_cone.h) that it is one and a saddle.  Where psi_ss has
 * no formula, y_ss is where dpsi/dt falls through 0.
 */
#pragma once

#include "block.h"
#include "interval_growth.h"
#include "interval_tape.h"
#include "law_graph.h"
#include "proof_input.h"

struct proof_law {
    struct law law;                     /* that of R = inf is the limit */
    const struct tape_lowered *lowered; /* borrowed, or == room */
    const struct law_graph *graph;      /* borrowed, or == graph_room */
    struct tape_lowered *room;          /* owned */
    struct law_graph *graph_room;       /* owned */
    struct interval_graph at;           /* constants at the anchor */
    struct interval_graph state;        /* mu and rates at any (x, y) */
    struct interval_growth *growth;     /* owned: room for those over boxes */
    struct interval_tape tape;
    struct interval x, y, v, psi;     /* the saddle: ln v, the chart's y */
    struct interval tan_alpha, force; /* cos(alpha)/eps^2 */
    bool is_log;                      /* psi is a logarithm */
};

/* With the saddle near b's anchor.  *why: a plain sentence where the answer is
 * STATUS_BAD_ARGUMENT, "not proved"; STATUS_NO_MEMORY.  proof_law_free either
 * way. */
MUST_CHECK enum status proof_law_at(struct proof_law *p, const struct block *b,
                                    const struct proof_inputs *in,
                                    struct fault *why);
void proof_law_free(struct proof_law *p);
