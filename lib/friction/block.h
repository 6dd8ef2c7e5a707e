/*
 * block.h -- a rigid block on a slope under rate-and-state friction, (17), as
 * a planar system in the chart x = ln v, y = ln psi (y = psi where psi is a
 * logarithm).  v in units of V*, psi as in law.h, time in L/V*.
 */
#ifndef FRICTION_BLOCK_H
#define FRICTION_BLOCK_H

#include "field.h"
#include "planar.h"
#include "steady.h"
#include "tape_plane.h"

/* A law, its parameters and a slope, with the point its field is anchored at.
 * Copied as a whole. */
struct block {
    struct law law;
    struct material material;
    long double tan_alpha;
    struct anchor at; /* set by block_anchor */
    long double x, y; /* its place, to all digits that are known */
    struct planar_steady steady;
    struct tape_plane plane; /* of a law of formulas */
};

/* Law, material and slope; anchored at no point yet.  The parameters must
 * have passed law_check. */
void block_init(struct block *b, const struct law *law,
                const struct material *m, long double tan_alpha);

/* Puts the anchor on the steady-state curve at x = ln v.  `equilibrium`: x is
 * a root of the force balance, which then vanishes there exactly. */
void block_anchor(struct block *b, long double x, bool equilibrium);

/* The planar system around b's anchor; borrows b, which must not move.
 * Observables: slip, work, excess, as in enum block_observable. */
struct planar block_planar(const struct block *b);

/* The offset of the state (v, psi) as its doubles read: near the anchor to more
 * digits than a difference of logarithms has. */
struct vec2 block_offset(const struct block *b, double v, double psi);

/* At least |d psi_ss/d ln v| at the anchor. */
double block_psi_slope(const struct block *b);

/* mu(v, psi) at an offset from the anchor. */
double block_mu(const struct block *b, struct vec2 z);

/* eps^2 (v1^2 - v0^2)/2 - sin(alpha) slip + cos(alpha) work, (27), over the
 * largest of its four terms: zero along every exact orbit. */
double block_energy_defect(const struct block *b, double v0, double v1,
                           double slip, double work);

#endif
