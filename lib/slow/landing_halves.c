/* Two halves miss far less than the whole, of order 8: 1/256 of it, where it
 * is resolved. */
#include "landing_halves.h"

#include <math.h>

#include "slider.h"

void landing_along(const void *ctx, double s, const double u[], double du[])
{
    const struct slider *slider = ctx;
    struct planar_field f;

    (void) s;
    slider->plane.system.field(slider->plane.system.ctx,
                               (struct vec2){ u[LAYER_X], u[LAYER_Y] }, &f);
    const double size = vec2_length(f.direction);
    du[LAYER_X] = f.direction.x / size;
    du[LAYER_Y] = f.direction.y / size;
    du[LAYER_TIME] = exp(-f.log_scale) / size;
    du[LAYER_SLIP] = exp(slider->block.at.x0 + u[LAYER_X]) * du[LAYER_TIME];
}

/* From u, along du, to u1. */
static void step(const struct slider *s, double h, const double u[],
                 const double du[], double u1[])
{
    const struct ode ode = { LAYER_DIM, landing_along, s };
    const double unit[LAYER_DIM] = { 1.0, 1.0, 1.0, 1.0 };
    double error[LAYER_DIM];
    struct explicit8 stages;

    for (int i = 0; i < LAYER_DIM; i++)
        stages.k[0][i] = du[i];
    explicit8_try(&stages, &ode, 0.0, u, h, unit, 0.0, u1, error);
}

struct landing_halves landing_halve(const struct slider *s, struct vec2 from,
                                    double h)
{
    const double u[LAYER_DIM] = { from.x, from.y, 0.0, 0.0 };
    double whole[LAYER_DIM], half[LAYER_DIM], end[LAYER_DIM], du[LAYER_DIM],
        off[LAYER_DIM];

    landing_along(s, 0.0, u, du);
    step(s, h, u, du, whole);
    step(s, 0.5 * h, u, du, half);
    landing_along(s, 0.0, half, du);
    step(s, 0.5 * h, half, du, end);
    landing_along(s, 0.0, whole, du);
    for (int i = 0; i < LAYER_DIM; i++)
        off[i] = whole[i] - end[i];
    const double on = off[LAYER_X] * du[LAYER_X] + off[LAYER_Y] * du[LAYER_Y];
    return (struct landing_halves){
        off[LAYER_Y] * du[LAYER_X] - off[LAYER_X] * du[LAYER_Y],
        off[LAYER_TIME] - on * du[LAYER_TIME],
        off[LAYER_SLIP] - on * du[LAYER_SLIP],
    };
}
