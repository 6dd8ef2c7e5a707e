/*
 * The graph y(x) or x(y), whichever is flatter, in offsets from the saddle.
 * Start: the eigenvector of differences 1e-18/(1 + psi) away from the saddle.
 * Near it, with s = ln|ind|, r = dep/ind and w = excess/ind are all but
 * constant:  dr/ds = slope - r,  dw/ds = d excess/d ind - w.  Further out the
 * graph itself.  End: where nothing changes any more, by tol.
 */
#include "quad_branch.h"

#include <string.h>

#include "quad_step.h"

enum { STEPS_MAX = 20000 };

static const double nearest = 1e-18, near_saddle = 1e-2;
static const double steep = 1.5;     /* |slope| above which the graph turns */
static const double longest = 3.2;   /* substeps of 0.4 see what there is */
static const double stride = 0.4;    /* likewise, as a part of the way */
static const double far = 300.0;     /* no limit within this of the saddle */
static const double top = 700.0;     /* of the plane: ln psi */
static const double bottom = -1e300; /* of psi that is a logarithm */
static const double decay = 0.2; /* rate at which a slope decays to nothing */

struct grower {
    const struct law *law;
    const struct quad_anchor *at;
    quad tol;
    quad start;   /* distance from the saddle where the growth starts */
    int ind;      /* 0: y(x), 1: x(y) */
    int way;      /* sign of the steps of ind */
    bool near;    /* in r, w over s */
    quad s, u[2]; /* ind, or ln|ind|; dep and excess, or r and w */
    quad h;
    quad slope, rate; /* d dep/d ind, d excess/d ind at the last point */
    size_t stride;    /* steps between points of the path */
    struct quad_branch *out;
};

static quad field_at(const struct grower *g, const quad z[2], quad rate[2])
{
    struct quad_field f;

    quad_block_field(g->at, z[0], z[1], &f);
    rate[0] = f.direction[0];
    rate[1] = f.direction[1];
    g->out->evaluations++;
    return f.log_scale;
}

/* d dep/d ind and d excess/d ind. */
static void slopes(const struct grower *g, quad ind, quad dep, quad out[2])
{
    const quad z[2] = { g->ind == 0 ? ind : dep, g->ind == 0 ? dep : ind };
    quad f[2];
    const quad scale = field_at(g, z, f);
    const quad excess = quad_block_rate(g->at, BLOCK_EXCESS, z[0], z[1]);

    out[0] = f[1 - g->ind] / f[g->ind];
    out[1] = excess * expq(-scale) / f[g->ind];
}

static void graph_rates(const void *ctx, quad s, const quad u[2], quad du[2])
{
    const struct grower *g = ctx;

    slopes(g, s, u[0], du);
}

static void near_rates(const void *ctx, quad s, const quad u[2], quad du[2])
{
    const struct grower *g = ctx;
    const quad ind = g->way * expq(s);

    slopes(g, ind, u[0] * ind, du);
    du[0] -= u[0];
    du[1] -= u[1];
}

/* ---- start ----------------------------------------------------------- */

/* The field's linear part, rates per offset, up to a common factor. */
static void linear_part(const struct grower *g, quad J[2][2])
{
    quad scale[2];

    for (int j = 0; j < 2; j++) {
        const quad z[2] = { j == 0 ? g->start : 0, j == 1 ? g->start : 0 };
        quad f[2];
        scale[j] = field_at(g, z, f);
        for (int i = 0; i < 2; i++)
            J[i][j] = f[i];
    }
    for (int i = 0; i < 2; i++)
        J[i][1] *= expq(scale[1] - scale[0]);
}

/* The eigenvector to the negative eigenvalue; false where there is none or
 * the other is not positive. */
static bool set_start(struct grower *g, int side)
{
    quad J[2][2], slope[2];

    linear_part(g, J);
    const quad half = (J[0][0] + J[1][1]) / 2;
    const quad det = J[0][0] * J[1][1] - J[0][1] * J[1][0];
    if (!(det < 0))
        return false;
    const quad minus = half - copysignq(sqrtq(half * half - det), 1);
    const quad p = minus - J[0][0], q = minus - J[1][1];
    /* (J01, p) and (q, J10) are multiples of it; no digits are lost in the
       larger difference */
    const bool first = fabsq(p) > fabsq(q);
    const quad x = first ? J[0][1] : q, y = first ? p : J[1][0];
    g->ind = fabsq(y) > fabsq(x);
    g->way = g->ind == 0 || (x > 0) == (y > 0) ? side : -side;
    g->near = true;
    g->s = logq(g->start);
    g->u[0] = g->ind == 0 ? y / x : x / y;
    slopes(g, g->way * g->start, g->u[0] * g->way * g->start, slope);
    g->u[1] = slope[1];
    g->slope = g->u[0];
    g->h = 1;
    return true;
}

/* ---- steps ----------------------------------------------------------- */

/* Whether dep is psi itself, which is known relatively. */
static bool is_plain_psi(const struct grower *g)
{
    return g->ind == 0 && law_psi_is_log(g->law);
}

/* What a step to u may be off by: dep absolutely, excess relatively. */
static void find_allowed(const struct grower *g, const quad u[2],
                         quad allowed[2])
{
    quad size = fabsq(u[0]);

    if (!g->near) /* dep may pass through zero */
        size += fabsq(g->h * g->slope) / 16;
    if (!g->near && size > 1 && !is_plain_psi(g))
        size = 1;
    allowed[0] = size * g->tol;
    allowed[1] = fabsq(u[1]) * g->tol;
}

static void choose_step(struct grower *g, const struct quad_step *step,
                        double error)
{
    const quad way = g->near ? 0 : stride * fabsq(g->s);
    const quad most = way > longest ? way : longest;

    g->h *= quad_step_factor(step, error);
    if (g->h > most)
        g->h = most;
}

/* Moves on by one accepted step; false when none is short enough. */
static bool move(struct grower *g)
{
    for (int attempt = 0; attempt < 60; attempt++) {
        const quad h = g->near ? g->h : g->way * g->h;
        quad to[2], error[2], allowed[2];
        find_allowed(g, g->u, allowed);
        const quad enough[2] = { allowed[0] / 10, allowed[1] / 10 };
        const struct quad_step step =
            quad_step(g->near ? near_rates : graph_rates, g, g->s, h, g->u,
                      enough, to, error);
        find_allowed(g, to, allowed);
        const double wrong =
            (double) (error[0] / allowed[0] + error[1] / allowed[1]);
        if (wrong <= 1.0) {
            g->s += h;
            g->u[0] = to[0];
            g->u[1] = to[1];
            g->out->error += g->near ? 0 : error[0];
            g->out->excess_error += g->near ? 0 : error[1];
            choose_step(g, &step, wrong);
            return true;
        }
        choose_step(g, &step, wrong);
    }
    return false;
}

/* ---- knees ----------------------------------------------------------- */

/* A step made, with d dep/ds or dr/ds at its ends. */
struct stretch {
    const struct grower *from;
    quad h, rise; /* of s and of u[0] */
    quad rate[2];
};

static quad rate_of(const struct grower *g)
{
    quad rate[2];

    (g->near ? near_rates : graph_rates)(g, g->s, g->u, rate);
    return rate[0];
}

/* By the cubic through the ends; or by a step of its own. */
static void point_on(const void *ctx, bool rough, quad part, quad z[2],
                     quad way[2])
{
    const struct stretch *p = ctx;
    const struct grower *g = p->from;
    const quad rest = 1 - part, s = g->s + part * p->h;
    quad u[2] = { g->u[0], g->u[1] }, error[2], allowed[2], f[2];

    if (rough) {
        u[0] += part * p->rise + part * rest *
                                     (rest * (p->h * p->rate[0] - p->rise) -
                                      part * (p->h * p->rate[1] - p->rise));
    } else if (part > 0) {
        find_allowed(g, g->u, allowed);
        quad_step(g->near ? near_rates : graph_rates, g, g->s, part * p->h,
                  g->u, allowed, u, error);
    }
    const quad ind = g->near ? g->way * expq(s) : s;
    z[g->ind] = ind;
    z[1 - g->ind] = g->near ? u[0] * ind : u[0];
    field_at(g, z, f);
    for (int i = 0; i < 2; i++) /* backward in time */
        way[i] = -f[i];
}

static void find_knees(const struct grower *from, const struct grower *to)
{
    const struct stretch stretch = { from,
                                     to->s - from->s,
                                     to->u[0] - from->u[0],
                                     { rate_of(from), rate_of(to) } };
    const struct quad_arc arc = { point_on, &stretch };

    quad_knee_add(&arc, &to->out->knees);
}

/* ---------------------------------------------------------------------- */

/* From r, w over ln|ind| to the graph. */
static void leave_saddle(struct grower *g)
{
    const quad ind = g->way * expq(g->s);

    g->near = false;
    g->s = ind;
    g->u[0] *= ind;
    g->u[1] *= ind;
    g->h = fabsq(ind) / 2;
}

/* The other coordinate becomes the independent one. */
static void turn(struct grower *g)
{
    if (g->near)
        leave_saddle(g);
    const quad ind = g->s;
    g->s = g->u[0];
    g->u[0] = ind;
    g->h *= fabsq(g->slope);
    g->way = g->slope > 0 ? g->way : -g->way;
    g->slope = 1 / g->slope;
    g->ind = 1 - g->ind;
}

/* ---- end ------------------------------------------------------------- */

/* Whether nothing changes any more. */
static bool is_still(const struct grower *g)
{
    const quad dep = fabsq(g->u[0]), still = g->tol / 10;

    return fabsq(g->slope) < still * (dep < 1 || is_plain_psi(g) ? dep : 1) &&
           fabsq(g->rate) < still * fabsq(g->u[1]);
}

/* Whether nothing ever will: as ind runs on, the slope decays exponentially. */
static bool is_done(const struct grower *g)
{
    const quad on = far > fabsq(g->s) ? far : fabsq(g->s);
    quad middle[2], edge[2];

    if (!is_still(g))
        return false;
    slopes(g, g->s + g->way * on, g->u[0], middle);
    slopes(g, g->s + g->way * on * 2, g->u[0], edge);
    return edge[0] == 0 || logq(middle[0] / edge[0]) > decay * on;
}

static bool has_ended(const struct grower *g)
{
    struct quad_branch *out = g->out;
    const bool done = is_done(g), is_log = law_psi_is_log(g->law);
    /* psi far above psi_0, too, where y is its logarithm */
    const bool beyond = is_log ? g->s > 2 * far : g->s > 30;

    out->end = QUAD_TRUNCATED;
    if (g->ind == 1 && g->way > 0) {
        out->end = done ? QUAD_PSI_INF : QUAD_OPEN;
        return done || (beyond && (is_log || g->at->y0 + g->s > top));
    }
    if (done)
        out->end = g->ind == 1 ? QUAD_PSI_0 : g->way < 0 ? QUAD_V_0 : out->end;
    if (is_log && g->ind == 1)
        return done || g->s < bottom;
    return done || fabsq(g->s) > far;
}

/* ---- path ------------------------------------------------------------ */

static void place(const struct grower *g, quad z[2])
{
    const quad ind = g->near ? g->way * expq(g->s) : g->s;

    z[g->ind] = ind;
    z[1 - g->ind] = g->near ? g->u[0] * ind : g->u[0];
}

/* Every second point goes where there is no room left. */
static void add_point(struct grower *g)
{
    struct quad_branch *out = g->out;

    if (out->points == QUAD_PATH) {
        out->points /= 2;
        for (size_t i = 0; i < out->points; i++)
            memcpy(out->path[i], out->path[2 * i], sizeof *out->path);
        g->stride *= 2;
    }
    place(g, out->path[out->points++]);
}

/* ---------------------------------------------------------------------- */

bool quad_branch_grow(const struct law *law, const struct quad_anchor *at,
                      int side, double tol, struct quad_branch *out)
{
    struct grower g = {
        .law = law, .at = at, .tol = tol, .stride = 1, .out = out
    };
    /* what counts in the kinetics is psi times an offset of ln psi */
    const quad psi = law_psi_is_log(law) ? 0 : fabsq(at->psi0);
    bool ended = false;

    *out = (struct quad_branch){ .at = at, .end = QUAD_TRUNCATED };
    g.start = nearest / (1 + psi);
    if (!set_start(&g, side))
        return false;
    for (struct grower from = g; !ended && out->steps < STEPS_MAX && move(&g);
         from = g) {
        quad both[2];
        find_knees(&from, &g);
        const quad ind = g.near ? g.way * expq(g.s) : g.s;
        slopes(&g, ind, g.near ? g.u[0] * ind : g.u[0], both);
        g.slope = both[0];
        g.rate = both[1];
        if (out->steps++ % g.stride == 0)
            add_point(&g);
        if (fabsq(g.slope) > steep)
            turn(&g);
        else if (g.near && fabsq(ind) > near_saddle)
            leave_saddle(&g);
        else if (!g.near)
            ended = has_ended(&g);
    }
    if (!ended)
        out->end = QUAD_TRUNCATED;
    add_point(&g);
    out->x = g.ind == 0 ? g.s : g.u[0];
    out->y = g.ind == 0 ? g.u[0] : g.s;
    out->excess = -g.u[1];
    out->error /= fabsq(g.u[0]);
    out->excess_error /= fabsq(g.u[1]);
    return true;
}
