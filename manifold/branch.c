#include "branch.h"

void branch_free(struct branch *b)
{
    curve_free(&b->curve);
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
