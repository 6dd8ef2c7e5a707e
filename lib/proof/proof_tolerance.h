/*
 * proof_tolerance.h -- the knobs of lib/proof.  None of them can make a proof
 * wrong: they decide what is tried, never what is concluded.
 */
#pragma once

/* Bits of constants at the saddle: 100 more than a double's, so that its place
 * is known to 2^-53 of itself where mu_ss' is 2^-60 (alpha a rounding away from
 * a fold). */
#define PROOF_BITS 256

/* Second point of the first secant, in ln v: near a root of long double, apart
 * enough for 256 bits. */
#define PROOF_SECANT 0x1p-40

/* Secant steps: each gives 1.6 times the digits of the last, from 10 to 70 in
 * five, and slower at a fold. */
#define PROOF_NEWTONS 12

/* Half widths, in ln v, around an extremum of mu_ss that are tried, each four
 * times the last: dtau/dx changes its sign on them by some 1e-2 times that, and
 * is known to some 1e-16. */
#define PROOF_FOLD_LEAST 0x1p-46
#define PROOF_FOLD_MOST  0x1p-10

/* Half widths of the saddle's ln v that are tried, times 256 each. */
#define PROOF_PLACE_LEAST 0x1p-180
#define PROOF_PLACE_MOST  0x1p-40

/* Of the cone: shortened by this factor, so often, as long as its slope falls
 * to this part, as the thirtieth power of the length does. */
#define PROOF_CONE_SHRINK   0.7
#define PROOF_CONE_TRIES    60
#define PROOF_CONE_NARROWER 0.5

/* A cell is shortened where what Lagrange's remainder adds to the error, or to
 * the integral, is above this part of what is not known of it; others are made
 * so long that it would be this part of that, between these lengths of theta:
 * on a longer one the transverse rate differs much from its bound. */
#define PROOF_FELT       0.005
#define PROOF_AIM        0.1
#define PROOF_CELL_LEAST 0x1p-12
#define PROOF_CELL_MOST  0.5

/* A branch is followed no further through more cells: most have 100 to 250, of
 * a millisecond each. */
#define PROOF_CELLS 2048

/* A branch is closed as soon as what is left is below this part of the error,
 * and of the width of its integral, that are there. */
#define PROOF_END_PART 0.02

/* A part of a piece is halved where neither the slope over 1 nor its derivative
 * has a sign, at most so often: at the saddle to the 2^-40 of the cone that the
 * eigenvector is known to. */
#define PROOF_KNEE_HALVINGS 40

/* Boxes that are tried at a turn, each twice as wide as the last one needed. */
#define PROOF_TURN_TRIES 8

/* A line that is met before this theta of a piece is looked for beyond the end
 * of the piece before. */
#define PROOF_BEGINNING 0x1p-20

/* Levels of a trap that are tried, each this part of the last: ellipses half as
 * large, down to a millionth. */
#define PROOF_TRAP_TRIES  20
#define PROOF_TRAP_SHRINK 0.25

/* What the curves are grown to, and where their first series ends. */
#define PROOF_RTOL 1e-14
#define PROOF_TERM 1e-16

/* Bounds on what is left that are tried, each twice what the last one gave and
 * a number that is smaller than any that matters. */
#define PROOF_END_TRIES 40
#define PROOF_END_LEAST 1e-290
