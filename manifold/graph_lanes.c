/* One source, once for each width of the processor's registers: GRAPH_EXPAND is
 * the name, JET_LANES how many graphs. */
#include "graph_lanes.h"

#include <math.h>

/* The series of all lanes; those beyond n are as the first. */
struct expansion {
    const struct planar *sys;
    const void *ctx[JET_LANES];
    const struct carry *carry;
    struct graph_start start[JET_LANES];
    jet_pair unit;
    jet_mask over_y; /* the lanes whose independent coordinate is y */
    struct jet_work work;
    jet_pair at[2][JET_SIZE], f[2][JET_SIZE];
    jet_pair ind[JET_SIZE], dep[JET_SIZE]; /* f by the part each plays */
    jet_pair slope[JET_SIZE];
    jet_pair rate[LOCAL_CARRY_MAX][JET_SIZE];
    jet_pair swift[LOCAL_CARRY_MAX][JET_SIZE]; /* d integral/d ind */
    jet_pair integral[LOCAL_CARRY_MAX][JET_SIZE];
};

static void set_start(struct expansion *e, const struct planar *const sys[],
                      const struct graph_start start[], size_t n)
{
    bool same = true;

    e->sys = sys[0];
    for (size_t i = 0; i < JET_LANES; i++) {
        e->ctx[i] = sys[i < n ? i : 0]->ctx;
        e->start[i] = start[i < n ? i : 0];
        same &= e->start[i].ind == start[0].ind;
    }
#define X(i)      e->start[i].z.x
#define Y(i)      e->start[i].z.y
#define UNIT(i)   e->start[i].unit
#define OVER_Y(i) (double) e->start[i].ind
    e->at[0][0] = JET_EACH(X);
    e->at[1][0] = JET_EACH(Y);
    e->unit = JET_EACH(UNIT);
    e->over_y = JET_EACH(OVER_Y) > JET_PAIR(0.0);
#undef X
#undef Y
#undef UNIT
#undef OVER_Y
    e->work.linear = same ? e->at[start[0].ind] : NULL;
    e->work.lanes = (int) n;
    for (size_t i = 0; i < e->carry->count; i++)
        e->integral[i][0] = JET_PAIR(0.0);
}

static void field_order(struct expansion *e, size_t k)
{
#if JET_LANES == 2
    e->sys->jet(e->sys->ctx, &e->work, k, e->at[0], e->at[1], e->f[0], e->f[1]);
#else
    e->sys->many->jet(e->ctx, &e->work, k, e->at[0], e->at[1], e->f[0],
                      e->f[1]);
#endif
}

static void rate_order(struct expansion *e, size_t i, size_t k)
{
    const size_t which = (size_t) e->carry->which[i];

#if JET_LANES == 2
    e->sys->rate_jet(e->sys->ctx, which, &e->work, k, e->at[0], e->at[1],
                     e->rate[i]);
#else
    e->sys->many->rate_jet(e->ctx, which, &e->work, k, e->at[0], e->at[1],
                           e->rate[i]);
#endif
}

/* Coefficient k + 1 of the unknowns from coefficient k of the field. */
static void unknown_order(struct expansion *e, size_t k)
{
    const jet_pair ahead = k == 0 ? e->unit : JET_PAIR(0.0);

    e->ind[k] = jet_choose(e->over_y, e->f[1][k], e->f[0][k]);
    e->dep[k] = jet_choose(e->over_y, e->f[0][k], e->f[1][k]);
    e->slope[k] = jet_quotient(k, e->dep, e->ind, e->slope);
    const jet_pair next = e->slope[k] * (e->unit * jet_inverse[k + 1]);
    e->at[0][k + 1] = jet_choose(e->over_y, next, ahead);
    e->at[1][k + 1] = jet_choose(e->over_y, ahead, next);
}

static void carry_order(struct expansion *e, size_t i, size_t k)
{
#define UNIT_TIME(i) exp(-e->work.log_scale[i])
    if (e->carry->which[i] != CARRY_TIME)
        rate_order(e, i, k);
    else
        e->rate[i][k] = k == 0 ? JET_EACH(UNIT_TIME) : JET_PAIR(0.0);
#undef UNIT_TIME
    e->swift[i][k] = jet_quotient(k, e->rate[i], e->ind, e->swift[i]);
    e->integral[i][k + 1] = e->swift[i][k] * e->unit * jet_inverse[k + 1];
}

static void take(const struct expansion *e, size_t order, size_t i,
                 struct graph_series *out)
{
    jet_take(order, e->at[0], i, out->at[0]);
    jet_take(order, e->at[1], i, out->at[1]);
    for (size_t j = 0; j < e->carry->count; j++) {
        jet_take(order, e->integral[j], i, out->integral[j]);
        local_integral_floor(order, e->ind[0][i] / e->unit[i],
                             out->integral[j]);
    }
    out->slope = e->slope[0][i];
}

void GRAPH_EXPAND(const struct planar *const sys[], const struct carry *carry,
                  size_t order, size_t n, const struct graph_start start[],
                  struct graph_series *const out[])
{
    struct expansion e;

    e.carry = carry;
    set_start(&e, sys, start, n);
    for (size_t k = 0; k < order; k++) {
        field_order(&e, k);
        unknown_order(&e, k);
        for (size_t i = 0; i < carry->count; i++)
            carry_order(&e, i, k);
    }
    for (size_t i = 0; i < n; i++)
        take(&e, order, i, out[i]);
}
