#include "workprec_system.h"

#include <math.h>
#include <stdint.h>

static struct vec2 place(const double u[])
{
    return (struct vec2){ u[0], u[1] };
}

/* What the field's direction is multiplied by; *time: what passes a unit of
 * the parameter. */
static double factor_of(const struct workprec_system *w,
                        const struct planar_field *f, double *time)
{
    const double size = hypot(f->direction.x, f->direction.y);

    *time = w->arc ? exp(-f->log_scale) / size : 1.0;
    return w->arc ? -1.0 / size : exp(f->log_scale);
}

static void rates(const void *ctx, const double u[], double du[])
{
    const struct workprec_system *w = ctx;
    struct planar_field f;
    double time, rate;

    w->planar->field(w->planar->ctx, place(u), &f);
    const double factor = factor_of(w, &f, &time);
    du[0] = f.direction.x * factor;
    du[1] = f.direction.y * factor;
    if (w->observable == WORKPREC_ALONE)
        return;
    w->planar->rate_gradient(w->planar->ctx, (size_t) w->observable, place(u),
                             &rate, NULL);
    du[2] = w->arc ? -rate * time : rate;
}

/* With n = f/|f|: D(-n) = -(1 - n n^T) Df/|f|, and |f|'s logarithmic gradient
 * is n^T Df/|f|. */
static void jacobian(const void *ctx, const double u[], double J[])
{
    const struct workprec_system *w = ctx;
    const size_t dim = w->observable == WORKPREC_ALONE ? 2 : 3;
    struct planar_jacobian at;
    struct vec2 g, along = { 0.0, 0.0 };
    double time, rate;

    w->planar->jacobian(w->planar->ctx, place(u), &at);
    const struct mat2 M = at.matrix;
    const double factor = factor_of(w, &at.field, &time);
    const struct vec2 n = { at.field.direction.x * factor,
                            at.field.direction.y * factor };
    if (w->arc)
        along = (struct vec2){ factor * (n.x * M.xx + n.y * M.yx),
                               factor * (n.x * M.xy + n.y * M.yy) };
    J[0] = M.xx * factor - n.x * along.x;
    J[1] = M.xy * factor - n.x * along.y;
    J[dim] = M.yx * factor - n.y * along.x;
    J[dim + 1] = M.yy * factor - n.y * along.y;
    if (dim == 2)
        return;
    w->planar->rate_gradient(w->planar->ctx, (size_t) w->observable, place(u),
                             &rate, &g);
    J[6] = w->arc ? -(g.x - rate * along.x) * time : g.x;
    J[7] = w->arc ? -(g.y - rate * along.y) * time : g.y;
    J[2] = J[5] = J[8] = 0.0;
}

struct method_system workprec_method_system(const struct workprec_system *w)
{
    return (struct method_system){
        .dim = w->observable == WORKPREC_ALONE ? 2 : 3,
        .rates = rates,
        .jacobian = jacobian,
        .ctx = w,
        .calls_most = SIZE_MAX,
    };
}
