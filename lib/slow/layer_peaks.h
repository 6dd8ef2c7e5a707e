/*
 * layer_peaks.h -- the largest ln v and friction on the way onto the slow curve
 * (landing.h), step by step, into *l->out.
 */
#pragma once

#include "landing.h"

/* At the start, where the way on is known. */
void layer_peaks_start(struct landing *l);

/* On the step of length h from where it is to u1, which goes on along du1;
 * stages: of explicit8_try; across: how far off the orbit the step is at most.
 */
void layer_peaks_step(struct landing *l, double h, double across,
                      const struct explicit8 *stages, const double u1[],
                      const double du1[]);

/* Those to come of one that lands at p, the curve's point at y, `off` along its
 * fibre.  False: nearer to the curve they would be known better than *excess
 * says, as a part of what is wanted. */
bool layer_peaks_land(struct landing *l, const struct slow_point *p, double y,
                      double off, double *excess);

/* At the face of a box, `way` of its own from where it is, known to within
 * `error` along it. */
void layer_peaks_arrive(struct landing *l, double way, double error);

/* One more value. */
void layer_peak_raise(struct layer_peak *p, double value, double error);

/* How far off the largest is: it may be another one. */
double layer_peak_error(const struct layer_peak *p);
