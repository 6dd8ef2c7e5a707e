/*
 * rest_form.h -- how a block stops that nothing steady can hold: v -> 0 as far
 * as the law alone tells.
 *
 * Friction stays near tan(alpha) as long as psi can grow fast enough, so that
 * v = C e^(-b theta(psi)/a), and dpsi/dt = K(psi_ss(v) - psi)/T(v) becomes an
 * equation of v alone:
 *
 *     psi_ss    K       1/T -> const      1/T ~ v            1/T ~ e^(-psi_ss)
 *     1/v       first   (t0 - t)^p        t^-q or e^(-kt)    1/ln t
 *               sinh    as v can fall     as v can fall      1/ln t or t^-q
 *     -ln v     first   e^(-e^(kt))       1/(t ln t)         (= v)
 *               sinh    (t0 - t)^p        t^-a/b             (= v)
 *
 * with p = b/(b - a) for a logarithm of psi under 1/v and for psi itself under
 * -ln v, p = 1 for psi itself under 1/v.  Where friction falls without bound as
 * v -> 0 at psi_ss(v), the block does not stop but creeps, if ever so slowly.
 *
 * As v can fall: psi is the faster one, psi = psi_ss(v), and inertia alone
 * holds v above 0.  The slip of the others, int v dpsi/(dpsi/dt), has a limit
 * where v falls like an exponential, like t^-q with q > 1, or faster.
 */
#pragma once

#include <stdbool.h>

#include "block.h"
#include "fate.h"

struct rest_form {
    enum fate fate; /* FATE_REST_FINITE, FATE_REST_ASYMPTOTIC; FATE_CREEP: it
                       never stops; FATE_UNDECIDED: formulas do not tell */
    const char *reason; /* static: why it is none of the first two, else NULL */
    double power;  /* finite: v ~ (t0 - t)^power or falls even faster to 0; 1
                      at the least */
    bool inertial; /* finite, and by inertia */
    bool has_slip; /* a limit of slip: always where it is finite */
};

/* law and m: by law_check; not of formulas. */
struct rest_form rest_form_of(const struct law *law, const struct material *m);
/* Of any law; block_ask has looked at one of formulas. */
struct rest_form rest_form_at(const struct block *b);
