/*
 * plane_lanes.h -- the field of a plane along JET_LANES series, over x or over
 * y each, order by order: what the series at a saddle (local_lanes.c) and those
 * of a graph (graph_lanes.c) have in common.
 */
#pragma once

#include "local.h"

struct plane_lanes {
    const struct planar *sys;
    const void *ctx[JET_LANES];
    const struct carry *carry;
    jet_pair unit;
    jet_mask over_y; /* the lanes whose independent coordinate is y */
    bool leans;      /* some lean (graph.h) */
    jet_pair lean;
    struct jet_work work;
    jet_pair at[2][JET_SIZE], f[2][JET_SIZE];
    jet_pair rate[LOCAL_CARRY_MAX][JET_SIZE];
};

/* n series, those beyond as the first; ind, unit: of all lanes. */
static inline void plane_lanes_begin(struct plane_lanes *p,
                                     const struct planar *const sys[], size_t n,
                                     const struct carry *carry, const int ind[],
                                     const double unit[])
{
    bool same = true;

    p->leans = false;
    p->sys = sys[0];
    p->carry = carry;
    for (size_t i = 0; i < JET_LANES; i++) {
        p->ctx[i] = sys[i < n ? i : 0]->ctx;
        same &= ind[i] == ind[0];
    }
#define UNIT(i)   unit[i]
#define OVER_Y(i) (double) ind[i]
    p->unit = JET_EACH(UNIT);
    p->over_y = JET_EACH(OVER_Y) > JET_PAIR(0.0);
#undef UNIT
#undef OVER_Y
    p->work.linear = same ? p->at[ind[0]] : NULL;
    p->work.lanes = (int) n;
}

/* Where lanes lean, each by so much; after plane_lanes_begin. */
static inline void plane_lanes_lean(struct plane_lanes *p, const double lean[])
{
#define LEAN(i) lean[i]
    p->lean = JET_EACH(LEAN);
#undef LEAN
    for (size_t i = 0; i < JET_LANES; i++)
        p->leans |= lean[i] != 0.0;
    if (p->leans)
        p->work.linear = NULL;
}

/* u + lean v in lanes that lean. */
static inline jet_pair plane_lanes_leaning(const struct plane_lanes *p,
                                           jet_pair u, jet_pair v)
{
    return p->leans ? jet_choose(p->lean != JET_PAIR(0.0), u + p->lean * v, u)
                    : u;
}

/* Order k of where they are, dep being the dependent coordinate's; k >= 1 where
 * they do not begin at 0. */
static inline void plane_lanes_place(struct plane_lanes *p, size_t k,
                                     jet_pair dep)
{
    const jet_pair over = k == 1 ? p->unit : JET_PAIR(0.0);
    const jet_pair ahead = plane_lanes_leaning(p, over, -dep);

    p->at[0][k] = jet_choose(p->over_y, dep, ahead);
    p->at[1][k] = jet_choose(p->over_y, ahead, dep);
}

static inline void plane_lanes_field(struct plane_lanes *p, size_t k)
{
#if JET_LANES == 2
    p->sys->jet(p->sys->ctx, &p->work, k, p->at[0], p->at[1], p->f[0], p->f[1]);
#else
    p->sys->many->jet(p->ctx, &p->work, k, p->at[0], p->at[1], p->f[0],
                      p->f[1]);
#endif
}

/* Of the carried quantity i, which is not time. */
static inline void plane_lanes_rate(struct plane_lanes *p, size_t i, size_t k)
{
    const size_t which = (size_t) p->carry->which[i];

#if JET_LANES == 2
    p->sys->rate_jet(p->sys->ctx, which, &p->work, k, p->at[0], p->at[1],
                     p->rate[i]);
#else
    p->sys->many->rate_jet(p->ctx, which, &p->work, k, p->at[0], p->at[1],
                           p->rate[i]);
#endif
}

/* The field's component along what the graph is over, and the other. */
static inline jet_pair plane_lanes_dep(const struct plane_lanes *p, size_t k)
{
    return jet_choose(p->over_y, p->f[0][k], p->f[1][k]);
}

static inline jet_pair plane_lanes_ind(const struct plane_lanes *p, size_t k)
{
    const jet_pair ind = jet_choose(p->over_y, p->f[1][k], p->f[0][k]);

    return plane_lanes_leaning(p, ind, plane_lanes_dep(p, k));
}
