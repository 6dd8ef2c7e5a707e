#include "branch.h"

void branch_free(struct branch *b)
{
    curve_free(&b->curve);
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
