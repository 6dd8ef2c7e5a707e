/* crest.h -- the largest value of a function on [0, 1] that has few maxima. */
#ifndef STUDY_CREST_H
#define STUDY_CREST_H

/* Of samples (TOL_CREST_SAMPLES), then by golden section beside the best one
 * (Kiefer, Proc. AMS 4, 1953, 502-506), to TOL_CREST_WIDTH in t: it errs by
 * the square of that. */
double crest_of(double (*value)(const void *ctx, double t), const void *ctx);

#endif
