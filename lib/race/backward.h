/*
 * backward.h -- the stable manifold of a saddle once more, by a route that
 * shares nothing with grow.h but the field: no jets, but an orbit followed
 * backward in time (orbit.h), from so near to the saddle that its stable
 * eigenvector is the curve, to another end.
 */
#pragma once

#include "branch.h"
#include "monitor.h"

struct backward_options {
    double rtol; /* asked of the limits and integrals */
    size_t max_steps;
    struct carry carry;
    const struct monitor *monitor; /* borrowed, may be NULL */
};

struct backward_options backward_defaults(double rtol);

/* The half of the stable manifold towards larger x (side +1; larger y where it
 * leaves the saddle vertically) or smaller x (side -1), of the saddle `e` at
 * sys->origin; uses sys->field, sys->jacobian and sys->rate_gradient only.
 * Errors of limits, totals and pieces are what the orbit's steps and roundings
 * come to, carried by the linearised field (drift.h), and what the end adds;
 * they bound the whole error: steps, start, end and rounding of the curve, not
 * of the field.
 * STATUS_BAD_ARGUMENT: rtol not in (0, 1), side not +-1, too much to carry, the
 * saddle outside sys->domain;
 * STATUS_NOT_HYPERBOLIC: `e` has no such manifold, or equilibrium_is_beyond;
 * STATUS_NO_CONVERGENCE: no start is near enough, or no step is short enough;
 * STATUS_STOPPED; STATUS_NO_MEMORY.  On error *out is empty. */
MUST_CHECK enum status backward_branch(const struct planar *sys,
                                       const struct equilibrium *e, int side,
                                       const struct backward_options *o,
                                       struct branch *out);
