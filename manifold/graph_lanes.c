/* One source, once for each width of the processor's registers: GRAPH_EXPAND is
 * the name, JET_LANES how many graphs. */
#include "graph_lanes.h"

#include <math.h>

#include "plane_lanes.h"

/* The series of all lanes; those beyond n are as the first. */
struct expansion {
    struct plane_lanes p;
    struct graph_start start[JET_LANES];
    jet_pair ind[JET_SIZE], dep[JET_SIZE]; /* f by the part each plays */
    jet_pair slope[JET_SIZE];
    jet_pair swift[LOCAL_CARRY_MAX][JET_SIZE]; /* d integral/d ind */
    jet_pair integral[LOCAL_CARRY_MAX][JET_SIZE];
};

static void set_start(struct expansion *e, const struct planar *const sys[],
                      const struct carry *carry,
                      const struct graph_start start[], size_t n)
{
    double unit[JET_LANES], lean[JET_LANES];
    int ind[JET_LANES];

    for (size_t i = 0; i < JET_LANES; i++) {
        e->start[i] = start[i < n ? i : 0];
        ind[i] = e->start[i].ind;
        unit[i] = e->start[i].unit;
        lean[i] = e->start[i].lean;
    }
    plane_lanes_begin(&e->p, sys, n, carry, ind, unit);
    plane_lanes_lean(&e->p, lean);
#define X(i) e->start[i].z.x
#define Y(i) e->start[i].z.y
    e->p.at[0][0] = JET_EACH(X);
    e->p.at[1][0] = JET_EACH(Y);
#undef X
#undef Y
    for (size_t i = 0; i < carry->count; i++)
        e->integral[i][0] = JET_PAIR(0.0);
}

/* Coefficient k + 1 of the unknowns from coefficient k of the field. */
static void unknown_order(struct expansion *e, size_t k)
{
    e->ind[k] = plane_lanes_ind(&e->p, k);
    e->dep[k] = plane_lanes_dep(&e->p, k);
    e->slope[k] = jet_quotient(k, e->dep, e->ind, e->slope);
    plane_lanes_place(&e->p, k + 1,
                      e->slope[k] * (e->p.unit * jet_inverse[k + 1]));
}

static void carry_order(struct expansion *e, size_t i, size_t k)
{
#define UNIT_TIME(i) exp(-e->p.work.log_scale[i])
    if (e->p.carry->which[i] != CARRY_TIME)
        plane_lanes_rate(&e->p, i, k);
    else
        e->p.rate[i][k] = k == 0 ? JET_EACH(UNIT_TIME) : JET_PAIR(0.0);
#undef UNIT_TIME
    e->swift[i][k] = jet_quotient(k, e->p.rate[i], e->ind, e->swift[i]);
    e->integral[i][k + 1] = e->swift[i][k] * e->p.unit * jet_inverse[k + 1];
}

static void take(const struct expansion *e, size_t order, size_t i,
                 struct graph_series *out)
{
    jet_take(order, e->p.at[0], i, out->at[0]);
    jet_take(order, e->p.at[1], i, out->at[1]);
    for (size_t j = 0; j < e->p.carry->count; j++) {
        jet_take(order, e->integral[j], i, out->integral[j]);
        local_integral_floor(order, e->ind[0][i] / e->p.unit[i],
                             out->integral[j]);
    }
    out->slope = e->slope[0][i];
}

void GRAPH_EXPAND(const struct planar *const sys[], const struct carry *carry,
                  size_t order, size_t n, const struct graph_start start[],
                  struct graph_series *const out[])
{
    struct expansion e;

    set_start(&e, sys, carry, start, n);
    for (size_t k = 0; k < order; k++) {
        plane_lanes_field(&e.p, k);
        unknown_order(&e, k);
        for (size_t i = 0; i < carry->count; i++)
            carry_order(&e, i, k);
    }
    for (size_t i = 0; i < n; i++)
        take(&e, order, i, out[i]);
}
