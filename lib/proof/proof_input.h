/* proof_input.h -- inputs of a scene as what they are taken for, enclosed. */
#pragma once

#include <mpfi.h>
#include <stdbool.h>

#include "interval.h"
#include "unit.h"

/* What the numbers of a scene are taken for. */
struct proof_inputs {
    bool decimal; /* the shortest decimals that read as these doubles; else
                     the doubles themselves */
    enum unit_angle slope_in;
    double slope;           /* as it was given */
    const char *slope_text; /* borrowed: its decimal; NULL: the shortest */
    const double *far;      /* borrowed: psi to which an open branch's tube is
                               followed; NULL: not at all */
    bool skip[2];           /* upper, lower: the branch is not asked for */
};

/* To the precision of `out`. */
void proof_input(mpfi_ptr out, double x, bool decimal);
void proof_slope(mpfi_ptr tan_alpha, const struct proof_inputs *in);

/* The doubles around such a decimal, and around tan(alpha). */
struct interval proof_decimal(double x);
struct interval proof_tangent(const struct proof_inputs *in);
