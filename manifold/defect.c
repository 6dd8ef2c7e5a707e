/*
 * One exponential step from Radau node to Radau node, each with S_dep and the
 * defect as they are there and the node's weight for its length (the weights'
 * partial sums lie between the nodes: Chebyshev, Markov, Stieltjes).  Without
 * S_dep that is Radau quadrature, and no less than the integral of a defect
 * whose ninth derivative has its sign: of theta^n, as a Taylor step's is, and
 * of exp(k theta), which its terms do not see coming, however steep, for the
 * end is a node.  And S_dep of any size does no harm.
 */
#include "defect.h"

#include <float.h>
#include <math.h>

#include "graph.h"
#include "many.h"
#include "tolerance.h"

enum { NODES = 5 };

/* On [0, 1]. */
static const double node[NODES] = { 0.0571041961145176822, 0.276843013638123828,
                                    0.58359043236891682, 0.860240135656219448,
                                    1.0 };
static const double weight[NODES] = { 0.143713560791225941, 0.28135601514946206,
                                      0.311826522975741254,
                                      0.223103901083570744, 0.04 };

/* Every operation of a field rounds, exponents by what they are, coordinates
 * likewise; near the origin only what is relative counts. */
static double rounding_of(const struct planar_field *f, struct vec2 z,
                          const struct defect_slope *s)
{
    const double far = fmin(1.0, fabs(z.x) + fabs(z.y));
    const double by_x = s->ind == 0 ? s->by_ind : s->by_dep;
    const double by_y = s->ind == 0 ? s->by_dep : s->by_ind;
    const double rounds = TOL_ROUNDINGS + fabs(f->log_scale);

    return DBL_EPSILON *
           (rounds * fabs(s->slope) + fabs(by_x) * (far + fabs(z.x)) +
            fabs(by_y) * (far + fabs(z.y)));
}

static struct defect_slope slope_of(int ind, struct vec2 z,
                                    const struct planar_jacobian *J)
{
    const struct vec2 f = J->field.direction;
    const struct mat2 m = J->matrix;
    const double slope = local_quotient(ind, f);
    struct defect_slope s = { .ind = ind, .slope = slope };

    if (ind == 0) {
        s.by_ind = (m.yx - slope * m.xx) / f.x;
        s.by_dep = (m.yy - slope * m.xy) / f.x;
    } else {
        s.by_ind = (m.xy - slope * m.yy) / f.y;
        s.by_dep = (m.xx - slope * m.yx) / f.y;
    }
    s.rounding = rounding_of(&J->field, z, &s);
    return s;
}

struct defect_slope defect_look(const struct planar *sys,
                                const struct branch *b, size_t piece,
                                double theta)
{
    struct planar_jacobian J;

    const struct vec2 z = curve_point(&b->curve, piece, theta);
    sys->jacobian(sys->ctx, z, &J);
    return slope_of(branch_graph(b, piece), z, &J);
}

struct defect defect_start(const struct branch *b, struct vec2 floor)
{
    double way[CURVE_DIM_MAX];

    curve_slope_at(&b->curve, 0, 0.0, way);
    const double saddle = branch_graph(b, 0) == 0
                              ? floor.y + fabs(way[1] / way[0]) * floor.x
                              : floor.x + fabs(way[0] / way[1]) * floor.y;
    return (struct defect){ 0.0, saddle };
}

/* (e^z - 1)/z */
static double mean_growth(double z)
{
    return z == 0.0 ? 1.0 : expm1(z) / z;
}

/* A piece's x and y at theta times a node, one after the other. */
static void piece_at(const struct branch *b, size_t piece, double theta,
                     struct graph_end at[2 * NODES])
{
    const double *u[2 * NODES];
    double s[2 * NODES];

    for (size_t i = 0; i < 2 * NODES; i++) {
        u[i] = curve_component(&b->curve, piece, i % 2);
        s[i] = theta * node[i / 2];
    }
    graph_ends(b->curve.piece[piece].degree, 2 * NODES, u, s, at);
}

struct defect defect_carry(const struct planar *sys, const struct branch *b,
                           size_t piece, double theta, struct defect e)
{
    const int over = branch_graph(b, piece);
    struct graph_end at[2 * NODES];
    struct planar_look seen[NODES];
    struct vec2 z[NODES];

    piece_at(b, piece, theta, at);
    for (int i = 0; i < NODES; i++)
        z[i] = (struct vec2){ at[2 * i].value, at[2 * i + 1].value };
    many_along(sys, NODES, z, -1, true, seen);
    for (int i = 0; i < NODES; i++) {
        const struct defect_slope s = slope_of(over, z[i], &seen[i].J);
        const double length = theta * weight[i];
        const double ind = at[2 * i + over].slope,
                     dep = at[2 * i + 1 - over].slope;
        const double grow = s.by_dep * ind * length;
        const double off = TOL_BAR_FIRST_ORDER * fabs(dep - s.slope * ind) +
                           s.rounding * fabs(ind);
        e.curve = e.curve * exp(grow) + off * length * mean_growth(grow);
        e.saddle *= exp(fmax(grow, 0.0));
    }
    return e;
}
