/*
 * proof_trap.h -- a place that no orbit leaves backward in the time of a tape,
 * which is the way in which a stable manifold is followed outward: around an
 * equilibrium z0, where V(z) = (z - z0)'Q(z - z0) <= level.
 *
 * Over the box of that ellipse let A be an enclosure of the Jacobian.  Where
 *     Q > 0  and  Q A + A'Q > 0  for every matrix in A,
 * dV/dt = (z - z0)'(Q A_z + A_z'Q)(z - z0) > 0 for z != z0, A_z the mean of the
 * Jacobian between z0 and z, which is in A: backward V falls along every orbit
 * in the ellipse, which therefore stays and tends to z0 (Lyapunov).
 */
#pragma once

#include "interval_tape.h"

struct proof_trap {
    struct interval at[2]; /* z0: an offset from the tape's anchor */
    double xx, xy, yy;     /* Q */
    double level;
};

/* Lowers the level until this is proved; false: at none. */
bool proof_trap_verify(struct interval_tape *t, struct proof_trap *trap);

/* Whether all of a box of offsets is in it. */
bool proof_trap_holds(const struct proof_trap *trap,
                      const struct interval z[2]);
