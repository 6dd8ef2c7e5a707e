#include "stretched.h"

#include <string.h>

static void shrink(const struct stretched *s, struct planar_field *f)
{
    f->direction.x /= s->unit.x;
    f->direction.y /= s->unit.y;
}

static void field(const void *ctx, struct vec2 z, struct planar_field *f)
{
    const struct stretched *s = ctx;

    s->of->field(s->of->ctx, stretched_offset(s, (double[]){ z.x, z.y }), f);
    shrink(s, f);
}

static void jacobian(const void *ctx, struct vec2 z, struct planar_jacobian *J)
{
    const struct stretched *s = ctx;

    s->of->jacobian(s->of->ctx, stretched_offset(s, (double[]){ z.x, z.y }), J);
    shrink(s, &J->field);
    J->matrix.xy *= s->unit.y / s->unit.x;
    J->matrix.yx *= s->unit.x / s->unit.y;
}

static void rate_gradient(const void *ctx, size_t which, struct vec2 z,
                          double *rate, struct vec2 *gradient)
{
    const struct stretched *s = ctx;

    s->of->rate_gradient(s->of->ctx, which,
                         stretched_offset(s, (double[]){ z.x, z.y }), rate,
                         gradient);
    *rate /= s->rate[which];
    if (gradient)
        *gradient = (struct vec2){
            s->unit.x / s->rate[which] * gradient->x,
            s->unit.y / s->rate[which] * gradient->y,
        };
}

/* The domain's edge there. */
static struct vec2 edge(const struct stretched *s, struct vec2 at)
{
    const struct vec2 off = vec2_sub(at, s->of->origin);

    return (struct vec2){ off.x / s->unit.x, off.y / s->unit.y };
}

void stretched_init(struct stretched *s, const struct planar *sys,
                    struct vec2 unit, const double rate[])
{
    *s = (struct stretched){ .of = sys, .unit = unit };
    memcpy(s->rate, rate, sizeof s->rate);
    s->planar = (struct planar){
        .name = sys->name,
        .domain = { edge(s, sys->domain.lo), edge(s, sys->domain.hi) },
        .field = field,
        .jacobian = jacobian,
        .observables = sys->observables,
        .observable_count = sys->observable_count,
        .rate_gradient = rate_gradient,
        .ctx = s,
    };
}
