/*
 * tape_sums.h -- inside tape_jet.c: sum[i] of a[j width + i] b[(k - j) width +
 * i], 0 < j < k, k > 0; width is even.  Neighbours never meet and nothing is
 * fused, so that wide registers give the same bits.
 */
#ifndef FORMULA_TAPE_SUMS_H
#define FORMULA_TAPE_SUMS_H

#include "jet.h"

/* Four numbers where pairs stand. */
typedef double four __attribute__((vector_size(32), aligned(16), may_alias));

/* One product of `fours` neighbours each. */
#define ADD_ROW(fours, j)                                                      \
    for (int i = 0; i < (fours); i++)                                          \
    s[i] += *(const four *) (a + (j) *width + 2 * i) *                         \
            *(const four *) (b + (k - (j)) * width + 2 * i)
/* The newest rows come last, and what is older need not wait for them. */
#define SUMS(fours)                                                            \
    do {                                                                       \
        four s[fours];                                                         \
        for (int i = 0; i < (fours); i++)                                      \
            s[i] = (four){ 0 };                                                \
        for (size_t j = 2; j + 1 < k; j++)                                     \
            ADD_ROW(fours, j);                                                 \
        if (k > 2)                                                             \
            ADD_ROW(fours, k - 1);                                             \
        if (k > 1)                                                             \
            ADD_ROW(fours, 1);                                                 \
        for (int i = 0; i < (fours); i++)                                      \
            *(four *) (sum + 2 * i) = s[i];                                    \
    } while (0)

static inline __attribute__((always_inline)) void sums(size_t k, size_t width,
                                                       size_t most,
                                                       const jet_pair *a,
                                                       const jet_pair *b,
                                                       jet_pair *sum)
{
    size_t left = width / 2;

    for (; left > 0;) {
        const size_t now = left < most ? left : most;
        switch (now) {
            case 8:
                SUMS(8);
                break;
            case 7:
                SUMS(7);
                break;
            case 6:
                SUMS(6);
                break;
            case 5:
                SUMS(5);
                break;
            case 4:
                SUMS(4);
                break;
            case 3:
                SUMS(3);
                break;
            case 2:
                SUMS(2);
                break;
            default:
                SUMS(1);
                break;
        }
        left -= now;
        a += 2 * now;
        b += 2 * now;
        sum += 2 * now;
    }
}

#undef SUMS
#undef ADD_ROW

#endif
