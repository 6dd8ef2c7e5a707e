#include "branch.h"

#include <math.h>

void branch_free(struct branch *b)
{
    curve_free(&b->curve);
}

double branch_error(const struct branch *b, size_t i, double by_limit,
                    double by_total)
{
    const double limit = b->end == BRANCH_LIMIT_X ? b->error.x : b->error.y;
    const double known = by_limit * b->limit_off + by_total * b->total_off[i];

    return fabs(known) + fabs(by_limit) * (limit - fabs(b->limit_off)) +
           fabs(by_total) * (b->total_error[i] - fabs(b->total_off[i]));
}

int branch_graph(const struct branch *b, size_t piece)
{
    const double *x = curve_component(&b->curve, piece, 0);
    bool linear = x[1] != 0.0;

    for (size_t k = 2; k <= b->curve.piece[piece].degree; k++)
        linear &= x[k] == 0.0;
    return linear ? 0 : 1;
}

double branch_slope(const struct planar *sys, const struct branch *b,
                    size_t piece, double theta)
{
    double at[CURVE_DIM_MAX], slope[CURVE_DIM_MAX];

    if (piece == 0) { /* the series: the field is 0/0 at the saddle */
        curve_slope_at(&b->curve, piece, theta, slope);
        return slope[1] / slope[0];
    }
    curve_at(&b->curve, piece, theta, at);
    return local_slope(sys, 0, (struct vec2){ at[0], at[1] });
}
