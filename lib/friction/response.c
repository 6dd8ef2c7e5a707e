#include "response.h"

#include <float.h>
#include <math.h>

#include "law_graph.h"

/* Of a law of formulas, which may cancel as they like, in 113 bits. */
static long double typed_slope(const struct law *law, const struct material *m,
                               long double x)
{
    struct law_quad p;

    law_quad_init(&p, law, m, 0);
    return (long double) law_quad_along(&p, x, LAW_AT_MU);
}

struct response response_at(const struct law *law, const struct material *m,
                            long double x)
{
    struct law_long p;

    law_long_init(&p, law, m, 0);
    const long double slope = law_long_along(&p, x, LAW_AT_MU);
    const long double direct = law_long_by(&p, LAW_AT_MU, p.g->x);
    (void) law_long_steady(&p, x, LAW_AT_GROWTH);
    const long double unit = law_psi_is_log(law) ? 1 : p.value[p.g->psi];
    const long double rate = -law_long_by(&p, LAW_AT_GROWTH, p.g->y) / unit;

    return (struct response){
        .slope = law->typed ? typed_slope(law, m, x) : slope,
        .direct = direct,
        .rate = rate,
        .slope_error = 16 * LDBL_EPSILON * (direct + fabsl(slope - direct)),
        .rate_error = 8 * LDBL_EPSILON * (1 + fabsl(x) + fabsl(logl(rate))),
    };
}
