/*
 * law_typed.h -- a law whose components are formulas that people type: theta,
 * psi_ss, T and K of dpsi/dt = -K/T, or the whole rate; mu, or the form of
 * friction.  They may use v, psi, what came before them (d = psi - psi_ss), the
 * material's mu_star a b c R V_c and names of their own.
 */
#pragma once

#include "law_graph.h"
#include "law_tape.h"

enum { LAW_LETTERS = 512 };

/* A name of the law's own; not one of the model's.  Its value is that of the
 * material, of the same sign as this one, and as whole (law_typed_at). */
struct law_own {
    char name[FORMULA_NAME];
    double value;
    bool exponent; /* of what may be < 0: whole values have graphs of their own;
                      made, not set */
};

/* The first members are to be set; the rest is made of them.  Large. */
struct law_typed {
    char text[LAW_PARTS][LAW_LETTERS]; /* empty: not given */
    bool real;                         /* psi is a logarithm: any number */
    enum friction_form form;           /* where there is no mu */
    struct law_own own[LAW_OWNS];
    int owns;
    char swept[2][FORMULA_NAME + 16]; /* "material.NAME" of keys of sweeps */
    int sweeps;

    struct tape_lowered tape[2]; /* where v changes, and from an equilibrium */
    struct law_graph graph;
    _Atomic(struct law_typed *) next; /* owned: with other whole exponents */
};

/* Makes the rest.  STATUS_BAD_SCENE with a reason where a part, *wrong, cannot
 * be read or used; *wrong is LAW_PARTS where one is missing. */
MUST_CHECK enum status law_typed_make(struct law_typed *t, enum law_part *wrong,
                                      struct fault *why);

/* The same of names' values own[], of t or kept in it; NULL without memory. */
const struct law_typed *law_typed_at(struct law_typed *t, const double own[]);

/* Of the heap, with what law_typed_at keeps in it; NULL is nothing. */
void law_typed_free(struct law_typed *t);

/* The law; borrows t. */
struct law law_of_typed(const struct law_typed *t);

/* As law_text. */
const char *law_typed_text(const struct law_typed *t, enum law_part part);

/* A preset as formulas, to be made. */
void law_typed_of_preset(const struct law *preset, struct law_typed *out);

/* ---- for this folder ----------------------------------------------------- */

/* Extrema of mu_ss, ascending, at most 4. */
size_t law_typed_extrema(const struct law *law, const struct material *m,
                         long double x[4]);

/* The largest range of x around the middle in which psi_ss and mu_ss are. */
void law_typed_range(const struct law *law, const struct material *m,
                     long double *lo, long double *hi);
