/* quad_side.h -- on which side of a saddle's stable manifold a state lies, by
 * its forward orbit in 113 bits into one of the quadrants of the saddle that
 * cannot be left. */
#pragma once

#include <math.h>

#include "check.h"
#include "quad_block.h"
#include "quad_step.h"
#include "study.h"

struct quad_side {
    struct law law;
    struct quad_anchor at; /* of the saddle */
};

/* Of the saddle of s. */
static inline struct quad_side quad_side_of(const struct study *s)
{
    const struct block *b = &s->slider.block;
    struct quad_side o = { .law = b->law };
    const quad h = (quad) 1e-3;
    quad near = h;

    for (size_t i = 0; i < s->slider.plane.equilibria; i++)
        if ((int) i != slider_saddle(&s->slider)) {
            const quad d = fabsq((quad) (s->slider.plane.equilibrium[i].z.x -
                                         s->slider.plane.system.origin.x)) /
                           2;
            near = d < near ? d : near;
        }
    const quad x = quad_block_equilibrium(&b->law, &b->material, b->tan_alpha,
                                          b->x - near, b->x + near);
    quad_block_anchor(&b->law, &b->material, b->tan_alpha, x, true, &o.at);
    return o;
}

/* Along the orbit, in units of the distance from the saddle. */
static inline void quad_side_rates(const void *ctx, quad s, const quad u[2],
                                   quad du[2])
{
    const struct quad_side *o = ctx;
    struct quad_field f;

    (void) s;
    quad_block_field(&o->at, u[0], u[1], &f);
    const quad size = sqrtq(f.direction[0] * f.direction[0] +
                            f.direction[1] * f.direction[1]);
    const quad r = sqrtq(u[0] * u[0] + u[1] * u[1]);
    du[0] = r * f.direction[0] / size;
    du[1] = r * f.direction[1] / size;
}

/* 0: slow, it stops; 1: fast; 2: not told. */
static inline int quad_side_of_offset(const struct quad_side *o, quad x, quad y)
{
    quad u[2] = { x, y }, to[2], error[2], h = (quad) 0.1;

    for (int n = 0; n < 2000; n++) {
        if (u[0] <= 0 && u[1] >= 0)
            return 0;
        if (u[0] >= 0 && u[1] <= 0)
            return 1;
        const quad allowed = (quad) 1e-24 * sqrtq(u[0] * u[0] + u[1] * u[1]);
        const quad enough[2] = { allowed / 10, allowed / 10 };
        const struct quad_step step =
            quad_step(quad_side_rates, o, 0, h, u, enough, to, error);
        const double wrong = (double) ((error[0] + error[1]) / allowed);
        const bool holds = wrong <= 1.0 && step.blind <= 1.0;
        if (holds) {
            u[0] = to[0];
            u[1] = to[1];
        }
        const double factor = quad_step_factor(&step, wrong);
        h *= holds ? fmin(fmax(factor, 0.2), 3.0)
                   : fmin(isfinite(factor) ? factor : 0.1, 0.5);
        h = h > 1 ? 1 : h;
        if (!(h > (quad) 1e-25))
            return 2;
    }
    return 2;
}

/* Of the state (v, psi) as its doubles read. */
static inline int quad_side_of_state(const struct quad_side *o, double v,
                                     double psi)
{
    const quad y = law_psi_is_log(&o->law) ? (quad) psi : logq((quad) psi);

    return quad_side_of_offset(o, logq((quad) v) - o->at.x0, y - o->at.y0);
}
