/* grower.h -- a branch in the making (grow.c): what its parts share. */
#pragma once

#include "graph.h"
#include "grow.h"

/* Branches that step together. */
enum { GROWERS = 2 * GROW_JOBS };

/* At a point of the curve: slope of dep and of the carried integrals by ind,
 * and how both change with ind at one dep, and with dep, which is how errors of
 * dep travel. */
struct outward {
    double slope, slope_i, slope_d;
    double swift[LOCAL_CARRY_MAX];
    double swift_i[LOCAL_CARRY_MAX], swift_d[LOCAL_CARRY_MAX];
};

/* The true number less the computed one: off, but for no more than bar; and the
 * root of the sum of the squares of its roundings. */
struct grow_miss {
    double off, bar, noise;
};

/* A branch in the making, by steps whose series are in s, ind = at + unit s
 * (graph.h). */
struct grower {
    const struct planar *sys;
    const struct grow_options *o;
    const struct carry *carry; /* what rides along */
    struct branch *b;
    bool done;
    enum status failed;
    double tol; /* of a step, part of what it changes */
    int ind;    /* independent coordinate, to which it leans: it is a graph
                   over that and lean times the other one, dep */
    double lean;
    int toward;    /* sign of its steps */
    struct vec2 z; /* where it is, and its integrals so far */
    double total[LOCAL_CARRY_MAX];
    struct grow_miss miss; /* of dep so far, and of the integrals */
    struct grow_miss total_miss[LOCAL_CARRY_MAX];
    struct branch_miss piece; /* since the last piece stored */
    double worst;             /* bound on the error of dep over the last step */
    double unit; /* of steps, a power of two; 1 but where a field changes over
                    far less (local.h) */
    double h;    /* step chosen, of s, positive */
    double last; /* length of the step before */
    double kink; /* slope that its series misses on the way */
    struct planar_look end; /* at the end of the last step, with the rate of
                               many_carried */
    struct vec2 at_end;     /* where that is, and what its series are there */
    struct graph_end dep_end, integral_end[LOCAL_CARRY_MAX];
    bool holds;         /* the field at its end, and on the way where that
                           says little, is that of its series */
    bool edge;          /* the step ends on that of the domain */
    int limited;        /* 1 + ind where its limit was seen to exist */
    int kin;            /* the first of all whose plane is alike */
    struct outward out; /* and what travels there */
    struct graph_series u;
    size_t order; /* of u */
};

/* How far the independent coordinate may go. */
static inline double grower_room(const struct grower *g)
{
    const struct box domain = g->sys->domain;
    const double edge =
        vec2_part(g->toward > 0 ? domain.hi : domain.lo, g->ind);
    const double here =
        vec2_part(g->z, g->ind) + vec2_part(g->sys->origin, g->ind);

    return (edge - here) * g->toward;
}

/* Of a direction: along what the graph is over, and dep's slope by that. */
static inline double grower_along(const struct grower *g, struct vec2 d)
{
    const double ind = vec2_part(d, g->ind);

    return g->lean == 0.0 ? ind : ind + g->lean * vec2_part(d, 1 - g->ind);
}

static inline double grower_slope(const struct grower *g, struct vec2 d)
{
    return vec2_part(d, 1 - g->ind) / grower_along(g, d);
}

/* The point of its series at s, where dep is told. */
static inline struct vec2 grower_point(const struct grower *g, double s,
                                       double dep)
{
    const double over = g->u.at[g->ind][0] + s * g->unit;
    const double less =
        g->lean == 0.0 ? 0.0 : g->lean * (dep - g->u.at[1 - g->ind][0]);

    return local_point(g->ind, over - less, dep);
}
