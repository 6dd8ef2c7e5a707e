/*
 * law_graph.h -- what the formulas of a law are at a state, steady or any, as
 * one graph of x = ln v and the chart's y: of the presets and of those that
 * people type.
 */
#pragma once

#include "formula.h"
#include "law.h"
#include "status.h"

/* What can be asked for. */
enum law_number {
    LAW_AT_Y,      /* the chart's y */
    LAW_AT_PSI,    /* the state itself */
    LAW_AT_MU,     /* friction */
    LAW_AT_MU_LOG, /* (2), mu_star + a ln v + b theta: the mu of a law that has
                      one of its own */
    LAW_AT_THETA,  /* where there is one */
    LAW_AT_GROWTH, /* dpsi/dt */
    LAW_AT_DX,     /* d ln v/dt */
    LAW_AT_DY,     /* dy/dt */
    LAW_NUMBERS
};

/* Nodes in the order in which they are made, leaves left out. */
struct law_steps {
    short node[FORMULA_NODES];
    int count;
};

struct law_graph {
    struct formula f;
    int node[LAW_NUMBERS]; /* 0: there is none */
    int x, y, psi;         /* leaves, and psi of y */
    int y_ss, psi_ss;      /* of x; -1: psi is steady where its growth is 0 */
    struct law_steps steady, then[LAW_NUMBERS]; /* these two, and the rest */
};

/* Of a law that can be used. */
void law_graph_make(const struct law *law, struct law_graph *out);

/* That of a law: a composition's is made once and kept as long as the program
 * runs; where there is no memory for it, in *room. */
const struct law_graph *law_graph_kept(const struct law *law,
                                       struct law_graph *room);

/* Its numbers, in long double and in 113 bits.  Large. */
#define LAW_POINT(T, K)                                                        \
    struct law_##K {                                                           \
        const struct law *law;    /* borrowed */                               \
        const struct material *m; /* borrowed */                               \
        const struct law_graph *g;                                             \
        T value[FORMULA_NODES], slope[FORMULA_NODES];                          \
        struct law_graph room;                                                 \
    };                                                                         \
    void law_##K##_init(struct law_##K *p, const struct law *law,              \
                        const struct material *m, T tan_alpha);                \
    /* At any state, and where psi stands still; NaN where it does nowhere. */ \
    T law_##K##_at(struct law_##K *p, T x, T y, enum law_number what);         \
    T law_##K##_steady(struct law_##K *p, T x, enum law_number what);          \
    /* Something else there. */                                                \
    T law_##K##_also(struct law_##K *p, enum law_number what);                 \
    /* How what was asked for last changes there with a leaf; y stays. */      \
    T law_##K##_by(struct law_##K *p, enum law_number what, int leaf);         \
    /* d/dx along the steady curve: that of y; of what was asked for last. */  \
    T law_##K##_climb(struct law_##K *p, T x);                                 \
    T law_##K##_along(struct law_##K *p, T x, enum law_number what)

LAW_POINT(long double, long);
LAW_POINT(formula_real, quad);

/* How far what law_long_steady and law_long_also have just found is off for its
 * arithmetic is rounded, to first order (formula_long_roundings). */
long double law_long_rounding(struct law_long *p, enum law_number what);

/* Of a law that is typed as dpsi/dt alone, psi_ss(v), where that is 0: the
 * chart's y at x = ln v; NaN where it is 0 at no psi. */
long double law_root(struct law_long *p, long double x);
/* The same to 113 bits. */
formula_real law_root_quad(struct law_quad *p, formula_real x);

/* STATUS_BAD_SCENE with a reason where psi_ss is no function of v as far as a
 * search can tell: dpsi/dt is 0 at no psi, or at several, or psi leaves where
 * it is 0. */
MUST_CHECK enum status law_root_check(const struct law *law,
                                      const struct material *m,
                                      struct fault *why);
