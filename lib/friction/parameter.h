/*
 * parameter.h -- how the block's vector field (17) changes with the parameters
 * of the model, at a fixed point (v, psi).
 */
#pragma once

#include "block.h"

enum parameter {
    PARAMETER_ALPHA, /* rad; eps2 stays as it is */
    PARAMETER_A,
    PARAMETER_B,
    PARAMETER_MU_STAR,
    PARAMETER_C,
    PARAMETER_R,
    PARAMETER_EPS2, /* eps^2 = V_star^2/(g L) */
    PARAMETERS
};

/* NULL where the field has a derivative by p that means something; else why
 * not, one plain sentence (static). */
const char *parameter_missing(const struct law *law, const struct material *m,
                              enum parameter p);

/* d field/d p * exp(-f->log_scale) for every p, in the chart (ln v, ln psi)
 * [(ln v, psi)], at an offset z from the anchor of the struct block that ctx
 * points to; f: the field there.  Zero where the law does not use p. */
void parameter_field(const void *ctx, struct vec2 z,
                     const struct planar_field *f, struct vec2 out[PARAMETERS]);
