/* setting.h -- random laws, materials and anchors, in double and in 113 bits,
 * and random points around them. */
#pragma once

#include <math.h>

#include "block.h"
#include "exact_anchor.h"
#include "laws.h"
#include "quad_block.h"
#include "tolerance.h"

/* A law, a material and an anchor on its steady-state curve in both kinds. */
struct setting {
    size_t number;
    struct law law;
    struct material m;
    long double x, tan_alpha;
    quad exact_tan; /* of which x is an exact equilibrium, if it is one */
    struct block b;
    struct quad_anchor at;
    struct exact_anchor hand; /* the same point by hand */
};

/* The anchor must lie in the chart's domain. */
static inline bool set_anchor(struct setting *s, double x,
                              long double tan_alpha, bool equilibrium)
{

    if (x >= steady_x_max(&s->law))
        return false;
    s->x = (long double) x;
    s->exact_tan =
        equilibrium ? quad_block_mu_ss(&s->law, &s->m, s->x) : (quad) tan_alpha;
    s->tan_alpha = (long double) s->exact_tan;
    if (!(s->tan_alpha > 1e-6L && s->tan_alpha < 100))
        return false;
    block_init(&s->b, &s->law, &s->m, s->tan_alpha);
    block_anchor(&s->b, s->x, equilibrium);
    quad_block_anchor(&s->law, &s->m, s->exact_tan, s->x, equilibrium, &s->at);
    s->hand = exact_anchor_at(&s->law, &s->m, s->exact_tan, s->x, equilibrium);
    return fabs(s->b.at.y0) < LN_RANGE || /* or friction of 1e30 */
           (law_psi_is_log(&s->law) && fabs(s->b.at.y0) < 1e30);
}

/* Setting i of a run: every law in turn, equilibrium or not, within +-range. */
static inline bool draw_setting(size_t i, double range, uint64_t *seed,
                                struct setting *s)
{
    s->number = i % LAWS;
    if (!laws_draw(s->number, seed, &s->law, &s->m))
        return false;
    for (int attempt = 0; attempt < 40; attempt++)
        if (set_anchor(s, check_uniform(seed, -range, range),
                       (long double) laws_power(seed, -2, 1),
                       check_bits(seed) % 2))
            return true;
    return false;
}

/* A point anywhere in the domain, or near the anchor. */
static inline struct vec2 draw_far(const struct setting *s, uint64_t *seed)
{
    const struct box d = block_planar(&s->b).domain;
    const bool deep = d.lo.y < -1e3 && check_bits(seed) % 8 == 0;
    const double far = deep ? 300 : d.hi.x; /* v psi is a double, too */

    return (struct vec2){
        check_uniform(seed, -far, far) - s->b.at.x0,
        (deep ? -laws_power(seed, 3, 30)
              : check_uniform(seed, fmax(d.lo.y, -1e3), d.hi.y)) -
            s->b.at.y0,
    };
}

static inline struct vec2 draw_near(double lo, double hi, uint64_t *seed)
{
    const double r = laws_power(seed, lo, hi);
    const double angle = check_uniform(seed, 0, 6.283185307179586);
    return (struct vec2){ r * cos(angle), r * sin(angle) };
}
