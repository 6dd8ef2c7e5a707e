/*
 * study_proof.h -- what is proved of a study's numbers, beside their bars.
 */
#pragma once

#include "proof_numbers.h"
#include "record.h"
#include "status.h"

struct scene;
struct study;

/* As many as are told: a branch's first knee twice. */
enum { STUDY_PROOFS = PROOF_NUMBERS + 4 };

/* Numbers point into `of`. */
struct study_proof {
    struct proof *exact; /* of the inputs as decimals; owned, NULL: none */
    struct proved of[STUDY_PROOFS][2]; /* as they are, in the SI */
    size_t count;
    struct fault lie; /* which number contradicts it; empty: none */
};

/* Proves the numbers that were found, of the saddle and of its stable manifold:
 * their `proved` is set.  Where what is proved is beside a bar, for decimals
 * and for the doubles that they are read as, s->proof.lie says so.
 * STATUS_NO_MEMORY. */
MUST_CHECK enum status study_prove(struct study *s);

/* Those of the scene, as decimals. */
struct proof_inputs study_proof_inputs(const struct scene *scene);

/* The same for the doubles that inputs are read as; proof_free either way. */
MUST_CHECK enum status study_prove_doubles(const struct study *s,
                                           struct proof *out);

/* Whether it does so for numbers of such records. */
bool study_proves(const struct record_type *type);

/* Lets go what contradicts the bars: the reason is that it does. */
void study_proof_withdraw(struct study_proof *p);

/* A second call is harmless. */
void study_proof_free(struct study_proof *p);
