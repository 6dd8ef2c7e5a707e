/*
 * tape_sums.h -- inside tape_jet.c: sum[i] of a[j width + i] b[(k - j) width +
 * i], 0 < j < k, k > 0, i < count, which is even of pairs.  Neighbours never
 * meet and nothing is fused, so that wide registers give the same bits.
 */
#pragma once

#include "jet.h"

/* One product of n neighbours each, of a type. */
#define ADD_ROW(type, n, j)                                                    \
    for (int i = 0; i < (n); i++)                                              \
    s[i] += ((const type *) (a + (j) *width))[i] *                             \
            ((const type *) (b + (k - (j)) * width))[i]
/* The newest rows come last, and what is older need not wait for them. */
#define SUMS(type, n)                                                          \
    do {                                                                       \
        type s[n];                                                             \
        for (int i = 0; i < (n); i++)                                          \
            s[i] = (type){ 0 };                                                \
        for (size_t j = 2; j + 1 < k; j++)                                     \
            ADD_ROW(type, n, j);                                               \
        if (k > 2)                                                             \
            ADD_ROW(type, n, k - 1);                                           \
        if (k > 1)                                                             \
            ADD_ROW(type, n, 1);                                               \
        for (int i = 0; i < (n); i++)                                          \
            ((type *) sum)[i] = s[i];                                          \
    } while (0)

/* name(k, width, count, a, b, sum), by registers of a type. */
#define SUMS_BY(name, type)                                                    \
    static inline __attribute__((always_inline)) void name(                    \
        size_t k, size_t width, size_t count, const jet_pair *a,               \
        const jet_pair *b, jet_pair *sum)                                      \
    {                                                                          \
        size_t now;                                                            \
                                                                               \
        for (size_t left = count * sizeof(jet_pair) / sizeof(type); left > 0;  \
             left -= now) {                                                    \
            now = left < 8 ? left : 8;                                         \
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
        }                                                                      \
    }

SUMS_BY(sums_by_pairs, jet_pair)
#ifndef __AVX512F__
/* Four numbers where pairs stand, or half of eight. */
typedef double four __attribute__((vector_size(32), aligned(16), may_alias));
SUMS_BY(sums_by_fours, four)
#endif

#undef SUMS_BY
#undef SUMS
#undef ADD_ROW
