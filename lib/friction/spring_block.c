/* V d/dV = d/d ln v turns the slopes of response.h into k_c:
 *     sigma mu_ss' g = sigma slope rate/(v L),
 *     m g/(sigma mu_v) = m V_star^2 rate v/(sigma direct L). */
#include "spring_block.h"

#include <float.h>
#include <math.h>

#include "response.h"

struct spring_limit spring_block_limit(const struct spring_block *block,
                                       const struct law *law,
                                       const struct material *m, long double x)
{
    const struct response at = response_at(law, m, x);
    const long double sigma = (long double) block->sigma;
    const long double L = (long double) m->L, V = (long double) m->V_star;
    const long double v = expl(x);
    const long double k = -sigma * at.slope * at.rate / (v * L);
    const long double inertia = (long double) block->mass * V * V * at.rate *
                                v / (sigma * at.direct * L);

    return (struct spring_limit){
        .k = k * (1 + inertia),
        .k_quasistatic = k,
        .relative_error = at.slope_error / fabsl(at.slope) + 2 * at.rate_error +
                          (32 + 4 * fabsl(x)) * LDBL_EPSILON,
    };
}
