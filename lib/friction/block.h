/*
 * block.h -- a rigid block on a slope under rate-and-state friction, (17), as
 * a planar system in the chart x = ln v, y = ln psi (y = psi where psi is a
 * logarithm).  v in units of V*, psi as in law.h, time in L/V*.
 */
#pragma once

#include "planar.h"
#include "steady.h"
#include "tape_plane.h"

/* Observables beyond time, in this order. */
enum block_observable {
    BLOCK_SLIP,   /* v: slip, units of L */
    BLOCK_WORK,   /* mu v: frictional work per normal force, units of L */
    BLOCK_EXCESS, /* v - v0: slip in excess of the anchor's, units of L */
    BLOCK_OBSERVABLES
};

/* What becomes of v as psi grows and nothing steady holds it: of laws of
 * formulas, see quasistatic.h. */
enum block_course {
    BLOCK_UNKNOWN, /* the formulas do not tell */
    BLOCK_NEVER,   /* it creeps */
    BLOCK_ENDLESS, /* v -> 0 as t -> inf, and so does the slip */
    BLOCK_SLOWLY,  /* as t -> inf, in a finite slip */
    BLOCK_SOON,    /* in a finite time */
    BLOCK_AT_ONCE  /* as fast as inertia lets it */
};
struct block_end {
    enum block_course course;
    double power; /* soon: v ~ (t0 - t)^power, or faster */
};

/* A law, its parameters and a slope, with the point its field is anchored at.
 * Copied as a whole. */
struct block {
    struct tape_plane plane; /* the field around the anchor: who has a block
                                has one of these */
    struct law law;
    struct material material;
    long double tan_alpha, tau; /* set by block_lean; tau: steady_tau */
    struct anchor at;           /* set by block_anchor */
    long double x, y;           /* its place, to all digits that are known */
    double bar; /* how far about x mu_ss stays within its noise of tan(alpha) */
    struct planar_steady steady;
    struct vec2 steep;    /* about the largest |d mu/dx| and |d mu/dy| */
    bool waits;           /* far above psi_ss psi has hardly a rate of its
                             own, or may have none: not of first order */
    bool traps;           /* v falls beside the anchor where psi is larger
                             and psi grows where v is smaller, and so on: the
                             quadrants of trap.h cannot be left */
    struct block_end end; /* of a law of formulas; set by block_ask */
};

/* Law, material and slope; anchored at no point yet.  The parameters must
 * have passed law_check. */
void block_init(struct block *b, const struct law *law,
                const struct material *m, long double tan_alpha);

/* Another slope; the anchor stays as it is until block_anchor. */
void block_lean(struct block *b, long double tan_alpha);

/* Puts the anchor on the steady-state curve at x = ln v.  `equilibrium`: x is
 * a root of the force balance, which then vanishes there exactly. */
void block_anchor(struct block *b, long double x, bool equilibrium);

/* Asks a law of formulas, from the anchor on, for steep, waits, traps and
 * end. */
void block_ask(struct block *b);

/* The planar system around b's anchor; borrows b, which must not move.
 * Observables: slip, work, excess, as in enum block_observable. */
struct planar block_planar(const struct block *b);

/* The offset of the state (v, psi) as its doubles read: near the anchor to more
 * digits than a difference of logarithms has. */
struct vec2 block_offset(const struct block *b, double v, double psi);

/* v and psi at these offsets from the anchor. */
double block_v(const struct block *b, double x);
double block_psi(const struct block *b, double y);

/* At least |d psi_ss/d ln v| at the anchor. */
double block_psi_slope(const struct block *b);

/* mu(v, psi) at an offset from the anchor. */
double block_mu(const struct block *b, struct vec2 z);

/* eps^2 (v1^2 - v0^2)/2 - sin(alpha) slip + cos(alpha) work, (27), over the
 * largest of its four terms: zero along every exact orbit. */
double block_energy_defect(const struct block *b, double v0, double v1,
                           double slip, double work);
