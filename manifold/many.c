#include "many.h"

#include <math.h>

static void many_alone(const struct planar *sys, struct vec2 z, int which,
                       bool slopes, struct planar_look *out)
{
    if (slopes)
        sys->jacobian(sys->ctx, z, &out->J);
    else
        sys->field(sys->ctx, z, &out->J.field);
    out->unit = exp(-out->J.field.log_scale);
    if (which >= 0)
        sys->rate_gradient(sys->ctx, (size_t) which, z, &out->rate,
                           slopes ? &out->gradient : NULL);
}

void many_at(const struct planar *const sys[], size_t n, const struct vec2 z[],
             int which, bool slopes, struct planar_look out[])
{
    const struct planar_many *many = n > 1 ? sys[0]->many : NULL;
    const void *ctx[JET_MANY];
    size_t some = 1;

    for (size_t i = 0; i < n; i += some) {
        some = !many ? 1 : n - i < JET_MANY ? n - i : JET_MANY;
        for (size_t k = 0; k < some; k++)
            ctx[k] = sys[i + k]->ctx;
        if (some > 1)
            many->look(ctx, some, z + i, which, slopes, out + i);
        else
            many_alone(sys[i], z[i], which, slopes, &out[i]);
    }
}

void many_along(const struct planar *sys, size_t n, const struct vec2 z[],
                int which, bool slopes, struct planar_look out[])
{
    const struct planar *all[JET_MANY];
    size_t some;

    for (size_t i = 0; i < JET_MANY; i++)
        all[i] = sys;
    for (size_t i = 0; i < n; i += some) {
        some = n - i < JET_MANY ? n - i : JET_MANY;
        many_at(all, some, z + i, which, slopes, out + i);
    }
}

bool many_alike(const struct planar *sys, const struct planar *other)
{
    return sys == other || (sys->many && sys->many == other->many &&
                            sys->many->alike(sys->ctx, other->ctx));
}

bool many_carry_alike(const struct carry *carry, const struct carry *other)
{
    bool alike = carry->count == other->count;

    for (size_t i = 0; i < carry->count && alike; i++)
        alike = carry->which[i] == other->which[i];
    return alike;
}

int many_carried(const struct carry *carry)
{
    const bool one = carry->count == 1 && carry->which[0] != CARRY_TIME;

    return one ? (int) carry->which[0] : -1;
}
