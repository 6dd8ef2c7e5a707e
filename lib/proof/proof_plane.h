/*
 * proof_plane.h -- a branch of a saddle of a planar system of formulas,
 * enclosed with proof: where it crosses the edge of a window, or that it comes
 * into a trap (proof_trap.h).  What is proved is a theorem about the system
 * with its numbers as decimals; docs/proofs.md has it.
 */
#pragma once

#include "equilibria.h"
#include "proof_join.h"
#include "proof_trap.h"
#include "system_plane.h"

/* The field about an exact saddle. */
struct proof_plane {
    struct interval_graph at; /* constants there */
    struct interval_tape tape;
};

/* Of a system lowered about equilibria, in that direction of time in which the
 * branch is of a stable manifold; value[]: of its parameters, ended by one
 * without a name; saddle: its place in the chart.  l is borrowed.
 * STATUS_BAD_ARGUMENT: "not proved", *why; STATUS_NO_MEMORY.  proof_plane_free
 * either way. */
MUST_CHECK enum status proof_plane_at(struct proof_plane *p,
                                      const struct tape_lowered *l,
                                      const struct formula_value value[],
                                      const struct system_number saddle[2],
                                      struct fault *why);
void proof_plane_free(struct proof_plane *p);

/* The doubles around a number of equilibria.h. */
struct interval proof_plane_number(const struct system_number *n);

/* What is to be proved of a branch; in offsets from the saddle. */
struct proof_goal {
    const struct proof_trap *trap; /* borrowed; that it comes into this one; or,
                                      NULL, that it crosses a line: */
    int axis;                      /* 0: x = at; 1: y = at */
    struct interval at;
    size_t piece; /* about there on its curve */
    double theta;
};

/* STATUS_NO_MEMORY; out->not_proved says why it is not.  crossing[]: where the
 * line is crossed.  The caller frees out's pieces and cells. */
MUST_CHECK enum status proof_plane_branch(struct proof_plane *p,
                                          const struct branch *curve,
                                          const struct proof_goal *goal,
                                          struct proof_branch *out,
                                          struct interval crossing[2]);
