/*
 * tape_sums.h -- inside tape_jet.c: sum[i] of a[j width + i] b[(k - j) width +
 * i], 0 < j < k, k > 0, i < count, which is even of pairs.  Neighbours never
 * meet and nothing is fused, so that wide registers give the same bits.  Orders
 * come in pairs: an even one begins the sums of the next, next[i], of rows that
 * it has read for its own.
 */
#pragma once

#include "jet.h"

/* Row j of a, row l of b. */
#define OF_A(type, j, i) ((const type *) (a + (j) *width))[i]
#define OF_B(type, l, i) ((const type *) (b + (l) *width))[i]
/* The newest rows come last, and what is older need not wait for them; of n
 * neighbours, k even. */
#define SUMS(type, n)                                                          \
    do {                                                                       \
        type s[n], t[n], before[n];                                            \
        for (int i = 0; i < (n); i++) {                                        \
            s[i] = t[i] = (type){ 0 };                                         \
            before[i] = OF_B(type, k - 1, i);                                  \
        }                                                                      \
        for (size_t j = 2; j < k; j++)                                         \
            for (int i = 0; i < (n); i++) {                                    \
                const type u = OF_A(type, j, i), w = OF_B(type, k - j, i);     \
                s[i] += u * w;                                                 \
                t[i] += u * before[i];                                         \
                before[i] = w;                                                 \
            }                                                                  \
        for (int i = 0; i < (n); i++) {                                        \
            ((type *) sum)[i] =                                                \
                s[i] + OF_A(type, 1, i) * OF_B(type, k - 1, i);                \
            ((type *) next)[i] = t[i];                                         \
        }                                                                      \
    } while (0)

/* Three registers a neighbour. */
#ifdef __AVX512F__
enum { SUMS_MOST = 8 };
#else
enum { SUMS_MOST = 4 };
#endif

/* name(k, width, count, a, b, sum, next), k even, by registers of a type. */
#define SUMS_BY(name, type)                                                    \
    static inline __attribute__((always_inline)) void name(                    \
        size_t k, size_t width, size_t count, const jet_pair *a,               \
        const jet_pair *b, jet_pair *sum, jet_pair *next)                      \
    {                                                                          \
        size_t now;                                                            \
                                                                               \
        for (size_t left = count * sizeof(jet_pair) / sizeof(type); left > 0;  \
             left -= now) {                                                    \
            now = left < SUMS_MOST ? left : SUMS_MOST;                         \
            switch (now) {                                                     \
                case 8:                                                        \
                    SUMS(type, 8);                                             \
                    break;                                                     \
                case 7:                                                        \
                    SUMS(type, 7);                                             \
                    break;                                                     \
                case 6:                                                        \
                    SUMS(type, 6);                                             \
                    break;                                                     \
                case 5:                                                        \
                    SUMS(type, 5);                                             \
                    break;                                                     \
                case 4:                                                        \
                    SUMS(type, 4);                                             \
                    break;                                                     \
                case 3:                                                        \
                    SUMS(type, 3);                                             \
                    break;                                                     \
                case 2:                                                        \
                    SUMS(type, 2);                                             \
                    break;                                                     \
                default:                                                       \
                    SUMS(type, 1);                                             \
                    break;                                                     \
            }                                                                  \
            a = (const jet_pair *) ((const type *) a + now);                   \
            b = (const jet_pair *) ((const type *) b + now);                   \
            sum = (jet_pair *) ((type *) sum + now);                           \
            next = (jet_pair *) ((type *) next + now);                         \
        }                                                                      \
    }

SUMS_BY(sums_by_pairs, jet_pair)
#ifndef __AVX512F__
/* Four numbers where pairs stand, or half of eight. */
typedef double four __attribute__((vector_size(32), aligned(16), may_alias));
SUMS_BY(sums_by_fours, four)
#endif

/* Of an odd order, which the one before has begun. */
static inline void sums_ended(size_t k, size_t width, const jet_pair *a,
                              const jet_pair *b, jet_pair *sum,
                              const jet_pair *next)
{
    for (size_t i = 0; i < width; i++)
        sum[i] = k == 1 ? JET_PAIR(0.0)
                        : next[i] +
                              OF_A(jet_pair, k - 1, i) * OF_B(jet_pair, 1, i) +
                              OF_A(jet_pair, 1, i) * OF_B(jet_pair, k - 1, i);
}

#undef SUMS_BY
#undef SUMS
#undef OF_A
#undef OF_B
