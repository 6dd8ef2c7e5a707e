/*
 * law_typed.h -- a law whose components are formulas that people type: theta,
 * psi_ss, T and K of dpsi/dt = -K/T, or the whole rate; mu, or the form of
 * friction.  They may use v, psi, what came before them (d = psi - psi_ss), the
 * material's mu_star a b c R V_c and names of their own.
 */
#ifndef FRICTION_LAW_TYPED_H
#define FRICTION_LAW_TYPED_H

#include "law_tape.h"
#include "response.h"

enum { LAW_LETTERS = 512, LAW_VALUES = 28 };

/* Two of its values. */
enum { LAW_LNV0 = 9, LAW_Y0 = 10 };

/* In the order in which each may use those before it. */
enum law_part {
    LAW_THETA,
    LAW_PSI_SS,
    LAW_T,
    LAW_K, /* of d; K(d) = d unless given */
    LAW_MU,
    LAW_RATE, /* dpsi/dt; or T and K; alone: psi_ss is where it is 0 */
    LAW_PARTS
};

/* A name of the law's own; not one of the model's.  Its value is that of the
 * material, of the same sign as this one. */
struct law_own {
    char name[FORMULA_NAME];
    double value;
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
    struct formula steady;       /* of lnv0 and y0, and what it gives: */
    int y, psi, mu;
    struct formula plain; /* the same, at any state, and what it gives: */
    int theta, psi_rate, chart_rate[2]; /* theta 0: there is none */
    struct formula growth; /* the same, where there is a rate alone: */
    int rate;              /* dpsi/dt anywhere */
};

extern const char *const law_part_names[]; /* "theta" ..., NULL-ended */

/* Makes the rest.  STATUS_BAD_SCENE with a reason where a part, *wrong, cannot
 * be read or used; *wrong is LAW_PARTS where one is missing. */
MUST_CHECK enum status law_typed_make(struct law_typed *t, enum law_part *wrong,
                                      struct fault *why);

/* The law; borrows t. */
struct law law_of_typed(const struct law_typed *t);

/* A preset as formulas, to be made. */
void law_typed_of_preset(const struct law *preset, struct law_typed *out);

/* ---- for this folder ----------------------------------------------------- */

/* All names that its formulas may have, at x = ln v and y, ended by none. */
void law_typed_values(const struct law_typed *t, const struct material *m,
                      long double tan_alpha, formula_real x, formula_real y,
                      struct formula_value out[LAW_VALUES]);

struct typed_steady {
    long double y, psi, mu; /* chart's y, psi_ss and mu_ss at x = ln v */
};
struct typed_steady law_typed_steady(const struct law *law,
                                     const struct material *m, long double x);

/* The same at many x, sooner: what does not change with x is made once. */
struct typed_curve {
    const struct law *law;    /* borrowed */
    const struct material *m; /* borrowed */
    long double value[FORMULA_NODES];
    short changing[FORMULA_NODES], of_mu[FORMULA_NODES];
    int count, count_mu; /* of them */
    formula_real exact[FORMULA_NODES];
    bool is_exact; /* exact[] is made */
};
void law_curve_init(struct typed_curve *c, const struct law *law,
                    const struct material *m);
struct typed_steady law_curve_at(struct typed_curve *c, long double x);
/* As law_typed_slope. */
formula_real law_curve_slope(struct typed_curve *c, long double x);

/* The same in 113 bits. */
struct typed_steady_quad {
    formula_real y, psi, mu;
};
struct typed_steady_quad law_typed_steady_quad(const struct law *law,
                                               const struct material *m,
                                               formula_real x);

/* d mu_ss/dx in 113 bits, to 1e-16 of its scale */
formula_real law_typed_slope(const struct law *law, const struct material *m,
                             long double x);

/* Extrema of mu_ss, ascending, at most 4. */
size_t law_typed_extrema(const struct law *law, const struct material *m,
                         long double x[4]);

/* The largest range of x around the middle in which psi_ss and mu_ss are. */
void law_typed_range(const struct law *law, const struct material *m,
                     long double *lo, long double *hi);

/* As response_at. */
struct response law_typed_response(const struct law *law,
                                   const struct material *m, long double x);

/* Whether a name of the model or of its own can change anything. */
bool law_typed_uses(const struct law_typed *t, const char *name);

/* As law_formula. */
void law_typed_formula(const struct law_typed *t, char *text, size_t size);

/* As block_anchor; false where a formula has no value there. */
bool law_typed_anchor(const struct law *law, const struct material *m,
                      long double tan_alpha, long double x, bool equilibrium,
                      struct tape_plane *plane);

#endif
