#include "quantile.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ensemble_tolerance.h"

enum { DIGIT = 8, CLASSES = 1 << DIGIT, DIGITS = 64 / DIGIT };

/* A rank on its way: what is known of the first digits of its value. */
struct ranked {
    uint64_t head; /* the digits known so far, at the right */
    uint64_t rank; /* among the values that begin with them, from 0 */
};

struct selection {
    struct ranked rank[QUANTILES_MAX];
    size_t ranks;
    uint64_t *counts; /* owned: a row of CLASSES for each different head */
    uint64_t head[QUANTILES_MAX];
    size_t heads;
    uint64_t values; /* in all */
};

/* Ascending as the doubles are. */
static uint64_t bits_of(double x)
{
    uint64_t bits;

    memcpy(&bits, &x, sizeof bits);
    return bits >> 63 ? ~bits : bits | (uint64_t) 1 << 63;
}

static double value_of(uint64_t bits)
{
    double x;

    bits = bits >> 63 ? bits & ~((uint64_t) 1 << 63) : ~bits;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* ---- passes -------------------------------------------------------------- */

/* The heads that differ; ranks ascend, so do they. */
static void find_heads(struct selection *s)
{
    s->heads = 0;
    for (size_t i = 0; i < s->ranks; i++)
        if (i == 0 || s->rank[i].head != s->head[s->heads - 1])
            s->head[s->heads++] = s->rank[i].head;
    memset(s->counts, 0, s->heads * CLASSES * sizeof *s->counts);
}

static void count_one(struct selection *s, uint64_t bits, int digit)
{
    const int shift = 64 - DIGIT * (digit + 1);
    const uint64_t head = digit == 0 ? 0 : bits >> (shift + DIGIT);
    size_t lo = 0, hi = s->heads;

    while (hi - lo > 1) {
        const size_t middle = (lo + hi) / 2;
        *(s->head[middle] <= head ? &lo : &hi) = middle;
    }
    if (s->head[lo] == head)
        s->counts[lo * CLASSES + (bits >> shift & (CLASSES - 1))]++;
}

static enum status pass(struct selection *s, const struct spool *spool,
                        enum spool_kind kind, size_t k, int digit,
                        struct fault *why)
{
    double *value = malloc(SPOOL_DRAWS * sizeof *value);
    int8_t *code = malloc(SPOOL_DRAWS);
    enum status status = value && code ? STATUS_OK : STATUS_NO_MEMORY;

    find_heads(s);
    for (size_t b = 0; b < spool_blocks(spool) && status == STATUS_OK; b++) {
        const size_t n = spool_count(spool, b);
        status = spool_read(spool, b, kind, k, value, why);
        memset(code, REASON_PRESENT, n);
        if (status == STATUS_OK && kind == SPOOL_VALUE)
            status = spool_read(spool, b, SPOOL_CODE, k, code, why);
        for (size_t i = 0; i < n && status == STATUS_OK; i++)
            if (code[i] == REASON_PRESENT)
                count_one(s, bits_of(value[i]), digit);
    }
    free(value);
    free(code);
    return status;
}

/* The class that holds each rank, and the rank in it. */
static void narrow(struct selection *s)
{
    for (size_t i = 0, h = 0; i < s->ranks; i++) {
        struct ranked *r = &s->rank[i];
        while (s->head[h] != r->head)
            h++;
        const uint64_t *count = s->counts + h * CLASSES;
        uint64_t c = 0;
        while (r->rank >= count[c])
            r->rank -= count[c++];
        r->head = r->head << DIGIT | c;
    }
}

/* After the first pass it is known how many there are. */
static void set_ranks(struct selection *s, const double p[])
{
    s->values = 0;
    for (size_t c = 0; c < CLASSES; c++)
        s->values += s->counts[c];
    for (size_t i = 0; i < s->ranks; i++) {
        const double rank = ceil(p[i] * (double) s->values);
        s->rank[i].rank = rank > 1.0 ? (uint64_t) rank - 1 : 0;
    }
}

enum status quantile_find(const struct spool *s, enum spool_kind kind, size_t k,
                          const double p[], size_t n, double out[],
                          struct fault *why)
{
    struct selection q = { .ranks = n };
    enum status status = STATUS_OK;

    q.counts = malloc(n * CLASSES * sizeof *q.counts);
    if (q.counts == NULL)
        return STATUS_NO_MEMORY;
    for (int digit = 0; digit < DIGITS && status == STATUS_OK; digit++) {
        status = pass(&q, s, kind, k, digit, why);
        if (digit == 0 && status == STATUS_OK)
            set_ranks(&q, p);
        if (q.values == 0)
            break;
        narrow(&q);
    }
    for (size_t i = 0; i < n && status == STATUS_OK; i++)
        out[i] = q.values ? value_of(q.rank[i].head) : (double) NAN;
    free(q.counts);
    return status;
}
