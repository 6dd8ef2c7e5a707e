/* ensemble_tolerance.h -- the tunable numbers of lib/ensemble. */
#pragma once

/* Draws that a thread takes at a time (batch.c): enough that what it sets up
 * for itself costs nothing, and few enough that it listens a hundred times a
 * second. */
#define BATCH_DRAWS 64

/* Draws of a block of the spool (spool.h): what is lost when a run is killed,
 * and what memory holds at a time. */
#define SPOOL_DRAWS 1024

/* Independent scramblings (draws.h).  The error of a mean over them is
 *
 *     t(0.975; 7) s/sqrt(8),
 *
 * s their standard deviation: more of them leave fewer draws to each, over
 * which alone the sequence is even; fewer let t grow. */
#define ENSEMBLE_REPEATS 8
#define ENSEMBLE_STUDENT 2.3646242515927849

/* Of the normal law: |mean - truth| <= 1.96 s/sqrt(n) in 95 of 100 samples; and
 * what was never met in n draws has a probability below 3.7/n as often:
 * (1 - p)^n >= 0.025. */
#define ENSEMBLE_NORMAL 1.9599639845400543
#define ENSEMBLE_NEVER  3.6888794541139363

/* Bins of a parameter for its share of the variance (shares.h): a power of two
 * up to SHARE_BINS, with m^3 <= SHARE_CUBE n of the n draws of a repeat, for
 * what varies within bins falls as 1/m^2 and what scatters between them grows
 * as m/n; below SHARE_LEAST there are too few. */
#define SHARE_BINS  64
#define SHARE_CUBE  8
#define SHARE_LEAST 4

/* Terms of the polynomial of threshold.h: of four scores all to the fifth
 * degree, for 2 terms^2 samples operations.  THRESHOLD_ROWS samples for each: a
 * fit of exact values by p coefficients is within a factor of the best one
 * where there are more than some p log p (Cohen, Davenport & Leviatan, Found.
 * Comput. Math. 13 (2013) 819-834).  What it errs by biases nothing. */
#define THRESHOLD_TERMS 128
#define THRESHOLD_ROWS  4
#define THRESHOLD_ROOM  (16 * THRESHOLD_TERMS)

/* P(|Z| > NORMAL_FAR) < 2^-52: as far as 1 can tell. */
#define NORMAL_FAR 8.3
