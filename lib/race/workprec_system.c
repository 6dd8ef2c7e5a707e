#include "workprec_system.h"

#include <math.h>
#include <stdint.h>

#include "field.h"

static struct vec2 place(const double u[])
{
    return (struct vec2){ u[0], u[1] };
}

/* ---- backward in arc length ------------------------------------------ */

static double arc(const struct planar *sys, const double u[], double du[])
{
    struct planar_field f;

    sys->field(sys->ctx, place(u), &f);
    const double size = hypot(f.direction.x, f.direction.y);
    du[0] = -f.direction.x / size;
    du[1] = -f.direction.y / size;
    return exp(-f.log_scale) / size; /* time a length */
}

static void arc_rates(const void *ctx, const double u[], double du[])
{
    (void) arc(ctx, u, du);
}

static void excess_rates(const void *ctx, const double u[], double du[])
{
    const struct planar *sys = ctx;
    const double slow = arc(sys, u, du);
    double rate;

    sys->rate_gradient(sys->ctx, BLOCK_EXCESS, place(u), &rate, NULL);
    du[2] = -rate * slow;
}

/* With n = f/|f|: D(-n) = -(1 - n n^T) Df/|f|.  Returns |f|/scale, and
 * |f|'s logarithmic gradient in *along. */
static struct planar_field arc_slopes(const struct planar *sys,
                                      const double u[], struct mat2 *D,
                                      struct vec2 *along)
{
    struct planar_jacobian J;

    sys->jacobian(sys->ctx, place(u), &J);
    const struct vec2 d = J.field.direction;
    const double size = hypot(d.x, d.y), x = d.x / size, y = d.y / size;
    const struct mat2 M = J.matrix;
    along->x = (x * M.xx + y * M.yx) / size;
    along->y = (x * M.xy + y * M.yy) / size;
    *D =
        (struct mat2){ x * along->x - M.xx / size, x * along->y - M.xy / size,
                       y * along->x - M.yx / size, y * along->y - M.yy / size };
    return J.field;
}

static void arc_jacobian(const void *ctx, const double u[], double J[])
{
    struct mat2 D;
    struct vec2 along;

    (void) arc_slopes(ctx, u, &D, &along);
    J[0] = D.xx;
    J[1] = D.xy;
    J[2] = D.yx;
    J[3] = D.yy;
}

static void excess_jacobian(const void *ctx, const double u[], double J[])
{
    const struct planar *sys = ctx;
    struct vec2 along, g;
    struct mat2 D;
    double rate;

    const struct planar_field f = arc_slopes(sys, u, &D, &along);
    const double slow = exp(-f.log_scale) / hypot(f.direction.x, f.direction.y);
    sys->rate_gradient(sys->ctx, BLOCK_EXCESS, place(u), &rate, &g);
    const double row[9] = { D.xx,
                            D.xy,
                            0.0,
                            D.yx,
                            D.yy,
                            0.0,
                            -(g.x - rate * along.x) * slow,
                            -(g.y - rate * along.y) * slow,
                            0.0 };
    for (int i = 0; i < 9; i++)
        J[i] = row[i];
}

/* ---- forward in time ------------------------------------------------- */

static void motion_rates(const void *ctx, const double u[], double du[])
{
    const struct planar *sys = ctx;
    struct planar_field f;

    sys->field(sys->ctx, place(u), &f);
    const double scale = exp(f.log_scale);
    du[0] = f.direction.x * scale;
    du[1] = f.direction.y * scale;
}

static void slip_rates(const void *ctx, const double u[], double du[])
{
    const struct planar *sys = ctx;

    motion_rates(sys, u, du);
    sys->rate_gradient(sys->ctx, BLOCK_SLIP, place(u), &du[2], NULL);
}

/* The plane's part, as rows of n numbers. */
static void plane_jacobian(const struct planar *sys, const double u[], size_t n,
                           double J[])
{
    struct planar_jacobian at;

    sys->jacobian(sys->ctx, place(u), &at);
    const double scale = exp(at.field.log_scale);
    J[0] = at.matrix.xx * scale;
    J[1] = at.matrix.xy * scale;
    J[n] = at.matrix.yx * scale;
    J[n + 1] = at.matrix.yy * scale;
}

static void motion_jacobian(const void *ctx, const double u[], double J[])
{
    plane_jacobian(ctx, u, 2, J);
}

static void slip_jacobian(const void *ctx, const double u[], double J[])
{
    const struct planar *sys = ctx;
    struct vec2 gradient;
    double rate;

    plane_jacobian(sys, u, 3, J);
    sys->rate_gradient(sys->ctx, BLOCK_SLIP, place(u), &rate, &gradient);
    J[6] = gradient.x;
    J[7] = gradient.y;
    J[2] = J[5] = J[8] = 0.0;
}

struct method_system workprec_arc(const struct planar *sys, bool excess)
{
    return (struct method_system){
        .dim = excess ? 3 : 2,
        .rates = excess ? excess_rates : arc_rates,
        .jacobian = excess ? excess_jacobian : arc_jacobian,
        .ctx = sys,
        .calls_most = SIZE_MAX,
    };
}

struct method_system workprec_motion(const struct planar *sys, bool slip)
{
    return (struct method_system){
        .dim = slip ? 3 : 2,
        .rates = slip ? slip_rates : motion_rates,
        .jacobian = slip ? slip_jacobian : motion_jacobian,
        .ctx = sys,
        .calls_most = SIZE_MAX,
    };
}
