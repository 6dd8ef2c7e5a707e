/* workprec_clock.h -- how long a piece of work takes: the median of repeats, of
 * batches far longer than a tick, without what asking the clock costs. */
#pragma once

/* Seconds of a call of `work`, which is called for about `budget` seconds, at
 * least once, where `once` is about what it takes.  `overhead`: of
 * workprec_clock_overhead. */
double workprec_clock_time(void (*work)(void *ctx), void *ctx, double once,
                           double budget, double overhead);

/* Seconds between two questions to the clock: their median. */
double workprec_clock_overhead(void);
