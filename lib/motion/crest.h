/* crest.h -- the largest value of a function that has few maxima. */
#pragma once

/* Between lo and hi, where it has one maximum, by golden section (Kiefer, Proc.
 * AMS 4, 1953, 502-506), to the width in t: it errs by the square of that. */
double crest_between(double (*value)(const void *ctx, double t),
                     const void *ctx, double lo, double hi, double width);

/* On [0, 1]: of samples (TOL_EVENT_SAMPLES), then beside the best one, to
 * TOL_ROOT; *at (may be NULL): where, as nearly. */
double crest_of(double (*value)(const void *ctx, double t), const void *ctx,
                double *at);
