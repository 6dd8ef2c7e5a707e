#include "variate.h"

#include <math.h>
#include <stdlib.h>

/* What is known of one push in the draws of a half. */
struct half {
    const struct draws *d;
    const int8_t *of;
    struct variate_half *out;
    double *row; /* owned; m and scores of draws with a margin */
    size_t rows;
    double count[2], fate[2][GOALS + 1]; /* where z_j >= g, and < */
};

enum status variate_goals(const struct spool *s, size_t block, size_t k,
                          const int8_t of[], int8_t goal[SPOOL_DRAWS],
                          struct fault *why)
{
    int8_t code[SPOOL_DRAWS];
    enum status status = spool_read(s, block, SPOOL_FATE, k, goal, why);

    if (status == STATUS_OK)
        status = spool_read(s, block, SPOOL_FATE_REASON, k, code, why);
    for (size_t i = 0; i < spool_count(s, block) && status == STATUS_OK; i++)
        goal[i] = goal[i] < 0 ? (int8_t) GOALS : of ? of[code[i]] : goal[i];
    return status;
}

typedef void taker(struct half *h, size_t i, int8_t goal, double margin);

static void take_row(struct half *h, size_t i, int8_t goal, double margin)
{
    double *row = h->row + h->rows * (1 + h->d->keys);

    (void) goal;
    if (!isfinite(margin) || h->rows == THRESHOLD_ROOM)
        return;
    row[0] = margin;
    draws_scores(h->d, i, row + 1);
    h->rows++;
}

/* [z_j < g], and P(z_j < g | others). */
static bool is_below(const struct threshold *g, const struct draws *d, size_t i,
                     double *chance)
{
    double z[SCENE_SPREADS];

    draws_scores(d, i, z);
    const double at = threshold_at(g, z);
    *chance = draws_below(d, g->pivot, at);
    return z[g->pivot] < at;
}

static void take_fate(struct half *h, size_t i, int8_t goal, double margin)
{
    double chance;
    const bool below = is_below(&h->out->g, h->d, i, &chance);

    (void) margin;
    h->count[below] += 1.0;
    h->fate[below][goal] += 1.0;
}

/* The draws of even repeats, or of odd ones. */
static enum status walk(struct half *h, const struct spool *s, size_t k,
                        size_t odd, taker *take, struct fault *why)
{
    double margin[SPOOL_DRAWS];
    int8_t goal[SPOOL_DRAWS];
    enum status status = STATUS_OK;

    for (size_t b = 0; b < spool_blocks(s) && status == STATUS_OK; b++) {
        status = spool_read(s, b, SPOOL_MARGIN, k, margin, why);
        if (status == STATUS_OK)
            status = variate_goals(s, b, k, h->of, goal, why);
        for (size_t i = 0; i < spool_count(s, b) && status == STATUS_OK; i++)
            if (draws_repeat(h->d, b * SPOOL_DRAWS + i) % 2 == odd)
                take(h, b * SPOOL_DRAWS + i, goal[i], margin[i]);
    }
    return status;
}

static enum status fit(struct half *h, const struct spool *s, size_t k,
                       size_t odd, struct fault *why)
{
    struct variate_half *out = h->out;
    enum status status = walk(h, s, k, odd, take_row, why);

    if (status == STATUS_OK)
        status = threshold_fit(&out->g, h->row, h->rows, h->d->keys);
    if (status == STATUS_OK && out->g.there)
        status = walk(h, s, k, odd, take_fate, why);
    for (int f = 0; f <= (int) GOALS; f++)
        if (h->count[0] > 0.0 && h->count[1] > 0.0)
            out->slope[f] =
                h->fate[1][f] / h->count[1] - h->fate[0][f] / h->count[0];
    return status;
}

enum status variate_fit(struct variate *c, const struct spool *s,
                        const struct draws *d, size_t k, const int8_t of[],
                        struct fault *why)
{
    const size_t room = THRESHOLD_ROOM * (1 + d->keys);
    enum status status = STATUS_OK;

    *c = (struct variate){ .d = d };
    for (size_t i = 0; i < 2 && draws_is_scrambled(d) && !status; i++) {
        struct half h = { .d = d, .of = of, .out = &c->half[i] };
        h.row = malloc(room * sizeof *h.row);
        status = h.row ? fit(&h, s, k, 1 - i, why) : STATUS_NO_MEMORY;
        free(h.row);
    }
    return status;
}

void variate_at(const struct variate *c, size_t i, double out[GOALS + 1])
{
    const struct variate_half *h = &c->half[draws_repeat(c->d, i) % 2];
    double chance = 0.0, off = 0.0;

    if (h->g.there)
        off = is_below(&h->g, c->d, i, &chance) ? 1.0 : 0.0;
    for (int f = 0; f <= (int) GOALS; f++)
        out[f] = h->slope[f] * (off - chance);
}
