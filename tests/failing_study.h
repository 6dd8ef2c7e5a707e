/* failing_study.h -- studies that fail where a test wants it (dependency
 * failing_study: -Wl,--wrap=study_run_jobs). */
#ifndef TESTS_FAILING_STUDY_H
#define TESTS_FAILING_STUDY_H

/* Slopes between these fail as no study yet did; none at first. */
extern double failing_slopes[2];

#endif
