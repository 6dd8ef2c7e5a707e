/* One source, once for each width of the processor's registers: LOCAL_BUILD is
 * the name, JET_LANES how many series. */
#include "local_lanes.h"

#include <math.h>

#include "plane_lanes.h"

/* The field along the graphs; those beyond n are as the first. */
struct building {
    struct plane_lanes p;
    struct local_seed seed[JET_LANES];
    jet_pair c[JET_SIZE], ind[JET_SIZE];
};

static void set_seed(struct building *g, const struct planar *const sys[],
                     const struct carry *carry, const struct local_seed seed[],
                     size_t n)
{
    double unit[JET_LANES];
    int ind[JET_LANES];

    for (size_t i = 0; i < JET_LANES; i++) {
        g->seed[i] = seed[i < n ? i : 0];
        ind[i] = g->seed[i].ind;
        unit[i] = g->seed[i].unit;
    }
    plane_lanes_begin(&g->p, sys, n, carry, ind, unit);
#define RISE(i) (g->seed[i].slope * g->seed[i].unit)
    g->c[0] = JET_PAIR(0.0);
    g->c[1] = JET_EACH(RISE);
#undef RISE
}

static void field_order(struct building *g, size_t k)
{
    plane_lanes_place(&g->p, k, g->c[k]);
    plane_lanes_field(&g->p, k);
    g->ind[k] = plane_lanes_ind(&g->p, k);
}

static void carry_order(struct building *g, size_t i, size_t k)
{
    if (g->p.carry->which[i] == CARRY_TIME)
        g->p.rate[i][k] = JET_PAIR(k == 0 ? 1.0 : 0.0);
    else
        plane_lanes_rate(&g->p, i, k);
}

/* What order k leaves on the right when c[k] is still zero. */
static jet_pair defect_of_order(const struct building *g, size_t k)
{
    jet_pair sum = g->c[1] * g->ind[k];

    for (size_t j = 1; j + 1 < k; j++)
        sum += jet_number[j + 1] * g->c[j + 1] * g->ind[k - j];
    return plane_lanes_dep(&g->p, k) - sum / g->p.unit;
}

static void build(struct building *g, size_t order)
{
    jet_pair along = JET_PAIR(0.0), across = along;

#define SCALE(i)  exp(g->seed[i].log_scale - g->p.work.log_scale[i])
#define ALONG(i)  g->seed[i].along
#define ACROSS(i) g->seed[i].across
    for (size_t k = 0; k <= order; k++) {
        if (k >= 2) {
            g->c[k] = JET_PAIR(0.0);
            field_order(g, k);
            g->c[k] = defect_of_order(g, k) / (jet_number[k] * along - across);
        } else if (k == 1) {
            const jet_pair scale = JET_EACH(SCALE);
            along = scale * JET_EACH(ALONG);
            across = scale * JET_EACH(ACROSS);
        }
        field_order(g, k);
        for (size_t i = 0; i < g->p.carry->count; i++)
            carry_order(g, i, k);
    }
#undef SCALE
#undef ALONG
#undef ACROSS
}

/* q' = rate/f_ind with both zero at the saddle: divide the shifted series. */
static void integrate(const struct building *g, size_t i, size_t order,
                      jet_pair integral[])
{
    jet_pair quotient[JET_SIZE];

    integral[0] = JET_PAIR(0.0);
    for (size_t k = 0; k < order; k++) {
        quotient[k] = jet_quotient(k, g->p.rate[i] + 1, g->ind + 1, quotient);
        integral[k + 1] = g->p.unit * quotient[k] / jet_number[k + 1];
    }
}

static void take_integral(const struct building *g, size_t i, size_t order,
                          size_t n, struct local_series *const out[])
{
    jet_pair integral[JET_SIZE];

    integrate(g, i, order, integral);
    for (size_t l = 0; l < n; l++) {
        struct local_series *u = out[l];
        u->converges[i] = g->p.rate[i][0][l] == 0.0;
        for (size_t k = 0; k <= order; k++)
            u->integral[i][k] = u->converges[i] ? integral[k][l] : 0.0;
        if (u->converges[i])
            local_integral_floor(order, g->ind[1][l] / u->unit, u->integral[i]);
    }
}

void LOCAL_BUILD(const struct planar *const sys[], const struct carry *carry,
                 size_t order, size_t n, const struct local_seed seed[],
                 struct local_series *const out[])
{
    struct building g;

    set_seed(&g, sys, carry, seed, n);
    build(&g, order);
    for (size_t l = 0; l < n; l++) {
        out[l]->ind = seed[l].ind;
        out[l]->order = order;
        out[l]->unit = seed[l].unit;
        jet_take(order, g.c, l, out[l]->c);
    }
    for (size_t i = 0; i < carry->count; i++)
        take_integral(&g, i, order, n, out);
}
