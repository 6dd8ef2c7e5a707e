/*
 * eigen_drift.h -- how far a computed curve may have drifted off the true one:
 * errors made on the way, carried on by the linearised field.
 *
 * With t the unit tangent and n the unit normal at a point u, A = Df there, a
 * displacement delta along n goes as  d ln(delta)/ds = -(n A n)/|f|  along the
 * curve, outward against f; an integral's rate r/|f| meanwhile changes by
 * delta d(r/|f|)/dn.  Where f contracts backwards, old errors are forgotten.
 */
#ifndef RACE_EIGEN_DRIFT_H
#define RACE_EIGEN_DRIFT_H

#include "eigen_frame.h"

struct eigen_drift {
    double normal;                 /* in units of u */
    double total[LOCAL_CARRY_MAX]; /* of the integrals */

    /* At the last point, coordinates u with z = map u. */
    struct mat2 map;
    struct vec2 u, tangent;
    double growth; /* d ln(normal)/ds */
    double shift[LOCAL_CARRY_MAX];
    double noise[LOCAL_CARRY_MAX]; /* what rounding makes of d integral/ds */
};

/* At u = (u[0], u[1]): of the first leg, the drift to be set; of another one,
 * with what d held before in its coordinates. */
void eigen_drift_begin(struct eigen_drift *d, const struct eigen_frame *g,
                       struct mat2 map, const double u[]);
void eigen_drift_turn(struct eigen_drift *d, const struct eigen_frame *g,
                      struct mat2 map, const double u[]);

/* A step of length h to u; error[]: what it may itself have been off, in all
 * components. */
void eigen_drift_step(struct eigen_drift *d, const struct eigen_frame *g,
                      double h, const double u[], const double error[]);

/* What it makes of the coordinate that does not run (`ind` does). */
double eigen_drift_of_limit(const struct eigen_drift *d, int ind);

/* And of the coordinate that depends on the other at this point, the one the
 * curve is flatter in. */
double eigen_drift_of_point(const struct eigen_drift *d);

/* The same of all points of a step between two drifts; defect[]: of its
 * polynomial, in u. */
double eigen_drift_of_piece(const struct eigen_drift *before,
                            const struct eigen_drift *after,
                            const double defect[]);

#endif
