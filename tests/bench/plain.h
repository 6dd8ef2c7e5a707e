/*
 * plain.h -- what a careful user writes with GSL: rk8pd on unit arc length in
 * (ln v, ln psi), saddle-centred differences, nothing overflows; x_excess as a
 * third component.  Laws dieterich_gen and spinodal_gen.
 */
#pragma once

#include "block.h"
#include "equilibrium.h"

struct plain {
    bool spinodal;
    double a, b, c, R, A; /* A = cos(alpha)/(eps^2 v_sp) */
    double v, psi;        /* saddle */
    double s0;            /* asinh form; 0: log form */
    double lambda;        /* stable eigenvalue */
    struct vec2 stable;   /* its direction */
    size_t calls;
};

struct plain plain_of(const struct block *b, const struct equilibrium *e);

/* d(ln v, ln psi)/dt over e^|psi - psi_ss|, whose logarithm is returned. */
double plain_field(const struct plain *p, double X, double Y, double f[2]);

struct plain_answer {
    double v_plus, v_minus, x_excess;
};

/* Both branches, to psi = 40 and ln(psi/psi_sp) = -34. */
struct plain_answer plain_branches(struct plain *p, double tol);

/* Seconds on a clock that only goes forward. */
double plain_now(void);

/* Seconds of the processor: what else runs on the machine matters little. */
double plain_worked(void);
