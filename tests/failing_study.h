/* failing_study.h -- studies that fail where a test wants it (dependency
 * failing_study: -Wl,--wrap=study_run_jobs). */
#pragma once

/* Slopes between these fail as no study yet did; none at first. */
extern double failing_slopes[2];
