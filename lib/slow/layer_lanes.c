/* Which of the widths that layer_lanes_wide.c was compiled for. */
#include "layer_lanes.h"

#ifdef HAVE_WIDE_LANES

int layer_lanes_width(int most)
{
    __builtin_cpu_init();
    const bool has8 = __builtin_cpu_supports("avx512f") &&
                      __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512vl");
    const bool has4 = __builtin_cpu_supports("avx2");

    return most >= 8 && has8 ? 8 : most >= 4 && has4 ? 4 : 2;
}

void layer_lanes_follow(const struct slow_curve *c, int width,
                        const struct layer_job job[], size_t n,
                        struct layer out[])
{
    if (width == 8)
        layer_lanes_8(c, job, n, out);
    else if (width == 4)
        layer_lanes_4(c, job, n, out);
    else
        layer_lanes_2(c, job, n, out);
}

#else

int layer_lanes_width(int most)
{
    (void) most;
    return 2;
}

void layer_lanes_follow(const struct slow_curve *c, int width,
                        const struct layer_job job[], size_t n,
                        struct layer out[])
{
    (void) width;
    layer_lanes_2(c, job, n, out);
}

#endif
