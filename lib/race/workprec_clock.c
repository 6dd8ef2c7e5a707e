#include "workprec_clock.h"

#include <math.h>
#include <stdlib.h>

#include "clock.h"
#include "workprec_tolerance.h"

enum { QUESTIONS = 501 };

static int compare(const void *a, const void *b)
{
    const double x = *(const double *) a, y = *(const double *) b;

    return (x > y) - (x < y);
}

static double median(double value[], size_t n)
{
    qsort(value, n, sizeof *value, compare);
    return value[n / 2];
}

double workprec_clock_overhead(void)
{
    double gap[QUESTIONS];

    for (int i = 0; i < QUESTIONS; i++) {
        const double before = clock_seconds();
        gap[i] = clock_seconds() - before;
    }
    return median(gap, QUESTIONS);
}

double workprec_clock_time(void (*work)(void *ctx), void *ctx, double once,
                           double budget, double overhead)
{
    const double batch = fmax(1.0, ceil(WORKPREC_BATCH / once));
    const double all = fmin(floor(budget / (once * batch)), WORKPREC_REPEATS);
    const size_t repeats = all > 1.0 ? (size_t) all : 1;
    double seconds[WORKPREC_REPEATS];

    for (size_t i = 0; i < repeats; i++) {
        const double start = clock_seconds();
        for (size_t k = 0; k < (size_t) batch; k++)
            work(ctx);
        seconds[i] = (clock_seconds() - start - overhead) / batch;
    }
    return median(seconds, repeats);
}
