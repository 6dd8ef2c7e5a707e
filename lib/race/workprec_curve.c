#include "workprec_curve.h"

#include <math.h>

#include "quad_step.h"
#include "workprec_tolerance.h"

enum { STEPS = 768 };

struct graph {
    const struct quad_branch *c;
    int ind; /* 0: y(x), 1: x(y) */
};

/* Against time. */
void workprec_curve_tangent(const struct quad_branch *c, const quad z[2],
                            quad n[2])
{
    struct quad_field f;

    quad_block_field(c->at, z[0], z[1], &f);
    const quad size = -sqrtq(f.direction[0] * f.direction[0] +
                             f.direction[1] * f.direction[1]);
    n[0] = f.direction[0] / size;
    n[1] = f.direction[1] / size;
}

/* u[0]: the dependent coordinate. */
static void graph_rates(const void *ctx, quad s, const quad u[2], quad du[2])
{
    const struct graph *g = ctx;
    const quad z[2] = { g->ind == 0 ? s : u[0], g->ind == 0 ? u[0] : s };
    quad n[2];

    workprec_curve_tangent(g->c, z, n);
    du[0] = n[1 - g->ind] / n[g->ind];
    du[1] = 0;
}

/* The dependent coordinate where the independent one is `to`, from a knot. */
static quad follow(const struct graph *g, const quad from[2], quad to)
{
    quad u[2] = { from[1 - g->ind], 0 }, s = from[g->ind], h = to - s;

    for (int i = 0; s != to && i < STEPS; i++) {
        quad next[2], error[2];
        if (fabsq(h) > fabsq(to - s))
            h = to - s;
        const quad allowed =
            (quad) WORKPREC_CURVE_TOL * (fabsq(u[0]) + fabsq(h));
        const quad enough[2] = { allowed / 10, allowed };
        quad_step(graph_rates, g, s, h, u, enough, next, error);
        if (error[0] <= allowed) {
            s = h == to - s ? to : s + h;
            u[0] = next[0];
        } else {
            h /= 2;
        }
    }
    return s == to ? u[0] : (quad) NAN;
}

static const quad *nearest(const struct quad_branch *c, const quad z[2])
{
    const quad *best = NULL;
    quad least = (quad) HUGE_VAL;

    for (size_t i = 0; i < c->points; i++) {
        const quad *at = c->path[i];
        const quad x = z[0] - at[0], y = z[1] - at[1], size = x * x + y * y;
        if (best == NULL || size < least) {
            least = size;
            best = at;
        }
    }
    return best;
}

double workprec_curve_distance(const struct quad_branch *c, const quad z[2])
{
    const quad *from = nearest(c, z);
    quad n[2];

    workprec_curve_tangent(c, from, n);
    const struct graph g = { c, fabsq(n[1]) > fabsq(n[0]) };
    const quad dep = follow(&g, from, z[g.ind]);
    const quad point[2] = { g.ind == 0 ? z[0] : dep, g.ind == 0 ? dep : z[1] };
    workprec_curve_tangent(c, point, n);
    const double off = fabs((double) ((z[1 - g.ind] - dep) * n[g.ind]));
    return isnan(off) ? HUGE_VAL : off;
}

quad workprec_curve_cross(const struct quad_branch *c, size_t before, quad y)
{
    const struct graph g = { c, 1 };

    return follow(&g, c->path[before], y);
}
