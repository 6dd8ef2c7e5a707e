/*
 * eigen_end.h -- where a curve may stop being followed because what is left of
 * it is negligible: a limit of one coordinate while the other one grows.
 */
#ifndef RACE_EIGEN_END_H
#define RACE_EIGEN_END_H

#include "eigen_frame.h"

/* How the curve runs at a point: the coordinate that moves faster, and how
 * fast the other one and the integrals follow. */
struct eigen_heading {
    int ind;
    double at;    /* coordinate ind */
    double dep;   /* the other one */
    double slope; /* d dep/d ind */
    double swift[LOCAL_CARRY_MAX];
};

/* At the offset z, if `ind` (-1: the faster one) is taken to run. */
struct eigen_heading eigen_heading_at(const struct eigen_frame *g, int ind,
                                      struct vec2 z);

/* What is left beyond the point `now`. */
struct eigen_rest {
    double dep;
    double total[LOCAL_CARRY_MAX]; /* 0 where an integral does not converge */
};

/* Whether everything left is below `part` of dep and of total[]: exponentials
 * through the headings at two points, earlier and now; and no more than their
 * like anywhere along the asymptote, up to the edge of the domain. */
bool eigen_end_near(const struct eigen_frame *g,
                    const struct eigen_heading *earlier,
                    const struct eigen_heading *now, const double total[],
                    double part, struct eigen_rest *rest);

#endif
