/*
 * law.h -- rate-and-state friction laws as compositions (Putelat & Dawes 2015,
 * eqs (2)-(10), (44), (45)):
 *
 *     mu(v, psi) from theta(psi),      dpsi/dt = -K(psi - psi_ss(v)) / T(v).
 *
 * A law names one of each component; a preset is a law with a name.  v is in
 * units of V_star; psi has none.  Adding a preset is one line of a table in
 * law.c; docs/new_law.md tells what a new component takes.
 */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "status.h"

/* How friction depends on the slip rate at a given state. */
enum friction_form {
    FRICTION_ASINH, /* (4a): a asinh((v/2) exp((mu_star + b theta)/a)) */
    FRICTION_LOG,   /* (2):  mu_star + a ln v + b theta */
    FRICTION_FORMS
};

/* How it depends on the state. */
enum theta {
    THETA_LN_PSI,       /* ln psi */
    THETA_PSI,          /* psi; psi is real, everywhere else psi > 0 */
    THETA_LN_C_PSI,     /* ln(c + psi) */
    THETA_LN_C_1PR_PSI, /* ln(c + (1 + R) psi) */
    THETAS
};

/* The state in steady sliding at v. */
enum psi_ss {
    PSI_SS_INVERSE,       /* 1/v */
    PSI_SS_MINUS_LOG,     /* -ln v */
    PSI_SS_SPINODAL,      /* (1 + R)/(1 + R v) */
    PSI_SS_SPINODAL_UNIT, /* 1/(1 + R v) */
    PSI_SS_LAMBERT,       /* exp(W(exp(-v/V_c)))/v: Kato-Tullis only */
    PSI_SSES
};

/* T(v): how long the state takes to follow, in L/V_star. */
enum timescale {
    TIMESCALE_SLIP,     /* 1/v */
    TIMESCALE_SPINODAL, /* R/(1 + R v) */
    TIMESCALE_AGEING44, /* R psi_ss(v), (44) */
    TIMESCALE_SLIP45,   /* R exp(psi_ss(v)), (45) */
    TIMESCALES
};

/* ln(1/T) is a sum, each term so many times: what closed forms of T are made
 * of. */
struct timescale_terms {
    int ln_r; /* ln(1/R) */
    int ln_v;
    int ln_r_plus_v; /* ln(1/R + v) */
    int ln_psi_ss;
    int psi_ss; /* -1 or 0 */
};

/* By enum timescale. */
extern const struct timescale_terms timescale_terms[TIMESCALES];

/* How: dpsi/dt = -K(psi - psi_ss)/T. */
enum kinetics {
    KINETICS_LINEAR, /* K(d) = d: first order */
    KINETICS_SINH,   /* K(d) = sinh d: hyperbolic */
    /* dpsi/dt = exp(-v/V_c) - v psi ln(v psi), Kato & Tullis (2001) */
    KINETICS_COMPOSITE,
    KINETICSES
};

/* One of each. */
struct law {
    const char *preset;   /* "dieterich_gen", or "composed" */
    const char *words;    /* "Generalised Dieterich law" */
    const char *equation; /* the paper's number, or a source */
    enum friction_form form;
    enum theta theta;
    enum psi_ss psi_ss;
    enum timescale timescale;
    enum kinetics kinetics;
    /* Borrowed, or NULL.  Its formulas then count; theta still tells whether
     * psi is a logarithm and form the mu if none is given, the other components
     * say nothing. */
    const struct law_typed *typed;
};

struct law_typed; /* law_typed.h */

/* Which composition it is, from 0 on. */
enum {
    LAW_COMPOSITIONS =
        FRICTION_FORMS * THETAS * PSI_SSES * TIMESCALES * KINETICSES
};
static inline size_t law_composition(const struct law *law)
{
    size_t i = (size_t) law->form * THETAS + law->theta;

    i = i * PSI_SSES + law->psi_ss;
    return (i * TIMESCALES + law->timescale) * KINETICSES + law->kinetics;
}

/* A law's formulas, in the order in which each may use those before it. */
enum law_part {
    LAW_THETA,
    LAW_PSI_SS,
    LAW_T,
    LAW_K,    /* of d = psi - psi_ss; K(d) = d unless given */
    LAW_MU,   /* or that of the form */
    LAW_RATE, /* dpsi/dt; or T and K; alone: psi_ss is where it is 0 */
    LAW_PARTS
};
extern const char *const law_part_names[]; /* "theta" ..., NULL-ended */

enum { LAW_OWNS = 16 };

/* Parameters; all dimensionless but L (m), V_star (m/s), g (m/s^2).  R may be
 * infinite.  A law ignores what it does not use. */
struct material {
    double mu_star, a, b, c, R, V_c, L, V_star, g;
    double own[LAW_OWNS]; /* of names of a law's own, see law_typed.h */
};

/* The members of struct material that scenes and sweeps name. */
enum material_key {
    MATERIAL_MU_STAR,
    MATERIAL_A,
    MATERIAL_B,
    MATERIAL_C,
    MATERIAL_R,
    MATERIAL_V_C,
    MATERIAL_L,
    MATERIAL_V_STAR,
    MATERIAL_G,
    MATERIAL_KEYS
};

/* Table 2: Bristol paper board (Heslot et al. 1994), g = 9.81 m/s^2; V_c = 1
 * (Table 2 has none). */
struct material material_bristol_board(void);

/* "mu_star" ... "V_star", "g". */
const char *material_key_name(enum material_key key);
double *material_member(struct material *m, enum material_key key);

/* Whether the value of `key`, or of a name of the law's own, can change
 * anything the law computes. */
bool law_uses(const struct law *law, enum material_key key);
bool law_uses_name(const struct law *law, const char *name);

/* psi itself plays the part of a logarithm (theta = psi), so the chart is
 * (ln v, psi) instead of (ln v, ln psi). */
static inline bool law_psi_is_log(const struct law *law)
{
    return law->theta == THETA_PSI;
}

/* Those of the law's T. */
static inline const struct timescale_terms *law_timescale(const struct law *law)
{
    return &timescale_terms[law->timescale];
}

/* T has exp(psi_ss) with psi_ss > 0, (45): the state freezes as v -> 0. */
static inline bool law_freezes(const struct law *law)
{
    return law_timescale(law)->psi_ss && law->psi_ss != PSI_SS_MINUS_LOG;
}

/* K = sinh and theta a logarithm of psi, as the paper's estimates have it. */
bool law_is_hyperbolic(const struct law *law, const struct material *m);

/* psi_ss is (1 + R)/(1 + R v) or 1/(1 + R v). */
bool law_is_spinodal(const struct law *law, const struct material *m);

/* eps^2 = V_star^2 / (g L), below (17). */
double material_eps2(const struct material *m);

/* eta = R/(1 + R) for laws with R, 1 for the others; below (26). */
double law_eta(const struct law *law, const struct material *m);

/* The presets, asinh form, in the order of the paper; NULL past the end. */
const struct law *law_preset_at(size_t i);
/* By name; NULL if there is none. */
const struct law *law_preset_find(const char *name);

/* Names as in scenes: "asinh", "ln_psi", ...  NULL-ended lists, indexed by the
 * enums above (PSI_SS_LAMBERT and KINETICS_COMPOSITE are no scene words). */
extern const char *const friction_form_names[];
extern const char *const theta_names[];
extern const char *const psi_ss_names[];
extern const char *const timescale_names[];
extern const char *const kinetics_names[];

/* A formula of the law, as scenes have it; NULL: it is not given.  All that is
 * computed of fields is computed of these. */
const char *law_text(const struct law *law, enum law_part part);
/* mu, given or of the form. */
const char *law_text_mu(const struct law *law);

/* The given ones as one readable line, e.g.
 * "theta = ln(psi), psi_ss = 1/v, T = 1/v, K = sinh(d)". */
void law_formula(const struct law *law, char *text, size_t size);

/* STATUS_BAD_ARGUMENT, with the reason, where the composition or a parameter
 * makes no sense: a, b, L, V_star, g, R, V_c > 0, c >= 0, mu_star finite; R
 * infinite only where the limit exists; (44) needs psi_ss > 0. */
MUST_CHECK enum status law_check(const struct law *law,
                                 const struct material *m, struct fault *why);
