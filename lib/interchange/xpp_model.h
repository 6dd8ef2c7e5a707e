/*
 * xpp_model.h -- a model of XPPAUT, an .ode file, as a planar system.
 *
 * Read: x' = , dx/dt = , x(0) = , init, par (param, p), number, !derived,
 * name = formula, f(x) = formula, @ options (the window of x against y, an
 * angle by fold and tor_per), done; comments, \ at line ends, ** and log as ^
 * and ln; capitals do not count.  Functions are written out; names that the
 * rates do not need are left.  Not needed, so left: aux, set, only, bdry.  A
 * forcing whose amplitude is 0 is none: that parameter is 0 for good then.
 *
 * Refused with a line and a reason: what is not planar (three variables,
 * delays, Volterra, tables, arrays, algebraic equations), not autonomous (t),
 * not a flow (maps, jumps, noise, Markov) or not analytic (if, heav, abs, ...).
 */
#pragma once

#include "system.h"

enum { XPP_STATEMENTS = 500, XPP_DECIMAL = 40, XPP_SIZE = 200000 };

struct xpp_model {
    struct formula_system system;
    char decimal[SYSTEM_PARAMETERS][XPP_DECIMAL]; /* as typed */
    double start[2];                              /* at time 0 */
    double lo[2], hi[2]; /* what XPPAUT shows, or the place around start[] */
};

/* Reads a file's text; `name` is how messages call it.  STATUS_BAD_SCENE with
 * one line; STATUS_NO_MEMORY. */
MUST_CHECK enum status xpp_model_read(const char *text, const char *name,
                                      struct xpp_model *out, struct fault *why);

/* The model as a scene with `system:`, allocated; NULL without memory. */
char *xpp_model_scene(const struct xpp_model *m, const char *title);
