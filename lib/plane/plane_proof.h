/* plane_proof.h -- what is proved of the equilibria and of the branches of a
 * plane of formulas, beside their bars (proof_plane.h, docs/proofs.md). */
#pragma once

#include "plane_study.h"
#include "result.h"

/* What is proved of the end of a branch, in this order; NULL-ended. */
enum plane_proved {
    PLANE_NOT_PROVED,
    PLANE_CROSSES, /* the window's edge, where it leaves it */
    PLANE_TRAPPED  /* what it comes to: all states around that go there */
};
extern const char *const plane_proved_names[];

/* Proves the places and eigenvalues of the listed equilibria, and the ends of
 * the listed branches: numbers have `proved`, branches their code and reason.
 * Where what is proved is beside a bar, s->proof.lie says so.
 * STATUS_NO_MEMORY. */
MUST_CHECK enum status plane_proof_find(struct plane_study *s);

/* The edge that a branch leaves the window by, a decimal. */
double plane_proof_edge(const struct plane_study *s,
                        const struct plane_branch *b);

/* Whether numbers of this field are among them. */
bool plane_proof_is_of(const struct result *r, const struct record_field *f);

/* Lets go what contradicts the bars: the reason is that it does. */
void plane_proof_withdraw(struct plane_proof *p);

/* A second call is harmless. */
void plane_proof_free(struct plane_proof *p);
