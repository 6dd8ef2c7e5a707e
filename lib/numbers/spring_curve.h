/* spring_curve.h -- the stick-slip boundary of a block pulled through a spring,
 * over the speed of pulling (spring_block.h, Fig 1(b)). */
#pragma once

#include "extremum.h"
#include "spring_block.h"
#include "status.h"

/* None where steady sliding is stable at any stiffness. */
struct spring_point {
    double v;                      /* pulling speed in units of V_star */
    struct quantity k;             /* Pa/m, with the block's inertia */
    struct quantity k_quasistatic; /* Pa/m, without */
};

extern const struct record_type record_spring;

struct spring_curve {
    struct spring_block block;
    struct spring_point *at; /* owned; ascending in v */
    size_t count;
    struct extremum extremum[EXTREMA_MAX]; /* of mu_ss: where k_c is 0 */
    size_t extrema;
};

/* From v[0] to v[1], as far as there are steady states, evenly in ln v.
 * STATUS_NO_MEMORY leaves *c empty. */
MUST_CHECK enum status spring_curve_find(const struct spring_block *block,
                                         const struct law *law,
                                         const struct material *m,
                                         const double v[2],
                                         struct spring_curve *c);

/* A second call is harmless. */
void spring_curve_free(struct spring_curve *c);
