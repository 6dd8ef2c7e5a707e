/* slow_tolerance.h -- the tunable numbers of lib/slow. */
#pragma once

#include "motion_tolerance.h"

/* The slow curve (slow_curve.c), whose orbit is as accurate as that of a rest,
 * TOL_REST_WRONG; to TOL_COARSEST one that is coarser by TOL_FINER must
 * agree on what is left of a rest.  Steps, in e-folds of the slopes of time and
 * slip (and TOL_NEARBY in ln psi), that polynomials of degree 5 bear to 1e-11,
 * at most TOL_BRANCH_STEPS; how much of what twice the step misses one step
 * may, but for rounding; the ratio of the slow rate to the fast one below which
 * slopes are mostly noise, where curvatures come from knots not nearer than
 * TOL_SHARE of an interval, and below which they are those of the eigenvector.
 */
#define TOL_SLOW_STEP   0.035
#define TOL_SLOW_MISSED 0.05
#define TOL_SLOW_NOISY  1e-5
#define TOL_SLOW_ALONG  1e-8

/* Beyond a node: nearest and furthest start in ln psi, growth of the
 * steps to it, on which any orbit is after TOL_SETTLED; the ratios below which
 * rounding in x or y, being the fast one, shows in the other; and how near the
 * end of a branch none lands, arriving first. */
#define TOL_SLOW_NEAREST     0.02
#define TOL_SLOW_FURTHEST    15.0
#define TOL_SLOW_GAP_LEAST_X 1e-14
#define TOL_SLOW_GAP_LEAST_Y 1e-11
#define TOL_SLOW_CLEAR       0.003
#define TOL_SLOW_STRIDE      1.1

/* Series at the saddle (saddle_series.c): their last terms are TOL_ROUNDED
 * of the first where they end, at most TOL_NEARBY out, or TOL_SHARE of the way
 * to a box of arrest; how near to 1 orders, in units of the ratio of the
 * eigenvalues, may come to a resonance. */
#define TOL_SADDLE_APART 0.8

/* Inside a box of arrest it is run to TOL_SEEN of that, where the node is as
 * good as linear (and a runaway TOL_SERIES_RADIUS_MAX far in ln psi: fields
 * next to the separatrix need no more). */

/* Terms that round: of the field (a coordinate by TOL_ROUNDING); and, where an
 * orbit meets a box of arrest off the slow curve, of the face: its node and the
 * origin, whose difference is rounded, and the field's zero. */
#define TOL_SLOW_TERMS 2.0

/* The fast layer (layer_lanes.c, landing.c): landing distance, TOL_NEARBY, and
 * closer for what is finer than TOL_COARSEST (no box of arrest, and TOL_SEEN
 * of it, must be between); how much later or earlier at most a box is entered
 * for what is then left of the distance, in what is left; steps, the first of a
 * landing's distance and none below TOL_TOUCH; the least error that tells
 * anything on the next step. Bars: what the fibre's curvature and the slow
 * rates change of what it corrects (measured: errors are 0.5 of that at most,
 * half of them 0.1), and how far off an orbit a step is, of what is known of it
 * at the ends (a corner is within one, and on stiff ones all terms may be
 * small: 4.2 by 113 bits). */
#define TOL_LAYER_CLOSER    0.01
#define TOL_LAYER_FORGET    4.0
#define TOL_LAYER_STEPS     500
#define TOL_LAYER_FLOOR     1e-8
#define TOL_LAYER_GROWTH    2.0
#define TOL_LAYER_BEND      3.0
#define TOL_LAYER_TRANSPORT 6.0

/* What a step of order 8 misses (landing_weigh.h): this times its terms of
 * order 6 and 7 times r^3, r the ratio in which terms fall; ten times what
 * integrals of powers have.  r^2 over the term of order 6 by those from order 4
 * on: what the latter's estimate has of the term of order 4 of an integral; and
 * the largest r^3, where terms grow. */
#define TOL_LAYER_MISSED 2.4e-3
#define TOL_LAYER_FOURTH 0.1
#define TOL_LAYER_FALL   30.0

/* How well what a step makes of a unit across is known (landing.c), as a part
 * of what it changes. */
#define TOL_LAYER_BLUR 0.3

/* It lands only where the fibre's part of the bar is within TOL_SHARE of what
 * was promised (finer tries aim at it, too), and its place is clearly known
 * beside the way to it; or TOL_ROOT near, for friction this near; nearer by
 * TOL_RETRY at most at once, and by TOL_SHARE towards a peak beside the
 * curve. */
#define TOL_LAYER_MU_TOUCH 1e-9

/* A box of arrest is come nearer by TOL_STEP_SAFETY of the way.  Nearer than
 * TOL_SEEN its face is aimed at; reached within TOL_TOUCH, and only by an
 * orbit that does not pass far along it as it closes, so many of its errors
 * from every corner (what is as far is surely there); others are let pass until
 * they touch it; and where nothing beyond the face may be seen the part of the
 * way that is gone at once (a step that went through is taken again, shorter by
 * TOL_ORBIT_RETREAT). */
#define TOL_LAYER_SHORT  0.97
#define TOL_LAYER_CORNER 10.0

/* What part of the step that its error allows is taken: more are refused, and
 * bars grow, where it is more. */
#define TOL_LAYER_SAFETY 0.8

/* Many states by the slow curve (fast_cells.c).  One whose bars are too wide
 * is tried finer; above what part of its bars a try has left one
 * TOL_RETRY times, and then no more, for they are the table's
 * (TOL_CELLS_GAIN), down to TOL_RTOL_DEFAULT. */

/* Peaks are sampled for patches no finer than TOL_ROOT, for at a peak what an
 * orbit is off shows by its square, with bars so many times as wide. */
#define TOL_FAST_LOOSE 10.0

/* Cells run to their fates (cells.c).  Orbits are first followed to TOL_PART of
 * the accuracy asked for, at most TOL_COARSEST (looser ones miss
 * where a block rests), then finer by TOL_FINER, down to TOL_RTOL_DEFAULT, as
 * long as bars shrink to this part. */
#define TOL_CELLS_GAIN 0.7

/* Patches (patch_poly.c, patchwork.c).  Accuracy of the samples, as a part of
 * what is asked for: of a part that small bars can be had next to the
 * separatrix; and the slowest that coefficients fall, two by two. */
#define TOL_PATCH_SAMPLES 0.002
#define TOL_PATCH_SLOWEST 0.9

/* A patch holds where no more cells than it has nodes are left for being too
 * near the separatrix; the excess of most samples, not all, says how far it
 * is from that (and no more than this is believed). */
#define TOL_PATCH_MOST   0.7
#define TOL_PATCH_EXCESS 1e9

/* Cuts: pieces of so many cells a node are too small; tests at least; a side
 * whose tail has TOL_SHARE of the bound is cut, but not if it is this far below
 * the other's, into fewer parts than the tails ask for (TOL_AIM), for they
 * decay the faster the shorter a side is. */
#define TOL_PATCH_SMALLEST    1.5
#define TOL_PATCH_LEAST_TESTS 6
#define TOL_PATCH_ASIDE       1e-3
