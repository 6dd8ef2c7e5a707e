#include "shares.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "quantile.h"

/* Values of Y in one bin of one repeat. */
struct bin {
    double count, sum;
};

struct shares {
    const struct spool *spool;
    const struct draws *d;
    size_t bins;
    double edge[SHARE_BINS];
    struct bin bin[ENSEMBLE_REPEATS][SHARE_BINS];
    double squares[ENSEMBLE_REPEATS]; /* sum of Y^2 */
};

static size_t bin_of(const struct shares *s, double x)
{
    size_t lo = 0, hi = s->bins; /* edge[lo - 1] < x <= edge[hi - 1] */

    while (hi - lo > 1) {
        const size_t middle = (lo + hi) / 2;
        *(x > s->edge[middle - 1] ? &lo : &hi) = middle;
    }
    return lo;
}

/* A power of two. */
static size_t bins_for(const struct spool *s)
{
    const size_t each = s->shape.draws / ENSEMBLE_REPEATS;
    size_t bins = 1;

    while (bins < SHARE_BINS && 8 * bins * bins * bins <= SHARE_CUBE * each)
        bins *= 2;
    return bins;
}

static enum status find_edges(struct shares *s, size_t key, struct fault *why)
{
    double p[SHARE_BINS];

    for (size_t i = 0; i + 1 < s->bins; i++)
        p[i] = (double) (i + 1) / (double) s->bins;
    return quantile_find(s->spool, SPOOL_KEY, key, p, s->bins - 1, s->edge,
                         why);
}

static enum status fill(struct shares *s, size_t key, size_t number,
                        double center, struct fault *why)
{
    double *x = malloc(2 * SPOOL_DRAWS * sizeof *x), *y = x + SPOOL_DRAWS;
    int8_t *code = malloc(SPOOL_DRAWS);
    enum status status = x && code ? STATUS_OK : STATUS_NO_MEMORY;

    memset(s->bin, 0, sizeof s->bin);
    memset(s->squares, 0, sizeof s->squares);
    for (size_t b = 0; b < spool_blocks(s->spool) && status == STATUS_OK; b++) {
        const size_t n = spool_count(s->spool, b);
        status = spool_read(s->spool, b, SPOOL_KEY, key, x, why);
        if (status == STATUS_OK)
            status = spool_read(s->spool, b, SPOOL_VALUE, number, y, why);
        if (status == STATUS_OK)
            status = spool_read(s->spool, b, SPOOL_CODE, number, code, why);
        for (size_t i = 0; i < n && status == STATUS_OK; i++) {
            if (code[i] != REASON_PRESENT)
                continue;
            const size_t r = draws_repeat(s->d, b * SPOOL_DRAWS + i);
            struct bin *bin = &s->bin[r][bin_of(s, x[i])];
            bin->count += 1.0;
            bin->sum += y[i] - center;
            s->squares[r] += (y[i] - center) * (y[i] - center);
        }
    }
    free(x);
    free(code);
    return status;
}

/* omega^2 = (between - (m - 1) w)/(total + w), w = within/(n - m), of m bins,
 * `wide` of them as one; of (m - 1) w the part that is given. */
static double index_of(const struct shares *s, size_t r, size_t wide,
                       double part)
{
    double between = 0.0, count = 0.0, sum = 0.0, bins = 0.0;

    for (size_t i = 0; i < s->bins; i += wide) {
        struct bin b = { 0.0, 0.0 };
        for (size_t j = i; j < i + wide; j++) {
            b.count += s->bin[r][j].count;
            b.sum += s->bin[r][j].sum;
        }
        if (b.count == 0.0)
            continue;
        between += b.sum * b.sum / b.count;
        count += b.count;
        sum += b.sum;
        bins += 1.0;
    }
    const double mean = sum * sum / count;
    const double total = s->squares[r] - mean;
    const double within = (s->squares[r] - between) / (count - bins);
    return count > bins + 1.0 && total > 0.0
               ? (between - mean - part * (bins - 1.0) * within) /
                     (total + within)
               : (double) NAN;
}

static struct estimate estimate_of(const struct shares *s)
{
    const bool even = !s->d->is_sample && s->d->method != ENSEMBLE_RANDOM;
    const double part = even ? 0.5 : 1.0;
    double fine[ENSEMBLE_REPEATS], coarse[ENSEMBLE_REPEATS];
    double all[ENSEMBLE_REPEATS];

    for (size_t r = 0; r < ENSEMBLE_REPEATS; r++) {
        fine[r] = index_of(s, r, 1, part);
        coarse[r] = index_of(s, r, 2, part);
        all[r] = index_of(s, r, 1, 1.0);
    }
    struct estimate e = tally_repeats(fine);
    e.error += fabs(e.value - tally_repeats(coarse).value) +
               fabs(e.value - tally_repeats(all).value);
    return e;
}

enum status shares_find(const struct spool *s, const struct draws *d,
                        size_t number, double center, struct estimate share[],
                        struct fault *why)
{
    struct shares *of = malloc(sizeof *of);
    enum status status = of ? STATUS_OK : STATUS_NO_MEMORY;

    if (of) {
        of->spool = s;
        of->d = d;
        of->bins = bins_for(s);
    }
    for (size_t k = 0; k < s->shape.keys && status == STATUS_OK; k++) {
        share[k] = (struct estimate){ NAN, NAN };
        if (of->bins < SHARE_LEAST)
            continue;
        status = find_edges(of, k, why);
        if (status == STATUS_OK)
            status = fill(of, k, number, center, why);
        if (status == STATUS_OK)
            share[k] = estimate_of(of);
    }
    free(of);
    return status;
}
