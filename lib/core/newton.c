/* Compiles newton_formula.h once for each kind of number. */
#include "newton.h"

#include <stdbool.h>
#include <tgmath.h>

#define REAL    double
#define NAME(x) x
#include "newton_formula.h"
#undef REAL
#undef NAME

#define REAL    long double
#define NAME(x) x##_long
#include "newton_formula.h"
#undef REAL
#undef NAME

enum status newton_close_long(long double (*f)(const void *ctx, long double x),
                              const void *ctx, const long double x[2],
                              const long double at[2],
                              struct newton_root_long *out)
{
    const struct bracket_long k = { .a = x[1],
                                    .b = x[0],
                                    .c = x[0],
                                    .f_a = at[1],
                                    .f_b = at[0],
                                    .f_c = at[0] };

    return find_between_long(f, ctx, k, 0, out);
}
