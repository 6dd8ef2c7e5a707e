#include "plane_weak.h"

#include <math.h>

#include "plane_rest.h"

/* The middle of number i of the equilibria and of the undecided boxes, and how
 * far from there it is; below 0: it is hyperbolic. */
static double spot(const struct plane_study *s, size_t i, struct vec2 *z)
{
    if (i < s->rests) {
        *z = s->rest[i].z;
        return s->rest[i].type == PLANE_NONHYPERBOLIC &&
                       !plane_rest_attracts(&s->rest[i], false) &&
                       !plane_rest_attracts(&s->rest[i], true)
                   ? 0.0
                   : -HUGE_VAL;
    }
    const struct plane_box *b = &s->undecided[i - s->rests];
    const struct vec2 lo = { plane_chart(s, 0, b->range[0][0]),
                             plane_chart(s, 1, b->range[1][0]) },
                      hi = { plane_chart(s, 0, b->range[0][1]),
                             plane_chart(s, 1, b->range[1][1]) };

    *z = vec2_scale(0.5, vec2_add(lo, hi));
    return vec2_length(arrival_from(&s->scale, hi, *z));
}

bool plane_weak_at(const struct plane_study *s, struct vec2 z, double near)
{
    struct vec2 middle;

    for (size_t i = 0; i < s->rests + s->undecided_count; i++) {
        const double reach = near + spot(s, i, &middle);
        if (vec2_length(arrival_from(&s->scale, z, middle)) <= reach)
            return true;
    }
    return false;
}

bool plane_weak_along(const struct plane_study *s, const struct curve *c,
                      size_t piece, struct vec2 origin, double near,
                      double *theta)
{
    struct vec2 middle;
    double at;
    bool meets = false;

    *theta = 1.0;
    for (size_t i = 0; i < s->rests + s->undecided_count; i++) {
        const double reach = near + spot(s, i, &middle);
        if (!(reach >= 0.0 && arrival_nearest(&s->scale, c, piece, origin,
                                              middle, reach, &at) <= reach))
            continue;
        meets = true;
        *theta = fmin(*theta, at);
    }
    return meets;
}
