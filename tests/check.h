/* check.h -- what every test program shares: cmocka, a seed, random numbers,
 * and CHECK, which says what was found.  A test's name is a sentence. */
#pragma once

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

/* CHECK(condition, "format", values...): fails the test and prints the values
 * and how to repeat the run. */
#define CHECK(cond, ...)                                                       \
    do {                                                                       \
        if (!(cond)) {                                                         \
            char check_text_[1024];                                            \
            snprintf(check_text_, sizeof check_text_, __VA_ARGS__);            \
            fail_msg("%s: %s  [CHECK_SEED=%llu]", #cond, check_text_,          \
                     (unsigned long long) check_seed());                       \
        }                                                                      \
    } while (0)

static inline uint64_t check_seed(void)
{
    const char *s = getenv("CHECK_SEED");
    return s ? strtoull(s, NULL, 10) : 20240229u;
}

/* splitmix64: Steele, Lea, Flood, OOPSLA 2014. */
static inline uint64_t check_bits(uint64_t *state)
{
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* Uniform in [lo, hi). */
static inline double check_uniform(uint64_t *state, double lo, double hi)
{
    return lo + (hi - lo) * (double) (check_bits(state) >> 11) * 0x1p-53;
}
