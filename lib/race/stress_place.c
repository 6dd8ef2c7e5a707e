#include "stress_place.h"

#include <math.h>
#include <stdlib.h>

#include "labels.h"
#include "slider.h"
#include "stress_tolerance.h"

/* What does not fit on a stack, and must not move. */
struct work {
    struct slider slider;
    struct labels labels;
};

/* The first end of a piece of the branch that far from the saddle, or the point
 * there of a branch that is straight beyond its last one. */
static bool find_offset(const struct branch *b, double far, struct vec2 *out)
{
    for (size_t i = 0; i < b->curve.count; i++) {
        *out = curve_point(&b->curve, i, 1.0);
        if (fmax(fabs(out->x), fabs(out->y)) >= far)
            return true;
    }
    *out = b->limit;
    if (b->end == BRANCH_LIMIT_X)
        out->y = copysign(far, b->limit.y);
    else if (b->end == BRANCH_LIMIT_Y)
        out->x = copysign(far, b->limit.x);
    return b->curve.count > 0 &&
           (b->end == BRANCH_LIMIT_X || b->end == BRANCH_LIMIT_Y);
}

/* On one of the stable branches, which begin at the saddle on either side. */
static bool find_point(const struct labels *l, double along, struct vec2 *out)
{
    for (int i = 0; i < 2; i++)
        if (find_offset(&l->stable[i], fabs(along), out) &&
            out->x * along > 0.0)
            return true;
    return false;
}

static void put(const struct slider *s, struct vec2 offset,
                struct stress_centre *out)
{
    const struct planar *system = &s->plane.system;
    const struct vec2 z = vec2_add(system->origin, offset);

    *out = (struct stress_centre){ true, exp(z.x),
                                   system->axis[1].is_log ? exp(z.y) : z.y };
}

static enum status find(struct work *w, double along, struct stress_centre *out)
{
    struct vec2 offset = { 0.0, 0.0 };

    if (!slider_has_manifolds(&w->slider))
        return STATUS_OK;
    if (along == 0.0) {
        put(&w->slider, offset, out);
        return STATUS_OK;
    }
    const enum status s =
        labels_init(&w->labels, &w->slider, STRESS_PLACE_RTOL, NULL);
    if (s == STATUS_OK && find_point(&w->labels, along, &offset))
        put(&w->slider, offset, out);
    return s == STATUS_NO_MEMORY ? s : STATUS_OK;
}

enum status stress_place_find(const struct law *law, const struct material *m,
                              double alpha, double along,
                              struct stress_centre *out)
{
    struct work *w = calloc(1, sizeof *w);

    *out = (struct stress_centre){ .exists = false };
    if (w == NULL)
        return STATUS_NO_MEMORY;
    slider_init(&w->slider, law, m, tanl((long double) alpha));
    const enum status s = find(w, along, out);
    labels_free(&w->labels);
    free(w);
    return s;
}
