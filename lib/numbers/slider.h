/*
 * slider.h -- a block that slides on a slope under rate-and-state friction,
 * (17), with the phase plane of its motion.
 */
#pragma once

#include "block.h"
#include "curve.h"
#include "numbers.h"
#include "phase_plane.h"

/* Must not move: the plane's system borrows the block. */
struct slider {
    struct block block; /* anchored where the plane is: at the saddle; without
                           one at a steady state, or without any somewhere on
                           the steady curve */
    struct phase_plane plane;
    double place; /* how far off the plane's origin may be, by noise of mu_ss */
    struct steady_number steady[EQUILIBRIA_MAX]; /* of each steady state */
    struct critical_numbers critical; /* none, until somebody finds them */
};

/* All steady states of the law, material and slope; they must have passed
 * law_check. */
void slider_init(struct slider *s, const struct law *law,
                 const struct material *m, long double tan_alpha);

/* The same for who asks for the saddle alone: where there is one, nodes are
 * counted, but what is said of them is nothing. */
void slider_init_saddle(struct slider *s, const struct law *law,
                        const struct material *m, long double tan_alpha);

/* STATUS_NOT_HYPERBOLIC, with *why, where the law has no derivative at a steady
 * state: a typed formula that has no real value beside it, as ln(v)^n with a
 * parameter n at v < 1. */
MUST_CHECK enum status slider_check(const struct slider *s, struct fault *why);

/* The index of the saddle, of which friction has at most one; -1: none. */
static inline int slider_saddle(const struct slider *s)
{
    return s->plane.saddles > 0 ? (int) s->plane.saddle[0] : -1;
}

/* Whether there is one saddle, whose quadrants v < v_sp, psi > psi_sp and
 * v > v_sp, psi < psi_sp cannot be left. */
static inline bool slider_traps(const struct slider *s)
{
    return s->plane.saddles == 1 && s->block.traps;
}

/* Why there are saddles and yet none of that kind: static; NULL: there is none
 * or one of that kind. */
const char *slider_no_traps(const struct slider *s);

/* Whether there is a saddle whose manifolds doubles can hold. */
bool slider_has_manifolds(const struct slider *s);

/* Why the saddle has no manifolds that doubles can hold: static; NULL: it has.
 */
const char *slider_no_manifolds(const struct slider *s);

/* The relative defect of the energy balance (27) along a whole curve whose
 * integrals are those of block.h, from component 3 on. */
double slider_energy_defect(const struct slider *s, const struct curve *c);

/* What the digits of the state at the offset z and of the steady states hide of
 * a coordinate, and how far the field is from its place with the origin: by
 * s->place everywhere. */
double slider_rounding(const struct slider *s, struct vec2 z);

/* Mean friction over a known slip between two slip rates: by (27)
 * tan(alpha) + eps^2 (v0^2 - v1^2)/(2 cos(alpha) slip), whatever happens in
 * between.  v1_part: how wrong v1 is, relative. */
struct quantity slider_mean_friction(const struct slider *s, double v0,
                                     double v1, double v1_part,
                                     const struct quantity *slip);
