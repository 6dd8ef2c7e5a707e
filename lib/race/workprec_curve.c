#include "workprec_curve.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "quad_step.h"
#include "workprec_tolerance.h"

enum { KNOTS_MOST = 4000, HALVINGS = 12 };

struct graph {
    const struct workprec_curve *c;
    int ind; /* 0: y(x), 1: x(y) */
};

/* Unit tangent, outward: against time. */
static void tangent(const struct law *law, const struct quad_anchor *at,
                    const quad z[2], quad n[2])
{
    struct quad_field f;

    quad_block_field(law, at, z[0], z[1], &f);
    const quad size = -sqrtq(f.direction[0] * f.direction[0] +
                             f.direction[1] * f.direction[1]);
    n[0] = f.direction[0] / size;
    n[1] = f.direction[1] / size;
}

static void arc_rates(const void *ctx, quad s, const quad z[2], quad dz[2])
{
    const struct workprec_curve *c = ctx;

    (void) s;
    tangent(c->law, c->at, z, dz);
}

/* u[0]: the dependent coordinate. */
static void graph_rates(const void *ctx, quad s, const quad u[2], quad du[2])
{
    const struct graph *g = ctx;
    const quad z[2] = { g->ind == 0 ? s : u[0], g->ind == 0 ? u[0] : s };
    quad n[2];

    tangent(g->c->law, g->c->at, z, n);
    du[0] = n[1 - g->ind] / n[g->ind];
    du[1] = 0;
}

/* ---- growing --------------------------------------------------------- */

/* The field's linear part, rates per offset, up to a common factor. */
static void linear_part(const struct workprec_curve *c, quad J[2][2])
{
    struct quad_field f[2];

    quad_block_field(c->law, c->at, (quad) WORKPREC_CURVE_PROBE, 0, &f[0]);
    quad_block_field(c->law, c->at, 0, (quad) WORKPREC_CURVE_PROBE, &f[1]);
    const quad factor = expq(f[1].log_scale - f[0].log_scale);
    for (int i = 0; i < 2; i++) {
        J[i][0] = f[0].direction[i];
        J[i][1] = f[1].direction[i] * factor;
    }
}

/* The first knot; false where it is no saddle. */
static bool first_knot(const struct workprec_curve *c, int side,
                       struct workprec_knot *k)
{
    quad J[2][2];

    linear_part(c, J);
    const quad half = (J[0][0] + J[1][1]) / 2;
    const quad det = J[0][0] * J[1][1] - J[0][1] * J[1][0];
    if (!(det < 0))
        return false;
    const quad minus = half - copysignq(sqrtq(half * half - det), 1);
    const quad p = minus - J[0][0], q = minus - J[1][1];
    const bool first = fabsq(J[0][1]) + fabsq(p) > fabsq(q) + fabsq(J[1][0]);
    const quad x = first ? J[0][1] : q, y = first ? p : J[1][0];
    const quad size = copysignq(sqrtq(x * x + y * y), x) * side;
    k->n[0] = x / size;
    k->n[1] = y / size;
    for (int i = 0; i < 2; i++)
        k->z[i] = k->n[i] * (quad) WORKPREC_CURVE_START;
    return true;
}

static enum status push(struct workprec_curve *c, const struct workprec_knot *k)
{
    if (c->count == c->room) {
        const size_t room = c->room ? 2 * c->room : 256;
        struct workprec_knot *more = realloc(c->knot, room * sizeof *more);
        if (more == NULL)
            return STATUS_NO_MEMORY;
        c->knot = more;
        c->room = room;
    }
    c->knot[c->count++] = *k;
    return STATUS_OK;
}

static quad size_of(const quad z[2])
{
    return sqrtq(z[0] * z[0] + z[1] * z[1]);
}

/* One step of at most *h; *h is what to try next. */
static bool step(const struct workprec_curve *c, struct workprec_knot *k,
                 quad *h)
{
    for (int i = 0; i < HALVINGS; i++, *h /= 2) {
        quad to[2], error[2];
        const quad size = size_of(k->z);
        const quad allowed = (quad) WORKPREC_CURVE_TOL * (size < 1 ? size : 1);
        const quad enough[2] = { allowed / 10, allowed / 10 };
        const struct quad_step step =
            quad_step(arc_rates, c, 0, *h, k->z, enough, to, error);
        const double off = (double) ((error[0] + error[1]) / allowed);
        if (!(off <= 1.0))
            continue;
        memcpy(k->z, to, sizeof to);
        tangent(c->law, c->at, k->z, k->n);
        *h *= quad_step_factor(&step, off);
        return true;
    }
    return false;
}

static bool holds(struct box b, const quad z[2])
{
    return z[0] >= b.lo.x && z[0] <= b.hi.x && z[1] >= b.lo.y && z[1] <= b.hi.y;
}

enum status workprec_curve_grow(const struct law *law,
                                const struct quad_anchor *at, int side,
                                struct box reach, struct workprec_curve *c)
{
    struct workprec_knot k;
    quad h = (quad) WORKPREC_CURVE_START / 2;

    *c = (struct workprec_curve){ .law = law, .at = at };
    if (!first_knot(c, side, &k))
        return STATUS_NO_CONVERGENCE;
    enum status s = push(c, &k);
    while (s == STATUS_OK && holds(reach, k.z)) {
        const bool good = c->count < KNOTS_MOST && step(c, &k, &h);
        s = good ? push(c, &k) : STATUS_NO_CONVERGENCE;
        if (h > (quad) WORKPREC_CURVE_LONGEST)
            h = (quad) WORKPREC_CURVE_LONGEST;
    }
    if (s != STATUS_OK)
        workprec_curve_free(c);
    return s;
}

/* ---- asking ---------------------------------------------------------- */

/* The dependent coordinate where the independent one is `to`, from a knot. */
static quad follow(const struct graph *g, const struct workprec_knot *k,
                   quad to)
{
    quad u[2] = { k->z[1 - g->ind], 0 }, s = k->z[g->ind], h = to - s;

    for (int i = 0; s != to && i < 64 * HALVINGS; i++) {
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

static size_t nearest(const struct workprec_curve *c, const quad z[2])
{
    size_t best = 0;
    quad least = (quad) HUGE_VAL;

    for (size_t i = 0; i < c->count; i++) {
        const quad off[2] = { z[0] - c->knot[i].z[0], z[1] - c->knot[i].z[1] };
        const quad size = size_of(off);
        if (size < least) {
            least = size;
            best = i;
        }
    }
    return best;
}

double workprec_curve_distance(const struct workprec_curve *c, const quad z[2])
{
    const struct workprec_knot *k = &c->knot[nearest(c, z)];
    const struct graph g = { c, fabsq(k->n[1]) > fabsq(k->n[0]) };
    const quad way = z[g.ind] - k->z[g.ind];
    const quad off[2] = { z[0] - k->z[0], z[1] - k->z[1] };

    if (size_of(off) > (quad) WORKPREC_CURVE_FAR)
        return (double) HUGE_VAL;
    const quad dep = way == 0 ? k->z[1 - g.ind] : follow(&g, k, z[g.ind]);
    const quad point[2] = { g.ind == 0 ? z[0] : dep, g.ind == 0 ? dep : z[1] };
    quad n[2];
    tangent(c->law, c->at, point, n);
    return fabs((double) ((z[1 - g.ind] - dep) * n[g.ind]));
}

quad workprec_curve_cross(const struct workprec_curve *c, size_t before, quad y)
{
    const struct graph g = { c, 1 };

    return follow(&g, &c->knot[before], y);
}

void workprec_curve_free(struct workprec_curve *c)
{
    free(c->knot);
    *c = (struct workprec_curve){ .knot = NULL };
}
