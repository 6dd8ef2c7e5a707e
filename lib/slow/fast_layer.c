/* By the widest lanes that layer_lanes.c was compiled for. */
#include "fast_layer.h"

#include "layer_lanes.h"
#include "slow_tolerance.h"

struct layer_options layer_defaults(double rtol)
{
    return (struct layer_options){
        .promise = rtol,
        .rtol = TOL_PART * rtol,
        .landing = rtol < TOL_COARSEST ? TOL_LAYER_CLOSER : TOL_NEARBY,
        .peaks = true,
    };
}

int layer_width(int most)
{
#ifdef HAVE_WIDE_LANES
    if (most >= 8 && jet_width() == 8)
        return 8;
    if (most >= 4 && jet_width() >= 4)
        return 4;
#endif
    return most >= 2 ? 2 : 1;
}

void layer_follow(const struct slow_curve *c, int width,
                  const struct layer_job job[], size_t n, struct layer out[])
{
#ifdef HAVE_WIDE_LANES
    if (width == 8)
        layer_lanes_8(c, job, n, out);
    else if (width == 4)
        layer_lanes_4(c, job, n, out);
    else
#endif
        if (width == 2)
        layer_lanes_2(c, job, n, out);
    else
        layer_lanes_1(c, job, n, out);
}
