#include "tally.h"

#include <math.h>

void tally_add(struct tally *t, size_t repeat, double x)
{
    struct tally_part *p = &t->part[repeat];
    const double off = x - p->mean;

    p->count += 1.0;
    p->mean += off / p->count;
    p->squares += off * (x - p->mean);
}

/* All parts as one: Chan, Golub & LeVeque, Am. Stat. 37 (1983) 242-247. */
static struct tally_part all_of(const struct tally *t)
{
    struct tally_part all = { 0.0, 0.0, 0.0 };

    for (int r = 0; r < ENSEMBLE_REPEATS; r++) {
        const struct tally_part *p = &t->part[r];
        const double count = all.count + p->count, off = p->mean - all.mean;
        if (p->count == 0.0)
            continue;
        all.squares += p->squares + off * off * (all.count * p->count / count);
        all.mean += off * (p->count / count);
        all.count = count;
    }
    return all;
}

double tally_variance(const struct tally *t)
{
    const struct tally_part all = all_of(t);

    return all.count > 1.0 ? all.squares / (all.count - 1.0) : (double) NAN;
}

struct estimate tally_repeats(const double value[ENSEMBLE_REPEATS])
{
    struct tally t = { .part = { { 0.0, 0.0, 0.0 } } };

    for (int r = 0; r < ENSEMBLE_REPEATS; r++)
        tally_add(&t, 0, value[r]);
    const double variance = t.part[0].squares / (ENSEMBLE_REPEATS - 1);
    return (struct estimate){
        t.part[0].mean, ENSEMBLE_STUDENT * sqrt(variance / ENSEMBLE_REPEATS)
    };
}

struct estimate tally_mean(const struct tally *t, const struct draws *d)
{
    const struct tally_part all = all_of(t);
    double mean[ENSEMBLE_REPEATS];

    if (all.count == 0.0)
        return (struct estimate){ NAN, NAN };
    if (!d->is_sample && d->method == ENSEMBLE_GRID)
        return (struct estimate){ all.mean, NAN };
    for (int r = 0; r < ENSEMBLE_REPEATS; r++)
        mean[r] = t->part[r].count > 0.0 ? t->part[r].mean : (double) NAN;
    return (struct estimate){
        all.mean, draws_is_scrambled(d)
                      ? tally_repeats(mean).error
                      : ENSEMBLE_NORMAL * sqrt(tally_variance(t) / all.count)
    };
}

struct estimate tally_share(const struct tally *t, const struct draws *d)
{
    struct estimate e = tally_mean(t, d);

    e.error = isnan(e.error)
                  ? e.error
                  : fmin(fmax(e.error, ENSEMBLE_NEVER / all_of(t).count), 1.0);
    return e;
}
